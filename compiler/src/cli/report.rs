//! `calyx report`: the page of a run, made again from its directory.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::directory::default_directory;
use calyx::rt::page;
use clap::Args;
use std::io::ErrorKind;
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "\
Examples:
  calyx report pair.cx.run          writes pair.cx.run/report.html
  calyx report pair.cx              the same

Exit status: 0 when the page is written, 1 if it cannot be, 2 if there is no run.";

#[derive(Args)]
pub struct Report {
    /// The directory of a run, or its model
    run: PathBuf,
}

impl Report {
    pub fn run(self) -> ExitCode {
        let directory = if self.run.is_file() { default_directory(&self.run) } else { self.run };
        let shown = directory.display();
        let (what, help, status) = match page::write(&directory) {
            Ok(path) => {
                println!("{}", path.display());
                return ExitCode::SUCCESS;
            }
            Err(error) if error.kind() == ErrorKind::NotFound => (
                format!("there is no run in {shown}"),
                "name the directory that `calyx run` wrote, or its model",
                USAGE,
            ),
            Err(error) => (
                format!("cannot make the report of {shown}: {error}"),
                "the run may be one of another version of Calyx: run the model again",
                MODEL_ERROR,
            ),
        };
        MessageFormat::Human.failure(&what, help);
        ExitCode::from(status)
    }
}
