//! Test surfaces whose contact is known in closed form.

use calyx_structure::surface::{Surface, SurfacePoint};

/// Bottom (facing -z) or top (facing +z) of a body with two principal radii: a paraboloid, or a
/// sphere for equal radii. Its lowest or highest point is the origin.
#[derive(Clone, Copy)]
pub struct Cap {
    pub radii: [f64; 2],
    /// +1 faces +z, -1 faces -z.
    pub faces: f64,
    pub half: [f64; 2],
    /// Rotation of the principal directions, rad.
    pub turn: f64,
}

impl Surface for Cap {
    fn range(&self) -> [[f64; 2]; 2] {
        self.half.map(|half| [-half, half])
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let (sine, cosine) = self.turn.sin_cos();
        let (x, y) = (cosine * u + sine * v, cosine * v - sine * u);
        let [rx, ry] = self.radii;
        // Depth below the apex, and its slopes along the principal directions.
        let (depth, slope_x, slope_y) = if rx == ry {
            let fall = (rx * rx - x * x - y * y).sqrt();
            ((x * x + y * y) / (rx + fall), x / fall, y / fall)
        } else {
            (0.5 * (x * x / rx + y * y / ry), x / rx, y / ry)
        };
        let (slope_u, slope_v) = (cosine * slope_x - sine * slope_y, sine * slope_x + cosine * slope_y);
        let size = (1.0 + slope_u * slope_u + slope_v * slope_v).sqrt();
        SurfacePoint {
            position: [u, v, -self.faces * depth],
            tangents: [[1.0, 0.0, -self.faces * slope_u], [0.0, 1.0, -self.faces * slope_v]],
            normal: [slope_u / size, slope_v / size, self.faces / size],
        }
    }
}

/// Involute helicoid of a base cylinder about the z axis, optionally rounded at the tip: u is the
/// roll angle times the base radius, v the axial coordinate. Its outward normal points
/// counter-clockwise.
#[derive(Clone, Copy)]
pub struct Helicoid {
    pub base_radius: f64,
    /// Rotation per axial length, rad/m; positive for counter-clockwise rotation with z.
    pub twist: f64,
    /// Range of u, m.
    pub u: [f64; 2],
    /// Range of v, m.
    pub v: [f64; 2],
    /// Crowning: at distance v from mid-face `crown v²` is removed along the normal, 1/m.
    pub crown: f64,
    /// +1 for a flank whose outward normal points counter-clockwise, -1 clockwise.
    pub hand: f64,
}

impl Surface for Helicoid {
    fn range(&self) -> [[f64; 2]; 2] {
        [self.u, self.v]
    }

    fn at(&self, u: f64, v: f64) -> SurfacePoint {
        let (rb, hand) = (self.base_radius, self.hand);
        let roll = u / rb;
        // Direction of the radius to the point where the generating line leaves the base circle.
        let angle = self.twist * v - hand * roll;
        let (sine, cosine) = angle.sin_cos();
        let (radial, turning) = ([cosine, sine], [-sine, cosine]);
        // Position: rb radial + hand u turning; the normal of the unmodified flank: along the
        // generating line, and axial by the twist.
        let base = [rb * radial[0] + hand * u * turning[0], rb * radial[1] + hand * u * turning[1], v];
        // Derivatives by u and by v.
        let by_u = [u / rb * radial[0], u / rb * radial[1], 0.0];
        let spun = [-base[1] * self.twist, base[0] * self.twist, 1.0];
        let size = (1.0 + (rb * self.twist).powi(2)).sqrt();
        // (hand turning, axial) is normal to both derivatives if its axial part is -hand rb twist.
        let normal = [hand * turning[0] / size, hand * turning[1] / size, -hand * rb * self.twist / size];
        let depth = self.crown * v * v;
        let position = [0, 1, 2].map(|k| base[k] - depth * normal[k]);
        // The normal rotates with the angle.
        let turned = [-hand * radial[0] / size, -hand * radial[1] / size, 0.0];
        let t_u = [0, 1, 2].map(|k| by_u[k] + depth * turned[k] * hand / rb);
        let t_v =
            [0, 1, 2].map(|k| spun[k] - depth * turned[k] * self.twist - 2.0 * self.crown * v * normal[k]);
        let cross = [
            t_u[1] * t_v[2] - t_u[2] * t_v[1],
            t_u[2] * t_v[0] - t_u[0] * t_v[2],
            t_u[0] * t_v[1] - t_u[1] * t_v[0],
        ];
        let length = cross.iter().map(|c| c * c).sum::<f64>().sqrt();
        let sign = (0..3).map(|k| cross[k] * normal[k]).sum::<f64>().signum();
        SurfacePoint { position, tangents: [t_u, t_v], normal: cross.map(|c| sign * c / length) }
    }
}

/// Pair of external helical gears on parallel axes: one flank of each in mesh at `phase` (m along
/// the line of action from the pitch point, at mid-face).
pub struct Pair {
    pub base_radii: [f64; 2],
    /// Base helix angle of the first gear, rad; that of the second is opposite.
    pub base_helix: f64,
    /// Working transverse pressure angle, rad.
    pub pressure_angle: f64,
    pub phase: f64,
    pub half_face: f64,
    pub crown: f64,
}

pub const HELICAL: Pair = Pair {
    base_radii: [0.03, 0.06],
    base_helix: 0.3,
    pressure_angle: 0.38,
    phase: 0.0,
    half_face: 0.0125,
    crown: 0.0,
};

impl Pair {
    pub fn center(&self) -> f64 {
        (self.base_radii[0] + self.base_radii[1]) / self.pressure_angle.cos()
    }

    /// Flanks of both in the coordinates of their bodies, and the rotations of the bodies, rad: in
    /// contact at mid-face.
    pub fn turned(&self) -> ([Helicoid; 2], [f64; 2]) {
        let tangents = self.base_radii.map(|rb| rb * self.pressure_angle.tan());
        let path = [tangents[0] + self.phase, tangents[1] - self.phase];
        let flank = |side: usize, hand: f64, sense: f64| Helicoid {
            base_radius: self.base_radii[side],
            twist: sense * self.base_helix.tan() / self.base_radii[side],
            u: [0.25 * tangents[side], 2.2 * tangents[side]],
            v: [-self.half_face, self.half_face],
            crown: self.crown,
            hand,
        };
        // Both flanks face counter-clockwise: the first gear drives the second, which rotates in
        // the opposite sense.
        let flanks = [flank(0, 1.0, 1.0), flank(1, 1.0, -1.0)];
        // The line of action leaves the first base circle at minus the pressure angle, the second
        // at the opposite point.
        let alpha = -self.pressure_angle;
        let turn = |at: f64, path: f64, rb: f64| at + path / rb;
        let turns = [
            turn(alpha, path[0], self.base_radii[0]),
            turn(alpha + std::f64::consts::PI, path[1], self.base_radii[1]),
        ];
        (flanks, turns)
    }
}
