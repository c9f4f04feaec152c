//! Complex columns over degrees of freedom, and small dense Hermitian matrices.
//!
//! Columns are stored as real ones, all real parts before all imaginary parts. Matrices of the mesh
//! are real, so their product with complex columns is that with twice as many real ones. Operations
//! on small matrices are sequential, so that results do not depend on threads bit for bit.

use calyx_numerics::dense::{add_product, product};
use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::evd::{
    ComputeEigenvectors, SelfAdjointEvdParams, self_adjoint_evd, self_adjoint_evd_scratch,
};
use faer::linalg::matmul::matmul;
use faer::sparse::SparseColMat;
use faer::{Accum, Mat, MatRef, Par, Spec, c64};
use std::array;

/// Complex columns.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    /// Real parts of all columns, then imaginary parts.
    pub parts: Mat<f64>,
}

impl Columns {
    pub fn zeros(rows: usize, count: usize) -> Self {
        Self { parts: Mat::zeros(rows, 2 * count) }
    }

    /// Builds columns from a function of row and column.
    pub fn from_fn(rows: usize, count: usize, entry: impl Fn(usize, usize) -> c64) -> Self {
        let part = |row, place: usize| {
            if place < count { entry(row, place).re } else { entry(row, place - count).im }
        };
        Self { parts: Mat::from_fn(rows, 2 * count, part) }
    }

    pub fn rows(&self) -> usize {
        self.parts.nrows()
    }

    pub fn count(&self) -> usize {
        self.parts.ncols() / 2
    }

    pub fn at(&self, row: usize, column: usize) -> c64 {
        c64::new(self.parts[(row, column)], self.parts[(row, self.count() + column)])
    }

    pub fn set(&mut self, row: usize, column: usize, value: c64) {
        let count = self.count();
        self.parts[(row, column)] = value.re;
        self.parts[(row, count + column)] = value.im;
    }

    /// Returns the real and the imaginary part of a column.
    pub fn column(&self, column: usize) -> [Vec<f64>; 2] {
        [column, self.count() + column].map(|place| self.parts.col(place).iter().copied().collect())
    }

    /// Computes `self += scale * other * by`.
    pub fn add_times(&mut self, scale: f64, other: &Columns, by: MatRef<'_, c64>) {
        let (p, q) = (by.nrows(), by.ncols());
        // (a + i b) (c + i d) as [a b] [c d; -d c].
        let real = Mat::from_fn(2 * p, 2 * q, |row, column| {
            let value = by[(row % p, column % q)];
            match (row < p, column < q) {
                (true, true) | (false, false) => value.re,
                (true, false) => value.im,
                (false, true) => -value.im,
            }
        });
        add_product(self.parts.as_mut(), scale, other.parts.as_ref(), real.as_ref());
    }

    /// Computes `self * by`.
    pub fn times(&self, by: MatRef<'_, c64>) -> Columns {
        let mut result = Columns::zeros(self.rows(), by.ncols());
        result.add_times(1.0, self, by);
        result
    }

    /// Computes `self^H other`.
    pub fn adjoint_times(&self, other: &Columns) -> Mat<c64> {
        let (p, q) = (self.count(), other.count());
        let real = product(self.parts.transpose(), other.parts.as_ref());
        Mat::from_fn(p, q, |row, column| {
            c64::new(
                real[(row, column)] + real[(p + row, q + column)],
                real[(row, q + column)] - real[(p + row, column)],
            )
        })
    }

    /// Multiplies a real symmetric matrix of the mesh by these columns.
    pub fn under(&self, matrix: &SparseColMat<usize, f64>) -> Columns {
        Columns { parts: under(matrix, self.parts.as_ref()) }
    }
}

/// Columns that are multiplied simultaneously.
const LANES: usize = 8;

