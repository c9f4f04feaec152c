//! Parallel computation of values that are passed on in order.

use crate::resources::Resources;
use calyx_numerics::parallel::while_all_are_busy;
use rayon::BroadcastContext;
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::{Mutex, MutexGuard, PoisonError, mpsc};

/// Number of values per thread that may exist before they are passed on.
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
        if rayon::current_thread_index().is_none() && count > 1 {
            return self.compute_ahead(count, &compute, &mut take);
        }
        let length = self.threads();
        for first in (0..count).step_by(length) {
            let block = first..count.min(first + length);
            let all = || block.clone().into_par_iter().map(&compute).collect::<Vec<_>>();
            let mut values = block.clone().zip(self.install(all));
            if values.any(|(index, value)| take(index, value).is_break()) {
                return values.collect();
            }
        }
        Vec::new()
    }

    /// Computes values on the pool and takes them on this thread, outside of the pool.
    ///
    /// Every thread of the pool has one job that computes one value after another: of several jobs,
    /// a thread might begin the next one while it waits for others to complete a part of the first.
    /// It may still begin the job of another caller that shares the pool, or resume its own. A job
    /// ends only where the window does, so callers of one pool may wait for each other.
    fn compute_ahead<T: Send>(
        &self,
        count: usize,
        compute: &(impl Fn(usize) -> T + Sync),
        take: &mut impl FnMut(usize, T) -> ControlFlow<()>,
    ) -> Vec<(usize, T)> {
        let threads = self.threads();
        let window = Window::new(count, threads);
        let (sender, receiver) = mpsc::channel();
        let compute_all = |context: BroadcastContext<'_>| {
            let thread = context.index();
            if !window.begin(thread) {
                return;
            }
            while let Some(index) = window.claim(thread) {
                let compute = || match count - index >= threads {
                    true => while_all_are_busy(|| compute(index)),
                    false => compute(index),
                };
                let value = catch_unwind(AssertUnwindSafe(compute));
                if value.is_err() {
                    // Values before this one are being computed already.
                    window.end();
                }
                // The receiver exists until all jobs have ended.
                let _ = sender.send((index, value));
            }
        };
        let mut waiting = BTreeMap::new();
        let mut take_all = |resume: &dyn Fn()| {
            resume();
            for index in 0..count {
                let value = loop {
                    match waiting.remove(&index) {
                        Some(value) => break value,
                        // The jobs send all values up to the end or a panic.
                        None => waiting.extend(receiver.recv()),
                    }
                };
                if take(index, value.unwrap_or_else(|panic| resume_unwind(panic))).is_break() {
                    window.end();
                    return;
                }
                if window.take() {
                    resume();
                }
            }
        };
        let compute_all = &compute_all;
        let resume = |_: &_, context: BroadcastContext<'_>| compute_all(context);
        match &self.pool {
            Some(pool) => pool.in_place_scope(|scope| take_all(&|| scope.spawn_broadcast(resume))),
            None => rayon::in_place_scope(|scope| take_all(&|| scope.spawn_broadcast(resume))),
        }
        waiting.extend(receiver.try_iter());
        waiting.into_iter().filter_map(|(index, value)| Some((index, value.ok()?))).collect()
    }
}

/// The values that may be computed: a limited number of values beyond those that have been taken.
/// A thread pauses where they end.
struct Window {
    count: usize,
    /// Largest number of values that are being computed or wait to be taken.
    ahead: usize,
    state: Mutex<WindowState>,
}

struct WindowState {
    /// Index of the next value to be computed.
    next: usize,
    /// Number of values that have been taken.
    taken: usize,
    ended: bool,
    /// State of each thread.
    threads: Vec<Thread>,
}

/// State of a thread of the pool.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Thread {
    Computes,
    /// It has no job.
    Paused,
    /// A job waits for it.
    Called,
}

impl Window {
    /// Returns the window of the first values; all threads are called.
    fn new(count: usize, threads: usize) -> Self {
        let threads_called = vec![Thread::Called; threads];
        let state = WindowState { next: 0, taken: 0, ended: false, threads: threads_called };
        Self { count, ahead: AHEAD * threads, state: Mutex::new(state) }
    }

