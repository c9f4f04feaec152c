//! Modes of the mean stiffness, in which a forced vibration is expressed.

use calyx_numerics::dense::symmetric_eigen;
use faer::Mat;
use nalgebra::{DMatrix, DVector};

/// A mode has inertia if its frequency is at most this multiple of the highest harmonic's.
pub(super) const DYNAMIC: f64 = 6.0;
/// The same if all coordinates are requested: the power balance of a part of the system omits the
/// inertia of the other modes.
pub(super) const DYNAMIC_COORDINATES: f64 = 15.0;

/// Modes of the mean stiffness, those with inertia first.
pub(super) struct Basis {
    /// Frequencies, rad/s, ascending.
    pub frequencies: Vec<f64>,
    /// Mass-normalized shapes by column.
    pub shapes: DMatrix<f64>,
    /// Number of modes with inertia.
    pub dynamic: usize,
}

impl Basis {
    /// Determines the modes of the mean of all samples of a stiffness for vibrations up to a
    /// frequency, rad/s; those up to a multiple of it have inertia. `None` if the mass is not
    /// positive definite or an entry is not finite.
    pub fn of(mass: &DMatrix<f64>, stiffness: &[DMatrix<f64>], highest: f64, multiple: f64) -> Option<Basis> {
        let mean = stiffness.iter().sum::<DMatrix<f64>>() / stiffness.len().max(1) as f64;
        let (frequencies, shapes) = modes(mass, &mean)?;
        let dynamic = frequencies.partition_point(|frequency| *frequency <= multiple * highest);
        Some(Basis { frequencies, shapes, dynamic })
    }

    /// Returns the shapes of the modes with inertia.
    pub fn with_inertia(&self) -> DMatrix<f64> {
        self.shapes.columns(0, self.dynamic).clone_owned()
    }

    /// Returns the shapes of the modes without inertia.
    pub fn without_inertia(&self) -> DMatrix<f64> {
        self.shapes.columns(self.dynamic, self.shapes.ncols() - self.dynamic).clone_owned()
    }

    /// Returns the stiffness of the modes with inertia at a sample, and the deflection of the
    /// others for each of them. `None` if the others have no stiffness.
    pub fn condensed(&self, stiffness: &DMatrix<f64>) -> Option<(DMatrix<f64>, DMatrix<f64>)> {
        let modal = self.shapes.transpose() * stiffness * &self.shapes;
        let (dynamic, others) = (self.dynamic, modal.nrows() - self.dynamic);
        let own = modal.view((0, 0), (dynamic, dynamic)).clone_owned();
        if others == 0 {
            return Some((own, DMatrix::zeros(0, dynamic)));
        }
        let between = modal.view((dynamic, 0), (others, dynamic)).clone_owned();
        let factor = modal.view((dynamic, dynamic), (others, others)).clone_owned().cholesky()?;
        let followed = -factor.solve(&between);
        Some((own + between.tr_mul(&followed), followed))
    }
}

/// Returns the frequencies (rad/s, ascending) and mass-normalized mode shapes of a stiffness.
/// `None` if the mass is not positive definite or an entry is not finite.
pub(super) fn modes(mass: &DMatrix<f64>, stiffness: &DMatrix<f64>) -> Option<(Vec<f64>, DMatrix<f64>)> {
    let size = mass.nrows();
    // Unit inertia of each coordinate makes metres and radians comparable.
    let scale = DVector::from_fn(size, |k, _| mass[(k, k)].sqrt().recip());
    if !scale.iter().all(|scale| scale.is_finite()) {
        return None;
    }
    let scaled =
        |matrix: &DMatrix<f64>| DMatrix::from_fn(size, size, |i, j| scale[i] * matrix[(i, j)] * scale[j]);
    let lower = scaled(mass).cholesky()?.l();
    let half = lower.solve_lower_triangular(&scaled(stiffness))?;
    let whole = lower.solve_lower_triangular(&half.transpose())?;
    let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
    let (squares, vectors) = symmetric_eigen(symmetric.as_ref())?;
    let vectors = DMatrix::from_fn(size, size, |i, j| vectors[(i, j)]);
    let shapes = lower.tr_solve_lower_triangular(&vectors)?;
    let shapes = DMatrix::from_fn(size, size, |i, j| scale[i] * shapes[(i, j)]);
    Some((squares.iter().map(|square| square.max(0.0).sqrt()).collect(), shapes))
}

/// Returns the square root of a symmetric matrix, without its negative part; `None` if an entry is
/// not finite.
pub(super) fn square_root(matrix: &DMatrix<f64>) -> Option<DMatrix<f64>> {
    let size = matrix.nrows();
    let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)]));
    let (values, vectors) = symmetric_eigen(symmetric.as_ref())?;
    let vectors = DMatrix::from_fn(size, size, |i, j| vectors[(i, j)]);
    let roots = DVector::from_fn(size, |k, _| values[k].max(0.0).sqrt());
    Some(&vectors * DMatrix::from_diagonal(&roots) * vectors.transpose())
}
