//! What the model says, before anything is built: bodies, the surfaces that may touch, and what is to be observed.

mod fidelity;
mod pairs;
mod prototype;

pub use fidelity::{BodyModel, Fidelity, StructureOptions, Template};
pub use pairs::{CharacteristicPoint, GearMesh, GridOptions, SurfacePair};
pub(crate) use prototype::no_model_in_space;
pub use prototype::{Ignored, Prototype};

use crate::bearing::Bearing;
use crate::error::EngineError;
use crate::inertia::Inertia;
use crate::load::{Blow, Load, Wrench};
use crate::motion::Motion;
use crate::observe::{ModesRequest, Observable};
use std::sync::Arc;

/// The six freedoms of a frame, in the order of their indices: names of [`Component`].
pub const FREEDOMS: [&str; 6] = ["u_x", "u_y", "u_z", "theta_x", "theta_y", "theta_z"];

/// A component of a frame's motion along and about the ground axes, in the order of [`FREEDOMS`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Component {
    /// Displacement along x.
    Ux,
    /// Displacement along y.
    Uy,
    /// Displacement along z, across a plane model.
    Uz,
    /// Turn about x.
    ThetaX,
    /// Turn about y.
    ThetaY,
    /// Turn about z, in the plane of a plane model.
    ThetaZ,
}

/// A body of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BodyId(pub usize);
/// A bearing of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct BearingId(pub usize);
/// A pair of surfaces of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct PairId(pub usize);
/// An observable of a scene, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ObservableId(pub usize);

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

/// Everything the model says. Frozen by the first analysis.
#[derive(Clone, Default)]
pub struct Scene {
    /// By [`BodyId`].
    pub bodies: Vec<Body>,
    /// By [`BearingId`].
    pub bearings: Vec<Bearing>,
    /// By [`PairId`].
    pub pairs: Vec<SurfacePair>,
    /// By [`ObservableId`].
    pub observables: Vec<Arc<dyn Observable>>,
    /// Whether a table of the modes at the first position is wanted.
    pub modes_table: Option<ModesRequest>,
}

impl Scene {
    /// Adds a body.
    pub fn add_body(&mut self, body: Body) -> BodyId {
        self.bodies.push(body);
        BodyId(self.bodies.len() - 1)
    }

    /// Adds a bearing.
    ///
    /// # Errors
    /// As [`Bearing::check`].
    pub fn add_bearing(&mut self, bearing: Bearing) -> Result<BearingId, EngineError> {
        bearing.check(self)?;
        self.bearings.push(bearing);
        Ok(BearingId(self.bearings.len() - 1))
    }

    /// Adds a pair of surfaces that may touch.
    pub fn add_pair(&mut self, pair: SurfacePair) -> PairId {
        self.pairs.push(pair);
        PairId(self.pairs.len() - 1)
    }

    /// Observing the same thing twice costs nothing.
    pub fn observe(&mut self, observable: impl Observable) -> ObservableId {
        let known = self.observables.iter().position(|known| known.as_ref().equals(observable.as_any()));
        let at = known.unwrap_or_else(|| {
            self.observables.push(Arc::new(observable));
            self.observables.len() - 1
        });
        ObservableId(at)
    }
}
