//! A run for people and for those who read its directory: an instance, watched and written down.

use crate::directory::{
    Details, REPORT, Record, StageTimes, Stages, head, prepare, write_run, write_unfinished,
};
use crate::engine::Engine;
use crate::error::Error;
use crate::given::Given;
use crate::instance::Instance;
use crate::journal::{self, Found};
use crate::program::Program;
use crate::progress::{Progress, ProgressFormat};
use crate::results::Results;
use crate::resume::{self, Begun};
use crate::{modes_table, page, signals, table};
use calyx_abi::description::OutputDescription;
use calyx_abi::{Cancel, Status};
use calyx_gears::host::Finding;
use calyx_runtime::error::EngineError;
use calyx_runtime::observe::Fields;
use calyx_runtime::overriding::Override;
use calyx_runtime::results::Solved;
use serde_json::Value;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// What a run is to do.
#[derive(Clone, Debug, Default)]
pub struct RunOptions {
    pub engine: Engine,
    /// Where results go.
    pub directory: PathBuf,
    /// Values given for params; the last of a name counts.
    pub given: Vec<Given>,
    /// Nothing but what the program prints, and errors.
    pub quiet: bool,
    /// How progress is shown; for people it is silent if `quiet`.
    pub progress: ProgressFormat,
    /// What the program prints goes to standard error.
    pub print_to_error: bool,
    /// What went before, for `timing.json`.
    pub before: StageTimes,
    /// How long the run may take.
    pub time_limit: Option<Duration>,
    /// Bytes that it may take: of the program's values, and of the process while it analyses.
    pub memory_limit: Option<u64>,
    /// Goes on after the positions that an earlier run completed.
    pub resume: bool,
    /// Writes the fields of every position as tables.
    pub fields: bool,
    /// Writes pictures of every position for ParaView.
    pub vtu: bool,
    /// What takes the place of what the model says of its analysis.
    pub overrides: Override,
    /// Set from outside, it ends the run soon; what was written is kept.
    pub cancel: Cancel,
}

impl RunOptions {
    fn details(&self) -> Details {
        Details { tables: self.fields, pictures: self.vtu }
    }
}

/// Why a run did not finish.
#[derive(Debug)]
pub enum RunError {
    /// What was given, the model or its analysis.
    Run(Error),
    Io {
        path: PathBuf,
        error: io::Error,
    },
}

/// What a finished run says for people.
#[derive(Default)]
pub struct RunReport {
    /// The table of outputs; empty for a model without an analysis.
    pub summary: String,
    /// What deserves a second look.
    pub warnings: Vec<String>,
    /// What the library found, with places in the source.
    pub findings: Vec<Finding>,
    /// An earlier run had done everything; this one did nothing.
    pub finished_before: bool,
}

/// Runs a model and writes its run directory.
pub fn run(program: Arc<dyn Program>, options: &RunOptions) -> Result<RunReport, RunError> {
    let directory = options.directory.as_path();
    let unwritable = |error| RunError::Io { path: directory.to_owned(), error };
    let mut instance = Instance::new(&options.engine, program.clone());
    for given in &options.given {
        instance.give(given).map_err(RunError::Run)?;
    }
    instance.limit_time(options.time_limit);
    instance.limit_memory(options.memory_limit);
    instance.set_cancel(options.cancel.clone());
    instance.override_analysis(options.overrides);
    let params = instance.params().map_err(RunError::Run)?;
    let description = program.description();
    let head = head(description, &params, &options.overrides);
    let progress = Arc::new(Progress::new(options.progress, options.quiet, options.print_to_error));
    let found = match earlier(options, &head)? {
        Begun::Finished => {
            progress.finish();
            // It may have been ended before its last file.
            if !directory.join(REPORT).exists() {
                page::write(directory).map_err(unwritable)?;
            }
            return Ok(RunReport { finished_before: true, ..RunReport::default() });
        }
        Begun::Unfinished(found) => {
            let count = found.solved.len();
            progress.note(&format!("going on after {count} positions of the run in {}", directory.display()));
            instance.begin_after(found.solved.clone());
            Some(found)
        }
        Begun::Nothing => {
            if options.resume {
                let directory = directory.display();
                progress.note(&format!("there is nothing to go on with in {directory}: the run begins anew"));
            }
            prepare(directory).map_err(unwritable)?;
            None
        }
    };
    let (shown, printed) = (progress.clone(), progress.clone());
    instance.on_progress(move |now| match now.total {
        Some(count) => shown.step(now.done - 1, count),
        None => shown.stage(now.stage),
    });
    instance.on_print(move |line| printed.print(line));
    let (solved, outcome) =
        write_steps(instance, directory, &head, found.as_ref(), (options.details(), progress.clone()));
    progress.finish();
    // What was solved until somebody ended the run is worth keeping, with what it is of.
    if let Err(RunError::Run(Error::Model(error))) = &outcome
        && error.status() == Status::Cancelled
        && solved > 0
    {
        write_unfinished(directory, head.clone(), solved, error).map_err(unwritable)?;
        page::write(directory).map_err(unwritable)?;
    }
    let results = outcome?;
    let stages = Stages {
        before: options.before.clone(),
        program: results.time(),
        solved_before: found.as_ref().map_or(0, |found| found.solved.len()),
    };
    let all_warnings = results.warnings();
    let findings = results.findings().iter();
    let mut written: Vec<String> =
        findings.map(|finding| format!("{}: {}", finding.error.code, finding.error.message)).collect();
    written.extend(all_warnings.iter().cloned());
    let result = results.analysis();
    let modes = result.and_then(|result| result.modes.as_ref());
    modes.map_or(Ok(()), |modes| modes_table::write(directory, modes)).map_err(unwritable)?;
    signals::write(directory, description, results.signals()).map_err(unwritable)?;
    let listed = signals::list(description, results.signals());
    write_run(directory, head, description, result, listed, &written, &stages).map_err(unwritable)?;
    journal::remove(directory).map_err(unwritable)?;
    page::write(directory).map_err(unwritable)?;
    let ignored = result.iter().flat_map(|result| &result.plan.ignored);
    let ignored =
        ignored.map(|ignored| format!("`{}` is not seen as given: {}", ignored.input, ignored.reason));
    Ok(RunReport {
        summary: result.map(|result| table::summary(description, result)).unwrap_or_default()
            + &modes.map(modes_table::summary).unwrap_or_default()
            + &signals::summary(description, results.signals()),
        warnings: ignored.chain(all_warnings).collect(),
        findings: results.findings().to_vec(),
        finished_before: false,
    })
}

