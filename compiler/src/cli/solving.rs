//! Options of the commands that solve many cases: `calyx sweep` and `calyx optimize`.

use calyx::rt::options::RunArguments;
use calyx::rt::progress::{Progress, ProgressFormat};
use calyx::rt::{Engine, EngineConfig};
use clap::Args;
use std::num::NonZeroUsize;
use std::thread::available_parallelism;

#[derive(Args)]
pub struct Solving {
    /// Number of threads, and of cases at a time [default: number of cores]
    #[arg(long, value_name = "N")]
    threads: Option<NonZeroUsize>,
    /// Do not use the structure cache on disk
    #[arg(long)]
    pub no_cache: bool,
    /// Print only the table and errors
    #[arg(long)]
    pub quiet: bool,
    /// Format of progress on standard error
    #[arg(long, value_enum, default_value_t, value_name = "FORMAT")]
    progress: ProgressFormat,
}

impl Solving {
    /// Returns the number of cases that are solved at a time.
    pub fn workers(&self) -> usize {
        self.threads.or_else(|| available_parallelism().ok()).map_or(1, NonZeroUsize::get)
    }

    /// Creates the engine that all cases share.
    pub fn engine(&self) -> Engine {
        let store = RunArguments::store_of(None, self.no_cache);
        Engine::new(EngineConfig { threads: self.workers(), store, ..EngineConfig::default() })
    }

    pub fn progress(&self) -> Progress {
        Progress::new(self.progress, self.quiet, true)
    }
}
