//! Body: its prototype, prescribed motion, free components, loads and masses.

use crate::dof::Component;
use crate::load::{Impulse, Load, Wrench};
use crate::motion::Motion;
use crate::prototype::Prototype;
use calyx_fe::inertia::Inertia;
use std::sync::Arc;

/// A deformable body on a moving frame.
#[derive(Clone)]
pub struct Body {
    /// Name in results and messages.
    pub name: String,
    /// Model of the body. Bodies with the same prototype share a structure.
    pub prototype: Arc<dyn Prototype>,
    /// Prescribed motion of the frame; the origin of the deviations of free components.
    pub motion: Arc<dyn Motion>,
    /// Rotation of the structure in its frame, rad: the phase in which a gear is mounted.
    pub phase: f64,
    /// Free degrees of freedom of the frame, in the order of [`crate::dof::DOF_NAMES`].
    pub free: [bool; 6],
    /// External load on the frame.
    pub load: Arc<dyn Load>,
    /// Additional impulses on the frame. Load ramps do not scale them.
    pub impulses: Vec<Impulse>,
    /// Masses on the frame in addition to the body's own.
    pub added: Inertia,
}

impl Body {
    /// Creates a fixed, unloaded body.
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
            impulses: Vec::new(),
            added: Inertia::default(),
        }
    }

    /// Makes these components of the frame free: contact, bearing and external forces are in
    /// equilibrium along them.
    pub fn free_in(mut self, components: &[Component]) -> Body {
        for component in components {
            self.free[*component as usize] = true;
        }
        self
    }

    /// Adds masses to the frame.
    pub fn with_added(mut self, inertia: Inertia) -> Body {
        self.added = self.added + inertia;
        self
    }

    /// Returns the total inertia of the body.
    pub fn inertia(&self) -> Inertia {
        self.prototype.inertia() + self.added
    }

    /// Returns the external load on the frame at a time (s), with the load scaled by `part`.
    /// Impulses are not scaled.
    pub fn acted_on(&self, time: f64, part: f64) -> Wrench {
        let load = self.load.at(time);
        let load = if part == 1.0 { load } else { part * load };
        self.impulses.iter().fold(load, |sum, impulse| sum + impulse.at(time))
    }

    /// Applies a load: a [`Wrench`] or a closure of time, see [`Load`].
    pub fn loaded(mut self, load: impl Load + 'static) -> Body {
        self.load = Arc::new(load);
        self
    }
}
