//! Dense matrix operations for condensation and for joining sectors.
//!
//! Large operations are divided into pieces that run in parallel. The division depends only on the
//! sizes, and each piece is sequential, so results are bitwise equal for any number of threads.

mod piece;

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{
    ComputeEigenvectors, SelfAdjointEvdParams, self_adjoint_evd, self_adjoint_evd_scratch,
};
use faer::{Mat, MatMut, MatRef, Par, Spec, c64};
use std::convert::Infallible;

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

/// Dense operations with a checkpoint before each piece: a callback whose error ends the operation.
/// The operation then returns this error, and its target is undefined. The functions of this module
/// are the same operations without checkpoints, with equal bits.
#[derive(Debug)]
pub struct Interruptible<'c, C>(pub &'c C);

// A derived implementation would require a copyable callback.
impl<C> Clone for Interruptible<'_, C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<C> Copy for Interruptible<'_, C> {}

impl<C, E> Interruptible<'_, C>
where
    C: Fn() -> Result<(), E> + Sync,
    E: Send,
{
    /// See [`cholesky`].
    pub fn cholesky(self, mut matrix: Mat<f64>) -> Result<Option<Mat<f64>>, E> {
        if !self.cholesky_in_place(matrix.as_mut())? {
            return Ok(None);
        }
        for j in 0..matrix.ncols() {
            matrix.as_mut().col_mut(j).subrows_mut(0, j).fill(0.0);
        }
        Ok(Some(matrix))
    }

    /// See [`cholesky_in_place`].
    pub fn cholesky_in_place(self, matrix: MatMut<'_, f64>) -> Result<bool, E> {
        let size = matrix.nrows();
        if size <= WHOLE {
            (self.0)()?;
            return Ok(piece::cholesky_in_place(matrix));
        }
        let cut = half(size);
        let (mut first, _, mut between, mut last) = matrix.split_at_mut(cut, cut);
        if !self.cholesky_in_place(first.as_mut())? {
            return Ok(false);
        }
        self.divide_by_cholesky_factor(between.as_mut(), first.as_ref())?;
        self.add_product_lower(last.as_mut(), -1.0, between.as_ref(), between.as_ref().transpose())?;
        self.cholesky_in_place(last)
    }

    /// See [`divide_by_cholesky_factor`].
    pub fn divide_by_cholesky_factor(self, right: MatMut<'_, f64>, lower: MatRef<'_, f64>) -> Result<(), E> {
        self.solve_lower_in_place(lower, right.transpose_mut())
    }

    fn solve_lower_in_place(self, lower: MatRef<'_, f64>, right: MatMut<'_, f64>) -> Result<(), E> {
        let columns = right.ncols();
        if columns <= NARROW || columns * lower.nrows() * lower.nrows() <= GRAIN {
            (self.0)()?;
            piece::solve_lower_in_place(lower, right);
            return Ok(());
        }
        let (one, other) = right.split_at_col_mut(half(columns));
        let (one, other) =
            rayon::join(|| self.solve_lower_in_place(lower, one), || self.solve_lower_in_place(lower, other));
        one.and(other)
    }

    fn solve_upper_in_place(self, lower: MatRef<'_, f64>, right: MatMut<'_, f64>) -> Result<(), E> {
        let columns = right.ncols();
        if columns <= NARROW || columns * lower.nrows() * lower.nrows() <= GRAIN {
            (self.0)()?;
            piece::solve_upper_in_place(lower, right);
            return Ok(());
        }
        let (one, other) = right.split_at_col_mut(half(columns));
        let (one, other) =
            rayon::join(|| self.solve_upper_in_place(lower, one), || self.solve_upper_in_place(lower, other));
        one.and(other)
    }

    /// See [`solve_lower`].
    pub fn solve_lower(self, lower: MatRef<'_, f64>, mut right: Mat<f64>) -> Result<Mat<f64>, E> {
        self.solve_lower_in_place(lower, right.as_mut())?;
        Ok(right)
    }

    /// See [`solve_upper`].
    pub fn solve_upper(self, lower: MatRef<'_, f64>, mut right: Mat<f64>) -> Result<Mat<f64>, E> {
        self.solve_upper_in_place(lower, right.as_mut())?;
        Ok(right)
    }

    /// See [`solve`].
    pub fn solve(self, lower: MatRef<'_, f64>, right: Mat<f64>) -> Result<Mat<f64>, E> {
        self.solve_upper(lower, self.solve_lower(lower, right)?)
    }

    /// See [`add_product`].
    pub fn add_product(
        self,
        target: MatMut<'_, f64>,
        scale: f64,
        a: MatRef<'_, f64>,
        b: MatRef<'_, f64>,
    ) -> Result<(), E> {
        let (rows, columns) = (target.nrows(), target.ncols());
        if rows.max(columns) <= NARROW || rows * columns * a.ncols() <= GRAIN {
            (self.0)()?;
            piece::add_product(target, scale, a, b);
            return Ok(());
        }
        let (one, other) = if rows >= columns {
            let cut = half(rows);
            let ((one, other), (upper, lower)) = (target.split_at_row_mut(cut), a.split_at_row(cut));
            rayon::join(
                || self.add_product(one, scale, upper, b),
                || self.add_product(other, scale, lower, b),
            )
        } else {
            let cut = half(columns);
            let ((one, other), (left, right)) = (target.split_at_col_mut(cut), b.split_at_col(cut));
            rayon::join(|| self.add_product(one, scale, a, left), || self.add_product(other, scale, a, right))
        };
        one.and(other)
    }

    /// See [`add_product_lower`].
    pub fn add_product_lower(
        self,
        target: MatMut<'_, f64>,
        scale: f64,
        a: MatRef<'_, f64>,
        b: MatRef<'_, f64>,
    ) -> Result<(), E> {
        let size = target.nrows();
        if size <= NARROW || size * size * a.ncols() <= GRAIN {
            (self.0)()?;
            piece::add_product_lower(target, scale, a, b);
            return Ok(());
        }
        let cut = half(size);
        let (first, _, between, last) = target.split_at_mut(cut, cut);
        let ((upper, lower), (left, right)) = (a.split_at_row(cut), b.split_at_col(cut));
        let (one, (other, third)) = rayon::join(
            || self.add_product(between, scale, lower, left),
            || {
                rayon::join(
                    || self.add_product_lower(first, scale, upper, left),
                    || self.add_product_lower(last, scale, lower, right),
                )
            },
        );
        one.and(other).and(third)
    }

    /// See [`product`].
    pub fn product(self, a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Result<Mat<f64>, E> {
        let mut result = Mat::zeros(a.nrows(), b.ncols());
        self.add_product(result.as_mut(), 1.0, a, b)?;
        Ok(result)
    }
}

/// The operations without checkpoints.
const WITHOUT: Interruptible<'static, fn() -> Result<(), Infallible>> =
    Interruptible(&((|| Ok(())) as fn() -> Result<(), Infallible>));

/// Computes the lower Cholesky factor of a symmetric positive definite matrix from its lower
/// triangle. `None` if the matrix is not numerically positive definite.
pub fn cholesky(matrix: Mat<f64>) -> Option<Mat<f64>> {
    let Ok(factor) = WITHOUT.cholesky(matrix);
    factor
}

/// Computes [`cholesky`] in place of the lower triangle; the upper triangle is undefined
/// afterwards. Returns whether the matrix was positive definite.
#[must_use]
pub fn cholesky_in_place(matrix: MatMut<'_, f64>) -> bool {
    let Ok(definite) = WITHOUT.cholesky_in_place(matrix);
    definite
}

/// Computes `B L^-T` in place of `B`.
pub fn divide_by_cholesky_factor(right: MatMut<'_, f64>, lower: MatRef<'_, f64>) {
    let Ok(()) = WITHOUT.divide_by_cholesky_factor(right, lower);
}

/// Computes `L^-1 B`, the first half of a solution: `B^T A^-1 B` is then a product of the result
/// with its own transpose, symmetric and positive semidefinite regardless of rounding.
pub fn solve_lower(lower: MatRef<'_, f64>, right: Mat<f64>) -> Mat<f64> {
    let Ok(solution) = WITHOUT.solve_lower(lower, right);
    solution
}

/// Computes `L^-T B`, the second half of a solution.
pub fn solve_upper(lower: MatRef<'_, f64>, right: Mat<f64>) -> Mat<f64> {
    let Ok(solution) = WITHOUT.solve_upper(lower, right);
    solution
}

/// Computes `A^-1 B` from the factor of `A`.
pub fn solve(lower: MatRef<'_, f64>, right: Mat<f64>) -> Mat<f64> {
    solve_upper(lower, solve_lower(lower, right))
}

/// Computes `target += scale * A B`.
pub fn add_product(target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    let Ok(()) = WITHOUT.add_product(target, scale, a, b);
}

/// Computes `target += scale * A B` for the lower triangle of a square target.
pub fn add_product_lower(target: MatMut<'_, f64>, scale: f64, a: MatRef<'_, f64>, b: MatRef<'_, f64>) {
    let Ok(()) = WITHOUT.add_product_lower(target, scale, a, b);
}

/// Computes `A B`.
pub fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let Ok(result) = WITHOUT.product(a, b);
    result
}

