//! Equations of an active set: dense Cholesky factorization of the compliance, and Schur complement
//! for the DOFs.

use calyx_numerics::dense::{add_product, divide_by_cholesky_factor};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt;
use faer::{Mat, MatMut, Par};
use nalgebra::DMatrix;
use std::ops::Range;

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Returns the product of row `i` of a matrix with a vector.
pub(super) fn row_product(matrix: &DMatrix<f64>, i: usize, vector: &[f64]) -> f64 {
    matrix.row(i).iter().zip(vector).map(|(x, y)| x * y).sum()
}

/// Returns the DOFs that a cell acts on, with its arms: those of its two bodies.
pub(super) fn arms_of(arms: &DMatrix<f64>, cell: usize) -> impl Iterator<Item = (usize, f64)> {
    (0..arms.ncols()).map(move |k| (k, arms[(cell, k)])).filter(|(_, arm)| *arm != 0.0)
}

/// Reason why the equations of an active set have no unique solution.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Singular {
    /// The compliance is not positive definite; contains the position in the active set at which
    /// the factorization breaks down.
    Compliance(usize),
    /// Neither the active cells nor a spring resist this motion.
    Dofs(Vec<f64>),
    /// The factorization was interrupted.
    Interrupted(EngineError),
}

/// Reason why a factorization has no result.
enum Broken {
    /// First row that depends on the rows before it.
    Dependent(usize),
    Interrupted(EngineError),
}

/// Size of a matrix that is factorized in one piece, in less than a tenth of a second.
const WHOLE: usize = 1024;
/// Number of multiplications between two checkpoints: about a tenth of a second.
const PIECE: usize = 1 << 29;
/// Size of a tile in which a matrix is copied. Rows of one matrix and columns of another, which are
/// far apart in memory, stay in the cache for a tile.
const TILE: usize = 64;

/// Returns the ranges of rows or columns of the tiles of a matrix of size `n`.
pub(super) fn tiles(n: usize) -> impl Iterator<Item = Range<usize>> {
    (0..n).step_by(TILE).map(move |start| start..(start + TILE).min(n))
}

/// A pivot below this fraction of its diagonal entry is rounding: the row depends on the rows
/// before it.
const PIVOT_TOLERANCE: f64 = 1e-13;

/// Cholesky factorization `A = L L'`, in place of the lower triangle.
fn cholesky(a: &mut Mat<f64>, interrupt: &Interrupt) -> Result<(), Broken> {
    let n = a.nrows();
    let diagonal: Vec<f64> = (0..n).map(|i| a[(i, i)]).collect();
    factor(a.as_mut(), 0, interrupt)?;
    match (0..n).find(|&i| a[(i, i)] * a[(i, i)] <= PIVOT_TOLERANCE * diagonal[i]) {
        Some(dependent) => Err(Broken::Dependent(dependent)),
        None => Ok(()),
    }
}

/// Factorizes a part of a matrix that starts at row `first` of the whole. Large parts are divided
/// by their size alone, with a checkpoint before each piece.
fn factor(a: MatMut<'_, f64>, first: usize, interrupt: &Interrupt) -> Result<(), Broken> {
    let checkpoint = || interrupt.check().map_err(Broken::Interrupted);
    checkpoint()?;
    let n = a.nrows();
    if n <= WHOLE {
        return factor_whole(a).map_err(|row| Broken::Dependent(first + row));
    }
    let cut = n / 2;
    let (mut upper, _, mut between, mut lower) = a.split_at_mut(cut, cut);
    factor(upper.as_mut(), first, interrupt)?;
    let rows = (PIECE / (cut * cut)).max(1);
    for from in (0..n - cut).step_by(rows) {
        checkpoint()?;
        let count = rows.min(n - cut - from);
        divide_by_cholesky_factor(between.as_mut().subrows_mut(from, count), upper.as_ref());
    }
    let columns = (PIECE / (n * cut)).max(1);
    for from in (0..n - cut).step_by(columns) {
        checkpoint()?;
        let count = columns.min(n - cut - from);
        let below = between.as_ref().subrows(from, n - cut - from);
        let target = lower.as_mut().submatrix_mut(from, from, n - cut - from, count);
        add_product(target, -1.0, below, below.subrows(0, count).transpose());
    }
    factor(lower, first + cut, interrupt)
}

/// Factorizes a matrix in one piece. The error is the row at which it is not positive definite.
fn factor_whole(mut a: MatMut<'_, f64>) -> Result<(), usize> {
    let n = a.nrows();
    // Sequential, so that the bits do not depend on the number of threads.
    let mut memory =
        MemBuffer::new(llt::factor::cholesky_in_place_scratch::<f64>(n, Par::Seq, Default::default()));
    llt::factor::cholesky_in_place(
        a.as_mut(),
        Default::default(),
        Par::Seq,
        MemStack::new(&mut memory),
        Default::default(),
    )
    .map_err(|llt::factor::LltError::NonPositivePivot { index }| index)?;
    Ok(())
}