    fn state(&self) -> MutexGuard<'_, WindowState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Begins the job of a thread. Returns whether it was called.
    fn begin(&self, thread: usize) -> bool {
        let mut state = self.state();
        let called = state.threads[thread] == Thread::Called;
        if called {
            state.threads[thread] = Thread::Computes;
        }
        called
    }

    /// Returns the index of the next value to be computed by a thread, which pauses if there is
    /// none in the window.
    fn claim(&self, thread: usize) -> Option<usize> {
        let mut state = self.state();
        if state.ended || state.next == self.count {
            return None;
        }
        if state.next == state.taken + self.ahead {
            state.threads[thread] = Thread::Paused;
            return None;
        }
        state.next += 1;
        Some(state.next - 1)
    }

    /// Moves the window on by one value and calls threads that pause. Returns whether there are
    /// any; they need a job then.
    fn take(&self) -> bool {
        let mut state = self.state();
        state.taken += 1;
        if state.next == self.count {
            return false;
        }
        let mut called = false;
        for thread in state.threads.iter_mut().filter(|thread| **thread == Thread::Paused) {
            (*thread, called) = (Thread::Called, true);
        }
        called
    }

    /// Ends the computation of further values.
    fn end(&self) {
        self.state().ended = true;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};
    use std::time::{Duration, Instant};

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

    /// While one value takes long, the others do not wait for it at the end of a block.
    #[test]
    fn threads_pause_only_where_the_window_ends() {
        let resources = with_threads(2);
        let computed = AtomicUsize::new(0);
        // The last value of the first window waits until all others within its reach are there.
        let slow = 2 * AHEAD - 1;
        let compute = |index: usize| {
            let deadline = Instant::now() + Duration::from_secs(20);
            while index == slow && computed.load(Ordering::SeqCst) < slow + 2 * AHEAD - 1 {
                assert!(Instant::now() < deadline, "the other thread pauses");
                std::thread::yield_now();
            }
            computed.fetch_add(1, Ordering::SeqCst);
        };
        resources.in_order(50, compute, |_, ()| ControlFlow::Continue(()));
        assert_eq!(computed.load(Ordering::SeqCst), 50);
    }

    /// Every value that is taken lets a paused thread compute another one.
    #[test]
    fn paused_threads_resume() {
        for threads in [1, 2] {
            let computed = AtomicUsize::new(0);
            let compute = |_| computed.fetch_add(1, Ordering::SeqCst);
            with_threads(threads).in_order(50, compute, |taken, _| {
                let deadline = Instant::now() + Duration::from_secs(20);
                while computed.load(Ordering::SeqCst) < 50.min(taken + AHEAD * threads) {
                    assert!(Instant::now() < deadline, "no thread resumes after {taken} values");
                    std::thread::yield_now();
                }
                ControlFlow::Continue(())
            });
        }
    }

    #[test]
    fn values_computed_after_the_end_are_returned() {
        let resources = with_threads(3);
        let take = |index, _| if index == 1 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        let others = AtomicUsize::new(0);
        let last = |index: usize| {
            // The value of index 1 is computed after the others of the window.
            while index == 1 && others.load(Ordering::Relaxed) < 12 {
                std::thread::yield_now();
            }
            others.fetch_add(1, Ordering::Relaxed);
            10 * index
        };
        let left = resources.in_order(100, last, take);
        assert_eq!(left, (2..13).map(|index| (index, 10 * index)).collect::<Vec<_>>());
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
            assert!(started.load(Ordering::Relaxed) <= 5 + 2 * AHEAD);
        }
    }

    #[test]
    #[should_panic(expected = "at 3")]
    fn a_panic_reaches_the_caller() {
        let compute = |index| if index == 3 { panic!("at {index}") } else { index };
        with_threads(2).in_order(10, compute, |_, _| ControlFlow::Continue(()));
    }
}
