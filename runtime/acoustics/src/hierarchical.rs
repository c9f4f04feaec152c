//! Hierarchical matrices: dense blocks near the diagonal, blocks of low rank elsewhere.
//!
//! Blocks of low rank come from adaptive cross approximation with partial pivoting (Bebendorf
//! 2000).

use crate::cluster::ClusterTree;
use crate::error::AcousticError;
use calyx_numerics::interrupt::{Interrupt, MemoryReservation};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, c64};
use rayon::prelude::*;

/// Matrix whose entries are computed on request.
pub(crate) trait Entries: Sync {
    /// Returns the entries of these rows and columns.
    fn block(&self, rows: &[usize], columns: &[usize]) -> Mat<c64>;
}

/// Compressed matrix.
#[derive(Debug)]
pub(crate) struct HierarchicalMatrix {
    size: [usize; 2],
    blocks: Vec<Block>,
}

#[derive(Debug)]
struct Block {
    rows: Vec<usize>,
    columns: Vec<usize>,
    content: Content,
    memory: MemoryReservation,
}

#[derive(Debug)]
enum Content {
    Dense(Mat<c64>),
    /// Product of the first matrix and the transpose of the second.
    LowRank([Mat<c64>; 2]),
}

/// A block is admissible if the smaller diameter is at most this multiple of the distance.
const ADMISSIBLE: f64 = 1.5;

impl HierarchicalMatrix {
    /// Compresses a matrix to a relative accuracy of each block. Its rows and columns have the
    /// clusters of two trees.
    pub fn new(
        entries: &impl Entries,
        rows: &ClusterTree,
        columns: &ClusterTree,
        accuracy: f64,
        interrupt: &Interrupt,
    ) -> Result<Self, AcousticError> {
        let mut pairs = Vec::new();
        partition(rows, columns, [0, 0], &mut pairs);
        let blocks: Result<Vec<Block>, AcousticError> = pairs
            .par_iter()
            .map(|&([row, column], is_far)| {
                let (rows, columns) = (rows.items(row).to_vec(), columns.items(column).to_vec());
                let bytes = |count: usize| 16 * count as u64;
                let mut memory = interrupt.reserve_memory(bytes(2 * rows.len() * columns.len()))?;
                let approximation =
                    if is_far { cross_approximation(entries, &rows, &columns, accuracy) } else { None };
                let content = match approximation {
                    Some(factors) => Content::LowRank(factors),
                    None => Content::Dense(entries.block(&rows, &columns)),
                };
                memory.shrink_to(bytes(content.len()));
                Ok(Block { rows, columns, content, memory })
            })
            .collect();
        Ok(Self { size: [rows.order.len(), columns.order.len()], blocks: blocks? })
    }

    /// Returns the memory of the entries, bytes.
    pub fn memory(&self) -> u64 {
        self.blocks.iter().map(|block| block.memory.bytes()).sum()
    }

    /// Returns the product with columns. The sums have the same order with any number of threads.
    pub fn product(&self, columns: MatRef<'_, c64>) -> Mat<c64> {
        self.sum(self.size[0], columns, false)
    }

    /// Returns the product of the transpose with columns.
    pub fn transpose_product(&self, columns: MatRef<'_, c64>) -> Mat<c64> {
        self.sum(self.size[1], columns, true)
    }

    fn sum(&self, size: usize, right: MatRef<'_, c64>, transpose: bool) -> Mat<c64> {
        let parts: Vec<Mat<c64>> =
            self.blocks.par_iter().map(|block| block.product(right, transpose)).collect();
        let mut result = Mat::<c64>::zeros(size, right.ncols());
        for (block, part) in self.blocks.iter().zip(&parts) {
            let targets = if transpose { &block.columns } else { &block.rows };
            for j in 0..right.ncols() {
                for (i, &target) in targets.iter().enumerate() {
                    result[(target, j)] += part[(i, j)];
                }
            }
        }
        result
    }
}

impl Content {
    /// Returns the number of stored entries.
    fn len(&self) -> usize {
        match self {
            Self::Dense(matrix) => matrix.nrows() * matrix.ncols(),
            Self::LowRank([a, b]) => a.ncols() * (a.nrows() + b.nrows()),
        }
    }
}

impl Block {
    fn product(&self, right: MatRef<'_, c64>, transpose: bool) -> Mat<c64> {
        let sources = if transpose { &self.rows } else { &self.columns };
        let own = Mat::from_fn(sources.len(), right.ncols(), |i, j| right[(sources[i], j)]);
        match (&self.content, transpose) {
            (Content::Dense(matrix), false) => product(matrix.as_ref(), own.as_ref()),
            (Content::Dense(matrix), true) => product(matrix.transpose(), own.as_ref()),
            (Content::LowRank([a, b]), false) => {
                product(a.as_ref(), product(b.transpose(), own.as_ref()).as_ref())
            }
            (Content::LowRank([a, b]), true) => {
                product(b.as_ref(), product(a.transpose(), own.as_ref()).as_ref())
            }
        }
    }
}

fn product(a: MatRef<'_, c64>, b: MatRef<'_, c64>) -> Mat<c64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    matmul(result.as_mut(), Accum::Replace, a, b, c64::new(1.0, 0.0), Par::Seq);
    result
}

