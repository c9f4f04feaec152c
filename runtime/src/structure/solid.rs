//! How bodies deform in space, seen through their loadable surfaces.
//!
//! The compliance of a surface is split as in the plane: `A(x, x') = G(x, x') + R(x, x')`. `G` is the half-space's answer to a normal
//! force (Johnson, Contact Mechanics, eq. 3.22a), `1 / (pi E' r)` with r the distance of the two points in a straight line, plus the
//! same of the images of the loaded point in the free side faces near which the surface ends; `R` is everything else, smooth, and
//! evaluated here. Displacements are elastic only: what moves the body as a whole belongs to its frame.

mod answers;
mod axial;
mod elastic;
mod half_space;
mod halves;
mod points;
mod responses;
mod screw;
mod simple;
mod stored;
#[cfg(test)]
pub(crate) mod test_surface;

pub use elastic::{ElasticSolid, SolidSplitOptions, SolidSurfaceSource};
pub use simple::SimpleSolid;

use super::{Chart, LugForce};
use crate::surface::Surface;
use std::f64::consts::TAU;
use std::sync::Arc;

/// A place on a surface, with the stretch of the face over which a force there is spread and a displacement there averaged, evenly. Points
/// that stand for cells side by side would see polynomials along the face that the cells' pressures do not have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Coordinates on the surface: across it, and of the middle of the stretch along the face, m.
    pub place: [f64; 2],
    /// Length of the stretch, along the second coordinate, m; 0 for a point.
    pub length: f64,
}

impl From<[f64; 2]> for Spot {
    /// A point.
    fn from(place: [f64; 2]) -> Self {
        Self { place, length: 0.0 }
    }
}

/// A normal force on a surface: positive presses into the material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpotLoad {
    /// Which surface of which tooth.
    pub chart: Chart,
    /// Where on the chart's surface.
    pub spot: Spot,
    /// N
    pub force: f64,
}

/// A plane in the body's coordinates in which `G` has an image of its load: a free side face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mirror {
    /// A point of it, m.
    pub point: [f64; 3],
    /// Its unit normal.
    pub normal: [f64; 3],
}

impl Mirror {
    /// The image of a point, m.
    pub fn image(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let [px, py, pz] = self.point;
        let [nx, ny, nz] = self.normal;
        let twice = 2.0 * ((x - px) * nx + (y - py) * ny + (z - pz) * nz);
        [x - twice * nx, y - twice * ny, z - twice * nz]
    }
}

/// A recovered stress on a free surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceStress {
    /// Counted counter-clockwise from 0.
    pub tooth: u32,
    /// As [`Chart::surface`]: the fillet beside that flank.
    pub surface: u32,
    /// Coordinates on the fillet: along the profile from the end of the flank, and along the axis, m.
    pub place: [f64; 2],
    /// In the body's frame, m.
    pub position: [f64; 3],
    /// In the surface: along the profile, along the face, and in shear, Pa.
    pub components: [f64; 3],
}

impl SurfaceStress {
    /// Largest and smallest principal stress in the surface, Pa; the third, across it, is zero.
    pub fn principal(&self) -> [f64; 2] {
        let [along, across, shear] = self.components;
        let (mean, radius) = (0.5 * (along + across), (0.5 * (along - across)).hypot(shear));
        [mean + radius, mean - radius]
    }
}

/// Elastic behaviour of a body in space.
pub trait SolidStructure: Send + Sync {
    /// A surface of tooth 0, in the body's frame; the same for every tooth, turned.
    fn surface(&self, surface: u32) -> Arc<dyn Surface>;

    /// Angle by which tooth `tooth` is turned about the body's z axis, rad, counter-clockwise.
    fn tooth_angle(&self, tooth: u32) -> f64 {
        let teeth = self.teeth();
        TAU * f64::from(tooth % teeth) / f64::from(teeth)
    }

    /// Number of repeated sectors; 1 where nothing repeats.
    fn teeth(&self) -> u32;

    /// `E' = E / (1 - nu²)` in Pa; infinite for a rigid body, whose `G` and `R` are zero.
    fn surface_modulus(&self) -> f64;

    /// Planes in which `G` has images.
    fn mirrors(&self) -> &[Mirror];

    /// Adds `R` to `block`, row-major, `observers.len()` rows by `loads.len()` columns: inward normal displacement at spots of
    /// `observe` per unit inward normal force at spots of `load`, m/N. Symmetric: exchanging loads and observers
    /// transposes it, bit for bit.
    fn add_compliance(
        &self,
        observe: Chart,
        observers: &[Spot],
        load: Chart,
        loads: &[Spot],
        block: &mut [f64],
    );

    /// Principal stresses at each point where stress is recovered beside a surface of a tooth, for the given loads. Empty if the
    /// structure recovers none.
    fn stresses(&self, tooth: u32, surface: u32, loads: &[SpotLoad]) -> Vec<SurfaceStress>;

    /// What the lugs that hold the body exert on it under the given loads, each in turn; none if no lugs hold it.
    fn lug_forces(&self, _loads: &[SpotLoad]) -> Vec<LugForce> {
        Vec::new()
    }

    /// Memory that the structure takes, in bytes, to the nearest few percent: what a cache counts.
    fn bytes(&self) -> usize;

    /// All of it but the surfaces that contact sees, to be kept on disk for
    /// [`Prototype::restore_solid`](crate::scene::Prototype::restore_solid); `None` if it is made faster than read.
    fn stored(&self) -> Option<Vec<u8>> {
        None
    }
}

/// A structure under surfaces that differ from its own by little, such as modified flanks on the body of the plain gear: what is pressed are
/// these, how the body gives is that of the shared one.
pub struct Reshaped {
    shared: Arc<dyn SolidStructure>,
    surfaces: Vec<Arc<dyn Surface>>,
}

impl Reshaped {
    /// `surfaces` stand for those of `shared` with the same index, over the same coordinates; further ones stay.
    pub fn new(shared: Arc<dyn SolidStructure>, surfaces: Vec<Arc<dyn Surface>>) -> Reshaped {
        Reshaped { shared, surfaces }
    }
}

impl SolidStructure for Reshaped {
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

    fn add_compliance(
        &self,
        observe: Chart,
        observers: &[Spot],
        load: Chart,
        loads: &[Spot],
        block: &mut [f64],
    ) {
        self.shared.add_compliance(observe, observers, load, loads, block);
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SpotLoad]) -> Vec<SurfaceStress> {
        self.shared.stresses(tooth, surface, loads)
    }

    fn lug_forces(&self, loads: &[SpotLoad]) -> Vec<LugForce> {
        self.shared.lug_forces(loads)
    }

    fn bytes(&self) -> usize {
        self.shared.bytes()
    }
}

#[cfg(test)]
pub(crate) mod tests;
