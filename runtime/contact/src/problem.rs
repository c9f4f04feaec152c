//! Contact problem (report eq. 2.40): its data, its solution and the certificate of a solution.
//!
//! Find cell forces `p >= 0` and rigid motions `x` with gaps `d = A p + C x + e >= 0`, `p'd = 0`
//! and equilibrium `C'p - K x = -f`. This is a (mixed) linear complementarity problem. Equations
//! 2.37 to 2.39 of the report need transposes; with the signs here B is C', because contact forces
//! do positive work where gaps grow. The conditions are the optimality conditions of the convex
//! program `min p'Ap/2 + e'p + x'Kx/2` subject to the equilibrium, with x as its multipliers.
//!
//! See `docs/theory/contact.md`.

use calyx_numerics::error::EngineError;
use serde::{Deserialize, Serialize};

/// Data of a contact problem of n cells and m DOFs; matrices are row-major.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactProblem {
    /// A, the compliance matrix, n by n, symmetric positive definite: growth of a cell's gap per
    /// force on a cell, m/(N/m).
    pub compliance: Vec<f64>,
    /// C, n by m: growth of a cell's gap per unit of a rigid-body DOF (m, or m/rad).
    pub arms: Vec<f64>,
    /// e, n: gaps without force and motion, m; negative where the undeformed bodies overlap.
    pub gaps: Vec<f64>,
    /// K, m by m, symmetric positive semidefinite: springs on the DOFs; zero without springs.
    pub stiffness: Vec<f64>,
    /// f, m: external generalized force on each DOF, positive in the positive sense of the DOF.
    pub load: Vec<f64>,
}

/// Rigid motion without resistance.
#[derive(Clone, Debug, PartialEq)]
pub struct FreeMotion {
    /// DOF with the largest part in the motion, compared by the change of gaps.
    pub dof: usize,
    /// Sense of that DOF, +1 or -1.
    pub direction: f64,
    /// Motion of all DOFs in their own units; that of the named one is ±1.
    pub motion: Vec<f64>,
}

/// Reason why a contact problem has no solution, or none was found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContactError {
    /// The load does work on this motion, and no contact closes along it.
    #[error("no contact can balance the load: it moves degree of freedom {} in the {} direction", .0.dof, sense(.0.direction))]
    Infeasible(FreeMotion),
    /// The load does no work on this motion, but neither contact nor a spring determines it.
    #[error("degree of freedom {} is constrained neither by contact nor by a spring", .0.dof)]
    Unconstrained(FreeMotion),
    /// The compliance matrix loses rank at this cell: two cells coincide, or the bodies are rigid.
    #[error("the compliance of cell {cell} is not independent of the cells before it")]
    DependentCells {
        /// Index of the cell.
        cell: usize,
    },
    /// No position is free of overlap, so the rigid-body limit does not exist.
    #[error("the bodies overlap in every position")]
    Jammed,
    /// A number is not finite, or the dimensions of the arrays do not match.
    #[error("contact problem: {0}")]
    Invalid(&'static str),
    /// Neither pivoting nor the interior-point method found the solution.
    #[error("the contact solver did not converge")]
    NotConverged,
    /// The caller interrupted the search.
    #[error(transparent)]
    Interrupted(EngineError),
}

fn sense(direction: f64) -> &'static str {
    if direction > 0.0 { "positive" } else { "negative" }
}

/// Algorithm that found the solution.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Block principal pivoting: many cells are exchanged at a time.
    BlockPivoting,
    /// Single exchanges, which cannot cycle.
    SinglePivoting,
    /// Interior-point method, used after pivoting reached its limit.
    Clarabel,
}

/// Largest relative residuals of a solution, evaluated with the unscaled data of the problem. An
/// exact solution has residuals of the order of rounding.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Certificate {
    /// Complementarity: largest `p_i |d_i|`, relative to the largest force times the gap scale.
    pub complementarity: f64,
    /// Largest overlap, relative to the gap scale, which is the largest sum of magnitudes in a
    /// loaded cell's gap equation.
    pub penetration: f64,
    /// Largest negative force, relative to the largest force.
    pub tension: f64,
    /// Largest residual of equilibrium, relative to the sum of magnitudes of its terms.
    pub equilibrium: f64,
}

impl Certificate {
    /// Returns the largest of all residuals.
    pub fn largest(&self) -> f64 {
        self.complementarity.max(self.penetration).max(self.tension).max(self.equilibrium)
    }

    /// Returns the larger of both residuals, entry by entry.
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
    /// p, cell forces, N/m.
    pub forces: Vec<f64>,
    /// x, rigid motion by DOF.
    pub motion: Vec<f64>,
    /// d, gaps, m.
    pub gaps: Vec<f64>,
    /// Active set: cells that carry force, ascending. It serves as a warm start for similar
    /// problems.
    pub active: Vec<usize>,
    /// Algorithm that found the solution.
    pub method: Method,
    /// Number of active sets tried.
    pub iterations: usize,
    /// Residuals of the solution.
    pub certificate: Certificate,
}

impl ContactProblem {
    /// Number of cells.
    pub fn cells(&self) -> usize {
        self.gaps.len()
    }

    /// Number of rigid-body DOFs.
    pub fn dofs(&self) -> usize {
        self.load.len()
    }

    pub(super) fn validate(&self) -> Result<(), ContactError> {
        let (n, m) = (self.cells(), self.dofs());
        if self.compliance.len() != n * n || self.arms.len() != n * m || self.stiffness.len() != m * m {
            return Err(ContactError::Invalid("sizes of the arrays do not match"));
        }
        let all = [
            (&self.compliance, "a compliance is not finite"),
            (&self.arms, "a direction of a rigid-body motion is not finite"),
            (&self.gaps, "a gap is not finite"),
            (&self.stiffness, "a stiffness of a bearing is not finite"),
            (&self.load, "a load is not finite"),
        ];
        let broken = |(values, _): &&(&Vec<f64>, &str)| !values.iter().all(|value| value.is_finite());
        if let Some((_, what)) = all.iter().find(broken) {
            return Err(ContactError::Invalid(what));
        }
        match (0..n).find(|&i| self.compliance[i * n + i] <= 0.0) {
            Some(cell) => Err(ContactError::DependentCells { cell }),
            None => Ok(()),
        }
    }

    /// Returns the gaps d at the given forces and motion.
    pub fn gaps_at(&self, forces: &[f64], motion: &[f64]) -> Vec<f64> {
        let (n, m) = (self.cells(), self.dofs());
        (0..n)
            .map(|i| {
                let elastic: f64 = (0..n).map(|j| self.compliance[i * n + j] * forces[j]).sum();
                let rigid: f64 = (0..m).map(|k| self.arms[i * m + k] * motion[k]).sum();
                elastic + rigid + self.gaps[i]
            })
            .collect()
    }

    /// Returns the objective function: elastic energy, and work against gaps and springs.
    pub fn objective(&self, forces: &[f64], motion: &[f64]) -> f64 {
        let (n, m) = (self.cells(), self.dofs());
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

    /// Computes the residuals of all conditions, each relative to the magnitude of its terms.
    pub fn certify(&self, forces: &[f64], motion: &[f64]) -> Certificate {
        let (n, m) = (self.cells(), self.dofs());
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
