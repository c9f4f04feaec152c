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

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;
    use std::thread::{self, ThreadId};
    use std::time::Duration;

    /// Returns the threads that compute parts.
    fn threads() -> BTreeSet<String> {
        let compute = |_: &u32| {
            thread::sleep(Duration::from_millis(1));
            Ok::<ThreadId, ()>(thread::current().id())
        };
        let found = try_map(&[0; 400], compute).expect("no part fails");
        found.into_iter().map(|thread| format!("{thread:?}")).collect()
    }

    #[test]
    fn one_thread_computes_all_parts_while_the_others_are_busy() {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().expect("threads");
        pool.install(|| {
            assert_eq!(while_all_are_busy(threads).len(), 1);
            assert!(threads().len() > 1);
            let panics = std::panic::catch_unwind(|| while_all_are_busy(|| panic!("while busy")));
            assert!(panics.is_err());
            assert!(threads().len() > 1, "after a panic");
        });
    }

    #[test]
    fn errors_are_returned() {
        let fails = |&item: &u32| if item == 3 { Err(item) } else { Ok(item) };
        assert_eq!(try_map(&[1, 2, 3, 4], fails), Err(3));
        assert_eq!(while_all_are_busy(|| try_map(&[1, 2], fails)), Ok(vec![1, 2]));
    }
}
