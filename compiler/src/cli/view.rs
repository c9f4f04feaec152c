//! `calyx view`: writes the three-dimensional view of a run as one self-contained page.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::println;
use calyx::rt::directory::default_directory;
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::view::page::{self, PageError};
use clap::Args;
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "\
Examples:
  calyx view pair.cx.run                    writes pair.cx.run/scene.html, linked from the report
  calyx view pair.cx                        the same
  calyx view pair.cx --html to_mail.html    writes this file
  calyx run pair.cx --vtu                   adds deformed meshes with stresses to the view

Exit status: 0 if the page was written, 1 on errors, 2 if there is no run.";

#[derive(Args)]
pub struct View {
    /// The directory of a run, or the model file
    run: PathBuf,
    /// Write the page to this file instead of the directory of the run
    #[arg(long, value_name = "FILE")]
    html: Option<PathBuf>,
    /// Replace a file that this command did not write
    #[arg(long)]
    force: bool,
}

/// Reason why no page was written: message, remedy and exit status.
struct Failure(String, &'static str, u8);

impl View {
    pub fn run(self) -> ExitCode {
        let directory = if self.run.is_file() { default_directory(&self.run) } else { self.run.clone() };
        let written = match &self.html {
            Some(file) => self.write_file(&directory, file).map(|()| file.clone()),
            None => write_into(&directory, self.force),
        };
        match written {
            Ok(path) => {
                println!("{}", path.display());
                ExitCode::SUCCESS
            }
            Err(Failure(message, help, status)) => {
                MessageFormat::Human.failure(&message, help);
                ExitCode::from(status)
            }
        }
    }

    /// Writes the page to a file outside of the directory.
    fn write_file(&self, directory: &Path, file: &Path) -> Result<(), Failure> {
        let text = page_of(directory)?;
        if !self.force && file.exists() && !is_page(file) {
            let message = format!("{} exists, and `calyx view` did not write it", file.display());
            return Err(Failure(message, "choose another name, or replace it with --force", USAGE));
        }
        fs::write(file, text).map_err(|error| unwritable(file, &error))
    }
}

/// Writes the page into the directory of a run, and the report with a link to it.
fn write_into(directory: &Path, force: bool) -> Result<PathBuf, Failure> {
    let text = page_of(directory)?;
    let locked = RunDirectory::lock(directory, Kind::Run, force).map_err(|error| match error {
        DirectoryError::InUse { .. } => Failure(
            error.to_string(),
            "wait until the run has ended, or write the positions so far with --html FILE",
            MODEL_ERROR,
        ),
        other => Failure(other.to_string(), "choose a file outside of the directory with --html", USAGE),
    })?;
    let path = directory.join(page::NAME);
    let written = locked.claim(page::NAME).and_then(|path| fs::write(path, text));
    written.map_err(|error| unwritable(&path, &error))?;
    if calyx::rt::page::is_run(directory) {
        locked.write_page().map_err(|error| unwritable(directory, &error))?;
    }
    Ok(path)
}

fn page_of(directory: &Path) -> Result<String, Failure> {
    let shown = directory.display();
    page::page(directory).map_err(|error| match error {
        PageError::NoFiles if !calyx::rt::page::is_run(directory) => Failure(
            format!("there is no run in {shown}"),
            "name the directory that `calyx run` wrote, or its model",
            USAGE,
        ),
        PageError::NoFiles => Failure(
            format!("the run in {shown} has no files of the viewer"),
            "run the model again: a run without positions, and runs of older versions have none",
            USAGE,
        ),
        error @ PageError::Unreadable { .. } => {
            Failure(error.to_string(), "run the model again with `calyx run`", MODEL_ERROR)
        }
    })
}

fn unwritable(path: &Path, error: &io::Error) -> Failure {
    let help = match error.kind() {
        ErrorKind::AlreadyExists => "move the file away, or replace it with --force",
        _ => "check the path and its permissions",
    };
    Failure(format!("cannot write {}: {error}", path.display()), help, MODEL_ERROR)
}

/// Returns true if this command wrote a file.
fn is_page(file: &Path) -> bool {
    let mut start = Vec::new();
    let read = fs::File::open(file).and_then(|file| file.take(page::MARK_WITHIN).read_to_end(&mut start));
    read.is_ok() && String::from_utf8_lossy(&start).contains(page::MARK)
}
