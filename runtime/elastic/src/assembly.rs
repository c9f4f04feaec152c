//! Assembly of a model into sparse matrices over its independent degrees of freedom.
//!
//! Degrees of freedom are numbered by node, six per node, in the displacement axes of the node. The
//! matrices have columns for all of them; those of dependent components and of components that no
//! element concerns are empty. Each entry is summed in the order of the elements, so that results
//! do not depend on the number of threads bit for bit.

use crate::constraint::{Expansion, rigid_row};
use crate::element::{self, ElementMatrix, Quantity};
use crate::error::{ElasticError, ElementError};
use crate::model::{ElasticModel, NodalLoad};
use crate::resources::Resources;
use calyx_fe::sparse::SparseVector;
use calyx_numerics::interrupt::MemoryReservation;
use faer::sparse::{SparseColMat, SymbolicSparseColMat};
use nalgebra::{DMatrix, Matrix6, Vector3};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Number of element matrices that are in memory at a time.
const ELEMENTS_AT_ONCE: usize = 256;
/// Number of ranges of columns that are summed in parallel.
const RANGES: usize = 16;
/// A diagonal entry that is a smaller share of the largest one of its kind is rounding.
const NO_STIFFNESS: f64 = 1e-22;
/// Node outside of the matrix.
const NONE: usize = usize::MAX;

/// Model with its transformation to independent degrees of freedom and its stiffness.
pub struct System<'m> {
    /// Model.
    pub model: &'m ElasticModel,
    /// Transformation from independent degrees of freedom.
    pub expansion: Expansion,
    /// Positions of the nodes, m.
    pub positions: Vec<[f64; 3]>,
    /// Prescribed values by degree of freedom.
    pub prescribed: BTreeMap<usize, f64>,
    /// Stiffness, both triangles, symmetric bit for bit.
    pub stiffness: SparseColMat<usize, f64>,
    /// Degrees of freedom with stiffness that are independent and not prescribed.
    is_unknown: Vec<bool>,
    /// Degrees of freedom with stiffness.
    is_stiff: Vec<bool>,
    pattern: Pattern,
    rooms: Vec<MemoryReservation>,
}

/// Pattern of the matrices.
struct Pattern {
    /// Index of each degree of freedom among those of its node in the pattern.
    local: Vec<usize>,
    /// Number of degrees of freedom of each node in the pattern.
    counts: Vec<usize>,
    starts: Vec<usize>,
    /// Coupled nodes of each node, ascending.
    neighbours: Vec<usize>,
    /// Row of each neighbour's first degree of freedom in a column of the node.
    offsets: Vec<usize>,
    /// Number of rows of a column of each node.
    heights: Vec<usize>,
    /// First entry of each node's columns.
    entries: Vec<usize>,
}

impl<'m> System<'m> {
    /// Collects the constraints of a model and assembles its stiffness.
    ///
    /// # Errors
    /// The model is invalid, memory is insufficient, or the caller ends the computation.
    pub fn new(model: &'m ElasticModel, resources: &Resources) -> Result<Self, ElasticError> {
        let expansion = Expansion::new(model)?;
        let pattern = Pattern::new(model, &expansion, resources)?;
        let unknowns: usize = pattern.counts.iter().sum();
        let bytes = 16 * pattern.entry_count() as u64;
        let room = resources.reserve("the stiffness matrix", bytes, unknowns, 1.0)?;
        let stiffness = assemble(model, &expansion, &pattern, Quantity::Stiffness, resources)?;
        let mut system = Self {
            model,
            expansion,
            positions: model.nodes.iter().map(|node| node.position).collect(),
            prescribed: BTreeMap::new(),
            stiffness,
            is_unknown: Vec::new(),
            is_stiff: Vec::new(),
            pattern,
            rooms: vec![room],
        };
        system.is_stiff = system.stiff_dofs();
        system.is_unknown = system.is_stiff.clone();
        system.prescribe()?;
        Ok(system)
    }

    /// Returns the number of degrees of freedom: six per node.
    pub fn dof_count(&self) -> usize {
        6 * self.model.nodes.len()
    }

    /// Returns true for a degree of freedom that is an unknown of the equations.
    pub fn is_unknown(&self, dof: usize) -> bool {
        self.is_unknown[dof]
    }

    /// Returns true for a prescribed degree of freedom with stiffness: it supports the body.
    pub fn is_support(&self, dof: usize) -> bool {
        self.is_stiff[dof] && self.prescribed.contains_key(&dof)
    }

    /// Returns the unknowns, ascending.
    pub fn unknowns(&self) -> Vec<usize> {
        (0..self.dof_count()).filter(|&dof| self.is_unknown[dof]).collect()
    }

