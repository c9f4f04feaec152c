//! Three-dimensional flank of a tooth: the transverse profile of [`Flank`] swept along the axis and
//! rotated by the helix.
//!
//! Transverse sections contain profile modifications exactly as the plane flank does, including the
//! tip edge. A lead modification removes an amount `h(v)` from the involute that does not depend on
//! the profile, measured in the transverse section like all amounts. The result is the same
//! involute rotated by `h / (base radius)`, and tip edges rotate with it. With `F(u)` the modified
//! profile and `T(angle)` a rotation about the axis, the surface is
//!
//! `Q(u, v) = T(k v - side h(v) / r) F(u) + v e_z`,
//!
//! with tangents and normal in closed form. A topography is an additional offset along the
//! section's normal. `u` is the arc length of the *plain* profile: coordinates on the surface are
//! those of the body without modifications, whose mesh serves all modifications.

use crate::fillet::Side;
use crate::flank::Flank;
use crate::modification::LeadModification;
use calyx_abi::math;
use calyx_runtime::profile::{Profile, ProfilePoint};
use calyx_runtime::surface::{Surface, SurfacePoint};
use std::sync::Arc;

/// Fraction of the flank's roll range over which the tip edge of the modified profile is mapped to
/// the plain one's.
const STRETCHED: f64 = 0.15;

/// Flank of tooth 0 in the gear's frame. `u` is the arc length along its plain transverse profile
/// from the form circle over the rounded tip edge, m; `v` the distance from mid-face along +z, m.
#[derive(Clone, Debug)]
pub struct GearSurface {
    plain: Arc<Flank>,
    modified: Arc<Flank>,
    face_width: f64,
    /// Counter-clockwise rotation of sections per length along the axis, rad/m.
    twist: f64,
    lead: LeadModification,
    breaks: Vec<f64>,
}

/// Point of the transverse profile, and the derivative of its arc length by that of the plain
/// profile.
struct Section {
    point: ProfilePoint,
    stretch: f64,
}

impl GearSurface {
    /// Creates a flank from its profiles without and with modifications, which agree in everything
    /// else. `twist` is the counter-clockwise rotation of sections per length along +z, rad/m:
    /// positive for a right-hand helix.
    pub fn new(
        plain: Arc<Flank>,
        modified: Arc<Flank>,
        face_width: f64,
        twist: f64,
        lead: LeadModification,
    ) -> GearSurface {
        // A helix slope deviation changes the twist.
        let twist = twist + lead.helix_slope / (face_width * plain.base_radius());
        let mut surface = GearSurface { plain, modified, face_width, twist, lead, breaks: Vec::new() };
        surface.breaks = surface.modified.breaks().iter().map(|&s| surface.plain_length(s)).collect();
        surface
    }

    /// Amount that the twist and the topographies remove at a point beyond their profile at
    /// mid-face, m, and its derivatives by `u` and `v`. The modified profile contains the profile
    /// at mid-face. The roll angle is extrapolated in proportion to the length on the tip edge and
    /// below the form circle.
    fn off(&self, u: f64, v: f64) -> [f64; 3] {
        if !self.lead.varies_over_both() {
            return [0.0; 3];
        }
        let on_flank = u.clamp(0.0, self.plain.edge_range()[0]);
        let plain_roll = self.plain.roll_at(on_flank);
        let per_length = 1.0 / self.plain.speed(plain_roll);
        let roll = plain_roll + (u - on_flank) * per_length;
        let sense = plain_roll.signum();
        let twist = self.twist_off(roll, v);
        let twist = [twist[0], per_length * twist[1], twist[2]];
        self.lead.topographies.iter().fold(twist, |[amount, by_u, by_v], topography| {
            let [off, by_roll, along] = topography.beyond_mid_face(roll.abs(), v);
            [amount + off, by_u + sense * per_length * by_roll, by_v + along]
        })
    }

    /// Amount that the twist removes at a roll angle and an axial position, m, and its derivatives.
    fn twist_off(&self, roll: f64, v: f64) -> [f64; 3] {
        let [part, rate] = self.plain.part_of_profile(roll);
        let per_length = -self.lead.flank_twist / self.face_width;
        [per_length * v * (part - 0.5), per_length * v * rate, per_length * (part - 0.5)]
    }

    /// Difference of the roll angles of the modified and the plain profile at the tip edge, and the
    /// plain roll angle from which on they differ.
    fn shift(&self) -> (f64, f64) {
        let (plain, modified) = (self.plain.edge_roll(), self.modified.edge_roll());
        (modified - plain, plain - STRETCHED * (plain - self.plain.form_roll()))
    }

