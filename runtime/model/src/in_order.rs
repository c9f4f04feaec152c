//! Parallel computation of values that are passed on in order.

use crate::resources::Resources;
use calyx_numerics::parallel::while_all_are_busy;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::ops::{ControlFlow, Range};
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc;

/// Number of values per thread that are computed before a thread may have to wait for others.
const AHEAD: usize = 4;

impl Resources {
    /// Computes the values of the indices below `count` in parallel and passes them on in order, on
    /// the calling thread, until `take` breaks. Meanwhile the pool computes the following values,
    /// of which a limited number exists at a time; if the calling thread belongs to a pool, one
    /// value per thread is computed before they are passed on. Returns the computed values that
    /// `take` has not received after a break, with their indices.
    pub fn in_order<T: Send>(
        &self,
        count: usize,
        compute: impl Fn(usize) -> T + Sync,
        mut take: impl FnMut(usize, T) -> ControlFlow<()>,
    ) -> Vec<(usize, T)> {
        // A thread of a pool must not wait for values that it may have to compute itself, and a
        // single value need not wait for all threads of the pool.
        let waits = rayon::current_thread_index().is_none() && count > 1;
        let length = if waits { AHEAD * self.threads() } else { self.threads() };
        for first in (0..count).step_by(length) {
            let block = first..count.min(first + length);
            let left = if waits {
                self.compute_and_take((block, count), &compute, &mut take)
            } else {
                let all = || block.clone().into_par_iter().map(&compute).collect::<Vec<_>>();
                let mut values = block.clone().zip(self.install(all));
                let broken = values.any(|(index, value)| take(index, value).is_break());
                broken.then(|| values.collect())
            };
            if let Some(left) = left {
                return left;
            }
        }
        Vec::new()
    }

