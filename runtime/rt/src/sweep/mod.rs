//! Sweeps: a model solved at many values of its params, several cases at a time.
//!
//! Each finished case is a line of the journal, so a sweep that is interrupted or killed resumes. A
//! case gives the same numbers as a single run, bit for bit. All cases share the structures of
//! bodies that do not change. A case that fails is a row with its reason.

mod axis;
mod journal;

pub use axis::{Axis, MOST_CASES};
pub use calyx_report::sweep::SweepTable;
pub use journal::JOURNAL;

use crate::engine::Engine;
use crate::error::Error;
use crate::instance::Instance;
use crate::param_assignment::ParamAssignment;
use crate::params::InvalidParam;
use crate::program::Program;
use crate::results::Results;
use crate::run::RunError;
use calyx_abi::{Cancel, Status};
use calyx_report::directory::head;
use calyx_report::sweep::{Case, Column, Row, Statistics};
use calyx_runtime::settings_override::Override;
use journal::Journal;
use serde_json::json;
use std::collections::BTreeMap;
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
    /// Directory of the sweep, locked by the caller.
    pub directory: PathBuf,
    pub engine: Engine,
    /// Number of cases at a time.
    pub workers: usize,
    pub cancel: Cancel,
}

/// Outcome of a sweep.
pub enum Outcome {
    /// All cases, in order.
    Finished(Box<SweepTable>),
    /// It was cancelled; the same sweep resumes.
    Ended,
}

/// A solved case, with the columns of its outputs.
type Solved = (Row, Vec<Column>);

impl Sweep {
    /// Returns the indices of the varied params, and all cases.
    ///
    /// # Errors
    /// Two axes vary one param, or there are too many cases.
    pub fn cases(&self) -> Result<(Vec<usize>, Vec<Case>), Error> {
        let mut params: Vec<usize> = Vec::new();
        for &param in self.axes.iter().flat_map(|axis| &axis.params) {
            if params.contains(&param) {
                let name = &self.program.description().params[param].name;
                return Err(Error::Given(InvalidParam::new(
                    format!("two axes vary `{name}`"),
                    "give each param one list of values",
                )));
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

    fn instance(&self) -> Result<Instance, Error> {
        let mut instance = Instance::new(&self.engine, self.program.clone());
        for given in &self.given {
            instance.give(given)?;
        }
        instance.override_analysis(self.overrides);
        instance.set_cancel(self.cancel.clone());
        Ok(instance)
    }

    /// Solves all cases that no earlier call has solved. `done` is told the number of finished
    /// cases after each.
    ///
    /// # Errors
    /// An assigned value is invalid, or the journal cannot be written.
    pub fn run(&self, done: impl Fn(usize, usize) + Sync) -> Result<Outcome, RunError> {
        let (params, cases) = self.cases().map_err(RunError::Run)?;
        let base = self.instance().map_err(RunError::Run)?.params().map_err(RunError::Run)?;
        let description = self.program.description();
        let mut subject = head(description, &base, &self.overrides);
        let names: Vec<&str> = params.iter().map(|&param| description.params[param].name.as_str()).collect();
        let values: Vec<_> = cases.iter().map(|case| (&case.name, &case.values)).collect();
        subject["sweep"] = json!({ "params": names, "cases": values });
        let unwritable = |error| RunError::Io { path: self.directory.clone(), error };
        let (journal, earlier) = Journal::open(&self.directory, &subject).map_err(unwritable)?;
        let mut solved: BTreeMap<usize, Solved> = earlier
            .into_iter()
            .filter(|(row, _)| row.case <= cases.len())
            .map(|own| (own.0.case, own))
            .collect();
        let left: Vec<usize> = (1..=cases.len()).filter(|case| !solved.contains_key(case)).collect();
        let (next, finished) = (AtomicUsize::new(0), AtomicUsize::new(solved.len()));
        let found: Mutex<(Vec<Solved>, Option<RunError>)> = Mutex::default();
        done(solved.len(), cases.len());
        let work = || {
            while let Some(&number) = left.get(next.fetch_add(1, Ordering::Relaxed)) {
                let outcome = self.solve(&params, number, &cases[number - 1]).map_err(RunError::Run);
                let written = outcome.and_then(|own| match own {
                    Some(own) => journal.write(&own).map(|()| Some(own)).map_err(unwritable),
                    None => Ok(None),
                });
                let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
                match written {
                    Ok(Some(own)) => found.0.push(own),
                    Ok(None) => return,
                    Err(error) => {
                        found.1.get_or_insert(error);
                        return;
                    }
                }
                drop(found);
                done(finished.fetch_add(1, Ordering::Relaxed) + 1, cases.len());
            }
        };
        thread::scope(|scope| {
            for _ in 0..self.workers.clamp(1, left.len().max(1)) {
                scope.spawn(work);
            }
        });
        let (found, error) = found.into_inner().unwrap_or_else(PoisonError::into_inner);
        if let Some(error) = error {
            return Err(error);
        }
        solved.extend(found.into_iter().map(|own| (own.0.case, own)));
        if solved.len() < cases.len() {
            return Ok(Outcome::Ended);
        }
        let mut outputs: Vec<Column> = Vec::new();
        for column in solved.values().flat_map(|(_, columns)| columns) {
            if !outputs.iter().any(|known| known.name == column.name) {
                outputs.push(column.clone());
            }
        }
        Ok(Outcome::Finished(Box::new(SweepTable {
            model: description.name.clone(),
            doc: description.doc.clone(),
            params: params.iter().map(|&param| Column::from(&description.params[param])).collect(),
            outputs,
            cases,
            rows: solved.into_values().map(|(row, _)| row).collect(),
        })))
    }

    /// Solves a case; `None` if the sweep is cancelled.
    fn solve(&self, params: &[usize], number: usize, case: &Case) -> Result<Option<Solved>, Error> {
        let mut instance = self.instance()?;
        let description = self.program.description();
        let failed = |failure: String| {
            let row =
                Row { case: number, outputs: BTreeMap::new(), failure: Some(failure), warnings: Vec::new() };
            Ok(Some((row, Vec::new())))
        };
        let set = params.iter().zip(&case.values);
        let set = set.into_iter().try_for_each(|(&param, value)| {
            instance.set(description.params[param].name.as_str(), value.clone())
        });
        instance.on_print(|_| {});
        match set.and_then(|()| instance.solve()) {
            Ok(results) => Ok(Some(row_of(number, &results))),
            Err(Error::Model(error)) if error.status() == Status::Cancelled => Ok(None),
            Err(Error::Model(error)) => failed(format!("{}: {}", error.code, error.message)),
            Err(Error::Given(why)) => failed(why.message),
        }
    }
}

fn row_of(case: usize, results: &Results) -> Solved {
    let description = results.description();
    let columns: Vec<Column> = description.outputs.iter().map(Column::from).collect();
    let statistics = description.outputs.iter().zip(results.summaries());
    let outputs = statistics.map(|(output, summary)| (output.name.clone(), Statistics::of(summary)));
    let findings =
        results.findings().iter().map(|finding| format!("{}: {}", finding.error.code, finding.error.message));
    let warnings = findings.chain(results.warnings()).collect();
    (Row { case, outputs: outputs.collect(), failure: None, warnings }, columns)
}
