//! `calyx explain`: prints the page of a diagnostic code, or the gear data and the plan of a model.

use crate::allow::AllowPath;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE};
use calyx::explain::{all, page, similar_codes};
use calyx::rt::ParamAssignment;
use calyx::rt::console::{print, println};
use calyx::rt::options::rates_file;
use calyx::rt::settings_override::OverrideArguments;
use calyx::{Checked, check_run_within};
use calyx_abi::visible::visible;
use calyx_runtime::cost::Rates;
use clap::Args;
use std::io;
use std::path::Path;
use std::process::ExitCode;

pub const EXAMPLES: &str = "Examples:
  calyx explain E0401
  calyx explain
  calyx explain pair.cx --set torque=500
  calyx explain pair.cx --fidelity finest      before running it";

#[derive(Args)]
pub struct Explain {
    /// A diagnostic code such as E0401, or a model (.cx file): its gears and its planned analysis
    #[arg(value_name = "CODE or FILE")]
    subject: Option<String>,
    /// Set a param of the model, see `calyx run`
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value)]
    set: Vec<ParamAssignment>,
    #[command(flatten)]
    overrides: OverrideArguments,
    /// Measure the speed of this machine again, for predictions of computing time
    ///
    /// Takes a tenth of a second. The result is stored in the structure cache (see `calyx run
    /// --help`).
    #[arg(long)]
    recalibrate: bool,
    #[command(flatten)]
    allow: AllowPath,
}

impl Explain {
    pub fn run(self) -> ExitCode {
        let Some(subject) = self.subject else {
            for explanation in all() {
                println!("{}  {}", explanation.code, explanation.title);
            }
            return ExitCode::SUCCESS;
        };
        if Path::new(&subject).extension().is_some_and(|extension| extension == "cx") {
            let overrides = self.overrides.to_override();
            let check = |file: &Path| check_run_within(file, &self.allow.paths(), &self.set, overrides, None);
            return plan(Path::new(&subject), check, self.recalibrate);
        }
        if let Some(page) = page(&subject) {
            print!("{page}");
            return ExitCode::SUCCESS;
        }
        let help = match similar_codes(&subject).as_slice() {
            [] => "`calyx explain` lists all codes".to_owned(),
            near => format!("did you mean {}? `calyx explain` lists all codes", near.join(" or ")),
        };
        MessageFormat::Human.failure(&format!("there is no code `{subject}`"), &help);
        ExitCode::from(USAGE)
    }
}

/// Prints the gear data of a model, and how it would be analysed.
fn plan(file: &Path, check: impl FnOnce(&Path) -> io::Result<Checked>, recalibrate: bool) -> ExitCode {
    let format = MessageFormat::Human;
    let checked = match check(file) {
        Ok(checked) => checked,
        Err(error) => return format.unreadable(file, &error),
    };
    MessageFormat::printed_before_error(&checked, false);
    format.diagnostics(&checked.diagnostics, &checked.files);
    if let Some(refused) = &checked.refused {
        format.refused(refused);
        return ExitCode::from(USAGE);
    }
    if checked.plan.is_none() && checked.has_errors() {
        return ExitCode::from(MODEL_ERROR);
    }
    if !checked.gear_data.is_empty() {
        println!("{}", visible(&checked.gear_data.text()));
    }
    match &checked.plan {
        Some(plan) => {
            let rates = Rates::of_this_machine(rates_file().as_deref(), recalibrate);
            print!("{}\n{}", visible(&plan.text()), visible(&plan.cost(&rates).text()));
            println!("  {}", plan.disk().text());
        }
        None => println!("There is nothing to analyse: no two bodies mesh."),
    }
    ExitCode::SUCCESS
}
