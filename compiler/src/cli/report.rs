//! `calyx report`: regenerates the report of a run from its directory.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::println;
use calyx::rt::directory::default_directory;
use calyx::rt::page;
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use clap::Args;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "\
Examples:
  calyx report pair.cx.run          writes pair.cx.run/report.html
  calyx report pair.cx              the same

Exit status: 0 if the report was written, 1 on errors, 2 if there is no run.";

#[derive(Args)]
pub struct Report {
    /// The directory of a run, or the model file
    run: PathBuf,
}

impl Report {
    pub fn run(self) -> ExitCode {
        let directory = if self.run.is_file() { default_directory(&self.run) } else { self.run };
        let shown = directory.display();
        let (what, help, status) = match write(&directory) {
            Ok(path) => {
                println!("{}", path.display());
                return ExitCode::SUCCESS;
            }
            Err(DirectoryError::InUse { path, owner }) => (
                format!("a run writes to {}: {owner}", path.display()),
                "wait until it has ended; its report is made then",
                MODEL_ERROR,
            ),
            Err(error @ (DirectoryError::Foreign { .. } | DirectoryError::InTheWay { .. })) => {
                (error.to_string(), "name the directory that `calyx run` wrote; move other files away", USAGE)
            }
            Err(DirectoryError::Io { error, .. }) if error.kind() == ErrorKind::NotFound => (
                format!("there is no run in {shown}"),
                "name the directory that `calyx run` wrote, or its model",
                USAGE,
            ),
            Err(DirectoryError::Io { error, .. }) => (
                format!("cannot make the report of {shown}: {error}"),
                "the run may be one of another version of Calyx: run the model again",
                MODEL_ERROR,
            ),
        };
        MessageFormat::Human.failure(&what, help);
        ExitCode::from(status)
    }
}

/// Writes the report of the run in a directory while no run writes to it.
fn write(directory: &Path) -> Result<PathBuf, DirectoryError> {
    let unreadable = |error| DirectoryError::Io { path: directory.to_owned(), error };
    // Nothing is written if the directory contains no run.
    if !page::is_run(directory) {
        return Err(unreadable(ErrorKind::NotFound.into()));
    }
    let locked = RunDirectory::lock(directory, Kind::Run, false)?;
    locked.write_page().map_err(unreadable)
}
