//! The entry point of executables linked from object files.

use crate::budget;
use crate::error::Error;
use crate::given::Given;
use crate::interrupt;
use crate::params;
use crate::program::{ParamFunction, Program};
use crate::report::{problem, refused};
use crate::run::{RunError, RunOptions, run};
use calyx_abi::call::KernelFn;
use calyx_abi::description::{ModelDescription, ModuleTable, ParamValue};
use calyx_abi::{Context, Fingerprint, Kernel, RuntimeError, Slot, Status, stack};
use calyx_gears::library::FINGERPRINT;
use clap::{Arg, ArgAction, Command};
use std::ffi::{CStr, OsString, c_char, c_int};
use std::fmt;
use std::os::unix::ffi::OsStringExt;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

/// The fingerprint of the engine in this library, by which `calyx build` knows whether a library fits.
#[unsafe(no_mangle)]
pub static CALYX_RT_ABI: u64 = FINGERPRINT.0;

/// The model, or its analysis, is wrong.
const MODEL_ERROR: c_int = 1;
/// The command was not used as it can be.
const USAGE: c_int = 2;

/// Runs a linked model as a program. Called by the `main` of its object file.
///
/// # Safety
/// `argv` holds `argc` C strings and `module` is the model's table with static lifetime.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn calyx_rt_main(
    argc: c_int,
    argv: *const *const c_char,
    module: *const ModuleTable,
) -> c_int {
    // SAFETY: as promised by the caller.
    let arguments: Vec<OsString> = (0..argc.max(0) as usize)
        .map(|i| OsString::from_vec(unsafe { CStr::from_ptr(*argv.add(i)) }.to_bytes().to_vec()))
        .collect();
    std::panic::catch_unwind(|| {
        // SAFETY: the table is a constant of the linked program.
        match LinkedProgram::new(unsafe { &*module }) {
            Ok(program) => run_as_command(Arc::new(program), arguments),
            Err(message) => {
                eprintln!("error: {message}");
                MODEL_ERROR
            }
        }
    })
    .unwrap_or(MODEL_ERROR)
}

/// A model whose code is part of this program.
pub(crate) struct LinkedProgram {
    module: &'static ModuleTable,
    description: ModelDescription,
}

/// Why a linked model cannot be run.
pub(crate) enum NotLinked {
    /// It was compiled against another engine.
    Version(Fingerprint),
    /// Its description cannot be read.
    Damaged(serde_json::Error),
}

impl fmt::Display for NotLinked {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        match self {
            NotLinked::Version(compiled_for) => write!(
                f,
                "the model was compiled for another version of Calyx than it is linked with\n  \
                 help: compile the model again with the `calyx` of this engine (the model's code expects the interface \
                 {compiled_for}, the engine has {FINGERPRINT})"
            ),
            NotLinked::Damaged(error) => write!(
                f,
                "the model's description is damaged: {error}\n  help: compile the model again with the `calyx` of this engine"
            ),
        }
    }
}

impl LinkedProgram {
    pub(crate) fn new(module: &'static ModuleTable) -> Result<Self, NotLinked> {
        let compiled_for = Fingerprint(module.abi);
        if compiled_for != FINGERPRINT {
            return Err(NotLinked::Version(compiled_for));
        }
        // SAFETY: the table states the length of its constant description.
        let bytes =
            unsafe { std::slice::from_raw_parts(module.description, module.description_len as usize) };
        let description = serde_json::from_slice(bytes).map_err(NotLinked::Damaged)?;
        Ok(LinkedProgram { module, description })
    }
}

/// A kernel in the program's code.
struct LinkedKernel {
    function: KernelFn,
    inputs: usize,
    outputs: usize,
}

impl Kernel for LinkedKernel {
    fn eval(&self, inputs: &[f64], outputs: &mut [f64]) {
        assert!(
            inputs.len() >= self.inputs && outputs.len() >= self.outputs,
            "a kernel was given too few values"
        );
        // SAFETY: the lengths were just checked against the description that was compiled with the code.
        unsafe { (self.function)(inputs.as_ptr(), outputs.as_mut_ptr()) }
    }
    fn inputs(&self) -> usize {
        self.inputs
    }
    fn outputs(&self) -> usize {
        self.outputs
    }
}

impl Program for LinkedProgram {
    fn description(&self) -> &ModelDescription {
        &self.description
    }

    fn kernels(&self) -> Vec<Arc<dyn Kernel>> {
        let kernels = self.description.kernels.iter().enumerate();
        kernels
            .map(|(index, kernel)| {
                Arc::new(LinkedKernel {
                    // SAFETY: the table has one function per described kernel.
                    function: unsafe { *self.module.kernels.add(index) },
                    inputs: kernel.inputs,
                    outputs: kernel.outputs,
                }) as Arc<dyn Kernel>
            })
            .collect()
    }

