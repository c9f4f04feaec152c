//! Gears with tabulated teeth without a mesh: the dimensions of their sections that the closed-form
//! models use. Theory: `docs/theory/analytic-compliance.md`.

use super::prototype::TabulatedGear;
use super::solid_mesh::Bore;
use super::surface::TabulatedSurface;
use super::tooth::{CurvePoint, Tooth};
use crate::analytic::{CRITICAL, FOOT, HALVINGS};
use calyx_abi::math;
use calyx_runtime::error::EngineError;
use calyx_runtime::scene::StructureOptions;
use calyx_runtime::structure::analytic::{
    CriticalSection, RingShape, RootStation, SectionedSurface, TaperedSolid, ToothSection,
};
use calyx_runtime::vec3::dot;
use std::sync::Arc;

/// Number of sections along the face.
const SECTIONS: usize = 17;
/// Numbers of points of the profile of a section along a fillet and along a flank.
const POINTS: [usize; 2] = [48, 48];
/// Largest number of teeth in a full circle of the developed section. The sections of crown gears
/// are racks; a ring this large differs from one by a part of the rim's thickness in its radius.
const MOST_IN_CIRCLE: f64 = 1000.0;
/// Iterations for the inclination of the tooth, which depends on the root that depends on it.
const ITERATIONS: usize = 4;
/// Part of the fillet over which its curvature is averaged.
const CURVED: f64 = 0.03;

impl TabulatedGear {
    /// Teeth and rim in closed form.
    ///
    /// # Errors
    /// The tip edge of the options does not fit.
    pub(super) fn analytic(&self, options: &StructureOptions) -> Result<TaperedSolid, EngineError> {
        self.analytic_with(options, SECTIONS)
    }

    /// The same with a number of sections along the face.
    pub(super) fn analytic_with(
        &self,
        options: &StructureOptions,
        count: usize,
    ) -> Result<TaperedSolid, EngineError> {
        let flanks = self.surfaces(options)?;
        let tooth = self.tooth_of(options)?;
        let [from, to] = tooth.face;
        let sections: Vec<ToothSection> = (0..count)
            .map(|k| from + (to - from) * k as f64 / (count - 1).max(1) as f64)
            .map(|v| Section::new(&tooth, &flanks, v).dimensions(self.bore(), options.stresses))
            .collect();
        let flanks = flanks.map(|flank| flank as Arc<dyn SectionedSurface>);
        Ok(TaperedSolid::new(flanks, &sections, part(&tooth), self.data.material))
    }
}

/// Part of the full circle that the teeth take in a developed section.
fn part(tooth: &Tooth) -> f64 {
    tooth.cones.radial_angle(1.0).max(f64::from(tooth.teeth) / MOST_IN_CIRCLE)
}

/// Section of a tooth, with the frame of its normal section.
struct Section<'a> {
    tooth: &'a Tooth,
    v: f64,
    rise: f64,
    lean: f64,
    root: [f64; 2],
    radial: f64,
    tilt: f64,
    /// Coordinates of the feet on the fillets.
    feet: [f64; 2],
    ring_radius: f64,
    half_arc: f64,
    foot_height: f64,
}

fn rotated([x, y]: [f64; 2], angle: f64) -> [f64; 2] {
    let (sine, cosine) = math::sincos(angle);
    [cosine * x - sine * y, sine * x + cosine * y]
}

impl<'a> Section<'a> {
    fn new(tooth: &'a Tooth, flanks: &[Arc<TabulatedSurface>; 2], v: f64) -> Self {
        // The flanks of a tapering tooth diverge; the tooth follows their mean.
        let slope = |side: usize| {
            let on = flanks[side].in_section(0.5 * tooth.edge_from(side), v);
            let along = on.point.tangents[1];
            dot(along, on.axes[1]) / dot(along, on.axes[2])
        };
        let rise = 0.5 * (slope(0) + slope(1));
        let mut section = Self {
            tooth,
            v,
            rise,
            lean: 1.0f64.hypot(rise).recip(),
            root: [0.0; 2],
            radial: 0.0,
            tilt: 0.0,
            feet: [0.0; 2],
            ring_radius: 0.0,
            half_arc: 0.0,
            foot_height: 0.0,
        };
        for _ in 0..ITERATIONS {
            section.place_root();
            let [left, right] = [0, 1].map(|side| section.local(section.tip(side)));
            let [x, y] = rotated([0.5 * (left[0] + right[0]), 0.5 * (left[1] + right[1])], section.tilt);
            section.tilt = math::atan2(y, x);
        }
        section
    }

    /// Finds the feet of the tooth and the arc of the ring between them.
    fn place_root(&mut self) {
        let (tooth, cones) = (self.tooth, &self.tooth.cones);
        let along = tooth.along(self.v);
        self.feet = [0, 1].map(|side| self.inclined(side, FOOT));
        let [left, right] =
            [0, 1].map(|side| cones.rolled(along, tooth.fillet_at(side, self.feet[side], self.v).position));
        self.foot_height = 0.5 * (left[0] + right[0]);
        let (middle, half) = (0.5 * (left[1] + right[1]), 0.5 * (left[1] - right[1]));
        let part = part(tooth);
        self.ring_radius = cones.radius(along, self.foot_height) / part;
        self.half_arc = part * half;
        self.radial = cones.radial_angle(middle);
        // The centre of the arc for transverse forces, see `RingShape::root`.
        let below = self.ring_radius * (1.0 - math::sin(self.half_arc) / self.half_arc);
        let [x, y] = cones.developed(along, self.foot_height, middle);
        let (sine, cosine) = math::sincos(self.radial);
        self.root = [x - below * cosine, y - below * sine];
    }

