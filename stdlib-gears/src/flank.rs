//! Flank of a tooth with its modifications, from the form circle over the tip edge, as the contact
//! solver uses it.
//!
//! Let `u(b)` and `v(b)` be the radial and the counter-clockwise unit vectors at angle `b`. The
//! involute of the base circle `r` at roll angle `g` is `r u + r g v` with
//! `b = (half angle at the base) - g`; its tangent is `u` and its outward normal `v`. A
//! modification of amount `a(g)` moves the point by `-a v`, so that `dP/dg = (r g - a) u - a' v`.
//! Tangent, normal and curvature follow exactly. On an internal gear the roll angle is negative
//! ([`ToothForm`]): `u` then points against the direction of the flank, and `v` still points out of
//! the material.

use crate::deviation::CubicSpline;
use crate::error::GeometryError;
use crate::fillet::Side;
use crate::gear::ToothForm;
use crate::modification::{Modification, ProfilePart, TipRelief};
use crate::relief::{PlacedRelief, check_depth};
use crate::root_finding::solve_bracketed;
use calyx_abi::math;
use calyx_runtime::fe::quadrature::gauss_legendre;
use calyx_runtime::profile::{Profile, ProfilePoint};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

/// Number of parts into which a flank with deviations is divided to measure its length.
const DEVIATED_PARTS: usize = 16;

/// Flank of a tooth in tooth coordinates (gear centre at the origin, tooth centreline along +x),
/// metres.
///
/// The arc length increases from the form circle to the tip circle. Below the form circle the
/// profile continues straight along its tangent; beyond the tip edge it continues along the tip
/// circle.
#[derive(Clone, Debug)]
pub struct Flank {
    side: Side,
    /// +1, or -1 for an internal gear.
    sense: f64,
    base_radius: f64,
    half_base_angle: f64,
    form_roll: f64,
    tip_roll: f64,
    reliefs: Vec<PlacedRelief>,
    deviations: Vec<Arc<CubicSpline>>,
    /// Profile slope deviation: material removed per roll angle from the form circle.
    slope: f64,
    /// Profile crowning: material removed at the form circle and at the tip circle, m.
    crown: f64,
    /// Parts of the flank with smooth curvature, in ascending order; the first starts at the form
    /// circle.
    parts: Vec<Part>,
    edge: Edge,
    breaks: Vec<f64>,
    /// Quadrature points and weights for the arc length of modified parts.
    quadrature: Vec<(f64, f64)>,
}

#[derive(Clone, Copy, Debug)]
struct Part {
    start_roll: f64,
    start_s: f64,
    modified: bool,
}

/// Rounded tip edge: an arc tangent to the flank and to the tip circle.
#[derive(Clone, Copy, Debug)]
struct Edge {
    centre: [f64; 2],
    radius: f64,
    tip_circle_radius: f64,
    start_roll: f64,
    start_s: f64,
    end_s: f64,
    /// Angle of the normal at the start. The normal rotates clockwise, on an internal gear
    /// counter-clockwise.
    start_angle: f64,
    /// Polar angle at which the arc meets the tip circle.
    end_polar: f64,
}

/// Unit vector at an angle, and the unit vector a right angle further.
fn directions(angle: f64) -> ([f64; 2], [f64; 2]) {
    let (sine, cosine) = math::sincos(angle);
    ([cosine, sine], [-sine, cosine])
}

fn combine(a: f64, u: [f64; 2], b: f64, v: [f64; 2]) -> [f64; 2] {
    [a * u[0] + b * v[0], a * u[1] + b * v[1]]
}

