//! `calyx object`: a model as an object file.

use crate::compile::compile;
use crate::messages::{MODEL_ERROR, MessageFormat};
use calyx::check_file;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Example:
  calyx object pair.cx -o pair.o
  cc pair.o libcalyx_rt.a -lm -lpthread -ldl -o pair";

#[derive(Args)]
pub struct Object {
    /// The model, a .cx file
    file: PathBuf,
    /// The object file to write
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
}

impl Object {
    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let module = match compile(&self.file, false, format, || check_file(&self.file)) {
            Ok((module, _)) => module,
            Err(status) => return status,
        };
        let output = &self.output;
        let written = module.object().map_err(|error| error.to_string()).and_then(|bytes| {
            std::fs::write(output, bytes)
                .map_err(|error| format!("cannot write {}: {error}", output.display()))
        });
        match written {
            Ok(()) => {
                if module.has_errors() {
                    format.note("the executable will say the same, unless it is given params that mend it\n");
                }
                ExitCode::SUCCESS
            }
            Err(message) => {
                format.failure(&message, "");
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}
