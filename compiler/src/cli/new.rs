//! `calyx new`: creates a model from a template.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::eprintln;
use calyx::rt::shell;
use clap::{Args, ValueEnum};
use std::fs::{self, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx new pair                            directory pair with pair.cx, two spur gears in mesh
  calyx new pair.cx                         only the file
  calyx new pair --template helical_pair    two helical gears
  calyx new planet --template frames        kinematics without gears";

/// Template of a model.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
#[value(rename_all = "snake_case")]
enum Template {
    /// Two spur gears in mesh: transmission error, load share, contact pressure, root stress
    #[default]
    SpurPair,
    /// Two helical gears in mesh, with misalignment
    HelicalPair,
    /// A pinion in an internal gear
    InternalPair,
    /// A spur pair of explicit bodies, frames and a mesh, for other shafts and loads
    Bodies,
    /// Moving frames: a planet on its carrier, positions and velocities
    Frames,
    /// Quantities, functions and a table of results, without gears
    Calculation,
}

impl Template {
    fn text(self) -> &'static str {
        match self {
            Template::SpurPair => include_str!("../../templates/spur_pair.cx"),
            Template::HelicalPair => include_str!("../../templates/helical_pair.cx"),
            Template::InternalPair => include_str!("../../templates/internal_pair.cx"),
            Template::Bodies => include_str!("../../templates/bodies.cx"),
            Template::Frames => include_str!("../../templates/frames.cx"),
            Template::Calculation => include_str!("../../templates/calculation.cx"),
        }
    }
}

#[derive(Args)]
pub struct New {
    /// The directory to create, or the file if the name ends in .cx
    name: PathBuf,
    /// Subject of the model
    #[arg(long, value_enum, default_value_t, value_name = "TEMPLATE")]
    template: Template,
}

impl New {
    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let Some((directory, file)) = self.places() else {
            format.failure(
                &format!("`{}` cannot be the name of a model", self.name.display()),
                "give a name like `pair`",
            );
            return ExitCode::from(USAGE);
        };
        match write(directory.as_deref(), &file, self.template.text()) {
            Ok(()) => {
                eprintln!("wrote {}", file.display());
                let shown = shell::path(&file);
                eprintln!("check it:  calyx check {shown}\nrun it:    calyx run {shown}");
                ExitCode::SUCCESS
            }
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                let taken = directory.unwrap_or(file);
                format.failure(
                    &format!("{} is there already, and nothing is overwritten", taken.display()),
                    "choose another name",
                );
                ExitCode::from(USAGE)
            }
            Err(error) => {
                format.failure(
                    &format!("cannot write {}: {error}", file.display()),
                    "choose a place where you may write",
                );
                ExitCode::from(MODEL_ERROR)
            }
        }
    }

    /// Returns the directory to create, if any, and the file to write.
    fn places(&self) -> Option<(Option<PathBuf>, PathBuf)> {
        let name = self.name.file_name()?;
        if self.name.extension().is_some_and(|extension| extension == "cx") {
            return Some((None, self.name.clone()));
        }
        let mut file = name.to_owned();
        file.push(".cx");
        Some((Some(self.name.clone()), self.name.join(file)))
    }
}

fn write(directory: Option<&Path>, file: &Path, text: &str) -> io::Result<()> {
    if let Some(directory) = directory {
        fs::create_dir(directory)?;
    }
    OpenOptions::new().write(true).create_new(true).open(file)?.write_all(text.as_bytes())
}
