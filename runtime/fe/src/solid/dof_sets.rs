//! Named sets of degrees of freedom (report 3.1.5): nodes of several meshes, rigid regions, and
//! series on surfaces of revolution, and the equations of the meshes in these unknowns.
//!
//! Nodes attached to a set follow its unknowns (multipoint constraints). A set joins the nodes of
//! different meshes that are attached to it, whether the meshes conform or not. Virtual work is
//! conserved: the transpose of the expansion of displacements reduces the loads.

use super::fourier::{Series, Term, rigid_motions};
use super::model::SolidModel;
use crate::solve::Constraints;
use crate::sparse::SparseVector;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use std::collections::BTreeMap;
use std::ops::Range;

/// Meaning of an unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum DofKind {
    /// Displacement of a node of a part along an axis.
    Displacement {
        /// Index of the part, in the order of definition.
        part: usize,
        /// Index of the node in that part's mesh.
        node: usize,
        /// Axis, 0 to 2.
        axis: usize,
    },
    /// Translation of a region or a surface as a whole, along one of its axes.
    Translation(usize),
    /// Rotation of a region or a surface as a whole, about one of its axes.
    Rotation(usize),
    /// Term of a series, without its rigid part.
    Series(Term),
}

/// Reasons why a set cannot be defined.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[allow(missing_docs, reason = "each says itself in its message")]
pub enum DofError {
    #[error("there is no set `{name}`")]
    NoSet { name: String },
    #[error("there is a set `{name}` already")]
    Taken { name: String },
    #[error("part {part} has no node {node}")]
    NoNode { part: usize, node: usize },
    #[error("node {node} of part {part} is in the set `{first}` already and cannot follow `{second}` too")]
    Twice { part: usize, node: usize, first: String, second: String },
}

/// Motion of the nodes attached to a set.
#[derive(Clone, Debug)]
enum Motion {
    /// Each node independently.
    Nodes,
    /// Rigid-body motion about a centre.
    Rigid([f64; 3]),
    /// Displacements of a series.
    Series(Box<Series>),
}

struct Set {
    name: String,
    motion: Motion,
    /// Part and node.
    nodes: Vec<(usize, usize)>,
    constrained: Vec<(DofKind, f64)>,
}

/// Builder of sets; [`DofSets::reduce`] numbers the unknowns. Nodes in no set are independent.
pub struct DofSets<'a> {
    parts: Vec<&'a SolidModel>,
    sets: Vec<Set>,
    /// Set of each node of each part.
    set_of: Vec<Vec<Option<usize>>>,
}

impl<'a> DofSets<'a> {
    /// Creates a builder for parts in common coordinates.
    pub fn new(parts: Vec<&'a SolidModel>) -> Self {
        let set_of = parts.iter().map(|part| vec![None; part.mesh.nodes.len()]).collect();
        Self { parts, sets: Vec::new(), set_of }
    }

    /// Adds a set of independent nodes, to be constrained or condensed onto by name.
    ///
    /// # Errors
    /// The name or a node is already used, or a node does not exist.
    pub fn nodes(&mut self, name: &str, part: usize, nodes: &[usize]) -> Result<&mut Self, DofError> {
        self.add(name, Motion::Nodes)?.attach(name, part, nodes)
    }

    /// Adds a region that moves as a rigid body; rotations are about the centre, all axes along x,
    /// y and z.
    ///
    /// # Errors
    /// The name is already used.
    pub fn rigid(&mut self, name: &str, center: [f64; 3]) -> Result<&mut Self, DofError> {
        self.add(name, Motion::Rigid(center))
    }

    /// Adds a surface that moves according to a series, with rotations and translations along its
    /// axes.
    ///
    /// # Errors
    /// The name is already used.
    pub fn series(&mut self, name: &str, series: Series) -> Result<&mut Self, DofError> {
        self.add(name, Motion::Series(Box::new(series)))
    }

    fn add(&mut self, name: &str, motion: Motion) -> Result<&mut Self, DofError> {
        if self.sets.iter().any(|set| set.name == name) {
            return Err(DofError::Taken { name: name.to_owned() });
        }
        self.sets.push(Set { name: name.to_owned(), motion, nodes: Vec::new(), constrained: Vec::new() });
        Ok(self)
    }

