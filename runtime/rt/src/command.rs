//! A run as a command: the part that `calyx run` and executables share once there is a program.

use crate::budget;
use crate::engine::{Engine, EngineConfig};
use crate::error::Error;
use crate::interrupt;
use crate::options::RunArguments;
use crate::param_assignment::ParamAssignment;
use crate::params::InvalidParam;
use crate::program::Program;
use crate::run::{RunError, RunOptions, RunReport, run};
use crate::run_directory::DirectoryError;
use calyx_abi::RuntimeError;
use calyx_gears::host::Finding;
use calyx_report::directory::{self, StageTimes};
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Exit status: the results are written.
pub const SUCCESS: u8 = 0;
/// Exit status: the model or its analysis failed.
pub const MODEL_ERROR: u8 = 1;
/// Exit status: usage error.
pub const USAGE: u8 = 2;

/// Output of messages to the user of a command.
pub trait Messages {
    /// Reports an invalid argument.
    fn refused(&self, why: &InvalidParam);
    /// Reports the failure of the run.
    fn error(&self, error: &RuntimeError);
    /// Reports findings of the library, with source locations.
    fn findings(&self, findings: &[Finding]);
    /// Reports a warning without a source location.
    fn warning(&self, text: &str);
    /// Prints a note for people; without a line break at the end.
    fn note(&self, text: &str);
}

/// A run started from a command line.
pub struct RunCommand<'c> {
    pub program: Arc<dyn Program>,
    pub arguments: &'c RunArguments,
    /// Stages that preceded the run, for `timing.json`.
    pub before: StageTimes,
    /// Directory of the results if no option sets it.
    pub default_directory: PathBuf,
    pub messages: &'c dyn Messages,
    /// Suppresses the progress bar, also on a terminal.
    pub silent: bool,
}

impl RunCommand<'_> {
    /// Runs the model with the given params and returns the exit status.
    pub fn execute(self, given: Vec<ParamAssignment>) -> u8 {
        let RunCommand { program, arguments, before, default_directory, messages, silent } = self;
        if let Err(why) = arguments.check_cache() {
            messages.refused(&why);
            return USAGE;
        }
        let directory = arguments.out.clone().unwrap_or(default_directory);
        let threads = arguments.threads.map_or(0, NonZeroUsize::get);
        if arguments.memory_limit.is_some() {
            // The memory of the type checker must not count for the run.
            budget::return_freed();
        }
        let options = RunOptions {
            engine: Engine::new(EngineConfig {
                threads,
                store: arguments.store(),
                ..EngineConfig::default()
            }),
            directory: directory.clone(),
            given,
            without_derivatives: false,
            quiet: arguments.quiet || silent,
            progress: arguments.progress,
            print_to_error: arguments.json,
            before,
            time_limit: arguments.time_limit,
            memory_limit: arguments.memory_limit,
            force: arguments.force,
            resume: arguments.resume,
            fields: arguments.fields,
            vtu: arguments.vtu,
            unv: arguments.unv,
            overrides: arguments.overrides.to_override(),
            cancel: interrupt::flag(),
        };
        match run(program, &options) {
            Ok(report) => {
                if !arguments.quiet {
                    tell(&report, &directory, messages);
                }
                let status = match arguments.json {
                    true => print_document(&directory, messages),
                    false => SUCCESS,
                };
                if report.tolerance_missed { status.max(MODEL_ERROR) } else { status }
            }
            Err(error) => failed(&error, &directory, messages),
        }
    }
}

fn tell(report: &RunReport, directory: &Path, messages: &dyn Messages) {
    messages.findings(&report.findings);
    report.warnings.iter().for_each(|warning| messages.warning(warning));
    if !report.summary.is_empty() {
        messages.note(report.summary.trim_end());
    }
    messages.note(&match report.finished_before {
        true => format!("the run in {} is finished already: there is nothing to do", directory.display()),
        false => format!("results are in {}", directory.display()),
    });
}

fn failed(error: &RunError, directory: &Path, messages: &dyn Messages) -> u8 {
    match error {
        RunError::Run(Error::Given(why)) => {
            messages.refused(why);
            USAGE
        }
        RunError::Run(Error::Model(error)) => {
            messages.error(error);
            refused_by_check(directory, messages)
        }
        RunError::Ended { error, .. } => {
            messages.error(error);
            messages.note(&format!(
                "the positions solved so far are in {}; to continue, run the same command with --resume",
                directory.display()
            ));
            MODEL_ERROR
        }
        RunError::Directory(error) => {
            messages.refused(&InvalidParam::new(error.to_string(), error.help()));
            match error {
                DirectoryError::Foreign { .. } | DirectoryError::InTheWay { .. } => USAGE,
                DirectoryError::InUse { .. } | DirectoryError::Io { .. } => MODEL_ERROR,
            }
        }
        RunError::Io { path, error } => unwritable(path, error, messages),
    }
}

/// Reports that a run which failed before its first position left the results of an earlier run
/// unchanged, if there are any. Returns the exit status.
pub fn refused_by_check(directory: &Path, messages: &dyn Messages) -> u8 {
    if directory.join("run.json").exists() {
        messages.note(&format!(
            "the results in {} are those of an earlier run and were not changed",
            directory.display()
        ));
    }
    MODEL_ERROR
}

/// Reports that results cannot be written to a directory.
pub fn unwritable(path: &Path, error: &io::Error, messages: &dyn Messages) -> u8 {
    messages.refused(&InvalidParam::new(
        format!("cannot write results to {}: {error}", path.display()),
        "choose another directory with --out",
    ));
    MODEL_ERROR
}

fn print_document(directory: &Path, messages: &dyn Messages) -> u8 {
    match directory::document(directory) {
        Ok(document) => print_json(&document, messages),
        Err(error) => {
            messages.refused(&InvalidParam::new(
                format!("cannot read the results in {}: {error}", directory.display()),
                "",
            ));
            MODEL_ERROR
        }
    }
}

/// Prints one JSON document on standard output. A reader that closes the pipe early is no error.
pub fn print_json(document: &serde_json::Value, messages: &dyn Messages) -> u8 {
    let mut out = io::stdout().lock();
    match serde_json::to_writer_pretty(&mut out, document)
        .map_err(io::Error::from)
        .and_then(|()| writeln!(out))
    {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            messages.refused(&InvalidParam::new(format!("cannot print the results: {error}"), ""));
            MODEL_ERROR
        }
        _ => SUCCESS,
    }
}