impl Flank {
    /// Creates a flank of a gear. It ignores lead crowning, which a plane model cannot represent.
    /// Reliefs must lie on the flank.
    pub fn new(
        gear: impl Into<ToothForm>,
        modifications: &[Modification],
        side: Side,
    ) -> Result<Self, Vec<GeometryError>> {
        let form: ToothForm = gear.into();
        let (mut reliefs, mut deviations, mut errors) = (Vec::new(), Vec::new(), Vec::new());
        let (mut slope, mut crown) = (0.0, 0.0);
        for modification in modifications.iter().filter(|one| one.applies_to(side, form.internal)) {
            let mut relieve = |relief: TipRelief, at_root: bool| {
                if relief.depth != 0.0 {
                    match relief.placed(&form, at_root) {
                        Ok(relief) => reliefs.push(relief),
                        Err(error) => errors.push(error),
                    }
                }
            };
            match modification.parts().profile {
                Some(ProfilePart::TipRelief(relief)) => relieve(relief, false),
                Some(ProfilePart::RootRelief(relief)) => relieve(relief, true),
                Some(ProfilePart::Slope(deviation)) => {
                    slope -= deviation / (form.tip_roll - form.form_roll);
                }
                Some(ProfilePart::Crown(depth)) => {
                    errors.extend(check_depth(["profile", " crown"], depth, &form).err());
                    crown += depth;
                }
                Some(ProfilePart::Deviation(deviation)) => match deviation.sampled(&form) {
                    Ok(sampled) => deviations.extend(sampled.map(Arc::new)),
                    Err(error) => errors.push(error),
                },
                None => {}
            }
        }
        if !errors.is_empty() {
            return Err(errors);
        }
        let mut flank = Self {
            side,
            sense: form.sense(),
            base_radius: form.base_radius,
            half_base_angle: form.half_base_angle,
            form_roll: form.form_roll,
            tip_roll: form.tip_roll,
            reliefs,
            deviations,
            slope,
            crown,
            parts: Vec::new(),
            edge: Edge {
                centre: [0.0; 2],
                radius: form.tip_edge_radius,
                tip_circle_radius: form.tip_radius,
                start_roll: 0.0,
                start_s: 0.0,
                end_s: 0.0,
                start_angle: 0.0,
                end_polar: 0.0,
            },
            breaks: Vec::new(),
            quadrature: gauss_legendre(16),
        };
        flank.place_edge();
        flank.divide();
        Ok(flank)
    }

    /// Side of the tooth.
    pub fn side(&self) -> Side {
        self.side
    }

    /// Computes the roll angle at which the edge's arc leaves the flank, and the centre of the arc.
    fn place_edge(&mut self) {
        let radius = self.edge.radius;
        let centre_at = |roll: f64| {
            let point = self.on_curve(roll);
            combine(1.0, point.position, -radius, point.normal)
        };
        let tip_centres = self.edge.tip_circle_radius - self.sense * radius;
        let beyond = |roll: f64| {
            let [x, y] = centre_at(roll);
            self.sense * (x.hypot(y) - tip_centres)
        };
        // A relieved flank meets the tip circle slightly later than the involute. An internal flank
        // may not reach its base circle.
        let last = self.tip_roll + (0.5 * (self.tip_roll - self.form_roll)).min(0.9 * self.tip_roll.abs());
        let start_roll = solve_bracketed(beyond, self.form_roll, last);
        let centre = centre_at(start_roll);
        let normal = self.on_curve(start_roll).normal;
        self.edge.start_roll = start_roll;
        self.edge.centre = centre;
        self.edge.start_angle = math::atan2(normal[1], normal[0]);
        self.edge.end_polar = math::atan2(centre[1], centre[0]);
    }

    /// Splits the flank where its curvature is discontinuous, and a flank with deviations finely
    /// enough to measure its parts.
    fn divide(&mut self) {
        let end = self.edge.start_roll;
        let jumps = self.reliefs.iter().flat_map(PlacedRelief::breaks);
        let mut rolls: Vec<(f64, bool)> = jumps.map(|roll| (roll, true)).collect();
        if self.has_deviations() {
            let part = |k: usize| self.form_roll + (end - self.form_roll) * k as f64 / DEVIATED_PARTS as f64;
            rolls.extend((1..DEVIATED_PARTS).map(|k| (part(k), false)));
        }
        rolls.retain(|(roll, _)| (self.form_roll..end).contains(roll));
        rolls.push((self.form_roll, false));
        rolls.sort_by(|a, b| a.0.total_cmp(&b.0));
        rolls.dedup_by(|later, earlier| {
            let same = later.0 == earlier.0;
            earlier.1 |= same && later.1;
            same
        });
        let mut s = 0.0;
        for (index, &(start_roll, jumps)) in rolls.iter().enumerate() {
            let end = rolls.get(index + 1).map_or(end, |next| next.0);
            let modified = self.has_deviations() || self.amount(0.5 * (start_roll + end))[0] != 0.0;
            let part = Part { start_roll, start_s: s, modified };
            self.parts.push(part);
            if index > 0 && jumps {
                self.breaks.push(s);
            }
            s = self.s_in_part(part, end);
        }
        self.breaks.push(s);
        self.edge.start_s = s;
        let turned = match self.sense > 0.0 {
            true => self.edge.start_angle - self.edge.end_polar,
            // At the end the normal points against the radial direction.
            false => (self.edge.end_polar + PI - self.edge.start_angle).rem_euclid(TAU),
        };
        self.edge.end_s = s + self.edge.radius * turned;
    }

