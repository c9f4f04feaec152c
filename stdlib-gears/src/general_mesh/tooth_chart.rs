//! Chart of a flank on the projection plane of its tooth: the axial section of the gear, into which
//! all points are rotated about the axis.

use super::topography::FlankPair;
use calyx_runtime::scene::{Prototype, ToothMeridian};
use calyx_runtime::surface::Surface;
use calyx_runtime::vec3::{cross, dot, length, minus};

/// Numbers of parts of a chart along the face and along the profile.
pub const PARTS: [usize; 2] = [32, 24];
/// Ratio of the deviation from a straight line to the length above which a flank is concave or
/// convex. Crowning of straight teeth is smaller.
const CURVED: f64 = 2e-3;

/// Lengthwise shape of a flank.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Lengthwise {
    /// Straight teeth, with or without crowning.
    Straight,
    /// Concave flank of a curved tooth.
    Concave,
    /// Convex flank of a curved tooth.
    Convex,
}

/// Point of a chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChartPoint {
    /// Fractions of the surface's range along the face and along the profile.
    pub place: [f64; 2],
    /// Axial position and radius, m.
    pub meridian: [f64; 2],
    /// Distance from the toe along the pitch cone, and height above the root at mid-face normal to
    /// it, m. On a cylinder, the distance is measured from the end at the smallest z.
    pub projected: [f64; 2],
}

/// Chart of a flank.
#[derive(Clone, Debug, PartialEq)]
pub struct ToothChart {
    /// True if the teeth are on a cone: distances run from the toe to the heel.
    pub conical: bool,
    /// Shape of the flank.
    pub shape: Lengthwise,
    /// Fraction of the range along the profile at which the rounded tip edge starts.
    pub edge_from: f64,
    /// Points by column along the face and row along the profile.
    pub points: Vec<([usize; 2], ChartPoint)>,
    /// Points of the root.
    pub root: Vec<ChartPoint>,
}

/// Lines of the projection plane.
struct Projection {
    along: [f64; 2],
    origin: [f64; 2],
}

impl Projection {
    fn of(&self, [z, radius]: [f64; 2]) -> [f64; 2] {
        let [dz, dr] = self.along;
        let ([ax, ay], [bx, by]) = ([dz, dr], [-dr, dz]);
        // The height is positive away from the axis.
        let sense = if dz < 0.0 { -1.0 } else { 1.0 };
        [ax * z + ay * radius - self.origin[0], sense * (bx * z + by * radius) - self.origin[1]]
    }
}

impl FlankPair {
    /// Returns the chart of the flank of a side; `None` if the body describes no meridian.
    pub fn chart(&self, side: usize, prototype: &dyn Prototype) -> Option<ToothChart> {
        chart(self.surface(side), &prototype.tooth_meridian()?)
    }
}

fn chart(surface: &dyn Surface, meridian: &ToothMeridian) -> Option<ToothChart> {
    let [[u0, u1], [v0, v1]] = surface.range();
    let at = |place: [f64; 2]| {
        let [x, y, z] = surface.at(u0 + place[1] * (u1 - u0), v0 + place[0] * (v1 - v0)).position;
        [z, x.hypot(y)]
    };
    let mut projection = Projection { along: meridian.along, origin: [0.0; 2] };
    let ends = [[0.0, 0.5], [1.0, 0.5]].map(|place| projection.of(at(place))[0]);
    let middle = meridian.root.get(meridian.root.len() / 2)?;
    projection.origin = [ends[0].min(ends[1]), projection.of(*middle)[1]];
    let point = |place: [f64; 2], meridian: [f64; 2]| ChartPoint {
        place,
        meridian,
        projected: projection.of(meridian),
    };
    let [columns, rows] = PARTS;
    let nodes = (0..=columns).flat_map(|column| (0..=rows).map(move |row| [column, row]));
    let points = nodes.map(|[column, row]| {
        let place = [column as f64 / columns as f64, row as f64 / rows as f64];
        ([column, row], point(place, at(place)))
    });
    let last = (meridian.root.len() - 1).max(1) as f64;
    let root = meridian.root.iter().enumerate().map(|(k, at)| point([k as f64 / last, 0.0], *at));
    let edge = surface.edge_from().unwrap_or(u1);
    Some(ToothChart {
        conical: meridian.along[1] > 1e-9,
        shape: lengthwise(surface, meridian.along),
        edge_from: (edge - u0) / (u1 - u0),
        points: points.collect(),
        root: root.collect(),
    })
}

/// Compares the line along the middle of the flank with its chord, in the tangent plane of the
/// cone through its middle.
fn lengthwise(surface: &dyn Surface, [dz, dr]: [f64; 2]) -> Lengthwise {
    let [[u0, u1], [v0, v1]] = surface.range();
    let middle = 0.5 * (u0 + surface.edge_from().unwrap_or(u1));
    let [first, at, last] = [0.0, 0.5, 1.0].map(|part: f64| surface.at(middle, v0 + part * (v1 - v0)));
    let [x, y, _] = at.position;
    let radius = x.hypot(y);
    let outwards = [-dz * x / radius, -dz * y / radius, dr];
    let chord = minus(last.position, first.position);
    let mean = [0, 1, 2].map(|k: usize| 0.5 * (first.position[k] + last.position[k]));
    let across = cross(outwards, chord);
    let sense = if dot(across, at.normal) < 0.0 { -1.0 } else { 1.0 };
    let off = sense * dot(minus(mean, at.position), across) / (length(across) * length(chord));
    match off {
        _ if off > CURVED => Lengthwise::Concave,
        _ if off < -CURVED => Lengthwise::Convex,
        _ => Lengthwise::Straight,
    }
}
