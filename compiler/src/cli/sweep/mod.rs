//! `calyx sweep`: solves a model at many values of its params.

mod plan;
mod report;
mod slurm;

use crate::allow::AllowPath;
use crate::compile::compile;
use crate::dry_run;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use crate::solving::Solving;
use calyx::check_run_within;
use calyx::rt::options::given_of;
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::settings_override::OverrideArguments;
use calyx::rt::study::{Method, Objective, Sample};
use calyx::rt::sweep::{
    Axis, CaseFile, Durations, JOURNAL, Sampling, StudyFile, Sweep as Cases, Tolerance, objective,
};
use calyx::rt::{Error, InvalidParam, ModelDescription, ParamAssignment, RunError, interrupt};
use clap::{Args, ValueEnum};
use report::Report;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "\
The values of an axis:
  --over torque=50..500:10            10 equally spaced numbers with both ends, in the unit of the param's default
  --over \"offset=-20 um..20 um:9\"     ends with a unit
  --over speed=100..10000:9log        equally spaced on a logarithmic scale
  --over torque=50,200,800            a list
  --over fidelity=analytic,medium     a list of choices
  --over \"coast=*\"                    all choices of a text or Boolean param
`fidelity` is the fidelity level of the analysis, unless the model has a param of this name.

Toleranced params have a distribution, of which --samples values are taken:
  --sample \"slope = normal(0 um, 5 um)\"              mean and standard deviation
  --sample \"slope = normal(-15 um..15 um)\"           bounds at three standard deviations
  --sample \"slope = truncated_normal(0 um, 5 um, -10 um..10 um)\"
  --sample \"crown = uniform(3 um..9 um)\"
  --sample \"crown = triangular(3 um..9 um, 5 um)\"    bounds and mode
A sample has statistics with confidence intervals, sample_statistics.csv, and the params that explain the variation,
explained_variation.csv. A study file in TOML, --study, has axes, distributions and objectives in one place.

Load cases in a file, with param names in the first line and optional columns `name` and `duration`:
  name,torque,speed,duration
  drive,120 N*m,3000 rpm,400 hour
  coast,-40 N*m,3000 rpm,100 hour

With load cases, sweep.html and component_loads.csv have the loads of all meshes and bearings by
case. A column `duration` makes the cases a duty cycle with equivalent values in sweep.html and
duty_cycle.csv. Its entries are times with a unit, percentages that add up to 100 %, or plain
numbers, of which only the proportions count. If the model has a param `duration`, the column is the
param instead.

Examples:
  calyx sweep pair.cx --over torque=50..500:10          results go to pair.cx.sweep
  calyx sweep pair.cx --over torque=50..500:10 --over \"slope=-20 um..20 um:9\"
  calyx sweep pair.cx --cases load_cases.csv --set fidelity=medium
  calyx sweep pair.cx --over torque=50..500:10          continues after an interruption
  calyx sweep pair.cx --cases load_cases.csv --dry-run  lists the cases without solving them
  calyx sweep pair.cx --sample \"slope = normal(0 um, 5 um)\" --samples 200 --seed 1
  calyx sweep pair.cx --study study.toml

On a cluster, or for any queue: a plan, a process per index on any machine, and the results:
  calyx sweep pair.cx --over torque=50..500:1000 --plan cases/ --cases-per-index 50
  calyx sweep --work cases/ --index 1                   and so on to index 20
  calyx sweep --collect cases/
  calyx sweep pair.cx --over torque=50..500:1000 --on slurm --slurm-options \"--time=1:00:00 --cpus-per-task=4\"
Indices may run at the same time and be killed; each solves its cases that are left. The results are
those of a sweep on one machine.

Several axes give all their combinations. A case has the same numbers as `calyx run` with these
params, to the last bit. A case that fails is a row with its reason.

Exit status: 0 if all cases were solved, 1 if the model or some cases failed, 2 for wrong usage of
the command.";

/// Queue of a cluster.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Queue {
    /// Slurm, by its commands sbatch, squeue and sacct
    Slurm,
}

const ELSEWHERE: &str = "Clusters and queues";
/// Options that a plan has recorded.
const NOT_OF_A_PLAN: [&str; 26] = [
    "file",
    "over",
    "cases",
    "study",
    "sample",
    "samples",
    "seed",
    "method",
    "objective",
    "damage_slope",
    "dry_run",
    "plan",
    "on",
    "cases_per_index",
    "set",
    "params",
    "paths",
    "fidelity",
    "refinement",
    "element_order",
    "face_elements",
    "displacement_order",
    "contact_cells",
    "contact_slices",
    "position_stride",
    "error_estimates",
];

