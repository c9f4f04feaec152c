//! Elimination of support and multiplier unknowns from a condensed stiffness.

use crate::error::ElasticError;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Condensed equations of retained unknowns `u` (attachments first, then helpers) and multipliers
/// of forms `q`: `S u = f + P^T multiplier + F`, `q = P u + C multiplier + d`. Helpers carry no
/// external force F.
pub(super) struct Interface {
    /// Number of attachment unknowns among the retained ones.
    pub attached: usize,
    /// Stiffness S of the retained unknowns.
    pub stiffness: Mat<f64>,
    /// Forms P of the retained unknowns.
    pub forms: Mat<f64>,
    /// Forms C of the multipliers.
    pub compliance: Mat<f64>,
    /// Loads f on the retained unknowns, one case per column.
    pub loads: Mat<f64>,
    /// Forms d by the loads.
    pub form_loads: Mat<f64>,
    /// Displacements of the loads by unit loads, with fixed retained unknowns and no multipliers.
    pub between_loads: Mat<f64>,
}

/// Equations of the attachments: retained unknowns, then forms.
pub(super) struct Relaxed {
    pub stiffness: Mat<f64>,
    pub loads: Mat<f64>,
    /// Displacements of the loads by unit loads with fixed attachments.
    pub between_loads: Mat<f64>,
    /// Values of helpers, then multipliers, by unit attachment values, one per column.
    pub response: Mat<f64>,
}

impl Interface {
    /// Eliminates helpers and multipliers.
    pub fn relax(&self) -> Result<Relaxed, ElasticError> {
        let (attached, forms) = (self.attached, self.forms.nrows());
        let helpers = self.stiffness.nrows() - attached;
        let size = helpers + forms;
        let cases = self.loads.ncols();
        let inner = Mat::from_fn(size, size, |row, column| match (row < helpers, column < helpers) {
            (true, true) => self.stiffness[(attached + row, attached + column)],
            (true, false) => -self.forms[(column - helpers, attached + row)],
            (false, true) => -self.forms[(row - helpers, attached + column)],
            (false, false) => -self.compliance[(row - helpers, column - helpers)],
        });
        let right = Mat::from_fn(size, attached + forms + cases, |row, column| {
            if column < attached {
                if row < helpers {
                    -self.stiffness[(attached + row, column)]
                } else {
                    self.forms[(row - helpers, column)]
                }
            } else if column < attached + forms {
                if row == helpers + column - attached { -1.0 } else { 0.0 }
            } else if row < helpers {
                self.loads[(attached + row, column - attached - forms)]
            } else {
                self.form_loads[(row - helpers, column - attached - forms)]
            }
        });
        let response = solve_scaled(&inner, &right)?;
        let force = |row: usize, column: usize| {
            if row >= attached {
                return response[(helpers + row - attached, column)];
            }
            let direct = if column < attached {
                self.stiffness[(row, column)]
            } else if column >= attached + forms {
                -self.loads[(row, column - attached - forms)]
            } else {
                0.0
            };
            let by_helpers =
                (0..helpers).map(|k| self.stiffness[(row, attached + k)] * response[(k, column)]);
            let by_forms = (0..forms).map(|k| -self.forms[(k, row)] * response[(helpers + k, column)]);
            direct + by_helpers.chain(by_forms).sum::<f64>()
        };
        let count = attached + forms;
        let moved = |observer: usize, case: usize| {
            let column = count + case;
            let by_helpers =
                (0..helpers).map(|k| self.loads[(attached + k, observer)] * response[(k, column)]);
            let by_forms =
                (0..forms).map(|k| self.form_loads[(k, observer)] * response[(helpers + k, column)]);
            self.between_loads[(observer, case)] + by_helpers.chain(by_forms).sum::<f64>()
        };
        Ok(Relaxed {
            stiffness: Mat::from_fn(count, count, |row, column| {
                0.5 * (force(row, column) + force(column, row))
            }),
            loads: Mat::from_fn(count, cases, |row, case| -force(row, count + case)),
            between_loads: Mat::from_fn(cases, cases, |row, column| {
                0.5 * (moved(row, column) + moved(column, row))
            }),
            response: response.subcols(0, count).to_owned(),
        })
    }
}

/// Solves symmetric indefinite equations whose unknowns have different units.
fn solve_scaled(matrix: &Mat<f64>, right: &Mat<f64>) -> Result<Mat<f64>, ElasticError> {
    let size = matrix.nrows();
    if size == 0 {
        return Ok(Mat::zeros(0, right.ncols()));
    }
    let scale: Vec<f64> = (0..size)
        .map(|k| if matrix[(k, k)] == 0.0 { 1.0 } else { matrix[(k, k)].abs().sqrt().recip() })
        .collect();
    let scaled = Mat::from_fn(size, size, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
    let load = Mat::from_fn(size, right.ncols(), |i, j| right[(i, j)] * scale[i]);
    let factor = scaled.partial_piv_lu();
    let mut solution = factor.solve(&load);
    // One step of iterative refinement.
    let residual = &load - &scaled * &solution;
    solution += factor.solve(&residual);
    let solution = Mat::from_fn(size, right.ncols(), |i, j| solution[(i, j)] * scale[i]);
    let finite = (0..solution.ncols()).all(|j| (0..size).all(|i| solution[(i, j)].is_finite()));
    if finite {
        Ok(solution)
    } else {
        Err(ElasticError::model(
            "the attachments do not determine the motion of the body, or depend on each other",
            "attach each averaged surface once, and support the body by its attachments",
        ))
    }
}
