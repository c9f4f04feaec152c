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
const AHEAD: usize = 8;

impl Resources {
    /// Computes the values of the indices below `count` in parallel and passes them on in order, on
    /// the calling thread, until `take` breaks. Meanwhile the pool computes the following values, of
    /// which a limited number exists at a time.
    pub fn in_order<T: Send>(
        &self,
        count: usize,
        compute: impl Fn(usize) -> T + Sync,
        mut take: impl FnMut(usize, T) -> ControlFlow<()>,
    ) {
        // A thread of a pool must not wait for values that it may have to compute itself.
        let waits = rayon::current_thread_index().is_none();
        let length = if waits { AHEAD * self.threads() } else { self.threads() };
        for first in (0..count).step_by(length) {
            let block = first..count.min(first + length);
            let ended = if waits {
                self.pass_on((block, count), &compute, &mut take)
            } else {
                let all = || block.clone().into_par_iter().map(&compute).collect::<Vec<_>>();
                block.clone().zip(self.install(all)).try_for_each(|(index, value)| take(index, value))
            };
            if ended.is_break() {
                return;
            }
        }
    }

    /// Computes and passes on a block of all values on a thread outside of the pool. Every thread of the
    /// pool has one job that computes one value after another: of several jobs, a thread might
    /// begin the next one while it waits for others to complete a part of the first.
    fn pass_on<T: Send>(
        &self,
        (block, count): (Range<usize>, usize),
        compute: &(impl Fn(usize) -> T + Sync),
        take: &mut impl FnMut(usize, T) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
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
                // There is no receiver any more if the computation has ended.
                let _ = sender.send((index, value));
            }
        };
        let mut take_all = || {
            let mut waiting = BTreeMap::new();
            for index in block.clone() {
                let value = loop {
                    match waiting.remove(&index) {
                        Some(value) => break value,
                        // The jobs send all values of the block.
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
        match &self.pool {
            Some(pool) => pool.in_place_scope(|scope| {
                scope.spawn_broadcast(|_, _| compute_all());
                take_all()
            }),
            None => rayon::in_place_scope(|scope| {
                scope.spawn_broadcast(|_, _| compute_all());
                take_all()
            }),
        }
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
