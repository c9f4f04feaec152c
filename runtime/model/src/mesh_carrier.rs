//! The carrier of a mesh: the frame in which the axes of both gears are at rest. It is ground for
//! gears on fixed axes, and the planet carrier or the case of a differential for others.
//!
//! Two axes that are not parallel determine the angular velocity `W` of their carrier. With the
//! unit vectors `a1` and `a2` along them and `a' = W x a`:
//!
//! ```text
//! W = a1 x a1' + s a1,   s = (a2' - (a1 x a1') x a2) . (a1 x a2) / |a1 x a2|^2
//! ```
//!
//! For parallel axes, the line of centres takes the place of the second axis.

use crate::motion::{Motion, angular_velocity, axle, point_velocity, spatial_pose};
use calyx_contact::solid::Pose;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, cross, dot, length, minus, plus, scaled, unit};

/// Sine of the angle between axes below which they are regarded as parallel.
const PARALLEL: f64 = 1e-6;

/// Axes of two meshing gears at a time.
#[derive(Clone, Copy, Debug)]
pub struct MeshAxes {
    /// Points of both axes, m.
    pub points: [Vector; 2],
    /// Unit vectors along both axes: e3 of the bodies.
    pub directions: [Vector; 2],
    /// e1 of both bodies.
    across: [Vector; 2],
}

/// Axes of a mesh on a moving carrier at time 0.
#[derive(Clone, Copy, Debug)]
pub enum MovingAxes {
    /// Parallel axes.
    Parallel {
        /// Direction of the line of centres, rad.
        line_of_centres: f64,
    },
    /// Axes of any directions.
    General {
        /// Rotations of both members relative to the carrier, rad.
        rotations: [f64; 2],
    },
}

/// Velocity field of the carrier of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CarrierVelocity {
    /// Angular velocity, rad/s.
    pub angular: Vector,
    /// Point of the first axis, m.
    point: Vector,
    /// Velocity of this point, m/s.
    velocity: Vector,
}

impl MeshAxes {
    /// Determines the axes at a time (s).
    ///
    /// # Errors
    /// E0710: a frame is NaN or infinite.
    pub fn at(motions: [&dyn Motion; 2], time: f64) -> Result<MeshAxes, EngineError> {
        let poses = [spatial_pose(motions[0], time)?, spatial_pose(motions[1], time)?];
        let points = [0, 1].map(|side: usize| poses[side].point(axle(motions[side])));
        let along = |axis: Vector| poses.map(|pose| pose.direction(axis));
        Ok(MeshAxes { points, directions: along([0.0, 0.0, 1.0]), across: along([1.0, 0.0, 0.0]) })
    }

    /// Returns the velocity of the carrier at the same time.
    pub fn carrier_velocity(&self, motions: [&dyn Motion; 2], time: f64) -> CarrierVelocity {
        let [first, second] = self.directions;
        let velocities = [0, 1].map(|side: usize| point_velocity(motions[side], time, self.points[side]));
        let rates =
            [0, 1].map(|side: usize| cross(angular_velocity(motions[side], time), self.directions[side]));
        let tilting = cross(first, rates[0]);
        let (other, rate) = match self.are_parallel() {
            false => (second, rates[1]),
            true => (minus(self.points[1], self.points[0]), minus(velocities[1], velocities[0])),
        };
        let perpendicular = cross(first, other);
        let square = dot(perpendicular, perpendicular);
        let missing = minus(rate, cross(tilting, other));
        // Gears on one axis determine no rotation about it.
        let spin = if square > 0.0 { dot(missing, perpendicular) / square } else { 0.0 };
        let angular = plus(tilting, scaled(first, spin));
        CarrierVelocity { angular, point: self.points[0], velocity: velocities[0] }
    }

    /// Returns the pose of the carrier: its origin is on the first axis, and its e3 along it.
    pub fn carrier_pose(&self) -> Pose {
        let z = self.directions[0];
        let x = self.reference(0);
        let y = cross(z, x);
        Pose { rotation: [0, 1, 2].map(|k: usize| [x[k], y[k], z[k]]), origin: self.points[0] }
    }

    /// Returns the rotation of a member about its own axis relative to the carrier, rad, modulo
    /// whole revolutions.
    pub fn rotation(&self, side: usize) -> f64 {
        let (x, z) = (self.reference(side), self.directions[side]);
        dot(self.across[side], cross(z, x)).atan2(dot(self.across[side], x))
    }

    fn are_parallel(&self) -> bool {
        length(cross(self.directions[0], self.directions[1])) < PARALLEL
    }

    /// Returns a direction perpendicular to the axis of a member that is fixed in the carrier.
    fn reference(&self, side: usize) -> Vector {
        let axis = self.directions[side];
        let other = match self.are_parallel() {
            false => self.directions[1 - side],
            true => minus(self.points[1 - side], self.points[side]),
        };
        unit(minus(other, scaled(axis, dot(other, axis))))
    }
}

impl CarrierVelocity {
    /// Returns the velocity at a point in ground coordinates (m), m/s.
    pub fn at(&self, point: Vector) -> Vector {
        plus(self.velocity, cross(self.angular, minus(point, self.point)))
    }
}
