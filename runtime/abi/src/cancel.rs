//! Cancellation of running programs from any thread.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Cancellation flag. Once set it stays set, and every run that polls it ends soon. Clones share
/// the flag, also between several runs.
#[derive(Clone, Debug, Default)]
pub struct Cancel(Arc<Switch>);

#[derive(Debug, Default)]
struct Switch {
    set: AtomicBool,
    above: Option<Cancel>,
}

impl Cancel {
    pub fn cancel(&self) {
        self.0.set.store(true, Ordering::Relaxed);
    }

    pub fn is_cancelled(&self) -> bool {
        self.0.set.load(Ordering::Relaxed) || self.0.above.as_ref().is_some_and(Cancel::is_cancelled)
    }

    /// Creates a flag of its own that this one sets too.
    #[must_use]
    pub fn child(&self) -> Cancel {
        Cancel(Arc::new(Switch { set: AtomicBool::new(false), above: Some(self.clone()) }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_switch_sets_those_below_it_and_no_other() {
        let above = Cancel::default();
        let (one, other) = (above.child(), above.child());
        one.clone().cancel();
        assert!(one.is_cancelled() && !above.is_cancelled() && !other.is_cancelled());
        above.cancel();
        assert!(other.is_cancelled());
    }
}
