//! `calyx optimize`: finds the values of params at which an output is best.

use crate::allow::AllowPath;
use crate::compile::compile;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use crate::solving::Solving;
use crate::sweep::failed;
use calyx::check_run_within;
use calyx::rt::console::print;
use calyx::rt::interrupt;
use calyx::rt::optimization::{
    self, DESIGNS, EVALUATIONS, OPTIMUM, OPTIMUM_HEADER, Optimization, Optimizer, State, write_designs,
    write_optimum,
};
use calyx::rt::options::given_of;
use calyx::rt::page::optimization as page;
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::settings_override::OverrideArguments;
use calyx::rt::sweep::StudyFile;
use calyx::rt::{InvalidParam, ParamAssignment};
use calyx_abi::units::from_si;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub const EXAMPLES: &str = "\
The study file has variables with their ranges, an objective, and usually constraints and load
cases:

  objective = \"min transmission_error.peak_to_peak\"
  constraints = [\"max_contact_pressure <= 200 ksi\"]

  [variables]
  tip_relief = \"0 inch..0.002 inch\"
  lead_crown = { from = \"0 inch\", to = \"0.001 inch\", initial = \"0.0005 inch\" }

  [axes]                        # load cases; a CSV file of them: cases = \"load_cases.csv\"
  torque = [500, 1000, 1500]

  [optimization]                # all of these are optional
  starts = 5                    # local searches of a round, from different designs
  rounds = 5                    # at most; later ones start near the best optimum
  over_cases = \"worst\"          # or \"mean\", \"percentile 90\"

Tolerances make the optimum robust: each design is evaluated with all samples.

  [tolerances]
  center_distance = \"normal(2.999 inch..3.001 inch)\"
  [deviations]                  # of variables
  tip_relief = \"normal(0 inch, 0.0001 inch)\"
  [sampling]
  samples = 16

Examples:
  calyx optimize pair.cx study.toml                    results go to pair.cx.optimum
  calyx optimize pair.cx study.toml --fidelity plane   at another fidelity level
  calyx optimize pair.cx study.toml                    continues after an interruption
  calyx run pair.cx --params pair.cx.optimum/optimum.toml

Constraints hold in every load case. Estimates of errors are not computed, unless --error-estimates
asks for them: run the optimum with them afterwards.

Exit status: 0 if an optimum was found that meets all constraints, 1 if not or after an
interruption, 2 for wrong usage of the command.";

#[derive(Args)]
pub struct Optimize {
    /// The model (.cx file)
    file: PathBuf,
    /// The study file (TOML)
    study: PathBuf,
    /// Read load cases from a CSV file with a column per param, see `calyx sweep`
    #[arg(long, value_name = "FILE")]
    cases: Option<PathBuf>,
    /// Set a param in all designs, see `calyx run`
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value)]
    set: Vec<ParamAssignment>,
    /// Read params of all designs from FILE.json or FILE.toml, see `calyx run`
    #[arg(long, value_name = "FILE")]
    params: Option<PathBuf>,
    #[command(flatten)]
    overrides: OverrideArguments,
    #[command(flatten)]
    allow: AllowPath,
    /// Directory for the results [default: the model's file name with the suffix .optimum]
    ///
    /// Contains optimum.toml (the params of the best design), optimization.html, designs.csv (one
    /// row per design) and evaluations.jsonl (solved load cases, from which an interrupted
    /// optimization continues).
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Files with the names of results are replaced; all others are kept.
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    solving: Solving,
}

impl Optimize {
    /// Returns the format of warnings; `None` if only errors are printed.
    pub fn warnings(&self) -> Option<MessageFormat> {
        (!self.solving.quiet).then_some(MessageFormat::Human)
    }

