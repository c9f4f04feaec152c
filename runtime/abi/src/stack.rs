//! Stack that is large enough for every program within the depth limit, on any thread.
//!
//! Programs may recurse to a depth of [`crate::context::MAX_DEPTH`]. Threads of tests and thread
//! pools have stacks of 2 MiB, which deep recursion would overflow, and an overflow ends the
//! process. Therefore programs run on a thread of their own, together with everything called from
//! there. Its memory is only reserved; pages are committed on first use.

use crate::call::{Slot, SlotFn};
use crate::context::{Context, RuntimeError, codes};
use crate::helpers;
use std::cell::Cell;
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::thread::{self, JoinHandle};

/// Stack size of the thread that runs a program, bytes.
pub const STACK_BYTES: usize = 256 << 20;

thread_local! {
    /// True on threads created here.
    static LARGE: Cell<bool> = const { Cell::new(false) };
}

/// Returns whether this thread has a large stack, so that [`with_stack`] runs on it.
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

/// Runs a closure on a large stack, on this thread if it has one, and waits for it.
///
/// # Errors
/// Internal errors if the thread cannot be created or the closure panics.
pub fn with_stack<R: Send>(body: impl FnOnce() -> R + Send) -> Result<R, RuntimeError> {
    if is_large() {
        // State that the closure was modifying is discarded with the error, as after a panic of a
        // separate thread.
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

/// Runs a closure on a large stack of its own, concurrently.
///
/// # Errors
/// Internal errors if the thread cannot be created; when it is joined, if the closure panicked.
pub fn beside<R: Send + 'static>(
    body: impl FnOnce() -> R + Send + 'static,
) -> Result<LargeStackThread<R>, RuntimeError> {
    let body = || {
        LARGE.set(true);
        body()
    };
    thread().spawn(body).map(LargeStackThread).map_err(|error| no_thread(&error))
}

/// Running closure of [`beside`].
pub struct LargeStackThread<R>(JoinHandle<R>);

impl<R> LargeStackThread<R> {
    /// Waits for its end.
    ///
    /// # Errors
    /// Internal if it panicked.
    pub fn join(self) -> Result<R, RuntimeError> {
        self.0.join().map_err(|payload| panicked(payload.as_ref()))
    }
}

/// Runs a compiled function from outside (a program's top level, a param's default) on a large
/// stack, and returns the slots of its results. [`Context::place`] should be the location of the
/// function.
///
/// # Errors
/// Those of the function, with their location.
///
/// # Safety
/// The function must take as many slots as `arguments` and return `results`.
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
        // SAFETY: guaranteed by the caller; the context is borrowed for the whole call.
        let status = unsafe { function(ctx, arguments.as_ptr(), slots.as_mut_ptr()) };
        ctx.depth = depth;
        helpers::outcome(ctx, status).map(|()| slots)
    })?
}

/// Returns the error for a panic of the engine.
pub(crate) fn panicked(payload: &(dyn std::any::Any + Send)) -> RuntimeError {
    RuntimeError::new(
        codes::INTERNAL,
        format!("internal error: {}", panic_message(payload)),
        "please report it with the model",
    )
}

/// Returns the message of a panic.
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
