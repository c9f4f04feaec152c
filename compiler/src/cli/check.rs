//! `calyx check`: reports all errors of a model, and fixes them with `--fix`.

use crate::allow::AllowPath;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::elaborate::{Cancel, Extent, Ranges, check_ranges};
use calyx::fix::{Applied, fix_file};
use calyx::rt::console::eprintln;
use calyx::rt::options::given_of;
use calyx::rt::settings_override::OverrideArguments;
use calyx::rt::{Override, ParamAssignment};
use calyx::{Checked, check_file_allowing, check_run_within};
use calyx_lang::diagnostic::Severity;
use clap::Args;
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx check pair.cx
  calyx check pair.cx --fix
  calyx check pair.cx --ranges
  calyx check pair.cx --set torque=500        what `calyx run` with these values would check
  calyx check pair.cx --message-format json 2> messages.jsonl

Exit status: 0 without errors, 1 with errors, 2 for wrong usage of the command.";

/// Options that `--fix` and `--ranges`, which check the model as it is written, do not accept.
const GIVEN_VALUES: [&str; 3] = ["set", "params", "OverrideArguments"];

#[derive(Args)]
pub struct Check {
    /// The model (.cx file)
    file: PathBuf,
    /// Apply unambiguous fixes to the model and the modules in its directory, then check again
    #[arg(long, conflicts_with_all = GIVEN_VALUES)]
    fix: bool,
    /// Set a param of the model, see `calyx run`; only these values are checked
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value)]
    set: Vec<ParamAssignment>,
    /// Read params from FILE.json or FILE.toml, see `calyx run`
    #[arg(long, value_name = "FILE")]
    params: Option<PathBuf>,
    /// Build the model also at the other values of its integer, Boolean and choice params, and at
    /// the ends of the ranges of its other params
    ///
    /// One param is varied at a time, then two. Of a range with many values, 32 are tried, or fewer
    /// if there are many params. Without this option, a few values of each param are tried; fewer
    /// if the model makes many gears or runs long.
    #[arg(long, conflicts_with_all = GIVEN_VALUES)]
    ranges: bool,
    #[command(flatten)]
    allow: AllowPath,
    /// Format of messages on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    message_format: MessageFormat,
    #[command(flatten)]
    overrides: OverrideArguments,
}

/// Number of params that the note on unchecked values names.
const MOST_NAMED: usize = 3;

/// Returns the names of params, each with its number of checked and of allowed values.
fn listed(cut: &[(String, usize, usize)]) -> String {
    let named = cut.iter().take(MOST_NAMED);
    let mut parts: Vec<String> =
        named.map(|(param, tried, allowed)| format!("`{param}` ({tried} of {allowed})")).collect();
    let others = cut.len().saturating_sub(MOST_NAMED);
    if others > 0 {
        parts.push(format!("{others} more"));
    }
    parts.join(", ")
}

impl Check {
    pub fn run(self) -> ExitCode {
        let format = self.message_format;
        let given = match given_of(self.params.as_deref(), &self.set) {
            Ok(given) => given,
            Err(refused) => {
                format.refused(&refused);
                return ExitCode::from(USAGE);
            }
        };
        let (allowed, overrides) = (self.allow.paths(), self.overrides.to_override());
        // As for a run, values that are given replace the defaults.
        let is_given = !given.is_empty() || overrides != Override::default();
        let check = || {
            if is_given {
                check_run_within(&self.file, &allowed, &given, overrides, None)
            } else {
                check_file_allowing(&self.file, &allowed)
            }
        };
        let mut checked = match if self.fix { self.fixed() } else { check() } {
            Ok(checked) => checked,
            Err(error) => return format.unreadable(&self.file, &error),
        };
        MessageFormat::printed_before_error(&checked, false);
        let extent = if self.ranges { Extent::Pairs } else { Extent::Cheap };
        let ranges = if is_given {
            Ranges::default()
        } else {
            check_ranges(&checked, extent, &Cancel::default()).unwrap_or_default()
        };
        checked.diagnostics.extend(ranges.found);
        format.diagnostics(&checked.diagnostics, &checked.files);
        if let Some(refused) = &checked.refused {
            format.refused(refused);
            return ExitCode::from(USAGE);
        }
        if self.ranges {
            for (param, tried, allowed) in &ranges.cut {
                format.note(&format!("`{param}` was checked at {tried} of its {allowed} values\n"));
            }
            if let Some((tried, allowed)) = ranges.cut_pairs {
                format.note(&format!("{tried} of {allowed} combinations of two params were checked\n"));
            }
        } else if !ranges.cut.is_empty() && !checked.has_errors() {
            format.note(&format!(
                "only some values were checked: {}; `--ranges` tries more\n",
                listed(&ranges.cut)
            ));
        }
        format.note(&self.summary(&checked, is_given));
        if checked.has_errors() { ExitCode::from(MODEL_ERROR) } else { ExitCode::SUCCESS }
    }

    fn fixed(&self) -> std::io::Result<Checked> {
        let fixed = fix_file(&self.file, &self.allow.paths())?;
        for Applied { file, line, column, code, title } in &fixed.applied {
            match self.message_format {
                MessageFormat::Human => {
                    let text = format!("fixed {code} at {file}:{line}:{column}: {title}\n");
                    self.message_format.note(&text);
                }
                MessageFormat::Json => {
                    let place = json!({ "file": file, "line": line, "column": column });
                    eprintln!("{}", json!({ "fixed": code, "title": title, "primary": place }));
                }
            }
        }
        if fixed.applied.is_empty() {
            self.message_format.note("nothing that is certain to fix\n");
        }
        Ok(fixed.checked)
    }

    /// Returns the last lines: the number of warnings of a model without errors, and the number of
    /// findings that `--fix` can fix.
    fn summary(&self, checked: &Checked, is_given: bool) -> String {
        let fixes = checked.diagnostics.iter().filter(|diagnostic| diagnostic.fix.is_some()).count();
        let file = calyx::rt::shell::path(&self.file);
        let offer = match fixes {
            0 => String::new(),
            _ => format!("{fixes} of these can be fixed automatically with `calyx check --fix {file}`\n"),
        };
        if checked.has_errors() {
            return offer;
        }
        let warnings = checked.diagnostics.iter().filter(|d| d.severity == Severity::Warning).count();
        let warnings = match warnings {
            0 => "no warnings".to_owned(),
            1 => "1 warning".to_owned(),
            _ => format!("{warnings} warnings"),
        };
        let values = if is_given { " with the given values" } else { "" };
        format!("{}{values}: no errors, {warnings}\n{offer}", self.file.display())
    }
}
