//! The matrix of a step, and where a step would end if contact did what it did before.
//!
//! Terms of Coriolis, of Euler and of centrifugal force make the matrix of a step unsymmetric, and the contact problem is one of least energy. With
//! contact's forces of the step before, the whole equations of a step are linear and solved as they are; of that end the unsymmetric terms are taken
//! as loads, and contact is solved. So what contact does not touch moves by the scheme itself, which keeps the energy of a turning body, and
//! contact changes within a step by so little that the order stays. (By rates extrapolated from the beginning of a step, free vibrations of a
//! turning ring grow by parts of the order of its turn within a step.)

use calyx_numerics::dense::{cholesky, half_solve, other_half_solve};
use faer::Mat;

/// Times that unsymmetric terms are put right; each leaves of the error about the turn of frames within a step.
const MOST: usize = 40;

/// Of Newmark's family, by `y`: freedoms, then modal coordinates.
pub struct Effective<'a> {
    /// Between freedoms, row-major.
    pub matrix: &'a [f64],
    /// Freedoms by modal coordinates, row-major.
    pub coupling: &'a [f64],
    /// Of modal coordinates.
    pub stiffness: &'a [f64],
}

impl Effective<'_> {
    /// `S y`.
    pub fn times(&self, y: &[f64]) -> Vec<f64> {
        let (count, m) = (self.stiffness.len(), y.len() - self.stiffness.len());
        let (x, q) = y.split_at(m);
        let product = |row: &[f64], by: &[f64]| row.iter().zip(by).map(|(a, b)| a * b).sum::<f64>();
        let freedoms = (0..m).map(|i| {
            product(&self.matrix[i * m..(i + 1) * m], x)
                + product(&self.coupling[i * count..(i + 1) * count], q)
        });
        let modal = (0..count).map(|k| {
            let carried: f64 = (0..m).map(|i| self.coupling[i * count + k] * x[i]).sum();
            self.stiffness[k] * q[k] + carried
        });
        freedoms.chain(modal).collect()
    }

    /// Of the freedoms, modal coordinates eliminated: its factor by Cholesky.
    fn factor(&self, m: usize) -> Option<Mat<f64>> {
        let count = self.stiffness.len();
        cholesky(Mat::from_fn(m, m, |i, j| {
            let through =
                |k: usize| self.coupling[i * count + k] * self.coupling[j * count + k] / self.stiffness[k];
            self.matrix[i * m + j] - (0..count).map(through).sum::<f64>()
        }))
    }

    /// `S^-1 right`.
    fn solve(&self, factor: &Mat<f64>, right: &[f64]) -> Vec<f64> {
        let (count, m) = (self.stiffness.len(), factor.nrows());
        let (f, g) = right.split_at(m);
        let left = Mat::from_fn(m, 1, |i, _| {
            let through = |k: usize| self.coupling[i * count + k] * g[k] / self.stiffness[k];
            f[i] - (0..count).map(through).sum::<f64>()
        });
        let x = other_half_solve(factor.as_ref(), half_solve(factor.as_ref(), left));
        let modal = (0..count).map(|k| {
            let carried: f64 = (0..m).map(|i| self.coupling[i * count + k] * x[(i, 0)]).sum();
            (g[k] - carried) / self.stiffness[k]
        });
        (0..m).map(|i| x[(i, 0)]).chain(modal).collect()
    }

    /// `y` of `S y = load + following(y)`, with `following` linear and small beside S; where it is not, how far it is worth going. `None` where
    /// S is not positive definite.
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
            // What does not shrink is rounding, or frames turn by radians in a step and nothing is resolved anyhow.
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
