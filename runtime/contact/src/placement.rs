//! Plane rigid motions: where bodies are, and the frame in which a patch acts on them.

/// Where a profile lies: turned counter-clockwise, then shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    cosine: f64,
    sine: f64,
    /// Where the origin of the profile's coordinates goes, m.
    origin: [f64; 2],
}

impl Placement {
    /// Turned by `angle` (rad) about its own origin, which is put at `origin` (m).
    pub fn new(angle: f64, origin: [f64; 2]) -> Self {
        let (sine, cosine) = angle.sin_cos();
        Self { cosine, sine, origin }
    }

    /// The placement of a part that is first turned by `angle` in the coordinates placed here: a tooth of its gear.
    pub fn turned_first(&self, angle: f64) -> Self {
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

/// The frame of a contact patch: reference point, common normal and tangent.
///
/// A patch acts on the rigid freedoms of its bodies through this one line for all its cells. Action then equals
/// reaction exactly, and the arms of an involute pair are its base radii exactly. The couple left out is of second
/// order, and taking each cell at its own offset along the tangent without also turning its normal would *introduce* an
/// error: on an involute every normal is tangent to the base circle, so the arm of a cell's own normal is the base
/// radius wherever the cell lies; the arm's change by the offset and by the turn of the normal cancel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactFrame {
    /// Midway between the two surfaces, m.
    pub point: [f64; 2],
    /// Unit vector out of the first body, into the second.
    pub normal: [f64; 2],
    /// Unit vector, the normal turned clockwise: (tangent, normal) is right-handed.
    pub tangent: [f64; 2],
}

impl ContactFrame {
    /// Growth of the gap per unit counter-clockwise rotation of a body about `center`; `side` is 0 for
    /// the first body and 1 for the second. m/rad.
    pub fn rotation_arm(&self, side: usize, center: [f64; 2]) -> f64 {
        let [x, y] = [self.point[0] - center[0], self.point[1] - center[1]];
        let along_normal = self.normal[1] * x - self.normal[0] * y;
        if side == 0 { -along_normal } else { along_normal }
    }

    /// Growth of the gap per unit translation of a body along `direction` (unit vector).
    pub fn translation_arm(&self, side: usize, direction: [f64; 2]) -> f64 {
        let along_normal = dot(self.normal, direction);
        if side == 0 { -along_normal } else { along_normal }
    }
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}