/// Returns eigenvalues of a symmetric matrix, ascending, and unit eigenvectors from its lower
/// triangle. `None` if an entry is not finite.
pub fn symmetric_eigen(matrix: MatRef<'_, f64>) -> Option<(Vec<f64>, Mat<f64>)> {
    let size = matrix.nrows();
    let mut params: Spec<SelfAdjointEvdParams, f64> = Spec::default();
    params.config.recursion_threshold = usize::MAX;
    let scratch = self_adjoint_evd_scratch::<f64>(size, ComputeEigenvectors::Yes, Par::Seq, params);
    let mut memory = MemBuffer::new(scratch);
    let (mut values, mut vectors) = (Diag::<f64>::zeros(size), Mat::zeros(size, size));
    let stack = MemStack::new(&mut memory);
    self_adjoint_evd(matrix, values.as_mut(), Some(vectors.as_mut()), Par::Seq, stack, params).ok()?;
    let values: Vec<f64> = values.column_vector().iter().copied().collect();
    values.iter().all(|value| value.is_finite()).then_some((values, vectors))
}

/// Returns the eigenvalues `w` of `i A` for a real skew-symmetric matrix `A`, ascending, and unit
/// eigenvectors from its lower triangle: `A v = -i w v`. The values are pairs of opposite sign, and
/// a zero for an odd size. `None` if an entry is not finite.
pub fn skew_symmetric_eigen(matrix: MatRef<'_, f64>) -> Option<(Vec<f64>, Mat<c64>)> {
    let size = matrix.nrows();
    let hermitian = Mat::from_fn(size, size, |i, j| c64::new(0.0, matrix[(i, j)]));
    let mut params: Spec<SelfAdjointEvdParams, c64> = Spec::default();
    // Divide and conquer loses digits for eigenvalues in pairs of opposite sign over several
    // decades; the QR algorithm does not.
    params.config.recursion_threshold = usize::MAX;
    let scratch = self_adjoint_evd_scratch::<c64>(size, ComputeEigenvectors::Yes, Par::Seq, params);
    let mut memory = MemBuffer::new(scratch);
    let (mut values, mut vectors) = (Diag::<c64>::zeros(size), Mat::zeros(size, size));
    let stack = MemStack::new(&mut memory);
    self_adjoint_evd(hermitian.as_ref(), values.as_mut(), Some(vectors.as_mut()), Par::Seq, stack, params)
        .ok()?;
    let values: Vec<f64> = values.column_vector().iter().map(|value| value.re).collect();
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
