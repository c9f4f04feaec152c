//! Where bodies are meant to be: the kinematic trajectory that the deflections are measured from.

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
        let f = motion.frame(time);
        let tilt = (f[8] - 1.0).abs() + f[2].abs() + f[5].abs() + f[6].abs() + f[7].abs();
        if f.iter().any(|entry| !entry.is_finite()) {
            return Err(EngineError::new(
                "E0710",
                format!("the body's frame is not a number at Time = {time} s"),
                "look for a division by zero or the root of a negative number in the frame's expression",
            )
            .blame("frame"));
        }
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
