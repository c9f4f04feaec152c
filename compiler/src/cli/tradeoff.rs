//! `calyx tradeoff`: measures error against computing time of a model at each fidelity level and
//! setting.

use crate::allow::AllowPath;
use crate::compile::compile;
use crate::messages::{MODEL_ERROR, MessageFormat, USAGE, beside};
use calyx::elaborate::Planned;
use calyx::rt::campaign::{Campaign, Outcome};
use calyx::rt::console::{print, println};
use calyx::rt::options::given_of;
use calyx::rt::progress::{CampaignProgress, ProgressFormat};
use calyx::rt::run_directory::{DirectoryError, Kind, RunDirectory};
use calyx::rt::tradeoff::text::{OmittedSetting, omitted, recommendations, seconds, table};
use calyx::rt::tradeoff::{
    Comparison, Measurement, Setting, current_setting_name, files, plot, references, settings,
};
use calyx::rt::{Error, Override, ParamAssignment, RunError, budget, interrupt};
use calyx::{Severity, check_run_within};
use calyx_runtime::cost::Rates;
use calyx_runtime::scene::Fidelity;
use calyx_runtime::settings_override::{FORMER_NAMES, Grid, current_name};
use clap::Args;
use clap::builder::{PossibleValue, PossibleValuesParser};
use std::io::{self, Write};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

pub const EXAMPLES: &str = "\
Every setting is a separate run below runs/ in the results directory, with the same params and
positions and without cached structures. The error of a setting is its largest deviation from the
reference at any position, divided by the largest magnitude of the output in the reference run; for
settings with fewer positions, the deviation of extremes and mean. The reference is the finest level
within --longest, with contact grids twice as fine and, if that is within --longest too, a finer
mesh than any other setting. Settings whose mesh is not coarser than that of the reference are
marked: their errors exclude the mesh error. No figure includes the error of the reference itself: a
model that agrees with it to 1 % has an error of up to 1 % plus that of the reference.

Examples:
  calyx tradeoff pair.cx                                results go to pair.cx.tradeoff
  calyx tradeoff pair.cx --set steps=8 --fidelities plane,medium
  calyx tradeoff pair.cx --longest 1h --reference finest
  calyx tradeoff pair.cx                                continues after an interruption

Then run with the recommended settings, e.g. calyx run pair.cx --fidelity plane --contact-cells 12.

Exit status: 0 if the comparison was written, 1 if the model or all levels failed, 2 for wrong usage
of the command.";

#[derive(Args)]
pub struct Tradeoff {
    /// The model (.cx file)
    file: PathBuf,
    /// Set a param of the model, see `calyx run`
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value)]
    set: Vec<ParamAssignment>,
    /// Read params from FILE.json or FILE.toml, see `calyx run`
    #[arg(long, value_name = "FILE")]
    params: Option<PathBuf>,
    #[command(flatten)]
    allow: AllowPath,
    /// Fidelity levels to measure, separated by commas [default: all that support the model]
    #[arg(long, alias = "levels", value_name = "LEVELS", value_delimiter = ',', value_parser = level)]
    fidelities: Vec<Fidelity>,
    /// Settings to vary within the levels, separated by commas: refinement (of the mesh),
    /// contact_cells, contact_slices, position_stride; "none" measures only the levels [default:
    /// all]
    #[arg(long, alias = "knobs", value_name = "SETTINGS", value_delimiter = ',', value_parser = setting_names())]
    settings: Vec<String>,
    /// Reference for errors: a level, or a setting as the table names it [default: the finest level
    /// within --longest, with contact grids twice as fine and a finer mesh]
    #[arg(long, value_name = "SETTING")]
    reference: Option<String>,
    /// Skip settings whose predicted time is longer than this, e.g. 30s or 2h
    #[arg(long, value_name = "TIME", value_parser = budget::time, default_value = "10min")]
    longest: Duration,
    /// Directory for the results [default: the model's file name with the suffix .tradeoff]
    ///
    /// Contains tradeoff.csv (one row per setting and output), tradeoff.json, tradeoff.svg and the
    /// run directories. Finished runs are reused while model and params are unchanged.
    #[arg(short, long, value_name = "DIR")]
    out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Files with the names of results, such as tradeoff.csv, are replaced; all others are kept.
    #[arg(long)]
    force: bool,
    /// Number of threads [default: number of cores]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Print the content of tradeoff.json instead of the table
    #[arg(long)]
    json: bool,
    /// Print only the table and errors
    #[arg(long)]
    quiet: bool,
    /// Format of progress on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    progress: ProgressFormat,
}

