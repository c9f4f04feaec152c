//! Evaluation of designs: all load cases and samples of each, and the journal of them.

mod cases;

use super::functions::{self, Shape};
use super::{Optimizer, Problem, State};
use crate::run::RunError;
use crate::sweep::journal::{self, Journal, fingerprint};
use crate::sweep::{Sweep, Varied};
use calyx_abi::description::ParamValue;
use calyx_report::directory::text_hash;
use calyx_report::optimization::{Constraint, Design, FEASIBLE, Measure, Search, Values, compare};
use calyx_report::study::Statistic;
use calyx_report::sweep::{Case, Column, Statistics};
use cases::{KnownSlopes, Line};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

/// File name of the journal.
pub const EVALUATIONS: &str = "evaluations.jsonl";
/// Format of the journal. A journal of another format is replaced.
const FORMAT: u32 = 1;

/// Reason for the end of an optimization.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stop {
    Cancelled,
    Unwritable,
}

/// Values of one load case and sample at a design.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct CaseValues {
    /// Statistics by output, SI.
    pub statistics: BTreeMap<String, Statistics>,
    /// Values by position of the outputs of objective and constraints, SI; empty if one is missing.
    pub positions: BTreeMap<String, Vec<f64>>,
}

impl CaseValues {
    /// Returns a statistic; NaN without a value.
    pub fn statistic(&self, output: &str, statistic: Statistic) -> f64 {
        self.statistics.get(output).and_then(|all| all.get(statistic)).unwrap_or(f64::NAN)
    }
}

/// Functions of a design, each divided by its scale.
#[derive(Clone, Debug)]
pub struct Functions {
    /// Their largest value is the objective, to be minimized.
    pub objective: Vec<f64>,
    /// Negative or zero if the constraints are met, by constraint and load case.
    pub constraints: Vec<((usize, usize), f64)>,
    /// Load case of each function of the objective.
    pub cases: Vec<usize>,
}

/// Design that was evaluated, with the values of its load cases by case and sample.
struct Evaluated {
    cases: Vec<Vec<CaseValues>>,
    values: Values,
}

type Memo = HashMap<Vec<u64>, Arc<Result<Evaluated, String>>>;

