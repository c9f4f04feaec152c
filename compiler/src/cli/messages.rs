//! How the command speaks: to people, or one JSON object a line to programs. Both go to standard error, so that standard
//! output holds what the model prints and nothing else.

use calyx::render;
use calyx::rt::{InvalidParam, report};
use calyx_abi::visible::visible;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::SourceFile;
use calyx_lang::render::to_json;
use clap::ValueEnum;
use serde_json::json;
use std::path::Path;
use std::process::ExitCode;

/// The model, or its analysis, is wrong.
pub const MODEL_ERROR: u8 = 1;
/// The command was not used as it can be.
pub const USAGE: u8 = 2;

/// Who reads what the command says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
pub enum MessageFormat {
    /// Text with an excerpt of the source
    #[default]
    Human,
    /// One JSON object per line
    Json,
}

impl MessageFormat {
    /// Says diagnostics.
    pub fn diagnostics(self, diagnostics: &[Diagnostic], files: &[SourceFile]) {
        match self {
            MessageFormat::Human => eprint!("{}", render(diagnostics, files)),
            MessageFormat::Json => {
                diagnostics.iter().for_each(|found| eprintln!("{}", to_json(found, files)))
            }
        }
    }

    /// Says what is wrong with something other than a place in a text.
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

    /// Says why a value given for a param cannot be used.
    pub fn refused(self, refused: &InvalidParam) {
        match self {
            MessageFormat::Human => eprint!("{}", report::refused(refused)),
            MessageFormat::Json => {
                let mut said = without_place("error", &refused.message, &refused.help);
                said["primary"] = refused.origin.as_ref().map_or(json!(null), report::place_json);
                eprintln!("{said}");
            }
        }
    }

    /// Says what deserves a second look and has no place in a text.
    pub fn warning(self, message: &str) {
        match self {
            MessageFormat::Human => eprintln!("warning: {}", visible(message)),
            MessageFormat::Json => eprintln!("{}", without_place("warning", message, "")),
        }
    }

    /// Says what only people want to know.
    pub fn note(self, text: &str) {
        if self == MessageFormat::Human {
            eprint!("{}", visible(text));
        }
    }

    /// A model's file that cannot be read.
    pub fn unreadable(self, file: &Path, error: &std::io::Error) -> ExitCode {
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
