//! Problem of a local search as the solvers see it: the coordinates of the variables in the unit
//! cube, and if the objective has several functions their common bound, which is minimized.

use super::evaluation::{Evaluator, Functions, Stop};
use super::functions::Shape;
use basin::{
    Cobyla, ConstraintDescription, ConstraintJacobian, ConstraintSet, ConstraintSolveError, Constraints,
    CostFunction, DenseMatrix, Executor, Gradient, NoBounds, NoLinearConstraints, NoNonlinearBlock,
    NonlinearBlock, NonlinearBlocks, NonlinearInequalityValues, SelectedFirstOrderState, SelectedState,
    Slsqp,
};
use calyx_report::optimization::{FEASIBLE, Values, compare};
use std::cell::{Cell, RefCell};
use std::fmt;
use std::rc::Rc;

/// Step of the differences, relative to the range of a variable.
const STEP: f64 = 1e-4;
/// Accuracy of SLSQP, relative to the objective of the start.
const ACCURACY: f64 = 1e-9;
/// Largest number of iterations of SLSQP.
const ITERATIONS: u64 = 50;
/// Largest number of evaluations of COBYLA per coordinate: then SLSQP has its turn.
const EVALUATIONS: u64 = 40;
/// Relative improvement of the objective that SLSQP must make within [`PATIENCE`] gradients, or it
/// stops: near a kink, or with rounding of the functions, it makes small steps only.
const PROGRESS: f64 = 1e-4;
/// Number of gradients for such an improvement.
const PATIENCE: usize = 4;
/// Unit of the common bound, relative to the objective of the start. The trust region of COBYLA
/// limits the bound too, which must not delay the variables.
const BOUND: f64 = 10.0;

/// End of a run of a solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    Stopped(Stop),
    /// The number of positions depends on the design.
    OtherShape,
    /// The number of designs is at its limit.
    Limit,
    /// The solver makes no progress.
    Stalled,
}

impl fmt::Display for End {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self:?}")
    }
}

impl std::error::Error for End {}

/// Best design of a search: its coordinates and values.
pub type Best = Rc<RefCell<Option<(Vec<f64>, Values)>>>;

/// Solver of a step of the search.
#[derive(Clone, Copy, Debug)]
pub enum Solver {
    /// From and to a radius of the trust region.
    Cobyla {
        radius: f64,
        tolerance: f64,
    },
    Slsqp,
}

/// Problem of a search.
pub struct Minimax<'e, 'o> {
    pub evaluator: &'e Evaluator<'o>,
    /// Number of the search.
    pub number: usize,
    pub shape: Shape,
    /// Magnitude of the objective.
    pub scale: f64,
    /// Largest number of designs of the search.
    pub most: usize,
    pub best: Best,
    /// Numbers of functions at the start: of the objective and of the constraints.
    counts: [usize; 2],
    /// Values in place of those of a design that failed.
    worst: Cell<f64>,
    /// Objective at the last progress, and the number of gradients since then.
    progress: Cell<(f64, usize)>,
}

impl<'e, 'o> Minimax<'e, 'o> {
    /// Creates the problem of a search from a design; `None` if that fails.
    ///
    /// # Errors
    /// The optimization is cancelled, or the journal cannot be written.
    pub fn from(
        (evaluator, number): (&'e Evaluator<'o>, usize),
        at: &[f64],
        shape: Shape,
        scale: f64,
        (most, best): (usize, &Best),
    ) -> Result<Option<Self>, Stop> {
        let functions = evaluator.functions(number, at, shape, scale)?;
        Ok(functions.map(|functions| {
            let counts = [functions.objective.len(), functions.constraints.len()];
            let worst = Cell::new(largest(&functions.objective));
            Minimax {
                evaluator,
                number,
                shape,
                scale,
                most,
                best: best.clone(),
                counts,
                worst,
                progress: Cell::new((f64::INFINITY, 0)),
            }
        }))
    }

