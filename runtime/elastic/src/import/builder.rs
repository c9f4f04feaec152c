//! Collection of the parts of a model with their locations, and the checks that all formats share.

use super::error::ImportError;
use super::origin::{Origin, Problem};
use super::source::{Place, Skipped, error, most_references};
use super::units::{Units, to_si};
use super::{Import, ImportReport, constraints, geometry, mass};
use crate::model::{
    Component, Components, Constraint, ElasticModel, Element, ElementKind, FixedComponents, NodalLoad, Node,
};
use std::cell::Cell;
use std::collections::{BTreeMap, HashMap};

/// Model under construction, in the units of its source.
pub(super) struct Builder {
    pub model: ElasticModel,
    pub notes: Vec<String>,
    pub skipped: Skipped,
    pub title: String,
    /// Noun for a node in messages.
    node_noun: &'static str,
    index: HashMap<u64, usize>,
    elements: Vec<Origin>,
    labels: HashMap<u64, usize>,
    constraints: Vec<Origin>,
    fixed: BTreeMap<(usize, Component), (f64, Origin)>,
    loads: BTreeMap<usize, [f64; 6]>,
    /// Number of nodes that ranges have given so far.
    expanded: Cell<usize>,
}

impl Builder {
    /// Starts a model with its nodes.
    pub fn new(nodes: impl IntoIterator<Item = Node>, node_noun: &'static str) -> Self {
        let mut nodes: Vec<Node> = nodes.into_iter().collect();
        nodes.sort_by_key(|node| node.label);
        let index = nodes.iter().enumerate().map(|(at, node)| (node.label, at)).collect();
        Self {
            model: ElasticModel { nodes, ..ElasticModel::default() },
            notes: Vec::new(),
            skipped: Skipped::default(),
            title: String::new(),
            node_noun,
            index,
            elements: Vec::new(),
            labels: HashMap::new(),
            constraints: Vec::new(),
            fixed: BTreeMap::new(),
            loads: BTreeMap::new(),
            expanded: Cell::new(0),
        }
    }

    /// Returns the index of the node with a label.
    pub fn find(&self, label: u64) -> Option<usize> {
        self.index.get(&label).copied()
    }

    /// Returns the index of the node with a label. `owner` is the subject of the error message.
    pub fn node(&self, label: u64, owner: &str, place: Place) -> Result<usize, Problem> {
        self.find(label).ok_or_else(|| {
            let noun = self.node_noun;
            Problem::new(
                place,
                format!("{owner} refers to {noun} {label}, which is not defined"),
                format!("define {noun} {label}, or correct the reference"),
            )
        })
    }

    /// Returns the indices of nodes with these labels.
    pub fn nodes(&self, labels: &[u64], owner: &str, place: Place) -> Result<Vec<usize>, Problem> {
        labels.iter().map(|label| self.node(*label, owner, place)).collect()
    }

    /// Indices of the nodes with labels from `from` to `to`. Ranges may be stated often, so their
    /// total is limited.
    pub fn range(&self, from: u64, to: u64, place: Place) -> Result<std::ops::Range<usize>, Problem> {
        let nodes = &self.model.nodes;
        let start = nodes.partition_point(|node| node.label < from);
        let end = nodes.partition_point(|node| node.label <= to).max(start);
        let expanded = self.expanded.get().saturating_add(end - start);
        self.expanded.set(expanded);
        match expanded <= most_references(nodes.len()) {
            true => Ok(start..end),
            false => Err(Problem::new(
                place,
                format!("the range {from} to {to} and others are stated too often"),
                "state each range once",
            )),
        }
    }

    /// Adds an element. Labels of elements are unique, except those of masses and springs.
    pub fn element(&mut self, origin: Origin, element: Element) -> Result<(), Problem> {
        if !matches!(element.kind, ElementKind::Mass { .. }) {
            if let Some(known) = self.labels.get(&element.label) {
                let known = self.elements[*known];
                return Err(Problem::new(
                    origin.place,
                    format!(
                        "element {} {} has the label of {} in line {}",
                        origin.name, element.label, known.name, known.place.line
                    ),
                    "give each element its own label",
                ));
            }
            self.labels.insert(element.label, self.elements.len());
        }
        self.elements.push(origin);
        self.model.elements.push(element);
        Ok(())
    }

