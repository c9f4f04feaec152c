//! `calyx run`: solves a model and writes its results.

use crate::compile::compile;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::directory::prepare;
use calyx::rt::progress::ProgressFormat;
use calyx::rt::run::{RunError, RunOptions, default_directory};
use calyx::rt::{Error, Given, budget, interrupt};
use calyx::{check_run, rt};
use calyx_abi::Status;
use clap::{Args, ValueEnum};
use std::io;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

pub const EXAMPLES: &str = "Examples:
  calyx run pair.cx
  calyx run pair.cx --set torque=500 --set \"tip_radius=0.5 mm\"
  calyx run pair.cx --out results/case-1 --quiet

Exit status: 0 when results are written, 1 if the model or its analysis failed, 2 if the command was not used as it can be.";

/// Who watches the run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum Progress {
    /// A bar, on a terminal
    #[default]
    Human,
    /// One JSON object a line: stage, done, total, seconds_left
    Json,
}

#[derive(Args)]
pub struct Run {
    /// The model, a .cx file
    file: PathBuf,
    /// Directory for the results [default: beside the model, named after it]
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Set a param; a bare VALUE is in the unit of the param's default. May be given several times
    #[arg(long, value_name = "NAME=VALUE", value_parser = Given::name_and_value)]
    set: Vec<Given>,
    /// End the run with an error after this time, like 10s or 5min
    #[arg(long, value_name = "TIME", value_parser = budget::time)]
    time_limit: Option<Duration>,
    /// End the run with an error when it takes more memory, like 2GB
    #[arg(long, value_name = "SIZE", value_parser = budget::memory)]
    memory_limit: Option<u64>,
    /// Print nothing but what the model prints
    #[arg(long)]
    quiet: bool,
    /// How progress is shown on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    progress: Progress,
    /// How messages are written to standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    message_format: MessageFormat,
}

impl Run {
    pub fn run(self) -> ExitCode {
        let Run { file, out, set, time_limit, memory_limit, quiet, progress, message_format: format } = self;
        let (module, before) = match compile(&file, quiet, format, || check_run(&file, &set)) {
            Ok(compiled) => compiled,
            Err(status) => return status,
        };
        let directory = out.unwrap_or_else(|| default_directory(&file));
        if module.has_errors() {
            // As after any run that fails, no results of an earlier one are left behind.
            return match prepare(&directory) {
                Ok(()) => ExitCode::from(MODEL_ERROR),
                Err(error) => unwritable(format, &directory, &error),
            };
        }
        // Progress bars are for people.
        let silent = quiet || format == MessageFormat::Json;
        let options = RunOptions {
            engine: module.engine().clone(),
            directory: directory.clone(),
            given: set.clone(),
            quiet: silent,
            progress: match progress {
                Progress::Human => ProgressFormat::Human,
                Progress::Json => ProgressFormat::Json,
            },
            before,
            time_limit,
            memory_limit,
            cancel: interrupt::flag(),
        };
        match rt::run(module.as_program(), &options) {
            Ok(report) => {
                if !quiet {
                    format.diagnostics(&module.findings(&report.findings), module.files());
                    report.warnings.iter().for_each(|warning| format.warning(warning));
                    format.note(&report.summary);
                    format.note(&format!("results are in {}\n", directory.display()));
                }
                ExitCode::SUCCESS
            }
            Err(RunError::Run(Error::Given(refused))) => {
                format.refused(&refused);
                ExitCode::from(USAGE)
            }
            Err(RunError::Run(Error::Model(error))) => {
                format.diagnostics(&[module.error(&error)], module.files());
                if error.status() == Status::Cancelled && directory.join("steps.csv").exists() {
                    format.note(&format!("the positions solved until then are in {}\n", directory.display()));
                }
                ExitCode::from(MODEL_ERROR)
            }
            Err(RunError::Io { path, error }) => unwritable(format, &path, &error),
        }
    }
}

fn unwritable(format: MessageFormat, path: &Path, error: &io::Error) -> ExitCode {
    format.failure(
        &format!("cannot write results to {}: {error}", path.display()),
        "choose another directory with --out",
    );
    ExitCode::from(MODEL_ERROR)
}
