//! Dense matrices of the equations, with LU factors.

use crate::cluster::ClusterTree;
use crate::error::AcousticError;
use crate::operators::{Operators, PairEntries};
use calyx_numerics::complex::ComplexLu;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use calyx_numerics::vec3::Vector;
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, c64};
use rayon::prelude::*;
use std::collections::HashMap;

/// Number of triangles of a block.
const BLOCK: usize = 64;

/// Factorized equations.
#[derive(Debug)]
pub(crate) struct DenseEquations {
    factors: ComplexLu,
    /// Matrix of the normal derivatives.
    sources: Mat<c64>,
    _memory: MemoryReservation,
}

/// Returns the memory of the dense equations with their blocks, bytes.
pub(crate) fn memory(nodes: usize, triangles: usize) -> u64 {
    let blocks = triangles.div_ceil(BLOCK) * 4 * BLOCK * BLOCK;
    16 * (nodes * nodes + nodes * triangles + blocks) as u64
}

/// Triangles of a block and their vertices.
struct Block {
    triangles: Vec<usize>,
    nodes: Vec<usize>,
    /// Index in `nodes` of the corners of each triangle.
    corners: Vec<[usize; 3]>,
}

/// Matrices of a pair of blocks: rows of the first and columns of the second, and the reverse.
struct BlockPair {
    matrices: [Mat<c64>; 2],
    sources: [Mat<c64>; 2],
}

impl DenseEquations {
    /// Assembles and factorizes the equations. The sums have the same order with any number of
    /// threads.
    pub fn new(operators: &Operators, interrupt: &Interrupt) -> Result<Self, AcousticError> {
        let (nodes, triangles) = (operators.nodes, operators.panels.len());
        let reservation = interrupt.reserve_memory(memory(nodes, triangles))?;
        let (matrix, sources) = assemble(operators, interrupt)?;
        interrupt.check()?;
        Ok(Self { factors: ComplexLu::new(matrix), sources, _memory: reservation })
    }

    /// Returns the pressures of columns of normal derivatives.
    pub fn solve(&self, derivatives: MatRef<'_, c64>) -> Mat<c64> {
        let mut pressure = product(self.sources.as_ref(), derivatives);
        self.factors.solve_in_place(pressure.as_mut());
        pressure
    }

    /// Applies the transpose of [`DenseEquations::solve`] to columns.
    pub fn solve_transpose(&self, mut weights: Mat<c64>) -> Mat<c64> {
        self.factors.solve_transpose_in_place(weights.as_mut());
        product(self.sources.transpose(), weights.as_ref())
    }
}

fn product(a: MatRef<'_, c64>, b: MatRef<'_, c64>) -> Mat<c64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    matmul(result.as_mut(), Accum::Replace, a, b, c64::new(1.0, 0.0), Par::Seq);
    result
}

/// Returns the matrices of the pressures and of the normal derivatives.
fn assemble(operators: &Operators, interrupt: &Interrupt) -> Result<(Mat<c64>, Mat<c64>), AcousticError> {
    let blocks = blocks(operators);
    let mut matrix = Mat::<c64>::zeros(operators.nodes, operators.nodes);
    let mut sources = Mat::<c64>::zeros(operators.nodes, operators.panels.len());
    for (at, first) in blocks.iter().enumerate() {
        interrupt.check()?;
        let pairs: Vec<BlockPair> =
            blocks[at..].par_iter().map(|second| block_pair(operators, first, second)).collect();
        for (second, pair) in blocks[at..].iter().zip(&pairs) {
            for (rows, columns, side) in [(first, second, 0), (second, first, 1)] {
                let (own, source) = (&pair.matrices[side], &pair.sources[side]);
                for (j, &column) in columns.nodes.iter().enumerate() {
                    for (i, &row) in rows.nodes.iter().enumerate() {
                        matrix[(row, column)] += own[(i, j)];
                    }
                }
                for (j, &column) in columns.triangles.iter().enumerate() {
                    for (i, &row) in rows.nodes.iter().enumerate() {
                        sources[(row, column)] += source[(i, j)];
                    }
                }
            }
        }
    }
    for (triangle, panel) in operators.panels.iter().enumerate() {
        let [diagonal, other] = operators.half_mass(triangle);
        for i in 0..3 {
            for j in 0..3 {
                matrix[(panel.nodes[i], panel.nodes[j])] += if i == j { diagonal } else { other };
            }
            sources[(panel.nodes[i], triangle)] += operators.half_mean(triangle);
        }
    }
    Ok((matrix, sources))
}

fn blocks(operators: &Operators) -> Vec<Block> {
    let supports: Vec<[Vector; 2]> =
        operators.panels.iter().map(|panel| [panel.centroid, panel.centroid]).collect();
    let tree = ClusterTree::new(&supports, BLOCK);
    let block = |leaf: usize| {
        let triangles = tree.items(leaf).to_vec();
        let mut nodes = Vec::new();
        let mut numbers = HashMap::new();
        let corners = triangles
            .iter()
            .map(|&triangle| {
                operators.panels[triangle].nodes.map(|node| {
                    *numbers.entry(node).or_insert_with(|| {
                        nodes.push(node);
                        nodes.len() - 1
                    })
                })
            })
            .collect();
        Block { triangles, nodes, corners }
    };
    tree.leaves().into_iter().map(block).collect()
}

fn block_pair(operators: &Operators, first: &Block, second: &Block) -> BlockPair {
    let same = std::ptr::eq(first, second);
    let (rows, columns) = (first.nodes.len(), second.nodes.len());
    let mut pair = BlockPair {
        matrices: [Mat::zeros(rows, columns), Mat::zeros(columns, rows)],
        sources: [Mat::zeros(rows, second.triangles.len()), Mat::zeros(columns, first.triangles.len())],
    };
    let has_images = !operators.images.is_empty();
    for (i, &triangle) in first.triangles.iter().enumerate() {
        for j in if same { i } else { 0 }..second.triangles.len() {
            let other = second.triangles[j];
            let once = triangle == other;
            let places = [(first.corners[i], i), (second.corners[j], j)];
            pair.add(&operators.pair(triangle, other), places, once);
            if has_images {
                pair.add(&operators.image_pair(triangle, other), places, once);
            }
        }
    }
    pair
}

impl BlockPair {
    /// Adds a contribution in both orders, or only in the first one.
    fn add(
        &mut self,
        entries: &PairEntries,
        [(from, source), (to, target)]: [([usize; 3], usize); 2],
        once: bool,
    ) {
        for i in 0..3 {
            for j in 0..3 {
                self.matrices[0][(from[i], to[j])] += entries.forward[i][j];
                if !once {
                    self.matrices[1][(to[j], from[i])] += entries.backward[j][i];
                }
            }
            self.sources[0][(from[i], target)] += entries.forward_source[i];
            if !once {
                self.sources[1][(to[i], source)] += entries.backward_source[i];
            }
        }
    }
}