    fn tip(&self, side: usize) -> [f64; 2] {
        self.tooth.flank_at(side, self.tooth.edge_from(side), self.v).position
    }

    /// Direction of the section in the normal section.
    fn direction(&self, direction: [f64; 2]) -> [f64; 2] {
        let [x, y] = rotated(direction, -self.radial);
        rotated([x, self.lean * y], -self.tilt)
    }

    /// Point of the section in the normal section, relative to the middle of the root.
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        self.direction([x - self.root[0], y - self.root[1]])
    }

    fn fillet(&self, side: usize, w: f64) -> CurvePoint {
        self.tooth.fillet_at(side, w, self.v)
    }

    /// Angle between the tangent of a fillet and the centre line of the tooth.
    fn inclination(&self, side: usize, w: f64) -> f64 {
        let [x, y] = self.direction(self.fillet(side, w).by_u);
        // Fillets run from the flank to the root, and away from the centre line.
        math::atan2(if side == 0 { y } else { -y }, -x)
    }

    /// Coordinate on a fillet at which its tangent has an inclination; one of the ends if there is
    /// none.
    fn inclined(&self, side: usize, angle: f64) -> f64 {
        let [mut low, mut high] = [0.0, self.tooth.fillet_length(side)];
        if self.inclination(side, high) <= angle {
            return high;
        }
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            *(if self.inclination(side, middle) < angle { &mut low } else { &mut high }) = middle;
        }
        high
    }

    /// Profile of a side from its foot to the tip edge: distances along and across the centre line,
    /// ascending.
    fn profile(&self, side: usize) -> Vec<[f64; 2]> {
        let [on_fillet, on_flank] = POINTS;
        let part = |k: usize, of: usize| k as f64 / of as f64;
        let fillet =
            (0..=on_fillet).map(|k| self.fillet(side, self.feet[side] * (1.0 - part(k, on_fillet))).position);
        let end = self.tooth.edge_from(side);
        let flank =
            (1..=on_flank).map(|k| self.tooth.flank_at(side, end * part(k, on_flank), self.v).position);
        let mut profile: Vec<[f64; 2]> = Vec::new();
        for [along, across] in fillet.chain(flank).map(|point| self.local(point)) {
            if profile.last().is_none_or(|last| along > last[0]) {
                profile.push([along, if side == 0 { across } else { -across }]);
            }
        }
        profile
    }

    /// Half of the thickness over the distance from the root.
    fn depths(&self) -> Vec<[f64; 2]> {
        let profiles = [0, 1].map(|side| self.profile(side));
        let end = |profile: &Vec<[f64; 2]>| profile[profile.len() - 1][0];
        let height = 0.5 * (end(&profiles[0]) + end(&profiles[1]));
        let count = POINTS[0] + POINTS[1];
        let at = |k: usize| {
            // Dense next to the root, where the fillet widens.
            let part = k as f64 / count as f64;
            let along = height * part * part;
            let [left, right] = [0, 1].map(|side| interpolated(&profiles[side], along));
            [along, 0.5 * (left + right)]
        };
        (0..=count).map(at).collect()
    }

    fn critical(&self) -> [RootStation; 2] {
        let [left, right] = [0, 1].map(|side| self.inclined(side, CRITICAL[0]));
        let points = [(0, left), (1, right)].map(|(side, w)| self.local(self.fillet(side, w).position));
        let chord = (points[0][0] - points[1][0]).hypot(points[0][1] - points[1][1]);
        [(0, left), (1, right)].map(|(side, w)| {
            let [x, y, z] = self.tooth.placed(self.v, self.fillet(side, w).position).position;
            let section = CriticalSection {
                at: points[side][0],
                chord,
                notch_radius: self.notch_radius(side, w),
                s: w,
                position: points[side],
            };
            RootStation { section, place: [w, self.v], position: [x, y, z] }
        })
    }

    /// Radius of curvature of a fillet in the normal section.
    fn notch_radius(&self, side: usize, w: f64) -> f64 {
        let length = self.tooth.fillet_length(side);
        let [low, high] =
            [w - 0.5 * CURVED * length, w + 0.5 * CURVED * length].map(|w| w.clamp(0.0, length));
        let [from, to] = [low, high].map(|w| self.local(self.fillet(side, w).position));
        let chord = (to[0] - from[0]).hypot(to[1] - from[1]);
        let turned = self.inclination(side, high) - self.inclination(side, low);
        // A straight part is no notch; the factor of the standard is limited.
        chord / turned.max(1e-9)
    }

    fn dimensions(&self, bore: &Bore, stresses: bool) -> ToothSection {
        let thickness = self.foot_height - bore.at(self.v);
        let ring = RingShape {
            radius: self.ring_radius,
            fixed_radius: self.ring_radius - thickness,
            half_arc: self.half_arc,
            lean: self.lean,
            sectors: self.tooth.teeth,
        };
        ToothSection {
            root: self.root,
            radial: self.radial,
            tilt: self.tilt,
            rise: self.rise,
            depths: self.depths(),
            ring,
            critical: stresses.then(|| self.critical()),
        }
    }
}

/// Value of an ascending list of distances and values, constant beyond its ends.
fn interpolated(list: &[[f64; 2]], at: f64) -> f64 {
    let next = list.partition_point(|[distance, _]| *distance <= at).clamp(1, list.len() - 1);
    let ([from, low], [to, high]) = (list[next - 1], list[next]);
    low + ((at - from) / (to - from)).clamp(0.0, 1.0) * (high - low)
}

#[cfg(test)]
mod tests;