    fn param_function(
        &self,
        param: usize,
        which: ParamFunction,
        context: &mut Context,
    ) -> Result<Option<Slot>, RuntimeError> {
        // SAFETY: the table has three entries per described param.
        let Some(function) = (unsafe { *self.module.param_functions.add(3 * param + which as usize) }) else {
            return Ok(None);
        };
        // SAFETY: a param's function takes nothing and returns one slot.
        let result = unsafe { stack::run(context, function, &[], 1) }?;
        Ok(result.first().copied())
    }

    fn main(&self, context: &mut Context) -> Result<(), RuntimeError> {
        // SAFETY: the top level takes and returns nothing.
        unsafe { stack::run(context, self.module.main, &[], 0) }.map(|_| ())
    }
}

/// The command line every executable has.
fn command(description: &ModelDescription) -> Command {
    Command::new(description.name.clone())
        .about(description.doc.clone())
        .after_help(params_help(description))
        .arg(
            Arg::new("out")
                .long("out")
                .value_name("DIR")
                .help("Directory for the results")
                .default_value("run"),
        )
        .arg(
            Arg::new("set")
                .long("set")
                .value_name("NAME=VALUE")
                .action(ArgAction::Append)
                .help("Set a param; a bare value is in the unit of its default"),
        )
        .arg(
            Arg::new("time-limit")
                .long("time-limit")
                .value_name("TIME")
                .value_parser(budget::time)
                .help("End the run with an error after this time, like 10s or 5min"),
        )
        .arg(
            Arg::new("memory-limit")
                .long("memory-limit")
                .value_name("SIZE")
                .value_parser(budget::memory)
                .help("End the run with an error when it takes more memory, like 2GB"),
        )
        .arg(
            Arg::new("quiet")
                .long("quiet")
                .action(ArgAction::SetTrue)
                .help("Print nothing but what the model prints"),
        )
}

fn run_as_command(program: Arc<LinkedProgram>, arguments: Vec<OsString>) -> c_int {
    let description = program.description();
    let matches = match command(description).try_get_matches_from(arguments) {
        Ok(matches) => matches,
        Err(error) => {
            let _ = error.print();
            return error.exit_code();
        }
    };
    let mut options = RunOptions {
        directory: matches.get_one::<String>("out").map_or_else(|| "run".into(), PathBuf::from),
        quiet: matches.get_flag("quiet"),
        time_limit: matches.get_one::<Duration>("time-limit").copied(),
        memory_limit: matches.get_one::<u64>("memory-limit").copied(),
        cancel: interrupt::flag(),
        ..RunOptions::default()
    };
    for given in matches.get_many::<String>("set").into_iter().flatten() {
        match Given::name_and_value(given) {
            Ok(given) => options.given.push(given),
            Err(message) => {
                eprintln!("error: `--set {given}`: {message}");
                return USAGE;
            }
        }
    }
    match run(program.clone(), &options) {
        Ok(report) => {
            if !options.quiet {
                for finding in &report.findings {
                    eprint!("{}", problem("warning", &finding.error, description));
                }
                for warning in &report.warnings {
                    eprintln!("warning: {warning}");
                }
                eprint!("{}", report.summary);
                eprintln!("results are in {}", options.directory.display());
            }
            0
        }
        Err(error) => {
            let status = report_failure(&error, description);
            if let RunError::Run(Error::Model(error)) = &error
                && error.status() == Status::Cancelled
                && options.directory.join("steps.csv").exists()
            {
                eprintln!("the positions solved until then are in {}", options.directory.display());
            }
            status
        }
    }
}

/// Every param with its default, what it takes, and its doc comment.
fn params_help(description: &ModelDescription) -> String {
    let mut text = String::from("Params:\n");
    for param in &description.params {
        let default = match &param.default {
            Some(ParamValue::Number(si)) => params::shown(param, *si),
            Some(ParamValue::Bool(value)) => (if *value { "TRUE" } else { "FALSE" }).into(),
            Some(ParamValue::String(value)) => format!("\"{value}\""),
            None => "?".into(),
        };
        let domain = params::domain(param, param.low, param.high);
        let domain = if domain.is_empty() { domain } else { format!(" [{domain}]") };
        text += &format!("  {} = {default}{domain}\n", param.name);
        for line in param.doc.lines() {
            text += &format!("      {line}\n");
        }
    }
    text
}

/// Says what went wrong and returns the exit status.
fn report_failure(error: &RunError, description: &ModelDescription) -> c_int {
    match error {
        RunError::Run(Error::Given(why)) => {
            eprint!("{}", refused(why));
            USAGE
        }
        RunError::Run(Error::Model(error)) => {
            eprint!("{}", problem("error", error, description));
            MODEL_ERROR
        }
        RunError::Io { path, error } => {
            eprintln!(
                "error: cannot write results to {}: {error}\n  help: choose another directory with --out",
                path.display()
            );
            MODEL_ERROR
        }
    }
}
