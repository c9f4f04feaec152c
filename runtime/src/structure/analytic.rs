//! Bodies in the plane without a mesh, by published closed forms: a tooth as a cantilever ([`Cantilever`]) on a ring that is held on its far
//! side ([`HeldRing`]), and the half-plane near loads.
//!
//! Nothing is counted twice. The cantilever's and the ring's displacements are those of the middle of the tooth, where the load's line of action
//! crosses it; what a place on the flank is pressed in by is relative to that point. Weber has it for Hertz's pressure: the half-plane's
//! displacement relative to a point at the depth `h` beneath the load, `2 / (pi E') (ln(h / |x|) - 1 / (2 (1 - nu)))` at the distance `x` from a line
//! load (Johnson, eq. 2.19, plane strain). So the reference length of a load's own half-plane is `h exp(-1 / (2 (1 - nu)))`. Between
//! two places it is taken as `ln(1 + h h' / x²) / (pi E')`, which is the same near the load, and dies out beyond the depth instead of changing its
//! sign; that kernel is positive definite.
//!
//! Helical teeth bend in the section at right angles to them, as the virtual spur gears of the standards do: across the tooth it is shorter than the
//! transverse one by the cosine `c` of the helix angle, a force across a slice of the face is the part `1 / c` of that at right angles to the tooth, and acts on
//! `1 / c` of its length. So an even load bends teeth by `1 / c⁴` as much as their transverse section, and stresses their fillets by `1 / c²` as much. What
//! carries them is the ring of the transverse section, which the part of the force along the face shears. Displacements are along the force of each load, so the whole is symmetric as it is for `c = 1`.

mod cantilever;
mod held_ring;
mod root_stress;
mod solid;

pub use cantilever::{Cantilever, Flexibility, RootLoad};
pub use held_ring::{HeldRing, RingShape};
pub use root_stress::CriticalSection;
pub use solid::AnalyticSolid;

use super::{Chart, StressPlace, Structure, SurfaceLoad};
use crate::material::{Material, Plane};
use crate::profile::Profile;
use std::f64::consts::PI;
use std::sync::Arc;

/// A tooth and what carries it, in tooth coordinates: the middle of the tooth along +x, the body's axis at the origin. m.
#[derive(Clone, Debug)]
pub struct ToothShape {
    /// +1 of a tooth that points outwards, -1 inwards.
    pub sense: f64,
    /// Distances along the tooth from where its fillets end on the ring, and half of its depth there, at right angles to the tooth; ascending, the
    /// first one 0.
    pub depths: Vec<[f64; 2]>,
    /// Cosine of the helix angle: 1 of straight teeth.
    pub lean: f64,
    /// What carries it.
    pub ring: RingShape,
    /// Where it is stressed most; none if stresses are not wanted.
    pub section: Option<CriticalSection>,
}

/// Teeth around a ring that give by closed forms.
pub struct AnalyticStructure {
    surfaces: Vec<Arc<dyn Profile>>,
    tooth: Tooth,
    ring: HeldRing,
    teeth: u32,
    reference_length: f64,
}

/// What of a tooth answers.
struct Tooth {
    sense: f64,
    root: f64,
    lean: f64,
    /// Tangent of the helix angle.
    rise: f64,
    cantilever: Cantilever,
    section: Option<CriticalSection>,
    modulus: f64,
    /// Of the depth beneath a load, the length in the half-plane's logarithm.
    depth_ratio: f64,
}

/// A place on a flank under a unit inward normal force.
#[derive(Clone, Copy, Default)]
struct Local {
    s: f64,
    /// On the ring, per length along the face.
    load: RootLoad,
    /// On the cantilever, per length along the face: at right angles to the tooth.
    bending: RootLoad,
    /// The cantilever up to where the load's line crosses its middle.
    beam: Flexibility,
    /// How far that is from the root, m.
    crossing: f64,
    /// Length in its half-plane's logarithm, m.
    depth: f64,
}

