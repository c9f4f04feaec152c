//! Effective matrix of a time step, and the solution of a step with the contact forces of the
//! previous one.
//!
//! Coriolis, Euler and centrifugal terms make the matrix of a step unsymmetric, but the contact
//! problem is a minimum problem. With the contact forces of the previous step, the complete
//! equations of a step are linear and are solved directly. The unsymmetric terms of this solution
//! are then treated as loads, and contact is solved. So motions without contact follow the scheme
//! itself, which conserves the energy of a rotating body, and the contact forces change so little
//! within a step that the order of the scheme is preserved. (With rates extrapolated from the start
//! of a step, free vibrations of a rotating ring grow by fractions of the order of its rotation per
//! step.)
//!
//! See `docs/theory/dynamics.md`.

use calyx_numerics::dense::{cholesky, solve_lower, solve_upper};
use faer::Mat;

/// Maximum number of corrections of the unsymmetric terms; each reduces the error by a factor of
/// about the rotation of frames in a step.
const MOST: usize = 40;

/// Effective matrix S of Newmark's family for the unknown `y`: DOFs, then modal coordinates.
pub struct EffectiveMatrix<'a> {
    /// Block of the DOFs, row-major.
    pub matrix: &'a [f64],
    /// Block of DOFs by modal coordinates, row-major.
    pub coupling: &'a [f64],
    /// Diagonal of the modal coordinates.
    pub stiffness: &'a [f64],
}

impl EffectiveMatrix<'_> {
    /// Computes `S y`.
    pub fn times(&self, y: &[f64]) -> Vec<f64> {
        let (count, m) = (self.stiffness.len(), y.len() - self.stiffness.len());
        let (x, q) = y.split_at(m);
        let product = |row: &[f64], by: &[f64]| row.iter().zip(by).map(|(a, b)| a * b).sum::<f64>();
        let dofs = (0..m).map(|i| {
            product(&self.matrix[i * m..(i + 1) * m], x)
                + product(&self.coupling[i * count..(i + 1) * count], q)
        });
        let modal = (0..count).map(|k| {
            let carried: f64 = (0..m).map(|i| self.coupling[i * count + k] * x[i]).sum();
            self.stiffness[k] * q[k] + carried
        });
        dofs.chain(modal).collect()
    }

    /// Returns the Cholesky factor of the Schur complement of the DOFs after elimination of the
    /// modal coordinates.
    fn factor(&self, m: usize) -> Option<Mat<f64>> {
        let count = self.stiffness.len();
        cholesky(Mat::from_fn(m, m, |i, j| {
            let through =
                |k: usize| self.coupling[i * count + k] * self.coupling[j * count + k] / self.stiffness[k];
            self.matrix[i * m + j] - (0..count).map(through).sum::<f64>()
        }))
    }

    /// Computes `S^-1 right`.
    fn solve(&self, factor: &Mat<f64>, right: &[f64]) -> Vec<f64> {
        let (count, m) = (self.stiffness.len(), factor.nrows());
        let (f, g) = right.split_at(m);
        let left = Mat::from_fn(m, 1, |i, _| {
            let through = |k: usize| self.coupling[i * count + k] * g[k] / self.stiffness[k];
            f[i] - (0..count).map(through).sum::<f64>()
        });
        let x = solve_upper(factor.as_ref(), solve_lower(factor.as_ref(), left));
        let modal = (0..count).map(|k| {
            let carried: f64 = (0..m).map(|i| self.coupling[i * count + k] * x[(i, 0)]).sum();
            (g[k] - carried) / self.stiffness[k]
        });
        (0..m).map(|i| x[(i, 0)]).chain(modal).collect()
    }

    /// Solves `S y = load + following(y)`, with `following` linear and small relative to S; if it
    /// is not small, iterates while the error decreases. `None` if S is not positive definite.
    pub fn free(&self, load: &[f64], following: impl Fn(&[f64]) -> Vec<f64>) -> Option<Vec<f64>> {
        let factor = self.factor(load.len() - self.stiffness.len())?;
        let energy = |y: &[f64]| self.times(y).iter().zip(y).map(|(f, y)| f * y).sum::<f64>();
        let mut y = self.solve(&factor, load);
        let (mut last, floor) = (f64::INFINITY, f64::EPSILON * f64::EPSILON * energy(&y));
        for _ in 0..MOST {
            let right: Vec<f64> = load.iter().zip(following(&y)).map(|(load, more)| load + more).collect();
            let next = self.solve(&factor, &right);
            let change: Vec<f64> = next.iter().zip(&y).map(|(next, y)| next - y).collect();
            let moved = energy(&change);
            // The change no longer shrinks: it is rounding, or frames rotate by radians per step
            // and nothing is resolved anyway.
            if moved.is_nan() || moved >= 0.25 * last {
                break;
            }
            (y, last) = (next, moved);
            if moved <= floor {
                break;
            }
        }
        Some(y)
    }
}
