//! Elastic compliance of three-dimensional bodies, at their loadable surfaces.
//!
//! The compliance of a surface is split as in plane models: `A(x, x') = G(x, x') + R(x, x')`. `G`
//! is the response of the half-space to a normal force (Johnson, Contact Mechanics, eq. 3.22a),
//! `1 / (pi E' r)` with r the straight distance of the two points, plus the same terms for the
//! images of the loaded point in the free side faces near which the surface ends. `R` is the smooth
//! remainder, which the structure evaluates. Displacements are elastic only: rigid-body motion
//! belongs to the frame.

mod axial_modes;
mod elastic;
mod exchange;
mod half_space;
mod half_space_body;
mod half_space_means;
mod influence;
mod mirror_symmetry;
mod responses;
mod screw;
mod side_faces;
mod stored;
mod surface_means;
mod surface_metric;
mod table_weights;
#[cfg(any(test, feature = "fixtures"))]
#[allow(dead_code, missing_docs, reason = "tests of other crates use it too")]
pub mod test_surface;

pub use elastic::{ElasticSolid, SolidSplitOptions, SolidSurfaceSource};
pub use half_space_body::HalfSpaceBody;

use super::{Chart, SplineToothForce};
use crate::raceway::Raceway;
use crate::surface::Surface;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use faer::{Mat, MatRef};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Location on a surface, with the length along the face over which a force is distributed and a
/// displacement averaged, uniformly. Point values in place of adjacent cells would add polynomial
/// variations along the face that the cells' pressures do not have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSegment {
    /// Coordinates on the surface: along the profile, and the middle of the length along the face.
    pub place: [f64; 2],
    /// Length in the second coordinate; 0 for a point.
    pub length: f64,
}

impl From<[f64; 2]> for SurfaceSegment {
    /// Returns a spot of zero length.
    fn from(place: [f64; 2]) -> Self {
        Self { place, length: 0.0 }
    }
}

/// A normal force on a surface: positive presses into the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SegmentLoad {
    /// Surface and tooth.
    pub chart: Chart,
    /// Location on the surface of the chart.
    pub segment: SurfaceSegment,
    /// Force, N.
    pub force: f64,
}

/// Mirror plane of `G` in the body's coordinates: a free side face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// Point on the plane, m.
    pub point: [f64; 3],
    /// Unit normal of the plane.
    pub normal: [f64; 3],
}

impl Mirror {
    /// Returns the image of a point, m.
    pub fn image(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [px, py, pz] = self.point;
        let [nx, ny, nz] = self.normal;
        let twice = 2.0 * ((x - px) * nx + (y - py) * ny + (z - pz) * nz);
        [x - twice * nx, y - twice * ny, z - twice * nz]
    }
}

/// Recovered stress on a free surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceStress {
    /// Index of the tooth, counted counter-clockwise from 0.
    pub tooth: u32,
    /// Index of the surface as in [`Chart::surface`]: the fillet adjacent to that flank.
    pub surface: u32,
    /// Coordinates on the fillet: along the profile from the end of the flank, and along the axis,
    /// m.
    pub place: [f64; 2],
    /// Position in the body's frame, m.
    pub position: [f64; 3],
    /// Stress components in the surface: along the profile, along the face, and shear, Pa.
    pub components: [f64; 3],
}

impl SurfaceStress {
    /// Returns the largest and the smallest principal stress in the surface, Pa; the third, normal
    /// to the surface, is zero.
    pub fn principal(&self) -> [f64; 2] {
        let [along, across, shear] = self.components;
        let (mean, radius) = (0.5 * (along + across), (0.5 * (along - across)).hypot(shear));
        [mean + radius, mean - radius]
    }
}

/// Elastic behaviour of a three-dimensional body.
pub trait SolidStructure: Send + Sync {
    /// Returns a surface of tooth 0 in the body's frame; the other teeth have the same surface,
    /// rotated.
    fn surface(&self, surface: u32) -> Arc<dyn Surface>;

    /// Returns the angle of tooth `tooth` about the body's z axis, rad, counter-clockwise.
    fn tooth_angle(&self, tooth: u32) -> f64 {
        let teeth = self.teeth();
        TAU * f64::from(tooth % teeth) / f64::from(teeth)
    }

    /// Returns the number of repeated sectors; 1 where nothing repeats.
    fn teeth(&self) -> u32;

    /// Returns `E' = E / (1 - nu²)` in Pa; infinite for a rigid body, whose `G` and `R` are zero.
    fn surface_modulus(&self) -> f64;

    /// Returns the mirror planes in which `G` has images.
    fn mirrors(&self) -> &[Mirror];

    /// Returns the mirror planes in which `G` has images on a surface of tooth 0, like
    /// [`Self::surface`]: the planes that touch the free side faces where the surface ends, at two
    /// coordinates `u`, one for the start and one for the end of `v`. They are those of
    /// [`Self::mirrors`] on every surface whose side faces are planes.
    fn side_faces(&self, _surface: u32, _u: [f64; 2]) -> Vec<Mirror> {
        self.mirrors().to_vec()
    }

