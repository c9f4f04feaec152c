//! Sequential operations on pieces. They are not generic, so that the generics of faer are compiled
//! once, in this crate, and not in every crate that has a checkpoint of its own.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{self, LltParams, cholesky_in_place_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::triangular_solve::{solve_lower_triangular_in_place, solve_upper_triangular_in_place};
use faer::{Accum, MatMut, MatRef, Par, Spec};

/// Computes the Cholesky factor in place of the lower triangle. Returns whether the matrix was
/// positive definite.
pub(super) fn cholesky_in_place(matrix: MatMut<'_, f64>) -> bool {
    let params: Spec<LltParams, f64> = Spec::default();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(matrix.nrows(), Par::Seq, params));
    let stack = MemStack::new(&mut memory);
    factor::cholesky_in_place(matrix, Default::default(), Par::Seq, stack, params).is_ok()
}

/// Computes `L^-1 B` in place of `B`.
pub(super) fn solve_lower_in_place(lower: MatRef<'_, f64>, right: MatMut<'_, f64>) {
    solve_lower_triangular_in_place(lower, right, Par::Seq);
}

/// Computes `L^-T B` in place of `B`.
pub(super) fn solve_upper_in_place(lower: MatRef<'_, f64>, right: MatMut<'_, f64>) {
    solve_upper_triangular_in_place(lower.transpose(), right, Par::Seq);
}

/// Computes `target += scale * A B`.
pub(super) fn add_product(target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    matmul(target, Accum::Add, a, b, scale, Par::Seq);
}

/// Computes `target += scale * A B` for the lower triangle of a square target.
pub(super) fn add_product_lower(target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    let (lower, whole) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
    triangular::matmul(target, lower, Accum::Add, a, whole, b, whole, scale, Par::Seq);
}
