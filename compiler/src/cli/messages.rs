//! Messages of the command: text for users, or one JSON object per line for programs. Both go to
//! standard error, so that standard output contains only what the model prints.

use calyx::rt::console::{eprint, eprintln};
use calyx::rt::run_directory::DirectoryError;
use calyx::rt::{InvalidParam, messages};
use calyx::{Checked, render};
use calyx_abi::visible::visible;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::SourceFile;
use calyx_lang::render::to_json;
use clap::ValueEnum;
use serde_json::json;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Returns the directory next to a model whose name is that of the model with a suffix.
pub fn beside(model: &Path, suffix: &str) -> PathBuf {
    let mut name = model.file_name().unwrap_or_default().to_owned();
    name.push(suffix);
    model.with_file_name(name)
}

/// Exit status: the model or its analysis has errors.
pub const MODEL_ERROR: u8 = 1;
/// Exit status: invalid arguments.
pub const USAGE: u8 = 2;

/// Format of messages.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum MessageFormat {
    /// Text with an excerpt of the source
    #[default]
    Human,
    /// One JSON object per line
    Json,
}

impl MessageFormat {
    /// Prints diagnostics.
    pub fn diagnostics(self, diagnostics: &[Diagnostic], files: &[SourceFile]) {
        match self {
            MessageFormat::Human => eprint!("{}", render(diagnostics, files)),
            MessageFormat::Json => {
                diagnostics.iter().for_each(|found| eprintln!("{}", to_json(found, files)))
            }
        }
    }

    /// Prints what a model with errors printed before the first one, on standard output, or on
    /// standard error if that has other contents. A model without errors prints when it runs.
    pub fn printed_before_error(checked: &Checked, to_error: bool) {
        if !checked.has_errors() || checked.printed.is_empty() {
            return;
        }
        let text = checked.printed.join("\n");
        // A reader that closes the pipe early is no error.
        let _ = match to_error {
            true => writeln!(io::stderr(), "{text}"),
            false => writeln!(io::stdout(), "{text}"),
        };
    }

    /// Prints an error without a source location.
    pub fn failure(self, message: &str, help: &str) {
        match self {
            MessageFormat::Human => {
                eprintln!("error: {}", visible(message));
                if !help.is_empty() {
                    eprintln!("  help: {}", visible(help));
                }
            }
            MessageFormat::Json => eprintln!("{}", without_place("error", message, help)),
        }
    }

    /// Prints the reason why a value given for a param is invalid.
    pub fn refused(self, refused: &InvalidParam) {
        match self {
            MessageFormat::Human => eprint!("{}", messages::refused(refused)),
            MessageFormat::Json => {
                let mut said = without_place("error", &refused.message, &refused.help);
                said["primary"] = refused.origin.as_ref().map_or(json!(null), messages::place_json);
                eprintln!("{said}");
            }
        }
    }

    /// Prints a warning without a source location.
    pub fn warning(self, message: &str) {
        match self {
            MessageFormat::Human => eprintln!("warning: {}", visible(message)),
            MessageFormat::Json => eprintln!("{}", without_place("warning", message, "")),
        }
    }

    /// Prints a note in text format; omits it in JSON.
    pub fn note(self, text: &str) {
        if self == MessageFormat::Human {
            eprint!("{}", visible(text));
        }
    }

    /// Reports why results cannot be written to a directory.
    pub fn directory(self, error: &DirectoryError) -> ExitCode {
        self.failure(&error.to_string(), error.help());
        ExitCode::from(match error {
            DirectoryError::Foreign { .. } | DirectoryError::InTheWay { .. } => USAGE,
            DirectoryError::InUse { .. } | DirectoryError::Io { .. } => MODEL_ERROR,
        })
    }

    /// Reports a result that cannot be written.
    pub fn unwritable(self, path: &Path, error: &str) -> ExitCode {
        let message = format!("cannot write {}: {error}", path.display());
        self.failure(&message, "choose another directory with --out");
        ExitCode::from(MODEL_ERROR)
    }

    /// Reports a model file that cannot be read.
    pub fn unreadable(self, file: &Path, error: &io::Error) -> ExitCode {
        self.failure(
            &format!("cannot read {}: {error}", file.display()),
            "give the path of a model, like examples/spur_pair.cx",
        );
        ExitCode::from(USAGE)
    }
}

fn without_place(severity: &str, message: &str, help: &str) -> serde_json::Value {
    let help = (!help.is_empty()).then_some(help);
    json!({
        "severity": severity, "code": null, "message": message, "primary": null, "labels": [], "help": help, "fix": null,
    })
}
