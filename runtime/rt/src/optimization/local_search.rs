//! Local search in the unit cube of the variables: COBYLA, then SLSQP from its result, repeated
//! until neither improves it.
//!
//! COBYLA interpolates linear models within a trust region, and tolerates kinks and designs that
//! fail. It is slow where fewer functions are active than there are variables; there, the quadratic
//! model of SLSQP converges fast. Its gradients are derivatives of the outputs, or central
//! differences. Both are those of the crate `basin`.
//!
//! M. J. D. Powell, "A direct search optimization method that models the objective and constraint
//! functions by linear interpolation", Advances in Optimization and Numerical Analysis (1994),
//! 51-67. D. Kraft, "A software package for sequential quadratic programming", DFVLR-FB 88-28
//! (1988).

use super::evaluation::{Evaluator, Stop};
use super::functions::Shape;
use super::minimax::{Best, End, Minimax, Solver, largest};
use calyx_report::optimization::{FEASIBLE, Search, compare};

/// Radius of the first trust region: a quarter of the range, as in a coarse grid of five values.
pub const FIRST_RADIUS: f64 = 0.25;
/// Radius of the trust region after a restart.
const NEXT_RADIUS: f64 = 0.05;
/// Largest number of repetitions.
const REPETITIONS: usize = 8;
/// Relative improvement of a repetition below which the search has converged.
const IMPROVEMENT: f64 = 1e-4;
/// Objective, relative to that of the start, below which it counts as zero.
const SMALL: f64 = 1e-3;

/// Searches from a start in the unit cube, within a trust region of a radius at first.
///
/// # Errors
/// The optimization is cancelled, or the journal cannot be written.
pub fn run(evaluator: &Evaluator<'_>, number: usize, start: &[f64], radius: f64) -> Result<Search, Stop> {
    let best = Best::default();
    let mut converged = false;
    if let Some(functions) = evaluator.functions(number, start, Shape::Statistics, 1.0)? {
        let scale = match largest(&functions.objective).abs() {
            scale if scale > 0.0 && scale.is_finite() => scale,
            _ => evaluator.unit(),
        };
        converged = repeat((evaluator, number), (start, radius), scale, &best)?;
    }
    let problem = evaluator.problem();
    let best = best.borrow().as_ref().map(|(at, values)| (problem.values_at(at), values.clone()));
    let designs = evaluator.count(number);
    Ok(Search { number, start: problem.values_at(start), best, designs, converged })
}

/// Repeats both solvers, and returns whether the search has converged.
fn repeat(
    own: (&Evaluator<'_>, usize),
    (start, first_radius): (&[f64], f64),
    scale: f64,
    best: &Best,
) -> Result<bool, Stop> {
    let effort = own.0.problem().effort;
    let (mut at, mut radius, mut shape) = (start.to_vec(), first_radius, Shape::Positions);
    for _ in 0..=REPETITIONS {
        let before = best.borrow().clone();
        for solver in [Solver::Cobyla { radius, tolerance: effort.tolerance }, Solver::Slsqp] {
            let problem = Minimax::from(own, &at, shape, scale, (effort.designs, best))?;
            let Some(problem) = problem else { return Ok(false) };
            let end = problem.solve(&at, solver)?;
            if let Some((best, _)) = &*best.borrow() {
                at.clone_from(best);
            }
            match end {
                Some(End::Limit) => return Ok(false),
                Some(End::OtherShape) => shape = Shape::Statistics,
                _ => {}
            }
        }
        radius = NEXT_RADIUS;
        let improved = match (&before, &*best.borrow()) {
            (Some((_, before)), Some((_, best))) => {
                let change = (before.objective - best.objective).abs();
                let least = IMPROVEMENT * before.objective.abs().max(SMALL * scale);
                compare(&own.0.problem().objective, best, before).is_lt()
                    && (change > least || before.violation > FEASIBLE)
            }
            (_, best) => best.is_some(),
        };
        if !improved {
            return Ok(true);
        }
    }
    Ok(false)
}
