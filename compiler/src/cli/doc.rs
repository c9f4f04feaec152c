//! `calyx doc`: generates reference pages.

use crate::allow::AllowPath;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::doc::{DocError, library, page, write};
use calyx::rt::console::eprintln;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx doc                      the library, into the directory doc
  calyx doc gears -o reference   one module
  calyx doc pair.cx shapes.cx    params, outputs and functions of your own files

Each page is a self-contained HTML file.";

#[derive(Args)]
pub struct Doc {
    /// Modules of the library, or .cx files [default: the whole library]
    modules: Vec<String>,
    /// Output directory
    #[arg(short, long, value_name = "DIR", default_value = "doc")]
    output: PathBuf,
    /// Replace files with the names of pages that `calyx doc` did not write
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    allow: AllowPath,
}

impl Doc {
    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let modules = if self.modules.is_empty() {
            library().into_iter().map(str::to_owned).collect()
        } else {
            self.modules
        };
        let allowed = self.allow.paths();
        let pages: Result<Vec<_>, _> = modules.iter().map(|name| page(name, &allowed)).collect();
        match pages.and_then(|pages| write(&pages, &self.output, self.force)) {
            Ok(first) => {
                eprintln!("wrote {}", first.display());
                ExitCode::SUCCESS
            }
            Err(DocError::Unknown { name, known }) => {
                format.failure(
                    &format!("there is no module `{name}`"),
                    &format!("the library has {}; a file of your own ends in .cx", known.join(", ")),
                );
                ExitCode::from(USAGE)
            }
            Err(DocError::Foreign { path }) => {
                format.failure(
                    &format!("{} is there already, and `calyx doc` did not write it", path.display()),
                    "choose another directory with -o, or replace it with --force",
                );
                ExitCode::from(USAGE)
            }
            Err(DocError::Io { path, error }) => {
                format.failure(&format!("{}: {error}", path.display()), "choose another directory with -o");
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}
