//! One run: params set, program run, its analysis watched and written down.

use crate::budget;
use crate::directory::{Stages, StepTable, prepare, warnings, write_run, write_unfinished};
use crate::given::Given;
use crate::params::{self, ParamError};
use crate::program::Program;
use crate::progress::{Progress, ProgressFormat};
use crate::table;
use calyx_abi::description::ModelDescription;
use calyx_abi::error::codes;
use calyx_abi::limits::Limits;
use calyx_abi::{Context, RuntimeError, Status};
use calyx_gears::host::{Finding, ModelHost};
use calyx_runtime::analysis::{Event, Observer};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// Names of stages, in order, and the time each took.
pub type StageTimes = Vec<(&'static str, Duration)>;

/// What a run is to do.
#[derive(Clone, Debug, Default)]
pub struct RunOptions {
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
    pub cancel: Arc<AtomicBool>,
}

/// Why a run did not finish.
#[derive(Debug)]
pub enum RunError {
    Param(ParamError),
    /// The model or its analysis failed.
    Model(RuntimeError),
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
pub fn run(program: &dyn Program, options: &RunOptions) -> Result<RunReport, RunError> {
    let description = program.description();
    let unwritable = |error| RunError::Io { path: options.directory.clone(), error };
    let mut host = ModelHost::new(&description.units);
    let progress = Arc::new(Progress::new(options.progress, options.quiet));
    let solved = Arc::new(AtomicUsize::new(0));
    let failure = Arc::new(Mutex::new(None));
    let limits = Limits::from_now(options.time_limit, options.memory_limit);
    let cancel = options.cancel.clone();
    host.analysis.resources.interrupt = Interrupt::new(move || check_limits(&limits, &cancel));
    host.observer = Some(Box::new(Watcher {
        directory: options.directory.clone(),
        description: description.clone(),
        table: None,
        progress: progress.clone(),
        solved: solved.clone(),
        failure: failure.clone(),
    }));
    let mut context = Context::new(Box::new(host));
    context.limits = limits;
    context.cancel = options.cancel.clone();
    context.kernels = program.kernels();
    let shown = progress.clone();
    context.print = Box::new(move |line| shown.print(line));
    let outcome = params::apply(program, &options.given, &mut context).map_err(RunError::Param);
    let outcome = outcome.and_then(|()| prepare(&options.directory).map_err(unwritable)).and_then(|()| {
        let started = Instant::now();
        program.main(&mut context).map_err(RunError::Model)?;
        Ok(started.elapsed())
    });
    progress.finish();
    if let Some(error) = failure.lock().ok().and_then(|mut failure| failure.take()) {
        return Err(unwritable(error));
    }
    // What was solved until somebody ended the run is worth keeping, with what it is of.
    if let Err(RunError::Model(error)) = &outcome
        && error.status() == Status::Cancelled
        && solved.load(Ordering::Relaxed) > 0
    {
        let solved = solved.load(Ordering::Relaxed);
        write_unfinished(&options.directory, description, &context, solved, error).map_err(unwritable)?;
    }
    let stages = Stages { before: options.before.clone(), program: outcome? };
    let (result, findings, failed) = match context.host::<ModelHost>() {
        Some(host) => (host.result.take(), std::mem::take(&mut host.findings), host.failed_analyses > 0),
        None => (None, Vec::new(), false),
    };
    if result.is_none() && !description.outputs.is_empty() {
        return Err(RunError::Model(no_analysis(description, failed)));
    }
    let all_warnings = result.as_ref().map(warnings).unwrap_or_default();
    let mut written: Vec<String> =
        findings.iter().map(|finding| format!("{}: {}", finding.error.code, finding.error.message)).collect();
    written.extend(all_warnings.iter().cloned());
    write_run(&options.directory, description, &context, result.as_ref(), &written, &stages)
        .map_err(unwritable)?;
    let ignored = result.iter().flat_map(|result| &result.plan.ignored);
    let ignored =
        ignored.map(|ignored| format!("`{}` is not seen as given: {}", ignored.input, ignored.reason));
    Ok(RunReport {
        summary: result.as_ref().map(|result| table::summary(description, result)).unwrap_or_default(),
        warnings: ignored.chain(all_warnings).collect(),
        findings,
    })
}

/// The place is the end of the model, where an analysis would stand.
fn no_analysis(description: &ModelDescription, failed: bool) -> RuntimeError {
    let end = description.files.first().map_or(0, |file| file.text.trim_end().len() as u32);
    let (message, help) = match failed {
        true => (
            "the model declares outputs, and its analysis failed",
            "the model caught the error of the analysis; print it there to see what it was",
        ),
        false => (
            "the model declares outputs and analyses nothing",
            "end it with `analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 32));`",
        ),
    };
    let error = RuntimeError::new("E0711", message, help);
    RuntimeError { place: Some((0, end.saturating_sub(1), end)), ..error }
}

/// Writes rows as they come and keeps the progress bar.
struct Watcher {
    directory: PathBuf,
    description: ModelDescription,
    table: Option<StepTable>,
    progress: Arc<Progress>,
    /// Positions that are on disk.
    solved: Arc<AtomicUsize>,
    /// An error of the file system, which ends the run but is not the model's.
    failure: Arc<Mutex<Option<io::Error>>>,
}

impl Watcher {
    /// Keeps the error for whoever started the run, and makes one that ends the analysis.
    fn fail(&self, error: io::Error) -> EngineError {
        let message = format!("cannot write to {}: {error}", self.directory.display());
        if let Ok(mut failure) = self.failure.lock() {
            *failure = Some(error);
        }
        EngineError::new("E0712", message, "choose another directory with --out")
    }
}

/// Ends an analysis that was cancelled or has used up its time or memory.
fn check_limits(limits: &Limits, cancel: &AtomicBool) -> Result<(), EngineError> {
    if cancel.load(Ordering::Relaxed) {
        return Err(EngineError::new(codes::CANCELLED, "the run was cancelled", ""));
    }
    let taken = limits.memory.and_then(|_| budget::taken()).unwrap_or(0);
    limits
        .check_time()
        .and_then(|()| limits.check_memory(taken))
        .map_err(|error| EngineError::new(codes::EXHAUSTED, error.message, error.help))
}

impl Observer for Watcher {
    fn observe(&mut self, event: Event<'_>) -> Result<(), EngineError> {
        match event {
            Event::Planned(_) => {
                let table = StepTable::create(&self.directory, &self.description.outputs);
                self.table = Some(table.map_err(|error| self.fail(error))?);
            }
            Event::Stage(name) => self.progress.stage(name),
            Event::Step { index, count, solved } => {
                let written = self.table.as_mut().map_or(Ok(()), |table| table.write(index, &solved.row));
                written.map_err(|error| self.fail(error))?;
                self.solved.store(index + 1, Ordering::Relaxed);
                self.progress.step(index, count);
            }
        }
        Ok(())
    }
}

/// The default run directory: beside the model, named after it.
pub fn default_directory(model: &Path) -> PathBuf {
    let mut name = model.file_name().unwrap_or_default().to_owned();
    name.push(".run");
    model.with_file_name(name)
}