    /// Material removed at a roll angle (m), and its first and second derivatives by the roll
    /// angle.
    fn amount(&self, roll: f64) -> [f64; 3] {
        let reliefs = self.reliefs.iter().map(|relief| relief.amount(roll));
        let mut total = [self.slope * (roll - self.form_roll), self.slope, 0.0];
        if self.crown != 0.0 {
            // The parabola is -1 to 1 from the form circle to the tip circle.
            let rate = 2.0 / (self.tip_roll - self.form_roll);
            let part = rate * (roll - self.form_roll) - 1.0;
            total[0] += self.crown * part * part;
            total[1] += 2.0 * self.crown * part * rate;
            total[2] += 2.0 * self.crown * rate * rate;
        }
        for amount in reliefs.chain(self.deviations.iter().map(|deviation| deviation.at(roll))) {
            for order in 0..3 {
                total[order] += amount[order];
            }
        }
        total
    }

    /// Point of the modified involute at a roll angle, on the counter-clockwise side.
    fn on_curve(&self, roll: f64) -> ProfilePoint {
        let [amount, slope, bend] = self.amount(roll);
        let (u, v) = directions(self.half_base_angle - roll);
        let (along, across) = (self.base_radius * roll - amount, -slope);
        let speed = along.hypot(across);
        // The derivatives of `along` and `across` by roll give the rotation of the tangent relative
        // to `u`, which itself rotates by -1.
        let turn = (along * -bend - across * (self.base_radius - slope)) / (speed * speed);
        ProfilePoint {
            position: combine(self.base_radius, u, along, v),
            tangent: combine(along / speed, u, across / speed, v),
            normal: combine(self.sense * along / speed, v, -self.sense * across / speed, u),
            curvature: self.sense * (1.0 - turn) / speed,
        }
    }

    /// Arc length of the modified involute per unit of roll, m.
    pub(crate) fn speed(&self, roll: f64) -> f64 {
        let [amount, slope, _] = self.amount(roll);
        (self.base_radius * roll - amount).hypot(slope)
    }

    fn s_in_part(&self, part: Part, roll: f64) -> f64 {
        let half = 0.5 * (roll - part.start_roll);
        if !part.modified {
            // The involute's arc length is r roll^2 / 2.
            return part.start_s + self.sense * self.base_radius * half * (roll + part.start_roll);
        }
        let middle = part.start_roll + half;
        let integral: f64 =
            self.quadrature.iter().map(|&(x, weight)| weight * self.speed(middle + half * x)).sum();
        part.start_s + half * integral
    }

    /// Arc length at a roll angle between the form circle and the edge, m. Roll angles outside this
    /// range are clamped.
    pub fn s_at_roll(&self, roll: f64) -> f64 {
        let roll = roll.clamp(self.form_roll, self.edge.start_roll);
        let index = self.parts.partition_point(|part| part.start_roll <= roll).max(1) - 1;
        self.s_in_part(self.parts[index], roll)
    }

    /// Roll angle at an arc length, rad. On and beyond the edge, the roll angle of the involute at
    /// the same radius.
    pub fn roll_at(&self, s: f64) -> f64 {
        if s > self.edge.start_s {
            return self.sense * crate::involute::roll_at_radius(self.base_radius, self.radius_at(s));
        }
        if s <= 0.0 {
            return self.form_roll;
        }
        let index = self.parts.partition_point(|part| part.start_s <= s).max(1) - 1;
        let part = self.parts[index];
        let from_start = self.sense * 2.0 * (s - part.start_s) / self.base_radius;
        let unmodified = self.sense * (part.start_roll * part.start_roll + from_start).max(0.0).sqrt();
        if !part.modified {
            return unmodified;
        }
        let mut roll = unmodified;
        // Newton's method needs few steps because reliefs are small compared with the flank.
        for _ in 0..20 {
            let step = (self.s_in_part(part, roll) - s) / self.speed(roll);
            roll -= step;
            if step.abs() <= 4.0 * f64::EPSILON * roll.abs() {
                break;
            }
        }
        roll
    }