    /// Roll angle on the modified profile for one on the plain profile, and its derivative.
    fn modified_roll(&self, plain: f64) -> [f64; 2] {
        let (ahead, from) = self.shift();
        let range = self.plain.edge_roll() - from;
        let part = ((plain - from) / range).max(0.0);
        [plain + ahead * part * part, 1.0 + 2.0 * ahead * part / range]
    }

    /// Arc length of the plain profile that corresponds to one of the modified profile up to its
    /// tip edge.
    fn plain_length(&self, s: f64) -> f64 {
        if s >= self.modified.edge_range()[0] {
            return self.plain.edge_range()[0];
        }
        let roll = self.modified.roll_at(s);
        let mut plain = roll;
        // Newton's method: the map differs from the identity by less than a hundredth.
        for _ in 0..8 {
            let [at, slope] = self.modified_roll(plain);
            plain -= (at - roll) / slope;
        }
        self.plain.s_at_roll(plain)
    }

    fn section(&self, u: f64) -> Section {
        let ([plain_edge, plain_end], [edge, end]) = (self.plain.edge_range(), self.modified.edge_range());
        if u > plain_end {
            return Section { point: self.modified.at(end + (u - plain_end)), stretch: 1.0 };
        }
        if u > plain_edge {
            let stretch = (end - edge) / (plain_end - plain_edge);
            return Section { point: self.modified.at(edge + stretch * (u - plain_edge)), stretch };
        }
        let plain_roll = self.plain.roll_at(u.max(0.0));
        let [roll, rate] = self.modified_roll(plain_roll);
        let (point, speed) = self.modified.at_roll(roll);
        let stretch = speed * rate / self.plain.speed(plain_roll);
        if u >= 0.0 {
            Section { point, stretch }
        } else {
            Section { point: self.modified.at(stretch * u), stretch }
        }
    }

    /// Rotation of the section at an axial position, and its derivative.
    fn turn(&self, v: f64) -> [f64; 2] {
        let [amount, slope] = self.lead.amount(v, self.face_width);
        let inwards = match self.plain.side() {
            Side::CounterClockwise => -1.0 / self.plain.base_radius(),
            Side::Clockwise => 1.0 / self.plain.base_radius(),
        };
        [self.twist * v + inwards * amount, self.twist + inwards * slope]
    }
}

impl GearSurface {
    /// Material removed from the involute helicoid at a roll angle (signed as in
    /// [`crate::gear::ToothForm`]) and a distance from mid-face (m), m: the sum of all
    /// modifications of the flank.
    pub fn amount_at(&self, roll: f64, v: f64) -> f64 {
        // The helix slope deviation rotates counter-clockwise towards +z.
        let helix = self.lead.helix_slope * v / self.face_width;
        let outwards = match self.plain.side() {
            Side::CounterClockwise => helix,
            Side::Clockwise => -helix,
        };
        let topographies =
            self.lead.topographies.iter().map(|topography| topography.beyond_mid_face(roll.abs(), v)[0]);
        self.modified.amount_at(roll) + self.lead.amount(v, self.face_width)[0] - outwards
            + self.twist_off(roll, v)[0]
            + topographies.sum::<f64>()
    }
}

impl Surface for GearSurface {
    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.plain.length()], [-0.5 * self.face_width, 0.5 * self.face_width]]
    }

    fn is_extruded(&self) -> bool {
        true
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let Section { point: ProfilePoint { position, tangent, normal, curvature }, stretch } =
            self.section(u);
        let [off, off_by_u, off_by_v] = self.off(u, v);
        let [angle, rate] = self.turn(v);
        let (sine, cosine) = math::sincos(angle);
        let turned = |[x, y]: [f64; 2], z: f64| [cosine * x - sine * y, sine * x + cosine * y, z];
        // In the section: the point, and the tangents along the profile and along the face.
        let [x, y] = [0, 1].map(|axis| position[axis] - off * normal[axis]);
        let along = stretch * (1.0 - off * curvature);
        let along_profile = [0, 1].map(|axis| along * tangent[axis] - off_by_u * normal[axis]);
        let along_face = [-rate * y - off_by_v * normal[0], rate * x - off_by_v * normal[1]];
        let own = [0, 1].map(|axis| along * normal[axis] + off_by_u * tangent[axis]);
        // Faster than `hypot`, whose range is not needed.
        let size = (own[0] * own[0] + own[1] * own[1]).sqrt();
        let normal = own.map(|part| part / size);
        let lean = normal[0] * along_face[0] + normal[1] * along_face[1];
        let length = (1.0 + lean * lean).sqrt();
        SurfacePoint {
            position: turned([x, y], v),
            tangents: [turned(along_profile, 0.0), turned(along_face, 1.0)],
            normal: turned(normal.map(|part| part / length), -lean / length),
        }
    }

    fn breaks(&self) -> &[f64] {
        &self.breaks
    }

    fn edge_from(&self) -> Option<f64> {
        self.plain.edge_from()
    }
}