#[derive(Args)]
pub struct Sweep {
    /// The model (.cx file)
    #[arg(required_unless_present_any = ["work", "collect"])]
    file: Option<PathBuf>,
    /// Vary a param: NAME=FROM..TO:COUNT, NAME=A,B,C or NAME=*; repeatable
    #[arg(long, value_name = "NAME=VALUES")]
    over: Vec<String>,
    /// Read cases from a CSV file with a column per param, and optional columns `name` and
    /// `duration`
    #[arg(long, value_name = "FILE")]
    cases: Option<PathBuf>,
    /// Read axes, tolerances and objectives from a study file in TOML
    #[arg(long, value_name = "FILE")]
    study: Option<PathBuf>,
    /// Sample a toleranced param: NAME = normal(MEAN, STANDARD_DEVIATION), and others; repeatable
    #[arg(long, value_name = "NAME=DISTRIBUTION")]
    sample: Vec<String>,
    /// Number of samples of toleranced params
    #[arg(long, value_name = "N")]
    samples: Option<usize>,
    /// Seed of the samples: the same seed gives the same samples [default: 0]
    #[arg(long, value_name = "SEED")]
    seed: Option<u64>,
    /// Method of sampling: latin_hypercube, sobol or random [default: latin_hypercube]
    ///
    /// With sobol and random, more samples of the same seed contain the fewer ones.
    #[arg(long, value_name = "METHOD", value_parser = method)]
    method: Option<Method>,
    /// Objective whose trade-off with a second one is shown: "min OUTPUT.STATISTIC" or "max ...";
    /// give two
    #[arg(long, value_name = "OBJECTIVE")]
    objective: Vec<String>,
    /// Slope p of the Woehler damage line for equivalent torques of meshes (ISO 6336-6); repeatable
    /// [default: 6.61, for pitting of hardened steels]
    #[arg(long, value_name = "P", value_parser = slope)]
    damage_slope: Vec<f64>,
    /// List the cases with a predicted time, without solving them or writing files
    #[arg(long)]
    dry_run: bool,
    /// Write a plan of the sweep to this directory, for `--work` on any machines
    ///
    /// The directory contains the model, the files that it reads, and the cases, divided into
    /// indices of some cases each. Nothing is solved.
    #[arg(long, value_name = "DIR", help_heading = ELSEWHERE, group = "planned", conflicts_with_all = ["out", "dry_run"])]
    plan: Option<PathBuf>,
    /// Number of cases per index of a plan [default: of about a minute, for at most 1000 indices]
    #[arg(long, value_name = "N", help_heading = ELSEWHERE, requires = "planned")]
    cases_per_index: Option<NonZeroUsize>,
    /// Solve the cases of an index of the plan in this directory that are not solved yet
    #[arg(long, value_name = "DIR", help_heading = ELSEWHERE, requires = "index", conflicts_with = "collect", conflicts_with_all = NOT_OF_A_PLAN)]
    work: Option<PathBuf>,
    /// Index that `--work` solves, from 1
    #[arg(long, value_name = "N", help_heading = ELSEWHERE, requires = "work")]
    index: Option<usize>,
    /// Write the results of all workers of the plan in this directory, there or to `--out`
    #[arg(long, value_name = "DIR", help_heading = ELSEWHERE, conflicts_with_all = NOT_OF_A_PLAN)]
    collect: Option<PathBuf>,
    /// Submit the sweep to a queue as an array job, follow it and collect the results
    ///
    /// The directory for the results contains the plan and the logs of the job. Ctrl-C leaves the
    /// job running; the same command follows it again.
    #[arg(long, value_enum, value_name = "QUEUE", help_heading = ELSEWHERE, group = "planned", conflicts_with = "dry_run")]
    on: Option<Queue>,
    /// Options of sbatch, like "--partition=short --time=1:00:00 --cpus-per-task=4"; repeatable
    #[arg(long, value_name = "OPTIONS", help_heading = ELSEWHERE, requires = "on", allow_hyphen_values = true)]
    slurm_options: Vec<String>,
    /// Submit the indices again that the last job did not finish
    #[arg(long, help_heading = ELSEWHERE, requires = "on")]
    resubmit: bool,
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
    /// Contains sweep.csv and sweep.parquet (one row per case), sweep.html, cases.jsonl (finished
    /// cases, from which an interrupted sweep continues), with --cases component_loads.csv and
    /// duty_cycle.csv, and with samples sample_statistics.csv and explained_variation.csv.
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Files with the names of results, such as sweep.csv, are replaced; all others are kept.
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    solving: Solving,
}

