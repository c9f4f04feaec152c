//! What an analysis uses and no result depends on.

use calyx_numerics::interrupt::Interrupt;
use calyx_structure::cache::OperatorCache;
use std::sync::Arc;

/// Threads, kept structures and an interrupt. By default: rayon's global threads, nothing kept, never interrupted.
#[derive(Clone, Debug, Default)]
pub struct Resources {
    /// Asked at every checkpoint whether to go on.
    pub interrupt: Interrupt,
    /// Where structures come from and go to.
    pub cache: Option<Arc<OperatorCache>>,
    /// Threads for everything that is done side by side. Results have the same bits whatever their number.
    pub pool: Option<Arc<rayon::ThreadPool>>,
}

impl Resources {
    /// How many threads there are.
    pub fn threads(&self) -> usize {
        self.pool.as_ref().map_or_else(rayon::current_num_threads, |pool| pool.current_num_threads())
    }

    /// Does `work` on the pool.
    pub fn install<T: Send>(&self, work: impl FnOnce() -> T + Send) -> T {
        match &self.pool {
            Some(pool) => pool.install(work),
            None => work(),
        }
    }
}
