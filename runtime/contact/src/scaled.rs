//! Contact problem in variables of order one.

use super::problem::ContactProblem;
use nalgebra::DMatrix;

/// Contact problem in the variables `p = cell_scale * q`, `x = dof_scale * y`. The compliance
/// matrix is large, so it is not copied but scaled entry by entry.
pub(super) struct Scaled<'a> {
    compliance: &'a [f64],
    pub arms: DMatrix<f64>,
    pub gaps: Vec<f64>,
    pub stiffness: DMatrix<f64>,
    pub load: Vec<f64>,
    pub cell_scale: Vec<f64>,
    pub dof_scale: Vec<f64>,
}

/// Returns the power of two nearest to `value` in the logarithm.
fn power_of_two(value: f64) -> f64 {
    value.log2().round().exp2()
}

impl<'a> Scaled<'a> {
    pub fn new(problem: &'a ContactProblem) -> Self {
        let (n, m) = (problem.cells(), problem.dofs());
        let cell_scale: Vec<f64> =
            (0..n).map(|i| power_of_two(problem.compliance[i * n + i].sqrt().recip())).collect();
        let mut column: Vec<f64> = vec![0.0; m];
        for i in 0..n {
            for k in 0..m {
                column[k] = column[k].max((cell_scale[i] * problem.arms[i * m + k]).abs());
            }
        }
        // An entry that is rounding relative to the entries of the other DOFs counts as zero.
        let largest = column.iter().copied().fold(0.0, f64::max);
        let seen: Vec<bool> = column.iter().map(|&c| c > 1e-13 * largest).collect();
        let dof_scale: Vec<f64> = (0..m)
            .map(|k| {
                let spring = problem.stiffness[k * m + k].max(0.0).sqrt();
                let size = if seen[k] { column[k] } else { spring };
                if size > 0.0 { power_of_two(size.recip()) } else { 1.0 }
            })
            .collect();
        let mut arms = DMatrix::zeros(n, m);
        for i in 0..n {
            for k in (0..m).filter(|&k| seen[k]) {
                arms[(i, k)] = cell_scale[i] * problem.arms[i * m + k] * dof_scale[k];
            }
        }
        let mut stiffness = DMatrix::zeros(m, m);
        for k in 0..m {
            for l in 0..m {
                stiffness[(k, l)] = dof_scale[k] * problem.stiffness[k * m + l] * dof_scale[l];
            }
        }
        Self {
            compliance: &problem.compliance,
            arms,
            gaps: problem.gaps.iter().zip(&cell_scale).map(|(e, s)| e * s).collect(),
            stiffness,
            load: problem.load.iter().zip(&dof_scale).map(|(f, s)| f * s).collect(),
            cell_scale,
            dof_scale,
        }
    }

    /// Returns the number of cells.
    pub fn cells(&self) -> usize {
        self.gaps.len()
    }

    /// Returns the influence coefficient of the force on cell `j` for the gap of cell `i`, in
    /// scaled variables.
    pub fn compliance(&self, i: usize, j: usize) -> f64 {
        self.cell_scale[i] * self.compliance[i * self.cells() + j] * self.cell_scale[j]
    }
    /// Returns the influence coefficients of all cells for the gap of cell `i`, not scaled.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.compliance[i * self.cells()..][..self.cells()]
    }
}
