//! Test surfaces: an arc of a circle, or a line, in the transverse plane, extruded along the z axis
//! with a rotation; and other surfaces in mapped coordinates.

use crate::surface::{Surface, SurfacePoint};
use calyx_numerics::vec3::{cross, dot, scaled, unit};

/// Convex, with the material on the left of its arc.
pub struct ScrewedArc {
    /// Rotation per axial length, rad/m.
    pub rate: f64,
    pub start: [f64; 2],
    /// Direction of the arc at its start, and 1 / radius.
    pub angle: f64,
    pub curvature: f64,
    pub length: f64,
    pub range: [f64; 2],
}

impl ScrewedArc {
    /// Returns a plane outwards from the z axis, parallel to it.
    pub fn straight(range: [f64; 2]) -> Self {
        Self { rate: 0.0, start: [0.05, 0.002], angle: 0.1, curvature: 0.0, length: 0.01, range }
    }

    /// Returns a surface like the flank of a gear of 50 mm radius, with this tangent of the helix
    /// angle.
    pub fn flank(tangent: f64, range: [f64; 2]) -> Self {
        Self {
            rate: tangent / 0.05,
            start: [0.046, 0.002],
            angle: -0.1,
            curvature: 60.0,
            length: 0.01,
            range,
        }
    }

    pub fn position(&self, u: f64, v: f64) -> [f64; 3] {
        self.at(u, v).position
    }
}

impl Surface for ScrewedArc {
    fn range(&self) -> [[f64; 2]; 2] {
        [[0.0, self.length], self.range]
    }

    fn is_extruded(&self) -> bool {
        true
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let turned = self.angle + self.curvature * u;
        let (sin, cos) = turned.sin_cos();
        // Chord without cancellation where the arc is straight.
        let half = 0.5 * self.curvature * u;
        let chord = if half == 0.0 { u } else { u * half.sin() / half };
        let (chord_sin, chord_cos) = (self.angle + half).sin_cos();
        let [x, y] = [self.start[0] + chord * chord_cos, self.start[1] + chord * chord_sin];
        let (twist_sin, twist_cos) = (self.rate * v).sin_cos();
        let turn = |[x, y]: [f64; 2]| [twist_cos * x - twist_sin * y, twist_sin * x + twist_cos * y];
        let ([x, y], [tx, ty]) = (turn([x, y]), turn([cos, sin]));
        let tangents = [[tx, ty, 0.0], [-self.rate * y, self.rate * x, 1.0]];
        let [a, b] = tangents;
        let across = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let size = (across[0] * across[0] + across[1] * across[1] + across[2] * across[2]).sqrt();
        SurfacePoint { position: [x, y, v], tangents, normal: across.map(|part| part / size) }
    }
}

/// Surface in other coordinates and at other positions.
pub struct MappedSurface<S> {
    pub base: S,
    /// Ranges of its own coordinates.
    pub range: [[f64; 2]; 2],
    /// Coordinates on the base of its own ones.
    pub coordinates: fn([f64; 2]) -> [f64; 2],
    /// Map of positions that preserves the orientation.
    pub map: fn([f64; 3]) -> [f64; 3],
}

impl<S: Surface> MappedSurface<S> {
    pub fn position(&self, u: f64, v: f64) -> [f64; 3] {
        let [u, v] = (self.coordinates)([u, v]);
        (self.map)(self.base.at(u, v).position)
    }
}

impl<S: Surface> Surface for MappedSurface<S> {
    fn range(&self) -> [[f64; 2]; 2] {
        self.range
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        // Differences of fourth order.
        let step = self.range.map(|[from, to]| 1e-3 * (to - from));
        let slope = |shift: [f64; 2]| {
            let at = |k: f64| self.position(u + k * shift[0], v + k * shift[1]);
            let [far, near, next, last] = [-2.0, -1.0, 1.0, 2.0].map(at);
            [0, 1, 2]
                .map(|k| (8.0 * (next[k] - near[k]) - (last[k] - far[k])) / (12.0 * (shift[0] + shift[1])))
        };
        let tangents = [slope([step[0], 0.0]), slope([0.0, step[1]])];
        let [x, y] = (self.coordinates)([u, v]);
        let base = self.base.at(x, y);
        let across = cross(tangents[0], tangents[1]);
        let sign = dot(cross(base.tangents[0], base.tangents[1]), base.normal).signum();
        SurfacePoint { position: self.position(u, v), tangents, normal: unit(scaled(across, sign)) }
    }
}
