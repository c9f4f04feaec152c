//! `calyx test`: runs the `test function` items of files.

use crate::allow::AllowPath;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::rt::console::println;
use calyx::testing::{Outcome, Tested, files_with_tests, test_file};
use calyx_lang::render::to_json;
use clap::Args;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx test                        every test below this directory
  calyx test shapes.cx --filter area
  calyx test --message-format json

A test is a function without parameters that asserts:

  function area(in d) { return pi * d^2 / 4; }
  test function area_of_a_disc() {
      assert(abs(area(2 mm) - pi * 1 mm^2) < 1e-12 mm^2);
  }

It sees functions, constants, records and params (at their defaults), not the variables of the
model, and runs on its own. Nothing is solved. Exit status: 0 if all tests passed, 1 if one failed,
2 for wrong usage of the command.";

#[derive(Args)]
pub struct Test {
    /// A file, or a directory whose files are searched for tests
    #[arg(default_value = ".")]
    path: PathBuf,
    /// Run only tests whose names contain this text
    #[arg(long, value_name = "NAME", default_value = "", hide_default_value = true)]
    filter: String,
    #[command(flatten)]
    allow: AllowPath,
    /// Format of results: text, or one JSON object per line
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    message_format: MessageFormat,
}

impl Test {
    pub fn run(self) -> ExitCode {
        let format = self.message_format;
        let files = match files_with_tests(&self.path) {
            Ok(files) => files,
            Err(error) => return format.unreadable(&self.path, &error),
        };
        let allowed = self.allow.paths();
        let (mut passed, mut failed, mut broken) = (0, 0, 0);
        for file in &files {
            let tested = match test_file(file, &allowed, &self.filter) {
                Ok(tested) => tested,
                Err(error) => return format.unreadable(file, &error),
            };
            self.show(file, &tested);
            passed += tested.passed();
            failed += tested.failed();
            broken += usize::from(!tested.errors.is_empty());
        }
        self.summary(passed, failed, broken);
        if passed + failed + broken == 0 {
            let help = "a test is `test function name() { assert(...); }`";
            format.failure("there is no such test", help);
            return ExitCode::from(USAGE);
        }
        if failed + broken == 0 { ExitCode::SUCCESS } else { ExitCode::from(MODEL_ERROR) }
    }

    fn show(&self, file: &Path, tested: &Tested) {
        self.message_format.diagnostics(&tested.errors, &tested.files);
        if self.message_format == MessageFormat::Json {
            return tested.outcomes.iter().for_each(|outcome| println!("{}", as_json(file, outcome, tested)));
        }
        if !tested.outcomes.is_empty() {
            println!("{}", file.display());
        }
        for outcome in &tested.outcomes {
            let Some(failure) = &outcome.failure else {
                println!("  ok      {}", outcome.name);
                continue;
            };
            println!("  FAILED  {}", outcome.name);
            outcome.lines.iter().for_each(|line| println!("          {line}"));
            self.message_format.diagnostics(std::slice::from_ref(failure), &tested.files);
        }
    }

    fn summary(&self, passed: usize, failed: usize, broken: usize) {
        if self.message_format == MessageFormat::Json {
            return println!(
                "{}",
                json!({ "passed": passed, "failed": failed, "files_with_errors": broken })
            );
        }
        let files = match broken {
            0 => String::new(),
            1 => ", 1 file with errors".into(),
            _ => format!(", {broken} files with errors"),
        };
        println!("{passed} passed, {failed} failed{files}");
    }
}

fn as_json(file: &Path, outcome: &Outcome, tested: &Tested) -> Value {
    let failure = outcome.failure.as_ref().map(|failure| to_json(failure, &tested.files));
    let diagnostic: Value = failure.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
    json!({
        "file": file.display().to_string(),
        "test": outcome.name,
        "passed": outcome.failure.is_none(),
        "printed": outcome.lines,
        "diagnostic": diagnostic,
    })
}
