//! A stack large enough for every program that keeps to the depth limit, whatever thread asks.
//!
//! Programs may recurse [`crate::context::MAX_DEPTH`] deep. Threads of tests and thread pools have 2 MiB, which deep
//! recursion would overrun, and an overrun ends the process. So programs run on a thread of their own, and whatever is
//! called from there stays on it. Its memory is only reserved: pages cost something when they are first touched.

use crate::call::{Slot, SlotFn};
use crate::context::{Context, RuntimeError, codes};
use crate::helpers;
use std::cell::Cell;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread::{self, JoinHandle};

/// Stack of the thread that runs a program.
pub const STACK_BYTES: usize = 256 << 20;

thread_local! {
    /// Whether this thread was made here.
    static LARGE: Cell<bool> = const { Cell::new(false) };
}

/// Whether this thread has a large stack, so that [`with_stack`] stays on it.
pub fn is_large() -> bool {
    LARGE.with(Cell::get)
}

fn thread() -> thread::Builder {
    thread::Builder::new().name("calyx program".into()).stack_size(STACK_BYTES)
}

fn no_thread(error: &io::Error) -> RuntimeError {
    RuntimeError::new(
        codes::INTERNAL,
        format!("cannot start a thread for the program: {error}"),
        "raise the limit on threads or address space of this process",
    )
}

/// Runs a closure on a large stack, here if this is one, and waits for it.
///
/// # Errors
/// Internal errors if the thread cannot be made or the closure panics.
pub fn with_stack<R: Send>(body: impl FnOnce() -> R + Send) -> Result<R, RuntimeError> {
    if is_large() {
        // What the closure was changing is given up with the error, as where a thread of its own panics.
        return catch_unwind(AssertUnwindSafe(body)).map_err(|payload| panicked(payload.as_ref()));
    }
    thread::scope(|scope| {
        let body = || {
            LARGE.set(true);
            body()
        };
        let thread = thread().spawn_scoped(scope, body).map_err(|error| no_thread(&error))?;
        thread.join().map_err(|payload| panicked(payload.as_ref()))
    })
}

/// Runs a closure on a large stack of its own beside what goes on here.
///
/// # Errors
/// Internal errors if the thread cannot be made; when it is joined, if the closure panicked.
pub fn beside<R: Send + 'static>(
    body: impl FnOnce() -> R + Send + 'static,
) -> Result<Beside<R>, RuntimeError> {
    let body = || {
        LARGE.set(true);
        body()
    };
    thread().spawn(body).map(Beside).map_err(|error| no_thread(&error))
}

/// What [`beside`] runs.
pub struct Beside<R>(JoinHandle<R>);

impl<R> Beside<R> {
    /// Waits for its end.
    ///
    /// # Errors
    /// Internal, if it panicked.
    pub fn join(self) -> Result<R, RuntimeError> {
        self.0.join().map_err(|payload| panicked(payload.as_ref()))
    }
}

/// Runs a compiled function from outside (a program's top level, a param's default) on a large stack, and returns
/// the slots of its results. [`Context::place`] should tell where the function is.
///
/// # Errors
/// What the function fails with, and where.
///
/// # Safety
/// The function takes as many slots as `arguments` and returns `results`.
pub unsafe fn run(
    ctx: &mut Context,
    function: SlotFn,
    arguments: &[Slot],
    results: usize,
) -> Result<Vec<Slot>, RuntimeError> {
    let here = is_large();
    with_stack(|| {
        ctx.text.clear();
        let depth = ctx.depth;
        if !here {
            // Calls that led here, through a function of the engine, are on another stack.
            ctx.depth = 0;
        }
        let mut slots = vec![0; results];
        // SAFETY: promised by the caller; the context is borrowed for the whole call.
        let status = unsafe { function(ctx, arguments.as_ptr(), slots.as_mut_ptr()) };
        ctx.depth = depth;
        helpers::outcome(ctx, status).map(|()| slots)
    })?
}

/// The error that stands for a panic of the engine.
pub(crate) fn panicked(payload: &(dyn std::any::Any + Send)) -> RuntimeError {
    RuntimeError::new(
        codes::INTERNAL,
        format!("internal error: {}", panic_message(payload)),
        "please report it with the model",
    )
}

/// What a panic says.
pub(crate) fn panic_message(payload: &(dyn std::any::Any + Send)) -> &str {
    let text = payload.downcast_ref::<&str>().copied();
    text.or_else(|| payload.downcast_ref::<String>().map(String::as_str)).unwrap_or("unknown cause")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_become_errors() {
        let broken = || {
            if true {
                panic!("broken {}", 1)
            }
        };
        let errors = [
            with_stack(broken).unwrap_err(),
            with_stack(|| with_stack(broken)).unwrap().unwrap_err(),
            beside(broken).unwrap().join().unwrap_err(),
        ];
        for error in errors {
            let said = (error.code.as_str(), error.message.as_str());
            assert_eq!(said, (codes::INTERNAL, "internal error: broken 1"));
        }
    }

    #[test]
    fn a_large_stack_is_stayed_on() {
        let this = || thread::current().id();
        let (outer, inner) = with_stack(|| (this(), with_stack(this).unwrap())).unwrap();
        assert!(outer == inner && outer != this());
    }
}
