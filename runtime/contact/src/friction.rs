//! Coulomb friction with prescribed sliding directions, by fixed-point iteration around the
//! frictionless contact problem.
//!
//! A sliding cell carries the force mu p along the surface in addition to its normal force p. The
//! direction follows from the kinematics, so the friction force does no work on gaps and enters
//! only equilibrium. With the friction of the previous forces among the loads, the problem is
//! convex. Friction is a small part of the load, so a few iterations converge to rounding.
//! Deformation due to friction is neglected.
//!
//! See `docs/theory/contact.md`.

use super::active_set::{solve_until, solve_with_active_set};
use super::problem::{ContactError, ContactProblem, Solution};
use calyx_numerics::interrupt::Interrupt;

/// Maximum number of iterations. Each gains at least a digit for coefficients of friction up to
/// some tenths.
const ROUNDS: usize = 60;
/// Change of the friction loads, relative to the loads, that counts as rounding.
const SETTLED: f64 = 1e-15;

/// What is known about the active set of a contact problem.
#[derive(Clone, Copy, Debug)]
pub enum ActiveSet<'a> {
    /// An estimate, from which the search starts.
    Estimate(&'a [usize]),
    /// The active set is given: forces may become negative, see [`solve_with_active_set`].
    Given(&'a [usize]),
}

/// Solves a contact problem with friction. `friction` (cells by DOFs, row-major) is the generalized
/// force on a DOF due to the friction of a unit normal force on a cell: mu times the work of the
/// friction on a unit of the DOF. It is zero for cells that do not slide.
///
/// Returns the solution together with the problem that includes all friction among its loads; the
/// certificate refers to this problem.
///
/// # Errors
/// Those of [`solve_until`]; [`ContactError::NotConverged`] if friction grows without bound
/// (self-locking), or a given active set does not determine the solution.
pub fn solve_with_friction(
    problem: ContactProblem,
    friction: &[f64],
    active: ActiveSet<'_>,
    interrupt: &Interrupt,
) -> Result<(ContactProblem, Solution), ContactError> {
    let solve = |problem: &ContactProblem, former: Option<&[usize]>| match active {
        ActiveSet::Estimate(estimate) => solve_until(problem, Some(former.unwrap_or(estimate)), interrupt),
        ActiveSet::Given(given) => {
            solve_with_active_set(problem, given, interrupt)?.ok_or(ContactError::NotConverged)
        }
    };
    let m = problem.dofs();
    if friction.len() != problem.cells() * m {
        return Err(ContactError::Invalid("sizes of the arrays do not match"));
    }
    let mut loaded = problem;
    let mut solution = solve(&loaded, None)?;
    if m == 0 || friction.iter().all(|&work| work == 0.0) {
        return Ok((loaded, solution));
    }
    let applied = loaded.load.clone();
    let mut previous = f64::INFINITY;
    for _ in 0..ROUNDS {
        let mut load = applied.clone();
        let mut scale: Vec<f64> = applied.iter().map(|f| f.abs()).collect();
        for (row, &force) in friction.chunks_exact(m).zip(&solution.forces) {
            for k in 0..m {
                load[k] += row[k] * force;
                scale[k] += (row[k] * force).abs();
            }
        }
        let change =
            |k: usize| if scale[k] == 0.0 { 0.0 } else { (load[k] - loaded.load[k]).abs() / scale[k] };
        let size = (0..m).map(change).fold(0.0, f64::max);
        // Converged, or limited by rounding of the forces.
        if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
            return Ok((loaded, solution));
        }
        previous = size;
        loaded.load = load;
        solution = solve(&loaded, Some(&solution.active))?;
    }
    Err(ContactError::NotConverged)
}
