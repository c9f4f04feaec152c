//! Local search: COBYLA in the unit cube of the variables, restarted until it no longer improves.
//!
//! M. J. D. Powell, "A direct search optimization method that models the objective and constraint
//! functions by linear interpolation", Advances in Optimization and Numerical Analysis (1994),
//! 51-67, in the implementation of the crate `basin`, after that of Zhang's PRIMA.

use super::evaluation::{Evaluator, Functions, Stop};
use super::functions::Shape;
use super::problem::Effort;
use basin::{
    Cobyla, ConstraintDescription, ConstraintSet, ConstraintSolveError, Constraints, CostFunction, Executor,
    NoBounds, NoLinearConstraints, NoNonlinearBlock, NonlinearBlock, NonlinearBlocks,
    NonlinearInequalityValues, SelectedState,
};
use calyx_report::optimization::{Search, Values, compare};
use std::cell::{Cell, RefCell};
use std::fmt;
use std::rc::Rc;

/// Radius of the first trust region: a quarter of the range, as in a coarse grid of five values.
const FIRST_RADIUS: f64 = 0.25;
/// Radius of the trust region after a restart.
const NEXT_RADIUS: f64 = 0.05;
/// Largest number of restarts.
const RESTARTS: usize = 4;
/// Relative improvement of a restart below which the search has converged.
const IMPROVEMENT: f64 = 1e-4;

/// End of a run of the solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    Stopped(Stop),
    /// The number of positions depends on the design.
    OtherShape,
    /// The number of designs is at its limit.
    Limit,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for End {}

/// Search in progress.
struct Progress {
    best: Option<(Vec<f64>, Values)>,
    designs: usize,
}

/// Searches from a start in the unit cube.
///
/// # Errors
/// The optimization is cancelled, or the journal cannot be written.
pub fn run(evaluator: &Evaluator<'_>, number: usize, start: &[f64], effort: Effort) -> Result<Search, Stop> {
    let search = Rc::new(RefCell::new(Progress { best: None, designs: 0 }));
    let (mut at, mut radius, mut shape) = (start.to_vec(), FIRST_RADIUS, Shape::Positions);
    let mut converged = false;
    for _ in 0..=RESTARTS {
        let before = search.borrow().best.clone();
        let end =
            minimize(evaluator, number, &at, [radius, effort.tolerance], shape, effort.designs, &search)?;
        let found = search.borrow();
        let Some((best, values)) = &found.best else { break };
        at.clone_from(best);
        match end {
            Some(End::Limit) => break,
            Some(End::OtherShape) => {
                shape = Shape::Statistics;
                continue;
            }
            _ => {}
        }
        radius = NEXT_RADIUS;
        let improved = before.is_none_or(|(_, before)| {
            let objectives = (before.objective - values.objective).abs();
            compare(&evaluator.problem().objective, values, &before).is_lt()
                && (objectives > IMPROVEMENT * before.objective.abs() || before.violation > values.violation)
        });
        if !improved {
            converged = true;
            break;
        }
    }
    let problem = evaluator.problem();
    let found = search.borrow();
    let best = found.best.as_ref().map(|(at, values)| (problem.values_at(at), values.clone()));
    Ok(Search { start: problem.values_at(start), best, designs: evaluator.count(number), converged })
}

/// Problem as the solver sees it: the coordinates of the variables, and the common bound of the
/// functions of the objective, which is minimized.
struct Bounded<'e, 'o> {
    evaluator: &'e Evaluator<'o>,
    number: usize,
    shape: Shape,
    /// Magnitude of the objective.
    scale: f64,
    /// Numbers of functions at the start.
    counts: [usize; 2],
    /// Values in place of those of a design that failed.
    worst: Cell<f64>,
    most: usize,
    search: Rc<RefCell<Progress>>,
}

