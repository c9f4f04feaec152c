//! Gears without a mesh: the dimensions of the teeth that the closed-form models use. Theory:
//! `docs/theory/analytic-compliance.md`.

use crate::fillet::{RootFillet, Side};
use crate::flank::Flank;
use crate::prototype::GearPrototype;
use calyx_abi::math;
use calyx_runtime::error::EngineError;
use calyx_runtime::material::Plane;
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::structure::RigidStructure;
use calyx_runtime::structure::analytic::{
    AnalyticSolid, AnalyticStructure, CriticalSection, RingShape, ToothShape,
};
use calyx_runtime::structure::solid::HalfSpaceBody;
use calyx_runtime::surface::Surface;
use std::sync::Arc;

/// Angle between the fillet's tangent and the tooth's centreline at which the tooth ends and the
/// foundation ring begins: 75 degrees, as Cornell (1981) recommends.
pub(crate) const FOOT: f64 = 75.0_f64.to_radians();
/// The same angle at the critical section for external and internal gears: ISO 6336-3.
pub(crate) const CRITICAL: [f64; 2] = [30.0_f64.to_radians(), 60.0_f64.to_radians()];
/// Numbers of stations of the tooth's half-thickness along a fillet and along a flank.
const STATIONS: [usize; 2] = [24, 24];
/// Number of bisections of a fillet's length to find an inclination.
pub(crate) const HALVINGS: usize = 50;

impl GearPrototype {
    /// Teeth and rim in closed form.
    ///
    /// # Errors
    /// E0623: the teeth are helical. E0677: the modified flanks do not fit.
    pub(crate) fn analytic(&self, options: &StructureOptions) -> Result<AnalyticStructure, EngineError> {
        self.refuse_helix()?;
        let [tip, _] = self.roundings(options);
        let surfaces = self.flanks_with(tip, &self.modifications)?.map(|flank| flank as Arc<dyn Profile>);
        let shape = self.tooth_shape(options)?;
        Ok(AnalyticStructure::new(surfaces.to_vec(), &shape, self.material, Plane::Strain))
    }

    /// Rigid flanks, without compliance.
    ///
    /// # Errors
    /// As [`GearPrototype::analytic`].
    pub(crate) fn rigid(&self, options: &StructureOptions) -> Result<RigidStructure, EngineError> {
        self.refuse_helix()?;
        let [tip, _] = self.roundings(options);
        let surfaces = self.flanks_with(tip, &self.modifications)?.map(|flank| flank as Arc<dyn Profile>);
        Ok(RigidStructure::new(surfaces.to_vec(), self.gear.teeth()))
    }

    /// Closed-form model of the gear in slices.
    ///
    /// # Errors
    /// E0677: the modified flanks do not fit.
    pub(crate) fn analytic_solid(&self, options: &StructureOptions) -> Result<AnalyticSolid, EngineError> {
        let surfaces = self.surfaces(options)?.map(|surface| surface as Arc<dyn Surface>);
        let (shape, face) = (self.tooth_shape(options)?, [self.face_width, self.twist_per_length()]);
        Ok(AnalyticSolid::new(surfaces.to_vec(), &shape, face, self.material))
    }

    /// Rigid flanks in three dimensions, without compliance.
    ///
    /// # Errors
    /// As [`GearPrototype::analytic_solid`].
    pub(crate) fn rigid_solid(&self, options: &StructureOptions) -> Result<HalfSpaceBody, EngineError> {
        let surfaces = self.surfaces(options)?.map(|surface| surface as Arc<dyn Surface>);
        Ok(HalfSpaceBody::rigid(surfaces.to_vec(), self.gear.teeth()))
    }

    /// Dimensions of the tooth of the plain gear for the closed-form models. Helical teeth use the
    /// normal section, on the ring of the transverse one.
    pub(crate) fn tooth_shape(&self, options: &StructureOptions) -> Result<ToothShape, EngineError> {
        let form = self.form();
        let sense = form.sense();
        let [tip, _] = self.roundings(options);
        let [flank, _] = self.flanks_with(tip, &[])?;
        let fillet = self.gear.root_fillet(Side::CounterClockwise);
        let lean = math::cos(self.helix.angle());
        let foot = inclined(&fillet, lean * sense, FOOT);
        let [x, y] = fillet.at(foot).position;
        let ring = RingShape {
            radius: x.hypot(y),
            fixed_radius: self.rim.ring_radius(),
            half_arc: math::atan2(y, x),
            lean,
            sectors: form.teeth,
        };
        let root = ring.root();
        let section = options.stresses.then(|| {
            let s = inclined(&fillet, lean * sense, CRITICAL[usize::from(form.internal)]);
            let point = fillet.at(s);
            let ([x, y], [out, across]) = (point.position, point.normal);
            CriticalSection {
                at: sense * (x - root),
                chord: 2.0 * lean * y,
                // Radius of curvature of the fillet curve, compressed across the tooth by
                // this factor.
                notch_radius: across.hypot(lean * out).powi(3) / (lean * point.curvature.abs()),
                s,
                position: point.position,
            }
        });
        let depths =
            depths(&fillet, foot, &flank, sense, root).into_iter().map(|[at, half]| [at, lean * half]);
        Ok(ToothShape { sense, depths: depths.collect(), ring, section })
    }
}

/// Angle between the fillet's tangent and the tooth's centreline. For helical teeth `sense`
/// includes the cosine of the helix angle, which gives the angle in the normal section.
fn inclination(fillet: &RootFillet, sense: f64, s: f64) -> f64 {
    let [x, y] = fillet.at(s).normal;
    math::atan2(sense * x, y)
}

/// Arc length on a fillet at which its tangent has an inclination; one of the ends if there is
/// none.
fn inclined(fillet: &RootFillet, sense: f64, angle: f64) -> f64 {
    let [mut low, mut high] = [0.0, fillet.fillet_length()];
    if inclination(fillet, sense, high) <= angle {
        return high;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        *(if inclination(fillet, sense, middle) < angle { &mut low } else { &mut high }) = middle;
    }
    high
}

/// Half-thicknesses of the tooth from its foot to the start of its tip edge, in m, over the
/// distance from the root, in m.
fn depths(fillet: &RootFillet, foot: f64, flank: &Flank, sense: f64, root: f64) -> Vec<[f64; 2]> {
    let [on_fillet, on_flank] = STATIONS;
    let part = |k: usize, of: usize| k as f64 / of as f64;
    let up_fillet = (0..=on_fillet).map(|k| fillet.at(foot * (1.0 - part(k, on_fillet))).position);
    let [edge, _] = flank.edge_range();
    let up_flank = (1..=on_flank).map(|k| flank.at(edge * part(k, on_flank)).position);
    let mut depths: Vec<[f64; 2]> = vec![[0.0, fillet.at(foot).position[1]]];
    depths
        .extend(up_fillet.chain(up_flank).map(|[x, y]| [sense * (x - root), y]).filter(|[at, _]| *at > 0.0));
    depths
}