    fn index(&self, name: &str) -> Result<usize, DofError> {
        let index = self.sets.iter().position(|set| set.name == name);
        index.ok_or_else(|| DofError::NoSet { name: name.to_owned() })
    }

    /// Attaches nodes of a part to a set.
    ///
    /// # Errors
    /// The set or a node does not exist, or a node already belongs to a set.
    pub fn attach(&mut self, name: &str, part: usize, nodes: &[usize]) -> Result<&mut Self, DofError> {
        let index = self.index(name)?;
        for &node in nodes {
            let place = self.set_of.get_mut(part).and_then(|nodes| nodes.get_mut(node));
            let place = place.ok_or(DofError::NoNode { part, node })?;
            match *place {
                Some(same) if same == index => {}
                Some(other) => {
                    let [first, second] = [other, index].map(|set| self.sets[set].name.clone());
                    return Err(DofError::Twice { part, node, first, second });
                }
                None => {
                    *place = Some(index);
                    self.sets[index].nodes.push((part, node));
                }
            }
        }
        Ok(self)
    }

    /// Prescribes the unknowns of a set for which `value` returns a value.
    ///
    /// # Errors
    /// The set does not exist.
    pub fn constrain(
        &mut self,
        name: &str,
        value: impl Fn(&DofKind) -> Option<f64>,
    ) -> Result<&mut Self, DofError> {
        let index = self.index(name)?;
        let set = &self.sets[index];
        let constrained = set.dofs().into_iter().filter_map(|kind| value(&kind).map(|value| (kind, value)));
        let constrained = constrained.collect::<Vec<_>>();
        self.sets[index].constrained.extend(constrained);
        Ok(self)
    }

    /// Fixes the rigid-body motion of a region or a surface, which can still deform.
    ///
    /// # Errors
    /// The set does not exist.
    pub fn constrain_rigid_motion(&mut self, name: &str) -> Result<&mut Self, DofError> {
        self.constrain(name, |kind| {
            matches!(kind, DofKind::Translation(_) | DofKind::Rotation(_)).then_some(0.0)
        })
    }

    /// Numbers the unknowns: nodes in no set first, part by part, then the sets in the order of
    /// definition.
    pub fn reduce(&self) -> Reduced<'a> {
        let mut count = 0;
        let mut next = |size: usize| {
            count += size;
            count - size
        };
        let mut nodes = self
            .set_of
            .iter()
            .map(|sets| sets.iter().map(|_| NodeMotion::Itself(0)).collect::<Vec<_>>())
            .collect::<Vec<_>>();
        for (part, sets) in self.set_of.iter().enumerate() {
            for (node, set) in sets.iter().enumerate() {
                if set.is_none() {
                    nodes[part][node] = NodeMotion::Itself(next(3));
                }
            }
        }
        let mut names = BTreeMap::new();
        let mut constraints = Constraints::new();
        for (index, set) in self.sets.iter().enumerate() {
            let dofs = set.dofs();
            let first = next(dofs.len());
            for (place, &(part, node)) in set.nodes.iter().enumerate() {
                let at = self.parts[part].mesh.nodes[node];
                let by = match &set.motion {
                    Motion::Nodes => {
                        nodes[part][node] = NodeMotion::Itself(first + 3 * place);
                        continue;
                    }
                    Motion::Rigid(center) => {
                        rigid_motions([0, 1, 2].map(|axis| at[axis] - center[axis])).to_vec()
                    }
                    Motion::Series(series) => series.displacements(at),
                };
                nodes[part][node] = NodeMotion::Follows { set: index, by };
            }
            for (kind, value) in &set.constrained {
                if let Some(place) = dofs.iter().position(|other| other == kind) {
                    constraints.prescribe(first + place, *value);
                }
            }
            names.insert(set.name.clone(), ReducedSet { first, dofs, index });
        }
        let mut firsts = vec![0; self.sets.len()];
        for set in names.values() {
            firsts[set.index] = set.first;
        }
        let followers = self.sets.iter().map(|set| match set.motion {
            Motion::Nodes => Vec::new(),
            Motion::Rigid(_) | Motion::Series(_) => set.nodes.clone(),
        });
        Reduced {
            parts: self.parts.clone(),
            count,
            firsts,
            followers: followers.collect(),
            nodes,
            sets: names,
            constraints,
        }
    }
}