    pub fn constraint(&mut self, origin: Origin, constraint: Constraint) {
        self.constraints.push(origin);
        self.model.constraints.push(constraint);
    }

    /// Fixes components of a node at a value.
    pub fn fix(
        &mut self,
        origin: Origin,
        node: usize,
        components: &Components,
        value: f64,
    ) -> Result<(), Problem> {
        for component in (0..6).filter(|c| components[*c]) {
            if let Some((known, other)) = self.fixed.get(&(node, component))
                && *known != value
            {
                let message = format!(
                    "{} sets component {} of {} {} to {value}, but {} in line {} sets it to {known}",
                    origin.name,
                    component + 1,
                    self.node_noun,
                    self.model.nodes[node].label,
                    other.name,
                    other.place.line
                );
                return Err(Problem::new(origin.place, message, "prescribe one value"));
            }
            self.fixed.insert((node, component), (value, origin));
        }
        Ok(())
    }

    /// Adds a load on a node, along and about the basic axes.
    pub fn load(&mut self, node: usize, load: [f64; 6]) {
        let sum = self.loads.entry(node).or_default();
        (0..6).for_each(|i| sum[i] += load[i]);
    }

    /// Checks the model, converts it to SI and returns it with its report.
    pub fn finish(
        mut self,
        files: &[String],
        units: &Units,
        mass_factor: f64,
    ) -> Result<Import, ImportError> {
        self.check().map_err(|problem| problem.located(files))?;
        let mut model = self.model;
        model.fixed = fixed_components(&self.fixed);
        model.loads = self.loads.into_iter().map(|(node, load)| NodalLoad { node, load }).collect();
        to_si(&mut model, units, mass_factor);
        let mass = mass::mass_properties(&model);
        let finite = mass.mass.is_finite()
            && model.nodes.iter().all(|node| node.position.iter().all(|x| x.is_finite()));
        if !finite {
            let place = self.elements.first().map_or(Place { file: 0, line: 1 }, |origin| origin.place);
            let message = "the dimensions or masses of the model overflow";
            return Err(error(files, place, message, "check the units and the densities of the model"));
        }
        let report = ImportReport {
            title: self.title,
            files: files.to_vec(),
            skipped: self.skipped.finish(files),
            notes: self.notes,
            mass,
        };
        Ok(Import { model, report })
    }

    fn check(&mut self) -> Result<(), Problem> {
        if self.model.nodes.is_empty() || self.model.elements.is_empty() {
            let missing = if self.model.nodes.is_empty() { "nodes" } else { "elements" };
            return Err(Problem::new(
                Place { file: 0, line: 1 },
                format!("the model has no {missing}"),
                "check that this is the complete model, with all files that it includes",
            ));
        }
        for (element, origin) in self.model.elements.iter().zip(&self.elements) {
            if let Some(defect) = geometry::defect(element, &self.model.nodes) {
                return Err(Problem::new(
                    origin.place,
                    format!("element {} {} {defect}", origin.name, element.label),
                    "correct the order or the positions of its nodes",
                ));
            }
        }
        constraints::check(&self.model, &self.constraints, &self.fixed, self.node_noun)
    }
}

/// Joins the fixed components of each node. Components with a value stay apart, because the units
/// of translations and rotations differ.
fn fixed_components(fixed: &BTreeMap<(usize, Component), (f64, Origin)>) -> Vec<FixedComponents> {
    let mut joined: Vec<FixedComponents> = Vec::new();
    for (&(node, component), &(value, _)) in fixed {
        let zero = joined.iter().rposition(|entry| entry.node != node || entry.value == 0.0);
        if value == 0.0
            && let Some(at) = zero.filter(|at| joined[*at].node == node)
        {
            joined[at].components[component] = true;
        } else {
            let mut components = [false; 6];
            components[component] = true;
            joined.push(FixedComponents { node, components, value });
        }
    }
    joined
}
