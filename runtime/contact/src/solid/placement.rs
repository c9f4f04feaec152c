//! Rigid placements in three dimensions, and the frame through which a patch acts on its bodies.

use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};
use calyx_structure::surface::{Surface, SurfacePoint};
use nalgebra::{Rotation3, Vector3};

/// Pose of a body: rotation, then translation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pose {
    /// Rotation matrix by rows; its columns are the images of the axes.
    pub rotation: [Vector; 3],
    /// Image of the origin of the body's coordinates, m.
    pub origin: Vector,
}

impl Pose {
    /// Identity.
    pub const IDENTITY: Pose =
        Pose { rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], origin: [0.0; 3] };

    /// Returns the image of a point.
    pub fn point(&self, point: Vector) -> Vector {
        plus(self.direction(point), self.origin)
    }

    /// Returns the image of a direction.
    pub fn direction(&self, direction: Vector) -> Vector {
        self.rotation.map(|row| dot(row, direction))
    }

    /// Returns the image of the z axis, about which bodies rotate.
    pub fn axis(&self) -> Vector {
        self.rotation.map(|row| row[2])
    }

    /// Composes the pose with a preceding rotation by `angle` (rad) about the z axis, like that of
    /// a tooth in its gear.
    pub fn rotated_first(&self, angle: f64) -> Pose {
        let (sine, cosine) = angle.sin_cos();
        let turn = |[x, y, z]: Vector| [x * cosine + y * sine, y * cosine - x * sine, z];
        Pose { rotation: self.rotation.map(turn), origin: self.origin }
    }
}

/// Rotation of a body about an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyRotation {
    /// Point of the axis, m.
    pub origin: Vector,
    /// Unit vector along the axis.
    pub axis: Vector,
    /// Angle, rad.
    pub angle: f64,
}

impl BodyRotation {
    /// Returns a pose of the body, or of one of its teeth, after the rotation.
    pub fn applied_to(&self, pose: &Pose) -> Pose {
        let rotation = Rotation3::new(self.angle * Vector3::from(self.axis));
        let rotated = |direction: Vector| <[f64; 3]>::from(rotation * Vector3::from(direction));
        let columns = [0, 1, 2].map(|column: usize| rotated(pose.rotation.map(|row| row[column])));
        Pose {
            rotation: [0, 1, 2].map(|row: usize| columns.map(|column| column[row])),
            origin: plus(self.origin, rotated(minus(pose.origin, self.origin))),
        }
    }

    /// Returns the displacement of a point of the body to first order in the angle, m.
    pub fn displacement(&self, point: Vector) -> Vector {
        scaled(cross(self.axis, minus(point, self.origin)), self.angle)
    }
}

/// Surface in the position of its body.
#[derive(Clone, Copy)]
pub struct PlacedSurface<'a> {
    /// Surface in the coordinates of its owner.
    pub surface: &'a dyn Surface,
    /// Pose of the owner, including the rotation of its tooth.
    pub pose: Pose,
}

impl PlacedSurface<'_> {
    /// Returns the point at `[u, v]`, in the coordinates of the placement.
    pub fn at(&self, [u, v]: [f64; 2]) -> SurfacePoint {
        let local = self.surface.at(u, v);
        SurfacePoint {
            position: self.pose.point(local.position),
            tangents: local.tangents.map(|tangent| self.pose.direction(tangent)),
            normal: self.pose.direction(local.normal),
        }
    }

    /// Returns the range of both coordinates: without `search_edges` the surface ends at the start
    /// of its rounded edge.
    pub(super) fn range(&self, search_edges: bool) -> [[f64; 2]; 2] {
        let [[first, last], v] = self.surface.range();
        let last = match self.surface.edge_from() {
            Some(edge) if !search_edges => edge.min(last),
            _ => last,
        };
        [[first, last], v]
    }

    /// Returns the surface coordinates at which a contact force at `place` is applied to the body.
    /// It acts along the normal of the other flank. Compliances of structures are those of forces
    /// along their own normals, which are rotated on a rounded edge, so there the force is applied
    /// at the start of the edge.
    pub(super) fn loaded_at(&self, [u, v]: [f64; 2]) -> [f64; 2] {
        [self.surface.edge_from().map_or(u, |start| u.min(start)), v]
    }

    pub(super) fn on_edge(&self, [u, _]: [f64; 2]) -> bool {
        self.surface.edge_from().is_some_and(|edge| u >= edge)
    }
}

/// Sliding speed below this fraction of the speeds that it is a difference of is rounding.
const ROLLING: f64 = 1e-12;

/// Returns the direction (unit vector) in which the first of two bodies in contact along `normal`
/// (unit vector) slides over the second, from the velocities of their points (m/s); `None` for pure
/// rolling.
pub fn sliding(normal: Vector, velocities: [Vector; 2]) -> Option<Vector> {
    let relative = minus(velocities[0], velocities[1]);
    let tangential = minus(relative, scaled(normal, dot(relative, normal)));
    let speed = length(tangential);
    let rolling = speed <= ROLLING * (length(velocities[0]) + length(velocities[1]));
    (!rolling).then(|| scaled(tangential, speed.recip()))
}