fn solve_in_place(factor: &Mat<f64>, right: &mut Mat<f64>) {
    let mut memory =
        MemBuffer::new(llt::solve::solve_in_place_scratch::<f64>(factor.nrows(), right.ncols(), Par::Seq));
    llt::solve::solve_in_place(factor.as_ref(), right.as_mut(), Par::Seq, MemStack::new(&mut memory));
}

/// Factorized equations of an active set S: `A_SS p + C_S x = -e_S`, `C_S' p - K x = -f`.
pub(super) struct ActiveEquations {
    factor: Mat<f64>,
    /// `C_S` and `A_SS^-1 C_S`.
    arms: Mat<f64>,
    solved_arms: Mat<f64>,
    /// Cholesky factor of the Schur complement `K + C_S' A_SS^-1 C_S`.
    schur: Mat<f64>,
}

/// Relative size below which a pivot of the Schur complement (with unit diagonal) counts as zero.
const RANK_TOLERANCE: f64 = 1e-12;

impl ActiveEquations {
    /// Factorizes the equations from the rows of the symmetric compliance of all cells, which is
    /// multiplied by `scale` from both sides, the scaled `arms` of all cells, the ascending
    /// `active` cells and the `stiffness` of the DOFs.
    pub fn new<'a>(
        row: impl Fn(usize) -> &'a [f64],
        scale: &[f64],
        arms: &DMatrix<f64>,
        stiffness: &DMatrix<f64>,
        active: &[usize],
        interrupt: &Interrupt,
    ) -> Result<Self, Singular> {
        let (n, m) = (active.len(), arms.ncols());
        let checkpoint = || interrupt.check().map_err(Singular::Interrupted);
        let mut factor = Mat::zeros(n, n);
        let scales: Vec<f64> = active.iter().map(|&cell| scale[cell]).collect();
        for columns in tiles(n) {
            checkpoint()?;
            // Only the lower triangle is read. Its columns are rows of the symmetric compliance, so
            // that both are read and written in the order of their addresses.
            for j in columns {
                let (of_cell, own) = (row(active[j]), scales[j]);
                let entries = factor.col_as_slice_mut(j)[j..].iter_mut().zip(&scales[j..]);
                for ((entry, scale), &cell) in entries.zip(&active[j..]) {
                    *entry = scale * of_cell[cell] * own;
                }
            }
        }
        cholesky(&mut factor, interrupt).map_err(|broken| match broken {
            Broken::Dependent(row) => Singular::Compliance(row),
            Broken::Interrupted(error) => Singular::Interrupted(error),
        })?;
        checkpoint()?;
        let active_arms = Mat::from_fn(n, m, |i, k| arms[(active[i], k)]);
        let mut solved_arms = active_arms.clone();
        solve_in_place(&factor, &mut solved_arms);
        // The arms of a cell are zero except for the DOFs of its two bodies.
        let mut sums = DMatrix::<f64>::zeros(m, m);
        let mut solved = vec![0.0; m];
        for (i, &cell) in active.iter().enumerate() {
            solved.iter_mut().enumerate().for_each(|(l, entry)| *entry = solved_arms[(i, l)]);
            for (k, arm) in arms_of(arms, cell) {
                for (sum, entry) in sums.column_mut(k).iter_mut().zip(&solved) {
                    *sum += arm * entry;
                }
            }
        }
        let mut schur = Mat::from_fn(m, m, |k, l| stiffness[(k, l)] + sums[(l, k)]);
        let whole = DMatrix::from_fn(m, m, |k, l| schur[(k, l)]);
        if let Some(motion) = null_motion(&whole, RANK_TOLERANCE) {
            return Err(Singular::Dofs(motion));
        }
        // The matrix is positive definite beyond RANK_TOLERANCE, so the factor exists. If rounding
        // breaks it, the last DOF is named.
        cholesky(&mut schur, interrupt).map_err(|broken| match broken {
            Broken::Dependent(k) => {
                let mut motion = vec![0.0; m];
                motion[k.min(m - 1)] = 1.0;
                Singular::Dofs(motion)
            }
            Broken::Interrupted(error) => Singular::Interrupted(error),
        })?;
        Ok(Self { factor, arms: active_arms, solved_arms, schur })
    }

    /// Solves for `(p_S, x)` with the right-hand sides `gaps` (of the gap rows) and `loads` (of the
    /// equilibrium rows).
    pub fn solve(&self, gaps: &[f64], loads: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let (n, m) = (gaps.len(), loads.len());
        let mut pressed = Mat::from_fn(n, 1, |i, _| gaps[i]);
        solve_in_place(&self.factor, &mut pressed);
        let mut motion = Mat::from_fn(m, 1, |k, _| {
            (0..n).map(|i| self.arms[(i, k)] * pressed[(i, 0)]).sum::<f64>() - loads[k]
        });
        solve_in_place(&self.schur, &mut motion);
        let x: Vec<f64> = (0..m).map(|k| motion[(k, 0)]).collect();
        let p = (0..n)
            .map(|i| pressed[(i, 0)] - (0..m).map(|k| self.solved_arms[(i, k)] * x[k]).sum::<f64>())
            .collect();
        (p, x)
    }
}

