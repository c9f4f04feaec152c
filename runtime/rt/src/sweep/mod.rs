//! Sweeps: a model solved at many values of its params, several cases at a time.
//!
//! Each solved case is a line of the journal, so a sweep that is interrupted or killed resumes. A
//! case gives the same numbers as a single run, bit for bit. All cases share the structures of
//! bodies that do not change. A case that fails is a row with its reason.

mod attempts;
mod axis;
mod case_file;
mod distribution;
mod duration;
pub(crate) mod journal;
pub mod objective;
pub mod plan;
pub mod sampling;
pub(crate) mod study_file;
mod tolerances;
mod varied;

pub(crate) use axis::check_units;
pub use axis::{Axis, MOST_CASES};
pub use calyx_report::durations::Durations;
pub use case_file::CaseFile;
pub use distribution::{Distribution, standard_normal_quantile};
pub use journal::JOURNAL;
pub use study_file::{Study, StudyFile};
pub use tolerances::{Sampling, Tolerance};
pub use varied::{FIDELITY, Varied};

use crate::engine::Engine;
use crate::error::Error;
use crate::instance::{Instance, NO_PARAMS};
use crate::param_assignment::ParamAssignment;
use crate::params::InvalidParam;
use crate::program::Program;
use crate::results::Results;
use crate::run::RunError;
use calyx_abi::description::ParamValue;
use calyx_abi::{Cancel, Status, stack};
use calyx_report::directory::head;
use calyx_report::study::{Objective, Sample};
use calyx_report::sweep::{Case, Column, Row, Statistics, SweepTable};
use calyx_runtime::scene::Fidelity;
use calyx_runtime::settings_override::Override;
use journal::{Journal, Line, fingerprint};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::num::NonZeroUsize;
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

/// A model and the cases that are solved.
pub struct Sweep {
    pub program: Arc<dyn Program>,
    /// Values assigned to params in all cases.
    pub given: Vec<ParamAssignment>,
    /// Overrides of the analysis settings.
    pub overrides: Override,
    /// Axes, of which the sweep has all combinations; the last one varies fastest.
    pub axes: Vec<Axis>,
    /// True if the first axis has the load cases of a file. Then the loads of meshes and bearings
    /// are recorded.
    pub load_cases: bool,
    /// Durations of the load cases, if they are a duty cycle.
    pub durations: Option<Durations>,
    /// Sample of toleranced params, if it is the last axis.
    pub sample: Option<Sample>,
    /// Objectives whose trade-off is shown: two, or none.
    pub objectives: Vec<Objective>,
    /// Directory of the sweep, locked by the caller.
    pub directory: PathBuf,
    pub engine: Engine,
    /// Number of cases at a time.
    pub workers: usize,
    pub cancel: Cancel,
}

/// Result of a sweep.
pub struct Outcome {
    /// Solved and failed cases, in order.
    pub table: SweepTable,
    /// Number of all cases. It is larger than that of the table if the sweep was cancelled; then
    /// the same sweep continues.
    pub count: usize,
    /// Number of cases that an earlier sweep has solved.
    pub earlier: usize,
}

/// Largest number of printed lines that are kept of a case.
const PRINTED_LINES: usize = 1000;
/// Number of cases per worker from which each worker has threads of its own: the time in which
/// those that have finished are idle is small then.
const MANY: usize = 8;

/// Lines that a model prints in a case.
#[derive(Clone, Default)]
struct Printed(Arc<Mutex<(Vec<String>, usize)>>);

impl Printed {
    fn collect(&self, instance: &mut Instance) {
        let Printed(all) = self.clone();
        instance.on_print(move |line| {
            let mut all = all.lock().unwrap_or_else(PoisonError::into_inner);
            if all.0.len() < PRINTED_LINES { all.0.push(line.to_owned()) } else { all.1 += 1 }
        });
    }

    fn lines(&self) -> Vec<String> {
        let (lines, more) = &*self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let more = (*more > 0).then(|| format!("({more} more lines)"));
        lines.iter().cloned().chain(more).collect()
    }
}