impl Bounded<'_, '_> {
    /// Returns the functions of a design; a failed one has the worst known objective and violates
    /// all constraints, so that the solver avoids it.
    fn functions(&self, at: &[f64]) -> Result<Functions, End> {
        if self.search.borrow().designs >= self.most {
            return Err(End::Limit);
        }
        let found =
            self.evaluator.functions(self.number, at, self.shape, self.scale).map_err(End::Stopped)?;
        let values = self.evaluator.values(self.number, at).map_err(End::Stopped)?;
        let mut search = self.search.borrow_mut();
        search.designs += 1;
        if let Ok(values) = values {
            let objective = &self.evaluator.problem().objective;
            if search.best.as_ref().is_none_or(|(_, best)| compare(objective, &values, best).is_lt()) {
                search.best = Some((at.to_vec(), values));
            }
        }
        let Some(functions) = found else {
            return Ok(Functions {
                objective: vec![self.worst.get(); self.counts[0]],
                constraints: vec![((0, 0), 1.0); self.counts[1]],
                cases: Vec::new(),
            });
        };
        if [functions.objective.len(), functions.constraints.len()] != self.counts {
            return Err(End::OtherShape);
        }
        let largest = functions.objective.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        self.worst.set(self.worst.get().max(largest));
        Ok(functions)
    }
}

type Inequalities =
    ConstraintSet<NoBounds, NoLinearConstraints, NonlinearBlocks<NoNonlinearBlock, NonlinearBlock>>;

impl Constraints for Bounded<'_, '_> {
    type Set = Inequalities;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        let variables = self.evaluator.problem().variables.len();
        ConstraintSet::new().with_nonlinear_inequalities(self.counts[0] + self.counts[1] + 2 * variables)
    }
}

impl CostFunction for Bounded<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = End;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, End> {
        Ok(x.last().copied().unwrap_or_default())
    }
}

impl NonlinearInequalityValues for Bounded<'_, '_> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = End;

    fn nonlinear_inequalities(&self, x: &Vec<f64>) -> Result<Vec<f64>, ConstraintSolveError<End>> {
        let (at, bound) = x.split_at(self.evaluator.problem().variables.len());
        // The solver tries points outside of the bounds.
        let inside: Vec<f64> = at.iter().map(|part| part.clamp(0.0, 1.0)).collect();
        let functions = self.functions(&inside).map_err(ConstraintSolveError::Evaluation)?;
        let mut values: Vec<f64> = functions.objective.iter().map(|value| value - bound[0]).collect();
        values.extend(functions.constraints.iter().map(|(_, value)| value));
        values.extend(at.iter().map(|part| -part));
        values.extend(at.iter().map(|part| part - 1.0));
        Ok(values)
    }
}

/// Runs the solver once, from and to the given radii of the trust region. Returns how it ended if
/// not by convergence.
fn minimize(
    evaluator: &Evaluator<'_>,
    number: usize,
    start: &[f64],
    [radius, tolerance]: [f64; 2],
    shape: Shape,
    most: usize,
    search: &Rc<RefCell<Progress>>,
) -> Result<Option<End>, Stop> {
    let unscaled = evaluator.functions(number, start, shape, 1.0)?;
    let Some(unscaled) = unscaled else { return Ok(Some(End::Limit)) };
    let largest = unscaled.objective.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let scale = if largest == 0.0 { 1.0 } else { largest.abs() };
    let problem = Bounded {
        evaluator,
        number,
        shape,
        scale,
        counts: [unscaled.objective.len(), unscaled.constraints.len()],
        worst: Cell::new(largest / scale),
        most,
        search: search.clone(),
    };
    let mut point = start.to_vec();
    point.push(largest / scale);
    let solver = Cobyla::new().with_initial_radius(radius.max(2.0 * tolerance)).with_final_radius(tolerance);
    let ended =
        Executor::new(problem, solver, SelectedState::new(point)).max_cost_evals(10 * most as u64).run();
    match ended {
        Ok(_) => Ok(None),
        Err(error) => match error {
            ConstraintSolveError::Evaluation(End::Stopped(stop)) => Err(stop),
            ConstraintSolveError::Evaluation(end) => Ok(Some(end)),
            _ => Ok(Some(End::Limit)),
        },
    }
}
