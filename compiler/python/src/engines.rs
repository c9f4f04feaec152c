//! Engines of the process: one for each number of threads and structure cache.

use calyx::rt::options::RunArguments;
use calyx::{Engine, EngineConfig};
use pyo3::prelude::*;
use std::collections::HashMap;
use std::mem;
use std::path::PathBuf;
use std::sync::{LazyLock, Mutex, PoisonError};

/// Settings of new runs.
#[derive(Default)]
struct Engines {
    /// Number of threads; 0 is one per core.
    threads: usize,
    /// Directory of the structure cache, or "off"; that of the command by default.
    cache: Option<PathBuf>,
    /// Engines by number of threads.
    engines: HashMap<usize, Engine>,
    /// Process that created the engines.
    process: u32,
}

static ENGINES: LazyLock<Mutex<Engines>> = LazyLock::new(Mutex::default);

/// Returns the engine of a number of threads; 0 is the configured number.
pub fn engine(threads: usize) -> Engine {
    let mut all = ENGINES.lock().unwrap_or_else(PoisonError::into_inner);
    let process = std::process::id();
    if all.process != process {
        // After a fork, the threads of the engines exist in the parent process only, and waiting
        // for them would not end.
        mem::forget(mem::take(&mut all.engines));
        all.process = process;
    }
    let threads = if threads == 0 { all.threads } else { threads };
    if let Some(engine) = all.engines.get(&threads) {
        return engine.clone();
    }
    let store = RunArguments::store_of(all.cache.as_deref(), false);
    let engine = Engine::new(EngineConfig { threads, store, ..EngineConfig::default() });
    all.engines.insert(threads, engine.clone());
    engine
}

/// Sets the number of threads (0: one per core) and the directory of the structure cache ("off":
/// none; None: the user's) of later runs.
#[pyfunction]
pub fn configure(threads: usize, cache: Option<PathBuf>) {
    let mut all = ENGINES.lock().unwrap_or_else(PoisonError::into_inner);
    let engines = mem::take(&mut all.engines);
    if all.process != std::process::id() {
        mem::forget(engines);
    }
    *all = Engines { threads, cache, process: std::process::id(), ..Engines::default() };
}