    /// Returns the degrees of freedom that are no unknowns, ascending.
    pub fn constrained(&self) -> Vec<usize> {
        (0..self.dof_count()).filter(|&dof| !self.is_unknown[dof]).collect()
    }

    /// Assembles the mass; it has the pattern of the stiffness.
    ///
    /// # Errors
    /// An element is invalid, memory is insufficient, or the caller ends the computation.
    pub fn mass(&self, resources: &Resources) -> Result<SparseColMat<usize, f64>, ElasticError> {
        // Refuses the matrix before its allocation; the caller owns it afterwards.
        let bytes = 16 * self.pattern.entry_count() as u64;
        let unknowns = self.pattern.counts.iter().sum();
        let _room = resources.reserve("the mass matrix", bytes, unknowns, 1.0)?;
        assemble(self.model, &self.expansion, &self.pattern, Quantity::Mass, resources)
    }

    /// Returns the reserved memory, bytes.
    pub fn reserved(&self) -> u64 {
        self.rooms.iter().map(MemoryReservation::bytes).sum()
    }

    /// Finds the degrees of freedom that have stiffness.
    fn stiff_dofs(&self) -> Vec<bool> {
        let diagonal = self.diagonal(&self.stiffness);
        let largest = |kind: usize| {
            let of_kind = diagonal.iter().enumerate().filter(|(dof, _)| dof % 6 / 3 == kind);
            of_kind.fold(0.0_f64, |largest, (_, value)| largest.max(value.abs()))
        };
        let limits = [largest(0), largest(1)].map(|largest| NO_STIFFNESS * largest);
        let stiff = |(dof, value): (usize, &f64)| value.abs() > limits[dof % 6 / 3];
        diagonal.iter().enumerate().map(stiff).collect()
    }

    fn diagonal(&self, matrix: &SparseColMat<usize, f64>) -> Vec<f64> {
        let entry = |dof: usize| {
            let mut column = matrix.row_idx_of_col(dof).zip(matrix.val_of_col(dof));
            column.find(|entry| entry.0 == dof).map_or(0.0, |entry| *entry.1)
        };
        (0..matrix.ncols()).map(entry).collect()
    }

    fn prescribe(&mut self) -> Result<(), ElementError> {
        for fixed in &self.model.fixed {
            let label = self
                .model
                .nodes
                .get(fixed.node)
                .map(|node| node.label)
                .ok_or_else(|| ElementError::new("a fixed node does not exist", "define all nodes"))?;
            for component in (0..6).filter(|&component| fixed.components[component]) {
                let dof = 6 * fixed.node + component;
                if self.expansion.of(dof).is_some() {
                    return Err(ElementError::new(
                        format!(
                            "component {} of node {label} is fixed and depends on other nodes by a constraint",
                            component + 1
                        ),
                        "fix the nodes on which it depends, or remove it from the constraint",
                    ));
                }
                if let Some(other) = self.prescribed.insert(dof, fixed.value)
                    && other != fixed.value
                {
                    return Err(ElementError::new(
                        format!(
                            "component {} of node {label} has the prescribed values {other} and {}",
                            component + 1,
                            fixed.value
                        ),
                        "prescribe one value",
                    ));
                }
                self.is_unknown[dof] = false;
            }
        }
        Ok(())
    }

    /// Returns a degree of freedom of a node as a combination of independent ones.
    pub fn form(&self, node: usize, component: usize) -> SparseVector {
        self.expansion.form(6 * node + component)
    }

    /// Returns the loads on the independent degrees of freedom.
    ///
    /// # Errors
    /// A load acts on a component without stiffness.
    pub fn loads(&self, loads: &[NodalLoad]) -> Result<Vec<f64>, ElementError> {
        let mut sum = vec![0.0; self.dof_count()];
        for load in loads {
            let node = self.model.nodes.get(load.node).ok_or_else(|| {
                ElementError::new("a load acts on a node that does not exist", "define all nodes")
            })?;
            let [force, moment] = [0, 3]
                .map(|first| Vector3::new(load.load[first], load.load[first + 1], load.load[first + 2]));
            for component in 0..6 {
                let axis = Vector3::from(node.axes[component % 3]);
                let value = axis.dot(if component < 3 { &force } else { &moment });
                if value == 0.0 {
                    continue;
                }
                for &(dof, factor) in &self.form(load.node, component).entries {
                    if !self.is_unknown[dof] && !self.prescribed.contains_key(&dof) && factor != 0.0 {
                        return Err(ElementError::new(
                            format!(
                                "the load on node {} acts on component {} of node {}, which has no stiffness",
                                node.label,
                                dof % 6 + 1,
                                self.model.nodes[dof / 6].label
                            ),
                            "connect the node to elements that carry the load",
                        ));
                    }
                    sum[dof] += factor * value;
                }
            }
        }
        Ok(sum)
    }