/// Lists the blocks below a pair of clusters, and whether they are admissible.
fn partition(
    rows: &ClusterTree,
    columns: &ClusterTree,
    [row, column]: [usize; 2],
    blocks: &mut Vec<([usize; 2], bool)>,
) {
    let (first, second) = (&rows.clusters[row], &columns.clusters[column]);
    let distance = first.distance(second);
    if distance > 0.0 && first.diameter().min(second.diameter()) <= ADMISSIBLE * distance {
        blocks.push(([row, column], true));
        return;
    }
    match (first.halves, second.halves) {
        (None, None) => blocks.push(([row, column], false)),
        (None, Some(halves)) => {
            halves.iter().for_each(|&half| partition(rows, columns, [row, half], blocks));
        }
        (Some(_), Some(halves)) if first.diameter() < second.diameter() => {
            halves.iter().for_each(|&half| partition(rows, columns, [row, half], blocks));
        }
        (Some(halves), _) => {
            halves.iter().for_each(|&half| partition(rows, columns, [half, column], blocks));
        }
    }
}

/// Approximates a block by the sum of products of columns and rows of its residual. `None` if this
/// takes more memory than the block.
fn cross_approximation(
    entries: &impl Entries,
    rows: &[usize],
    columns: &[usize],
    accuracy: f64,
) -> Option<[Mat<c64>; 2]> {
    let (m, n) = (rows.len(), columns.len());
    let most = (m * n / (m + n)).min(m).min(n);
    let mut cross = Cross { left: Vec::new(), right: Vec::new(), norm: 0.0 };
    let mut used = vec![false; m];
    // Rows at which an approximation that seems converged is compared with the block.
    let mut samples = vec![m / 4, m - 1, 0];
    let mut pivot = m / 2;
    loop {
        used[pivot] = true;
        let row = cross.residual_row(entries, pivot, rows, columns);
        let at = (0..n).fold(0, |best, j| if row[j].norm_sqr() > row[best].norm_sqr() { j } else { best });
        let scale = row[at];
        let row_norm = norm(&row);
        let mut is_small = scale.norm_sqr() == 0.0;
        if !is_small {
            if cross.left.len() == most {
                return None;
            }
            let column = cross.residual_column(entries, at, rows, columns);
            let product = norm(&column) * row_norm / scale.norm();
            cross.push(column, row.iter().map(|value| value / scale).collect());
            is_small = product <= accuracy * cross.norm.sqrt();
        }
        let next = if is_small { None } else { cross.pivot(&used) };
        pivot = match next {
            Some(next) => next,
            None => {
                let bound = accuracy * cross.norm.sqrt() / (m as f64).sqrt();
                let deviates = |sample: &usize| {
                    !used[*sample] && norm(&cross.residual_row(entries, *sample, rows, columns)) > bound
                };
                let found = std::iter::from_fn(|| samples.pop()).find(deviates);
                match found {
                    Some(sample) => sample,
                    None => break,
                }
            }
        };
    }
    let rank = cross.left.len();
    Some([Mat::from_fn(m, rank, |i, k| cross.left[k][i]), Mat::from_fn(n, rank, |j, k| cross.right[k][j])])
}

fn norm(values: &[c64]) -> f64 {
    values.iter().map(|value| value.norm_sqr()).sum::<f64>().sqrt()
}

/// Sum of products of columns and rows.
struct Cross {
    left: Vec<Vec<c64>>,
    right: Vec<Vec<c64>>,
    /// Square of the Frobenius norm.
    norm: f64,
}

impl Cross {
    fn residual_row(
        &self,
        entries: &impl Entries,
        pivot: usize,
        rows: &[usize],
        columns: &[usize],
    ) -> Vec<c64> {
        let exact = entries.block(&rows[pivot..=pivot], columns);
        let residual = |j: usize| {
            let known: c64 = self.left.iter().zip(&self.right).map(|(a, b)| a[pivot] * b[j]).sum();
            exact[(0, j)] - known
        };
        (0..columns.len()).map(residual).collect()
    }

    fn residual_column(
        &self,
        entries: &impl Entries,
        pivot: usize,
        rows: &[usize],
        columns: &[usize],
    ) -> Vec<c64> {
        let exact = entries.block(rows, &columns[pivot..=pivot]);
        let residual = |i: usize| {
            let known: c64 = self.left.iter().zip(&self.right).map(|(a, b)| a[i] * b[pivot]).sum();
            exact[(i, 0)] - known
        };
        (0..rows.len()).map(residual).collect()
    }

    fn push(&mut self, left: Vec<c64>, right: Vec<c64>) {
        let dot = |a: &[c64], b: &[c64]| a.iter().zip(b).map(|(x, y)| x.conj() * y).sum::<c64>();
        for (a, b) in self.left.iter().zip(&self.right) {
            self.norm += 2.0 * (dot(a, &left) * dot(b, &right)).re;
        }
        self.norm += (norm(&left) * norm(&right)).powi(2);
        self.norm = self.norm.max(0.0);
        self.left.push(left);
        self.right.push(right);
    }

    /// Returns the row of the largest entry of the last column that is not used yet.
    fn pivot(&self, used: &[bool]) -> Option<usize> {
        let column = self.left.last()?;
        let free = (0..used.len()).filter(|row| !used[*row]);
        free.max_by(|&a, &b| column[a].norm_sqr().total_cmp(&column[b].norm_sqr()).then(b.cmp(&a)))
    }
}
