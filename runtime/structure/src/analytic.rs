//! Two-dimensional bodies without a mesh, by published closed forms: a tooth as a cantilever
//! ([`Cantilever`]) on a ring that is fixed on its far side ([`FoundationRing`]), and the
//! half-plane near loads.
//!
//! Each compliance contribution is counted once. The displacements of the cantilever and the ring
//! are those of the tooth's centre line, where the load's line of action crosses it; the local
//! indentation of a point on the flank is relative to that crossing. For Hertzian pressure Weber
//! gives the displacement of the half-plane relative to a point at the depth `h` beneath the load:
//! `2 / (pi E') (ln(h / |x|) - 1 / (2 (1 - nu)))` at the distance `x` from a line load (Johnson,
//! eq. 2.19, plane strain). So the reference length of the half-plane of a load is
//! `h exp(-1 / (2 (1 - nu)))`. Between two points the model uses `ln(1 + h h' / x²) / (pi E')`.
//! This is the same near the load and decays beyond the depth instead of changing its sign; the
//! kernel is positive definite.
//!
//! Helical teeth bend in the normal section, as the virtual spur gears of the standards do. Across
//! the tooth this section is shorter than the transverse one by the cosine `c` of the helix angle.
//! The force normal to the tooth is `1 / c` times the transverse force on a slice of the face, and
//! acts on `1 / c` times its length. A uniform load therefore bends teeth `1 / c⁴` times as much as
//! their transverse section, and stresses their fillets `1 / c²` times as much. The ring below them
//! deforms in the same normal section ([`foundation_ring`]). Displacements are along the force of
//! each load, so the compliance is symmetric as it is for `c = 1`.
//!
//! See `docs/theory/analytic-compliance.md`.

mod cantilever;
mod face_coupling;
mod foundation_ring;
mod ring_family;
mod root_stress;
mod sections;
mod solid;
mod tapered;

pub use cantilever::{Cantilever, Flexibility, RootLoad};
pub use foundation_ring::{FoundationRing, RingShape};
pub use root_stress::CriticalSection;
pub use sections::{RootStation, ToothSection};
pub use solid::AnalyticSolid;
pub use tapered::{SectionPoint, SectionedSurface, TaperedSolid};

use super::{Chart, StressPoint, Structure, SurfaceLoad};
use crate::profile::Profile;
use calyx_fe::material::{Material, Plane};
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::PI;
use std::sync::Arc;

/// Shape of a tooth and the ring below it, in tooth coordinates, m: the centre line of the tooth
/// along +x, the body's axis at the origin.
#[derive(Clone, Debug)]
pub struct ToothShape {
    /// +1 for a tooth that points outwards, -1 inwards.
    pub sense: f64,
    /// Distances along the tooth from the lower end of its fillets on the ring, and half of the
    /// tooth thickness there, normal to the centre line; ascending, the first distance 0.
    pub depths: Vec<[f64; 2]>,
    /// Ring that supports the tooth.
    pub ring: RingShape,
    /// Critical section of the root stress; `None` if stresses are not requested.
    pub section: Option<CriticalSection>,
}

/// Teeth around a ring with closed-form compliances.
pub struct AnalyticStructure {
    surfaces: Vec<Arc<dyn Profile>>,
    tooth: Tooth,
    ring: FoundationRing,
    teeth: u32,
    reference_length: f64,
}

/// Closed-form models of a tooth.
struct Tooth {
    sense: f64,
    root: f64,
    /// Cosine of the helix angle.
    lean: f64,
    cantilever: Cantilever,
    section: Option<CriticalSection>,
    modulus: f64,
    /// Reference length in the half-plane's logarithm as a fraction of the depth beneath a load.
    depth_ratio: f64,
}

/// Point on a flank under a unit inward normal force.
#[derive(Clone, Copy, Default)]
struct Local {
    s: f64,
    /// Load on the ring, per length along the face.
    load: RootLoad,
    /// Load on the cantilever, per length along the face: normal to the tooth.
    bending: RootLoad,
    /// Flexibility of the cantilever up to the point where the load's line of action crosses the
    /// centre line.
    beam: Flexibility,
    /// Distance of that crossing from the root, m.
    crossing: f64,
    /// Length in the half-plane's logarithm of this load, m.
    depth: f64,
}

impl AnalyticStructure {
    /// Builds the structure. `surfaces` are the flanks of tooth 0; apart from modifications, the
    /// second is the mirror image of the first.
    pub fn new(
        surfaces: Vec<Arc<dyn Profile>>,
        shape: &ToothShape,
        material: Material,
        plane: Plane,
    ) -> AnalyticStructure {
        let tooth = Tooth::new(shape, material, plane);
        let ring = FoundationRing::new(&shape.ring, material, plane);
        let teeth = shape.ring.sectors.max(1);
        let middle = surfaces.first().map(|profile| tooth.local(profile.as_ref(), 0.5 * profile.length()));
        let reference_length = middle.map_or(shape.ring.radius, |local| local.depth);
        AnalyticStructure { surfaces, tooth, ring, teeth, reference_length }
    }

    fn locals(&self, chart: Chart, s: &[f64]) -> Vec<Local> {
        let Some(profile) = self.surfaces.get(chart.surface as usize) else { return Vec::new() };
        s.iter().map(|&s| self.tooth.local(profile.as_ref(), s)).collect()
    }
}