    /// Runs a solver from a design, and returns how it ended if not by itself.
    ///
    /// # Errors
    /// The optimization is cancelled, or the journal cannot be written.
    pub fn solve(self, start: &[f64], solver: Solver) -> Result<Option<End>, Stop> {
        let mut point = start.to_vec();
        point.extend(self.has_bound().then_some(self.worst.get() / BOUND));
        let evaluations = EVALUATIONS * (point.len() as u64 + 1);
        let ended = match solver {
            Solver::Cobyla { radius, tolerance } => {
                let cobyla = Cobyla::new().with_initial_radius(radius.max(2.0 * tolerance));
                let cobyla = cobyla.with_final_radius(tolerance);
                let executor = Executor::new(self, cobyla, SelectedState::new(point));
                executor.max_cost_evals(evaluations).run().map(drop)
            }
            Solver::Slsqp => {
                let slsqp = Slsqp::new().with_absolute_accuracy_tolerance(ACCURACY);
                let state = SelectedFirstOrderState::new(point);
                Executor::new(self, slsqp, state).max_iter(ITERATIONS).run().map(drop)
            }
        };
        match ended {
            Ok(()) => Ok(None),
            Err(ConstraintSolveError::Evaluation(End::Stopped(stop))) => Err(stop),
            Err(ConstraintSolveError::Evaluation(end)) => Ok(Some(end)),
            // The solver gives up; the best design so far remains.
            Err(_) => Ok(None),
        }
    }

    fn variables(&self) -> usize {
        self.evaluator.problem().variables.len()
    }

    /// Returns whether the objective has several functions.
    fn has_bound(&self) -> bool {
        self.counts[0] > 1
    }

    /// Returns the functions of the objective, then those of the constraints.
    fn values(&self, x: &[f64]) -> Result<Vec<f64>, End> {
        // The solvers try points outside of the ranges.
        let inside: Vec<f64> = x[..self.variables()].iter().map(|part| part.clamp(0.0, 1.0)).collect();
        let Functions { mut objective, constraints, .. } = self.functions(&inside)?;
        objective.extend(constraints.into_iter().map(|(_, value)| value));
        Ok(objective)
    }

    /// Returns the slopes of these functions by variable: their derivatives, or where these are not
    /// known central differences, and one-sided ones at the ends of the ranges.
    fn slopes(&self, x: &[f64]) -> Result<Vec<Vec<f64>>, End> {
        self.check_progress()?;
        let inside: Vec<f64> = x[..self.variables()].iter().map(|part| part.clamp(0.0, 1.0)).collect();
        let exact = self.evaluator.slopes(&inside, self.shape, self.scale).map_err(End::Stopped)?;
        let exact = exact.unwrap_or_default();
        let count = self.counts[0] + self.counts[1];
        let slope = |k: usize| {
            if let Some(known) = exact.get(k).and_then(Option::as_ref).filter(|known| known.len() == count) {
                return Ok(known.clone());
            }
            let ends = [-STEP, STEP].map(|step| (x[k] + step).clamp(0.0, 1.0));
            let at = |end: f64| {
                let mut moved = x.to_vec();
                moved[k] = end;
                self.values(&moved)
            };
            let (below, above, width) = (at(ends[0])?, at(ends[1])?, ends[1] - ends[0]);
            let change =
                |(above, below): (&f64, &f64)| if width > 0.0 { (above - below) / width } else { 0.0 };
            Ok(above.iter().zip(&below).map(change).collect())
        };
        (0..self.variables()).map(slope).collect()
    }

    /// Stops a solver whose last gradients have not led to a better design.
    fn check_progress(&self) -> Result<(), End> {
        let best = self
            .best
            .borrow()
            .as_ref()
            .filter(|(_, values)| values.violation <= FEASIBLE)
            .map(|(_, values)| values.objective);
        let Some(objective) = best else {
            return Ok(());
        };
        let (before, count) = self.progress.get();
        if (objective - before).abs() > PROGRESS * objective.abs() {
            self.progress.set((objective, 0));
        } else if count >= PATIENCE {
            return Err(End::Stalled);
        } else {
            self.progress.set((before, count + 1));
        }
        Ok(())
    }