    pub fn run(self) -> ExitCode {
        let format = MessageFormat::Human;
        let refused = |all: &[InvalidParam]| {
            all.iter().for_each(|refused| format.refused(refused));
            ExitCode::from(USAGE)
        };
        let study = match StudyFile::read(&self.study) {
            Ok(study) => study,
            Err(why) => return refused(&[why]),
        };
        // Values of the command line follow those of the study file, because the last one counts.
        let mut given = study.params.clone();
        match given_of(self.params.as_deref(), &self.set) {
            Ok(own) => given.extend(own),
            Err(why) => return refused(&[why]),
        }
        let overrides = self.overrides.to_override();
        let check = || check_run_within(&self.file, &self.allow.paths(), &given, overrides, None);
        let (module, _) = match compile(&self.file, self.solving.quiet, format, check) {
            Ok(compiled) => compiled,
            Err(status) => return status,
        };
        let program = module.as_program();
        let problem = match optimization::read(&study, self.cases.as_deref(), &given, program.description()) {
            Ok(problem) => problem,
            Err(mistakes) => return refused(&mistakes),
        };
        let directory = self.out.clone().unwrap_or_else(|| beside(&self.file, ".optimum"));
        let optimizer = Optimizer {
            program,
            given,
            overrides,
            problem,
            directory: directory.clone(),
            engine: self.solving.engine(),
            workers: self.solving.workers(),
            cancel: interrupt::flag(),
        };
        let locked = RunDirectory::lock(&directory, Kind::Optimization, self.force).and_then(|locked| {
            let listed = locked.claim_all([EVALUATIONS, DESIGNS, OPTIMUM, page::NAME]);
            listed.map(|()| locked).map_err(|error| DirectoryError::Io { path: directory.clone(), error })
        });
        let locked = match locked {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        let progress = self.solving.progress();
        progress.stage("designs");
        let name = &optimizer.problem.objective.output;
        let output = optimizer.program.description().outputs.iter().find(|output| output.name == *name);
        let unit = output.map(|output| (output.unit.factor, output.unit.name.clone()));
        let shown = |si: f64| match &unit {
            Some((factor, unit)) if unit != "1" => format!("{:.4} {unit}", from_si(si, *factor)),
            Some((factor, _)) => format!("{:.4}", from_si(si, *factor)),
            None => format!("{si:.4}"),
        };
        let outcome = optimizer.run(|state| progress.searching(&described(state, shown), state.designs));
        progress.finish();
        match outcome {
            Ok(outcome) => self.report(&outcome, &locked),
            Err(error) => failed(format, &module, error),
        }
    }

    /// Writes the results and prints the table.
    fn report(&self, outcome: &Optimization, directory: &RunDirectory) -> ExitCode {
        let format = MessageFormat::Human;
        let path = directory.path();
        if outcome.interrupted && (outcome.best().is_none() || is_complete(&path.join(OPTIMUM))) {
            let message = format!("interrupted after {} designs", outcome.designs.len());
            let files = if outcome.best().is_none() {
                ""
            } else {
                "; the files of the earlier optimization are kept"
            };
            format.failure(&(message + files), "run the same command again to continue");
            return ExitCode::from(MODEL_ERROR);
        }
        let written = write_designs(&path.join(DESIGNS), outcome)
            .and_then(|()| write_optimum(&path.join(OPTIMUM), outcome))
            .and_then(|()| page::write(&path.join(page::NAME), outcome));
        if let Err(error) = written {
            return format.unwritable(path, &error.to_string());
        }
        print!("{}", optimization::text(outcome));
        if !self.solving.quiet && outcome.best().is_some() {
            self.explain(path);
        }
        if outcome.interrupted {
            let message = format!("interrupted after {} designs", outcome.designs.len());
            format.failure(&message, "run the same command again to continue");
            return ExitCode::from(MODEL_ERROR);
        }
        match outcome.best() {
            Some((_, values)) if values.violation <= optimization::FEASIBLE => ExitCode::SUCCESS,
            Some(_) => {
                let help = "widen the ranges of the variables, or relax the bounds; optimization.html shows which ones conflict";
                format.failure("no design meets all constraints", help);
                ExitCode::from(MODEL_ERROR)
            }
            None => {
                let reason = outcome.designs.iter().find_map(|design| design.values.as_ref().err());
                let first = reason.map(|reason| format!(", the first one because: {reason}"));
                let message = format!("all designs failed{}", first.unwrap_or_default());
                format.failure(&message, "designs.csv has the reason of each");
                ExitCode::from(MODEL_ERROR)
            }
        }
    }

    fn explain(&self, directory: &Path) {
        let optimum = directory.join(OPTIMUM);
        MessageFormat::Human.note(&format!(
            "run the optimum with `calyx run {} --params {}`; designs and plots are in {}\n",
            self.file.display(),
            optimum.display(),
            directory.display()
        ));
    }
}

/// Returns whether a params file is the optimum of an optimization that was not interrupted.
fn is_complete(optimum: &Path) -> bool {
    fs::read_to_string(optimum).is_ok_and(|text| text.starts_with(OPTIMUM_HEADER))
}

/// Describes the state of an optimization in a line.
fn described(state: &State, shown: impl Fn(f64) -> String) -> String {
    let [ended, all] = state.searches;
    let best = state
        .best
        .map_or("no design meets the constraints yet".to_owned(), |best| format!("best {}", shown(best)));
    format!("{} designs, {best}, {ended} of {all} searches ended", state.designs)
}
