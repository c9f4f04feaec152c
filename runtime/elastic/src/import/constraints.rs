//! Checks of constraints: each component depends on one constraint at most, is not fixed as well,
//! and does not depend on itself.

use super::origin::{Origin, Problem};
use crate::model::{Component, Constraint, ElasticModel};
use std::collections::{BTreeMap, HashMap};

type Dof = (usize, Component);

fn label(constraint: &Constraint) -> u64 {
    match constraint {
        Constraint::Rigid { label, .. }
        | Constraint::WeightedAverage { label, .. }
        | Constraint::Equation { label, .. } => *label,
    }
}

/// Components that a constraint determines.
fn dependents(constraint: &Constraint) -> Vec<Dof> {
    let all = |node: usize, components: &[bool; 6]| {
        let components = *components;
        (0..6).filter(move |c| components[*c]).map(move |c| (node, c))
    };
    match constraint {
        Constraint::Rigid { dependents, .. } => {
            dependents.iter().flat_map(|(node, components)| all(*node, components)).collect()
        }
        Constraint::WeightedAverage { reference, components, .. } => all(*reference, components).collect(),
        Constraint::Equation { terms, .. } => {
            terms.first().map(|term| (term.0, term.1)).into_iter().collect()
        }
    }
}

/// Components that determine a dependent one.
fn determining(constraint: &Constraint, (_, component): Dof) -> Vec<Dof> {
    match constraint {
        Constraint::Rigid { reference, .. } => {
            let first = if component < 3 { 0 } else { 3 };
            (first..6).map(|c| (*reference, c)).collect()
        }
        Constraint::WeightedAverage { terms, .. } => terms
            .iter()
            .filter(|term| term.0 != 0.0)
            .flat_map(|(_, node, components)| (0..6).filter(|c| components[*c]).map(move |c| (*node, c)))
            .collect(),
        Constraint::Equation { terms, .. } => {
            terms.iter().skip(1).filter(|term| term.2 != 0.0).map(|term| (term.0, term.1)).collect()
        }
    }
}

/// Checks the constraints of a model.
pub(super) fn check(
    model: &ElasticModel,
    origins: &[Origin],
    fixed: &BTreeMap<Dof, (f64, Origin)>,
    noun: &str,
) -> Result<(), Problem> {
    let name = |at: usize| format!("{} {}", origins[at].name, label(&model.constraints[at]));
    let place = |at: usize| origins[at].place;
    let described =
        |(node, component): Dof| format!("component {} of {noun} {}", component + 1, model.nodes[node].label);
    let mut owner: HashMap<Dof, usize> = HashMap::new();
    for (at, constraint) in model.constraints.iter().enumerate() {
        for dof in dependents(constraint) {
            if let Some(other) = owner.insert(dof, at) {
                let message = match other == at {
                    true => format!("{} makes {} dependent twice", name(at), described(dof)),
                    false => format!(
                        "{} makes {} dependent, but it already depends on {} in line {}",
                        name(at),
                        described(dof),
                        name(other),
                        place(other).line
                    ),
                };
                return Err(Problem::new(place(at), message, "let each component depend on one constraint"));
            }
            if let Some((_, support)) = fixed.get(&dof) {
                let message = format!(
                    "{} makes {} dependent, but {} in line {} prescribes it",
                    name(at),
                    described(dof),
                    support.name,
                    support.place.line
                );
                let help = "support the reference node instead of the dependent node";
                return Err(Problem::new(place(at), message, help));
            }
        }
    }
    let starts = model.constraints.iter().flat_map(dependents);
    match find_loop(model, &owner, starts) {
        None => Ok(()),
        Some((dof, at)) => Err(Problem::new(
            place(at),
            format!("{} closes a loop of constraints: {} depends on itself", name(at), described(dof)),
            "remove one constraint of the loop, or exchange its reference node and its dependent node",
        )),
    }
}

/// Searches a loop depth-first. Returns a component of the loop and the constraint that closes it.
fn find_loop(
    model: &ElasticModel,
    owner: &HashMap<Dof, usize>,
    starts: impl Iterator<Item = Dof>,
) -> Option<(Dof, usize)> {
    // Components on the current path are false, finished ones are true.
    let mut finished: HashMap<Dof, bool> = HashMap::new();
    for start in starts {
        if finished.contains_key(&start) {
            continue;
        }
        finished.insert(start, false);
        let next =
            |dof: Dof| owner.get(&dof).map_or_else(Vec::new, |at| determining(&model.constraints[*at], dof));
        let mut path = vec![(start, next(start))];
        while let Some((dof, rest)) = path.last_mut() {
            let dof = *dof;
            let Some(target) = rest.pop() else {
                finished.insert(dof, true);
                path.pop();
                continue;
            };
            match finished.get(&target) {
                Some(true) => {}
                Some(false) => return Some((target, owner[&dof])),
                None if owner.contains_key(&target) => {
                    finished.insert(target, false);
                    path.push((target, next(target)));
                }
                None => {}
            }
        }
    }
    None
}
