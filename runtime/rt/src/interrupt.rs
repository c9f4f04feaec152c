//! Ctrl-C: the first interrupt asks the run to end and keep its files; the second one ends the
//! process.

use calyx_abi::Cancel;
use std::sync::OnceLock;

/// Static, because signals go to the process.
static INTERRUPTED: OnceLock<Cancel> = OnceLock::new();

/// Installs the interrupt handler and returns the handle that it sets, the same at every call. Only
/// for programs: a library must not change signal handlers.
pub fn flag() -> Cancel {
    let switch = INTERRUPTED.get_or_init(Cancel::default).clone();
    let handler: extern "C" fn(libc::c_int) = interrupted;
    // SAFETY: the handler is async-signal-safe: it stores to an atomic and resets itself.
    unsafe { libc::signal(libc::SIGINT, handler as *const () as libc::sighandler_t) };
    switch
}

extern "C" fn interrupted(_signal: libc::c_int) {
    if let Some(switch) = INTERRUPTED.get() {
        switch.cancel();
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
        assert!(flag.is_cancelled());
    }
}
