//! Results of a sweep: files, the printed table, and notes.

use crate::messages::{MODEL_ERROR, MessageFormat};
use calyx::rt::component_table;
use calyx::rt::console::print;
use calyx::rt::duty_cycle::{self, DutyCycle, PITTING_SLOPE};
use calyx::rt::page::sweep as page;
use calyx::rt::parquet_table;
use calyx::rt::run_directory::RunDirectory;
use calyx::rt::study::{self, EXPLAINED_VARIATION, Group, SAMPLE_STATISTICS};
use calyx::rt::sweep::Outcome;
use calyx::rt::sweep_table::{PRINTED_TEXT, SweepTable};
use std::io;
use std::path::Path;
use std::process::ExitCode;

/// How results are reported.
pub struct Report<'a> {
    pub quiet: bool,
    /// Slopes of damage lines; empty for the default.
    pub damage_slopes: &'a [f64],
    /// Remedy if cases are not finished; `None` if the caller reports them.
    pub to_continue: Option<&'a str>,
}

impl Report<'_> {
    /// Writes the results and prints the table.
    pub fn write(&self, outcome: &Outcome, directory: &RunDirectory) -> ExitCode {
        let format = MessageFormat::Human;
        let table = &outcome.table;
        let slopes = if self.damage_slopes.is_empty() { &[PITTING_SLOPE][..] } else { self.damage_slopes };
        let cycle = DutyCycle::of(table, slopes);
        let values = cycle.as_ref().and_then(|cycle| cycle.as_ref().ok());
        let groups = study::groups(table);
        if let Err(error) = write(directory, table, cycle.as_ref(), &groups) {
            return format.unwritable(directory.path(), &error.to_string());
        }
        match table.sample {
            // A sample has too many cases to print.
            Some(_) => print!("{}", study::text(table, &groups)),
            None => print!("{}", table.text()),
        }
        if let Some(values) = values {
            print!("\n{}", values.text());
        }
        if !self.quiet {
            explain(outcome, cycle.as_ref(), directory.path());
        }
        let Outcome { count, .. } = outcome;
        if table.rows.len() < *count {
            if let Some(help) = self.to_continue {
                format.failure(&format!("interrupted after {} of {count} cases", table.rows.len()), help);
            }
            return ExitCode::from(MODEL_ERROR);
        }
        match table.failures() {
            0 => ExitCode::SUCCESS,
            failures => {
                let message = format!("{failures} of {} cases failed", table.rows.len());
                format.failure(&message, "see the reason in the row of each");
                ExitCode::from(MODEL_ERROR)
            }
        }
    }
}

/// Prints notes about the results.
fn explain(
    Outcome { table, earlier, .. }: &Outcome,
    cycle: Option<&Result<DutyCycle, String>>,
    directory: &Path,
) {
    let format = MessageFormat::Human;
    if table.sample.is_some() {
        format.note("sweep.csv has the cases, sample_statistics.csv confidence intervals, and explained_variation.csv the influence of each param\n");
    }
    if table.unprinted() > 0 {
        let (all, left) = (table.outputs.len(), table.unprinted());
        format.note(&format!("the table shows {} of {all} outputs; sweep.csv has all\n", all - left));
    }
    if *earlier > 0 {
        let cases = if *earlier == 1 { "case was" } else { "cases were" };
        format.note(&format!("{earlier} {cases} solved before\n"));
    }
    match cycle {
        Some(Err(reason)) => format.note(&format!("no values over the duty cycle: {reason}\n")),
        Some(Ok(cycle)) if !cycle.missing.is_empty() => {
            format.note("some values over the duty cycle are not available; sweep.html has the reasons\n");
        }
        _ => {}
    }
    if table.has_printed() {
        format.note(&format!("text that the model prints is in {PRINTED_TEXT}\n"));
    }
    format.note(&format!("table and plots are in {}\n", directory.display()));
    if table.warned() > 0 {
        let cases = if table.warned() == 1 { "case has" } else { "cases have" };
        format.warning(&format!("{} {cases} warnings, see sweep.html", table.warned()));
    }
}

/// Writes the files of a sweep, and removes those of an earlier sweep that this one does not have.
fn write(
    directory: &RunDirectory,
    table: &SweepTable,
    cycle: Option<&Result<DutyCycle, String>>,
    groups: &[Group],
) -> io::Result<()> {
    table.write(&directory.claim("sweep.csv")?)?;
    directory.claim("sweep.parquet.part")?;
    parquet_table::write_sweep(&directory.claim(parquet_table::NAME)?, table)?;
    page::write(&directory.claim("sweep.html")?, table, cycle, groups)?;
    match table.sample {
        Some(_) => {
            study::write_statistics(&directory.claim(SAMPLE_STATISTICS)?, table, groups)?;
            study::write_explained_variation(&directory.claim(EXPLAINED_VARIATION)?, table, groups)?;
        }
        None => {
            directory.remove_owned(SAMPLE_STATISTICS)?;
            directory.remove_owned(EXPLAINED_VARIATION)?;
        }
    }
    match table.load_cases {
        true => component_table::write(&directory.claim(component_table::NAME)?, table)?,
        false => directory.remove_owned(component_table::NAME)?,
    }
    match cycle {
        Some(Ok(cycle)) => cycle.write(&directory.claim(duty_cycle::NAME)?)?,
        _ => directory.remove_owned(duty_cycle::NAME)?,
    }
    match table.has_printed() {
        true => table.write_printed(&directory.claim(PRINTED_TEXT)?),
        false => directory.remove_owned(PRINTED_TEXT),
    }
}
