//! Linearized rolling bearings under loads that their linearization does not cover.

use super::StepResult;
use crate::system::System;
use calyx_model::bearing::BearingState;
use calyx_numerics::error::EngineError;

impl System<'_> {
    /// Returns the forces of linearized bearings on the DOFs without deflection, per
    /// [`System::width`].
    ///
    /// # Errors
    /// Those of [`BearingState::at`].
    pub(super) fn linearized_preload(&self, time: f64) -> Result<Vec<f64>, EngineError> {
        let mut preload = vec![0.0; self.dofs.len()];
        for &index in &self.bearings {
            let own = &self.scene.bearings[index];
            if own.linearization.is_none() {
                continue;
            }
            let placed = BearingState::at(&self.scene.bodies, own, time)?;
            for (sum, dof) in preload.iter_mut().zip(&self.dofs) {
                let parts = placed.deflection(dof);
                let force: f64 = (0..6).map(|k| parts[k] * own.load[k]).sum();
                *sum += force / self.width(own.body.0);
            }
        }
        Ok(preload)
    }

    /// Warns of linearized bearings whose force is out of the range of the linearization. Warnings
    /// state no values, so that all positions of an analysis have the same ones.
    ///
    /// # Errors
    /// Those of [`BearingState::at`].
    pub(super) fn warn_of_linearized_bearings(
        &self,
        time: f64,
        step: &mut StepResult,
    ) -> Result<(), EngineError> {
        for &index in &self.bearings {
            let own = &self.scene.bearings[index];
            let Some(linearization) = own.linearization else { continue };
            let placed = BearingState::at(&self.scene.bodies, own, time)?;
            let mut deflection = [0.0; 6];
            for (dof, motion) in self.dofs.iter().zip(&step.motion) {
                let parts = placed.deflection(dof);
                deflection.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part * motion);
            }
            let [x, y, z, ..] = own.push(&deflection, &[], None);
            let force = [-x, -y, -z];
            if linearization.opposes(force) {
                step.warnings.push(format!(
                    "bearing \"{}\" carries a force opposite to the one at which it is linearized; reverse the sign of \
                     `linearized_at`, which is the external force on the body: `bearing_force` has the opposite sign",
                    own.name
                ));
            } else if !linearization.covers(force) {
                step.warnings.push(format!(
                    "bearing \"{}\" carries a force out of the range of its linearization, which `calyx explain` states; \
                     linearize it at the force of this position",
                    own.name
                ));
            }
        }
        Ok(())
    }
}
