//! `calyx sweep`: solves a model at many values of its params.

use crate::allow::AllowPath;
use crate::compile::compile;
use crate::dry_run;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use calyx::check_run_within;
use calyx::rt::component_table;
use calyx::rt::console::print;
use calyx::rt::duty_cycle::{self, DutyCycle, PITTING_SLOPE};
use calyx::rt::options::{RunArguments, given_of};
use calyx::rt::page::sweep as page;
use calyx::rt::progress::{Progress, ProgressFormat};
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::settings_override::OverrideArguments;
use calyx::rt::sweep::{Axis, CaseFile, Durations, JOURNAL, Outcome, Sweep as Cases};
use calyx::rt::sweep_table::{PRINTED_TEXT, SweepTable};
use calyx::rt::{Engine, EngineConfig, Error, ModelDescription, ParamAssignment, RunError, interrupt};
use clap::Args;
use std::io;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::thread::available_parallelism;

pub const EXAMPLES: &str = "\
The values of an axis:
  --over torque=50..500:10            10 equally spaced numbers with both ends, in the unit of the param's default
  --over \"offset=-20 um..20 um:9\"     ends with a unit
  --over speed=100..10000:9log        equally spaced on a logarithmic scale
  --over torque=50,200,800            a list
  --over fidelity=analytic,medium     a list of choices
  --over \"coast=*\"                    all choices of a text or Boolean param

Load cases in a file, with param names in the first line and optional columns `name` and `duration`:
  name,torque,speed,duration
  drive,120 N*m,3000 rpm,400 hour
  coast,-40 N*m,3000 rpm,100 hour

With load cases, sweep.html and component_loads.csv have the loads of all meshes and bearings by case. A column `duration` makes the
cases a duty cycle with equivalent values in sweep.html and duty_cycle.csv. Its entries are times with a unit, percentages that add up
to 100 %, or plain numbers, of which only the proportions count. If the model has a param `duration`, the column is the param instead.

Examples:
  calyx sweep pair.cx --over torque=50..500:10          results go to pair.cx.sweep
  calyx sweep pair.cx --over torque=50..500:10 --over \"slope=-20 um..20 um:9\"
  calyx sweep pair.cx --cases load_cases.csv --set fidelity=medium
  calyx sweep pair.cx --over torque=50..500:10          continues after an interruption
  calyx sweep pair.cx --cases load_cases.csv --dry-run  lists the cases without solving them

Several axes give all their combinations. A case has the same numbers as `calyx run` with these params, to the last bit. A case that
fails is a row with its reason.

Exit status: 0 if all cases were solved, 1 if the model or some cases failed, 2 for wrong usage of the command.";

#[derive(Args)]
pub struct Sweep {
    /// The model (.cx file)
    file: PathBuf,
    /// Vary a param: NAME=FROM..TO:COUNT, NAME=A,B,C or NAME=*; repeatable
    #[arg(long, value_name = "NAME=VALUES")]
    over: Vec<String>,
    /// Read cases from a CSV file with a column per param, and optional columns `name` and
    /// `duration`
    #[arg(long, value_name = "FILE")]
    cases: Option<PathBuf>,
    /// Slope p of the Woehler damage line for equivalent torques of meshes (ISO 6336-6); repeatable
    /// [default: 6.61, for pitting of hardened steels]
    #[arg(long, value_name = "P", value_parser = slope)]
    damage_slope: Vec<f64>,
    /// List the cases with a predicted time, without solving them or writing files
    #[arg(long)]
    dry_run: bool,
    /// Set a param in all cases, see `calyx run`
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value)]
    set: Vec<ParamAssignment>,
    /// Read params of all cases from FILE.json or FILE.toml, see `calyx run`
    #[arg(long, value_name = "FILE")]
    params: Option<PathBuf>,
    #[command(flatten)]
    overrides: OverrideArguments,
    #[command(flatten)]
    allow: AllowPath,
    /// Directory for the results [default: the model's file name with the suffix .sweep]
    ///
    /// Contains sweep.csv (one row per case), sweep.html, cases.jsonl (finished cases, from which
    /// an interrupted sweep continues), and with --cases component_loads.csv and duty_cycle.csv.
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Files with the names of results, such as sweep.csv, are replaced; all others are kept.
    #[arg(long)]
    force: bool,
    /// Number of threads, and of cases at a time [default: number of cores]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Do not use the structure cache on disk
    #[arg(long)]
    no_cache: bool,
    /// Print only the table and errors
    #[arg(long)]
    quiet: bool,
    /// Format of progress on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    progress: ProgressFormat,
}

