//! Outer Newton iteration for rolling bearings.
//!
//! The contact problem has the tangents of all rolling bearings; its solution gives their next
//! deflections. The potential energy of the whole is convex (nearly so with balls). A multiple of
//! the typical stiffness is added about the last deflection, a proximal term, which keeps steps
//! short while clearances close. It decreases where the linearized load agrees with that of the
//! elements.

use super::StepResult;
use crate::system::System;
use calyx_model::bearing::{BearingState, RollingElements, RollingState, Tangent};
use calyx_model::dof::Dof;
use calyx_numerics::error::{EngineError, Subject};
use std::sync::Arc;

/// Largest number of contact problems of a position.
const ROUNDS: usize = 120;
/// Difference between the load of the elements and its linearization, relative to the loads of the
/// elements and of the contact problem.
const TOLERANCE: f64 = 1e-11;
/// Difference below which rounding may end the iteration.
const STALLED: f64 = 1e-8;
/// First and least multiple of the typical stiffness.
const ADDITIONS: [f64; 2] = [1e-2, 1e-12];
/// Multiple of the typical stiffness with which a solution is accepted.
const NEGLIGIBLE: f64 = 1e-9;

/// A rolling bearing of the scene in the iteration.
struct Rolling {
    /// Index in the scene.
    bearing: usize,
    elements: Arc<RollingElements>,
    /// Deflection by DOF.
    arms: Vec<[f64; 6]>,
    /// Length that makes moments comparable with forces, m.
    radius: f64,
    state: RollingState,
}

/// Agreement of the next loads of all bearings with their linearization.
struct Agreement {
    /// Largest difference relative to the loads.
    residual: f64,
    /// Work of the difference on the step.
    excess: f64,
    /// Work of the linearized change of load on the step.
    work: f64,
}

impl System<'_> {
    /// Returns whether rolling bearings are modelled.
    pub fn has_rolling_bearings(&self) -> bool {
        self.bearings.iter().any(|&bearing| self.scene.bearings[bearing].rolling.is_some())
    }

    /// Solves the equilibrium with rolling bearings at a time (s). `solve` solves the contact
    /// problem with given tangents, by bearing of the scene.
    ///
    /// # Errors
    /// E0726: the rolling bearings do not balance their loads. Those of `solve`.
    pub(super) fn with_rolling_bearings(
        &self,
        time: f64,
        solve: impl Fn(&[Option<Tangent>]) -> Result<StepResult, EngineError>,
    ) -> Result<StepResult, EngineError> {
        let mut rolling = self.rolling_at(time)?;
        let mut addition = ADDITIONS[0];
        let mut last = f64::INFINITY;
        for _ in 0..ROUNDS {
            let mut tangents = vec![None; self.scene.bearings.len()];
            for own in &rolling {
                tangents[own.bearing] = Some(own.state.tangent(&own.elements, addition));
            }
            let mut step = solve(&tangents)?;
            let next = rolling.iter().map(|own| own.next(&step.motion)).collect::<Result<Vec<_>, _>>()?;
            let agreement = agreement(&rolling, &next, &tangents);
            // Rounding of the contact problem may leave a residual that the certificate states.
            let is_stalled = agreement.residual <= STALLED && agreement.residual >= 0.5 * last;
            last = agreement.residual;
            if (agreement.residual <= TOLERANCE || is_stalled) && addition <= NEGLIGIBLE {
                let certificate = &mut step.certificate;
                certificate.equilibrium = certificate.equilibrium.max(agreement.residual);
                return Ok(step);
            }
            // The elements are stiffer than their linearization: the step would gain no energy.
            // Near the solution, rounding decides the sign of both.
            if agreement.residual > STALLED && agreement.excess > 0.5 * agreement.work {
                addition = 8.0 * addition.max(1e-4);
                continue;
            }
            let close = agreement.residual <= STALLED || agreement.excess.abs() <= 0.25 * agreement.work;
            addition = (addition * if close { 1e-2 } else { 0.25 }).max(ADDITIONS[1]);
            for (own, next) in rolling.iter_mut().zip(next) {
                own.state = next;
            }
        }
        Err(self.unbalanced(&rolling, last))
    }

    /// Returns the rolling bearings without deflection.
    fn rolling_at(&self, time: f64) -> Result<Vec<Rolling>, EngineError> {
        let mut rolling = Vec::new();
        for &bearing in &self.bearings {
            let own = &self.scene.bearings[bearing];
            let Some(elements) = &own.rolling else { continue };
            let placed = BearingState::at(&self.scene.bodies, own, time)?;
            let arms = self.dofs.iter().map(|dof: &Dof| placed.deflection(dof)).collect();
            let rows = elements.bearing.rows().iter();
            let radius = rows.map(|row| 0.5 * row.pitch_diameter()).fold(0.0, f64::max);
            let (elements, state) = (elements.clone(), elements.state([0.0; 5])?);
            rolling.push(Rolling { bearing, elements, arms, radius, state });
        }
        Ok(rolling)
    }

    fn unbalanced(&self, rolling: &[Rolling], residual: f64) -> EngineError {
        let name = rolling.first().map_or("", |own| self.scene.bearings[own.bearing].name.as_str());
        let error = EngineError::new(
            "E0726",
            format!(
                "the rolling bearings do not balance their loads: the difference is {residual:.1e} of the loads, among others at \"{name}\""
            ),
            "give bearings that carry the load in its direction, such as a second tapered roller bearing for the opposite axial load",
        );
        match rolling.first() {
            Some(own) => error.about(Subject::Bearing(own.bearing)),
            None => error,
        }
    }
}

impl Rolling {
    /// Returns the state at the deflection of a solution.
    fn next(&self, motion: &[f64]) -> Result<RollingState, EngineError> {
        let mut deflection = [0.0; 5];
        for (arm, motion) in self.arms.iter().zip(motion) {
            for (sum, part) in deflection.iter_mut().zip(arm) {
                *sum += part * motion;
            }
        }
        self.elements.moved(&self.state, deflection)
    }
}

fn agreement(rolling: &[Rolling], next: &[RollingState], tangents: &[Option<Tangent>]) -> Agreement {
    let mut total = Agreement { residual: 0.0, excess: 0.0, work: 0.0 };
    for (own, next) in rolling.iter().zip(next) {
        let Some(tangent) = &tangents[own.bearing] else { continue };
        let mut scale = next.evaluation.scale + own.state.evaluation.scale;
        let mut difference = 0.0f64;
        for i in 0..5 {
            let unit = if i < 3 { 1.0 } else { own.radius };
            let row = &tangent.stiffness[i];
            let linear: f64 = (0..5).map(|j| row[j] * next.deflection[j]).sum::<f64>() - tangent.load[i];
            let change = next.deflection[i] - own.state.deflection[i];
            let apart = next.evaluation.load[i] - linear;
            total.excess += apart * change;
            total.work += (linear - own.state.evaluation.load[i]) * change;
            scale = scale.max(linear.abs() / unit);
            difference = difference.max(apart.abs() / unit);
        }
        if scale > 0.0 {
            total.residual = total.residual.max(difference / scale);
        }
    }
    total
}
