//! `calyx run`: solves a model and writes its results.

use crate::allow::AllowPath;
use crate::compile::{checked, compile};
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::command::{Messages, RunCommand, refused_by_check};
use calyx::rt::console::println;
use calyx::rt::directory::default_directory;
use calyx::rt::options::RunArguments;
use calyx::rt::schema::schema;
use calyx::rt::{InvalidParam, budget, interrupt};
use calyx::{Module, check_file_allowing, check_run_within};
use calyx_abi::RuntimeError;
use calyx_gears::host::Finding;
use clap::Args;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::{self, ExitCode};
use std::sync::Arc;
use std::thread;
use std::time::Duration;

pub const EXAMPLES: &str = "\
Examples:
  calyx run pair.cx                                     writes results to pair.cx.run
  calyx run pair.cx --set torque=500 --set \"tip_radius=0.5 mm\"
  calyx run pair.cx --params case.toml --out results/case-1 --quiet
  calyx run pair.cx --print-params > params.schema.json schema of a params file
  calyx run pair.cx --json --quiet | jq .outputs.max_contact_pressure.max
  calyx run pair.cx --resume                            after an interrupted run
  calyx run pair.cx --fidelity plane --contact-cells 12 overrides settings of the model

A params file, case.toml:
  torque = 500              # in the unit of the param's default
  tip_radius = \"0.5 mm\"

Exit status: 0 if the results were written, 1 if the model or its analysis failed, 2 for wrong usage
of the command.";

#[derive(Args)]
pub struct Run {
    /// The model (.cx file)
    file: PathBuf,
    #[command(flatten)]
    run: RunArguments,
    #[command(flatten)]
    allow: AllowPath,
    /// Format of messages on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    message_format: MessageFormat,
    /// Cancel the run at the end of standard input, when the program that started it has ended
    #[arg(long, hide = true)]
    cancel_at_end_of_input: bool,
}

/// Time in which a cancelled run writes its files before its process ends.
const GRACE: Duration = Duration::from_secs(8);

impl Run {
    /// Returns the format of warnings; `None` if only errors are printed.
    pub fn warnings(&self) -> Option<MessageFormat> {
        (!self.run.quiet).then_some(self.message_format)
    }

    pub fn run(self) -> ExitCode {
        let Run { file, run: arguments, allow, message_format: format, cancel_at_end_of_input } = self;
        if cancel_at_end_of_input {
            cancel_at_end_of(io::stdin());
        }
        if arguments.memory_limit.is_some() {
            // The check of the program frees its memory before the run.
            budget::share_one_arena();
        }
        let allowed = allow.paths();
        if arguments.print_params {
            return print_params(&file, &allowed, arguments.quiet, format);
        }
        let given = match arguments.given() {
            Ok(given) => given,
            Err(refused) => {
                format.refused(&refused);
                return ExitCode::from(USAGE);
            }
        };
        let overrides = arguments.overrides.to_override();
        let check = || {
            let checked = check_run_within(&file, &allowed, &given, overrides, arguments.memory_limit)?;
            MessageFormat::printed_before_error(&checked, arguments.json);
            Ok(checked)
        };
        let (module, before) = match compile(&file, arguments.quiet, format, check) {
            Ok(compiled) => compiled,
            Err(status) => return status,
        };
        let directory = arguments.out.clone().unwrap_or_else(|| default_directory(&file));
        let messages = RunMessages { module: &module, format };
        if module.has_errors() {
            return ExitCode::from(refused_by_check(&directory, &messages));
        }
        let command = RunCommand {
            program: module.as_program(),
            arguments: &arguments,
            before,
            default_directory: directory,
            messages: &messages,
            // Progress bars only in text format.
            silent: format == MessageFormat::Json,
        };
        ExitCode::from(command.execute(given))
    }
}

/// Cancels the run at the end of a stream, as Ctrl-C does. A process that is killed closes its
/// pipes, so that no run outlives the studio that started it.
fn cancel_at_end_of(mut stream: impl Read + Send + 'static) {
    thread::spawn(move || {
        // An error ends the stream as well.
        let _ = io::copy(&mut stream, &mut io::sink());
        interrupt::flag().cancel();
        thread::sleep(GRACE);
        process::exit(i32::from(MODEL_ERROR));
    });
}

fn print_params(file: &Path, allowed: &Arc<[PathBuf]>, quiet: bool, format: MessageFormat) -> ExitCode {
    match checked(file, quiet, format, || check_file_allowing(file, allowed)) {
        Ok(checked) => {
            println!("{:#}", schema(&checked.description));
            ExitCode::SUCCESS
        }
        Err(status) => status,
    }
}

/// Printer of the messages of a run, with source lines.
struct RunMessages<'m> {
    module: &'m Module,
    format: MessageFormat,
}

impl Messages for RunMessages<'_> {
    fn refused(&self, why: &InvalidParam) {
        self.format.refused(why);
    }

    fn error(&self, error: &RuntimeError) {
        self.format.diagnostics(&[self.module.error(error)], self.module.files());
    }

    fn findings(&self, findings: &[Finding]) {
        self.format.diagnostics(&self.module.findings(findings), self.module.files());
    }

    fn warning(&self, text: &str) {
        self.format.warning(text);
    }

    fn note(&self, text: &str) {
        self.format.note(&format!("{text}\n"));
    }
}
