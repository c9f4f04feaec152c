//! Connected parts of a model: nodes that elements and constraints join.

use crate::model::{Constraint, ElasticModel};

/// Returns the nodes of each connected part, in the order of their first nodes. A node that nothing
/// refers to is a part of its own.
pub fn connected_parts(model: &ElasticModel) -> Vec<Vec<usize>> {
    let count = model.nodes.len();
    let mut leader: Vec<usize> = (0..count).collect();
    fn find(leader: &mut [usize], node: usize) -> usize {
        let mut top = node;
        while leader[top] != top {
            leader[top] = leader[leader[top]];
            top = leader[top];
        }
        top
    }
    let mut join = |nodes: &mut dyn Iterator<Item = usize>| {
        let mut first = None;
        for node in nodes.filter(|&node| node < count) {
            let top = find(&mut leader, node);
            match first {
                None => first = Some(top),
                Some(other) => {
                    let (low, high) = (top.min(other), top.max(other));
                    leader[high] = low;
                    first = Some(low);
                }
            }
        }
    };
    for element in &model.elements {
        join(&mut element.nodes.iter().copied());
    }
    for constraint in &model.constraints {
        join(&mut nodes_of(constraint));
    }
    let mut members: Vec<Vec<usize>> = vec![Vec::new(); count];
    for node in 0..count {
        let top = find(&mut leader, node);
        members[top].push(node);
    }
    members.retain(|nodes| !nodes.is_empty());
    members
}

/// Returns the connected parts of a model that have elements.
pub fn parts_with_elements(model: &ElasticModel) -> Vec<Vec<usize>> {
    let mut with_element = vec![false; model.nodes.len()];
    for element in &model.elements {
        element.nodes.iter().for_each(|&node| with_element[node] = true);
    }
    let mut parts = connected_parts(model);
    parts.retain(|nodes| nodes.iter().any(|&node| with_element[node]));
    parts
}

/// Returns the nodes that a constraint connects.
pub fn nodes_of(constraint: &Constraint) -> Box<dyn Iterator<Item = usize> + '_> {
    match constraint {
        Constraint::Rigid { reference, dependents, .. } => {
            Box::new(dependents.iter().map(|entry| entry.0).chain([*reference]))
        }
        Constraint::WeightedAverage { reference, terms, .. } => {
            Box::new(terms.iter().map(|entry| entry.1).chain([*reference]))
        }
        Constraint::Equation { terms, .. } => Box::new(terms.iter().map(|entry| entry.0)),
    }
}
