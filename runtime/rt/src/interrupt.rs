//! Ctrl-C: the first one asks the run to end, which keeps what it has written; the second ends the process at once.

use calyx_abi::Cancel;
use std::sync::OnceLock;

/// Signals come to the process, so this is the process's.
static INTERRUPTED: OnceLock<Cancel> = OnceLock::new();

/// Set by an interrupt of this process from now on; the same switch however often this is called. For programs that are
/// their own masters: a library leaves signals alone.
pub fn flag() -> Cancel {
    let switch = INTERRUPTED.get_or_init(Cancel::default).clone();
    let handler: extern "C" fn(libc::c_int) = interrupted;
    // SAFETY: the handler does nothing but what a signal handler may: it stores to an atomic and resets itself.
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