    /// Returns the components of all nodes from values of the independent degrees of freedom.
    pub fn expand(&self, independent: &[f64]) -> Vec<f64> {
        let mut all = independent.to_vec();
        for (dof, terms) in self.expansion.dependent() {
            all[dof] = terms.dot(independent);
        }
        all
    }

    /// Returns the displacements by the six rigid-body motions about a point, along the basic axes;
    /// zero for dependent components.
    pub fn rigid_motions(&self, about: [f64; 3]) -> [Vec<f64>; 6] {
        let mut motions = [(); 6].map(|()| vec![0.0; self.dof_count()]);
        for (index, node) in self.model.nodes.iter().enumerate() {
            for component in 0..6 {
                let dof = 6 * index + component;
                if self.expansion.of(dof).is_none() {
                    let row = rigid_row(node, component, about);
                    motions.iter_mut().enumerate().for_each(|(k, motion)| motion[dof] = row[k]);
                }
            }
        }
        motions
    }

    /// Returns the mass matrix of the whole body as a rigid one about a point.
    pub fn rigid_mass(&self, mass: &SparseColMat<usize, f64>, about: [f64; 3]) -> Matrix6<f64> {
        let motions = self.rigid_motions(about);
        let forces = motions.each_ref().map(|motion| multiply(mass, motion));
        Matrix6::from_fn(|i, j| dot(&motions[i], &forces[j]))
    }
}

/// Returns the product of a symmetric sparse matrix (both triangles) with a vector.
pub fn multiply(matrix: &SparseColMat<usize, f64>, vector: &[f64]) -> Vec<f64> {
    let mut product = vec![0.0; vector.len()];
    product.par_iter_mut().enumerate().for_each(|(column, value)| {
        let entries = matrix.row_idx_of_col_raw(column).iter().zip(matrix.val_of_col(column));
        *value = entries.map(|(&row, entry)| entry * vector[row]).sum();
    });
    product
}

/// Returns the scalar product.
pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Converts an element matrix to independent degrees of freedom.
fn reduced(expansion: &Expansion, element: ElementMatrix) -> ElementMatrix {
    if element.dofs.iter().all(|&dof| expansion.of(dof).is_none()) {
        return element;
    }
    let forms: Vec<SparseVector> = element.dofs.iter().map(|&dof| expansion.form(dof)).collect();
    let mut dofs: Vec<usize> =
        forms.iter().flat_map(|form| form.entries.iter().map(|entry| entry.0)).collect();
    dofs.sort_unstable();
    dofs.dedup();
    let mut transformation = DMatrix::<f64>::zeros(element.dofs.len(), dofs.len());
    for (row, form) in forms.iter().enumerate() {
        for &(dof, value) in &form.entries {
            transformation[(row, dofs.partition_point(|&other| other < dof))] += value;
        }
    }
    let mut matrix: DMatrix<f64> = transformation.transpose() * element.matrix * transformation;
    for column in 0..dofs.len() {
        for row in 0..column {
            let mean = 0.5 * (matrix[(row, column)] + matrix[(column, row)]);
            matrix[(row, column)] = mean;
            matrix[(column, row)] = mean;
        }
    }
    ElementMatrix { dofs, matrix }
}

fn assemble(
    model: &ElasticModel,
    expansion: &Expansion,
    pattern: &Pattern,
    quantity: Quantity,
    resources: &Resources,
) -> Result<SparseColMat<usize, f64>, ElasticError> {
    let nodes = model.nodes.len();
    let mut values = vec![0.0; pattern.entry_count()];
    let mut ranges = Vec::with_capacity(RANGES);
    let mut rest = values.as_mut_slice();
    let mut first = 0;
    for range in 1..=RANGES {
        let end = nodes * range / RANGES;
        let (own, others) = rest.split_at_mut(pattern.entries[end] - pattern.entries[first]);
        ranges.push((first..end, own));
        (rest, first) = (others, end);
    }
    for portion in model.elements.chunks(ELEMENTS_AT_ONCE) {
        resources.check()?;
        let matrices = portion
            .par_iter()
            .map(|element| element::matrix(model, element, quantity).map(|matrix| reduced(expansion, matrix)))
            .collect::<Result<Vec<_>, ElementError>>()?;
        ranges.par_iter_mut().for_each(|(range, values)| {
            let offset = pattern.entries[range.start];
            for element in &matrices {
                pattern.add(element, range, offset, values);
            }
        });
    }
    resources.check()?;
    Ok(pattern.matrix(values))
}

