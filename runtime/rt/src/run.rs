//! A run for people and for those who read its directory: an instance, watched and written down.

use crate::directory::{Stages, StepTable, prepare, write_run, write_unfinished};
use crate::engine::Engine;
use crate::error::Error;
use crate::given::Given;
use crate::instance::Instance;
use crate::program::Program;
use crate::progress::{Progress, ProgressFormat};
use crate::results::Results;
use crate::table;
use calyx_abi::{Cancel, Status};
use calyx_gears::host::Finding;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Duration;

/// Names of stages, in order, and the time each took.
pub type StageTimes = Vec<(&'static str, Duration)>;

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
    /// What went before, for `timing.json`.
    pub before: StageTimes,
    /// How long the run may take.
    pub time_limit: Option<Duration>,
    /// Bytes that it may take: of the program's values, and of the process while it analyses.
    pub memory_limit: Option<u64>,
    /// Set from outside, it ends the run soon; what was written is kept.
    pub cancel: Cancel,
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
pub struct RunReport {
    /// The table of outputs; empty for a model without an analysis.
    pub summary: String,
    /// What deserves a second look.
    pub warnings: Vec<String>,
    /// What the library found, with places in the source.
    pub findings: Vec<Finding>,
}

/// Runs a model and writes its run directory.
pub fn run(program: Arc<dyn Program>, options: &RunOptions) -> Result<RunReport, RunError> {
    let unwritable = |error| RunError::Io { path: options.directory.clone(), error };
    let mut instance = Instance::new(&options.engine, program.clone());
    for given in &options.given {
        instance.give(given).map_err(RunError::Run)?;
    }
    instance.limit_time(options.time_limit);
    instance.limit_memory(options.memory_limit);
    instance.set_cancel(options.cancel.clone());
    let params = instance.params().map_err(RunError::Run)?;
    prepare(&options.directory).map_err(unwritable)?;
    let progress = Arc::new(Progress::new(options.progress, options.quiet));
    let (shown, printed) = (progress.clone(), progress.clone());
    instance.on_progress(move |now| match now.total {
        Some(count) => shown.step(now.done - 1, count),
        None => shown.stage(now.stage),
    });
    instance.on_print(move |line| printed.print(line));
    let (solved, outcome) = write_steps(&instance, &options.directory);
    progress.finish();
    let description = program.description();
    // What was solved until somebody ended the run is worth keeping, with what it is of.
    if let Err(RunError::Run(Error::Model(error))) = &outcome
        && error.status() == Status::Cancelled
        && solved > 0
    {
        write_unfinished(&options.directory, description, &params, solved, error).map_err(unwritable)?;
    }
    let results = outcome?;
    let stages = Stages { before: options.before.clone(), program: results.time() };
    let all_warnings = results.warnings();
    let findings = results.findings().iter();
    let mut written: Vec<String> =
        findings.map(|finding| format!("{}: {}", finding.error.code, finding.error.message)).collect();
    written.extend(all_warnings.iter().cloned());
    let result = results.analysis();
    write_run(&options.directory, description, results.params(), result, &written, &stages)
        .map_err(unwritable)?;
    let ignored = result.iter().flat_map(|result| &result.plan.ignored);
    let ignored =
        ignored.map(|ignored| format!("`{}` is not seen as given: {}", ignored.input, ignored.reason));
    Ok(RunReport {
        summary: result.map(|result| table::summary(description, result)).unwrap_or_default(),
        warnings: ignored.chain(all_warnings).collect(),
        findings: results.findings().to_vec(),
    })
}

/// Runs the instance with each position on disk before the next one begins: how many there are, and how it ended.
fn write_steps(instance: &Instance, directory: &Path) -> (usize, Result<Results, RunError>) {
    let mut solved = 0;
    let mut write = || {
        let mut run = instance.run().map_err(RunError::Run)?;
        let mut table = None;
        for step in &mut run {
            let step = step.map_err(RunError::Run)?;
            let unwritable = |error| RunError::Io { path: directory.to_owned(), error };
            // A model may go on after an analysis that failed, and begin another.
            if step.index() == 0 {
                let outputs = &instance.description().outputs;
                table = Some(StepTable::create(directory, outputs).map_err(unwritable)?);
            }
            if let Some(table) = &mut table {
                table.write(step.index(), step.row()).map_err(unwritable)?;
            }
            solved = step.index() + 1;
        }
        run.finish().map_err(RunError::Run)
    };
    let outcome = write();
    (solved, outcome)
}

/// The default run directory: beside the model, named after it.
pub fn default_directory(model: &Path) -> PathBuf {
    let mut name = model.file_name().unwrap_or_default().to_owned();
    name.push(".run");
    model.with_file_name(name)
}
