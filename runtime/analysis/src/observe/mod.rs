//! What can be read off a solved position: one small item an observable.
//!
//! An observable says what it is ([`Quantity`]) and finds its value in a scene in [`Equilibrium`], which shows patches, loads
//! and motions in newtons and metres whatever the model is made of. Who embeds the engine writes observables of their own in the
//! same way.

mod bearings;
mod bodies;
mod deformed;
mod equilibrium;
mod fields;
mod gauge;
mod loads;
mod lugs;
mod mesh;
mod mode_kind;
mod places;
mod pressure;
mod sliding;
mod stress;
mod vibration;

pub use bearings::{BearingDeflection, BearingForce, BearingMoment, BearingTilt, Borne, Direction};
pub use bodies::{
    Displacement, HighestContact, LowestContact, Rotation, SupportForce, SupportMoment, ToothLoad,
};
pub use calyx_model::fidelity::Needs;
pub use calyx_solve::vibrations::Vibrations;
pub(crate) use deformed::MeshedBodies;
pub use deformed::{BodyField, SectorField};
pub use equilibrium::{Contact, Equilibrium, Slice};
pub use fields::{ContactField, Fields, FilletField, FilletStress, PressedCell};
pub use gauge::{Gauge, GaugeReading, Reading};
pub use loads::{FaceLoadFactor, LoadShare, LoadedFace, MaxLineLoad, MeshForce, PairLoad, PairsInContact};
pub use lugs::LugLoad;
pub use mesh::{MeshStiffness, SecantStiffness, TransmissionError, UnloadedTransmissionError};
pub use mode_kind::{KindOfMode, KindShares, ModeKind, ModeRow, ModesRequest, ModesTable, PlanetSet};
pub use places::{Coordinate, Maximum, PlaceOf};
pub use pressure::{MaxContactPressure, MaxEdgePressure};
pub use sliding::{Efficiency, FrictionLoss, MaxSlidingVelocity, SlidingVelocity};
pub use stress::{FilletSide, MaxRootCompression, MaxRootStress};
pub use vibration::{ModeShare, NaturalFrequency};

use calyx_model::fidelity::Fidelity;
use calyx_model::ids::{BearingId, BodyId, PairId};
use calyx_model::observed::Observed;
use calyx_model::plan::looks_at;
use calyx_model::target::Target;
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

/// What an observable measures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// As the library of gears calls it.
    pub name: &'static str,
    /// Of its value, in SI; `1` for pure numbers.
    pub unit: &'static str,
    /// How it goes on from one mesh cycle to the next.
    pub course: Course,
}

/// How an observable goes on from one mesh cycle to the next, which says how it is summed up over one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Where the teeth of a gear are alike, every cycle has the same values: it has a mean over the closed cycle, and harmonics.
    Repeats,
    /// It follows one tooth or pair of teeth, which have gone on when the cycle ends.
    Passes,
}

impl Quantity {
    /// A quantity that every mesh cycle repeats.
    pub const fn repeating(name: &'static str, unit: &'static str) -> Quantity {
        Quantity { name, unit, course: Course::Repeats }
    }

    /// A quantity of one tooth or pair of teeth.
    pub const fn passing(name: &'static str, unit: &'static str) -> Quantity {
        Quantity { name, unit, course: Course::Passes }
    }
}

/// A quantity of a solved position.
///
/// Two that are equal are observed once.
pub trait Observable: Comparable + Debug + Send + Sync {
    /// What it measures.
    fn quantity(&self) -> Quantity;

    /// Its value at a solved position.
    fn value(&self, at: &Equilibrium<'_>) -> Observed;

    /// What it needs of bodies: of less it has no value.
    fn needs(&self) -> Needs {
        if self.stresses_of().is_some() { Needs::Stresses } else { Needs::Forces }
    }

    /// The body whose stresses it needs: recovering them is planned for.
    fn stresses_of(&self) -> Option<BodyId> {
        None
    }

    /// The body whose frame it looks at, whether or not the body touches anything.
    fn frame_of(&self) -> Option<BodyId> {
        None
    }

    /// The mode that it tells of, from 0: vibrations need inertia, and have so many modes.
    fn mode(&self) -> Option<usize> {
        None
    }

    /// The bearing it looks at.
    fn bearing_of(&self) -> Option<BearingId> {
        None
    }

    /// The mesh it looks at. An observable that names neither mesh nor bearing nor body is taken to look at the whole scene.
    fn pair_of(&self) -> Option<PairId> {
        None
    }

    /// Whether it reads beside the middle of the face, which a plane model does not see.
    fn off_middle(&self) -> bool {
        false
    }

    /// All that it looks at, as a plan takes it.
    fn target(&self) -> Target {
        Target {
            needs: self.needs(),
            stresses_of: self.stresses_of(),
            frame_of: self.frame_of(),
            bearing_of: self.bearing_of(),
            pair_of: self.pair_of(),
            mode: self.mode(),
            off_middle: self.off_middle(),
        }
    }
}

/// Equality of things whose type is not known; everything that can be compared and copied about has it.
pub trait Comparable: Any {
    /// Whether the other one is of the same type and equal.
    fn equals(&self, other: &dyn Any) -> bool;

    /// Itself, to be compared with.
    fn as_any(&self) -> &dyn Any;
}

impl<T: Any + PartialEq> Comparable for T {
    fn equals(&self, other: &dyn Any) -> bool {
        other.downcast_ref::<T>() == Some(self)
    }

    fn as_any(&self) -> &dyn Any {
        self
    }
}

/// Reads observables off the positions that a system has solved.
pub trait Observe {
    /// The value of an observable at a solved position; none (not a number) if the plan left out something that it looks at.
    fn value(&self, step: &StepResult, observable: &dyn Observable) -> Observed;

    /// The values of observables at a solved position; none (not a number) of those that need what the fidelity does not have.
    fn values(
        &self,
        step: &StepResult,
        fidelity: Fidelity,
        observables: &[Arc<dyn Observable>],
    ) -> Vec<Observed> {
        let value = |observable: &Arc<dyn Observable>| match observable.needs() > fidelity.gives() {
            true => Observed::number(f64::NAN),
            false => self.value(step, observable.as_ref()),
        };
        observables.iter().map(value).collect()
    }

    /// What contact does to a body's frame, see [`Equilibrium::contact_force`].
    fn contact_force(&self, step: &StepResult, body: BodyId) -> [f64; 6];
}

impl Observe for System<'_> {
    fn value(&self, step: &StepResult, observable: &dyn Observable) -> Observed {
        let left_out = |body: &BodyId| self.left_out.get(body.0) == Some(&true);
        if self.left_out.contains(&true) && looks_at(self.scene, &observable.target()).iter().any(left_out) {
            return Observed::number(f64::NAN);
        }
        observable.value(&Equilibrium { system: self, step })
    }

    fn contact_force(&self, step: &StepResult, body: BodyId) -> [f64; 6] {
        Equilibrium { system: self, step }.contact_force(body)
    }
}
