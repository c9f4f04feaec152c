//! What can be asked of a run on a command line: one set of options for `calyx run` and for executables.

use crate::budget;
use crate::given::Given;
use crate::overriding::OverrideArguments;
use crate::params::Refused;
use crate::params_file;
use crate::progress::ProgressFormat;
use calyx_runtime::cache::Store;
use clap::Args;
use etcetera::BaseStrategy;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// The options of a run.
#[derive(Args, Clone, Debug, Default)]
pub struct RunArguments {
    /// Set a param, like torque=500 or "torque=60 N*m"
    ///
    /// A bare VALUE is in the unit of the param's default. May be given several times; the last of a name counts, and it
    /// counts more than a file of --params.
    #[arg(long, value_name = "NAME=VALUE", value_parser = Given::name_and_value, help_heading = PARAMS)]
    pub set: Vec<Given>,
    /// Read params from FILE.json or FILE.toml
    ///
    /// An object or table of names and values. Numbers are in the unit of the param's default, texts like "0.5 mm" have
    /// their own. --print-params says what such a file may hold.
    #[arg(long, value_name = "FILE", help_heading = PARAMS)]
    pub params: Option<PathBuf>,
    /// Print what the params are, as JSON Schema, and run nothing
    #[arg(long, help_heading = PARAMS)]
    pub print_params: bool,
    #[command(flatten)]
    pub overrides: OverrideArguments,
    /// Directory for the results [default: the model's name and .run]
    ///
    /// Gets report.html (all of it, to be looked at), run.json (inputs, outputs, certificate), steps.csv (a row a position) and
    /// timing.json. A run replaces only files that an earlier run wrote; they are listed in .calyx-run. Results of an earlier run
    /// stay until the first position is solved. One run at a time writes to a directory.
    #[arg(long, value_name = "DIR", help_heading = RESULTS)]
    pub out: Option<PathBuf>,
    /// Write to a directory that holds files which no run wrote
    ///
    /// Without it, a run replaces only files that an earlier run wrote, and refuses a directory with other files. With it, files
    /// that have names of results, like run.json and steps.csv, are replaced; all others stay.
    #[arg(long, help_heading = RESULTS)]
    pub force: bool,
    /// Go on where an earlier run was ended
    ///
    /// Begins after the last position that the run in the results' directory completed. Model and params must be those of
    /// that run, and the results are those of a run that was never ended.
    #[arg(long, help_heading = RESULTS)]
    pub resume: bool,
    /// Write the fields of every position too
    ///
    /// pressure.csv (cell by cell), root_stress.csv (along the fillets, if an output asks for stress) and places.csv (where each
    /// maximum is). line_load.csv (along the lines of contact) is always there; of more than 256 positions it then has all.
    #[arg(long, help_heading = RESULTS)]
    pub fields: bool,
    /// Write pictures of every position for ParaView
    ///
    /// Contact pressure, stress in the fillets if an output asks for stress, and the meshes of elastic bodies with their displacements and
    /// stresses, as VTU files in the directory vtu of the results.
    #[arg(long, help_heading = RESULTS)]
    pub vtu: bool,
    /// Print the results on standard output, as one JSON document
    ///
    /// What run.json says, and the rows of steps.csv. What the model prints then goes to standard error.
    #[arg(long, help_heading = RESULTS)]
    pub json: bool,
    /// Print nothing but what the model prints, and errors
    #[arg(long)]
    pub quiet: bool,
    /// How progress is shown on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    pub progress: ProgressFormat,
    /// Keep the structures of gears in this directory for runs to come [default: calyx/structures in the user's cache]
    ///
    /// Condensing the structures is most of the work of a run, and the same as long as geometry and material are. The environment
    /// variable CALYX_CACHE names a directory too, or is "off". Files there are trusted: whoever can write to the directory can
    /// change the results of later runs.
    #[arg(long, value_name = "DIR", help_heading = KEPT)]
    pub cache: Option<PathBuf>,
    /// Keep no structures on disk, and take none from there
    #[arg(long, conflicts_with = "cache", help_heading = KEPT)]
    pub no_cache: bool,
    /// Use this many threads [default: one a core]
    ///
    /// The results have the same bits with any number.
    #[arg(long, value_name = "N", help_heading = LIMITS)]
    pub threads: Option<NonZeroUsize>,
    /// End the run with an error after this time, like 10s or 5min
    #[arg(long, value_name = "TIME", value_parser = budget::time, help_heading = LIMITS)]
    pub time_limit: Option<Duration>,
    /// End the run with an error when it takes more memory, like 2GB
    #[arg(long, value_name = "SIZE", value_parser = budget::memory, help_heading = LIMITS)]
    pub memory_limit: Option<u64>,
}

const PARAMS: &str = "Giving params";
const RESULTS: &str = "Results";
const LIMITS: &str = "Limits";
const KEPT: &str = "Kept structures";
/// Names the directory of kept structures, or is "off".
const CACHE_VARIABLE: &str = "CALYX_CACHE";
/// Of kept structures on disk, bytes: some dozens of pairs of gears in space.
const CACHE_LIMIT: u64 = 4 << 30;

impl RunArguments {
    /// Where structures are kept on disk; `None` if that is not wanted or the user has no place for such files.
    pub fn store(&self) -> Option<Store> {
        let directory = match &self.cache {
            _ if self.no_cache => return None,
            Some(directory) => directory.clone(),
            None => cache_directory()?,
        };
        Some(Store::new(directory, CACHE_LIMIT))
    }

    /// What is given for params: of the file first, then what counts more.
    ///
    /// # Errors
    /// The file cannot be read, or is not one of params.
    pub fn given(&self) -> Result<Vec<Given>, Refused> {
        given_of(self.params.as_deref(), &self.set)
    }
}

/// What is given for params: of the file first, then what counts more.
///
/// # Errors
/// The file cannot be read, or is not one of params.
pub fn given_of(file: Option<&Path>, set: &[Given]) -> Result<Vec<Given>, Refused> {
    let mut given = file.map(params_file::read).transpose()?.unwrap_or_default();
    given.extend(set.iter().cloned());
    Ok(given)
}

/// Where the user's cache is: the directory that the environment names, else the user's own; `None` if nothing is to be kept or there is no
/// place for such files.
fn cache_directory() -> Option<PathBuf> {
    match std::env::var_os(CACHE_VARIABLE).filter(|name| !name.is_empty()) {
        Some(name) if name == "off" => None,
        Some(name) => Some(PathBuf::from(name)),
        None => Some(etcetera::choose_base_strategy().ok()?.cache_dir().join("calyx/structures")),
    }
}

/// Where the rates are kept that this machine was measured to have.
pub fn rates_file() -> Option<PathBuf> {
    Some(cache_directory()?.join("rates.json"))
}
