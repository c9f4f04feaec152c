//! Rolling bearings as constant stiffnesses: their tangent at a load, and the range of loads over
//! which it is accurate.

use super::nonlinear::{NonlinearLoad, Tangent};
use super::nonlinear_state::NonlinearState;
use super::rolling::{RollingElements, rejected};
use calyx_numerics::error::EngineError;
use calyx_rolling::Conditions;
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// Deviation of the stiffness at the ends of the range of loads, relative to the stiffness at the
/// operating point.
pub const RANGE_TOLERANCE: f64 = 0.1;
/// Largest ratio of a load of the range to that at the operating point, and of that load to the
/// smallest one.
const WIDEST: f64 = 1048576.0;
/// Number of bisections of the ends of the range.
const BISECTIONS: usize = 30;

/// Operating point about which a bearing is linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// External force on the first race, along the axes of the bearing, N.
    pub force: [f64; 3],
    /// Smallest and largest force in this direction, N, between which the stiffness along it
    /// deviates by at most [`RANGE_TOLERANCE`] from that at the operating point.
    pub range: [f64; 2],
}

impl Linearization {
    /// Returns whether the stiffness is accurate under a force on the first race, N.
    pub fn covers(&self, force: [f64; 3]) -> bool {
        let [x, y, z] = force;
        let [least, most] = self.range;
        (least..=most).contains(&x.hypot(y).hypot(z))
    }
}

impl RollingElements {
    /// Linearizes the load about its equilibrium with an external force on the first race (N, along
    /// the axes of the bearing) and parallel rings.
    ///
    /// # Errors
    /// E0697: the elements cannot carry the force, or have no stiffness along it.
    pub fn linearized(self: &Arc<Self>, force: [f64; 3]) -> Result<(Tangent, Linearization), EngineError> {
        let size = magnitude(force);
        if !(size > 0.0 && size.is_finite()) {
            return Err(EngineError::new(
                "E0697",
                "the force at which a rolling bearing is linearized is zero or not a number",
                "give the force of the operating point, from `gears.bearing_force`; for the stiffness under preload alone, give a small one, such as 1 N",
            ));
        }
        let state = self.under(force)?;
        let tangent = NonlinearLoad::Rolling(self.clone()).tangent(&state, 0.0);
        let Some(stiffness) = self.stiffness_along(force, &state) else {
            return Err(EngineError::new(
                "E0697",
                "the rolling bearing has no stiffness along this force",
                "give a force that loads its elements",
            ));
        };
        let is_near = |factor: f64| {
            let state = self.under(force.map(|part| factor * part));
            let own = state.ok().and_then(|state| self.stiffness_along(force, &state));
            own.is_some_and(|own| (own / stiffness - 1.0).abs() <= RANGE_TOLERANCE)
        };
        let range = [0.5, 2.0].map(|ratio| size * end_of_range(ratio, is_near));
        Ok((tangent, Linearization { force, range }))
    }

    /// Returns the state in equilibrium with an external force on the first race.
    fn under(&self, force: [f64; 3]) -> Result<NonlinearState, EngineError> {
        let [x, y, z] = force;
        let load = self.of_inner_ring([x, y, z, 0.0, 0.0]);
        let is_axial = self.axial_supports() != [false, false];
        if !is_axial && z != 0.0 {
            return Err(EngineError::new(
                "E0697",
                "the bearing carries no axial force",
                "give a force normal to its axis",
            ));
        }
        let prescribed = [false, false, !is_axial, true, true];
        let conditions = Conditions { load, prescribed, start: [0.0; 5] };
        let found = self.bearing.equilibrium(&conditions, &self.motion).map_err(rejected)?;
        self.state(self.of_inner_ring(found.displacement))
    }

    /// Returns the force per displacement along a force, with displacements normal to it free, N/m;
    /// `None` without stiffness.
    fn stiffness_along(&self, force: [f64; 3], state: &NonlinearState) -> Option<f64> {
        let size = magnitude(force);
        let count = if self.axial_supports() == [false, false] { 2 } else { 3 };
        let matrix = DMatrix::from_fn(count, count, |i, j| state.evaluation.stiffness[i][j]);
        let direction = DVector::from_fn(count, |k, _| force[k] / size);
        let compliance = direction.dot(&matrix.lu().solve(&direction)?);
        (compliance > 0.0 && compliance.is_finite()).then(|| compliance.recip())
    }
}

fn magnitude([x, y, z]: [f64; 3]) -> f64 {
    x.hypot(y).hypot(z)
}

/// Returns the factor up to which a condition holds, from 1 by powers of a ratio, and by bisection
/// in between.
fn end_of_range(ratio: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut inside, mut outside) = (1.0, ratio);
    while holds(outside) {
        (inside, outside) = (outside, outside * ratio);
        if !(WIDEST.recip()..=WIDEST).contains(&outside) {
            return inside;
        }
    }
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside);
        if holds(middle) { inside = middle } else { outside = middle }
    }
    inside
}