impl Sweep {
    /// Returns the format of warnings; `None` if only errors are printed.
    pub fn warnings(&self) -> Option<MessageFormat> {
        (!self.solving.quiet).then_some(MessageFormat::Human)
    }

    pub fn run(self) -> ExitCode {
        match (&self.work, &self.collect) {
            (Some(directory), _) => plan::work(&self, directory),
            (None, Some(directory)) => plan::collect(&self, directory),
            (None, None) => self.run_model(),
        }
    }

    /// Returns the model; empty with `--work` and `--collect`.
    fn file(&self) -> &Path {
        self.file.as_deref().unwrap_or(Path::new(""))
    }

    /// Checks and compiles the model, and returns it with the cases.
    fn prepared(&self) -> Result<(calyx::Module, Cases), ExitCode> {
        let format = MessageFormat::Human;
        let usage = |refused: InvalidParam| {
            format.refused(&refused);
            ExitCode::from(USAGE)
        };
        let file = self.study.as_deref().map(StudyFile::read).transpose().map_err(usage)?;
        // Values of the command line follow those of the study file, because the last one counts.
        let mut given = file.as_ref().map(|file| file.params.clone()).unwrap_or_default();
        given.extend(given_of(self.params.as_deref(), &self.set).map_err(usage)?);
        if self.over.is_empty() && self.cases.is_none() && self.study.is_none() && self.sample.is_empty() {
            let help = "name a param, like `--over torque=50..500:10`";
            return Err(usage(InvalidParam::new("the sweep varies nothing", help)));
        }
        let overrides = self.overrides.to_override();
        let check = || check_run_within(self.file(), &self.allow.paths(), &given, overrides, None);
        let (module, _) = compile(self.file(), self.solving.quiet, format, check)?;
        let program = module.as_program();
        let content = self.content(file.as_ref(), program.description()).map_err(|mistakes| {
            mistakes.iter().for_each(|mistake| format.refused(mistake));
            ExitCode::from(USAGE)
        })?;
        let directory = self.plan.clone().or_else(|| self.out.clone());
        let directory = directory.unwrap_or_else(|| beside(self.file(), ".sweep"));
        let sweep = Cases {
            given,
            overrides,
            axes: content.axes,
            load_cases: content.load_cases,
            durations: content.durations,
            sample: content.sample,
            objectives: content.objectives,
            ..Cases::new(program, directory)
        };
        Ok((module, self.on_engine(sweep)))
    }

    /// Returns the sweep on an engine with the options of this command.
    fn on_engine(&self, sweep: Cases) -> Cases {
        let (engine, workers) = (self.solving.engine(), self.solving.workers());
        Cases { engine, workers, cancel: interrupt::flag(), ..sweep }
    }

