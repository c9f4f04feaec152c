//! `calyx sweep`: solves a model at many values of its params.

use crate::allow::AllowPath;
use crate::compile::compile;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use calyx::check_run_within;
use calyx::rt::console::print;
use calyx::rt::options::{RunArguments, given_of};
use calyx::rt::page::sweep as page;
use calyx::rt::progress::{Progress, ProgressFormat};
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::settings_override::OverrideArguments;
use calyx::rt::sweep::{Axis, JOURNAL, Outcome, Sweep as Cases};
use calyx::rt::{Engine, EngineConfig, Error, ParamAssignment, RunError, interrupt};
use clap::Args;
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

Load cases in a file, with param names in the first line and an optional column `name`:
  name,torque,speed
  drive,120 N*m,3000 rpm
  coast,-40 N*m,3000 rpm

Examples:
  calyx sweep pair.cx --over torque=50..500:10          results go to pair.cx.sweep
  calyx sweep pair.cx --over torque=50..500:10 --over \"slope=-20 um..20 um:9\"
  calyx sweep pair.cx --cases load_cases.csv --set fidelity=medium
  calyx sweep pair.cx --over torque=50..500:10          continues after an interruption

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
    /// Read cases from a CSV file with a column per param
    #[arg(long, value_name = "FILE")]
    cases: Option<PathBuf>,
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
    /// Contains sweep.csv (one row per case), sweep.html and cases.jsonl (finished cases, from
    /// which an interrupted sweep continues).
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
        let of_file = self.cases.iter().map(|path| Axis::of_file(path, program.description()));
        let of_options = self.over.iter().map(|text| Axis::parse(text, program.description()));
        let axes = match of_file.chain(of_options).collect::<Result<Vec<Axis>, Error>>() {
            Ok(axes) => axes,
            Err(error) => return failed(format, &module, RunError::Run(error)),
        };
        let directory = self.out.clone().unwrap_or_else(|| beside(&self.file, ".sweep"));
        let locked = RunDirectory::lock(&directory, Kind::Sweep, self.force).and_then(|locked| {
            let listed = locked.claim_all(["sweep.csv", "sweep.html", JOURNAL]);
            listed.map(|()| locked).map_err(|error| DirectoryError::Io { path: directory.clone(), error })
        });
        let _locked = match locked {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        let threads = self.threads.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get);
        let store = RunArguments::store_of(None, self.no_cache);
        let sweep = Cases {
            program,
            given,
            overrides,
            axes,
            directory: directory.clone(),
            engine: Engine::new(EngineConfig { threads, store, ..EngineConfig::default() }),
            workers: threads,
            cancel: interrupt::flag(),
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
            Ok(outcome) => self.report(&outcome, &directory),
            Err(error) => failed(format, &module, error),
        }
    }

    /// Writes the results and prints the table.
    fn report(&self, Outcome { table, count, earlier }: &Outcome, directory: &Path) -> ExitCode {
        let format = MessageFormat::Human;
        let [file, shown] = ["sweep.csv", "sweep.html"].map(|name| directory.join(name));
        if let Err(error) = table.write(&file).and_then(|()| page::write(&shown, table)) {
            return format.unwritable(directory, &error.to_string());
        }
        print!("{}", table.text());
        if !self.quiet {
            if *earlier > 0 {
                let cases = if *earlier == 1 { "case was" } else { "cases were" };
                format.note(&format!("{earlier} {cases} solved before\n"));
            }
            format.note(&format!("table and plots are in {}\n", directory.display()));
        }
        if table.warned() > 0 && !self.quiet {
            let cases = if table.warned() == 1 { "case has" } else { "cases have" };
            format.warning(&format!("{} {cases} warnings, see sweep.html", table.warned()));
        }
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