impl Set {
    fn dofs(&self) -> Vec<DofKind> {
        let whole = (0..3).map(DofKind::Translation).chain((0..3).map(DofKind::Rotation));
        match &self.motion {
            Motion::Nodes => self
                .nodes
                .iter()
                .flat_map(|&(part, node)| (0..3).map(move |axis| DofKind::Displacement { part, node, axis }))
                .collect(),
            Motion::Rigid(_) => whole.collect(),
            Motion::Series(series) => {
                whole.chain(series.terms().iter().copied().map(DofKind::Series)).collect()
            }
        }
    }
}

/// Motion of a node by the unknowns.
enum NodeMotion {
    /// Displacements along x, y and z are three unknowns from this index on.
    Itself(usize),
    /// Displacement by a unit of each unknown of a set.
    Follows { set: usize, by: Vec<[f64; 3]> },
}

/// Unknowns of a set.
#[derive(Clone, Debug, PartialEq)]
pub struct ReducedSet {
    first: usize,
    /// Meanings, in the order of the unknowns.
    pub dofs: Vec<DofKind>,
    index: usize,
}

impl ReducedSet {
    /// Returns the range of the set's unknowns.
    pub fn unknowns(&self) -> Range<usize> {
        self.first..self.first + self.dofs.len()
    }
}

/// Parts in the unknowns of their sets.
pub struct Reduced<'a> {
    parts: Vec<&'a SolidModel>,
    count: usize,
    /// First unknown of each set.
    firsts: Vec<usize>,
    /// Nodes attached to each set.
    followers: Vec<Vec<(usize, usize)>>,
    nodes: Vec<Vec<NodeMotion>>,
    sets: BTreeMap<String, ReducedSet>,
    constraints: Constraints,
}

