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
pub use vibration::{ModeShare, NaturalFrequency, Vibrations};
pub(crate) use vibration::{check_mode_count, check_vibrations};

use crate::plan::looks_at;
use crate::results::Observed;
use crate::scene::{BearingId, BodyId, PairId};
use crate::step::StepResult;
use crate::system::System;
use std::any::Any;
use std::fmt::Debug;

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

/// What of bodies an observable needs to be modelled: each of these has the ones before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Needs {
    /// Where bodies and surfaces are, and where they touch.
    Motions,
    /// With which forces bodies press on each other, which follow from how they deform.
    Forces,
    /// The largest stress in the fillet of a loaded tooth.
    RootStress,
    /// Stresses everywhere on the fillets.
    Stresses,
}

impl Needs {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Needs::Motions => "motions",
            Needs::Forces => "forces between elastic bodies",
            Needs::RootStress => "root stresses",
            Needs::Stresses => "stresses all over the fillets",
        }
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

impl System<'_> {
    /// The value of an observable at a solved position; none (not a number) if the plan left out something that it looks at.
    pub fn value(&self, step: &StepResult, observable: &dyn Observable) -> Observed {
        let left_out = |body: &BodyId| self.left_out.get(body.0) == Some(&true);
        if self.left_out.contains(&true) && looks_at(self.scene, observable).iter().any(left_out) {
            return Observed::number(f64::NAN);
        }
        observable.value(&Equilibrium { system: self, step })
    }
}
