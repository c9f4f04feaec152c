//! The entry point of executables linked from object files.

use crate::params::ParamError;
use crate::program::{ParamFunction, Program};
use crate::run::{RunError, RunOptions, run};
use calyx_abi::call::KernelFn;
use calyx_abi::description::{ModelDescription, ModuleTable};
use calyx_abi::{ABI_VERSION, Context, Kernel, RuntimeError, Slot, stack};
use clap::{Arg, ArgAction, Command};
use std::ffi::{CStr, OsString, c_char, c_int};
use std::os::unix::ffi::OsStringExt;
use std::path::PathBuf;
use std::sync::Arc;

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
            Ok(program) => run_as_command(&program, arguments),
            Err(message) => {
                eprintln!("error: {message}");
                1
            }
        }
    })
    .unwrap_or(1)
}

/// A model whose code is part of this program.
struct LinkedProgram {
    module: &'static ModuleTable,
    description: ModelDescription,
}

impl LinkedProgram {
    fn new(module: &'static ModuleTable) -> Result<Self, String> {
        if module.abi_version != ABI_VERSION {
            return Err(format!(
                "the model was compiled for version {} of the engine's interface and this engine has version \
                 {ABI_VERSION}; compile the model again",
                module.abi_version
            ));
        }
        // SAFETY: the table states the length of its constant description.
        let bytes =
            unsafe { std::slice::from_raw_parts(module.description, module.description_len as usize) };
        let description =
            serde_json::from_slice(bytes).map_err(|e| format!("the model's description is damaged: {e}"))?;
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
        let inputs = 1 + self.description.params.len();
        let kernels = self.description.kernels.iter().enumerate();
        kernels
            .map(|(index, kernel)| {
                let captured: usize = kernel.captures.iter().map(|capture| capture.repr.slots()).sum();
                Arc::new(LinkedKernel {
                    // SAFETY: the table has one function per described kernel.
                    function: unsafe { *self.module.kernels.add(index) },
                    inputs: inputs + captured,
                    outputs: kernel.repr.slots() * (1 + usize::from(kernel.order)),
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
fn run_as_command(program: &LinkedProgram, arguments: Vec<OsString>) -> c_int {
    let description = program.description();
    let command = Command::new(description.name.clone())
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
        .arg(Arg::new("quiet").long("quiet").action(ArgAction::SetTrue).help("No progress, no summary"));
    let matches = match command.try_get_matches_from(arguments) {
        Ok(matches) => matches,
        Err(error) => {
            let _ = error.print();
            return error.exit_code();
        }
    };
    let mut set = Vec::new();
    for given in matches.get_many::<String>("set").into_iter().flatten() {
        let Some((name, value)) = given.split_once('=') else {
            eprintln!("error: `--set {given}` has no `=`; give it like `--set torque=500`");
            return 2;
        };
        set.push((name.trim().to_owned(), value.trim().to_owned()));
    }
    let directory = matches.get_one::<String>("out").map_or_else(|| "run".into(), PathBuf::from);
    let quiet = matches.get_flag("quiet");
    match run(program, &RunOptions { directory: directory.clone(), set, quiet }) {
        Ok(report) => {
            for warning in &report.warnings {
                eprintln!("warning: {warning}");
            }
            if !quiet {
                eprint!("{}", report.summary);
                eprintln!("results are in {}", directory.display());
            }
            0
        }
        Err(error) => report_failure(&error, description),
    }
}

fn params_help(description: &ModelDescription) -> String {
    let mut text = String::from("Params:\n");
    for param in &description.params {
        let unit = if param.unit.name.is_empty() { String::new() } else { format!(" [{}]", param.unit.name) };
        text += &format!("  {}{unit}  {}\n", param.name, param.doc);
    }
    text
}

/// Says what went wrong and returns the exit status.
fn report_failure(error: &RunError, description: &ModelDescription) -> c_int {
    match error {
        RunError::Param(ParamError::Given { message, help }) => {
            eprintln!("error: {message}");
            if !help.is_empty() {
                eprintln!("  help: {help}");
            }
            2
        }
        RunError::Param(ParamError::Model(error)) | RunError::Model(error) => {
            eprintln!("error[{}]: {}", error.code, error.message);
            if let Some(place) = error.place.and_then(|place| line_of(place, description)) {
                eprintln!("  at {place}");
            }
            if !error.help.is_empty() {
                eprintln!("  help: {}", error.help);
            }
            1
        }
        RunError::Io { path, error } => {
            eprintln!("error: cannot write results to {}: {error}", path.display());
            1
        }
    }
}

/// `file:line:column` of a place in the sources the description carries.
fn line_of((file, start, _): (u32, u32, u32), description: &ModelDescription) -> Option<String> {
    let file = description.files.get(file as usize)?;
    let before = file.text.get(..start as usize)?;
    let line = before.matches('\n').count() + 1;
    let column = before.chars().rev().take_while(|&c| c != '\n').count() + 1;
    Some(format!("{}:{line}:{column}", file.name))
}
