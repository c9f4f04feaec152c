//! `calyx fmt`: formats models.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::replace::replace;
use calyx::rt::console::{eprintln, print, println};
use calyx_lang::format::{FormatError, format};
use calyx_lang::ir::SourceFile;
use clap::Args;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx fmt pair.cx
  calyx fmt --check models
  calyx fmt --stdin < pair.cx

Exit status: 0 on success, 1 if a file has syntax errors or, with --check, is not formatted, 2 for
wrong usage of the command.";

#[derive(Args)]
pub struct Fmt {
    /// Source files, or directories that are searched for .cx files [default: the current
    /// directory]
    #[arg(value_name = "FILE or DIR")]
    paths: Vec<PathBuf>,
    /// List files that are not formatted without changing them
    #[arg(long)]
    check: bool,
    /// Format standard input to standard output
    #[arg(long, conflicts_with = "paths")]
    stdin: bool,
}

/// Result of formatting a file.
enum Outcome {
    Unchanged,
    Changed,
    Failed,
}

impl Fmt {
    pub fn run(self) -> ExitCode {
        if self.stdin {
            return self.standard_input();
        }
        let mut files = Vec::new();
        let here = [PathBuf::from(".")];
        let paths = if self.paths.is_empty() { &here[..] } else { &self.paths };
        for path in paths {
            if let Err(error) = models(path, true, &mut files) {
                return MessageFormat::Human.unreadable(path, &error);
            }
        }
        let mut status = ExitCode::SUCCESS;
        for file in files {
            let outcome = self.file(&file).unwrap_or_else(|error| {
                MessageFormat::Human.failure(&format!("{}: {error}", file.display()), "");
                Outcome::Failed
            });
            match outcome {
                Outcome::Unchanged => {}
                Outcome::Changed if self.check => {
                    println!("{}", file.display());
                    status = ExitCode::from(MODEL_ERROR);
                }
                Outcome::Changed => eprintln!("formatted {}", file.display()),
                Outcome::Failed => status = ExitCode::from(MODEL_ERROR),
            }
        }
        status
    }

    fn file(&self, path: &Path) -> io::Result<Outcome> {
        let text = std::fs::read_to_string(path)?;
        let Some(formatted) = formatted(&path.display().to_string(), &text) else {
            return Ok(Outcome::Failed);
        };
        if formatted == text {
            return Ok(Outcome::Unchanged);
        }
        if !self.check {
            replace(path, &formatted)?;
        }
        Ok(Outcome::Changed)
    }

    fn standard_input(&self) -> ExitCode {
        let mut text = String::new();
        if let Err(error) = io::stdin().read_to_string(&mut text) {
            MessageFormat::Human.failure(&format!("cannot read standard input: {error}"), "");
            let not_utf8 = error.kind() == io::ErrorKind::InvalidData;
            return ExitCode::from(if not_utf8 { MODEL_ERROR } else { USAGE });
        }
        let Some(formatted) = formatted("<stdin>", &text) else { return ExitCode::from(MODEL_ERROR) };
        if self.check {
            return if formatted == text { ExitCode::SUCCESS } else { ExitCode::from(MODEL_ERROR) };
        }
        print!("{formatted}");
        ExitCode::SUCCESS
    }
}

/// Returns the formatted text; reports errors that prevent formatting.
fn formatted(name: &str, text: &str) -> Option<String> {
    match format(text) {
        Ok(formatted) => Some(formatted),
        Err(FormatError::Errors(errors)) => {
            let files = [SourceFile { name: name.into(), text: text.into() }];
            MessageFormat::Human.diagnostics(&errors, &files);
            MessageFormat::Human.note(&format!("{name} is left as it is\n"));
            None
        }
        Err(FormatError::WouldChange) => {
            let message = format!("{name} is left as it is: formatted, it would not be the same program");
            MessageFormat::Human.failure(&message, "this is a defect of calyx fmt; please report it");
            None
        }
    }
}

/// Adds a file, or the models in a directory and its subdirectories, sorted by name. Skips hidden
/// ones and links to directories unless they are `named`.
fn models(path: &Path, named: bool, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let directory = if named { path.metadata()?.is_dir() } else { path.symlink_metadata()?.is_dir() };
    if !directory {
        if named || path.extension().is_some_and(|extension| extension == "cx") {
            files.push(path.strip_prefix("./").unwrap_or(path).to_path_buf());
        }
        return Ok(());
    }
    let mut entries = Vec::new();
    for entry in std::fs::read_dir(path)? {
        let entry = entry?;
        if !entry.file_name().to_string_lossy().starts_with('.') {
            entries.push(entry.path());
        }
    }
    entries.sort();
    entries.iter().try_for_each(|entry| models(entry, false, files))
}
