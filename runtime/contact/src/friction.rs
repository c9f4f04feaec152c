//! Friction along a given direction of sliding: a fixed point around the frictionless contact problem.
//!
//! A cell that slides carries, beside its normal force p, the force mu p along the surface. It does no work on gaps, for the direction
//! is that of the kinematics; it enters equilibrium. With the friction of the forces found before among the loads, the problem is the
//! convex one again, and as friction is a small part of the load a few rounds settle it to rounding. What friction itself does to the
//! shape of the bodies is left out.

use super::active_set::solve_until;
use super::problem::{ContactError, ContactProblem, Solution};
use calyx_numerics::interrupt::Interrupt;

/// Rounds of which each gains at least a digit for every coefficient of friction up to some tenths.
const ROUNDS: usize = 60;
/// Change of the loads by friction, relative to the loads, that is rounding.
const SETTLED: f64 = 1e-15;

/// Solves a contact problem with friction. `friction`, cells by freedoms, row-major: the generalised force on a freedom by the friction of
/// a unit normal force on a cell, mu times the work of the friction on a unit of the freedom; zero where a cell does not slide.
///
/// The solution is that of the problem with all friction among its loads, which is what its certificate is about; that problem is
/// returned with it.
///
/// # Errors
/// As [`solve_until`]; [`ContactError::NotConverged`] if friction grows without end (it holds what should move).
pub fn solve_with_friction(
    problem: ContactProblem,
    friction: &[f64],
    warm_start: Option<&[usize]>,
    interrupt: &Interrupt,
) -> Result<(ContactProblem, Solution), ContactError> {
    let m = problem.freedoms();
    if friction.len() != problem.cells() * m {
        return Err(ContactError::Invalid("sizes of the arrays do not match"));
    }
    let mut loaded = problem;
    let mut solution = solve_until(&loaded, warm_start, interrupt)?;
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
        // Settled, or as near as rounding of the forces lets it come.
        if size <= SETTLED || (size <= 1e3 * SETTLED && size >= 0.5 * previous) {
            return Ok((loaded, solution));
        }
        previous = size;
        loaded.load = load;
        solution = solve_until(&loaded, Some(&solution.active), interrupt)?;
    }
    Err(ContactError::NotConverged)
}
