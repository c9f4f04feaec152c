//! Results of the library's functions in earlier elaborations. An editor elaborates a model after
//! each edit, and most calls, such as those that compute the teeth of a bevel gear from its machine
//! settings, have unchanged arguments.

use calyx_lower::interpret::{CallContent, CallResult, CallResults};
use calyx_lower::recently_used::RecentlyUsed;
use std::sync::{Arc, LazyLock, Mutex, MutexGuard, PoisonError};

/// Limit of the memory of all stored results, bytes.
const MOST_BYTES: usize = 32_000_000;

/// The results of this process.
pub(crate) struct KnownResults;

fn known() -> MutexGuard<'static, RecentlyUsed<CallContent, Arc<CallResult>>> {
    static KNOWN: LazyLock<Mutex<RecentlyUsed<CallContent, Arc<CallResult>>>> =
        LazyLock::new(|| Mutex::new(RecentlyUsed::new(MOST_BYTES)));
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner)
}

impl CallResults for KnownResults {
    fn find(&self, call: CallContent) -> Option<Arc<CallResult>> {
        known().find(call)
    }

    fn store(&self, call: CallContent, result: CallResult) {
        let size = result.size();
        known().store(call, Arc::new(result), size);
    }
}