/// The run that is to be gone on with, if there is one.
fn earlier(options: &RunOptions, head: &Value) -> Result<Begun, RunError> {
    if !options.resume {
        return Ok(Begun::Nothing);
    }
    let found = resume::find(&options.directory, head).map_err(|not| match not {
        resume::Not::Other(refused) => RunError::Run(Error::Given(refused)),
        resume::Not::Io(error) => RunError::Io { path: options.directory.clone(), error },
    })?;
    let positions = match &found {
        Begun::Nothing => return Ok(found),
        Begun::Unfinished(found) => found.solved.len(),
        Begun::Finished => 1,
    };
    // What an earlier run has not written of its positions can only be had by solving them again.
    let complete = options.details().are_in(&options.directory, positions);
    Ok(if complete { found } else { Begun::Nothing })
}

/// Runs the instance with each position on disk before the next one begins: how many there are, and how it ended.
fn write_steps(
    mut instance: Instance,
    directory: &Path,
    head: &Value,
    found: Option<&Found>,
    (details, progress): (Details, Arc<Progress>),
) -> (usize, Result<Results, RunError>) {
    let unwritable = |error| RunError::Io { path: directory.to_owned(), error };
    let outputs = instance.description().outputs.clone();
    instance.tell_fields(details.positions());
    instance.tell_bodies(details.pictures);
    let solved = found.map_or(0, |found| found.solved.len());
    let record = match found.map(|found| Record::go_on(directory, &outputs, found, details)).transpose() {
        Ok(record) => record,
        Err(error) => return (solved, Err(unwritable(error))),
    };
    let written = Arc::new(Mutex::new(Written { record, solved, failure: None }));
    let mut unsaid = true;
    let (writing, head, path) = (written.clone(), head.clone(), directory.to_owned());
    instance.on_solved(move |index, solved, fields| {
        for (body, reason) in fields.iter().filter(|_| unsaid).flat_map(|fields| &fields.without_mesh) {
            progress.note(&format!("`{body}` is not among the bodies in the pictures: it {reason}"));
        }
        unsaid &= fields.is_none();
        let mut written = writing.lock().unwrap_or_else(PoisonError::into_inner);
        written.write(&path, &outputs, &head, details, (index, solved, fields)).map_err(|error| {
            written.failure = Some(error);
            // The run ends with what is kept; this ends the analysis.
            EngineError::new("E0712", "the results cannot be written", "")
        })
    });
    let outcome = instance.solve().map_err(RunError::Run);
    let mut written = written.lock().unwrap_or_else(PoisonError::into_inner);
    match written.failure.take() {
        Some(error) => (written.solved, Err(unwritable(error))),
        None => (written.solved, outcome),
    }
}

/// What of a run is on disk.
struct Written {
    record: Option<Record>,
    /// Positions.
    solved: usize,
    failure: Option<io::Error>,
}

impl Written {
    fn write(
        &mut self,
        directory: &Path,
        outputs: &[OutputDescription],
        head: &Value,
        details: Details,
        (index, solved, fields): (usize, &Solved, Option<&Fields>),
    ) -> io::Result<()> {
        // A model may go on after an analysis that failed, and begin another.
        let record = match self.record.take().filter(|_| index > 0) {
            Some(record) => record,
            None => Record::begin(directory, outputs, head, details)?,
        };
        self.record.insert(record).write(index, outputs, solved, fields)?;
        self.solved = index + 1;
        Ok(())
    }
}