/// A solved case, with the columns of its outputs.
type Solved = (Row, Vec<Column>);

impl Sweep {
    /// Creates a sweep that varies nothing, on an engine with default settings.
    pub fn new(program: Arc<dyn Program>, directory: PathBuf) -> Sweep {
        Sweep {
            program,
            given: Vec::new(),
            overrides: Override::default(),
            axes: Vec::new(),
            load_cases: false,
            durations: None,
            sample: None,
            objectives: Vec::new(),
            directory,
            engine: Engine::default(),
            workers: 1,
            cancel: Cancel::default(),
        }
    }

    /// Returns what the sweep varies, and all cases.
    ///
    /// # Errors
    /// Two axes vary one param, a varied param is also set, a duty cycle has other axes, or there
    /// are too many cases.
    pub fn cases(&self) -> Result<(Vec<Varied>, Vec<Case>), Error> {
        if self.durations.is_some() && self.axes.len() > 1 {
            return Err(Error::Given(InvalidParam::new(
                "a duty cycle is combined with other axes",
                "set the other params with `--set`, one sweep with its own `--out` per value, or remove the column `duration`",
            )));
        }
        let description = self.program.description();
        let mut params: Vec<Varied> = Vec::new();
        for &param in self.axes.iter().flat_map(|axis| &axis.params) {
            let name = param.name(description);
            if params.contains(&param) {
                return Err(Error::Given(InvalidParam::new(
                    format!("two axes vary `{name}`"),
                    "give each param one list of values",
                )));
            }
            let is_set = match param {
                Varied::Param(_) => self.given.iter().any(|given| given.name == name),
                Varied::Fidelity => self.overrides.fidelity.is_some(),
            };
            if is_set {
                let help = match param {
                    Varied::Param(_) => "remove it from `--set` and the params file, or do not vary it",
                    Varied::Fidelity => "remove the option `--fidelity`, or do not vary it",
                };
                let message = format!("`{name}` is varied and also set to one value");
                return Err(Error::Given(InvalidParam::new(message, help)));
            }
            params.push(param);
        }
        let count = self.axes.iter().try_fold(1usize, |count, axis| count.checked_mul(axis.points.len()));
        if count.is_none_or(|count| count > MOST_CASES) {
            return Err(Error::Given(InvalidParam::new(
                format!("the axes have more than {MOST_CASES} combinations"),
                "give fewer values, or list the wanted cases in a file, `--cases`",
            )));
        }
        let mut cases = vec![Case { name: String::new(), values: Vec::new() }];
        for axis in &self.axes {
            let extended = |case: Case| {
                let point = |(k, values): (usize, &Vec<_>)| Case {
                    name: axis.names.get(k).unwrap_or(&case.name).clone(),
                    values: case.values.iter().chain(values).cloned().collect(),
                };
                axis.points.iter().enumerate().map(point).collect::<Vec<_>>()
            };
            cases = cases.into_iter().flat_map(extended).collect();
        }
        Ok((params, cases))
    }

    /// Returns all cases without solving them.
    ///
    /// # Errors
    /// Those of [`Sweep::cases`], or a value is invalid.
    pub fn planned(&self) -> Result<SweepTable, Error> {
        let (params, cases) = self.cases()?;
        for (number, case) in (1..).zip(&cases) {
            self.check(&params, number, case)?;
        }
        let rows = (1..=cases.len()).map(|case| (case, (Row { case, ..Row::default() }, Vec::new())));
        let rows = rows.collect();
        Ok(self.table(&params, cases, rows))
    }

    /// Checks the values of a case: ranges may depend on other params.
    fn check(&self, params: &[Varied], number: usize, case: &Case) -> Result<(), Error> {
        let checked = self.instance_of(params, case).and_then(|instance| instance.params());
        match checked {
            Err(Error::Given(why)) if why.origin.is_none() => {
                let message = format!("case {number}: {}", why.message);
                Err(Error::Given(InvalidParam { message, ..why }))
            }
            checked => checked.map(|_| ()),
        }
    }

