//! Rigid placements in space, and the frame through which a patch acts on its bodies.

use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};
use calyx_structure::surface::{Surface, SurfacePoint};

/// Where a body lies: turned, then shifted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Row by row: columns are the images of the axes.
    pub rotation: [Vector; 3],
    /// Where the origin of the body's coordinates goes, m.
    pub origin: Vector,
}

impl Pose {
    /// Coordinates stay as they are.
    pub const IDENTITY: Pose =
        Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// Of the image of a point given in the coordinates that are placed.
    pub fn point(&self, point: Vector) -> Vector {
        plus(self.direction(point), self.origin)
    }

    /// Of the image of a direction.
    pub fn direction(&self, direction: Vector) -> Vector {
        self.rotation.map(|row| dot(row, direction))
    }

    /// The image of the z axis, about which bodies turn.
    pub fn axis(&self) -> Vector {
        self.rotation.map(|row| row[2])
    }

    /// The placement of a part that is first turned by `angle` (rad) about the z axis of the coordinates placed here, like a tooth
    /// of its gear.
    pub fn turned_first(&self, angle: f64) -> Pose {
        let (sine, cosine) = angle.sin_cos();
        let turn = |[x, y, z]: Vector| [x * cosine + y * sine, y * cosine - x * sine, z];
        Pose { rotation: self.rotation.map(turn), origin: self.origin }
    }
}

/// A surface where its body has put it.
#[derive(Clone, Copy)]
pub struct PlacedSurface<'a> {
    /// In the coordinates of whatever owns it.
    pub surface: &'a dyn Surface,
    /// Of its owner, with the turn of its tooth.
    pub pose: Pose,
}

impl PlacedSurface<'_> {
    /// The point at `[u, v]`, in the coordinates that the surface is placed in.
    pub fn at(&self, [u, v]: [f64; 2]) -> SurfacePoint {
        let local = self.surface.at(u, v);
        SurfacePoint {
            position: self.pose.point(local.position),
            tangents: local.tangents.map(|tangent| self.pose.direction(tangent)),
            normal: self.pose.direction(local.normal),
        }
    }

    /// Ends of both coordinates: without `search_edges` the surface ends where its rounded edge begins.
    pub(super) fn range(&self, search_edges: bool) -> [[f64; 2]; 2] {
        let [[first, last], v] = self.surface.range();
        let last = match self.surface.edge_from() {
            Some(edge) if !search_edges => edge.min(last),
            _ => last,
        };
        [[first, last], v]
    }

    pub(super) fn on_edge(&self, [u, _]: [f64; 2]) -> bool {
        self.surface.edge_from().is_some_and(|edge| u >= edge)
    }
}

/// Sliding slower than this part of the speeds it is the difference of is rounding.
const ROLLING: f64 = 1e-12;

/// Direction (unit vector) in which the first of two bodies that touch along `normal` (unit vector) slides over the second, where their
/// points move at these velocities (m/s); `None` where they only roll.
pub fn sliding(normal: Vector, velocities: [Vector; 2]) -> Option<Vector> {
    let relative = minus(velocities[0], velocities[1]);
    let tangential = minus(relative, scaled(normal, dot(relative, normal)));
    let speed = length(tangential);
    let rolling = speed <= ROLLING * (length(velocities[0]) + length(velocities[1]));
    (!rolling).then(|| scaled(tangential, speed.recip()))
}

/// The frame of a patch: a point, the common normal there, and the directions across and along the ridge; `across`, `along` and
/// `normal` are right-handed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchFrame {
    /// Midway between the two surfaces, m.
    pub point: Vector,
    /// Unit vector out of the first body, into the second.
    pub normal: Vector,
    /// Unit vector in which the patch is narrow: x.
    pub across: Vector,
    /// Unit vector in which it is long: y.
    pub along: Vector,
}

impl PatchFrame {
    /// Growth of the gap per unit translation of a body along `direction` (unit vector); `side` is 0 for the first body and 1 for
    /// the second.
    pub fn translation_arm(&self, side: usize, direction: Vector) -> f64 {
        let along_normal = dot(self.normal, direction);
        if side == 0 { -along_normal } else { along_normal }
    }

    /// Growth of the gap at `point` (where a cell acts, [`super::Cell::point`]) per unit turn of a body about the unit vector `axis`
    /// through `center`, m/rad.
    pub fn rotation_arm(&self, side: usize, axis: Vector, center: Vector, point: Vector) -> f64 {
        self.translation_arm(side, cross(axis, minus(point, center)))
    }

    /// The point of the tangent plane at x, y, m.
    pub fn at(&self, [x, y]: [f64; 2]) -> Vector {
        plus(self.point, plus(scaled(self.across, x), scaled(self.along, y)))
    }

    /// x, y and height over the tangent plane of a point, m.
    pub fn coordinates(&self, point: Vector) -> Vector {
        let from = minus(point, self.point);
        [dot(from, self.across), dot(from, self.along), dot(from, self.normal)]
    }

    /// With x and y turned by `angle` (rad) about the normal, x towards y.
    pub(super) fn turned(&self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let across = plus(scaled(self.across, cosine), scaled(self.along, sine));
        Self::new(self.point, self.normal, across)
    }

    /// With x as near to `across` as the normal (unit vector) lets it be.
    pub(super) fn new(point: Vector, normal: Vector, across: Vector) -> Self {
        let across = unit(minus(across, scaled(normal, dot(normal, across))));
        Self { point, normal, across, along: cross(normal, across) }
    }
}
