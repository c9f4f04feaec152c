//! Dense matrix operations for condensation and for joining sectors.
//!
//! Large operations are divided into pieces that run in parallel. The division depends only on the
//! sizes, and each piece is sequential, so results are bitwise equal for any number of threads.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{self, LltParams, cholesky_in_place_scratch};
use faer::linalg::evd::{
    ComputeEigenvectors, SelfAdjointEvdParams, self_adjoint_evd, self_adjoint_evd_scratch,
};
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatMut, MatRef, Par, Spec};

/// Number of multiplications of a piece that is not divided further: about a millisecond.
const GRAIN: usize = 1 << 24;
/// Number of rows or columns of a piece that is not divided further.
const NARROW: usize = 96;
/// Size of a matrix that is factorized in one piece.
const WHOLE: usize = 256;

/// Returns the point of division of a length, aligned to the vectors of the processor.
fn half(length: usize) -> usize {
    (length / 2).next_multiple_of(16)
}

/// Computes the lower Cholesky factor of a symmetric positive definite matrix from its lower
/// triangle. `None` if the matrix is not numerically positive definite.
pub fn cholesky(mut matrix: Mat<f64>) -> Option<Mat<f64>> {
    if !cholesky_in_place(matrix.as_mut()) {
        return None;
    }
    for j in 0..matrix.ncols() {
        matrix.as_mut().col_mut(j).subrows_mut(0, j).fill(0.0);
    }
    Some(matrix)
}

/// Computes [`cholesky`] in place of the lower triangle; the upper triangle is undefined
/// afterwards. Returns whether the matrix was positive definite.
#[must_use]
pub fn cholesky_in_place(matrix: MatMut<'_, f64>) -> bool {
    let size = matrix.nrows();
    if size <= WHOLE {
        let params: Spec<LltParams, f64> = Spec::default();
        let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(size, Par::Seq, params));
        let stack = MemStack::new(&mut memory);
        return factor::cholesky_in_place(matrix, Default::default(), Par::Seq, stack, params).is_ok();
    }
    let cut = half(size);
    let (mut first, _, mut between, mut last) = matrix.split_at_mut(cut, cut);
    if !cholesky_in_place(first.as_mut()) {
        return false;
    }
    divide_by_cholesky_factor(between.as_mut(), first.as_ref());
    add_product_lower(last.as_mut(), -1.0, between.as_ref(), between.as_ref().transpose());
    cholesky_in_place(last)
}

/// Computes `B L^-T` in place of `B`.
pub fn divide_by_cholesky_factor(right: MatMut<'_, f64>, lower: MatRef<'_, f64>) {
    solve_lower_in_place(lower, right.transpose_mut());
}

fn solve_lower_in_place(lower: MatRef<'_, f64>, right: MatMut<'_, f64>) {
    let columns = right.ncols();
    if columns <= NARROW || columns * lower.nrows() * lower.nrows() <= GRAIN {
        return solve_lower_triangular_in_place(lower, right, Par::Seq);
    }
    let (one, other) = right.split_at_col_mut(half(columns));
    rayon::join(|| solve_lower_in_place(lower, one), || solve_lower_in_place(lower, other));
}

/// Computes `L^-1 B`, the first half of a solution: `B^T A^-1 B` is then a product of the result
/// with its own transpose, symmetric and positive semidefinite regardless of rounding.
pub fn solve_lower(lower: MatRef<'_, f64>, mut right: Mat<f64>) -> Mat<f64> {
    solve_lower_in_place(lower, right.as_mut());
    right
}

/// Computes `L^-T B`, the second half of a solution.
pub fn solve_upper(lower: MatRef<'_, f64>, mut right: Mat<f64>) -> Mat<f64> {
    fn in_place(lower: MatRef<'_, f64>, right: MatMut<'_, f64>) {
        let columns = right.ncols();
        if columns <= NARROW || columns * lower.nrows() * lower.nrows() <= GRAIN {
            return solve_upper_triangular_in_place(lower.transpose(), right, Par::Seq);
        }
        let (one, other) = right.split_at_col_mut(half(columns));
        rayon::join(|| in_place(lower, one), || in_place(lower, other));
    }
    in_place(lower, right.as_mut());
    right
}

/// Computes `A^-1 B` from the factor of `A`.
pub fn solve(lower: MatRef<'_, f64>, right: Mat<f64>) -> Mat<f64> {
    solve_upper(lower, solve_lower(lower, right))
}

/// Computes `target += scale * A B`.
pub fn add_product(target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    let (rows, columns) = (target.nrows(), target.ncols());
    if rows.max(columns) <= NARROW || rows * columns * a.ncols() <= GRAIN {
        matmul(target, Accum::Add, a, b, scale, Par::Seq);
    } else if rows >= columns {
        let cut = half(rows);
        let ((one, other), (upper, lower)) = (target.split_at_row_mut(cut), a.split_at_row(cut));
        rayon::join(|| add_product(one, scale, upper, b), || add_product(other, scale, lower, b));
    } else {
        let cut = half(columns);
        let ((one, other), (left, right)) = (target.split_at_col_mut(cut), b.split_at_col(cut));
        rayon::join(|| add_product(one, scale, a, left), || add_product(other, scale, a, right));
    }
}

/// Computes `target += scale * A B` for the lower triangle of a square target.
pub fn add_product_lower(target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    let size = target.nrows();
    if size <= NARROW || size * size * a.ncols() <= GRAIN {
        let (lower, whole) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
        return triangular::matmul(target, lower, Accum::Add, a, whole, b, whole, scale, Par::Seq);
    }
    let cut = half(size);
    let (first, _, between, last) = target.split_at_mut(cut, cut);
    let ((upper, lower), (left, right)) = (a.split_at_row(cut), b.split_at_col(cut));
    rayon::join(
        || add_product(between, scale, lower, left),
        || {
            rayon::join(
                || add_product_lower(first, scale, upper, left),
                || add_product_lower(last, scale, lower, right),
            )
        },
    );
}

/// Computes `A B`.
pub fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    add_product(result.as_mut(), 1.0, a, b);
    result
}

/// Returns eigenvalues of a symmetric matrix, ascending, and unit eigenvectors from its lower
/// triangle. `None` if an entry is not finite.
pub fn symmetric_eigen(matrix: MatRef<'_, f64>) -> Option<(Vec<f64>, Mat<f64>)> {
    let size = matrix.nrows();
    let params: Spec<SelfAdjointEvdParams, f64> = Spec::default();
    let scratch = self_adjoint_evd_scratch::<f64>(size, ComputeEigenvectors::Yes, Par::Seq, params);
    let mut memory = MemBuffer::new(scratch);
    let (mut values, mut vectors) = (Diag::<f64>::zeros(size), Mat::zeros(size, size));
    let stack = MemStack::new(&mut memory);
    self_adjoint_evd(matrix, values.as_mut(), Some(vectors.as_mut()), Par::Seq, stack, params).ok()?;
    let values: Vec<f64> = values.column_vector().iter().copied().collect();
    values.iter().all(|value| value.is_finite()).then_some((values, vectors))
}

/// Copies the lower triangle of a matrix that is symmetric up to rounding onto the upper one.
pub fn mirror_lower(matrix: &mut Mat<f64>) {
    for j in 0..matrix.ncols() {
        for i in 0..j {
            matrix[(i, j)] = matrix[(j, i)];
        }
    }
}
