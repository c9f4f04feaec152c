//! Three-dimensional bodies without a mesh: rigid bodies, and half-spaces of any shape.

use super::{Mirror, SegmentLoad, SolidStructure, SurfaceSegment, SurfaceStress};
use crate::Chart;
use crate::surface::Surface;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::sync::Arc;

/// Body with independent surfaces, each with the compliance of its tangent half-space: `R` is zero.
///
/// With an infinite modulus it is rigid. Its surfaces are repeated around the z axis like those of
/// a gear.
pub struct HalfSpaceBody {
    surfaces: Vec<Arc<dyn Surface>>,
    teeth: u32,
    surface_modulus: f64,
    mirrors: Vec<Mirror>,
}

impl HalfSpaceBody {
    /// Builds a rigid body. `surfaces` are those of tooth 0; `teeth` is at least 1.
    pub fn rigid(surfaces: Vec<Arc<dyn Surface>>, teeth: u32) -> Self {
        Self::half_space(surfaces, teeth, f64::INFINITY)
    }

    /// Builds a body that deforms near the loads only. `surface_modulus` is `E' = E / (1 - nu²)` in
    /// Pa.
    pub fn half_space(surfaces: Vec<Arc<dyn Surface>>, teeth: u32, surface_modulus: f64) -> Self {
        Self { surfaces, teeth: teeth.max(1), surface_modulus, mirrors: Vec::new() }
    }

    /// Adds free side faces.
    #[must_use]
    pub fn between(mut self, mirrors: Vec<Mirror>) -> Self {
        self.mirrors = mirrors;
        self
    }
}

impl SolidStructure for HalfSpaceBody {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.surfaces[surface as usize].clone()
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        self.surface_modulus
    }

    fn mirrors(&self) -> &[Mirror] {
        &self.mirrors
    }

    fn add_compliance_until(
        &self,
        _: Chart,
        _: &[SurfaceSegment],
        _: Chart,
        _: &[SurfaceSegment],
        _: &mut [f64],
        _: &Interrupt,
    ) -> Result<(), EngineError> {
        Ok(())
    }

    fn stresses(&self, _: u32, _: u32, _: &[SegmentLoad]) -> Vec<SurfaceStress> {
        Vec::new()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.surfaces.as_slice()) + size_of_val(self.mirrors.as_slice())
    }
}