/// Evaluator of the designs of a problem.
pub struct Evaluator<'o> {
    optimizer: &'o Optimizer,
    /// Quantities that the load cases vary.
    varied: Vec<Varied>,
    cases: Vec<Case>,
    /// Outputs of objective and constraints.
    outputs: Vec<String>,
    journal: Journal,
    subject: String,
    known: Mutex<HashMap<String, CaseValues>>,
    known_slopes: Mutex<HashMap<String, KnownSlopes>>,
    /// Names of the variables with exact derivatives, once they have been found.
    exact: OnceLock<Vec<String>>,
    memo: Mutex<Memo>,
    designs: Mutex<Vec<Design>>,
    state: Mutex<State>,
    error: Mutex<Option<RunError>>,
    done: &'o (dyn Fn(&State) + Sync),
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl<'o> Evaluator<'o> {
    /// Opens the journal and checks the load cases.
    ///
    /// # Errors
    /// A value of a load case is invalid, or the journal cannot be written.
    pub fn new(
        optimizer: &'o Optimizer,
        done: &'o (dyn Fn(&State) + Sync),
    ) -> Result<Evaluator<'o>, RunError> {
        let problem = &optimizer.problem;
        let sweep = Sweep {
            given: optimizer.given.clone(),
            overrides: optimizer.overrides,
            axes: problem.axes.clone(),
            engine: optimizer.engine.clone(),
            ..Sweep::new(optimizer.program.clone(), optimizer.directory.clone())
        };
        let (varied, cases) = sweep.cases().map_err(RunError::Run)?;
        sweep.planned().map_err(RunError::Run)?;
        let subject = text_hash(&sweep.subject().map_err(RunError::Run)?.to_string());
        let mut outputs = vec![problem.objective.output.clone()];
        outputs.extend(problem.constraints.iter().map(|constraint| constraint.output.clone()));
        outputs.sort();
        outputs.dedup();
        let path = optimizer.directory.join(EVALUATIONS);
        let opened = Journal::open(&path, &json!({ "optimization": FORMAT }));
        let (journal, lines) = opened.map_err(|error| RunError::Io { path, error })?;
        let directory = optimizer.program.directory();
        let current = |line: &Line| {
            line.subject == subject
                && line.tables.iter().all(|(table, known)| fingerprint(directory.as_deref(), table) == *known)
                && outputs.iter().all(|output| line.values.positions.contains_key(output))
        };
        let (mut known, mut known_slopes) = (HashMap::new(), HashMap::new());
        for line in lines.into_iter().filter(current) {
            let key = journal::key(&line.params, line.fidelity.as_deref());
            if let Some(slopes) = line.slopes {
                known_slopes.insert(key.clone(), slopes);
            }
            known.insert(key, line.values);
        }
        let (known, known_slopes) = (Mutex::new(known), Mutex::new(known_slopes));
        let state = State { designs: 0, searches: [0, problem.effort.starts], best: None };
        Ok(Evaluator {
            optimizer,
            varied,
            cases,
            outputs,
            journal,
            subject,
            known,
            known_slopes,
            exact: OnceLock::new(),
            memo: Mutex::default(),
            designs: Mutex::default(),
            state: Mutex::new(state),
            error: Mutex::default(),
            done,
        })
    }

    pub fn problem(&self) -> &Problem {
        &self.optimizer.problem
    }

    /// Returns a label for each load case.
    pub fn labels(&self) -> Vec<String> {
        let description = self.optimizer.program.description();
        let label = |(k, case): (usize, &Case)| {
            if !case.name.is_empty() {
                return case.name.clone();
            }
            let value = |(varied, value): (&Varied, &ParamValue)| {
                let column = varied.column(description);
                let unit = if column.unit == "1" { "" } else { column.unit.as_str() };
                format!("{} = {} {unit}", column.name, column.shown(value)).trim_end().to_owned()
            };
            let values: Vec<String> = self.varied.iter().zip(&case.values).map(value).collect();
            if values.is_empty() { format!("case {}", k + 1) } else { values.join(", ") }
        };
        self.cases.iter().enumerate().map(label).collect()
    }

    /// Returns the values of a design of a search, or the reason of its failure.
    ///
    /// # Errors
    /// The optimization is cancelled, or the journal cannot be written.
    pub fn values(&self, search: usize, at: &[f64]) -> Result<Result<Values, String>, Stop> {
        let evaluated = self.evaluate(search, at)?;
        Ok(evaluated.as_ref().as_ref().map(|design| design.values.clone()).map_err(Clone::clone))
    }

    /// Returns the functions of a design of a search, `scale` being that of the objective; `None`
    /// if it failed.
    ///
    /// # Errors
    /// The optimization is cancelled, or the journal cannot be written.
    pub fn functions(
        &self,
        search: usize,
        at: &[f64],
        shape: Shape,
        scale: f64,
    ) -> Result<Option<Functions>, Stop> {
        let evaluated = self.evaluate(search, at)?;
        Ok(evaluated.as_ref().as_ref().ok().map(|design| self.functions_of(design, shape, scale)))
    }

    fn functions_of(&self, design: &Evaluated, shape: Shape, scale: f64) -> Functions {
        let Problem { objective, over_cases, constraints, .. } = self.problem();
        let sign = if objective.maximize { -1.0 } else { 1.0 };
        let (mut own, mut cases) = (Vec::new(), Vec::new());
        match over_cases {
            Measure::Worst => {
                for (k, all) in self.objective_functions(&design.cases, shape).into_iter().enumerate() {
                    cases.resize(cases.len() + all.len(), k);
                    own.extend(all.into_iter().map(|value| value / scale));
                }
            }
            _ => {
                own.push(sign * design.values.objective / scale);
                cases.push(0);
            }
        }
        let mut bounds = Vec::new();
        for (index, constraint) in constraints.iter().enumerate() {
            let sign = if constraint.at_most { 1.0 } else { -1.0 };
            let functions = self.constraint_functions(constraint, &design.cases, shape);
            for (k, all) in functions.into_iter().enumerate() {
                let scaled =
                    all.into_iter().map(|value| (value - sign * constraint.bound) / self.scale(constraint));
                bounds.extend(scaled.map(|value| ((index, k), value)));
            }
        }
        Functions { objective: own, constraints: bounds, cases }
    }

    /// Returns the functions of the objective by load case, without scale.
    fn objective_functions(&self, cases: &[Vec<CaseValues>], shape: Shape) -> Vec<Vec<f64>> {
        let Problem { objective, .. } = self.problem();
        let of = (objective.statistic, !objective.maximize, objective.output.as_str());
        self.case_functions(of, cases, shape)
    }

    /// Returns the functions of a constraint by load case, without bound and scale.
    fn constraint_functions(
        &self,
        constraint: &Constraint,
        cases: &[Vec<CaseValues>],
        shape: Shape,
    ) -> Vec<Vec<f64>> {
        let of = (constraint.statistic, constraint.at_most, constraint.output.as_str());
        self.case_functions(of, cases, shape)
    }

    fn case_functions(
        &self,
        (statistic, upper, output): (Statistic, bool, &str),
        cases: &[Vec<CaseValues>],
        shape: Shape,
    ) -> Vec<Vec<f64>> {
        let solutions = cases.iter().map(Vec::len).sum();
        let of_case = |cases: &Vec<CaseValues>| -> Vec<f64> {
            let all =
                cases.iter().map(|case| functions::of(statistic, upper, (case, solutions), output, shape));
            match self.problem().over_samples {
                Measure::Worst => all.flatten().collect(),
                measure => {
                    let sign = if upper { 1.0 } else { -1.0 };
                    let all = cases.iter().map(|case| sign * case.statistic(output, statistic));
                    vec![measure.of(&all.collect::<Vec<_>>())]
                }
            }
        };
        cases.iter().map(of_case).collect()
    }

    /// Returns the functions of the objective and then those of the constraints, as in
    /// [`Evaluator::functions`] but without bounds, of values that replace those of the load cases.
    pub(super) fn linear_functions(&self, cases: &[Vec<CaseValues>], shape: Shape, scale: f64) -> Vec<f64> {
        let mut all: Vec<f64> =
            self.objective_functions(cases, shape).into_iter().flatten().map(|value| value / scale).collect();
        for constraint in &self.problem().constraints {
            let functions = self.constraint_functions(constraint, cases, shape);
            all.extend(functions.into_iter().flatten().map(|value| value / self.scale(constraint)));
        }
        all
    }

    /// Returns the magnitude of a constraint.
    fn scale(&self, constraint: &Constraint) -> f64 {
        let outputs = &self.optimizer.program.description().outputs;
        let output = outputs.iter().find(|output| output.name == constraint.output);
        output.map_or(1.0, |output| constraint.magnitude(&Column::from(output)))
    }

    /// Returns the unit of the objective, SI.
    pub fn unit(&self) -> f64 {
        let outputs = &self.optimizer.program.description().outputs;
        let output = outputs.iter().find(|output| output.name == self.problem().objective.output);
        output.map_or(1.0, |output| output.unit.factor.abs())
    }

    fn evaluate(&self, search: usize, at: &[f64]) -> Result<Arc<Result<Evaluated, String>>, Stop> {
        let variables = self.problem().values_at(at);
        let key: Vec<u64> = variables.iter().map(|value| value.to_bits()).collect();
        let memorized = locked(&self.memo).get(&key).cloned();
        let evaluated = match memorized {
            Some(known) => known,
            None => {
                let found = Arc::new(self.solve(&variables)?);
                locked(&self.memo).insert(key, found.clone());
                found
            }
        };
        self.record(search, variables, &evaluated);
        Ok(evaluated)
    }

    /// Notes a design of a search, unless the search has had it.
    fn record(&self, search: usize, variables: Vec<f64>, evaluated: &Result<Evaluated, String>) {
        let values = evaluated.as_ref().map(|design| design.values.clone()).map_err(Clone::clone);
        let mut designs = locked(&self.designs);
        if designs.iter().any(|known| known.search == search && known.variables == variables) {
            return;
        }
        let mut state = locked(&self.state);
        state.designs += 1;
        if let Ok(values) = &values {
            let best = designs.iter().filter_map(|design| design.values.as_ref().ok()).chain([values]);
            let best = best.min_by(|one, other| compare(&self.problem().objective, one, other));
            state.best = best.filter(|best| best.violation <= FEASIBLE).map(|best| best.objective);
        }
        designs.push(Design { search, variables, values });
        drop(designs);
        (self.done)(&state);
    }

    /// Returns the values of a design that was evaluated.
    pub fn evaluated(&self, at: &[f64]) -> Option<Result<Values, String>> {
        let variables = self.problem().values_at(at);
        let designs = locked(&self.designs);
        designs.iter().find(|design| design.variables == variables).map(|design| design.values.clone())
    }

    /// Returns the number of different designs of a search.
    pub fn count(&self, search: usize) -> usize {
        locked(&self.designs).iter().filter(|design| design.search == search).count()
    }

    /// Counts further searches.
    pub fn add_searches(&self, count: usize) {
        locked(&self.state).searches[1] += count;
    }

    /// Counts a search that has ended.
    pub fn end_search(&self) {
        let mut state = locked(&self.state);
        state.searches[0] += 1;
        (self.done)(&state);
    }

    /// Returns all designs by search, in an order that does not depend on the threads.
    pub fn designs(&self) -> Vec<Design> {
        let mut designs = locked(&self.designs).clone();
        let variables = |design: &Design| design.variables.clone();
        designs.sort_by(|one, other| {
            let order = one.search.cmp(&other.search);
            // Those of a search follow each other; the others were evaluated in parallel.
            if one.search > 0 {
                return order;
            }
            let pairs = variables(one).into_iter().zip(variables(other));
            order.then(
                pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(Ordering::Equal),
            )
        });
        designs
    }

    /// Returns the searches of an interrupted optimization, from their designs so far.
    pub fn searches(&self) -> Vec<Search> {
        let designs = self.designs();
        let [_, count] = locked(&self.state).searches;
        let search = |number: usize| {
            let own: Vec<&Design> = designs.iter().filter(|design| design.search == number).collect();
            let known =
                own.iter().filter_map(|design| Some((&design.variables, design.values.as_ref().ok()?)));
            let best = known.min_by(|one, other| compare(&self.problem().objective, one.1, other.1));
            Search {
                number,
                start: own.first().map(|design| design.variables.clone()).unwrap_or_default(),
                best: best.map(|(variables, values)| (variables.clone(), values.clone())),
                designs: own.len(),
                converged: false,
            }
        };
        // Before the first search, the designs of the starts count.
        let first = if designs.iter().any(|design| design.search > 0) { 1 } else { 0 };
        (first..=if first == 0 { 0 } else { count }).map(search).filter(|search| search.designs > 0).collect()
    }

    /// Returns the error behind the end of an optimization.
    pub fn failure(&self, stop: Stop) -> RunError {
        let path = self.optimizer.directory.join(EVALUATIONS);
        let other = || RunError::Io { path, error: std::io::Error::other(format!("{stop:?}")) };
        locked(&self.error).take().unwrap_or_else(other)
    }

    /// Solves all load cases and samples of a design.
    fn solve(&self, variables: &[f64]) -> Result<Result<Evaluated, String>, Stop> {
        let samples = self.problem().samples().unwrap_or(1);
        let jobs: Vec<(usize, usize)> =
            (0..self.cases.len()).flat_map(|case| (0..samples).map(move |sample| (case, sample))).collect();
        let solved = jobs.into_par_iter().map(|(case, sample)| self.solve_case(variables, case, sample));
        let solved: Vec<Result<CaseValues, String>> = solved.collect::<Result<_, Stop>>()?;
        let mut all = Vec::with_capacity(solved.len());
        for (k, case) in solved.into_iter().enumerate() {
            match case {
                Ok(values) => all.push(values),
                Err(reason) => {
                    let label = &self.labels()[k / samples];
                    return Ok(Err(if self.cases.len() > 1 { format!("{label}: {reason}") } else { reason }));
                }
            }
        }
        let mut by_case: Vec<Vec<CaseValues>> = Vec::with_capacity(self.cases.len());
        let mut rest = all.into_iter();
        for _ in 0..self.cases.len() {
            by_case.push(rest.by_ref().take(samples).collect());
        }
        Ok(match self.measured(&by_case) {
            Some(values) => Ok(Evaluated { cases: by_case, values }),
            None => Err("an output has no value".to_owned()),
        })
    }

    /// Returns the objective and the constrained values; `None` if one has no value.
    fn measured(&self, cases: &[Vec<CaseValues>]) -> Option<Values> {
        let Problem { objective, over_cases, over_samples, constraints, .. } = self.problem();
        let by_case = |output: &str, statistic, upper: bool| -> Option<Vec<f64>> {
            let sign = if upper { 1.0 } else { -1.0 };
            let of_case = |samples: &Vec<CaseValues>| {
                let all: Vec<f64> =
                    samples.iter().map(|case| sign * case.statistic(output, statistic)).collect();
                let value = over_samples.of(&all);
                value.is_finite().then_some(sign * value)
            };
            cases.iter().map(of_case).collect()
        };
        let upper = !objective.maximize;
        let sign = if upper { 1.0 } else { -1.0 };
        let own = by_case(&objective.output, objective.statistic, upper)?;
        let costs: Vec<f64> = own.iter().map(|value| sign * value).collect();
        let mut violation = f64::NEG_INFINITY;
        let mut constrained = Vec::with_capacity(constraints.len());
        for constraint in constraints {
            let values = by_case(&constraint.output, constraint.statistic, constraint.at_most)?;
            let sign = if constraint.at_most { 1.0 } else { -1.0 };
            let off = |value: &f64| sign * (value - constraint.bound) / self.scale(constraint);
            violation = values.iter().map(off).fold(violation, f64::max);
            constrained.push(values);
        }
        let violation = if constraints.is_empty() { 0.0 } else { violation };
        let objective = sign * over_cases.of(&costs);
        Some(Values { objective, cases: own, constraints: constrained, violation })
    }

    /// Returns the names of the variables with exact derivatives.
    pub(super) fn exact_variables(&self) -> &[String] {
        self.exact.get().map_or(&[], Vec::as_slice)
    }

    pub(super) fn set_exact_variables(&self, names: Vec<String>) {
        self.exact.get_or_init(|| names);
    }

    /// Returns the number of load cases.
    pub(super) fn case_count(&self) -> usize {
        self.cases.len()
    }
}