    /// Adds `R` to `block`, row-major, `observers.len()` rows by `loads.len()` columns: inward
    /// normal displacement at spots of `observe` per unit inward normal force at spots of `load`,
    /// m/N. The result is symmetric: exchanging loads and observers transposes it, bit for bit.
    ///
    /// # Errors
    /// The interrupt's. Many cells take long, so implementations check it.
    fn add_compliance_until(
        &self,
        observe: Chart,
        observers: &[SurfaceSegment],
        load: Chart,
        loads: &[SurfaceSegment],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError>;

    /// [`SolidStructure::add_compliance_until`] without an interrupt.
    fn add_compliance(
        &self,
        observe: Chart,
        observers: &[SurfaceSegment],
        load: Chart,
        loads: &[SurfaceSegment],
        block: &mut [f64],
    ) {
        // An interrupt that is never asked ends nothing.
        let _ = self.add_compliance_until(observe, observers, load, loads, block, &Interrupt::never());
    }

    /// Returns the stresses under the given loads at each stress recovery point next to a surface
    /// of a tooth. Empty if the structure recovers no stress.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SegmentLoad]) -> Vec<SurfaceStress>;

    /// Returns the forces of the supporting spline teeth on the body under the given loads, one
    /// entry a spline tooth; empty if spline teeth do not support the body.
    fn spline_tooth_forces(&self, _loads: &[SegmentLoad]) -> Vec<SplineToothForce> {
        Vec::new()
    }

    /// Returns the raceway in the bore of the body, if any.
    fn raceway(&self) -> Option<Raceway> {
        None
    }

    /// Returns the compliance matrix of the terms of the raceway: displacements by forces, m/N. The
    /// matrix is square and symmetric to the bit; `None` for another bore.
    fn interface_compliance(&self) -> Option<MatRef<'_, f64>> {
        None
    }

    /// Returns the same displacements by unit loads on segments of a chart, displacements by
    /// segments. By reciprocity these are also the displacements of the segments by the conjugate
    /// forces.
    ///
    /// # Errors
    /// Those of the interrupt.
    fn interface_displacements(
        &self,
        _load: Chart,
        loads: &[SurfaceSegment],
        _interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        Ok(Mat::zeros(0, loads.len()))
    }

    /// Returns the contribution to [`SolidStructure::stresses`] of forces on all these
    /// displacements: the components of each stress recovery point, Pa. Empty if they contribute
    /// nothing.
    fn stresses_by_interface(&self, _tooth: u32, _surface: u32, _forces: &[f64]) -> Vec<[f64; 3]> {
        Vec::new()
    }

    /// Returns the memory of the structure, in bytes, to within a few percent: the size that a
    /// cache counts.
    fn bytes(&self) -> usize;

    /// Returns everything but the contact surfaces, to be stored on disk for
    /// `Prototype::restore_solid`; `None` if building the
    /// structure is faster than reading it.
    fn stored(&self) -> Option<Vec<u8>> {
        None
    }
}

/// Structure with surfaces that differ slightly from its own, such as modified flanks on the body
/// of the unmodified gear. Contact acts on the new surfaces; the compliance is that of the shared
/// structure.
pub struct ModifiedStructure {
    shared: Arc<dyn SolidStructure>,
    surfaces: Vec<Arc<dyn Surface>>,
}

impl ModifiedStructure {
    /// Replaces the surfaces of `shared` with the same index by `surfaces`, over the same
    /// coordinates; further ones remain.
    pub fn new(shared: Arc<dyn SolidStructure>, surfaces: Vec<Arc<dyn Surface>>) -> ModifiedStructure {
        ModifiedStructure { shared, surfaces }
    }
}

impl SolidStructure for ModifiedStructure {
    fn surface(&self, surface: u32) -> Arc<dyn Surface> {
        self.surfaces.get(surface as usize).cloned().unwrap_or_else(|| self.shared.surface(surface))
    }

    fn teeth(&self) -> u32 {
        self.shared.teeth()
    }

    fn surface_modulus(&self) -> f64 {
        self.shared.surface_modulus()
    }

    fn mirrors(&self) -> &[Mirror] {
        self.shared.mirrors()
    }

    fn side_faces(&self, surface: u32, u: [f64; 2]) -> Vec<Mirror> {
        self.shared.side_faces(surface, u)
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observers: &[SurfaceSegment],
        load: Chart,
        loads: &[SurfaceSegment],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        self.shared.add_compliance_until(observe, observers, load, loads, block, interrupt)
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SegmentLoad]) -> Vec<SurfaceStress> {
        self.shared.stresses(tooth, surface, loads)
    }

    fn spline_tooth_forces(&self, loads: &[SegmentLoad]) -> Vec<SplineToothForce> {
        self.shared.spline_tooth_forces(loads)
    }

    fn raceway(&self) -> Option<Raceway> {
        self.shared.raceway()
    }

    fn interface_compliance(&self) -> Option<MatRef<'_, f64>> {
        self.shared.interface_compliance()
    }

    fn interface_displacements(
        &self,
        load: Chart,
        loads: &[SurfaceSegment],
        interrupt: &Interrupt,
    ) -> Result<Mat<f64>, EngineError> {
        self.shared.interface_displacements(load, loads, interrupt)
    }

    fn stresses_by_interface(&self, tooth: u32, surface: u32, forces: &[f64]) -> Vec<[f64; 3]> {
        self.shared.stresses_by_interface(tooth, surface, forces)
    }

    fn bytes(&self) -> usize {
        self.shared.bytes()
    }
}

#[cfg(any(test, feature = "fixtures"))]
#[allow(dead_code, missing_docs, unused_imports, reason = "bodies that tests of other crates use too")]
pub mod tests;
