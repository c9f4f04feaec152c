//! Component modes of a body with dense matrices: given ones, and those of shafts.

use calyx_numerics::dense::symmetric_eigen;
use faer::Mat;
use nalgebra::{Cholesky, DMatrix, Dyn, SymmetricEigen};
use std::f64::consts::TAU;

/// Compliance of a mode relative to that of the most compliant one below which it has no mass.
const MASSLESS: f64 = 1e-14;
/// Squared norm of a pseudo-mode in scaled combinations below which it depends on others.
const DEPENDENT: f64 = 1e-8;

/// Component modes of a body whose attachments are fixed. The modal masses are 1.
pub(crate) struct InteriorModes {
    /// Squared natural frequencies, (rad/s)²; those of pseudo-modes are the last ones.
    pub eigenvalues: Vec<f64>,
    /// Mass between the attachment components (rows) and the modes.
    pub coupling: DMatrix<f64>,
    /// Motions of the interior components (rows) in the modes.
    pub shapes: DMatrix<f64>,
}

impl InteriorModes {
    /// Returns the modes of the interior with fixed attachments up to a frequency (Hz), and as many
    /// pseudo-modes as the attachments require: the response of the omitted modes to the inertia of
    /// the static shapes (Dickens, Nakagawa and Wittbrodt 1997). The matrices are the factor of the
    /// interior stiffness, the interior mass, and the inertia of the static shapes (interior by
    /// attachment components). `None` if an eigenproblem fails.
    pub fn find(
        factor: &Cholesky<f64, Dyn>,
        mass: &DMatrix<f64>,
        inertia: &DMatrix<f64>,
        highest: f64,
    ) -> Option<InteriorModes> {
        if mass.nrows() == 0 {
            let none = DMatrix::zeros(inertia.ncols(), 0);
            return Some(InteriorModes {
                eigenvalues: Vec::new(),
                coupling: none,
                shapes: DMatrix::zeros(0, 0),
            });
        }
        let lower = factor.l();
        let half = lower.solve_lower_triangular(mass)?;
        let scaled = lower.solve_lower_triangular(&half.transpose())?;
        // Eigenvalues are 1 / omega², so that components without mass are zero.
        let size = scaled.nrows();
        let symmetric = Mat::from_fn(size, size, |i, j| 0.5 * (scaled[(i, j)] + scaled[(j, i)]));
        let (values, vectors) = symmetric_eigen(symmetric.as_ref())?;
        let largest = values.iter().copied().fold(0.0, f64::max);
        let order: Vec<usize> = (0..size).rev().filter(|&k| values[k] > MASSLESS * largest).collect();
        let squares: Vec<f64> = order.iter().map(|&k| values[k].recip()).collect();
        let normalized =
            DMatrix::from_fn(size, order.len(), |row, k| squares[k].sqrt() * vectors[(row, order[k])]);
        let shapes = lower.transpose().solve_upper_triangular(&normalized)?;
        let participation = shapes.transpose() * inertia;
        let kept = squares.iter().take_while(|square| **square <= (TAU * highest).powi(2)).count();
        let omitted = order.len() - kept;
        let (pseudo, combination) =
            pseudo_modes(&squares[kept..], &participation.rows(kept, omitted).into_owned());
        // Combinations of all modes: the kept ones, then the pseudo-modes.
        let count = kept + pseudo.len();
        let all = DMatrix::from_fn(order.len(), count, |row, column| {
            match (row.checked_sub(kept), column.checked_sub(kept)) {
                (None, None) => f64::from(row == column),
                (Some(row), Some(column)) => combination[(row, column)],
                _ => 0.0,
            }
        });
        Some(InteriorModes {
            eigenvalues: squares[..kept].iter().copied().chain(pseudo).collect(),
            coupling: participation.transpose() * &all,
            shapes: shapes * all,
        })
    }
}

/// Returns squared frequencies of the pseudo-modes, and their combinations of the omitted modes by
/// column.
fn pseudo_modes(squares: &[f64], participation: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    let none = || (Vec::new(), DMatrix::zeros(squares.len(), 0));
    if squares.is_empty() || participation.ncols() == 0 {
        return none();
    }
    let response =
        DMatrix::from_fn(squares.len(), participation.ncols(), |k, j| participation[(k, j)] / squares[k]);
    let norms: Vec<f64> = response.column_iter().map(|column| column.norm()).collect();
    let scaled = DMatrix::from_fn(squares.len(), norms.len(), |k, j| match norms[j] {
        0.0 => 0.0,
        norm => response[(k, j)] / norm,
    });
    let found = SymmetricEigen::new(scaled.transpose() * &scaled);
    let independent: Vec<usize> = (0..norms.len()).filter(|&k| found.eigenvalues[k] > DEPENDENT).collect();
    if independent.is_empty() {
        return none();
    }
    let combination = DMatrix::from_fn(norms.len(), independent.len(), |j, k| {
        found.eigenvectors[(j, independent[k])] / found.eigenvalues[independent[k]].sqrt()
    });
    let basis = scaled * combination;
    let weighted = DMatrix::from_fn(squares.len(), basis.ncols(), |k, j| squares[k] * basis[(k, j)]);
    let stiffness = SymmetricEigen::new(basis.transpose() * weighted);
    (stiffness.eigenvalues.iter().copied().collect(), basis * &stiffness.eigenvectors)
}
