//! Plane rigid placements, and the frame in which a patch acts on its bodies.

use calyx_numerics::vec2::dot;

/// Placement of a profile: counter-clockwise rotation, then translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    cosine: f64,
    sine: f64,
    /// Image of the origin of the profile's coordinates, m.
    origin: [f64; 2],
}

impl Placement {
    /// Creates a rotation by `angle` (rad) about the profile's origin and a translation of it to
    /// `origin` (m).
    pub fn new(angle: f64, origin: [f64; 2]) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self { cosine, sine, origin }
    }

    /// Composes the placement with a preceding rotation by `angle`, like that of a tooth in its
    /// gear.
    pub fn rotated_first(&self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let [turned_x, turned_y] = self.direction([cosine, sine]);
        Self { cosine: turned_x, sine: turned_y, origin: self.origin }
    }

    /// Maps a point from the profile's own coordinates, m.
    pub fn point(&self, p: [f64; 2]) -> [f64; 2] {
        let [x, y] = self.direction(p);
        [x + self.origin[0], y + self.origin[1]]
    }

    /// Rotates a direction from the profile's own axes.
    pub fn direction(&self, v: [f64; 2]) -> [f64; 2] {
        [self.cosine * v[0] - self.sine * v[1], self.sine * v[0] + self.cosine * v[1]]
    }

    /// Returns the position of the origin of the profile's coordinates, m.
    pub fn origin(&self) -> [f64; 2] {
        self.origin
    }
}

/// Frame of a contact patch: reference point, common normal and tangent.
///
/// All cells of a patch act on the rigid-body DOFs through this one line. Action then equals
/// reaction exactly, and the arms of an involute pair are exactly its base radii. The neglected
/// couple is of second order. Using the tangential offset of each cell without also rotating its
/// normal would *introduce* an error: every normal of an involute is tangent to the base circle, so
/// the arm of a cell's own normal is the base radius everywhere, and the effects of the offset and
/// of the rotated normal cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactFrame {
    /// Midpoint between the two surfaces, m.
    pub point: [f64; 2],
    /// Unit normal, out of the first body and into the second.
    pub normal: [f64; 2],
    /// Unit tangent, the normal rotated clockwise: (tangent, normal) is right-handed.
    pub tangent: [f64; 2],
}

impl ContactFrame {
    /// Returns the growth of the gap per unit counter-clockwise rotation of a body about `center`,
    /// m/rad; `side` is 0 for the first body and 1 for the second.
    pub fn rotation_arm(&self, side: usize, center: [f64; 2]) -> f64 {
        let [x, y] = [self.point[0] - center[0], self.point[1] - center[1]];
        let along_normal = self.normal[1] * x - self.normal[0] * y;
        if side == 0 { -along_normal } else { along_normal }
    }

    /// Returns the growth of the gap per unit translation of a body along `direction` (unit
    /// vector).
    pub fn translation_arm(&self, side: usize, direction: [f64; 2]) -> f64 {
        let along_normal = dot(self.normal, direction);
        if side == 0 { -along_normal } else { along_normal }
    }
}
