//! Rolling bearings as constant stiffnesses: their tangent at a load, and the range of loads over
//! which it is accurate.

use super::nonlinear::NonlinearLoad;
use super::nonlinear_state::NonlinearState;
use super::rolling::RollingElements;
use super::tangent::Tangent;
use calyx_numerics::error::EngineError;
use calyx_rolling::{Conditions, Displacement};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// Deviation of the stiffness at the ends of the range of loads, relative to the stiffness at the
/// operating point.
pub const RANGE_TOLERANCE: f64 = 0.1;
/// Largest ratio of a load of the range to that at the operating point, and of that load to the
/// smallest one.
const WIDEST: f64 = 1048576.0;
/// Number of bisections of the ends of the range, which are displayed with three digits.
const BISECTIONS: usize = 12;
/// Largest force normal to the direction of the operating point, relative to the force along it:
/// the loaded zone rotates with the force.
const SIDEWAYS: f64 = 0.25;

/// Operating point about which a bearing is linear.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization {
    /// External force on the first race, along the axes of the bearing, N.
    pub force: [f64; 3],
    /// Smallest and largest force in this direction, N, between which the stiffness along it
    /// deviates by at most [`RANGE_TOLERANCE`] from that at the operating point.
    pub range: [f64; 2],
    /// Deflection at the operating point, m and rad.
    pub deflection: Displacement,
    /// True if radial forces cause axial ones: the elements have a contact angle.
    pub has_contact_angle: bool,
}

impl Linearization {
    /// Returns whether the stiffness is accurate under an external force on the first race, N: its
    /// component along the force of the operating point is in the range, and the rest is small
    /// against it. Axial reactions count only if the operating point has an axial force.
    pub fn covers(&self, force: [f64; 3]) -> bool {
        let [along, sideways] = self.components(force);
        let [least, most] = self.range;
        (least..=most).contains(&along) && sideways <= SIDEWAYS * along
    }

    /// Returns whether an external force on the first race, N, is opposite to that of the operating
    /// point.
    pub fn opposes(&self, force: [f64; 3]) -> bool {
        let [along, sideways] = self.components(force);
        along < 0.0 && sideways <= SIDEWAYS * -along
    }

    /// Returns the component of a force along that of the operating point, and the rest, N.
    fn components(&self, force: [f64; 3]) -> [f64; 2] {
        let [x, y, z] = force;
        let force = [x, y, if self.force[2] == 0.0 { 0.0 } else { z }];
        let direction = self.force.map(|part| part / magnitude(self.force));
        let along: f64 = (0..3).map(|k| force[k] * direction[k]).sum();
        [along, magnitude(std::array::from_fn(|k| force[k] - along * direction[k]))]
    }
}

impl RollingElements {
    /// Linearizes the load about its equilibrium with an external force on the first race (N, along
    /// the axes of the bearing) and parallel rings. Without an axial force, the rings keep their
    /// axial position.
    ///
    /// # Errors
    /// E0697: the elements cannot carry the force, have no stiffness along it, or are damaged by
    /// it.
    pub fn linearized(self: &Arc<Self>, force: [f64; 3]) -> Result<(Tangent, Linearization), EngineError> {
        let size = magnitude(force);
        if !(size > 0.0 && size.is_finite()) {
            return Err(EngineError::new(
                "E0697",
                "the force at which a rolling bearing is linearized is zero or not a number",
                "give the external force on the body at the operating point; for the stiffness under preload alone, give a small one, such as 1 N",
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
        let [x, y, z, about_x, about_y] = state.deflection;
        if let Some(warning) = self.warnings(&[x, y, z, about_x, about_y, 0.0], None)?.first() {
            let message = format!("at the force at which it is linearized, the bearing {warning}");
            return Err(EngineError::new("E0697", message, "check the size and the sense of the force"));
        }
        let range = [0.5, 2.0].map(|ratio| size * end_of_range(ratio, is_near));
        let has_contact_angle = self.bearing.has_contact_angle();
        Ok((tangent, Linearization { force, range, deflection: state.deflection, has_contact_angle }))
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
        let prescribed = [false, false, z == 0.0, true, true];
        let conditions = Conditions { load, prescribed, start: [0.0; 5] };
        let found = self.bearing.equilibrium(&conditions, &self.motion).map_err(|_| {
            EngineError::new(
                "E0697",
                "the bearing cannot carry the force at which it is linearized",
                "compare the sense of its axial part with `thrust`, and its size with the load ratings",
            )
        })?;
        self.state(self.of_inner_ring(found.displacement))
    }

    /// Returns the force per displacement along a force, with displacements normal to it free, N/m;
    /// `None` without stiffness.
    fn stiffness_along(&self, force: [f64; 3], state: &NonlinearState) -> Option<f64> {
        let size = magnitude(force);
        let count = if force[2] == 0.0 { 2 } else { 3 };
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
        if outside > WIDEST {
            return inside;
        }
        if outside < WIDEST.recip() {
            return 0.0;
        }
    }
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (inside + outside);
        if holds(middle) { inside = middle } else { outside = middle }
    }
    inside
}