    /// Returns the functions of a design; a failed one has the worst known objective and violates
    /// all constraints, so that the solver avoids it.
    fn functions(&self, at: &[f64]) -> Result<Functions, End> {
        if self.evaluator.count(self.number) >= self.most {
            return Err(End::Limit);
        }
        let found =
            self.evaluator.functions(self.number, at, self.shape, self.scale).map_err(End::Stopped)?;
        let values = self.evaluator.values(self.number, at).map_err(End::Stopped)?;
        if let Ok(values) = values {
            let objective = &self.evaluator.problem().objective;
            let mut best = self.best.borrow_mut();
            if best.as_ref().is_none_or(|(_, best)| compare(objective, &values, best).is_lt()) {
                *best = Some((at.to_vec(), values));
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
        self.worst.set(self.worst.get().max(largest(&functions.objective)));
        Ok(functions)
    }
}

/// Returns the largest of some values.
pub fn largest(values: &[f64]) -> f64 {
    values.iter().copied().fold(f64::NEG_INFINITY, f64::max)
}

type Inequalities =
    ConstraintSet<NoBounds, NoLinearConstraints, NonlinearBlocks<NoNonlinearBlock, NonlinearBlock>>;

impl Constraints for Minimax<'_, '_> {
    type Set = Inequalities;

    fn constraints(&self) -> <Self::Set as ConstraintDescription>::Borrowed<'_> {
        let objective = if self.has_bound() { self.counts[0] } else { 0 };
        ConstraintSet::new().with_nonlinear_inequalities(objective + self.counts[1] + 2 * self.variables())
    }
}

impl CostFunction for Minimax<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = End;

    fn cost(&self, x: &Vec<f64>) -> Result<f64, End> {
        match x.get(self.variables()) {
            Some(bound) => Ok(BOUND * bound),
            None => self.values(x).map(|values| values[0]),
        }
    }
}

impl NonlinearInequalityValues for Minimax<'_, '_> {
    type Param = Vec<f64>;
    type Values = Vec<f64>;
    type Error = End;

    fn nonlinear_inequalities(&self, x: &Vec<f64>) -> Result<Vec<f64>, ConstraintSolveError<End>> {
        let mut values = self.values(x).map_err(ConstraintSolveError::Evaluation)?;
        let (at, bound) = x.split_at(self.variables());
        match bound.first() {
            Some(bound) => values[..self.counts[0]].iter_mut().for_each(|value| *value -= BOUND * bound),
            None => drop(values.remove(0)),
        }
        values.extend(at.iter().map(|part| -part));
        values.extend(at.iter().map(|part| part - 1.0));
        Ok(values)
    }
}

impl Gradient for Minimax<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, x: &Vec<f64>) -> Result<Vec<f64>, End> {
        if !self.has_bound() {
            return self.slopes(x).map(|slopes| slopes.iter().map(|slopes| slopes[0]).collect());
        }
        let mut gradient = vec![0.0; x.len()];
        gradient[self.variables()] = BOUND;
        Ok(gradient)
    }
}

impl ConstraintJacobian for Minimax<'_, '_> {
    type Param = Vec<f64>;
    type Jacobian = DenseMatrix<f64>;
    type Error = End;

    fn constraint_jacobian(&self, x: &Vec<f64>) -> Result<DenseMatrix<f64>, ConstraintSolveError<End>> {
        let slopes = self.slopes(x).map_err(ConstraintSolveError::Evaluation)?;
        let first = if self.has_bound() { 0 } else { 1 };
        let functions = self.counts[0] + self.counts[1] - first;
        let (variables, columns) = (slopes.len(), x.len());
        let rows = functions + 2 * variables;
        let mut entries = vec![0.0; rows * columns];
        for (k, slopes) in slopes.iter().enumerate() {
            for (row, slope) in slopes[first..].iter().enumerate() {
                entries[row * columns + k] = *slope;
            }
            entries[(functions + k) * columns + k] = -1.0;
            entries[(functions + variables + k) * columns + k] = 1.0;
        }
        if self.has_bound() {
            (0..self.counts[0]).for_each(|row| entries[row * columns + variables] = -BOUND);
        }
        Ok(DenseMatrix::from_row_slice(rows, columns, &entries))
    }
}