fn level(name: &str) -> Result<Fidelity, String> {
    let mut overrides = Override::default();
    overrides.set("fidelity", name).map_err(|error| error.help)?;
    overrides.fidelity.ok_or_else(|| name.to_owned())
}

/// Returns the settings that can be varied; former names are hidden.
fn setting_names() -> PossibleValuesParser {
    let name = |name: &'static str| {
        let former = FORMER_NAMES.iter().filter(|(current, _)| *current == name).map(|(_, former)| *former);
        PossibleValue::new(name).aliases(former)
    };
    PossibleValuesParser::new(
        ["refinement", "contact_cells", "contact_slices", "position_stride", "none"].map(name),
    )
}

/// Setting to run, and its predicted time, s.
type Expected = (Setting, Option<f64>);

impl Tradeoff {
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
        let check = || check_run_within(&self.file, &self.allow.paths(), &given, Override::default(), None);
        let (module, _) = match compile(&self.file, true, format, check) {
            Ok(compiled) => compiled,
            Err(status) => return status,
        };
        let mut left = Vec::new();
        let (expected, chosen) = match self.plan(&given, &mut left) {
            Ok(plan) => plan,
            Err(why) => {
                format.failure(&why, "`calyx check` says what is wrong with the model");
                return ExitCode::from(MODEL_ERROR);
            }
        };
        let directory = self.out.clone().unwrap_or_else(|| beside(&self.file, ".tradeoff"));
        let locked = RunDirectory::lock(&directory, Kind::Tradeoff, self.force);
        let locked = match locked.and_then(|locked| claimed(locked, &directory)) {
            Ok(locked) => locked,
            Err(error) => return format.directory(&error),
        };
        let campaign = Campaign {
            program: module.as_program(),
            given,
            directory: directory.clone(),
            threads: self.threads.map_or(0, NonZeroUsize::get),
            cancel: interrupt::flag(),
        };
        let measured = match self.measure(&campaign, &expected, &mut left) {
            Ok(Some(measured)) => measured,
            Ok(None) => {
                format.note("interrupted; run the same command again to continue\n");
                return ExitCode::from(MODEL_ERROR);
            }
            Err(RunError::Run(Error::Given(refused))) => {
                format.refused(&refused);
                return ExitCode::from(USAGE);
            }
            Err(RunError::Run(Error::Model(error))) => {
                format.diagnostics(&[module.error(&error)], module.files());
                return ExitCode::from(MODEL_ERROR);
            }
            Err(RunError::Ended { error, .. }) => {
                format.diagnostics(&[module.error(&error)], module.files());
                return ExitCode::from(MODEL_ERROR);
            }
            Err(RunError::Directory(error)) => return format.directory(&error),
            Err(RunError::Io { path, error }) => return format.unwritable(&path, &error.to_string()),
        };
        let known = |name: &str| measured.iter().any(|measured| measured.setting.name == name);
        // If the reference failed, use the finest successful setting.
        let finest = measured.iter().max_by_key(|measured| {
            let level = Fidelity::ALL.iter().position(|level| level.name() == measured.setting.level());
            (level, measured.setting.overridden().is_empty())
        });
        let reference = chosen.filter(|name| known(name)).or_else(|| Some(finest?.setting.name.clone()));
        let Some(comparison) = reference.and_then(|reference| Comparison::new(measured, &reference)) else {
            format.note(&omitted(&left));
            format.failure(
                "the model cannot be analysed at any of these levels",
                "remove the reason that is given for a level",
            );
            return ExitCode::from(MODEL_ERROR);
        };
        let status = self.report(&comparison, &left, &directory);
        drop(locked);
        status
    }

    /// Returns the plan of the model with overridden settings, or the reason why it has none.
    fn plan_with(&self, given: &[ParamAssignment], overrides: Override) -> Result<Planned, String> {
        let checked = check_run_within(&self.file, &self.allow.paths(), given, overrides, None);
        let checked = checked.map_err(|error| error.to_string())?;
        if let Some(refused) = checked.refused {
            return Err(refused.message);
        }
        let errors = checked.diagnostics.iter().find(|found| found.severity == Severity::Error);
        match (errors, checked.plan) {
            (Some(error), _) => Err(format!("{}: {}", error.code, error.message)),
            (None, None) => Err("the model analyses nothing".into()),
            (None, Some(plan)) => Ok(plan),
        }
    }

    /// Returns the settings to run, in order, and the name of the reference; records omitted
    /// settings.
    fn plan(
        &self,
        given: &[ParamAssignment],
        left: &mut Vec<OmittedSetting>,
    ) -> Result<(Vec<Expected>, Option<String>), String> {
        let wanted = |level: &Fidelity| self.fidelities.is_empty() || self.fidelities.contains(level);
        let levels = Fidelity::ALL.into_iter().filter(wanted);
        let rates = Rates::of_this_machine(calyx::rt::options::rates_file().as_deref(), false);
        let planned = |overrides: Override| self.plan_with(given, overrides);
        let mut expected: Vec<Expected> = Vec::new();
        let (mut best_of_levels, mut added) = (Vec::new(), Vec::new());
        for level in levels {
            let own = match planned(Override { fidelity: Some(level), ..Override::default() }) {
                Ok(own) => own,
                Err(reason) => {
                    left.push(OmittedSetting { name: level.name().into(), reason });
                    continue;
                }
            };
            let grid = own.grid().unwrap_or(Grid { half_cells: 0, half_slices: None });
            let finest = references(level, grid);
            let mut of_level = settings(level, grid, own.is_sampled());
            let varied = |name: &str| {
                self.settings.is_empty() || self.settings.iter().any(|known| current_name(known) == name)
            };
            of_level.retain(|setting| setting.overridden().iter().all(|(name, _)| varied(name)));
            for finest in &finest {
                if !of_level.contains(finest) {
                    // Settings of one mesh are adjacent; a separate mesh comes last.
                    let shares = |setting: &Setting| setting.mesh() == finest.mesh();
                    let at = of_level.iter().rposition(shares).map_or(of_level.len(), |at| at + 1);
                    added.push(finest.name.clone());
                    of_level.insert(at, finest.clone());
                }
            }
            let mut affordable = Vec::new();
            for setting in of_level {
                let cost = match planned(setting.overrides) {
                    Ok(plan) => plan.cost(&rates),
                    Err(reason) => {
                        left.push(OmittedSetting { name: setting.name, reason });
                        continue;
                    }
                };
                let time = cost.time_in_study();
                let longest = self.longest.as_secs_f64();
                let reason = match budget::available() {
                    _ if time > longest => {
                        format!("predicted to take {}, and --longest is {}", seconds(time), seconds(longest))
                    }
                    Some(room) if cost.memory() > room as f64 => format!(
                        "predicted to need {:.1} GB, and this machine has {:.1} GB",
                        1e-9 * cost.memory(),
                        1e-9 * room as f64
                    ),
                    _ => {
                        if finest.contains(&setting) {
                            affordable.push(setting.name.clone());
                        }
                        expected.push((setting, Some(time)));
                        continue;
                    }
                };
                left.push(OmittedSetting { name: setting.name, reason });
            }
            let best = finest.into_iter().map(|setting| setting.name).find(|name| affordable.contains(name));
            best_of_levels.extend(best);
        }
        if expected.is_empty() {
            let why: Vec<String> =
                left.iter().map(|left| format!("{}: {}", left.name, left.reason)).collect();
            return Err(format!("no setting can be run: {}", why.join("; ")));
        }
        let chosen = match self.reference.as_deref().map(current_setting_name) {
            Some(name) if !expected.iter().any(|(setting, _)| setting.name == name) => {
                let known: Vec<&str> = expected.iter().map(|(setting, _)| setting.name.as_str()).collect();
                return Err(format!(
                    "unknown setting `{name}`; the settings of this model are {}",
                    known.join(", ")
                ));
            }
            Some(name) => Some(name),
            None => best_of_levels.pop(),
        };
        // Keep only the selected one of the settings that were added as references of the levels.
        expected
            .retain(|(setting, _)| !added.contains(&setting.name) || chosen.as_ref() == Some(&setting.name));
        Ok((expected, chosen))
    }

    /// Runs the planned settings; `None` if the user cancels.
    fn measure(
        &self,
        campaign: &Campaign,
        expected: &[Expected],
        left: &mut Vec<OmittedSetting>,
    ) -> Result<Option<Vec<Measurement>>, RunError> {
        let mut measured: Vec<Measurement> = Vec::new();
        let tour = CampaignProgress::new(
            self.progress,
            self.quiet,
            expected.iter().map(|(_, time)| time.unwrap_or(0.0)).collect(),
        );
        for (index, (setting, predicted)) in expected.iter().enumerate() {
            // If the model does not support a level, skip the settings of that level.
            if left.iter().any(|left| left.name == setting.level()) {
                continue;
            }
            tour.begin(index, &setting.name);
            match campaign.run(setting, *predicted, &measured)? {
                Outcome::Measured(run) => measured.push(*run),
                Outcome::Refused(reason) => left.push(OmittedSetting { name: setting.name.clone(), reason }),
                Outcome::Ended => {
                    tour.finish();
                    return Ok(None);
                }
            }
        }
        tour.finish();
        let tidied = campaign.tidy();
        tidied.map_err(|error| RunError::Io { path: campaign.directory.clone(), error })?;
        Ok(Some(measured))
    }

    /// Writes the comparison and prints it.
    fn report(&self, comparison: &Comparison, left: &[OmittedSetting], directory: &Path) -> ExitCode {
        let format = MessageFormat::Human;
        let name = self.file.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
        let reference = &comparison.settings[comparison.reference].setting;
        let run = calyx::rt::directory::read_run(&directory.join("runs").join(reference.folder()));
        let params = run.ok().flatten().map_or_else(Default::default, |run| run["params"].clone());
        let document = files::document(&name, &params, comparison, left);
        let path = |name: &str| directory.join(name);
        let written = files::write_table(&path("tradeoff.csv"), comparison)
            .and_then(|()| files::write_document(&path("tradeoff.json"), &document));
        if let Err(error) = written {
            return format.unwritable(directory, &error.to_string());
        }
        if let Err(error) = plot::draw(&path("tradeoff.svg"), &name, comparison) {
            return format.unwritable(&path("tradeoff.svg"), &error.to_string());
        }
        if self.json {
            // The reader may close the pipe early.
            let _ = writeln!(io::stdout().lock(), "{document:#}");
            return ExitCode::SUCCESS;
        }
        print!("{}", table(comparison));
        println!("");
        print!("{}", recommendations(comparison));
        print!("{}", omitted(left));
        if !self.quiet {
            format.note(&format!("table, plot and runs are in {}\n", directory.display()));
        }
        ExitCode::SUCCESS
    }
}

/// Registers all files that a comparison writes at the top of its directory.
fn claimed(locked: RunDirectory, path: &Path) -> Result<RunDirectory, DirectoryError> {
    let names = ["tradeoff.csv", "tradeoff.json", "tradeoff.svg", "runs", "structures"];
    let listed = locked.claim_all(names);
    listed.map(|()| locked).map_err(|error| DirectoryError::Io { path: path.to_owned(), error })
}
