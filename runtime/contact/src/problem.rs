//! The contact problem (report eq. 2.40): its data, what a solution is, and the certificate of one.
//!
//! Find cell forces `p >= 0` and rigid motions `x` with gaps `d = A p + C x + e >= 0`, `p'd = 0` and equilibrium
//! `C'p - K x = -f`. The report's eq. 2.37 to 2.39 need transposes; with the signs here B is C', because contact forces
//! do positive work where gaps grow. These are the optimality conditions of the convex program
//! `min p'Ap/2 + e'p + x'Kx/2` under the equilibrium, with x as its multipliers.

use calyx_numerics::error::EngineError;
use serde::{Deserialize, Serialize};

/// Data of a contact problem of n cells and m freedoms; matrices row-major.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactProblem {
    /// A, n by n, symmetric positive definite: growth of a cell's gap per force on a cell, m/(N/m).
    pub compliance: Vec<f64>,
    /// C, n by m: growth of a cell's gap per unit of a rigid freedom (m, or m/rad).
    pub arms: Vec<f64>,
    /// e, n: gaps with no force and no motion, m; negative where bodies overlap.
    pub gaps: Vec<f64>,
    /// K, m by m, symmetric positive semi-definite: springs on the freedoms. All zero without springs.
    pub stiffness: Vec<f64>,
    /// f, m: external generalised force on each freedom, positive in the freedom's positive sense.
    pub load: Vec<f64>,
}

/// A motion of the freedoms that nothing resists.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// The freedom that takes most part in it, compared by the growth of gaps it causes.
    pub freedom: usize,
    /// +1 or -1: the sense of that freedom.
    pub direction: f64,
    /// All freedoms in their own units, the named one ±1.
    pub motion: Vec<f64>,
}

/// Why a contact problem has no solution, or none was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// The load runs away along this motion, on which no contact closes.
    #[error("no contact can balance the load: it moves degree of freedom {} in the {} direction", .0.freedom, sense(.0.direction))]
    Infeasible(FreeMotion),
    /// The load does no work on this motion, but neither contact nor spring fixes it.
    #[error("degree of freedom {} is constrained neither by contact nor by a spring", .0.freedom)]
    Unconstrained(FreeMotion),
    /// Gaps of cells are not independent: the compliance loses rank at this cell (two cells in one place,
    /// or rigid bodies).
    #[error("the compliance of cell {cell} is not independent of the cells before it")]
    DependentCells {
        /// Index of the cell.
        cell: usize,
    },
    /// Contact cannot be avoided by any motion, so there is no limit of vanishing load.
    #[error("the bodies overlap in every position")]
    Jammed,
    /// A number is not finite, or the arrays do not fit each other.
    #[error("contact problem: {0}")]
    Invalid(&'static str),
    /// Neither pivoting nor the check found the solution.
    #[error("the contact solver did not converge")]
    NotConverged,
    /// Whoever asked for the solution ended the search.
    #[error(transparent)]
    Interrupted(EngineError),
}

fn sense(direction: f64) -> &'static str {
    if direction > 0.0 { "positive" } else { "negative" }
}

/// What led to a solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Blocks of cells exchanged at once.
    BlockPivoting,
    /// One exchange at a time, which cannot cycle as blocks of them can.
    SinglePivoting,
    /// Interior point, when pivoting ran into its limit.
    Clarabel,
}

/// Largest relative violations of a solution, from the problem's own unscaled data. Of the order of rounding if exact.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Largest `p_i |d_i|` over the largest force and the gap scale.
    pub complementarity: f64,
    /// Largest overlap over the gap scale: the largest sum of magnitudes in a loaded cell's gap equation.
    pub penetration: f64,
    /// Largest negative force over the largest force.
    pub tension: f64,
    /// Largest residual of equilibrium over the sum of magnitudes of its terms.
    pub equilibrium: f64,
}

impl Certificate {
    /// The largest of all residuals.
    pub fn largest(&self) -> f64 {
        self.complementarity.max(self.penetration).max(self.tension).max(self.equilibrium)
    }

    /// The worse of both, entry by entry: for a summary over steps.
    pub fn worst(&self, other: &Self) -> Self {
        Self {
            complementarity: self.complementarity.max(other.complementarity),
            penetration: self.penetration.max(other.penetration),
            tension: self.tension.max(other.tension),
            equilibrium: self.equilibrium.max(other.equilibrium),
        }
    }
}

