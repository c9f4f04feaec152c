//! Where bodies are meant to be: the kinematic trajectory that the deflections are measured from.

use crate::contact::solid::Pose;
use crate::error::EngineError;
use calyx_abi::math;

/// A prescribed motion. `frame` takes ground coordinates into the body's frame: `x' = R x + t`.
pub trait Motion: Send + Sync {
    /// Rotation row by row (9), then translation (3), at `time` seconds.
    fn frame(&self, time: f64) -> [f64; 12];

    /// Rate of `frame`, per second.
    fn rate(&self, time: f64) -> [f64; 12];
}

/// Turning steadily about an axis parallel to e3 through a fixed point: the motion of most gear bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyRotation {
    /// Where the axis meets the plane, m.
    pub origin: [f64; 2],
    /// Angle at time 0, rad.
    pub start: f64,
    /// rad/s, counter-clockwise.
    pub speed: f64,
}

impl SteadyRotation {
    /// Standing still, unturned, with the frame's origin at a point (m).
    pub const fn at_rest(origin: [f64; 2]) -> SteadyRotation {
        SteadyRotation { origin, start: 0.0, speed: 0.0 }
    }
}

impl Motion for SteadyRotation {
    fn frame(&self, time: f64) -> [f64; 12] {
        let (sin, cos) = math::sincos(self.start + self.speed * time);
        let [x, y] = self.origin;
        [cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0, 1.0, -(cos * x + sin * y), sin * x - cos * y, 0.0]
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        let (sin, cos) = math::sincos(self.start + self.speed * time);
        let [x, y] = self.origin;
        [-sin, cos, 0.0, -cos, -sin, 0.0, 0.0, 0.0, 0.0, sin * x - cos * y, cos * x + sin * y, 0.0]
            .map(|entry| entry * self.speed)
    }
}

/// Velocity of the point of a moving body that is at a point in ground coordinates (m) at a time (s), m/s.
pub fn point_velocity(motion: &dyn Motion, time: f64, point: [f64; 3]) -> [f64; 3] {
    let (f, r) = (motion.frame(time), motion.rate(time));
    // A point that stays in the body has x' = R x + t at rest, so its velocity is -R^T (dR/dt x + dt/dt).
    let seen: [f64; 3] = std::array::from_fn(|row| {
        r[9 + row] + (0..3).map(|column| r[3 * row + column] * point[column]).sum::<f64>()
    });
    std::array::from_fn(|axis| -(0..3).map(|row| f[3 * row + axis] * seen[row]).sum::<f64>())
}

/// A pose in the plane: a body turned by `angle` with its origin at `origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanePose {
    /// m
    pub origin: [f64; 2],
    /// rad, counter-clockwise.
    pub angle: f64,
}

impl PlanePose {
    /// The pose of `motion` at `time`, if its axis is parallel to e3.
    pub fn of(motion: &dyn Motion, time: f64) -> Result<PlanePose, EngineError> {
        let f = finite_frame(motion, time)?;
        let tilt = (f[8] - 1.0).abs() + f[2].abs() + f[5].abs() + f[6].abs() + f[7].abs();
        if tilt > 1e-9 {
            return Err(EngineError::new(
                "E0610",
                "a plane model needs every body to turn about an axis parallel to e3",
                "let the frame use rotations about e3 (an axis of unit length) and translations in the plane only",
            )
            .blame("frame"));
        }
        // x' = R x + t: the origin is where x' = 0, so x = -R^T t.
        let origin = [-(f[0] * f[9] + f[3] * f[10]), -(f[1] * f[9] + f[4] * f[10])];
        Ok(PlanePose { origin, angle: f[1].atan2(f[0]) })
    }

    /// Angular velocity of `motion` about e3, rad/s.
    pub fn angular_velocity(motion: &dyn Motion, time: f64) -> f64 {
        let (f, r) = (motion.frame(time), motion.rate(time));
        // With R = [c s; -s c]: dR/dt R^T has the angular velocity in its upper right corner.
        r[0] * f[3] + r[1] * f[4]
    }
}

fn finite_frame(motion: &dyn Motion, time: f64) -> Result<[f64; 12], EngineError> {
    let frame = motion.frame(time);
    if frame.iter().all(|entry| entry.is_finite()) {
        return Ok(frame);
    }
    Err(EngineError::new(
        "E0710",
        format!("the body's frame is not a number at Time = {time} s"),
        "look for a division by zero or the root of a negative number in the frame's expression",
    )
    .blame("frame"))
}

/// Where `motion` puts a body at `time`: the way from the body's coordinates to those of ground.
///
/// # Errors
/// E0710: the frame is not a number.
pub fn pose_in_space(motion: &dyn Motion, time: f64) -> Result<Pose, EngineError> {
    let f = finite_frame(motion, time)?;
    // x' = R x + t: x = R^T x' - R^T t.
    let rotation = [[f[0], f[3], f[6]], [f[1], f[4], f[7]], [f[2], f[5], f[8]]];
    let origin = rotation.map(|row| -(row[0] * f[9] + row[1] * f[10] + row[2] * f[11]));
    Ok(Pose { rotation, origin })
}

/// Angle (rad) about the body's own z axis between two of its poses, whose axes are parallel to each other.
pub fn turned_between(before: &Pose, after: &Pose) -> f64 {
    let column = |pose: &Pose, axis: usize| pose.rotation.map(|row| row[axis]);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let x = column(after, 0);
    dot(x, column(before, 1)).atan2(dot(x, column(before, 0)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_pose_of_a_turning_body_is_its_angle_and_its_axis() {
        let motion = SteadyRotation { origin: [0.3, -0.2], start: 0.4, speed: -2.0 };
        let pose = PlanePose::of(&motion, 0.1).unwrap();
        assert!((pose.angle - 0.2).abs() < 1e-15);
        assert!((pose.origin[0] - 0.3).abs() < 1e-15 && (pose.origin[1] + 0.2).abs() < 1e-15);
        assert!((PlanePose::angular_velocity(&motion, 0.1) + 2.0).abs() < 1e-14);
    }

    #[test]
    fn points_of_a_turning_body_move_about_its_axis() {
        let motion = SteadyRotation { origin: [0.3, -0.2], start: 0.4, speed: -2.0 };
        let [x, y, z] = point_velocity(&motion, 0.7, [1.3, 0.3, 5.0]);
        // Speed times the arm, turned by a right angle.
        assert!((x - 2.0 * 0.5).abs() < 1e-14 && (y + 2.0).abs() < 1e-14 && z == 0.0, "{x} {y} {z}");
    }

    #[test]
    fn a_frame_tilted_out_of_the_plane_is_refused() {
        struct Tilted;
        impl Motion for Tilted {
            fn frame(&self, _: f64) -> [f64; 12] {
                [1.0, 0.0, 0.0, 0.0, 0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0]
            }
            fn rate(&self, _: f64) -> [f64; 12] {
                [0.0; 12]
            }
        }
        assert_eq!(PlanePose::of(&Tilted, 0.0).unwrap_err().code, "E0610");
    }
}
