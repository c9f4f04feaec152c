//! Observables: quantities that are evaluated at a solved position, one small type each.
//!
//! An observable describes itself ([`Quantity`]) and evaluates a scene in [`Equilibrium`], which
//! provides patches, loads and motions in newtons and metres for every kind of model. Programs that
//! embed the engine can implement their own observables in the same way.
//!
//! See `docs/theory/observables.md`.

mod bearings;
mod bodies;
mod deformed;
mod equilibrium;
mod fields;
mod flank_cells;
mod gauge;
mod load_factors;
mod loads;
mod maximum_location;
mod mesh;
mod mesh_cycle;
mod misalignment;
mod mode_kind;
mod parts;
mod pressure;
mod rolling;
mod shafts;
mod sliding;
mod sound;
mod spline_teeth;
mod stress;
mod tribology;
mod vibration;
mod whirl;

pub use bearings::{
    BearingDeflection, BearingForce, BearingLoad, BearingMoment, BearingStiffness, BearingTilt, Direction,
};
pub use bodies::{
    Displacement, HighestContact, LowestContact, Rotation, SupportForce, SupportMoment, ToothLoad,
};
pub use calyx_contact::zone::Zone;
pub use calyx_model::fidelity::Needs;
pub use calyx_solve::vibrations::Vibrations;
pub use calyx_structure::DisplacedSector;
pub(crate) use deformed::MeshedBodies;
pub use deformed::{BodyField, ElasticBodyField, SectorField};
pub use equilibrium::{Contact, Equilibrium, Slice};
pub(crate) use fields::Displayed;
pub use fields::{ContactField, Fields, FilletField, FilletStress, LocalState, LubricatedState, PressedCell};
pub use flank_cells::FlankCorners;
pub use gauge::{Gauge, GaugeReading, Reading};
pub use load_factors::{DynamicFactor, FaceLoadFactor, RootFaceLoadFactor, TransverseLoadFactor};
pub use loads::{LoadShare, LoadedFace, MaxLineLoad, MeshForce, PairLoad, PairsInContact};
pub use maximum_location::{Coordinate, Maximum, MaximumLocation};
pub use mesh::{MeshStiffness, SecantStiffness, TransmissionError, UnloadedTransmissionError};
pub use mesh_cycle::positions_of_cycle;
pub use misalignment::{Misalignment, MisalignmentComponent};
pub use mode_kind::{
    ModeClassification, ModeEnergyShares, ModeKind, ModeRow, ModesRequest, ModesTable, PlanetSet,
};
pub use parts::{ForceOf, Part, PartForce, PartKind, PartMotion, PartOf, parts, prescribed_poses};
pub use pressure::{MaxContactPressure, MaxEdgePressure};
pub use rolling::{
    BearingFriction, BearingLife, BearingPressure, LoadedElements, MaxElementLoad, RollingBearingField,
    RollingElementLoad, StaticSafety,
};
pub use shafts::{
    ConnectionLoad, NominalStress, SectionComponent, ShaftDisplacement, ShaftMoment, ShaftPosition,
    ShaftReaction, ShaftRotation, ShaftStress,
};
pub use sliding::{Efficiency, FrictionLoss, MaxSlidingVelocity, SlidingVelocity};
pub use sound::{
    RadiationEfficiency, SoundFieldLevel, SoundLines, SoundPower, SoundPowerLevel, SoundPressureLevel,
};
pub use spline_teeth::SplineToothLoad;
pub use stress::{FilletSide, MaxRootCompression, MaxRootStress};
pub use tribology::{
    EntrainmentVelocity, LocalQuantity, LubricatedEfficiency, LubricatedExtreme, LubricatedLoss,
};
pub use vibration::{ModeShare, NaturalFrequency};
pub use whirl::{CampbellDiagram, CampbellPoint, CampbellRequest, WhirlFrequency, WhirlSense};

use calyx_model::fidelity::Fidelity;
use calyx_model::ids::{BearingId, BodyId, PairId};
use calyx_model::observed::Observed;
use calyx_model::plan::depends_on;
use calyx_model::target::Target;
use calyx_solve::step::StepResult;
use calyx_solve::system::System;
use std::any::Any;
use std::fmt::Debug;
use std::sync::Arc;

/// Description of an observable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// Name in the gear library.
    pub name: &'static str,
    /// SI unit of the value; `1` for dimensionless quantities.
    pub unit: &'static str,
    /// Behaviour from one mesh cycle to the next.
    pub course: Periodicity,
}

/// Behaviour of an observable from one mesh cycle to the next; it determines the statistics over a
/// cycle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Periodicity {
    /// Repeats in every cycle if all teeth of a gear are equal: has a mean over the closed cycle,
    /// and harmonics.
    Repeats,
    /// Follows one tooth or tooth pair, which has moved on at the end of the cycle.
    Passes,
}

