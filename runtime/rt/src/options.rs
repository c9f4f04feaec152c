//! Command-line options of a run, shared by `calyx run` and executables.

use crate::budget;
use crate::param_assignment::ParamAssignment;
use crate::params::InvalidParam;
use crate::params_file;
use crate::progress::ProgressFormat;
use crate::settings_override::OverrideArguments;
use calyx_runtime::cache::Store;
use clap::Args;
use etcetera::BaseStrategy;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The options of a run.
#[derive(Args, Clone, Debug, Default)]
pub struct RunArguments {
    /// Set a param, e.g. torque=500 or "torque=60 N*m"
    ///
    /// A VALUE without a unit is in the unit of the param's default. Can be repeated; the last
    /// value of a param applies. Overrides values in a --params file.
    #[arg(long, value_name = "NAME=VALUE", value_parser = ParamAssignment::name_and_value, help_heading = PARAMS)]
    pub set: Vec<ParamAssignment>,
    /// Read params from FILE.json or FILE.toml
    ///
    /// The file contains an object or table of names and values. Numbers are in the unit of the
    /// param's default; strings like "0.5 mm" include their unit. --print-params prints the schema
    /// of such a file.
    #[arg(long, value_name = "FILE", help_heading = PARAMS)]
    pub params: Option<PathBuf>,
    /// Print a JSON Schema of the params and exit
    #[arg(long, help_heading = PARAMS)]
    pub print_params: bool,
    #[command(flatten)]
    pub overrides: OverrideArguments,
    /// Directory for the results [default: the model's name with the suffix .run]
    ///
    /// Contains report.html (an illustrated report), run.json (inputs, outputs, solver residuals),
    /// steps.csv (one row per position) and timing.json. A run replaces only files of an earlier
    /// run, which are listed in .calyx-run, and keeps them until the first position is solved. Only
    /// one run at a time can write to a directory.
    #[arg(long, value_name = "DIR", help_heading = RESULTS)]
    pub out: Option<PathBuf>,
    /// Write to a directory that contains other files
    ///
    /// Without this option, a run refuses a directory with files that are not from an earlier run.
    /// With it, files with the names of results, such as run.json and steps.csv, are replaced; all
    /// others are kept.
    #[arg(long, help_heading = RESULTS)]
    pub force: bool,
    /// Resume an interrupted run
    ///
    /// Continues after the last completed position of the run in the results directory. Model and
    /// params must be unchanged. The results are identical to those of an uninterrupted run.
    #[arg(long, help_heading = RESULTS)]
    pub resume: bool,
    /// Write field results for every position
    ///
    /// Writes pressure.csv (contact pressure per cell), root_stress.csv (stress along the fillets,
    /// if an output requires it) and max_locations.csv (location of each maximum). line_load.csv
    /// (load along the contact lines) is always written, by default for at most 256 positions; with
    /// this option for all.
    #[arg(long, help_heading = RESULTS)]
    pub fields: bool,
    /// Write VTU files for ParaView for every position
    ///
    /// Contain the contact pressure, the stress in the fillets (if an output requires it), and the
    /// meshes of elastic bodies with displacements and stresses. Written to the directory vtu of
    /// the results.
    #[arg(long, help_heading = RESULTS)]
    pub vtu: bool,
    /// Write universal files of radiating surfaces for other acoustic programs
    ///
    /// For each radiated sound of the model: the closed surface before it is coarsened, and the
    /// complex velocities of its nodes at each spectral line of the speed of the model, as datasets
    /// 2411, 2412 and 55 in SI. Written to the directory unv of the results. `calyx sound` reads
    /// such files.
    #[arg(long, help_heading = RESULTS)]
    pub unv: bool,
    /// Print the results to standard output as one JSON document
    ///
    /// Contains the content of run.json and the rows of steps.csv. Output of the model's `print`
    /// statements goes to standard error.
    #[arg(long, help_heading = RESULTS)]
    pub json: bool,
    /// Print only errors and the output of the model's `print` statements
    #[arg(long)]
    pub quiet: bool,
    /// Format of progress on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    pub progress: ProgressFormat,
    /// Directory of the structure cache [default: calyx/structures in the user's cache directory]
    ///
    /// Static condensation of the gear bodies is most of the work of a run, and is reused while
    /// geometry and material do not change. The environment variable CALYX_CACHE also names a
    /// directory; "off" in place of a directory has the effect of --no-cache. Cached files are
    /// trusted: anyone who can write to the directory can change the results of later runs.
    #[arg(long, value_name = "DIR", help_heading = KEPT)]
    pub cache: Option<PathBuf>,
    /// Do not use the structure cache on disk
    #[arg(long, conflicts_with = "cache", help_heading = KEPT)]
    pub no_cache: bool,
    /// Number of threads [default: number of cores]
    ///
    /// The results do not depend on it, to the last bit.
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub threads: Option<NonZeroUsize>,
    /// Stop the run with an error after this time, e.g. 10s or 5min
    #[arg(long, value_name = "TIME", value_parser = budget::time, help_heading = LIMITS)]
    pub time_limit: Option<Duration>,
    /// Stop the run with an error if it requires more memory, e.g. 2GB
    #[arg(long, value_name = "SIZE", value_parser = budget::memory, help_heading = LIMITS)]
    pub memory_limit: Option<u64>,
}