impl Tooth {
    fn new(shape: &ToothShape, material: Material, plane: Plane) -> Tooth {
        let nu = match plane {
            Plane::Strain => material.poissons_ratio,
            // Effective Poisson's ratio that turns the plane-strain formulas into plane stress.
            Plane::Stress => material.poissons_ratio / (1.0 + material.poissons_ratio),
        };
        Tooth {
            sense: shape.sense,
            root: shape.ring.root(),
            lean: shape.ring.lean,
            cantilever: Cantilever::new(&shape.depths, material, plane),
            section: shape.section,
            modulus: material.surface_modulus(plane),
            depth_ratio: (-0.5 / (1.0 - nu)).exp(),
        }
    }

    fn local(&self, profile: &dyn Profile, s: f64) -> Local {
        let on = profile.at(s);
        // Around a tip edge the direction of the force rotates towards the tooth axis, and its line
        // crosses the centre line farther down. The model lets these forces enter the tooth where
        // the edge begins.
        let entering = profile.at(profile.edge_from().map_or(s, |edge| s.min(edge)));
        self.local_at(s, (on.position, on.normal), (entering.position, entering.normal))
    }

    /// Returns the local data of a point from its position and outward normal, and from those of
    /// the point where its load enters the tooth. For a slice of the face, these are the components
    /// in the slice.
    fn local_at(&self, s: f64, on: ([f64; 2], [f64; 2]), entering: ([f64; 2], [f64; 2])) -> Local {
        let ([x, y], [out, across]) = on;
        let (deep, against) = (self.lean * y, across / self.lean);
        let bending = RootLoad {
            axial: -self.sense * out,
            shear: -against,
            moment: self.sense * (-(x - self.root) * against + deep * out),
        };
        // The same moment by tractions on the longer arc of the transverse section.
        let load = RootLoad { moment: bending.moment / self.lean, ..bending };
        let ([x, y], [out, across]) = entering;
        let (deep, tangent) = (self.lean * y.abs(), self.lean * out / across.abs());
        let along = self.sense * (x - self.root - deep * tangent);
        let crossing = along.clamp(0.0, self.cantilever.length());
        let depth = self.depth_ratio * deep * 1.0f64.hypot(tangent);
        Local { s, load, bending, beam: self.cantilever.up_to(crossing), crossing, depth }
    }

    /// Returns the compliance at one point by a load on another of the same tooth, without the
    /// ring, m/(N/m).
    fn between(&self, one: &Local, other: &Local) -> f64 {
        let nearer = if one.crossing <= other.crossing { one } else { other };
        self.lean * nearer.beam.between(&one.bending, &other.bending)
    }

    /// Returns the stress at the critical section on a side of the tooth by a force of 1 N/m at a
    /// point, Pa/(N/m).
    fn stress(&self, section: &CriticalSection, place: &Local, side: f64) -> f64 {
        self.lean * section.stress(&place.bending, side)
    }

    /// Returns the difference between the compliance of half-planes that end at a depth and that of
    /// one with this reference length, m/(N/m).
    fn near(&self, one: &Local, other: &Local, reference: f64) -> f64 {
        let apart = one.s - other.s;
        let argument = (apart * apart + one.depth * other.depth) / (reference * reference);
        argument.ln() / (PI * self.modulus)
    }
}

impl Structure for AnalyticStructure {
    fn profile(&self, surface: u32) -> Arc<dyn Profile> {
        self.surfaces[surface as usize].clone()
    }

    fn teeth(&self) -> u32 {
        self.teeth
    }

    fn surface_modulus(&self) -> f64 {
        self.tooth.modulus
    }

    fn reference_length(&self) -> f64 {
        self.reference_length
    }

    fn add_compliance_until(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
        interrupt: &Interrupt,
    ) -> Result<(), EngineError> {
        let (observers, loads) = (self.locals(observe, observe_s), self.locals(load, load_s));
        if loads.is_empty() {
            return Ok(());
        }
        let ring = self.ring.link(observe.tooth, load.tooth);
        for (row, observer) in block.chunks_mut(loads.len()).zip(&observers) {
            interrupt.check()?;
            for (entry, loaded) in row.iter_mut().zip(&loads) {
                let mut given = ring.compliance(&observer.load, &loaded.load);
                if observe.tooth == load.tooth {
                    given += self.tooth.between(observer, loaded);
                }
                if observe == load {
                    given += self.tooth.near(observer, loaded, self.reference_length);
                }
                *entry += given;
            }
        }
        Ok(())
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPoint, f64)> {
        let Some(section) = &self.tooth.section else { return Vec::new() };
        let side = if surface == 0 { 1.0 } else { -1.0 };
        let by = |load: &SurfaceLoad| {
            let profile = self.surfaces.get(load.chart.surface as usize)?;
            let local = self.tooth.local(profile.as_ref(), load.s);
            Some(load.force * self.tooth.stress(section, &local, side))
        };
        let stress = loads.iter().filter(|load| load.chart.tooth == tooth).filter_map(by).sum();
        let (sine, cosine) = self.tooth_angle(tooth).sin_cos();
        let [x, y] = [section.position[0], side * section.position[1]];
        let position = [cosine * x - sine * y, sine * x + cosine * y];
        vec![(StressPoint { tooth, surface, s: section.s, position }, stress)]
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.tooth.cantilever.bytes() + self.ring.bytes()
    }
}

#[cfg(test)]
mod tests;
