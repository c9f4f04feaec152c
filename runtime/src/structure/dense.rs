//! The few dense operations the condensation needs, sequential so that results have the same bits at any thread count.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltParams, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, Mat, MatMut, MatRef, Par, Spec};

/// The lower Cholesky factor of a symmetric positive definite matrix, of which the lower triangle is read.
/// `None` if it is not numerically positive definite.
pub(super) fn cholesky(mut matrix: Mat<f64>) -> Option<Mat<f64>> {
    let size = matrix.nrows();
    let params: Spec<LltParams, f64> = Spec::default();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(size, Par::Seq, params));
    cholesky_in_place(matrix.as_mut(), Default::default(), Par::Seq, MemStack::new(&mut memory), params)
        .ok()?;
    for j in 0..size {
        for i in 0..j {
            matrix[(i, j)] = 0.0;
        }
    }
    Some(matrix)
}

/// `L^-1 B`, half of a solution: `B^T A^-1 B` is then a product of it with its own transpose, symmetric and
/// non-negative whatever the rounding.
pub(super) fn half_solve(lower: MatRef<'_, f64>, mut right: Mat<f64>) -> Mat<f64> {
    solve_lower_triangular_in_place(lower, right.as_mut(), Par::Seq);
    right
}

/// `A^-1 B` from the factor of `A`.
pub(super) fn solve(lower: MatRef<'_, f64>, right: Mat<f64>) -> Mat<f64> {
    let mut right = half_solve(lower, right);
    solve_upper_triangular_in_place(lower.transpose(), right.as_mut(), Par::Seq);
    right
}

/// `target += scale * A B`.
pub(super) fn add_product(mut target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    matmul(target.as_mut(), Accum::Add, a, b, scale, Par::Seq);
}

/// `A B`.
pub(super) fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    add_product(result.as_mut(), 1.0, a, b);
    result
}

/// Copies the lower triangle of a matrix that is symmetric up to rounding onto the upper one.
pub(super) fn mirror_lower(matrix: &mut Mat<f64>) {
    for j in 0..matrix.ncols() {
        for i in 0..j {
            matrix[(i, j)] = matrix[(j, i)];
        }
    }
}