    fn run_model(&self) -> ExitCode {
        let format = MessageFormat::Human;
        let (module, sweep) = match self.prepared() {
            Ok(prepared) => prepared,
            Err(status) => return status,
        };
        if self.dry_run {
            return match sweep.planned() {
                Ok(table) => dry_run::list(self.file(), &sweep, &table, &self.allow.paths()),
                Err(error) => failed(format, &module, RunError::Run(error)),
            };
        }
        if self.plan.is_some() {
            return plan::write(self, &sweep);
        }
        if let Some(Queue::Slurm) = self.on {
            return slurm::run(self, &module, &sweep);
        }
        let directory = sweep.directory.clone();
        let locked = RunDirectory::lock(&directory, Kind::Sweep, self.force).and_then(|locked| {
            let listed = locked.claim_all(["sweep.csv", "sweep.html", JOURNAL]);
            listed.map(|()| locked).map_err(|error| DirectoryError::Io { path: directory.clone(), error })
        });
        let locked = match locked {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        let progress = self.solving.progress();
        progress.stage("cases");
        let outcome = sweep.run(|done, count| {
            if done > 0 {
                progress.step(done - 1, count)
            }
        });
        progress.finish();
        let report = Report {
            quiet: self.solving.quiet,
            damage_slopes: &self.damage_slope,
            to_continue: Some("run the same command again to continue"),
        };
        match outcome {
            Ok(outcome) => report.write(&outcome, &locked),
            Err(error) => failed(format, &module, error),
        }
    }

    /// Combines the study file with the options.
    fn content(
        &self,
        file: Option<&StudyFile>,
        description: &ModelDescription,
    ) -> Result<Content, Vec<InvalidParam>> {
        let mut study = file.map(|file| file.study(description)).transpose()?.unwrap_or_default();
        let given = |error: Error| match error {
            Error::Given(refused) => vec![refused],
            Error::Model(error) => vec![InvalidParam::new(error.message, error.help)],
        };
        if let Some(path) = &self.cases {
            if study.cases.is_some() {
                let message = "`--cases` and the study file name files of load cases";
                return Err(vec![InvalidParam::new(message, "give one of them")]);
            }
            study.cases = Some(CaseFile::read(path, description).map_err(given)?);
        }
        let mut content = Content { load_cases: study.cases.is_some(), ..Content::default() };
        if let Some(cases) = study.cases {
            if cases.duration_is_param && !self.solving.quiet {
                MessageFormat::Human.note(
                    "`duration` is a param of the model, so that the column is its value, and the cases are no duty cycle\n",
                );
            }
            content.axes.push(cases.axis);
            content.durations = cases.durations;
        }
        content.axes.append(&mut study.axes);
        for text in &self.over {
            content.axes.push(Axis::parse(text, description).map_err(given)?);
        }
        for text in &self.sample {
            study.tolerances.push(Tolerance::parse(text, description).map_err(given)?);
        }
        let own = Sampling { method: self.method, samples: self.samples, seed: self.seed };
        let sample = own.or(study.sampling).axis(study.tolerances, description).map_err(given)?;
        if let Some((axis, sample)) = sample {
            content.axes.push(axis);
            content.sample = Some(sample);
        }
        content.objectives = study.objectives;
        for text in &self.objective {
            content.objectives.push(objective::parse(text, description).map_err(given)?);
        }
        match (content.axes.len(), content.objectives.len()) {
            (0, _) => {
                let help = "add `[axes]` or `[tolerances]` to the study file, or `--over torque=50..500:10`";
                Err(vec![InvalidParam::new("the sweep varies nothing", help)])
            }
            (_, 0 | 2) => Ok(content),
            (_, count) => {
                let help = "give two objectives, like `--objective \"min stress\" --objective \"min mass\"`";
                let message = format!("the trade-off has {count} objectives instead of two");
                Err(vec![InvalidParam::new(message, help)])
            }
        }
    }
}

/// Content of the command line and the study file.
#[derive(Default)]
struct Content {
    axes: Vec<Axis>,
    load_cases: bool,
    durations: Option<Durations>,
    sample: Option<Sample>,
    objectives: Vec<Objective>,
}

/// Parses a method of sampling.
fn method(text: &str) -> Result<Method, String> {
    let known = Method::ALL.map(Method::name).join(", ");
    Method::named(text).ok_or_else(|| format!("choose from {known}"))
}

/// Parses a slope of a damage line.
fn slope(text: &str) -> Result<f64, String> {
    let slope = text.parse().ok().filter(|slope: &f64| slope.is_finite() && *slope >= 1.0);
    slope.ok_or_else(|| "give a number of at least 1, like `--damage-slope 8.738`".to_owned())
}

/// Prints the error of a sweep or an optimization.
pub fn failed(format: MessageFormat, module: &calyx::Module, error: RunError) -> ExitCode {
    match error {
        RunError::Run(Error::Model(error)) => {
            format.diagnostics(&[module.error(&error)], module.files());
            ExitCode::from(MODEL_ERROR)
        }
        RunError::Ended { error, .. } => {
            format.diagnostics(&[module.error(&error)], module.files());
            ExitCode::from(MODEL_ERROR)
        }
        error => failed_without_module(format, error),
    }
}

/// Prints the error of a sweep that concerns no location of the model.
fn failed_without_module(format: MessageFormat, error: RunError) -> ExitCode {
    match error {
        RunError::Run(Error::Given(why)) => {
            format.refused(&why);
            ExitCode::from(USAGE)
        }
        RunError::Run(Error::Model(error)) => {
            format.failure(&format!("{}: {}", error.code, error.message), &error.help);
            ExitCode::from(MODEL_ERROR)
        }
        RunError::Ended { error, .. } => {
            format.failure(&format!("{}: {}", error.code, error.message), &error.help);
            ExitCode::from(MODEL_ERROR)
        }
        RunError::Directory(error) => format.directory(&error),
        RunError::Io { path, error } => format.unwritable(&path, &error.to_string()),
    }
}