    pub(crate) fn instance(&self) -> Result<Instance, Error> {
        let mut instance = Instance::new(&self.engine, self.program.clone());
        for given in &self.given {
            instance.give(given)?;
        }
        instance.override_analysis(self.overrides);
        // The tables of a sweep do not contain derivatives.
        instance.request_sensitivities(NO_PARAMS)?;
        instance.set_cancel(self.cancel.clone());
        Ok(instance)
    }

    /// Returns the values that a case assigns to params, and its overrides.
    pub fn given_in(&self, case: &Case) -> (Vec<ParamAssignment>, Override) {
        let params: Vec<Varied> = self.axes.iter().flat_map(|axis| axis.params.clone()).collect();
        let description = self.program.description();
        let varied = params.iter().zip(&case.values).filter(|(param, _)| **param != Varied::Fidelity);
        let varied =
            varied.map(|(param, value)| ParamAssignment::value(param.name(description), value.clone()));
        let given = self.given.iter().cloned().chain(varied).collect();
        (given, self.overrides_in(&params, case))
    }

    fn overrides_in(&self, params: &[Varied], case: &Case) -> Override {
        let fidelity = fidelity_of(params, case).and_then(Fidelity::named);
        Override { fidelity: fidelity.or(self.overrides.fidelity), ..self.overrides }
    }

    /// Returns the instance of a case.
    fn instance_of(&self, params: &[Varied], case: &Case) -> Result<Instance, Error> {
        let mut instance = self.instance()?;
        for (&param, value) in params.iter().zip(&case.values) {
            if let Varied::Param(index) = param {
                let name = self.program.description().params[index].name.as_str();
                instance.set(name, value.clone())?;
            }
        }
        instance.override_analysis(self.overrides_in(params, case));
        instance.request_component_loads(self.load_cases);
        Ok(instance)
    }

    /// Solves all cases that no earlier call has solved; failed ones are tried again. `done`
    /// receives the number of finished cases after each.
    ///
    /// # Errors
    /// A value of a case is out of range, before any case is solved, or the journal cannot be
    /// written.
    pub fn run(&self, done: impl Fn(usize, usize) + Sync) -> Result<Outcome, RunError> {
        let (params, cases) = self.cases().map_err(RunError::Run)?;
        self.check_all(&params, &cases).map_err(RunError::Run)?;
        let subject = self.subject().map_err(RunError::Run)?;
        let unwritable = |error| RunError::Io { path: self.directory.join(JOURNAL), error };
        let (journal, lines) = Journal::open(&self.directory.join(JOURNAL), &subject).map_err(unwritable)?;
        let mut solved = self.known(&params, &cases, lines);
        let earlier = solved.len();
        let left: Vec<usize> = (1..=cases.len()).filter(|case| !solved.contains_key(case)).collect();
        let finished = AtomicUsize::new(earlier);
        done(earlier, cases.len());
        let lines = self.solve_each(&params, &cases, &left, &|line| {
            journal.write(line).map_err(unwritable)?;
            done(finished.fetch_add(1, Ordering::Relaxed) + 1, cases.len());
            Ok(())
        })?;
        solved.extend(lines.into_iter().map(|line| (line.row.case, line.solved())));
        let count = cases.len();
        Ok(Outcome { table: self.table(&params, cases, solved), count, earlier })
    }

    /// Checks the values of all cases. Errors of the model are those of its case, when it is
    /// solved.
    fn check_all(&self, params: &[Varied], cases: &[Case]) -> Result<(), Error> {
        on_large_stack(&|| {
            for (number, case) in (1..).zip(cases) {
                match self.check(params, number, case) {
                    Err(error @ Error::Given(_)) => return Err(error),
                    _ if self.cancel.is_cancelled() => break,
                    _ => {}
                }
            }
            Ok(())
        })
    }

