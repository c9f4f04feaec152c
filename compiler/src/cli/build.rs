//! `calyx build`: a model as an executable, an object file, a library or a header.

use crate::allow::AllowPath;
use crate::compile::checked;
use crate::messages::{MODEL_ERROR, MessageFormat};
use calyx::build::{BuildOptions, Built, Emit, TargetCpu, build};
use calyx::check_file_allowing;
use calyx::rt::shell;
use clap::{Args, ValueEnum};
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx build pair.cx                          ./pair, an executable
  calyx build pair.cx -o bin/pair --target-cpu native
  calyx build pair.cx --emit lib,header        libpair.a and pair.h, for a program in C
  CC=clang calyx build pair.cx
  calyx build pair.cx --bundle                 needs no linker; the executable is as large as calyx

Exit status: 0 if everything was built, 1 if the model has errors or cannot be built, 2 for wrong
usage of the command.";

/// Kind of output.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Kind {
    /// NAME: an executable
    Exe,
    /// NAME.o: machine code of the model, to be linked with libcalyx_rt.a
    Obj,
    /// libNAME.a: a library with model and engine
    Lib,
    /// NAME.h: the header for C and C++
    Header,
}

/// Target processors of the code.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Cpu {
    /// All processors of this architecture
    #[default]
    Baseline,
    /// This processor and those with the same instruction sets
    Native,
}

#[derive(Args)]
pub struct Build {
    /// The model (.cx file)
    file: PathBuf,
    /// Output file; extensions of other kinds are added [default: the model's path without its
    /// extension]
    #[arg(short, long, value_name = "NAME")]
    output: Option<PathBuf>,
    /// Kinds of output, separated by commas
    #[arg(long, value_enum, value_delimiter = ',', default_value = "exe", value_name = "KIND")]
    emit: Vec<Kind>,
    /// Target processors of the model's code; results are identical on all
    #[arg(long, value_enum, default_value_t, value_name = "CPU")]
    target_cpu: Cpu,
    /// Keep function names in the executable, for debuggers and profilers
    #[arg(long)]
    keep_symbols: bool,
    /// Make the executable a copy of `calyx` with the compiled model attached
    ///
    /// Such an executable is larger, but requires neither a linker nor the runtime library. This is
    /// also the fallback if the runtime library is not found, as after `cargo install`. An
    /// executable is machine code: run only executables from sources you trust.
    #[arg(long)]
    bundle: bool,
    /// Replace files that `calyx build` did not write
    ///
    /// Without this option, only output files of an earlier build are replaced.
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    allow: AllowPath,
    /// Format of messages on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    message_format: MessageFormat,
}

impl Build {
    pub fn run(self) -> ExitCode {
        let format = self.message_format;
        let checked =
            match checked(&self.file, false, format, || check_file_allowing(&self.file, &self.allow.paths()))
            {
                Ok(checked) => checked,
                Err(status) => return status,
            };
        let emit = self.emit.iter().map(|kind| match kind {
            Kind::Exe => Emit::Executable,
            Kind::Obj => Emit::Object,
            Kind::Lib => Emit::Library,
            Kind::Header => Emit::Header,
        });
        let cpu = match self.target_cpu {
            Cpu::Baseline => TargetCpu::Baseline,
            Cpu::Native => TargetCpu::Native,
        };
        let (bundle, bundle_without_library) = match std::env::current_exe() {
            Ok(calyx) if self.bundle => (Some(calyx), None),
            Ok(calyx) => (None, Some(calyx)),
            Err(_) if !self.bundle => (None, None),
            Err(error) => {
                format.failure(
                    &format!("`calyx` cannot find its own file: {error}"),
                    "build without `--bundle`",
                );
                return ExitCode::from(MODEL_ERROR);
            }
        };
        let output = self.output.unwrap_or_else(|| self.file.with_extension(""));
        let options = BuildOptions {
            emit: emit.collect(),
            cpu,
            keep_symbols: self.keep_symbols,
            bundle,
            bundle_without_library,
            force: self.force,
            ..BuildOptions::executable(output)
        };
        match build(&checked, &options) {
            Ok(built) => {
                if checked.has_errors() {
                    format.note("the executable will report the same, unless it is run with other params\n");
                }
                built.iter().for_each(|built| format.note(&description(built)));
                ExitCode::SUCCESS
            }
            Err(error) => {
                format.failure(&error.to_string(), &error.help());
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}

/// Returns one line about a file: its size, requirements and usage.
fn description(built: &Built) -> String {
    let Built { path, size, .. } = built;
    let shown = shell::path(path);
    let size = shown_size(*size);
    match built.emit {
        Emit::Executable if built.why_bundled.is_some() => {
            let why = built.why_bundled.as_deref().unwrap_or_default();
            format!(
                "{shown}: {size}, a copy of `calyx` with the model, as by --bundle, because {why}; run it with {} --help\n",
                shell::command(path)
            )
        }
        Emit::Executable => {
            let needs =
                built.glibc.map(|floor| format!(", needs glibc {floor} or newer")).unwrap_or_default();
            format!("{shown}: {size}{needs}; run it with {} --help\n", shell::command(path))
        }
        Emit::Object => format!("{shown}: {size}; link it with your program and libcalyx_rt.a\n"),
        Emit::Library => {
            format!("{shown}: {size}; link it with: cc PROGRAM.c {shown} -lm -lpthread -ldl\n")
        }
        Emit::Header => format!("{shown}: interface of the library, params and outputs of the model\n"),
    }
}

/// Formats a size in megabytes, or in kilobytes below 0.1 MB.
fn shown_size(bytes: u64) -> String {
    match bytes as f64 {
        bytes if bytes < 1e5 => format!("{:.1} kB", bytes / 1e3),
        bytes => format!("{:.1} MB", bytes / 1e6),
    }
}