/// A solved contact problem.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// p, N/m.
    pub forces: Vec<f64>,
    /// x.
    pub motion: Vec<f64>,
    /// d, m.
    pub gaps: Vec<f64>,
    /// Cells that carry force, ascending: a warm start for a problem that is nearly the same.
    pub active: Vec<usize>,
    /// How it was found.
    pub method: Method,
    /// Active sets tried.
    pub iterations: usize,
    /// How well it is solved.
    pub certificate: Certificate,
}

impl ContactProblem {
    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.gaps.len()
    }

    /// Number of rigid freedoms.
    pub fn freedoms(&self) -> usize {
        self.load.len()
    }

    pub(super) fn validate(&self) -> Result<(), ContactError> {
        let (n, m) = (self.cells(), self.freedoms());
        if self.compliance.len() != n * n || self.arms.len() != n * m || self.stiffness.len() != m * m {
            return Err(ContactError::Invalid("sizes of the arrays do not match"));
        }
        let finite = [&self.compliance, &self.arms, &self.gaps, &self.stiffness, &self.load]
            .iter()
            .all(|values| values.iter().all(|v| v.is_finite()));
        if !finite {
            return Err(ContactError::Invalid("a number is not finite"));
        }
        match (0..n).find(|&i| self.compliance[i * n + i] <= 0.0) {
            Some(cell) => Err(ContactError::DependentCells { cell }),
            None => Ok(()),
        }
    }

    /// d for the given forces and motion.
    pub fn gaps_at(&self, forces: &[f64], motion: &[f64]) -> Vec<f64> {
        let (n, m) = (self.cells(), self.freedoms());
        (0..n)
            .map(|i| {
                let elastic: f64 = (0..n).map(|j| self.compliance[i * n + j] * forces[j]).sum();
                let rigid: f64 = (0..m).map(|k| self.arms[i * m + k] * motion[k]).sum();
                elastic + rigid + self.gaps[i]
            })
            .collect()
    }

    /// The value that the solution minimises: elastic energy and work against gaps and springs.
    pub fn objective(&self, forces: &[f64], motion: &[f64]) -> f64 {
        let (n, m) = (self.cells(), self.freedoms());
        let mut value = 0.0;
        for i in 0..n {
            let elastic: f64 = (0..n).map(|j| self.compliance[i * n + j] * forces[j]).sum();
            value += forces[i] * (0.5 * elastic + self.gaps[i]);
        }
        for k in 0..m {
            let spring: f64 = (0..m).map(|l| self.stiffness[k * m + l] * motion[l]).sum();
            value += 0.5 * motion[k] * spring;
        }
        value
    }

    /// Violations of the conditions of the problem, each over the magnitude of what it is made of.
    pub fn certify(&self, forces: &[f64], motion: &[f64]) -> Certificate {
        let (n, m) = (self.cells(), self.freedoms());
        let gaps = self.gaps_at(forces, motion);
        let mut gap_scale = 0.0f64;
        for i in (0..n).filter(|&i| forces[i] > 0.0) {
            let elastic: f64 = (0..n).map(|j| (self.compliance[i * n + j] * forces[j]).abs()).sum();
            let rigid: f64 = (0..m).map(|k| (self.arms[i * m + k] * motion[k]).abs()).sum();
            gap_scale = gap_scale.max(elastic + rigid + self.gaps[i].abs());
        }
        let force_scale = forces.iter().fold(0.0f64, |a, p| a.max(p.abs()));
        let ratio = |violation: f64, scale: f64| if violation == 0.0 { 0.0 } else { violation / scale };
        let mut certificate = Certificate::default();
        for i in 0..n {
            certificate.complementarity =
                certificate.complementarity.max(ratio((forces[i] * gaps[i]).abs(), force_scale * gap_scale));
            certificate.penetration = certificate.penetration.max(ratio((-gaps[i]).max(0.0), gap_scale));
            certificate.tension = certificate.tension.max(ratio((-forces[i]).max(0.0), force_scale));
        }
        for k in 0..m {
            let (mut residual, mut magnitude) = (self.load[k], self.load[k].abs());
            for i in 0..n {
                let term = self.arms[i * m + k] * forces[i];
                residual += term;
                magnitude += term.abs();
            }
            for l in 0..m {
                let term = self.stiffness[k * m + l] * motion[l];
                residual -= term;
                magnitude += term.abs();
            }
            certificate.equilibrium = certificate.equilibrium.max(ratio(residual.abs(), magnitude));
        }
        certificate
    }
}
