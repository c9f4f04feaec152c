//! `calyx eval`: evaluates one expression.

use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::println;
use calyx::session::Session;
use clap::Args;
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx eval \"3 inch to mm\"
  calyx eval \"15 kW / 1500 rpm in N*m\"
  calyx eval --units inch_lbf_s \"200 GPa\"
  calyx eval --file pair.cx \"contact_ratio(24, 40)\"

`to` or `in` is followed by a unit or a product of units. Without it the result is in the unit system. With --file,
the functions and params of a file are available; its analyses are skipped.";

#[derive(Args)]
pub struct Eval {
    /// An expression in the syntax of a model
    expression: String,
    /// Unit system for bare numbers and the result: SI, mm_N_s or inch_lbf_s [default: the file's,
    /// or SI]
    #[arg(long, value_name = "SYSTEM")]
    units: Option<String>,
    /// A model or module whose declarations are available in the expression
    #[arg(long, value_name = "FILE")]
    file: Option<PathBuf>,
}

impl Eval {
    pub fn run(self) -> ExitCode {
        let session = match session(self.file, self.units) {
            Ok(session) => session,
            Err(status) => return status,
        };
        match session.evaluate(&self.expression) {
            Ok(value) => {
                println!("{value}");
                ExitCode::SUCCESS
            }
            Err(answer) => {
                MessageFormat::Human.diagnostics(&answer.diagnostics, &answer.files);
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}

/// Creates a session with the declarations of a file, in a unit system.
pub fn session(file: Option<PathBuf>, units: Option<String>) -> Result<Session, ExitCode> {
    let format = MessageFormat::Human;
    let mut session = Session::new();
    if let Some(file) = file {
        session.load(&file).map_err(|error| format.unreadable(&file, &error))?;
    }
    if let Some(units) = units
        && !session.set_units(&units)
    {
        format.failure(
            &format!("there is no unit system `{units}`"),
            "the unit systems are SI, mm_N_s and inch_lbf_s",
        );
        return Err(ExitCode::from(USAGE));
    }
    Ok(session)
}
