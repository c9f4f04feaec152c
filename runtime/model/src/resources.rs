//! Resources of an analysis, on which no result depends.

use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::OperatorCache;
use std::sync::Arc;

/// Threads, structure cache and interrupt. By default: rayon's global threads, no cache, no
/// interrupt.
#[derive(Clone, Debug, Default)]
pub struct Resources {
    /// Callback at every checkpoint.
    pub interrupt: Interrupt,
    /// Structure cache.
    pub cache: Option<Arc<OperatorCache>>,
    /// Thread pool for parallel work. Results are bitwise equal for any number of threads.
    pub pool: Option<Arc<rayon::ThreadPool>>,
}

impl Resources {
    /// Returns the number of threads.
    pub fn threads(&self) -> usize {
        self.pool.as_ref().map_or_else(rayon::current_num_threads, |pool| pool.current_num_threads())
    }

    /// Runs `work` on the pool.
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}