impl Pattern {
    fn new(model: &ElasticModel, expansion: &Expansion, resources: &Resources) -> Result<Self, ElasticError> {
        let count = model.nodes.len();
        let mut present = vec![false; 6 * count];
        let mut nodes_of = Vec::with_capacity(model.elements.len());
        for (index, element) in model.elements.iter().enumerate() {
            if index % ELEMENTS_AT_ONCE == 0 {
                resources.check()?;
            }
            let mut nodes = Vec::new();
            for dof in element::dofs(element) {
                if dof >= 6 * count {
                    let message = format!("element {} refers to a node that does not exist", element.label);
                    return Err(ElasticError::model(message, "define all nodes"));
                }
                let mut concern = |dof: usize| {
                    present[dof] = true;
                    nodes.push(dof / 6);
                };
                match expansion.of(dof) {
                    Some(terms) => terms.entries.iter().for_each(|entry| concern(entry.0)),
                    None => concern(dof),
                }
            }
            nodes.sort_unstable();
            nodes.dedup();
            nodes_of.push(nodes);
        }
        let (starts, neighbours) = neighbours(count, &nodes_of);
        let mut local = vec![NONE; 6 * count];
        let mut counts = vec![0; count];
        for dof in (0..6 * count).filter(|&dof| present[dof]) {
            local[dof] = counts[dof / 6];
            counts[dof / 6] += 1;
        }
        let mut offsets = Vec::with_capacity(neighbours.len());
        let (mut heights, mut entries) = (Vec::with_capacity(count), vec![0]);
        for node in 0..count {
            let mut height = 0;
            for &other in &neighbours[starts[node]..starts[node + 1]] {
                offsets.push(height);
                height += counts[other];
            }
            heights.push(height);
            entries.push(entries[node] + height * counts[node]);
        }
        Ok(Self { local, counts, starts, neighbours, offsets, heights, entries })
    }

    fn entry_count(&self) -> usize {
        self.entries.last().copied().unwrap_or(0)
    }

    /// Adds the columns of an element's nodes in a range.
    fn add(
        &self,
        element: &ElementMatrix,
        range: &std::ops::Range<usize>,
        offset: usize,
        values: &mut [f64],
    ) {
        let mut node = NONE;
        let mut rows = Vec::with_capacity(element.dofs.len());
        for (column, &dof) in element.dofs.iter().enumerate() {
            let owner = dof / 6;
            if !range.contains(&owner) {
                continue;
            }
            if owner != node {
                node = owner;
                let around = &self.neighbours[self.starts[node]..self.starts[node + 1]];
                rows.clear();
                rows.extend(element.dofs.iter().map(|&dof| {
                    let place = around.partition_point(|&other| other < dof / 6);
                    self.offsets[self.starts[node] + place] + self.local[dof]
                }));
            }
            let first = self.entries[node] - offset + self.local[dof] * self.heights[node];
            let target = &mut values[first..first + self.heights[node]];
            let source = element.matrix.column(column);
            rows.iter().zip(source.iter()).for_each(|(&row, value)| target[row] += value);
        }
    }

    fn matrix(&self, values: Vec<f64>) -> SparseColMat<usize, f64> {
        let count = self.counts.len();
        let mut starts = Vec::with_capacity(6 * count + 1);
        let mut rows = Vec::with_capacity(values.len());
        starts.push(0);
        for node in 0..count {
            let around = &self.neighbours[self.starts[node]..self.starts[node + 1]];
            for component in 0..6 {
                if self.local[6 * node + component] != NONE {
                    let dofs = around.iter().flat_map(|&other| 6 * other..6 * other + 6);
                    rows.extend(dofs.filter(|&dof| self.local[dof] != NONE));
                }
                starts.push(rows.len());
            }
        }
        let symbolic = SymbolicSparseColMat::new_checked(6 * count, 6 * count, starts, None, rows);
        SparseColMat::new(symbolic, values)
    }
}

/// Returns for each node the nodes that share an element with it, itself included, ascending: start
/// indices, and all lists concatenated.
fn neighbours(count: usize, nodes_of: &[Vec<usize>]) -> (Vec<usize>, Vec<usize>) {
    let mut elements_of = vec![Vec::new(); count];
    for (index, nodes) in nodes_of.iter().enumerate() {
        for &node in nodes {
            elements_of[node].push(index);
        }
    }
    let mut starts = Vec::with_capacity(count + 1);
    let mut all = Vec::new();
    let mut seen_by = vec![NONE; count];
    starts.push(0);
    for (node, elements) in elements_of.iter().enumerate() {
        let first = all.len();
        for &other in elements.iter().flat_map(|&element| &nodes_of[element]) {
            if seen_by[other] != node {
                seen_by[other] = node;
                all.push(other);
            }
        }
        all[first..].sort_unstable();
        starts.push(all.len());
    }
    (starts, all)
}
