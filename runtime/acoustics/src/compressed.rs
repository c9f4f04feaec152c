//! Equations with hierarchical matrices, solved by GMRES.

use crate::cluster::ClusterTree;
use crate::error::AcousticError;
use crate::gmres::{Outcome, gmres};
use crate::hierarchical::{Entries, HierarchicalMatrix};
use crate::operators::{Operators, PairEntries};
use calyx_numerics::complex::ComplexLu;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::vec3::Vector;
use faer::{Mat, MatRef, c64};
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Largest number of vertices of a leaf, and of triangles.
const LEAVES: [usize; 2] = [48, 96];
/// Largest number of iterations.
const ITERATIONS: usize = 300;

/// Compressed equations with the LU factors of the diagonal blocks as preconditioner.
#[derive(Debug)]
pub(crate) struct CompressedEquations {
    matrix: HierarchicalMatrix,
    sources: HierarchicalMatrix,
    diagonal: Vec<(Vec<usize>, ComplexLu)>,
    tolerance: f64,
}

impl CompressedEquations {
    pub fn new(operators: &Operators, accuracy: f64, interrupt: &Interrupt) -> Result<Self, AcousticError> {
        let entries = SurfaceEntries::new(operators);
        let nodes = ClusterTree::new(&entries.supports(), LEAVES[0]);
        let supports: Vec<[Vector; 2]> =
            operators.panels.iter().map(|panel| bounds(panel.corners.iter())).collect();
        let triangles = ClusterTree::new(&supports, LEAVES[1]);
        let matrix =
            HierarchicalMatrix::new(&PressureEntries(&entries), &nodes, &nodes, accuracy, interrupt)?;
        let sources =
            HierarchicalMatrix::new(&SourceEntries(&entries), &nodes, &triangles, accuracy, interrupt)?;
        let diagonal = nodes
            .leaves()
            .into_par_iter()
            .map(|leaf| {
                let items = nodes.items(leaf).to_vec();
                let factors = ComplexLu::new(PressureEntries(&entries).block(&items, &items));
                (items, factors)
            })
            .collect();
        Ok(Self { matrix, sources, diagonal, tolerance: 0.1 * accuracy })
    }

    /// Returns the memory of the matrices, bytes.
    pub fn memory(&self) -> u64 {
        let factors: usize = self.diagonal.iter().map(|(items, _)| 16 * items.len() * items.len()).sum();
        self.matrix.memory() + self.sources.memory() + factors as u64
    }

    /// Returns the pressures of columns of normal derivatives.
    pub fn solve(
        &self,
        derivatives: MatRef<'_, c64>,
        interrupt: &Interrupt,
    ) -> Result<Mat<c64>, AcousticError> {
        let right = self.sources.product(derivatives);
        self.iterate(right.as_ref(), false, interrupt)
    }

    /// Applies the transpose of [`CompressedEquations::solve`] to columns.
    pub fn solve_transpose(
        &self,
        weights: MatRef<'_, c64>,
        interrupt: &Interrupt,
    ) -> Result<Mat<c64>, AcousticError> {
        let solved = self.iterate(weights, true, interrupt)?;
        Ok(self.sources.transpose_product(solved.as_ref()))
    }

    fn iterate(
        &self,
        right: MatRef<'_, c64>,
        transpose: bool,
        interrupt: &Interrupt,
    ) -> Result<Mat<c64>, AcousticError> {
        let matrix = |vector: &[c64]| {
            let column = MatRef::from_column_major_slice(vector, vector.len(), 1);
            let image =
                if transpose { self.matrix.transpose_product(column) } else { self.matrix.product(column) };
            image.col(0).iter().copied().collect()
        };
        let preconditioner = |vector: &[c64]| self.precondition(vector, transpose);
        let mut solutions = Mat::zeros(right.nrows(), right.ncols());
        for j in 0..right.ncols() {
            let column: Vec<c64> = right.col(j).iter().copied().collect();
            match gmres(&matrix, &preconditioner, &column, self.tolerance, ITERATIONS, interrupt)? {
                Outcome::Converged(solution) => {
                    solution.iter().enumerate().for_each(|(i, value)| solutions[(i, j)] = *value);
                }
                Outcome::Stalled(residual) => {
                    return Err(AcousticError::convergence(
                        format!(
                            "GMRES has the relative residual {residual:.1e} after {ITERATIONS} iterations; \
                             the limit is {:.1e}",
                            self.tolerance
                        ),
                        "refine the mesh where its elements are distorted, or use the dense method",
                    ));
                }
            }
        }
        Ok(solutions)
    }

