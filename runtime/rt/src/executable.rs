//! Command line of a model compiled to an executable: its help is generated from the model's docs,
//! and its options are those of `calyx run`.

use crate::adapted::AdaptedProgram;
use crate::command::{MODEL_ERROR, Messages, RunCommand, USAGE, print_json};
use crate::console::{eprint, eprintln};
use crate::former_options;
use crate::help;
use crate::linked::LinkedProgram;
use crate::messages::{problem, refused};
use crate::options::RunArguments;
use crate::params::InvalidParam;
use crate::program::Program;
use crate::schema::schema;
use calyx_abi::RuntimeError;
use calyx_abi::description::{ModelDescription, ModuleTable};
use calyx_abi::visible::visible;
use calyx_gears::error::Severity;
use calyx_gears::host::Finding;
use clap::{Args, Command, CommandFactory, FromArgMatches, Parser};
use std::ffi::{CStr, OsString, c_char, c_int};
use std::os::unix::ffi::OsStringExt;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Options of an executable.
#[derive(Parser)]
#[command(disable_help_subcommand = true)]
struct Arguments {
    #[command(flatten)]
    run: RunArguments,
    #[command(flatten)]
    tables: Tables,
}

#[derive(Args)]
struct Tables {
    /// Read the model's tables from this directory instead of those compiled into the executable
    ///
    /// Tables that the model reads with default params are part of the executable. Other tables are
    /// searched for in the working directory.
    #[arg(long, value_name = "DIR")]
    tables: Option<PathBuf>,
}

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
    // SAFETY: guaranteed by the caller.
    let arguments: Vec<OsString> = (0..argc.max(0) as usize)
        .map(|i| OsString::from_vec(unsafe { CStr::from_ptr(*argv.add(i)) }.to_bytes().to_vec()))
        .collect();
    std::panic::catch_unwind(|| {
        // SAFETY: the table is a constant of the linked program.
        match LinkedProgram::new(unsafe { &*module }) {
            Ok(program) => main(Arc::new(program), &arguments).into(),
            Err(message) => {
                eprintln!("error: {message}");
                MODEL_ERROR.into()
            }
        }
    })
    .unwrap_or(MODEL_ERROR.into())
}

/// Runs a model as a program and returns its exit status: 0 when results are written, 1 if the
/// model or its analysis failed, 2 for a usage error. `arguments` begin with the program's name.
pub fn main(program: Arc<dyn Program>, arguments: &[OsString]) -> u8 {
    let description = program.description();
    let options = command(description);
    let former = former_options::warnings(&options, arguments);
    let parsed = options.try_get_matches_from(arguments);
    let parsed = parsed.and_then(|mut matches| Arguments::from_arg_matches_mut(&mut matches));
    let Arguments { run: arguments_of_run, tables } = match parsed {
        Ok(arguments) => arguments,
        Err(error) => {
            let _ = error.print();
            return error.exit_code().try_into().unwrap_or(1);
        }
    };
    let name = arguments.first().and_then(|path| Path::new(path).file_name());
    let mut directory = name.map_or_else(|| "model".into(), OsString::from);
    directory.push(".run");
    let messages = StandaloneMessages { description };
    if !arguments_of_run.quiet {
        former.iter().for_each(|warning| messages.warning(warning));
    }
    let program = Arc::new(AdaptedProgram::standalone(program.clone(), tables.tables));
    let command = RunCommand {
        program,
        arguments: &arguments_of_run,
        before: Vec::new(),
        default_directory: directory.into(),
        messages: &messages,
        silent: false,
    };
    if arguments_of_run.print_params {
        return print_json(&schema(description), &messages);
    }
    match arguments_of_run.given() {
        Ok(given) => command.execute(given),
        Err(why) => {
            messages.refused(&why);
            USAGE
        }
    }
}

/// Builds the command line, with the help of this model.
fn command(description: &ModelDescription) -> Command {
    let (about, long_about) = match description.doc.trim() {
        "" => ("A model compiled by Calyx.", "A model compiled by Calyx."),
        doc => (doc.lines().next().unwrap_or_default(), doc),
    };
    let name = Path::new(&description.name).file_stem().map(|name| name.to_string_lossy().into_owned());
    Arguments::command()
        .name(name.unwrap_or_else(|| "model".into()))
        .version(format!("(compiled by Calyx {}, engine {})", env!("CARGO_PKG_VERSION"), description.abi))
        .about(visible(about).into_owned())
        .long_about(visible(long_about).into_owned())
        .after_help(visible(&help::short(description)).into_owned())
        .after_long_help(visible(&help::long(description)).into_owned())
        .help_template("{about-with-newline}\n{usage-heading} {usage}{after-help}\n\n{all-args}")
}

/// Messages of an executable, on standard error.
struct StandaloneMessages<'d> {
    description: &'d ModelDescription,
}

impl Messages for StandaloneMessages<'_> {
    fn refused(&self, why: &InvalidParam) {
        eprint!("{}", refused(why));
    }

    fn error(&self, error: &RuntimeError) {
        eprint!("{}", problem(Severity::Error, error, self.description));
    }

    fn findings(&self, findings: &[Finding]) {
        for finding in findings {
            eprint!("{}", problem(finding.severity, &finding.error, self.description));
        }
    }

    fn warning(&self, text: &str) {
        eprintln!("warning: {}", visible(text));
    }

    fn note(&self, text: &str) {
        eprintln!("{}", visible(text));
    }
}
