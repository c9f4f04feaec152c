//! A run as a command: what `calyx run` and an executable do with their options, once there is a program.

use crate::budget;
use crate::directory::{self, StageTimes};
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
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Results are written.
pub const SUCCESS: u8 = 0;
/// The model, or its analysis, is wrong.
pub const MODEL_ERROR: u8 = 1;
/// The command was not used as it can be.
pub const USAGE: u8 = 2;

/// How a command speaks to whoever gave it.
pub trait Messages {
    /// Why what was given cannot be used.
    fn refused(&self, why: &InvalidParam);
    /// Why the run failed.
    fn error(&self, error: &RuntimeError);
    /// What the library found, with places in the source.
    fn findings(&self, findings: &[Finding]);
    /// What deserves a second look and has no place in the source.
    fn warning(&self, text: &str);
    /// What only people want to know; without the line's end.
    fn note(&self, text: &str);
}

/// A run that somebody asked for.
pub struct RunCommand<'c> {
    pub program: Arc<dyn Program>,
    pub arguments: &'c RunArguments,
    /// What went before, for `timing.json`.
    pub before: StageTimes,
    /// Where results go if nobody says.
    pub default_directory: PathBuf,
    pub messages: &'c dyn Messages,
    /// Shows no bar, even where people watch.
    pub silent: bool,
}

impl RunCommand<'_> {
    /// Does what the options say, with the params that they gave: the exit status.
    pub fn execute(self, given: Vec<ParamAssignment>) -> u8 {
        let RunCommand { program, arguments, before, default_directory, messages, silent } = self;
        let directory = arguments.out.clone().unwrap_or(default_directory);
        let threads = arguments.threads.map_or(0, NonZeroUsize::get);
        if arguments.memory_limit.is_some() {
            // What checking took is not the run's.
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

/// Says that a run which failed before its first position left the results of an earlier run as they are, if there are
/// any: the exit status.
pub fn refused_by_check(directory: &Path, messages: &dyn Messages) -> u8 {
    if directory.join("run.json").exists() {
        messages.note(&format!(
            "the results in {} are those of an earlier run and were not changed",
            directory.display()
        ));
    }
    MODEL_ERROR
}

/// Says that a directory does not take results.
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

/// Prints one JSON document on standard output. Whoever does not want to read to its end may close it.
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
