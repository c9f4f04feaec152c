//! Threads for long texts. Results do not depend on the number of threads.

use std::num::NonZero;
use std::sync::{Mutex, PoisonError};
use std::thread::{Builder, available_parallelism, scope};

/// Least length of a text, bytes, for which another thread pays off: parsing and checking it takes
/// some milliseconds.
const BYTES_OF_THREAD: usize = 16 << 10;

/// Returns the number of threads for parsing or checking a text of this length.
pub(crate) fn for_text(bytes: usize) -> usize {
    // The number of cores is a system call, which short texts need not wait for.
    match bytes / BYTES_OF_THREAD {
        0 | 1 => 1,
        most => available_parallelism().map_or(1, NonZero::get).min(most),
    }
}

/// Runs `work` for each job, on so many threads including this one. If the system creates no
/// thread, the others do its work.
pub(crate) fn for_each<J: Send>(jobs: Vec<J>, threads: usize, work: impl Fn(J) + Sync) {
    let left = Mutex::new(jobs.into_iter());
    let run = || {
        loop {
            let Some(job) = left.lock().unwrap_or_else(PoisonError::into_inner).next() else { break };
            work(job);
        }
    };
    scope(|scope| {
        for _ in 1..threads {
            let _ = Builder::new().spawn_scoped(scope, run);
        }
        run();
    });
}
