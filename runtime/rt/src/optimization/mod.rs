//! Optimization of a model: the values of some params at which a statistic of an output is best,
//! within bounds of others, over load cases and samples of toleranced params.
//!
//! Several local searches begin at different designs. Each begins with COBYLA of Powell: linear models of
//! all functions, interpolated at the corners of a simplex, minimized within a trust region. It
//! needs no derivatives, and a maximum over positions or load cases is a set of functions below a
//! common bound, whose kinks are therefore exact. Every evaluated load case is a line of a journal,
//! from which an interrupted optimization continues: the searches are deterministic, and repeat
//! their designs from the journal.
//!
//! See `docs/theory/optimization.md`.

mod evaluation;
mod functions;
mod global_search;
mod local_search;
mod minimax;
mod optimality;
mod problem;
mod slopes;
mod study;

pub use calyx_report::optimization::{
    Constraint, DESIGNS, FEASIBLE, Measure, OPTIMUM, OPTIMUM_HEADER, Optimization, Variable, text,
    write_designs, write_optimum,
};
pub use evaluation::EVALUATIONS;
pub use problem::{Effort, Problem};
pub use study::read;

use crate::engine::Engine;
use crate::param_assignment::ParamAssignment;
use crate::params::output_of;
use crate::program::Program;
use crate::run::RunError;
use calyx_abi::{Cancel, stack};
use calyx_report::optimization::{Influence, Optimality, STEP};
use calyx_report::sweep::Column;
use calyx_runtime::settings_override::Override;
use evaluation::{Evaluator, Stop};
use rayon::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// A model and what is optimized.
pub struct Optimizer {
    pub program: Arc<dyn Program>,
    /// Values assigned to params in all designs.
    pub given: Vec<ParamAssignment>,
    /// Overrides of the analysis settings.
    pub overrides: Override,
    pub problem: Problem,
    /// Directory of the journal, locked by the caller.
    pub directory: PathBuf,
    pub engine: Engine,
    /// Number of load cases that are solved at a time.
    pub workers: usize,
    pub cancel: Cancel,
}

/// State of an optimization, after each design.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Number of evaluated designs.
    pub designs: usize,
    /// Number of searches that have ended, and of all.
    pub searches: [usize; 2],
    /// Best feasible objective, SI.
    pub best: Option<f64>,
}

impl Optimizer {
    /// Runs the optimization, or continues it. `done` receives the state after each design.
    ///
    /// # Errors
    /// A value is invalid, every design of the starts failed, or the journal cannot be written.
    pub fn run(&self, done: impl Fn(&State) + Sync) -> Result<Optimization, RunError> {
        let evaluator = Evaluator::new(self, &done)?;
        // Each evaluation of a model needs a large stack, and would start a thread for it.
        let on_large_stack = |worker: rayon::ThreadBuilder| {
            let thread = stack::beside(move || worker.run());
            thread.map(drop).map_err(|error| std::io::Error::other(error.message))
        };
        let workers = rayon::ThreadPoolBuilder::new().num_threads(self.workers.max(1));
        let workers = workers.spawn_handler(on_large_stack).build();
        let workers = workers.map_err(|error| RunError::Io {
            path: self.directory.clone(),
            error: std::io::Error::other(error),
        })?;
        let ended = workers.install(|| global_search::run(&evaluator, &self.initial()));
        let mut all = self.summary(&evaluator)?;
        match ended {
            Ok(searches) => {
                all.initial = evaluator.values(0, &self.initial()).map_err(|stop| evaluator.failure(stop))?;
                all.searches = searches;
            }
            Err(Stop::Cancelled) => {
                all.interrupted = true;
                if let Some(initial) = evaluator.evaluated(&self.initial()) {
                    all.initial = initial;
                }
                all.searches = evaluator.searches();
            }
            Err(Stop::Unwritable) => return Err(evaluator.failure(Stop::Unwritable)),
        }
        if !all.interrupted {
            let near = workers.install(|| self.near_optimum(&evaluator, &all));
            match near {
                Ok((influences, optimality)) => (all.influences, all.optimality) = (influences, optimality),
                Err(Stop::Cancelled) => all.interrupted = true,
                Err(stop) => return Err(evaluator.failure(stop)),
            }
        }
        all.designs = evaluator.designs();
        Ok(all)
    }

    /// Returns the coordinates of the initial design in the unit cube.
    fn initial(&self) -> Vec<f64> {
        let variables = self.problem.variables.iter();
        variables.map(|variable| (variable.initial - variable.low) / (variable.high - variable.low)).collect()
    }

    /// Evaluates designs near the optimum.
    fn near_optimum(
        &self,
        evaluator: &Evaluator<'_>,
        all: &Optimization,
    ) -> Result<(Vec<Influence>, Option<Optimality>), Stop> {
        let Some((best, values)) = all.best() else { return Ok((Vec::new(), None)) };
        let variables = &self.problem.variables;
        let unit = |(variable, si): (&Variable, &f64)| (si - variable.low) / (variable.high - variable.low);
        let at: Vec<f64> = variables.iter().zip(best).map(unit).collect();
        let beside = |k: usize| {
            let step = |sign: f64| {
                let mut moved = at.clone();
                moved[k] += sign * STEP;
                if !(0.0..=1.0).contains(&moved[k]) {
                    return Ok(None);
                }
                evaluator.values(0, &moved).map(Some)
            };
            Ok(Influence { steps: [step(-1.0)?, step(1.0)?] })
        };
        let influences = (0..at.len()).into_par_iter().map(beside).collect::<Result<Vec<_>, Stop>>()?;
        // The gradients of a design that violates a constraint do not balance those of the objective.
        let scale = Some(all.scale()).filter(|scale| *scale > 0.0 && values.violation <= FEASIBLE);
        let optimality = match scale {
            Some(scale) => optimality::certificate(evaluator, &at, scale)?,
            None => None,
        };
        Ok((influences, optimality))
    }

    /// Returns the description of the problem, without results.
    fn summary(&self, evaluator: &Evaluator<'_>) -> Result<Optimization, RunError> {
        let description = self.program.description();
        let column = |output: &str| {
            let index = output_of(description, output).map_err(RunError::Run)?;
            Ok::<Column, RunError>(Column::from(&description.outputs[index]))
        };
        let constraints = &self.problem.constraints;
        Ok(Optimization {
            model: description.name.clone(),
            doc: description.doc.clone(),
            variables: self.problem.variables.clone(),
            objective: self.problem.objective.clone(),
            column: column(&self.problem.objective.output)?,
            over_cases: self.problem.over_cases,
            over_samples: self.problem.samples().map(|count| (self.problem.over_samples, count)),
            constraints: constraints.clone(),
            constraint_columns: constraints
                .iter()
                .map(|constraint| column(&constraint.output))
                .collect::<Result<_, _>>()?,
            cases: evaluator.labels(),
            initial: Err("not evaluated".to_owned()),
            searches: Vec::new(),
            designs: Vec::new(),
            influences: Vec::new(),
            optimality: None,
            interrupted: false,
        })
    }
}
