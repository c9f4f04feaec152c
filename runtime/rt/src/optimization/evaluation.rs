//! Evaluation of designs: all load cases and samples of each, and the journal of them.

use super::functions::{self, Shape};
use super::problem::{deviated, variable_of};
use super::{Optimizer, Problem, State};
use crate::error::Error;
use crate::instance::{Instance, NO_PARAMS};
use crate::results::Results;
use crate::run::RunError;
use crate::sweep::journal::{self, Journal, fingerprint};
use crate::sweep::{Sweep, Varied, fidelity_of};
use calyx_abi::Status;
use calyx_abi::description::ParamValue;
use calyx_report::directory::text_hash;
use calyx_report::optimization::{Constraint, Design, FEASIBLE, Measure, Search, Values, compare};
use calyx_report::study::Statistic;
use calyx_report::sweep::{Case, Column, Statistics};
use calyx_runtime::estimate::Estimates;
use calyx_runtime::scene::Fidelity;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use serde_json::{Value, json};
use std::cmp::Ordering;
use std::collections::{BTreeMap, HashMap};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

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

/// Line of the journal.
#[derive(Clone, Serialize, Deserialize)]
struct Line {
    /// Hash of the model and the settings: a journal keeps the lines of others, so that a return to
    /// them solves nothing again.
    subject: String,
    /// Values of all params, SI.
    params: Value,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    fidelity: Option<String>,
    /// Content of each table that the case has read, by name.
    tables: BTreeMap<String, String>,
    values: CaseValues,
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
        let lines = lines.into_iter().filter(current);
        let known = lines.map(|line| (journal::key(&line.params, line.fidelity.as_deref()), line.values));
        let known = Mutex::new(known.collect());
        let state = State { designs: 0, searches: [0, problem.effort.starts], best: None };
        Ok(Evaluator {
            optimizer,
            varied,
            cases,
            outputs,
            journal,
            subject,
            known,
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
        let Problem { objective, over_cases, over_samples, constraints, .. } = self.problem();
        let upper = !objective.maximize;
        let sign = if upper { 1.0 } else { -1.0 };
        let solutions = design.cases.iter().map(Vec::len).sum();
        let of_case = |cases: &[CaseValues], statistic, upper: bool, output: &str| -> Vec<f64> {
            let all =
                cases.iter().map(|case| functions::of(statistic, upper, (case, solutions), output, shape));
            match over_samples {
                Measure::Worst => all.flatten().collect(),
                measure => {
                    let sign = if upper { 1.0 } else { -1.0 };
                    let all = cases.iter().map(|case| sign * case.statistic(output, statistic));
                    vec![measure.of(&all.collect::<Vec<_>>())]
                }
            }
        };
        let (mut own, mut cases) = (Vec::new(), Vec::new());
        match over_cases {
            Measure::Worst => {
                for (k, case) in design.cases.iter().enumerate() {
                    let all = of_case(case, objective.statistic, upper, &objective.output);
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
            for (k, case) in design.cases.iter().enumerate() {
                let all = of_case(case, constraint.statistic, constraint.at_most, &constraint.output);
                let scaled =
                    all.into_iter().map(|value| (value - sign * constraint.bound) / self.scale(constraint));
                bounds.extend(scaled.map(|value| ((index, k), value)));
            }
        }
        Functions { objective: own, constraints: bounds, cases }
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

    /// Solves a load case and sample of a design, unless the journal has it.
    fn solve_case(
        &self,
        variables: &[f64],
        case: usize,
        sample: usize,
    ) -> Result<Result<CaseValues, String>, Stop> {
        if self.optimizer.cancel.is_cancelled() {
            return Err(Stop::Cancelled);
        }
        let prepared = self.instance(variables, case, sample).and_then(|instance| {
            let params = json!(instance.params()?);
            Ok((instance, params))
        });
        let (instance, params) = match prepared {
            Ok(prepared) => prepared,
            Err(error) => return Ok(Err(reason(&error))),
        };
        let fidelity = fidelity_of(&self.varied, &self.cases[case]).map(str::to_owned);
        let key = journal::key(&params, fidelity.as_deref());
        if let Some(known) = locked(&self.known).get(&key) {
            return Ok(Ok(known.clone()));
        }
        let results = match instance.solve() {
            Ok(results) => results,
            Err(Error::Model(error)) if error.status() == Status::Cancelled => return Err(Stop::Cancelled),
            Err(error) => return Ok(Err(reason(&error))),
        };
        let values = self.case_values(&results);
        let directory = self.optimizer.program.directory();
        let table = |name: &String| (name.clone(), fingerprint(directory.as_deref(), name));
        let tables = results.tables().iter().map(table).collect();
        let line = Line { subject: self.subject.clone(), params, fidelity, tables, values: values.clone() };
        if let Err(error) = self.journal.write(&line) {
            let path = self.optimizer.directory.join(EVALUATIONS);
            locked(&self.error).get_or_insert(RunError::Io { path, error });
            return Err(Stop::Unwritable);
        }
        locked(&self.known).insert(key, values.clone());
        Ok(Ok(values))
    }

    fn case_values(&self, results: &Results) -> CaseValues {
        let outputs = &results.description().outputs;
        let statistics = outputs.iter().zip(results.summaries());
        let statistics = statistics.map(|(output, summary)| (output.name.clone(), Statistics::of(summary)));
        let positions = |name: &String| {
            let all: Vec<f64> = results.steps().filter_map(|step| step.si(name.as_str()).ok()).collect();
            let is_whole = all.len() == results.steps().len() && all.iter().all(|value| value.is_finite());
            (name.clone(), if is_whole { all } else { Vec::new() })
        };
        CaseValues {
            statistics: statistics.collect(),
            positions: self.outputs.iter().map(positions).collect(),
        }
    }

    /// Returns the instance of a load case and sample of a design.
    fn instance(&self, variables: &[f64], case: usize, sample: usize) -> Result<Instance, Error> {
        let Optimizer { program, given, overrides, problem, engine, cancel, .. } = self.optimizer;
        let description = program.description();
        let mut instance = Instance::new(engine, program.clone());
        instance.request_sensitivities(NO_PARAMS)?;
        for given in given {
            instance.give(given)?;
        }
        let case = &self.cases[case];
        for (&varied, value) in self.varied.iter().zip(&case.values) {
            if let Varied::Param(index) = varied {
                instance.set(description.params[index].name.as_str(), value.clone())?;
            }
        }
        let mut values = variables.to_vec();
        if let Some(all) = &problem.sample {
            for (&varied, value) in all.params.iter().zip(&all.points[sample]) {
                match (variable_of(&problem.params, varied), varied) {
                    (Some(k), _) => values[k] = deviated(values[k], value),
                    (None, Varied::Param(index)) => {
                        instance.set(description.params[index].name.as_str(), value.clone())?;
                    }
                    (None, Varied::Fidelity) => {}
                }
            }
        }
        for (&index, value) in problem.params.iter().zip(&values) {
            instance.set_si(description.params[index].name.as_str(), *value)?;
        }
        let mut own = *overrides;
        own.fidelity = fidelity_of(&self.varied, case).and_then(Fidelity::named).or(overrides.fidelity);
        // Estimates of errors cost more than the values.
        own.error_estimates = own.error_estimates.or(Some(Estimates::None));
        instance.override_analysis(own);
        instance.set_cancel(cancel.clone());
        Ok(instance)
    }
}

fn reason(error: &Error) -> String {
    match error {
        Error::Model(error) => format!("{}: {}", error.code, error.message),
        Error::Given(why) => why.message.clone(),
    }
}
