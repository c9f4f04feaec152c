//! A body: what it is made of, its prescribed motion, its free components, its loads and masses.

use crate::freedom::Component;
use crate::load::{Blow, Load, Wrench};
use crate::motion::Motion;
use crate::prototype::Prototype;
use calyx_fe::inertia::Inertia;
use std::sync::Arc;

/// A deformable body on a moving frame.
#[derive(Clone)]
pub struct Body {
    /// What results and messages call it.
    pub name: String,
    /// How it is modelled. Bodies that share one share its structure.
    pub prototype: Arc<dyn Prototype>,
    /// Where its frame is meant to be; deviations of free components are measured from there.
    pub motion: Arc<dyn Motion>,
    /// Turns the structure in its frame, rad: the phase at which a gear was mounted.
    pub phase: f64,
    /// Freedoms of the frame that are not held, in the order of [`FREEDOMS`].
    pub free: [bool; 6],
    /// What acts on the frame from outside.
    pub load: Arc<dyn Load>,
    /// What hits the frame besides; ramps of the load leave it as it is.
    pub blows: Vec<Blow>,
    /// Masses on the frame beside the body's own.
    pub added: Inertia,
}

impl Body {
    /// A body that is held on its frame and not loaded.
    pub fn new(
        name: impl Into<String>,
        prototype: Arc<dyn Prototype>,
        motion: impl Motion + 'static,
    ) -> Body {
        Body {
            name: name.into(),
            prototype,
            motion: Arc::new(motion),
            phase: 0.0,
            free: [false; 6],
            load: Arc::new(Wrench::NONE),
            blows: Vec::new(),
            added: Inertia::default(),
        }
    }

    /// The body with these components of its frame free: there contact and load are in equilibrium.
    pub fn free_in(mut self, components: &[Component]) -> Body {
        for component in components {
            self.free[*component as usize] = true;
        }
        self
    }

    /// The body with masses on its frame beside its own.
    pub fn with_added(mut self, inertia: Inertia) -> Body {
        self.added = self.added + inertia;
        self
    }

    /// All that it weighs.
    pub fn inertia(&self) -> Inertia {
        self.prototype.inertia() + self.added
    }

    /// What acts on the frame from outside at a time (s), if so large a part of the load is on it.
    pub fn acted_on(&self, time: f64, part: f64) -> Wrench {
        let load = self.load.at(time);
        let load = if part == 1.0 { load } else { part * load };
        self.blows.iter().fold(load, |sum, blow| sum + blow.at(time))
    }

    /// The body under a load: a [`Wrench`] or a closure of time, see [`Load`].
    pub fn loaded(mut self, load: impl Load + 'static) -> Body {
        self.load = Arc::new(load);
        self
    }
}
