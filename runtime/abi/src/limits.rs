//! Limits of a running program: cancellation, number of basic blocks, time, memory, and depth of
//! calls.

use crate::context::{Context, MAX_DEPTH};
use crate::error::{RuntimeError, codes};
use std::time::{Duration, Instant};

/// Number of basic blocks between two checks of the limits.
const GRANT: u64 = 4096;

/// Limits of a run; `None` is unlimited.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limits {
    /// Deadline, and the time limit that it follows from.
    pub time: Option<(Instant, Duration)>,
    /// Memory limit of the program's strings, arrays, expressions and tables together, bytes.
    pub memory: Option<u64>,
}

impl Limits {
    /// Creates the limits of a run that starts now.
    pub fn from_now(time: Option<Duration>, memory: Option<u64>) -> Limits {
        let end = |given: Duration| Some((Instant::now().checked_add(given)?, given));
        Limits { time: time.and_then(end), memory }
    }

    /// Checks the time.
    ///
    /// # Errors
    /// E0707 after the deadline.
    pub fn check_time(&self) -> Result<(), RuntimeError> {
        match self.time {
            Some((end, given)) if Instant::now() >= end => Err(RuntimeError::new(
                codes::EXHAUSTED,
                format!("the run took longer than its time limit of {} s", given.as_secs_f64()),
                "give it more time, or look for a loop that does not end",
            )),
            _ => Ok(()),
        }
    }

    /// Checks an amount of memory.
    ///
    /// # Errors
    /// E0707 if it exceeds the limit.
    pub fn check_memory(&self, bytes: u64) -> Result<(), RuntimeError> {
        match self.memory {
            Some(limit) if bytes > limit => Err(RuntimeError::new(
                codes::EXHAUSTED,
                format!("the run needs more than its memory limit of {}", shown_bytes(limit)),
                "give it more memory, or look for a text or an array that grows without end, or a table that is too large",
            )),
            _ => Ok(()),
        }
    }
}

/// Formats a size like `2 GB`, `512 MB`, `100 bytes`, in the largest unit without a fraction.
fn shown_bytes(bytes: u64) -> String {
    let units = [(1_000_000_000, "GB"), (1_000_000, "MB"), (1000, "kB")];
    match units.into_iter().find(|(size, _)| bytes >= *size && bytes.is_multiple_of(*size)) {
        Some((size, unit)) => format!("{} {unit}", bytes / size),
        None => format!("{bytes} bytes"),
    }
}

/// Checks for cancellation and the time limit.
///
/// # Errors
/// E0704 or E0707.
pub fn check(ctx: &Context) -> Result<(), RuntimeError> {
    if ctx.cancel.is_cancelled() {
        return Err(RuntimeError::new(codes::CANCELLED, "the run was cancelled", ""));
    }
    ctx.limits.check_time()
}

/// Checks the memory of the program's values.
///
/// # Errors
/// E0707.
pub fn check_memory(ctx: &Context) -> Result<(), RuntimeError> {
    request_memory(ctx, 0)
}

/// Checks the memory of the program's values with an allocation of `more` bytes, before it is made.
///
/// # Errors
/// E0707.
pub fn request_memory(ctx: &Context, more: u64) -> Result<(), RuntimeError> {
    let taken = [ctx.heap.bytes(), ctx.kept_output, ctx.kept_tables, ctx.text.len() as u64, more];
    ctx.limits.check_memory(taken.into_iter().fold(0, u64::saturating_add))
}

/// Grants more basic blocks to the program.
///
/// # Errors
/// The program is cancelled or a limit is reached.
pub fn refuel(ctx: &mut Context) -> Result<(), RuntimeError> {
    check(ctx)?;
    if ctx.fuel == 0 {
        return Err(RuntimeError::new(
            codes::LIMIT,
            "the program ran for longer than it may here",
            "look for a loop that does not end",
        ));
    }
    let grant = ctx.fuel.min(GRANT);
    ctx.fuel -= grant;
    ctx.granted += grant;
    Ok(())
}

/// Counts the basic block about to be entered; `false` if [`refuel`] must be called first.
pub fn enter_block(ctx: &mut Context) -> bool {
    let granted = ctx.granted > 0;
    ctx.granted = ctx.granted.saturating_sub(1);
    granted
}

/// Counts basic blocks that an equal call entered before. The program must have so many left.
pub fn spend(ctx: &mut Context, blocks: u64) {
    let granted = ctx.granted.min(blocks);
    ctx.granted -= granted;
    ctx.fuel = ctx.fuel.saturating_sub(blocks - granted);
}

/// Returns the error of a call beyond [`MAX_DEPTH`].
pub fn too_deep() -> RuntimeError {
    RuntimeError::new(
        codes::DEPTH,
        format!("functions call each other more than {MAX_DEPTH} deep"),
        "give the recursion an end, or write it as a loop",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::call::Status;
    use crate::helpers;

    #[test]
    fn limits_and_cancellation_stop_a_program() {
        let mut ctx = Context::new(Box::new(()));
        ctx.fuel = 5000;
        let mut enter = || enter_block(&mut ctx) || (refuel(&mut ctx).is_ok() && enter_block(&mut ctx));
        let entered = (0..10_000).take_while(|_| enter()).count();
        assert_eq!(entered, 5000);
        assert_eq!(refuel(&mut ctx).unwrap_err().status(), Status::Cancelled);
        ctx.fuel = u64::MAX;
        ctx.cancel.cancel();
        assert_eq!(refuel(&mut ctx).unwrap_err().code, codes::CANCELLED);
    }

    #[test]
    fn time_and_memory_have_limits() {
        let mut ctx = Context::new(Box::new(()));
        ctx.limits = Limits::from_now(Some(Duration::ZERO), Some(1_000_000));
        let error = refuel(&mut ctx).unwrap_err();
        assert_eq!((error.code.as_str(), error.status()), (codes::EXHAUSTED, Status::Cancelled));
        let text = "0123456789".repeat(5000);
        let mut made = 0;
        let refused = loop {
            ctx.text.push_str(&text);
            match helpers::finish_text(&mut ctx) {
                Ok(_) => made += 1,
                Err(error) => break error,
            }
        };
        assert!((10..21).contains(&made));
        assert!(refused.message.ends_with("of 1 MB"));
    }

    #[test]
    fn sizes_are_shown_in_the_unit_they_are_given_in() {
        let shown = [2_000_000_000, 1_500_000, 1500, 1001].map(shown_bytes);
        assert_eq!(shown, ["2 GB", "1500 kB", "1500 bytes", "1001 bytes"]);
    }
}
