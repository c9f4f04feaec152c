//! What instances share: threads and kept structures. Nothing of it is the process's, and two engines know nothing of
//! each other.

use crate::error::Error;
use calyx_abi::RuntimeError;
use calyx_abi::error::codes;
use calyx_runtime::cache::{CacheCounts, OperatorCache, Store};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::resources::Resources;
use std::sync::{Arc, Mutex, PoisonError};

/// How an engine is set up.
#[derive(Clone, Debug, PartialEq)]
pub struct EngineConfig {
    /// Threads that analyses share; 0 is one per core.
    pub threads: usize,
    /// Bytes of structures that are kept for analyses to come: the part of an analysis that takes longest, and the same
    /// as long as geometry and material are. 0 keeps none.
    pub kept: usize,
    /// Where structures are kept on disk, for other processes and runs to come. By default nowhere: a program that embeds models says
    /// what it writes.
    pub store: Option<Store>,
}

impl Default for EngineConfig {
    fn default() -> EngineConfig {
        EngineConfig { threads: 0, kept: 512 << 20, store: None }
    }
}

/// What instances share: threads, and the structures of gears that were analysed before.
///
/// Most programs have one. Making it is cheap, its threads start with the first analysis; a clone is the same engine, to
/// be used by any thread. It lives as long as anything that came from it.
#[derive(Clone, Debug, Default)]
pub struct Engine(Arc<Shared>);

#[derive(Debug)]
struct Shared {
    config: EngineConfig,
    cache: Arc<OperatorCache>,
    pool: Mutex<Option<Arc<rayon::ThreadPool>>>,
}

impl Default for Shared {
    fn default() -> Shared {
        Shared::new(EngineConfig::default())
    }
}

impl Shared {
    fn new(config: EngineConfig) -> Shared {
        let cache = OperatorCache::new(config.kept);
        let cache = Arc::new(match &config.store {
            Some(store) => cache.with_store(store.clone()),
            None => cache,
        });
        Shared { config, cache, pool: Mutex::default() }
    }
}

impl Engine {
    pub fn new(config: EngineConfig) -> Engine {
        Engine(Arc::new(Shared::new(config)))
    }

    pub fn config(&self) -> &EngineConfig {
        &self.0.config
    }

    /// Structures that were kept, and how often they served.
    pub fn kept(&self) -> CacheCounts {
        self.0.cache.counts()
    }

    /// What an analysis uses of this engine.
    pub(crate) fn resources(&self, interrupt: Interrupt) -> Result<Resources, Error> {
        let EngineConfig { kept, store, .. } = &self.0.config;
        let cache = (*kept > 0 || store.is_some()).then(|| self.0.cache.clone());
        Ok(Resources { interrupt, cache, pool: Some(self.pool()?) })
    }

    fn pool(&self) -> Result<Arc<rayon::ThreadPool>, Error> {
        let mut pool = self.0.pool.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(pool) = &*pool {
            return Ok(pool.clone());
        }
        let threads = rayon::ThreadPoolBuilder::new().num_threads(self.0.config.threads);
        let made = threads.thread_name(|index| format!("calyx {index}")).build().map_err(|error| {
            RuntimeError::new(
                codes::INTERNAL,
                format!("cannot start the engine's threads: {error}"),
                "raise the limit on threads of this process, or give the engine fewer",
            )
        })?;
        Ok(pool.insert(Arc::new(made)).clone())
    }
}