impl Quantity {
    /// Creates the description of a quantity that repeats in every mesh cycle.
    pub const fn repeating(name: &'static str, unit: &'static str) -> Quantity {
        Quantity { name, unit, course: Periodicity::Repeats }
    }

    /// Creates the description of a quantity of one tooth or tooth pair.
    pub const fn passing(name: &'static str, unit: &'static str) -> Quantity {
        Quantity { name, unit, course: Periodicity::Passes }
    }
}

/// Quantity of a solved position.
///
/// Equal observables are evaluated once.
pub trait Observable: Comparable + Debug + Send + Sync {
    /// Describes the observable.
    fn quantity(&self) -> Quantity;

    /// Evaluates the observable at a solved position.
    fn value(&self, at: &Equilibrium<'_>) -> Observed;

    /// Returns its model requirements; without them it has no value.
    fn needs(&self) -> Needs {
        if self.stresses_of().is_some() { Needs::Stresses } else { Needs::Forces }
    }

    /// Returns the smallest and the largest possible value, SI.
    fn bounds(&self) -> [f64; 2] {
        [f64::NEG_INFINITY, f64::INFINITY]
    }

    /// Returns the body whose stresses it needs; the plan provides stress recovery for it.
    fn stresses_of(&self) -> Option<BodyId> {
        None
    }

    /// Returns whether it is a pressure on flanks away from edges, whose error decreases faster
    /// with the cell size than that of other values.
    fn is_flank_pressure(&self) -> bool {
        false
    }

    /// Returns the body whose frame it depends on, with or without contact.
    fn frame_of(&self) -> Option<BodyId> {
        None
    }

    /// Returns whether the value is one of the forced response, which has no derivatives.
    fn is_of_forced_response(&self) -> bool {
        false
    }

    /// Returns the index of its mode, from 0: vibrations need inertia and a sufficient number of
    /// modes.
    fn mode(&self) -> Option<usize> {
        None
    }

    /// Returns the harmonic of the mesh frequencies whose sound it is.
    fn harmonic(&self) -> Option<usize> {
        None
    }

    /// Returns the bearing that it depends on.
    fn bearing_of(&self) -> Option<BearingId> {
        None
    }

    /// Returns the mesh over whose cycle it is defined: it solves positions of its own there, see
    /// [`positions_of_cycle`].
    fn cycle_of(&self) -> Option<PairId> {
        None
    }

    /// Returns the mesh that it depends on. An observable without mesh, bearing and body depends on
    /// the whole scene.
    fn pair_of(&self) -> Option<PairId> {
        None
    }

    /// Returns whether it is evaluated outside the middle of the face, which a plane model ignores.
    fn off_middle(&self) -> bool {
        false
    }

    /// Returns the parts of the mechanism that it depends on, for the plan.
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

/// Equality of values of unknown type; implemented for all types with equality and a static
/// lifetime.
pub trait Comparable: Any {
    /// Returns whether the other value has the same type and is equal.
    fn equals(&self, other: &dyn Any) -> bool;

    /// Returns the value for a comparison.
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

/// Evaluation of observables at the positions that a system has solved.
pub trait Observe {
    /// Evaluates an observable at a solved position; NaN if the plan leaves out a part that it
    /// depends on.
    fn value(&self, step: &StepResult, observable: &dyn Observable) -> Observed;

    /// Evaluates observables at a solved position; NaN for those that require more than the
    /// fidelity provides.
    fn values(
        &self,
        step: &StepResult,
        fidelity: Fidelity,
        observables: &[Arc<dyn Observable>],
    ) -> Vec<Observed> {
        self.values_of(step, fidelity, observables, &vec![true; observables.len()])
    }

    /// Evaluates the `wanted` observables at a solved position, as [`Observe::values`] does; NaN
    /// for the others.
    fn values_of(
        &self,
        step: &StepResult,
        fidelity: Fidelity,
        observables: &[Arc<dyn Observable>],
        wanted: &[bool],
    ) -> Vec<Observed> {
        let value = |(observable, wanted): (&Arc<dyn Observable>, &bool)| match *wanted
            && observable.needs() <= fidelity.supports()
        {
            true => self.value(step, observable.as_ref()),
            false => Observed::number(f64::NAN),
        };
        observables.iter().zip(wanted).map(value).collect()
    }

    /// Returns the contact forces on a body's frame, see [`Equilibrium::contact_force`].
    fn contact_force(&self, step: &StepResult, body: BodyId) -> [f64; 6];
}

impl Observe for System<'_> {
    fn value(&self, step: &StepResult, observable: &dyn Observable) -> Observed {
        let left_out = |body: &BodyId| self.left_out.get(body.0) == Some(&true);
        if self.left_out.contains(&true) && depends_on(self.scene, &observable.target()).iter().any(left_out)
        {
            return Observed::number(f64::NAN);
        }
        observable.value(&Equilibrium { system: self, step })
    }

    fn contact_force(&self, step: &StepResult, body: BodyId) -> [f64; 6] {
        Equilibrium { system: self, step }.contact_force(body)
    }
}