    /// Solves with the diagonal blocks.
    fn precondition(&self, vector: &[c64], transpose: bool) -> Vec<c64> {
        let mut result = vec![c64::new(0.0, 0.0); vector.len()];
        for (items, factors) in &self.diagonal {
            let mut own = Mat::from_fn(items.len(), 1, |i, _| vector[items[i]]);
            if transpose {
                factors.solve_transpose_in_place(own.as_mut());
            } else {
                factors.solve_in_place(own.as_mut());
            }
            items.iter().enumerate().for_each(|(i, item)| result[*item] = own[(i, 0)]);
        }
        result
    }
}

fn bounds<'p>(points: impl Iterator<Item = &'p Vector>) -> [Vector; 2] {
    let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for point in points {
        for axis in 0..3 {
            bounds[0][axis] = bounds[0][axis].min(point[axis]);
            bounds[1][axis] = bounds[1][axis].max(point[axis]);
        }
    }
    bounds
}

/// Entries of the equations by vertex and triangle.
struct SurfaceEntries<'o> {
    operators: &'o Operators,
    /// Triangles at each vertex.
    around: Vec<Vec<usize>>,
}

impl<'o> SurfaceEntries<'o> {
    fn new(operators: &'o Operators) -> Self {
        let mut around = vec![Vec::new(); operators.nodes];
        for (triangle, panel) in operators.panels.iter().enumerate() {
            panel.nodes.iter().for_each(|&node| around[node].push(triangle));
        }
        Self { operators, around }
    }

    /// Returns the bounding boxes of the shape functions of the vertices.
    fn supports(&self) -> Vec<[Vector; 2]> {
        let support = |triangles: &Vec<usize>| {
            bounds(triangles.iter().flat_map(|&t| self.operators.panels[t].corners.iter()))
        };
        self.around.iter().map(support).collect()
    }

    /// Returns the triangles at some vertices, with the position of each corner among the vertices.
    fn triangles(&self, nodes: &[usize]) -> Vec<(usize, [Option<usize>; 3])> {
        let all: BTreeSet<usize> = nodes.iter().flat_map(|&node| self.around[node].iter().copied()).collect();
        let mut sorted: Vec<(usize, usize)> = nodes.iter().copied().zip(0..).collect();
        sorted.sort_unstable();
        let find =
            |node: usize| sorted.binary_search_by_key(&node, |entry| entry.0).ok().map(|at| sorted[at].1);
        all.into_iter().map(|t| (t, self.operators.panels[t].nodes.map(find))).collect()
    }

    /// Calls a function with the contribution of each kind of pair: direct, and with the image.
    fn pairs(&self, first: usize, second: usize, mut add: impl FnMut(&PairEntries)) {
        add(&self.operators.pair(first, second));
        if !self.operators.images.is_empty() {
            add(&self.operators.image_pair(first, second));
        }
    }
}

/// Matrix of the pressures.
struct PressureEntries<'e, 'o>(&'e SurfaceEntries<'o>);

impl Entries for PressureEntries<'_, '_> {
    fn block(&self, rows: &[usize], columns: &[usize]) -> Mat<c64> {
        let mut block = Mat::<c64>::zeros(rows.len(), columns.len());
        let targets = self.0.triangles(columns);
        for (first, from) in self.0.triangles(rows) {
            for &(second, to) in &targets {
                let mut add = |entries: &PairEntries| {
                    for i in 0..3 {
                        for j in 0..3 {
                            if let (Some(row), Some(column)) = (from[i], to[j]) {
                                block[(row, column)] += entries.forward[i][j];
                            }
                        }
                    }
                };
                self.0.pairs(first, second, &mut add);
                if first == second {
                    let [diagonal, other] = self.0.operators.half_mass(first);
                    for i in 0..3 {
                        for j in 0..3 {
                            if let (Some(row), Some(column)) = (from[i], to[j]) {
                                block[(row, column)] += if i == j { diagonal } else { other };
                            }
                        }
                    }
                }
            }
        }
        block
    }
}

/// Matrix of the normal derivatives.
struct SourceEntries<'e, 'o>(&'e SurfaceEntries<'o>);

impl Entries for SourceEntries<'_, '_> {
    fn block(&self, rows: &[usize], columns: &[usize]) -> Mat<c64> {
        let mut block = Mat::<c64>::zeros(rows.len(), columns.len());
        for (first, from) in self.0.triangles(rows) {
            for (column, &second) in columns.iter().enumerate() {
                self.0.pairs(first, second, |entries| {
                    for i in 0..3 {
                        if let Some(row) = from[i] {
                            block[(row, column)] += entries.forward_source[i];
                        }
                    }
                });
                if first == second {
                    for row in from.into_iter().flatten() {
                        block[(row, column)] += self.0.operators.half_mean(first);
                    }
                }
            }
        }
        block
    }
}