impl AnalyticStructure {
    /// `surfaces` are the flanks of tooth 0, the second the mirror image of the first but for modifications. `coupled` is how far apart
    /// teeth feel each other.
    pub fn new(
        surfaces: Vec<Arc<dyn Profile>>,
        shape: &ToothShape,
        coupled: u32,
        material: Material,
        plane: Plane,
    ) -> AnalyticStructure {
        let tooth = Tooth::new(shape, material, plane);
        let ring = HeldRing::new(&shape.ring, coupled, material, plane);
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
            // The section with the constants that make plane strain of it.
            Plane::Stress => material.poissons_ratio / (1.0 + material.poissons_ratio),
        };
        Tooth {
            sense: shape.sense,
            root: shape.ring.root(),
            lean: shape.lean,
            rise: (1.0 - shape.lean * shape.lean).max(0.0).sqrt() / shape.lean,
            cantilever: Cantilever::new(&shape.depths, material, plane),
            section: shape.section,
            modulus: material.surface_modulus(plane),
            depth_ratio: (-0.5 / (1.0 - nu)).exp(),
        }
    }

    fn local(&self, profile: &dyn Profile, s: f64) -> Local {
        let on = profile.at(s);
        // Round a tip edge forces turn along the tooth, and their lines cross its middle farther and farther down: they are taken to enter as
        // where the edge begins.
        let entering = profile.at(profile.edge_from().map_or(s, |edge| s.min(edge)));
        self.local_at(s, (on.position, on.normal), (entering.position, entering.normal))
    }

    /// A place by its position and outward normal, and by those of where its load enters the tooth: of a slice of the face, the parts in it.
    fn local_at(&self, s: f64, on: ([f64; 2], [f64; 2]), entering: ([f64; 2], [f64; 2])) -> Local {
        let ([x, y], [out, across]) = on;
        let load = RootLoad {
            axial: -self.sense * out,
            shear: -across,
            moment: self.sense * (-(x - self.root) * across + y * out),
            along: across * self.rise,
        };
        let (deep, against) = (self.lean * y, across / self.lean);
        let bending = RootLoad {
            shear: -against,
            moment: self.sense * (-(x - self.root) * against + deep * out),
            ..load
        };
        let ([x, y], [out, across]) = entering;
        let (deep, tangent) = (self.lean * y.abs(), self.lean * out / across.abs());
        let along = self.sense * (x - self.root - deep * tangent);
        let crossing = along.clamp(0.0, self.cantilever.length());
        let depth = self.depth_ratio * deep * 1.0f64.hypot(tangent);
        Local { s, load, bending, beam: self.cantilever.up_to(crossing), crossing, depth }
    }

    /// What gives beneath one place by a load on another of the same tooth, the ring left out, m/(N/m).
    fn between(&self, one: &Local, other: &Local) -> f64 {
        let nearer = if one.crossing <= other.crossing { one } else { other };
        self.lean * nearer.beam.between(&one.bending, &other.bending)
    }

    /// Stress at the critical section on a side of the tooth, by a force of 1 N/m on a place: Pa/(N/m).
    fn stress(&self, section: &CriticalSection, place: &Local, side: f64) -> f64 {
        self.lean * section.stress(&place.bending, side)
    }

    /// What half-planes that end at a depth have beside one with this reference length, m/(N/m).
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

    fn add_compliance(
        &self,
        observe: Chart,
        observe_s: &[f64],
        load: Chart,
        load_s: &[f64],
        block: &mut [f64],
    ) {
        let (observers, loads) = (self.locals(observe, observe_s), self.locals(load, load_s));
        if loads.is_empty() {
            return;
        }
        let ring = self.ring.link(observe.tooth, load.tooth);
        for (row, observer) in block.chunks_mut(loads.len()).zip(&observers) {
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
    }

    fn stresses(&self, tooth: u32, surface: u32, loads: &[SurfaceLoad]) -> Vec<(StressPlace, f64)> {
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
        vec![(StressPlace { tooth, surface, s: section.s, position }, stress)]
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.tooth.cantilever.bytes() + self.ring.bytes()
    }
}

#[cfg(test)]
mod tests;
