//! Resources that instances share: threads and the structure cache. None is global, and two engines
//! are independent.

use crate::error::Error;
use crate::watcher;
use calyx_abi::error::codes;
use calyx_abi::limits::Limits;
use calyx_abi::{Cancel, RuntimeError};
use calyx_runtime::cache::{CacheCounts, OperatorCache, Store};
use calyx_runtime::error::EngineError;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::resources::Resources;
use std::sync::{Arc, Mutex, PoisonError};

/// Configuration of an engine.
#[derive(Clone, Debug, PartialEq)]
pub struct EngineConfig {
    /// Number of threads that analyses share; 0 is one per core.
    pub threads: usize,
    /// Size in bytes of the structure cache in memory. Static condensation is the longest part of
    /// an analysis, and its result is the same while geometry and material are unchanged. 0
    /// disables the cache.
    pub kept: usize,
    /// Structure cache on disk, for other processes and future runs. None by default: the embedding
    /// program decides which files it writes.
    pub store: Option<Store>,
}

impl Default for EngineConfig {
    fn default() -> EngineConfig {
        EngineConfig { threads: 0, kept: 512 << 20, store: None }
    }
}

/// Resources that instances share: threads and the structure cache.
///
/// Most programs have one. Its creation is cheap; its threads start with the first analysis. A
/// clone is the same engine and may be used by any thread. The engine lives as long as any object
/// created from it.
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

    /// Creates an engine with a number of threads of its own and the structure cache of this one.
    #[cfg(feature = "command")]
    pub(crate) fn with_threads(&self, threads: usize) -> Engine {
        let config = EngineConfig { threads, ..self.0.config.clone() };
        Engine(Arc::new(Shared { config, cache: self.0.cache.clone(), pool: Mutex::default() }))
    }

    pub fn config(&self) -> &EngineConfig {
        &self.0.config
    }

    /// Returns the number of cached structures and the hits.
    pub fn kept(&self) -> CacheCounts {
        self.0.cache.counts()
    }

    /// Returns the resources for an analysis.
    pub(crate) fn resources(&self, interrupt: Interrupt) -> Result<Resources, Error> {
        let EngineConfig { kept, store, .. } = &self.0.config;
        let cache = (*kept > 0 || store.is_some()).then(|| self.0.cache.clone());
        Ok(Resources { interrupt, cache, pool: Some(self.pool()?) })
    }

    /// Runs work outside of an instance on the threads of this engine. Its interrupt ends it if it
    /// is cancelled, or requests more memory than this machine has.
    ///
    /// # Errors
    /// The threads cannot be started.
    pub fn work<T: Send>(
        &self,
        cancel: Cancel,
        work: impl FnOnce(&Interrupt) -> T + Send,
    ) -> Result<T, EngineError> {
        let interrupt = watcher::interrupt(cancel, Limits::default());
        let pool = self
            .pool()
            .map_err(|error| EngineError::new(codes::INTERNAL, error.to_string(), "use fewer threads"))?;
        Ok(pool.install(|| work(&interrupt)))
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
