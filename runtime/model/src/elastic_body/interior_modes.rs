//! Component modes of a body that is given by dense matrices.

use nalgebra::{Cholesky, DMatrix, Dyn, SymmetricEigen};
use std::f64::consts::TAU;

/// Compliance of a mode relative to that of the most compliant one below which it has no mass.
const MASSLESS: f64 = 1e-14;
/// Squared norm of a pseudo-mode in scaled combinations below which it depends on others.
const DEPENDENT: f64 = 1e-8;

/// Returns the modes of the interior with fixed attachments up to a frequency (Hz), and as many
/// pseudo-modes as the attachments require: the response of the omitted modes to the inertia of the
/// static shapes (Dickens, Nakagawa and Wittbrodt 1997). The matrices are the factor of the interior
/// stiffness, the interior mass, and the inertia of the static shapes (interior by attachment
/// components). The coupling has the attachment components as rows.
pub(super) fn interior_modes(
    factor: &Cholesky<f64, Dyn>,
    mass: &DMatrix<f64>,
    inertia: &DMatrix<f64>,
    highest: f64,
) -> (Vec<f64>, DMatrix<f64>) {
    let none = || (Vec::new(), DMatrix::zeros(inertia.ncols(), 0));
    let lower = factor.l();
    let Some(half) = lower.solve_lower_triangular(mass) else { return none() };
    let Some(scaled) = lower.solve_lower_triangular(&half.transpose()) else { return none() };
    // Eigenvalues are 1 / omega², so that components without mass are zero.
    let found = SymmetricEigen::new(0.5 * (&scaled + scaled.transpose()));
    let largest = found.eigenvalues.max();
    let mut order: Vec<usize> =
        (0..found.eigenvalues.len()).filter(|&k| found.eigenvalues[k] > MASSLESS * largest).collect();
    order.sort_by(|&a, &b| found.eigenvalues[b].total_cmp(&found.eigenvalues[a]));
    let squares: Vec<f64> = order.iter().map(|&k| found.eigenvalues[k].recip()).collect();
    let Some(shapes) = lower.transpose().solve_upper_triangular(&found.eigenvectors) else { return none() };
    let participation = shapes.transpose() * inertia;
    let participation = DMatrix::from_fn(order.len(), inertia.ncols(), |mode, component| {
        squares[mode].sqrt() * participation[(order[mode], component)]
    });
    let kept = squares.iter().take_while(|square| **square <= (TAU * highest).powi(2)).count();
    let (pseudo, by_pseudo) =
        pseudo_modes(&squares[kept..], &participation.rows(kept, order.len() - kept).into_owned());
    let mut coupling = participation.rows(0, kept).transpose();
    coupling = coupling.resize_horizontally(kept + pseudo.len(), 0.0);
    coupling.columns_mut(kept, pseudo.len()).copy_from(&by_pseudo.transpose());
    (squares[..kept].iter().copied().chain(pseudo).collect(), coupling)
}

/// Returns squared frequencies and participations (by row) of the pseudo-modes of omitted modes.
fn pseudo_modes(squares: &[f64], participation: &DMatrix<f64>) -> (Vec<f64>, DMatrix<f64>) {
    let response =
        DMatrix::from_fn(squares.len(), participation.ncols(), |k, j| participation[(k, j)] / squares[k]);
    let norms: Vec<f64> = response.column_iter().map(|column| column.norm()).collect();
    let scaled = DMatrix::from_fn(squares.len(), norms.len(), |k, j| match norms[j] {
        0.0 => 0.0,
        norm => response[(k, j)] / norm,
    });
    let found = SymmetricEigen::new(scaled.transpose() * &scaled);
    let independent: Vec<usize> = (0..norms.len()).filter(|&k| found.eigenvalues[k] > DEPENDENT).collect();
    let combination = DMatrix::from_fn(norms.len(), independent.len(), |j, k| {
        found.eigenvectors[(j, independent[k])] / found.eigenvalues[independent[k]].sqrt()
    });
    let basis = scaled * combination;
    let weighted = DMatrix::from_fn(squares.len(), basis.ncols(), |k, j| squares[k] * basis[(k, j)]);
    let stiffness = SymmetricEigen::new(basis.transpose() * weighted);
    let participation = (basis * &stiffness.eigenvectors).transpose() * participation;
    (stiffness.eigenvalues.iter().copied().collect(), participation)
}