impl Reduced<'_> {
    /// Returns the number of unknowns.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Returns the set of that name, if any.
    pub fn set(&self, name: &str) -> Option<&ReducedSet> {
        self.sets.get(name)
    }

    /// Returns the constraints, by unknown.
    pub fn constraints(&self) -> &Constraints {
        &self.constraints
    }

    /// Assembles the stiffness of all parts in the unknowns; symmetric bit for bit, both triangles
    /// stored.
    pub fn stiffness(&self) -> SparseColMat<usize, f64> {
        self.reduced(&self.parts.iter().map(|part| part.stiffness()).collect::<Vec<_>>())
    }

    /// Assembles the mass of all parts in the unknowns, stored like the stiffness.
    pub fn mass(&self) -> SparseColMat<usize, f64> {
        self.reduced(&self.parts.iter().map(|part| part.mass()).collect::<Vec<_>>())
    }

    /// Converts a load on a part, or a row of its displacements, to the unknowns.
    pub fn load(&self, part: usize, load: &SparseVector) -> SparseVector {
        let mut entries = Vec::new();
        for &(dof, value) in &load.entries {
            match &self.nodes[part][dof / 3] {
                NodeMotion::Itself(first) => entries.push((first + dof % 3, value)),
                NodeMotion::Follows { set, by } => {
                    let first = self.firsts[*set];
                    entries.extend(
                        by.iter().enumerate().map(|(index, by)| (first + index, by[dof % 3] * value)),
                    );
                }
            }
        }
        entries.into_iter().collect()
    }

    /// Returns the displacements of a part from values of the unknowns.
    pub fn displacements(&self, part: usize, unknowns: &[f64]) -> Vec<f64> {
        let of_node = |motion: &NodeMotion| match motion {
            NodeMotion::Itself(first) => [0, 1, 2].map(|axis| unknowns[first + axis]),
            NodeMotion::Follows { set, by } => {
                let values = &unknowns[self.firsts[*set]..];
                [0, 1, 2].map(|axis| by.iter().zip(values).map(|(by, value)| by[axis] * value).sum())
            }
        };
        self.nodes[part].iter().flat_map(of_node).collect()
    }

    /// Returns `T' A T` with the matrices of the parts on the diagonal of `A`, and `T` the
    /// expansion of the unknowns to displacements.
    fn reduced(&self, matrices: &[SparseColMat<usize, f64>]) -> SparseColMat<usize, f64> {
        let mut columns = vec![Vec::new(); self.count];
        for (nodes, matrix) in self.nodes.iter().zip(matrices) {
            for (node, motion) in nodes.iter().enumerate() {
                let NodeMotion::Itself(first) = motion else { continue };
                for axis in 0..3 {
                    for (row, value) in column(matrix, 3 * node + axis) {
                        if let NodeMotion::Itself(other) = nodes[row / 3] {
                            columns[first + axis].push((other + row % 3, value));
                        }
                    }
                }
            }
        }
        let mut of_sets = vec![false; self.count];
        for (set, unknown) in self.followed() {
            of_sets[self.firsts[set] + unknown] = true;
        }
        for (set, unknown) in self.followed() {
            let own = self.firsts[set] + unknown;
            for (row, value) in self.column_of(set, unknown, matrices).into_iter().enumerate() {
                // Both entries use one value, so that the matrix is symmetric to the bit.
                if value != 0.0 && (row >= own || !of_sets[row]) {
                    columns[own].push((row, value));
                    if row != own {
                        columns[row].push((own, value));
                    }
                }
            }
        }
        let mut starts = vec![0];
        let (mut rows, mut values) = (Vec::new(), Vec::new());
        for column in &mut columns {
            column.sort_unstable_by_key(|entry| entry.0);
            rows.extend(column.iter().map(|entry| entry.0));
            values.extend(column.iter().map(|entry| entry.1));
            starts.push(rows.len());
        }
        SparseColMat::new(
            SymbolicSparseColMat::new_checked(self.count, self.count, starts, None, rows),
            values,
        )
    }

    /// Returns the unknowns with attached nodes: set, and index within the set.
    fn followed(&self) -> impl Iterator<Item = (usize, usize)> {
        let size = |followers: &[(usize, usize)]| match followers
            .first()
            .map(|&(part, node)| &self.nodes[part][node])
        {
            Some(NodeMotion::Follows { by, .. }) => by.len(),
            _ => 0,
        };
        self.followers
            .iter()
            .enumerate()
            .flat_map(move |(set, followers)| (0..size(followers)).map(move |unknown| (set, unknown)))
    }

    /// Returns the forces on all unknowns by a unit of one with attached nodes.
    fn column_of(&self, set: usize, unknown: usize, matrices: &[SparseColMat<usize, f64>]) -> Vec<f64> {
        let mut on_parts = matrices.iter().map(|matrix| vec![0.0; matrix.nrows()]).collect::<Vec<_>>();
        for &(part, node) in &self.followers[set] {
            let NodeMotion::Follows { by, .. } = &self.nodes[part][node] else { continue };
            for axis in 0..3 {
                let moved = by[unknown][axis];
                if moved != 0.0 {
                    for (row, value) in column(&matrices[part], 3 * node + axis) {
                        on_parts[part][row] += value * moved;
                    }
                }
            }
        }
        let mut sum = vec![0.0; self.count];
        for (nodes, forces) in self.nodes.iter().zip(&on_parts) {
            for (motion, force) in nodes.iter().zip(forces.chunks_exact(3)) {
                match motion {
                    NodeMotion::Itself(first) => {
                        for axis in 0..3 {
                            sum[first + axis] += force[axis];
                        }
                    }
                    NodeMotion::Follows { set, by } => {
                        for (sum, by) in sum[self.firsts[*set]..].iter_mut().zip(by) {
                            *sum += by[0] * force[0] + by[1] * force[1] + by[2] * force[2];
                        }
                    }
                }
            }
        }
        sum
    }
}

fn column(matrix: &SparseColMat<usize, f64>, column: usize) -> impl Iterator<Item = (usize, f64)> {
    matrix.row_idx_of_col(column).zip(matrix.val_of_col(column).iter().copied())
}
