//! The `calyx` command.

use calyx::{Module, check_file, rt};
use calyx_lang::diagnostic::Severity;
use clap::{Parser, Subcommand};
use rt::params::ParamError;
use rt::run::{RunError, RunOptions, StageTimes, default_directory};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

/// The model, or its analysis, is wrong.
const MODEL_ERROR: u8 = 1;
/// The command was not used as it can be.
const USAGE: u8 = 2;

/// Design gear systems: write a model as text, check it, run it.
///
/// A model is a text file ending in .cx. `calyx check` says what is wrong with it without running it; `calyx run` solves
/// it and writes a directory of results.
#[derive(Parser)]
#[command(name = "calyx", version, after_help = "Start with:  calyx run examples/spur_pair.cx")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Say everything that is wrong with a model, without solving anything
    ///
    /// Finds errors of the language, of dimensions and units, and of the gears themselves (undercut, pointed teeth,
    /// contact ratio below 1, interference) at the params' defaults.
    Check {
        /// The model, a .cx file
        file: PathBuf,
    },
    /// Run a model and write its results
    ///
    /// Prints a summary table and writes a directory with run.json (inputs, outputs, certificate), steps.csv (one row a
    /// position) and timing.json.
    #[command(
        after_help = "Examples:\n  calyx run pair.cx\n  calyx run pair.cx --set torque=500 --set \"tip_radius=0.5 mm\"\n  calyx run pair.cx --out results/case-1 --quiet"
    )]
    Run {
        /// The model, a .cx file
        file: PathBuf,
        /// Directory for the results [default: beside the model, named after it]
        #[arg(long, value_name = "DIR")]
        out: Option<PathBuf>,
        /// Set a param; a bare VALUE is in the unit of the param's default. May be given several times
        #[arg(long, value_name = "NAME=VALUE", value_parser = rt::params::name_and_value)]
        set: Vec<(String, String)>,
        /// Print nothing but what the model prints
        #[arg(long)]
        quiet: bool,
    },
    /// Compile a model to an object file, to be linked with the calyx_rt library into an executable
    #[command(
        after_help = "Example:\n  calyx object pair.cx -o pair.o\n  cc pair.o libcalyx_rt.a -lm -lpthread -ldl -o pair"
    )]
    Object {
        /// The model, a .cx file
        file: PathBuf,
        /// The object file to write
        #[arg(short, long, value_name = "FILE")]
        output: PathBuf,
    },
}

fn main() -> ExitCode {
    match Arguments::parse().command {
        Command::Check { file } => check(&file),
        Command::Run { file, out, set, quiet } => run(&file, out, set, quiet),
        Command::Object { file, output } => object(&file, &output),
    }
}

fn check(file: &Path) -> ExitCode {
    let checked = match check_file(file) {
        Ok(checked) => checked,
        Err(error) => return unreadable(file, &error),
    };
    eprint!("{}", checked.render());
    if checked.has_errors() {
        return ExitCode::from(MODEL_ERROR);
    }
    let warnings = checked.diagnostics.iter().filter(|d| d.severity == Severity::Warning).count();
    match warnings {
        0 => eprintln!("{}: no errors, no warnings", file.display()),
        1 => eprintln!("{}: no errors, 1 warning", file.display()),
        _ => eprintln!("{}: no errors, {warnings} warnings", file.display()),
    }
    ExitCode::SUCCESS
}

fn run(file: &Path, out: Option<PathBuf>, set: Vec<(String, String)>, quiet: bool) -> ExitCode {
    let (module, before) = match compile(file, quiet) {
        Ok(compiled) => compiled,
        Err(status) => return status,
    };
    let directory = out.unwrap_or_else(|| default_directory(file));
    let options = RunOptions { directory: directory.clone(), set, quiet, before };
    match rt::run(&module, &options) {
        Ok(report) => {
            if !quiet {
                eprint!("{}", module.render_findings(&report.findings));
                for warning in &report.warnings {
                    eprintln!("warning: {warning}");
                }
                eprint!("{}", report.summary);
                eprintln!("results are in {}", directory.display());
            }
            ExitCode::SUCCESS
        }
        Err(RunError::Param(ParamError::Given { message, help })) => {
            eprintln!("error: {message}");
            if !help.is_empty() {
                eprintln!("  help: {help}");
            }
            ExitCode::from(USAGE)
        }
        Err(RunError::Param(ParamError::Model(error)) | RunError::Model(error)) => {
            eprint!("{}", module.render_error(&error));
            ExitCode::from(MODEL_ERROR)
        }
        Err(RunError::Io { path, error }) => {
            eprintln!(
                "error: cannot write results to {}: {error}\n  help: choose another directory with --out",
                path.display()
            );
            ExitCode::from(MODEL_ERROR)
        }
    }
}

fn object(file: &Path, output: &Path) -> ExitCode {
    let module = match compile(file, false) {
        Ok((module, _)) => module,
        Err(status) => return status,
    };
    let written = module.object().map_err(|error| error.to_string()).and_then(|bytes| {
        std::fs::write(output, bytes).map_err(|error| format!("cannot write {}: {error}", output.display()))
    });
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("error: {message}");
            ExitCode::from(MODEL_ERROR)
        }
    }
}

/// Checks and compiles; prints diagnostics (only errors if `quiet`) and returns the exit status if there are errors.
/// Beside the module, how long each took.
fn compile(file: &Path, quiet: bool) -> Result<(Module, StageTimes), ExitCode> {
    let started = Instant::now();
    let checked = check_file(file).map_err(|error| unreadable(file, &error))?;
    let checking = started.elapsed();
    if !quiet || checked.has_errors() {
        eprint!("{}", checked.render());
    }
    if checked.has_errors() {
        return Err(ExitCode::from(MODEL_ERROR));
    }
    let started = Instant::now();
    let module = Module::compile(checked).map_err(|error| {
        eprintln!("error: {error}");
        ExitCode::from(MODEL_ERROR)
    })?;
    Ok((module, vec![("check", checking), ("compile", started.elapsed())]))
}

fn unreadable(file: &Path, error: &std::io::Error) -> ExitCode {
    eprintln!(
        "error: cannot read {}: {error}\n  help: give the path of a model, like examples/spur_pair.cx",
        file.display()
    );
    ExitCode::from(USAGE)
}
