//! Ctrl-C, and the termination that batch systems send before they kill a job: the first signal
//! asks the run to end and keep its files; the second one ends the process.

use calyx_abi::Cancel;
use std::sync::OnceLock;

/// Static, because signals go to the process.
static INTERRUPTED: OnceLock<Cancel> = OnceLock::new();

/// The signals that ask a run to end.
const SIGNALS: [libc::c_int; 2] = [libc::SIGINT, libc::SIGTERM];

/// Installs the interrupt handler and returns the handle that it sets, the same at every call. Only
/// for programs: a library must not change signal handlers.
pub fn flag() -> Cancel {
    let switch = INTERRUPTED.get_or_init(Cancel::default).clone();
    let handler: extern "C" fn(libc::c_int) = interrupted;
    for signal in SIGNALS {
        // SAFETY: the handler is async-signal-safe: it stores to an atomic and resets itself.
        unsafe { libc::signal(signal, handler as *const () as libc::sighandler_t) };
    }
    switch
}

extern "C" fn interrupted(_signal: libc::c_int) {
    if let Some(switch) = INTERRUPTED.get() {
        switch.cancel();
    }
    for signal in SIGNALS {
        // SAFETY: `signal` may be called in a handler.
        unsafe { libc::signal(signal, libc::SIG_DFL) };
    }
}
