//! Observables of rolling bearings: loads and pressures of the elements, static safety, and
//! reference rating life.

use super::{Equilibrium, Observable, Quantity};
use calyx_model::bearing::{NonlinearLoad, RollingElements};
use calyx_model::ids::BearingId;
use calyx_model::observed::Observed;
use calyx_rolling::rating::{Life, LifeConditions, rating_life, static_safety};
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
        elements.elements(&self.bearing(bearing)?.deflection).ok()
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