    /// Returns the description of what the journals record: the model, and settings of all cases.
    pub(crate) fn subject(&self) -> Result<Value, Error> {
        let base = self.instance()?.params()?;
        let mut subject = head(self.program.description(), &base, &self.overrides);
        if let Some(subject) = subject.as_object_mut() {
            subject.remove("params");
            subject.insert("journal".to_owned(), json!(journal::FORMAT));
        }
        Ok(subject)
    }

    /// Solves cases, several at a time, until all are solved or the sweep is cancelled. `write`
    /// receives each line.
    ///
    /// # Errors
    /// The first error of `write`.
    fn solve_each(
        &self,
        params: &[Varied],
        cases: &[Case],
        numbers: &[usize],
        write: &(dyn Fn(&Line) -> Result<(), RunError> + Sync),
    ) -> Result<Vec<Line>, RunError> {
        let next = AtomicUsize::new(0);
        let found: Mutex<(Vec<Line>, Option<RunError>)> = Mutex::default();
        let work = || {
            let engine = self.engine_of_worker(numbers.len());
            while let Some(&number) = numbers.get(next.fetch_add(1, Ordering::Relaxed)) {
                let solved = self.solve(params, (number, &cases[number - 1]), &engine);
                let Some(line) = solved else { return };
                let written = write(&line);
                let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
                match written {
                    Ok(()) => found.0.push(line),
                    Err(error) => {
                        found.1.get_or_insert(error);
                        return;
                    }
                }
            }
        };
        thread::scope(|scope| {
            for _ in 0..self.workers.clamp(1, numbers.len().max(1)) {
                scope.spawn(|| on_large_stack(&work));
            }
        });
        let (lines, error) = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        error.map_or(Ok(lines), Err)
    }

    /// Returns the engine of a worker for a number of cases. Of many cases, each worker solves its
    /// own with its part of the threads, and none waits for another; the last of few cases has all
    /// threads.
    fn engine_of_worker(&self, cases: usize) -> Engine {
        if self.workers <= 1 || cases < MANY * self.workers {
            return self.engine.clone();
        }
        let threads = match self.engine.config().threads {
            0 => thread::available_parallelism().map_or(1, NonZeroUsize::get),
            threads => threads,
        };
        self.engine.with_threads((threads / self.workers).max(1))
    }

    fn table(&self, params: &[Varied], cases: Vec<Case>, solved: BTreeMap<usize, Solved>) -> SweepTable {
        let description = self.program.description();
        let mut outputs: Vec<Column> = Vec::new();
        for column in solved.values().flat_map(|(_, columns)| columns) {
            if !outputs.iter().any(|known| known.name == column.name) {
                outputs.push(column.clone());
            }
        }
        let (mut before, mut logarithmic) = (0, Vec::new());
        for axis in &self.axes {
            logarithmic.extend(axis.logarithmic.then_some(before));
            before += axis.params.len();
        }
        let cases = cases.into_iter().enumerate().filter(|(k, _)| solved.contains_key(&(k + 1)));
        SweepTable {
            model: description.name.clone(),
            doc: description.doc.clone(),
            params: params.iter().map(|param| param.column(description)).collect(),
            outputs,
            cases: cases.map(|(_, case)| case).collect(),
            rows: solved.into_values().map(|(row, _)| row).collect(),
            units: description.units.clone(),
            logarithmic,
            load_cases: self.load_cases,
            durations: self.durations.clone(),
            sample: self.sample.clone(),
            objectives: self.objectives.clone(),
        }
    }

