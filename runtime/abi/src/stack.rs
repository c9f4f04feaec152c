//! A stack large enough for every program that keeps to the depth limit, whatever thread asks.
//!
//! Programs may recurse [`crate::context::MAX_DEPTH`] deep. Threads of tests and thread pools have 2 MiB, which deep
//! recursion would overrun, and an overrun ends the process. So programs run on a thread of their own. Its memory is
//! only reserved: pages cost something when they are first touched.

use crate::call::{Slot, SlotFn};
use crate::context::{Context, RuntimeError, codes};
use crate::helpers;
use std::thread;

/// Stack of the thread that runs a program.
pub const STACK_BYTES: usize = 256 << 20;

/// Runs a closure on a large stack and waits for it.
///
/// # Errors
/// Internal errors if the thread cannot be made or the closure panics.
pub fn with_stack<R: Send>(body: impl FnOnce() -> R + Send) -> Result<R, RuntimeError> {
    thread::scope(|scope| {
        let thread = thread::Builder::new()
            .name("calyx program".into())
            .stack_size(STACK_BYTES)
            .spawn_scoped(scope, body)
            .map_err(|error| {
                RuntimeError::new(
                    codes::INTERNAL,
                    format!("cannot start a thread for the program: {error}"),
                    "raise the limit on threads or address space of this process",
                )
            })?;
        thread.join().map_err(|payload| panicked(payload.as_ref()))
    })
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
    with_stack(|| {
        ctx.text.clear();
        // Calls that led here, through a function of the engine, are on another stack.
        let depth = std::mem::take(&mut ctx.depth);
        let mut slots = vec![0; results];
        // SAFETY: promised by the caller; the context is borrowed for the whole call.
        let status = unsafe { function(ctx, arguments.as_ptr(), slots.as_mut_ptr()) };
        ctx.depth = depth;
        helpers::outcome(ctx, status).map(|()| slots)
    })?
}

/// The error that stands for a panic of the engine.
pub(crate) fn panicked(payload: &(dyn std::any::Any + Send)) -> RuntimeError {
    let message = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("unknown cause");
    RuntimeError::new(
        codes::INTERNAL,
        format!("internal error: {message}"),
        "please report it with the model",
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panics_become_errors() {
        let error = with_stack(|| {
            if true {
                panic!("broken {}", 1)
            }
        })
        .unwrap_err();
        assert_eq!(
            (error.code.as_str(), error.message.as_str()),
            (codes::INTERNAL, "internal error: broken 1")
        );
    }
}
