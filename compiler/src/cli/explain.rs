//! `calyx explain`: the page behind a diagnostic code.

use crate::messages::{MessageFormat, USAGE};
use calyx::explain::{all, page, similar_codes};
use clap::Args;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx explain E0401
  calyx explain";

#[derive(Args)]
pub struct Explain {
    /// The code, like E0401
    code: Option<String>,
}

impl Explain {
    pub fn run(self) -> ExitCode {
        let Some(code) = self.code else {
            for explanation in all() {
                println!("{}  {}", explanation.code, explanation.title);
            }
            return ExitCode::SUCCESS;
        };
        if let Some(page) = page(&code) {
            print!("{page}");
            return ExitCode::SUCCESS;
        }
        let help = match similar_codes(&code).as_slice() {
            [] => "`calyx explain` lists all codes".to_owned(),
            near => format!("did you mean {}? `calyx explain` lists all codes", near.join(" or ")),
        };
        MessageFormat::Human.failure(&format!("there is no code `{code}`"), &help);
        ExitCode::from(USAGE)
    }
}
