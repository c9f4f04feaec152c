//! Ctrl-C: the first one asks the run to end, which keeps what it has written; the second ends the process at once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

static INTERRUPTED: OnceLock<Arc<AtomicBool>> = OnceLock::new();

/// Set by an interrupt of this process from now on; the same flag however often this is called.
pub fn flag() -> Arc<AtomicBool> {
    let flag = INTERRUPTED.get_or_init(Arc::default).clone();
    let handler: extern "C" fn(libc::c_int) = interrupted;
    // SAFETY: the handler does nothing but what a signal handler may: it stores to an atomic and resets itself.
    unsafe { libc::signal(libc::SIGINT, handler as *const () as libc::sighandler_t) };
    flag
}

extern "C" fn interrupted(_signal: libc::c_int) {
    if let Some(flag) = INTERRUPTED.get() {
        flag.store(true, Ordering::Relaxed);
    }
    // SAFETY: `signal` may be called in a handler.
    unsafe { libc::signal(libc::SIGINT, libc::SIG_DFL) };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_interrupt_sets_the_flag() {
        let flag = flag();
        // SAFETY: a signal to this thread, whose handler is the one above.
        unsafe { libc::raise(libc::SIGINT) };
        assert!(flag.load(Ordering::Relaxed));
    }
}
