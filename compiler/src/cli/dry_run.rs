//! `calyx sweep --dry-run`: lists the cases of a sweep with a predicted time, without solving them.

use calyx::check_run_within;
use calyx::rt::console::{print, println};
use calyx::rt::options::rates_file;
use calyx::rt::sweep::Sweep;
use calyx::rt::sweep_table::{Case, SweepTable};
use calyx::rt::tradeoff::text::seconds;
use calyx_abi::visible::visible;
use calyx_runtime::cost::Rates;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::Arc;

/// Largest number of cases of which each is planned; of more cases only the first one is.
const PLANNED: usize = 32;

/// Returns the predicted time of a sweep's first case on this machine, s; `None` if it is not
/// known.
pub fn predicted_time(file: &Path, sweep: &Sweep, allowed: &Arc<[PathBuf]>) -> Option<f64> {
    let (_, cases) = sweep.cases().ok()?;
    time_of(file, sweep, cases.first()?, allowed, &Rates::of_this_machine(rates_file().as_deref(), false))
}

/// Returns the predicted time of a case, s.
fn time_of(file: &Path, sweep: &Sweep, case: &Case, allowed: &Arc<[PathBuf]>, rates: &Rates) -> Option<f64> {
    let (given, overrides) = sweep.given_in(case);
    let checked = check_run_within(file, allowed, &given, overrides, None).ok()?;
    // A model without an analysis takes no time.
    Some(checked.plan.filter(|_| checked.refused.is_none())?.cost(rates).time_in_study())
}

/// Prints the cases. Each is planned, which solves nothing, to predict its time on this machine.
pub fn list(file: &Path, sweep: &Sweep, table: &SweepTable, allowed: &Arc<[PathBuf]>) -> ExitCode {
    let rates = Rates::of_this_machine(rates_file().as_deref(), false);
    let count = table.cases.len();
    let planned = if count > PLANNED { 1 } else { count };
    let times = table.cases[..planned].iter().map(|case| time_of(file, sweep, case, allowed, &rates));
    let times: Vec<Option<f64>> = times.collect();
    let shown = |time: &Option<f64>| time.map(seconds).unwrap_or_default();
    let mut cells: Vec<String> = times.iter().map(shown).collect();
    cells.resize(count, String::new());
    print!("{}", visible(&table.list(&cells)));
    let cases = if count == 1 { "1 case".to_owned() } else { format!("{count} cases") };
    let known: Vec<f64> = times.into_iter().flatten().collect();
    if known.is_empty() {
        println!("{cases}");
        return ExitCode::SUCCESS;
    }
    let total = known.iter().sum::<f64>() * if planned < count { count as f64 } else { 1.0 };
    let each = if planned < count { ", if each takes as long as the first" } else { "" };
    println!(
        "{cases}, predicted to take at most {} on this machine without cached structures{each}",
        seconds(total)
    );
    ExitCode::SUCCESS
}