/// Returns a null vector of a positive semidefinite matrix with largest component 1; `None` if the
/// matrix is definite. Uses diagonal pivoting after scaling to unit diagonal, so units of the DOFs
/// do not matter.
pub(super) fn null_motion(matrix: &DMatrix<f64>, tolerance: f64) -> Option<Vec<f64>> {
    let m = matrix.nrows();
    let scale: Vec<f64> =
        (0..m).map(|k| if matrix[(k, k)] > 0.0 { matrix[(k, k)].sqrt().recip() } else { 0.0 }).collect();
    if let Some(k) = scale.iter().position(|&s| s == 0.0) {
        return Some((0..m).map(|l| if l == k { 1.0 } else { 0.0 }).collect());
    }
    let mut a = DMatrix::zeros(m, m);
    for k in 0..m {
        for l in 0..m {
            a[(k, l)] = scale[k] * matrix[(k, l)] * scale[l];
        }
    }
    let mut remaining: Vec<usize> = (0..m).collect();
    let mut pivots = Vec::new();
    while let Some(position) = (0..remaining.len()).max_by(|&p, &q| {
        a[(remaining[p], remaining[p])].total_cmp(&a[(remaining[q], remaining[q])]).then(q.cmp(&p))
    }) {
        let k = remaining[position];
        if a[(k, k)] <= tolerance {
            // Solve a v = 0 with v_k = 1 by back-substitution through the eliminated rows.
            let mut motion = vec![0.0; m];
            motion[k] = 1.0;
            for &(row, ref values) in pivots.iter().rev() {
                let values: &Vec<f64> = values;
                let sum: f64 = (0..m).filter(|&l| l != row).map(|l| values[l] * motion[l]).sum();
                motion[row] = -sum / values[row];
            }
            for l in 0..m {
                motion[l] *= scale[l];
            }
            let largest = motion.iter().fold(0.0, |b: f64, v| if v.abs() > b.abs() { *v } else { b });
            return Some(motion.iter().map(|v| v / largest).collect());
        }
        remaining.swap_remove(position);
        let row: Vec<f64> =
            (0..m).map(|l| if l == k || remaining.contains(&l) { a[(k, l)] } else { 0.0 }).collect();
        for &i in &remaining {
            let factor = a[(i, k)] / row[k];
            for &j in &remaining {
                a[(i, j)] -= factor * row[j];
            }
        }
        pivots.push((k, row));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    /// Returns a matrix of that size with a dense factor.
    fn compliance(n: usize) -> Mat<f64> {
        Mat::from_fn(n, n, |i, j| {
            let apart = i.abs_diff(j) as f64;
            if i == j { 2.0 } else { (-0.01 * apart).exp() }
        })
    }

    #[test]
    fn a_large_factor_has_checkpoints_and_reproduces_its_matrix() {
        let n = WHOLE + 200;
        let asked = Arc::new(AtomicUsize::new(0));
        let counted = asked.clone();
        let counting = Interrupt::new(move || {
            counted.fetch_add(1, Relaxed);
            Ok(())
        });
        let whole = compliance(n);
        let mut cut = whole.clone();
        assert!(cholesky(&mut cut, &counting).is_ok());
        assert!(asked.load(Relaxed) >= 5, "{} checkpoints", asked.load(Relaxed));
        for (i, j) in [(0, 0), (n - 1, 0), (n - 1, n - 1), (n / 2 + 3, n / 2 - 5), (n - 7, n / 2)] {
            let value: f64 = (0..=i.min(j)).map(|k| cut[(i, k)] * cut[(j, k)]).sum();
            assert!((value - whole[(i, j)]).abs() < 1e-12, "({i}, {j}): {value} and {}", whole[(i, j)]);
        }
        // A row that repeats another one is detected at any position.
        let twice = Mat::from_fn(n, n, |i, j| {
            let of = |k: usize| if k == n - 2 { 3 } else { k };
            whole[(of(i), of(j))]
        });
        let broken = cholesky(&mut twice.clone(), &Interrupt::never());
        assert!(matches!(broken, Err(Broken::Dependent(row)) if row == n - 2));
        let ended = Interrupt::new(|| Err(EngineError::new("E0704", "enough", "")));
        assert!(matches!(cholesky(&mut whole.clone(), &ended), Err(Broken::Interrupted(_))));
    }
}