    /// Computes a block of all values on the pool and takes them on this thread, outside of the
    /// pool. Returns the computed values that are left if `take` breaks.
    ///
    /// Every thread of the pool has one job that computes one value after another: of several jobs,
    /// a thread might begin the next one while it waits for others to complete a part of the first.
    /// It may still begin the job of another caller that shares the pool.
    fn compute_and_take<T: Send>(
        &self,
        (block, count): (Range<usize>, usize),
        compute: &(impl Fn(usize) -> T + Sync),
        take: &mut impl FnMut(usize, T) -> ControlFlow<()>,
    ) -> Option<Vec<(usize, T)>> {
        let threads = self.threads();
        let (next, ended) = (AtomicUsize::new(block.start), AtomicBool::new(false));
        let (sender, receiver) = mpsc::channel();
        let compute_all = || {
            while !ended.load(Ordering::Relaxed) {
                let index = next.fetch_add(1, Ordering::Relaxed);
                if index >= block.end {
                    return;
                }
                let compute = || match count - index >= threads {
                    true => while_all_are_busy(|| compute(index)),
                    false => compute(index),
                };
                let value = catch_unwind(AssertUnwindSafe(compute));
                if value.is_err() {
                    // Values before this one are being computed already.
                    ended.store(true, Ordering::Relaxed);
                }
                // The receiver exists until all jobs have ended.
                let _ = sender.send((index, value));
            }
        };
        let mut waiting = BTreeMap::new();
        let mut take_all = || {
            for index in block.clone() {
                let value = loop {
                    match waiting.remove(&index) {
                        Some(value) => break value,
                        // The jobs send all values up to the end or a panic.
                        None => waiting.extend(receiver.recv()),
                    }
                };
                if take(index, value.unwrap_or_else(|panic| resume_unwind(panic))).is_break() {
                    ended.store(true, Ordering::Relaxed);
                    return ControlFlow::Break(());
                }
            }
            ControlFlow::Continue(())
        };
        let result = match &self.pool {
            Some(pool) => pool.in_place_scope(|scope| {
                scope.spawn_broadcast(|_, _| compute_all());
                take_all()
            }),
            None => rayon::in_place_scope(|scope| {
                scope.spawn_broadcast(|_, _| compute_all());
                take_all()
            }),
        };
        waiting.extend(receiver.try_iter());
        let computed = waiting.into_iter().filter_map(|(index, value)| Some((index, value.ok()?)));
        result.is_break().then(|| computed.collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::time::Duration;

    /// Returns resources with a pool of this number of threads.
    fn with_threads(threads: usize) -> Resources {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        Resources { pool: Some(Arc::new(pool)), ..Resources::default() }
    }

    /// Returns the squares of the indices below 50, which are taken in order although some take
    /// longer.
    fn squares(resources: &Resources) -> Vec<usize> {
        let mut taken = Vec::new();
        let compute = |index: usize| {
            std::thread::sleep(Duration::from_millis(if index.is_multiple_of(3) { 4 } else { 0 }));
            index * index
        };
        resources.in_order(50, compute, |index, value| {
            assert_eq!(index, taken.len());
            taken.push(value);
            ControlFlow::Continue(())
        });
        taken
    }

    #[test]
    fn values_are_taken_in_order() {
        let expected: Vec<usize> = (0..50).map(|index| index * index).collect();
        for threads in [1, 2, 5] {
            let resources = with_threads(threads);
            assert_eq!(squares(&resources), expected);
            assert_eq!(resources.install(|| squares(&resources)), expected, "on a thread of the pool");
        }
        assert_eq!(squares(&Resources::default()), expected);
    }

    /// Parallel work inside a value does not begin another value, which would delay the first.
    #[test]
    fn each_thread_computes_one_value_at_a_time() {
        let resources = with_threads(3);
        let nested = AtomicUsize::new(0);
        let compute = |_| {
            let computing = nested.fetch_add(1, Ordering::Relaxed);
            let parts = (0..8).into_par_iter().map(|_| std::thread::sleep(Duration::from_millis(1)));
            parts.collect::<Vec<_>>();
            nested.fetch_sub(1, Ordering::Relaxed);
            computing
        };
        resources.in_order(30, compute, |_, computing| {
            assert!(computing < 3);
            ControlFlow::Continue(())
        });
    }

    #[test]
    fn values_computed_after_the_end_are_returned() {
        let resources = with_threads(3);
        let take = |index, _| if index == 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        let others = AtomicUsize::new(0);
        let last = |index: usize| {
            // The value of index 1 is computed after the others of the block.
            while index == 1 && others.load(Ordering::Relaxed) < 11 {
                std::thread::yield_now();
            }
            others.fetch_add(1, Ordering::Relaxed);
            10 * index
        };
        let left = resources.in_order(100, last, take);
        assert_eq!(left, (2..12).map(|index| (index, 10 * index)).collect::<Vec<_>>());
        let left = resources.install(|| resources.in_order(100, |index| 10 * index, take));
        assert_eq!(left, [(2, 20)], "on a thread of the pool");
        assert_eq!(resources.in_order(5, |index| index, |_, _| ControlFlow::Continue(())), []);
    }

    /// Several callers share a pool whose threads they all wait for.
    #[test]
    fn callers_share_a_pool() {
        let resources = with_threads(2);
        let expected: Vec<usize> = (0..50).map(|index| index * index).collect();
        std::thread::scope(|scope| {
            let callers: Vec<_> = (0..4).map(|_| scope.spawn(|| squares(&resources))).collect();
            for caller in callers {
                assert_eq!(caller.join().expect("no caller panics"), expected);
            }
        });
    }

    #[test]
    fn few_values_are_computed_after_the_end() {
        for on_thread_of_pool in [false, true] {
            let resources = with_threads(2);
            let started = AtomicUsize::new(0);
            let compute = |_| started.fetch_add(1, Ordering::Relaxed);
            let run = || {
                let mut taken = 0;
                resources.in_order(1000, compute, |index, _| {
                    taken += 1;
                    if index == 4 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                });
                taken
            };
            let taken = if on_thread_of_pool { resources.install(run) } else { run() };
            assert_eq!(taken, 5);
            assert!(started.load(Ordering::Relaxed) <= 2 * AHEAD);
        }
    }

    #[test]
    #[should_panic(expected = "at 3")]
    fn a_panic_reaches_the_caller() {
        let compute = |index| if index == 3 { panic!("at {index}") } else { index };
        with_threads(2).in_order(10, compute, |_, _| ControlFlow::Continue(()));
    }
}