/// Frame of a patch: a point, the common normal there, and the directions across and along the
/// contact line; `across`, `along` and `normal` are right-handed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PatchFrame {
    /// Midpoint between the two surfaces, m.
    pub point: Vector,
    /// Unit normal, out of the first body and into the second.
    pub normal: Vector,
    /// Unit vector across the contact line, x.
    pub across: Vector,
    /// Unit vector along the contact line, y.
    pub along: Vector,
}

impl PatchFrame {
    /// Returns the growth of the gap per unit translation of a body along `direction` (unit
    /// vector); `side` is 0 for the first body and 1 for the second.
    pub fn translation_arm(&self, side: usize, direction: Vector) -> f64 {
        let along_normal = dot(self.normal, direction);
        if side == 0 { -along_normal } else { along_normal }
    }

    /// Returns the growth of the gap at `point` (where a cell acts, [`super::Cell::point`]) per
    /// unit rotation of a body about the unit vector `axis` through `center`, m/rad.
    pub fn rotation_arm(&self, side: usize, axis: Vector, center: Vector, point: Vector) -> f64 {
        self.translation_arm(side, cross(axis, minus(point, center)))
    }

    /// Returns the direction in which a unit force on a surface with these slopes along x and y
    /// acts out of the first body: its component along the normal is 1.
    pub fn action(&self, slope: [f64; 2]) -> Vector {
        match slope == [0.0; 2] {
            true => self.normal,
            false => {
                let tangential = plus(scaled(self.across, slope[0]), scaled(self.along, slope[1]));
                minus(self.normal, tangential)
            }
        }
    }

    /// Returns the point of the tangent plane at x, y, m.
    pub fn at(&self, [x, y]: [f64; 2]) -> Vector {
        plus(self.point, plus(scaled(self.across, x), scaled(self.along, y)))
    }

    /// Returns x, y and height over the tangent plane of a point, m.
    pub fn coordinates(&self, point: Vector) -> Vector {
        let from = minus(point, self.point);
        [dot(from, self.across), dot(from, self.along), dot(from, self.normal)]
    }

    /// Rotates x and y by `angle` (rad) about the normal, x towards y.
    pub(super) fn turned(&self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let across = plus(scaled(self.across, cosine), scaled(self.along, sine));
        Self::new(self.point, self.normal, across)
    }

    /// Creates a frame with x as near to `across` as the normal (unit vector) permits.
    pub(super) fn new(point: Vector, normal: Vector, across: Vector) -> Self {
        let across = unit(minus(across, scaled(normal, dot(normal, across))));
        Self { point, normal, across, along: cross(normal, across) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const POSE: Pose =
        Pose { rotation: [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], origin: [0.03, -0.02, 0.05] };
    const POINT: Vector = [0.01, 0.04, -0.02];

    fn rotation(angle: f64) -> BodyRotation {
        BodyRotation { origin: [0.02, 0.01, -0.03], axis: unit([1.0, -2.0, 2.0]), angle }
    }

    fn apart(first: Vector, second: Vector) -> f64 {
        length(minus(first, second))
    }

    #[test]
    fn a_rotation_moves_points_of_a_body_about_the_axis() {
        for angle in [0.0, 1e-3, -0.7, 2.5] {
            let rotation = rotation(angle);
            let BodyRotation { origin, axis, .. } = rotation;
            let (before, after) = (POSE.point(POINT), rotation.applied_to(&POSE).point(POINT));
            // Heights along the axis, distances from it, and the angle between both.
            let radial = |point: Vector| {
                let from = minus(point, origin);
                minus(from, scaled(axis, dot(from, axis)))
            };
            assert!(dot(minus(after, before), axis).abs() < 1e-15);
            let [from, to] = [radial(before), radial(after)];
            let found = dot(cross(from, to), axis).atan2(dot(from, to));
            assert!((length(from) - length(to)).abs() < 1e-15 && (found - angle).abs() < 1e-14);
        }
    }

    #[test]
    fn the_displacement_is_that_of_a_small_rotation() {
        for angle in [1e-3, -1e-4] {
            let rotation = rotation(angle);
            let before = POSE.point(POINT);
            let exact = minus(rotation.applied_to(&POSE).point(POINT), before);
            // The next term of the series is half of the square of the angle times the distance
            // from the axis.
            let error = apart(rotation.displacement(before), exact);
            let distance = length(cross(rotation.axis, minus(before, rotation.origin)));
            assert!((error / (0.5 * angle * angle * distance) - 1.0).abs() < 1e-3, "{error:e}");
        }
    }

    #[test]
    fn rotations_about_the_same_axis_add_up() {
        let twice = rotation(0.3).applied_to(&rotation(0.4).applied_to(&POSE));
        let sum = rotation(0.7).applied_to(&POSE);
        assert!(apart(twice.point(POINT), sum.point(POINT)) < 1e-15);
    }
}