    /// Returns the cases that the lines of a journal have solved, by their numbers.
    fn known(&self, params: &[Varied], cases: &[Case], lines: Vec<Line>) -> BTreeMap<usize, Solved> {
        let directory = self.program.directory();
        let mut hashes: BTreeMap<String, String> = BTreeMap::new();
        let mut by_params: BTreeMap<String, Line> = BTreeMap::new();
        // A case that was solved without `--cases` has no loads.
        let is_complete =
            |line: &Line| line.row.failure.is_none() && (!self.load_cases || line.row.components.is_some());
        for line in lines.into_iter().filter(is_complete) {
            let current = line.tables.iter().all(|(table, known)| {
                let hash = hashes.entry(table.clone());
                hash.or_insert_with(|| fingerprint(directory.as_deref(), table)) == known
            });
            if current {
                by_params.insert(line.key(), line);
            }
        }
        let mut solved = BTreeMap::new();
        if by_params.is_empty() {
            return solved;
        }
        let key = |case: &Case| {
            let values = self.instance_of(params, case).and_then(|instance| instance.params());
            values.map(|values| journal::key(&json!(values), fidelity_of(params, case)))
        };
        let keys = on_large_stack(&|| cases.iter().map(key).collect::<Vec<_>>());
        for (k, key) in keys.into_iter().enumerate() {
            if let Some(line) = key.ok().and_then(|key| by_params.remove(&key)) {
                solved.insert(k + 1, line.of_case(k + 1).solved());
            }
        }
        solved
    }

    /// Solves a case; `None` if the sweep is cancelled.
    fn solve(&self, params: &[Varied], (number, case): (usize, &Case), engine: &Engine) -> Option<Line> {
        let printed = Printed::default();
        let solved = self.instance_of(params, case).and_then(|mut instance| {
            instance.set_engine(engine);
            let values = json!(instance.params()?);
            printed.collect(&mut instance);
            Ok((values, instance.solve()?))
        });
        let failure = match solved {
            Ok((values, results)) => {
                let fidelity = fidelity_of(params, case).map(str::to_owned);
                return Some(self.line(number, (values, fidelity), &results, printed.lines()));
            }
            Err(Error::Model(error)) if error.status() == Status::Cancelled => return None,
            Err(Error::Model(error)) => format!("{}: {}", error.code, error.message),
            Err(Error::Given(why)) => why.message,
        };
        let row = Row { case: number, failure: Some(failure), printed: printed.lines(), ..Row::default() };
        Some(Line { params: Value::Null, fidelity: None, tables: BTreeMap::new(), row, columns: Vec::new() })
    }

    /// Returns the line of a solved case.
    fn line(
        &self,
        case: usize,
        (params, fidelity): (Value, Option<String>),
        results: &Results,
        printed: Vec<String>,
    ) -> Line {
        let description = results.description();
        let columns = description.outputs.iter().map(Column::from);
        let statistics = description.outputs.iter().zip(results.summaries());
        let outputs = statistics.map(|(output, summary)| (output.name.clone(), Statistics::of(summary)));
        let findings = results.findings().iter();
        let findings = findings.map(|finding| format!("{}: {}", finding.error.code, finding.error.message));
        let search = results.analysis().and_then(|result| result.tolerance_search.as_ref());
        let missed = search.is_some_and(|search| search.ended.is_some());
        // A model without an analysis has no loads.
        let components = results.analysis().and_then(|result| result.component_loads.as_ref());
        let row = Row {
            case,
            outputs: outputs.collect(),
            failure: missed.then(|| "the results do not meet the tolerance".to_owned()),
            warnings: findings.chain(results.warnings()).collect(),
            components: self.load_cases.then(|| components.cloned().unwrap_or_default()),
            printed,
        };
        let directory = self.program.directory();
        let table = |name: &String| (name.clone(), fingerprint(directory.as_deref(), name));
        let tables = results.tables().iter().map(table).collect();
        Line { params, fidelity, tables, row, columns: columns.collect() }
    }
}

/// Calls a function for many cases on one large stack. Otherwise, each evaluation of a model starts
/// a thread for its stack, which takes longer than a quick case.
fn on_large_stack<R: Send>(function: &(dyn Fn() -> R + Sync)) -> R {
    // Without such a thread, each case fails with the reason.
    stack::with_stack(function).unwrap_or_else(|_| function())
}

/// Returns the fidelity level of a case, if it is an axis.
pub(crate) fn fidelity_of<'c>(params: &[Varied], case: &'c Case) -> Option<&'c str> {
    let at = params.iter().position(|param| *param == Varied::Fidelity)?;
    match case.values.get(at)? {
        ParamValue::String(level) => Some(level),
        _ => None,
    }
}