const PARAMS: &str = "Params";
const RESULTS: &str = "Results";
const LIMITS: &str = "Limits";
const KEPT: &str = "Structure cache";
/// Environment variable with the directory of the structure cache, or "off".
const CACHE_VARIABLE: &str = "CALYX_CACHE";
/// The word that disables the structure cache in place of its directory.
const OFF: &str = "off";
/// Words that are probably meant as [`OFF`].
const NEAR_OFF: [&str; 9] = ["off", "of", "offf", "0", "no", "none", "false", "null", "disabled"];
/// Limit of the structure cache on disk in bytes: some dozens of 3-D gear pairs.
const CACHE_LIMIT: u64 = 4 << 30;

impl RunArguments {
    /// Returns the structure cache on disk; `None` if it is disabled or the user has no cache
    /// directory.
    pub fn store(&self) -> Option<Store> {
        RunArguments::store_of(self.cache.as_deref(), self.no_cache)
    }

    /// Returns the structure cache in a directory, or in that of the user; `None` if it is disabled
    /// or the user has no cache directory.
    pub fn store_of(directory: Option<&Path>, disabled: bool) -> Option<Store> {
        let directory = match directory {
            _ if disabled => return None,
            Some(directory) if directory == Path::new(OFF) => return None,
            Some(directory) => directory.to_owned(),
            None => cache_directory()?,
        };
        Some(Store::new(directory, CACHE_LIMIT))
    }

    /// Checks the directory of the structure cache.
    ///
    /// # Errors
    /// It is a file, or does not exist and is probably the word "off", misspelt.
    pub fn check_cache(&self) -> Result<(), InvalidParam> {
        let named = std::env::var_os(CACHE_VARIABLE).filter(|name| !name.is_empty());
        let (origin, directory) = match (&self.cache, named) {
            _ if self.no_cache => return Ok(()),
            (Some(directory), _) => (format!("--cache {}", directory.display()), directory.clone()),
            (None, Some(name)) => (format!("{CACHE_VARIABLE}={}", name.display()), PathBuf::from(name)),
            (None, None) => return Ok(()),
        };
        if directory.is_file() {
            return Err(InvalidParam::new(
                format!("`{origin}`: this is a file, and the structure cache needs a directory"),
                "name a directory, which may not exist yet, or use --no-cache",
            ));
        }
        let word = directory.to_str().unwrap_or_default().to_lowercase();
        if directory.as_os_str() != OFF && NEAR_OFF.contains(&word.as_str()) && !directory.exists() {
            return Err(InvalidParam::new(
                format!("`{origin}` names a directory that does not exist; is \"off\" meant?"),
                format!(
                    "use --no-cache for a run without the structure cache, or name the directory ./{word}"
                ),
            ));
        }
        Ok(())
    }

    /// Returns the assignments of params: those of the file first, then those that override it.
    ///
    /// # Errors
    /// The file cannot be read, or is not a params file.
    pub fn given(&self) -> Result<Vec<ParamAssignment>, InvalidParam> {
        given_of(self.params.as_deref(), &self.set)
    }
}

/// Returns the assignments of params: those of the file first, then those that override it.
///
/// # Errors
/// The file cannot be read, or is not a params file.
pub fn given_of(file: Option<&Path>, set: &[ParamAssignment]) -> Result<Vec<ParamAssignment>, InvalidParam> {
    let mut given = file.map(params_file::read).transpose()?.unwrap_or_default();
    given.extend(set.iter().cloned());
    Ok(given)
}

/// Returns the directory of the structure cache: the one of the environment variable, else one in
/// the user's cache directory. `None` if the cache is disabled or there is no such directory.
fn cache_directory() -> Option<PathBuf> {
    match std::env::var_os(CACHE_VARIABLE).filter(|name| !name.is_empty()) {
        Some(name) if name == OFF => None,
        Some(name) => Some(PathBuf::from(name)),
        None => Some(etcetera::choose_base_strategy().ok()?.cache_dir().join("calyx/structures")),
    }
}

/// Returns the path of the file with the measured computing rates of this machine.
pub fn rates_file() -> Option<PathBuf> {
    Some(cache_directory()?.join("rates.json"))
}
