//! A switch that ends what runs, from any thread.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

/// Once set it stays set, and whatever looks at it ends soon. Clones are the same switch; one may stand behind as many
/// runs as are to end together.
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

    /// A switch of its own that this one sets as well.
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
