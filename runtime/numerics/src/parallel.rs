//! Parallel computation of the parts of a value that may be one of many.
//!
//! If many values are computed in parallel, parallel parts do not make them faster: a thread that
//! waits for a part of its value may be late for the next one.

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use std::cell::Cell;

thread_local! {
    static ALL_BUSY: Cell<bool> = const { Cell::new(false) };
}

/// Computes a value while other values keep all other threads busy: [`try_map`] within it uses this
/// thread alone.
pub fn while_all_are_busy<T>(compute: impl FnOnce() -> T) -> T {
    /// Restores the former state, also after a panic.
    struct Restore(bool);
    impl Drop for Restore {
        fn drop(&mut self) {
            ALL_BUSY.set(self.0);
        }
    }
    let _restore = Restore(ALL_BUSY.replace(true));
    compute()
}

/// Computes a result for each item: in parallel, unless all other threads are busy.
///
/// # Errors
/// The first error, or one of the errors of a parallel computation.
pub fn try_map<T: Sync, R: Send, E: Send>(
    items: &[T],
    compute: impl Fn(&T) -> Result<R, E> + Sync,
) -> Result<Vec<R>, E> {
    if ALL_BUSY.get() {
        items.iter().map(compute).collect()
    } else {
        items.par_iter().map(&compute).collect()
    }
}
