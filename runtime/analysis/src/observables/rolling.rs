//! Observables of rolling bearings: loads and pressures of the elements, static safety, reference
//! rating life, and friction.

use super::{Direction, Equilibrium, Observable, Quantity};
use calyx_model::bearing::{Bearing, NonlinearLoad, RollingElements, Support};
use calyx_model::ids::BearingId;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::angular_velocity;
use calyx_model::observed::Observed;
use calyx_numerics::vec3::{length, minus};
use calyx_rolling::rating::{
    Friction, FrictionCoefficients, Life, LifeConditions, friction, friction_load, rating_life, static_safety,
};
use calyx_rolling::{ElementState, RollingError};

/// Rolling elements of a bearing.
#[derive(Clone, Debug, PartialEq)]
pub struct RollingBearingField {
    /// Name of the bearing.
    pub bearing: String,
    /// States of the elements, row by row.
    pub elements: Vec<ElementState>,
}

impl Equilibrium<'_> {
    /// Returns the elements of all rolling bearings that take part.
    pub(super) fn rolling_bearings(self) -> Vec<RollingBearingField> {
        let field = |&index: &usize| {
            let bearing = &self.system.scene.bearings[index];
            let elements = self.rolling_elements(BearingId(index))?;
            Some(RollingBearingField { bearing: bearing.name.clone(), elements })
        };
        self.system.bearings.iter().filter_map(field).collect()
    }

    /// Returns the states of the elements of a rolling bearing, row by row; `None` if the scene has
    /// no such rolling bearing, or its races have separated.
    pub fn rolling_elements(self, bearing: BearingId) -> Option<Vec<ElementState>> {
        let load = self.nonlinear_load(bearing)?;
        let NonlinearLoad::Rolling(elements) = load else { return None };
        let deflection = self.bearing(bearing)?.deflection;
        elements.elements(&deflection, self.step.bearing_state(bearing.0, &deflection)).ok()
    }
}

/// Evaluates the states of the elements; NaN without them.
fn observed(
    at: &Equilibrium<'_>,
    bearing: BearingId,
    of: impl Fn(&[ElementState]) -> Option<f64>,
) -> Observed {
    Observed::number(at.rolling_elements(bearing).and_then(|elements| of(&elements)).unwrap_or(f64::NAN))
}

/// Largest contact pressure of the rolling elements, Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingPressure(pub BearingId);

impl Observable for BearingPressure {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_bearing_pressure", "Pa")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |elements| Some(elements.iter().map(ElementState::pressure).fold(0.0, f64::max)))
    }
}

/// Load of the most loaded rolling element, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MaxElementLoad(pub BearingId);

impl Observable for MaxElementLoad {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("max_rolling_element_load", "N")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |elements| Some(elements.iter().map(ElementState::load).fold(0.0, f64::max)))
    }
}

/// Load of a rolling element by its index, row by row, N.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingElementLoad(pub BearingId, pub usize);

impl Observable for RollingElementLoad {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("rolling_element_load", "N")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |elements| elements.get(self.1).map(ElementState::load))
    }
}

/// Number of rolling elements that carry load between both rings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoadedElements(pub BearingId);

impl Observable for LoadedElements {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("loaded_rolling_elements", "")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |elements| {
            Some(elements.iter().filter(|element| element.is_loaded()).count() as f64)
        })
    }
}

/// Static safety factor of ISO 76 from the largest contact pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StaticSafety(pub BearingId);

impl Observable for StaticSafety {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("bearing_static_safety", "")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.0)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        observed(at, self.0, |elements| Some(static_safety(elements)))
    }
}

/// Reference rating life of ISO/TS 16281 under the load of a position, revolutions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingLife {
    /// Bearing.
    pub bearing: BearingId,
    /// Conditions of the rating life.
    pub conditions: LifeConditions,
    /// True for the life that accounts for lubrication, contamination and reliability.
    pub modified: bool,
}

impl BearingLife {
    /// Checks the conditions.
    ///
    /// # Errors
    /// [`RollingError::Input`] if a condition is out of its range.
    pub fn check(&self, elements: &RollingElements) -> Result<(), RollingError> {
        // Any load checks all conditions.
        let reach = elements.bearing.reach();
        let states = elements.bearing.elements(&[reach, 0.0, reach, 0.0, 0.0], &elements.motion)?;
        self.of(elements, &states).map(|_| ())
    }

    fn of(&self, elements: &RollingElements, states: &[ElementState]) -> Result<Life, RollingError> {
        rating_life(&elements.bearing, states, &self.conditions)
    }
}

impl Observable for BearingLife {
    fn quantity(&self) -> Quantity {
        Quantity::repeating(if self.modified { "modified_bearing_life" } else { "bearing_life" }, "")
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.bearing)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let bearing = at.system.scene.bearings.get(self.bearing.0);
        let elements = bearing.and_then(|bearing| bearing.rolling().map(AsRef::as_ref));
        observed(at, self.bearing, |states| {
            let life = self.of(elements?, states).ok()?;
            Some(if self.modified { life.modified } else { life.basic })
        })
    }
}

/// Friction of a rolling bearing by Palmgren's model: its torque, N m, or its power loss, W.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingFriction {
    /// Bearing.
    pub bearing: BearingId,
    /// Kinematic viscosity of the lubricant at its operating temperature, m²/s.
    pub viscosity: f64,
    /// Coefficients of the torque.
    pub coefficients: FrictionCoefficients,
    /// True for the power loss.
    pub is_loss: bool,
}

impl BearingFriction {
    /// Returns the torque from the radial and the axial force, N, and the relative speed of the
    /// rings, rad/s.
    ///
    /// # Errors
    /// [`RollingError::Input`] if the viscosity is not positive, or a value is not finite.
    pub fn of(
        &self,
        elements: &RollingElements,
        forces: [f64; 2],
        speed: f64,
    ) -> Result<Friction, RollingError> {
        let diameter = elements.bearing.rows().first().map_or(f64::NAN, |row| row.pitch_diameter());
        let load = friction_load(&elements.bearing, forces);
        friction(&self.coefficients, diameter, load, speed, self.viscosity)
    }
}

/// Returns the speed of the body of the first race relative to that of the second at a time (s),
/// rad/s.
fn relative_speed(scene: &Mechanism, bearing: &Bearing, time: f64) -> f64 {
    let of = |body: usize| angular_velocity(scene.bodies[body].motion.as_ref(), time);
    let own = of(bearing.body.0);
    match bearing.to {
        Support::Ground => length(own),
        Support::Body(other) => length(minus(own, of(other.0))),
    }
}

impl Observable for BearingFriction {
    fn quantity(&self) -> Quantity {
        match self.is_loss {
            true => Quantity::repeating("bearing_friction_loss", "W"),
            false => Quantity::repeating("bearing_friction_torque", "N*m"),
        }
    }

    fn bearing_of(&self) -> Option<BearingId> {
        Some(self.bearing)
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let of = |direction: Direction| super::BearingForce(self.bearing, direction).value(at).value;
        let forces = [of(Direction::Radial), of(Direction::Axial)];
        let scene = at.system.scene;
        let torque = scene.bearings.get(self.bearing.0).and_then(|bearing| {
            let speed = relative_speed(scene, bearing, at.step.time);
            let friction = self.of(bearing.rolling()?, forces, speed).ok()?;
            Some(friction.torque() * if self.is_loss { speed } else { 1.0 })
        });
        Observed::number(torque.unwrap_or(f64::NAN))
    }
}
