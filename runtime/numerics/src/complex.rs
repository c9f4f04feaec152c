//! Complex linear systems: LU factors, and an iterative solution with a preconditioner.
//!
//! All operations are sequential, so several systems can be solved at a time with bits that do not
//! depend on the number of threads.

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::lu::partial_pivoting::factor::{lu_in_place, lu_in_place_scratch};
use faer::linalg::lu::partial_pivoting::solve::{
    solve_in_place, solve_in_place_scratch, solve_transpose_in_place, solve_transpose_in_place_scratch,
};
use faer::matrix_free::bicgstab::{BicgParams, bicgstab, bicgstab_scratch};
use faer::matrix_free::{IdentityPrecond, InitialGuessStatus, LinOp, Precond};
use faer::perm::PermRef;
use faer::{Mat, MatMut, MatRef, Par, Spec, c64};
use std::fmt;

/// LU factors of a square complex matrix with row exchanges.
#[derive(Debug)]
pub struct ComplexLu {
    factors: Mat<c64>,
    /// Exchange of rows, and its inverse.
    rows: [Vec<usize>; 2],
}

impl ComplexLu {
    /// Factorizes a square matrix. The factors of a singular matrix are not finite.
    pub fn new(mut matrix: Mat<c64>) -> ComplexLu {
        let size = matrix.nrows();
        let (mut rows, mut inverse) = (vec![0_usize; size], vec![0_usize; size]);
        let params = Spec::default();
        let mut memory = MemBuffer::new(lu_in_place_scratch::<usize, c64>(size, size, Par::Seq, params));
        let stack = MemStack::new(&mut memory);
        lu_in_place(matrix.as_mut(), &mut rows, &mut inverse, Par::Seq, stack, params);
        ComplexLu { factors: matrix, rows: [rows, inverse] }
    }

    /// Replaces the columns of a right-hand side by the solutions.
    ///
    /// # Panics
    /// The number of rows is not that of the matrix.
    pub fn solve_in_place(&self, right: MatMut<'_, c64>) {
        let size = self.factors.nrows();
        let [rows, inverse] = &self.rows;
        let rows = PermRef::new_checked(rows, inverse, size);
        let mut memory = MemBuffer::new(solve_in_place_scratch::<usize, c64>(size, right.ncols(), Par::Seq));
        let stack = MemStack::new(&mut memory);
        solve_in_place(self.factors.as_ref(), self.factors.as_ref(), rows, right, Par::Seq, stack);
    }

    /// Replaces the columns of a right-hand side by the solutions with the transposed matrix.
    ///
    /// # Panics
    /// The number of rows is not that of the matrix.
    pub fn solve_transpose_in_place(&self, right: MatMut<'_, c64>) {
        let size = self.factors.nrows();
        let [rows, inverse] = &self.rows;
        let rows = PermRef::new_checked(rows, inverse, size);
        let scratch = solve_transpose_in_place_scratch::<usize, c64>(size, right.ncols(), Par::Seq);
        let mut memory = MemBuffer::new(scratch);
        let stack = MemStack::new(&mut memory);
        solve_transpose_in_place(self.factors.as_ref(), self.factors.as_ref(), rows, right, Par::Seq, stack);
    }
}

/// Solves a complex linear system with row exchanges. `None` if a value of the solution is not
/// finite.
pub fn solve_complex(matrix: Mat<c64>, mut right: Mat<c64>) -> Option<Mat<c64>> {
    ComplexLu::new(matrix).solve_in_place(right.as_mut());
    is_finite(&right).then_some(right)
}

fn is_finite(matrix: &Mat<c64>) -> bool {
    let finite = |i: usize, j: usize| matrix[(i, j)].re.is_finite() && matrix[(i, j)].im.is_finite();
    (0..matrix.ncols()).all(|j| (0..matrix.nrows()).all(|i| finite(i, j)))
}

/// Linear map of columns of a length to columns of the same length: it writes the images of the
/// columns of its first argument into the second one.
pub type Map<'f> = &'f (dyn Fn(MatRef<'_, c64>, MatMut<'_, c64>) + Sync);

/// Solves a complex linear system with the stabilized biconjugate gradient method (van der Vorst
/// 1992), until the residual is at most `tolerance` times the right-hand side.
///
/// `preconditioner` is an approximate inverse of `matrix`. `None` if the residual is larger after
/// this number of iterations.
pub fn solve_iteratively(
    matrix: Map<'_>,
    preconditioner: Map<'_>,
    right: MatRef<'_, c64>,
    (tolerance, iterations): (f64, usize),
) -> Option<Mat<c64>> {
    let size = right.nrows();
    let [matrix, preconditioner] = [matrix, preconditioner].map(|apply| Operator { size, apply });
    let params = BicgParams {
        // faer 0.24 does not initialize the residual for the guess `Zero`.
        initial_guess: InitialGuessStatus::MaybeNonZero,
        rel_tolerance: tolerance,
        max_iters: iterations,
        ..BicgParams::default()
    };
    // The left one would change the residual that is compared with the tolerance.
    let left = IdentityPrecond { dim: size };
    let scratch = bicgstab_scratch(left, &preconditioner, &matrix, right.ncols(), Par::Seq);
    let mut memory = MemBuffer::new(scratch);
    let stack = MemStack::new(&mut memory);
    let mut found = Mat::<c64>::zeros(size, right.ncols());
    bicgstab(found.as_mut(), left, &preconditioner, &matrix, right, params, |_| {}, Par::Seq, stack).ok()?;
    // The recursive residual of the method may deviate from the true one.
    let mut rest = Mat::<c64>::zeros(size, right.ncols());
    (matrix.apply)(found.as_ref(), rest.as_mut());
    let residual = (&rest - right).norm_l2();
    (residual <= 100.0 * tolerance * right.norm_l2()).then_some(found)
}

/// A linear map as an operator of the iterative method.
struct Operator<'f> {
    size: usize,
    apply: Map<'f>,
}

impl fmt::Debug for Operator<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Operator").field("size", &self.size).finish_non_exhaustive()
    }
}

impl LinOp<c64> for Operator<'_> {
    fn apply_scratch(&self, _: usize, _: Par) -> StackReq {
        StackReq::EMPTY
    }

    fn nrows(&self) -> usize {
        self.size
    }

    fn ncols(&self) -> usize {
        self.size
    }

    fn apply(&self, out: MatMut<'_, c64>, rhs: MatRef<'_, c64>, _: Par, _: &mut MemStack) {
        (self.apply)(rhs, out);
    }

    fn conj_apply(&self, mut out: MatMut<'_, c64>, rhs: MatRef<'_, c64>, _: Par, _: &mut MemStack) {
        let conjugate = rhs.conjugate().to_owned();
        (self.apply)(conjugate.as_ref(), out.as_mut());
        for j in 0..out.ncols() {
            for i in 0..out.nrows() {
                out[(i, j)] = out[(i, j)].conj();
            }
        }
    }
}

impl Precond<c64> for Operator<'_> {}
