//! Rigid bodies.

use super::{Chart, StressPoint, Structure, SurfaceLoad};
use crate::profile::Profile;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::sync::Arc;

/// Surfaces without compliance, repeated around a circle like those of a gear.
pub struct RigidStructure {
    surfaces: Vec<Arc<dyn Profile>>,
    teeth: u32,
}

impl RigidStructure {
    /// Builds a rigid body. `surfaces` are those of tooth 0; `teeth` is at least 1.
    pub fn new(surfaces: Vec<Arc<dyn Profile>>, teeth: u32) -> Self {
        Self { surfaces, teeth: teeth.max(1) }
    }
}

impl Structure for RigidStructure {
    fn profile(&self, surface: u32) -> Arc<dyn Profile> {
        self.surfaces[surface as usize].clone()
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        f64::INFINITY
    }

    fn reference_length(&self) -> f64 {
        self.surfaces.first().map_or(1.0, |profile| profile.length())
    }

    fn add_compliance_until(
        &self,
        _: Chart,
        _: &[f64],
        _: Chart,
        _: &[f64],
        _: &mut [f64],
        _: &Interrupt,
    ) -> Result<(), EngineError> {
        Ok(())
    }

    fn stresses(&self, _: u32, _: u32, _: &[SurfaceLoad]) -> Vec<(StressPoint, f64)> {
        Vec::new()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.surfaces.as_slice())
    }
}
