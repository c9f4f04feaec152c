//! Test of the interrupt handler.

use calyx_rt::interrupt::flag;

#[test]
fn an_interrupt_sets_the_flag() {
    let flag = flag();
    // SAFETY: a signal to this thread, whose handler is the one above.
    unsafe { libc::raise(libc::SIGTERM) };
    assert!(flag.is_cancelled());
}