    /// Distance from the gear's centre at an arc length, m.
    pub fn radius_at(&self, s: f64) -> f64 {
        let [x, y] = self.at(s).position;
        x.hypot(y)
    }

    /// Point at a roll angle between the form circle and the edge, as [`Profile::at`] returns it at
    /// an arc length, and the arc length of the flank per unit of roll there, m.
    pub(crate) fn at_roll(&self, roll: f64) -> (ProfilePoint, f64) {
        (self.side.place(self.on_curve(roll)), self.speed(roll))
    }

    /// Base radius of the flank's involute, m.
    pub(crate) fn base_radius(&self) -> f64 {
        self.base_radius
    }

    /// Material removed at an arc length, normal to the involute, m. On the edge, that of the
    /// relief alone.
    pub fn relief_at(&self, s: f64) -> f64 {
        self.amount(self.roll_at(s))[0]
    }

    /// Returns whether this flank is modified.
    pub fn is_modified(&self) -> bool {
        !self.reliefs.is_empty() || self.has_deviations()
    }

    /// Returns whether the flank has deviations that may extend over its whole length.
    fn has_deviations(&self) -> bool {
        !self.deviations.is_empty() || self.slope != 0.0 || self.crown != 0.0
    }

    /// Largest amount removed or added between form and tip circle, m.
    pub(crate) fn deepest(&self) -> f64 {
        const STEPS: usize = 64;
        let range = self.tip_roll - self.form_roll;
        let at = |step: usize| self.amount(self.form_roll + range * step as f64 / STEPS as f64)[0].abs();
        if self.is_modified() { (0..=STEPS).map(at).fold(0.0, f64::max) } else { 0.0 }
    }

    /// Material removed at a roll angle, normal to the involute, m.
    pub fn amount_at(&self, roll: f64) -> f64 {
        self.amount(roll)[0]
    }

    /// Position between form circle (0) and tip circle (1) of a roll angle, and its derivative.
    pub(crate) fn part_of_profile(&self, roll: f64) -> [f64; 2] {
        let range = self.tip_roll - self.form_roll;
        [(roll - self.form_roll) / range, 1.0 / range]
    }

    /// Roll angle at the form circle, rad.
    pub fn form_roll(&self) -> f64 {
        self.form_roll
    }

    /// Roll angle below which the flank is unmodified, rad.
    pub(crate) fn first_modified_roll(&self) -> f64 {
        let modified = self.parts.iter().find(|part| part.modified);
        modified.map_or(self.edge.start_roll, |part| part.start_roll)
    }

    /// Roll angle at which the rounded tip edge begins, rad.
    pub fn edge_roll(&self) -> f64 {
        self.edge.start_roll
    }

    /// Arc lengths at which the rounded tip edge begins and ends, m.
    pub fn edge_range(&self) -> [f64; 2] {
        [self.edge.start_s, self.edge.end_s]
    }
}

impl Profile for Flank {
    fn length(&self) -> f64 {
        self.edge.end_s
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let edge = &self.edge;
        let point = if s < 0.0 {
            let form = self.on_curve(self.form_roll);
            ProfilePoint { position: combine(1.0, form.position, s, form.tangent), curvature: 0.0, ..form }
        } else if s <= edge.start_s {
            self.on_curve(self.roll_at(s))
        } else {
            let on_edge = s.min(edge.end_s) - edge.start_s;
            let beyond = (s - edge.end_s).max(0.0) / edge.tip_circle_radius;
            // The tip circle follows. Its normal is radial: outwards, or inwards on an internal
            // gear.
            if beyond > 0.0 {
                let (radial, left) = directions(edge.end_polar - beyond);
                ProfilePoint {
                    position: radial.map(|part| edge.tip_circle_radius * part),
                    tangent: left.map(|part| -part),
                    normal: radial.map(|part| self.sense * part),
                    curvature: self.sense / edge.tip_circle_radius,
                }
            } else {
                let (normal, left) = directions(edge.start_angle - self.sense * on_edge / edge.radius);
                ProfilePoint {
                    position: combine(1.0, edge.centre, edge.radius, normal),
                    tangent: left.map(|part| -self.sense * part),
                    normal,
                    curvature: 1.0 / edge.radius,
                }
            }
        };
        self.side.place(point)
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn edge_from(&self) -> Option<f64> {
        Some(self.edge.start_s)
    }
}