impl Sweep {
    /// Returns the format of warnings; `None` if only errors are printed.
    pub fn warnings(&self) -> Option<MessageFormat> {
        (!self.quiet).then_some(MessageFormat::Human)
    }

    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let given = match given_of(self.params.as_deref(), &self.set) {
            Ok(given) => given,
            Err(refused) => {
                format.refused(&refused);
                return ExitCode::from(USAGE);
            }
        };
        if self.over.is_empty() && self.cases.is_none() {
            format.failure("the sweep varies nothing", "name a param, like `--over torque=50..500:10`");
            return ExitCode::from(USAGE);
        }
        let overrides = self.overrides.to_override();
        let check = || check_run_within(&self.file, &self.allow.paths(), &given, overrides, None);
        let (module, _) = match compile(&self.file, self.quiet, format, check) {
            Ok(compiled) => compiled,
            Err(status) => return status,
        };
        let program = module.as_program();
        let (axes, durations) = match self.axes(program.description()) {
            Ok(axes) => axes,
            Err(error) => return failed(format, &module, RunError::Run(error)),
        };
        let directory = self.out.clone().unwrap_or_else(|| beside(&self.file, ".sweep"));
        let threads = self.threads.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get);
        let store = RunArguments::store_of(None, self.no_cache);
        let sweep = Cases {
            program,
            given,
            overrides,
            axes,
            load_cases: self.cases.is_some(),
            durations,
            directory: directory.clone(),
            engine: Engine::new(EngineConfig { threads, store, ..EngineConfig::default() }),
            workers: threads,
            cancel: interrupt::flag(),
        };
        if self.dry_run {
            return match sweep.planned() {
                Ok(table) => dry_run::list(&self.file, &sweep, &table, &self.allow.paths()),
                Err(error) => failed(format, &module, RunError::Run(error)),
            };
        }
        let locked = RunDirectory::lock(&directory, Kind::Sweep, self.force).and_then(|locked| {
            let listed = locked.claim_all(["sweep.csv", "sweep.html", JOURNAL]);
            listed.map(|()| locked).map_err(|error| DirectoryError::Io { path: directory.clone(), error })
        });
        let locked = match locked {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        let progress = Progress::new(self.progress, self.quiet, true);
        progress.stage("cases");
        let outcome = sweep.run(|done, count| {
            if done > 0 {
                progress.step(done - 1, count)
            }
        });
        progress.finish();
        match outcome {
            Ok(outcome) => self.report(&outcome, &locked),
            Err(error) => failed(format, &module, error),
        }
    }

    /// Returns the axes, with that of the file of cases first, and the durations of its cases.
    fn axes(&self, description: &ModelDescription) -> Result<(Vec<Axis>, Option<Durations>), Error> {
        let (mut axes, mut durations) = (Vec::new(), None);
        if let Some(path) = &self.cases {
            let file = CaseFile::read(path, description)?;
            if file.duration_is_param && !self.quiet {
                MessageFormat::Human.note(
                    "`duration` is a param of the model, so that the column is its value, and the cases are no duty cycle\n",
                );
            }
            axes.push(file.axis);
            durations = file.durations;
        }
        for text in &self.over {
            axes.push(Axis::parse(text, description)?);
        }
        Ok((axes, durations))
    }

    /// Writes the results and prints the table.
    fn report(&self, outcome: &Outcome, directory: &RunDirectory) -> ExitCode {
        let format = MessageFormat::Human;
        let table = &outcome.table;
        let slopes = if self.damage_slope.is_empty() { &[PITTING_SLOPE][..] } else { &self.damage_slope };
        let cycle = DutyCycle::of(table, slopes);
        let values = cycle.as_ref().and_then(|cycle| cycle.as_ref().ok());
        if let Err(error) = write(directory, table, cycle.as_ref()) {
            return format.unwritable(directory.path(), &error.to_string());
        }
        print!("{}", table.text());
        if let Some(values) = values {
            print!("\n{}", values.text());
        }
        if !self.quiet {
            self.explain(outcome, cycle.as_ref(), directory.path());
        }
        let Outcome { count, .. } = outcome;
        if table.rows.len() < *count {
            let message = format!("interrupted after {} of {count} cases", table.rows.len());
            format.failure(&message, "run the same command again to continue");
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

    /// Prints notes about the results.
    fn explain(
        &self,
        Outcome { table, earlier, .. }: &Outcome,
        cycle: Option<&Result<DutyCycle, String>>,
        directory: &Path,
    ) {
        let format = MessageFormat::Human;
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
                format
                    .note("some values over the duty cycle are not available; sweep.html has the reasons\n");
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
}

/// Parses a slope of a damage line.
fn slope(text: &str) -> Result<f64, String> {
    let slope = text.parse().ok().filter(|slope: &f64| slope.is_finite() && *slope >= 1.0);
    slope.ok_or_else(|| "give a number of at least 1, like `--damage-slope 8.738`".to_owned())
}

/// Writes the files of a sweep, and removes those of an earlier sweep that this one does not have.
fn write(
    directory: &RunDirectory,
    table: &SweepTable,
    cycle: Option<&Result<DutyCycle, String>>,
) -> io::Result<()> {
    let path = directory.path();
    table.write(&path.join("sweep.csv"))?;
    page::write(&path.join("sweep.html"), table, cycle)?;
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

/// Prints the error of a sweep.
fn failed(format: MessageFormat, module: &calyx::Module, error: RunError) -> ExitCode {
    match error {
        RunError::Run(Error::Given(why)) => {
            format.refused(&why);
            ExitCode::from(USAGE)
        }
        RunError::Run(Error::Model(error)) => {
            format.diagnostics(&[module.error(&error)], module.files());
            ExitCode::from(MODEL_ERROR)
        }
        RunError::Ended { error, .. } => {
            format.diagnostics(&[module.error(&error)], module.files());
            ExitCode::from(MODEL_ERROR)
        }
        RunError::Directory(error) => format.directory(&error),
        RunError::Io { path, error } => format.unwritable(&path, &error.to_string()),
    }
}