/// Multiplies a real symmetric matrix of the mesh by columns.
pub(super) fn under(matrix: &SparseColMat<usize, f64>, columns: MatRef<'_, f64>) -> Mat<f64> {
    let mut result = Mat::zeros(matrix.ncols(), columns.ncols());
    let mut lanes = vec![[0.0; LANES]; columns.nrows()];
    for first in (0..columns.ncols()).step_by(LANES) {
        let width = LANES.min(columns.ncols() - first);
        for (row, lanes) in lanes.iter_mut().enumerate() {
            *lanes = array::from_fn(|lane| if lane < width { columns[(row, first + lane)] } else { 0.0 });
        }
        for column in 0..matrix.ncols() {
            // The matrix is symmetric: a column is a row.
            let mut sum = [0.0; LANES];
            for (row, value) in matrix.row_idx_of_col(column).zip(matrix.val_of_col(column)) {
                for (sum, part) in sum.iter_mut().zip(&lanes[row]) {
                    *sum += value * part;
                }
            }
            for (lane, sum) in sum.into_iter().enumerate().take(width) {
                result[(column, first + lane)] = sum;
            }
        }
    }
    result
}

/// Computes `a b` for small matrices.
pub(super) fn times(a: MatRef<'_, c64>, b: MatRef<'_, c64>) -> Mat<c64> {
    let mut result = Mat::zeros(a.nrows(), b.ncols());
    matmul(result.as_mut(), Accum::Replace, a, b, c64::new(1.0, 0.0), Par::Seq);
    result
}

/// Returns `a^H`.
pub(super) fn adjoint(a: MatRef<'_, c64>) -> Mat<c64> {
    Mat::from_fn(a.ncols(), a.nrows(), |row, column| a[(column, row)].conj())
}

/// Eigendecomposition of a Hermitian matrix: ascending eigenvalues and unit eigenvectors.
#[derive(Clone, Debug)]
pub(super) struct Spectrum {
    pub values: Vec<f64>,
    pub vectors: Mat<c64>,
}

impl Spectrum {
    /// Decomposes a matrix that is Hermitian up to rounding. `None` if an entry is not finite.
    pub fn of(matrix: &Mat<c64>) -> Option<Self> {
        let size = matrix.nrows();
        if size == 0 {
            return Some(Self { values: Vec::new(), vectors: Mat::zeros(0, 0) });
        }
        let even = Mat::from_fn(size, size, |row, column| {
            (matrix[(row, column)] + matrix[(column, row)].conj()) * 0.5
        });
        let params: Spec<SelfAdjointEvdParams, c64> = Spec::default();
        let scratch = self_adjoint_evd_scratch::<c64>(size, ComputeEigenvectors::Yes, Par::Seq, params);
        let mut memory = MemBuffer::new(scratch);
        let (mut values, mut vectors) = (Diag::<c64>::zeros(size), Mat::zeros(size, size));
        let stack = MemStack::new(&mut memory);
        self_adjoint_evd(even.as_ref(), values.as_mut(), Some(vectors.as_mut()), Par::Seq, stack, params)
            .ok()?;
        let values: Vec<f64> = values.column_vector().iter().map(|value| value.re).collect();
        values.iter().all(|value| value.is_finite()).then_some(Self { values, vectors })
    }

    /// Returns the number of negative eigenvalues.
    pub fn negative(&self) -> usize {
        self.values.iter().filter(|&&value| value < 0.0).count()
    }

    /// Returns the inverse times a matrix.
    pub fn solve(&self, right: MatRef<'_, c64>) -> Mat<c64> {
        self.apply(right, |value| value.recip())
    }

    /// Returns a function of the matrix times a matrix.
    pub fn apply(&self, right: MatRef<'_, c64>, function: impl Fn(f64) -> f64) -> Mat<c64> {
        let mut amounts = times(adjoint(self.vectors.as_ref()).as_ref(), right);
        for (row, &value) in self.values.iter().enumerate() {
            let factor = function(value);
            for column in 0..amounts.ncols() {
                amounts[(row, column)] *= factor;
            }
        }
        times(self.vectors.as_ref(), amounts.as_ref())
    }
}
