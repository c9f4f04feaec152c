//! Prescribed motions of bodies: the kinematic trajectories from which deflections are measured.
//!
//! See `docs/theory/kinematics.md`.

use calyx_abi::math;
use calyx_contact::solid::Pose;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{dot, length};
use std::f64::consts::TAU;
use std::sync::Arc;

/// Prescribed motion of a body. `frame` maps ground coordinates to those of the body's frame: `x' =
/// R x + t`.
pub trait Motion: Send + Sync {
    /// Rotation row by row (9), then translation (3), at `time` (s).
    fn frame(&self, time: f64) -> [f64; 12];

    /// First time derivative of `frame`, per second.
    fn rate(&self, time: f64) -> [f64; 12];

    /// Second time derivative of `frame`, per second squared; used by transient analyses.
    fn acceleration(&self, time: f64) -> [f64; 12];
}

/// Rotation at constant speed about a fixed axis parallel to e3: the motion of most gear bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SteadyRotation {
    /// Intersection of the axis with the plane, m.
    pub origin: [f64; 2],
    /// Angle at time 0, rad.
    pub start: f64,
    /// Angular velocity, rad/s, counter-clockwise.
    pub speed: f64,
}

impl SteadyRotation {
    /// Creates a body at rest, without rotation, with the origin of its frame at a point (m).
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

    fn acceleration(&self, time: f64) -> [f64; 12] {
        let mut turning = self.frame(time).map(|entry| -entry * self.speed * self.speed);
        // The axis is fixed.
        turning[8] = 0.0;
        turning
    }
}

/// Motion under a constant rigid displacement, for example with a tilted axis.
pub struct RelocatedMotion {
    /// Motion before the displacement.
    pub motion: Arc<dyn Motion>,
    /// Rigid displacement.
    pub pose: Pose,
}

impl RelocatedMotion {
    /// Rotates a motion by `rotation` (a matrix, row by row) about a point (m).
    pub fn rotated_about(
        motion: Arc<dyn Motion>,
        rotation: [[f64; 3]; 3],
        point: [f64; 3],
    ) -> RelocatedMotion {
        let turned = Pose { rotation, origin: [0.0; 3] }.point(point);
        RelocatedMotion { motion, pose: Pose { rotation, origin: [0, 1, 2].map(|k| point[k] - turned[k]) } }
    }

    /// Displaces a frame or its rate. The displacement is constant, so both transform equally.
    fn put(&self, f: [f64; 12]) -> [f64; 12] {
        let Pose { rotation: q, origin } = self.pose;
        // Map ground back to the original position of the motion: x' = R Q^T (x - p) + t.
        let r: [f64; 9] = std::array::from_fn(|k| {
            let (row, column) = (k / 3, k % 3);
            (0..3).map(|j| f[3 * row + j] * q[column][j]).sum()
        });
        let t: [f64; 3] = std::array::from_fn(|row| {
            f[9 + row] - (0..3).map(|column| r[3 * row + column] * origin[column]).sum::<f64>()
        });
        [r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], r[8], t[0], t[1], t[2]]
    }
}

impl Motion for RelocatedMotion {
    fn frame(&self, time: f64) -> [f64; 12] {
        self.put(self.motion.frame(time))
    }

    fn rate(&self, time: f64) -> [f64; 12] {
        self.put(self.motion.rate(time))
    }

    fn acceleration(&self, time: f64) -> [f64; 12] {
        self.put(self.motion.acceleration(time))
    }
}

/// Returns the velocity at a time (s) of the material point of a moving body at a point in ground
/// coordinates (m), m/s.
pub fn point_velocity(motion: &dyn Motion, time: f64, point: [f64; 3]) -> [f64; 3] {
    let (f, r) = (motion.frame(time), motion.rate(time));
    // A material point has constant x' = R x + t, so its velocity is -R^T (dR/dt x + dt/dt).
    let seen: [f64; 3] = std::array::from_fn(|row| {
        r[9 + row] + (0..3).map(|column| r[3 * row + column] * point[column]).sum::<f64>()
    });
    std::array::from_fn(|axis| -(0..3).map(|row| f[3 * row + axis] * seen[row]).sum::<f64>())
}

/// Returns the acceleration at a time (s) of the material point of a moving body at a point in
/// ground coordinates (m), m/s².
pub fn point_acceleration(motion: &dyn Motion, time: f64, point: [f64; 3]) -> [f64; 3] {
    let (f, r, a) = (motion.frame(time), motion.rate(time), motion.acceleration(time));
    let velocity = point_velocity(motion, time, point);
    // The second derivative of x' = R x + t vanishes.
    let seen: [f64; 3] = std::array::from_fn(|row| {
        let turning = |k: usize| a[3 * row + k] * point[k] + 2.0 * r[3 * row + k] * velocity[k];
        a[9 + row] + (0..3).map(turning).sum::<f64>()
    });
    std::array::from_fn(|axis| -(0..3).map(|row| f[3 * row + axis] * seen[row]).sum::<f64>())
}

/// Returns the angular acceleration of a motion along the ground axes, rad/s².
pub fn angular_acceleration(motion: &dyn Motion, time: f64) -> [f64; 3] {
    let (f, r, a) = (motion.frame(time), motion.rate(time), motion.acceleration(time));
    // Derivative of the expression in `angular_velocity`.
    let entry = |row: usize, column: usize| -> f64 {
        let of = |k: usize| a[3 * k + row] * f[3 * k + column] + r[3 * k + row] * r[3 * k + column];
        (0..3).map(of).sum()
    };
    [entry(2, 1), entry(0, 2), entry(1, 0)]
}

/// Plane pose: a body rotated by `angle` with its origin at `origin`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanePose {
    /// Origin, m.
    pub origin: [f64; 2],
    /// Angle, rad, counter-clockwise.
    pub angle: f64,
}

impl PlanePose {
    /// Returns the pose of `motion` at `time`, if its axis is parallel to e3.
    pub fn of(motion: &dyn Motion, time: f64) -> Result<PlanePose, EngineError> {
        let f = finite_frame(motion, time)?;
        let tilt = (f[8] - 1.0).abs() + f[2].abs() + f[5].abs() + f[6].abs() + f[7].abs();
        if tilt > 1e-9 {
            return Err(out_of_plane());
        }
        // x' = R x + t: the origin is at x' = 0, so x = -R^T t.
        let origin = [-(f[0] * f[9] + f[3] * f[10]), -(f[1] * f[9] + f[4] * f[10])];
        Ok(PlanePose { origin, angle: f[1].atan2(f[0]) })
    }

    /// Returns the position of a point given in the coordinates of the body, m.
    pub fn point(&self, [x, y, _]: [f64; 3]) -> [f64; 2] {
        let (sine, cosine) = self.angle.sin_cos();
        [self.origin[0] + (cosine * x - sine * y), self.origin[1] + (sine * x + cosine * y)]
    }
}

/// Checks that a plane model supports the motion: its axis is, and remains, parallel to e3.
///
/// # Errors
/// E0610: the axis is not parallel; E0710: the frame is NaN at time 0.
pub fn check_in_plane(motion: &dyn Motion) -> Result<(), EngineError> {
    PlanePose::of(motion, 0.0)?;
    // A frame that is upright at time 0 may tilt later. The rate of the row and the column of e3 in
    // the rotation is perpendicular to e3, so these four entries contain all tilting.
    let rate = motion.rate(0.0);
    let fastest = rate[..9].iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
    match [2, 5, 6, 7].iter().any(|&entry| rate[entry].abs() > 1e-9 * fastest) {
        true => Err(out_of_plane()),
        false => Ok(()),
    }
}

fn out_of_plane() -> EngineError {
    EngineError::new(
        "E0610",
        "a plane model needs every body to turn about an axis parallel to e3",
        "build the frame from rotations about e3 (an axis of unit length) and translations in the plane",
    )
    .blame("frame")
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

/// Returns the pose of a body under `motion` at `time`: the map from body to ground coordinates.
///
/// # Errors
/// E0710: the frame is NaN.
pub fn spatial_pose(motion: &dyn Motion, time: f64) -> Result<Pose, EngineError> {
    let f = finite_frame(motion, time)?;
    // x' = R x + t gives x = R^T x' - R^T t.
    let rotation = [[f[0], f[3], f[6]], [f[1], f[4], f[7]], [f[2], f[5], f[8]]];
    let origin = rotation.map(|row| -(row[0] * f[9] + row[1] * f[10] + row[2] * f[11]));
    Ok(Pose { rotation, origin })
}

/// Orientation of a body in three dimensions: the direction of its axis and its angle of rotation
/// about it.
///
/// Rotation and tilt are separated uniquely: the ground axes are rotated with the body's axis by
/// the minimal rotation from e3, and the angle is measured from there. So the angle of a gear on a
/// tilted shaft, or of a wobbling gear on a straight shaft, grows exactly with the rotation of the
/// shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orientation {
    /// Ground axes after the minimal rotation that maps e3 to the body's axis, which is the last of
    /// them: unit vectors.
    pub axes: [[f64; 3]; 3],
    /// Angle of rotation about the last axis, rad.
    pub angle: f64,
}

impl Orientation {
    /// Returns the orientation of a body in a pose.
    pub fn of(pose: &Pose) -> Orientation {
        let [[xx, xy, xz], [yx, yy, yz], [_, _, zz]] = pose.rotation;
        if zz <= OPPOSITE {
            // The minimal rotation to -e3 is not unique: half a revolution about e1 is used.
            return Orientation { axes: tilted_axes([xz, yz, zz]), angle: (-yx).atan2(xx) };
        }
        Orientation { axes: tilted_axes([xz, yz, zz]), angle: (yx - xy).atan2(xx + yy) }
    }

    /// Returns the body's axis.
    pub fn axis(&self) -> [f64; 3] {
        self.axes[2]
    }

    /// Returns the angle between the axis and e3, rad.
    pub fn tilt(&self) -> f64 {
        let [x, y, z] = self.axis();
        x.hypot(y).atan2(z)
    }
}

/// Component along e3 of an axis that is opposite to e3 to within rounding.
const OPPOSITE: f64 = -1.0 + 1e-12;

/// Rotates the ground axes by the minimal rotation that maps e3 to `axis` (unit vector); for -e3,
/// by half a revolution about e1.
pub fn tilted_axes([x, y, z]: [f64; 3]) -> [[f64; 3]; 3] {
    if z <= OPPOSITE {
        return [[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]];
    }
    // 1 / (1 + z), without cancellation next to -e3.
    let by = if z < 0.0 { (1.0 - z) / (x * x + y * y) } else { (1.0 + z).recip() };
    let mixed = -x * y * by;
    [[1.0 - x * x * by, mixed, -x], [mixed, 1.0 - y * y * by, -y], [x, y, z]]
}

/// Displaces and rotates a pose along and about the axes of its body ([`Orientation::axes`]) by the
/// values of its DOFs, m and rad.
pub fn moved_by(pose: &Pose, by: [f64; 6]) -> Pose {
    let axes = Orientation::of(pose).axes;
    let along =
        |[x, y, z]: [f64; 3]| [0, 1, 2].map(|k: usize| x * axes[0][k] + y * axes[1][k] + z * axes[2][k]);
    let [ux, uy, uz, tx, ty, tz] = by;
    let shift = along([ux, uy, uz]);
    let origin = [0, 1, 2].map(|k: usize| pose.origin[k] + shift[k]);
    // Apply the rotation about the body's axis first, then the small tilt, which moves the axis.
    let turned = pose.rotated_first(tz);
    let lean = tx.hypot(ty);
    if lean == 0.0 {
        return Pose { origin, ..turned };
    }
    let (sine, cosine) = lean.sin_cos();
    let axis = along([tx / lean, ty / lean, 0.0]);
    let tilted = |[x, y, z]: [f64; 3]| {
        let [a, b, c] = axis;
        let cross = [b * z - c * y, c * x - a * z, a * y - b * x];
        let on = (a * x + b * y + c * z) * (1.0 - cosine);
        [
            x * cosine + cross[0] * sine + a * on,
            y * cosine + cross[1] * sine + b * on,
            z * cosine + cross[2] * sine + c * on,
        ]
    };
    let columns = [0, 1, 2].map(|column: usize| tilted(turned.rotation.map(|row| row[column])));
    Pose { rotation: [0, 1, 2].map(|row: usize| columns.map(|column| column[row])), origin }
}

/// Returns the angular velocity of a motion along the ground axes, rad/s.
pub fn angular_velocity(motion: &dyn Motion, time: f64) -> [f64; 3] {
    let (f, r) = (motion.frame(time), motion.rate(time));
    // With x' = R x the velocity field is -R^T dR/dt x; its antisymmetric matrix contains the
    // angular velocity.
    let entry =
        |row: usize, column: usize| -> f64 { (0..3).map(|k| r[3 * k + row] * f[3 * k + column]).sum() };
    [entry(2, 1), entry(0, 2), entry(1, 0)]
}

/// Fractions of a revolution after which the axis is computed again, to test whether it is fixed.
const LATER: [f64; 2] = [0.13, 0.38];
/// Times, s, at which a body that is at rest at time 0 may move.
const MOVING: [f64; 4] = [0.0, 1e-3, 1.0, 1e3];
/// Tolerances of the position of an axis for rounding: absolute, m, and relative to the positions
/// of frames.
const NOWHERE: [f64; 2] = [1e-12, 1e-9];

/// Returns the position of the axis of rotation in the coordinates of the body, m: for an eccentric
/// gear, the point of the shaft's axis next to the origin of its frame; otherwise the origin. An
/// axis counts if it is fixed in the body and on ground, or if it is a planet's pin, which is fixed
/// in the body and moves on a circle. If the body is at rest at time 0, its later motion decides.
pub fn axle(motion: &dyn Motion) -> [f64; 3] {
    // Axis in body and in ground coordinates, at a time.
    let axis = |time: f64| -> Option<([f64; 3], [f64; 3])> {
        let pose = spatial_pose(motion, time).ok()?;
        let [wx, wy, wz] = angular_velocity(motion, time);
        let [vx, vy, vz] = point_velocity(motion, time, pose.origin);
        // The velocity vanishes at p from the origin where v + w x p = 0.
        let square = wx * wx + wy * wy + wz * wz;
        let p = [wy * vz - wz * vy, wz * vx - wx * vz, wx * vy - wy * vx].map(|part| part / square);
        let size = |[x, y, z]: [f64; 3]| x.hypot(y).hypot(z);
        let [floor, relative] = NOWHERE;
        if !(square > 0.0 && size(p) > floor + relative * size(pose.origin)) {
            return None;
        }
        let own = [0, 1, 2].map(|k: usize| (0..3).map(|row| pose.rotation[row][k] * p[row]).sum());
        Some((own, [0, 1, 2].map(|k: usize| pose.origin[k] + p[k])))
    };
    let speed = |time: f64| {
        let [x, y, z] = angular_velocity(motion, time);
        x.hypot(y).hypot(z)
    };
    let start = MOVING.into_iter().find(|&time| speed(time) > 0.0).unwrap_or_default();
    let found = axis(start).filter(|(own, ground)| {
        let turn = TAU / speed(start);
        let size = own.iter().fold(0.0, |size: f64, part| size.hypot(*part));
        let near = |one: &[f64; 3], other: &[f64; 3]| (0..3).all(|k| (one[k] - other[k]).abs() < 1e-6 * size);
        LATER.iter().all(|part| {
            axis(start + part * turn).is_some_and(|(later, there)| near(own, &later) && near(ground, &there))
        })
    });
    found.map(|(own, _)| own).or_else(|| pin(motion)).unwrap_or_default()
}

/// Returns the position of the pin of an eccentric planet in the coordinates of the body, m; `None`
/// for a body that does not orbit steadily or is centred on its pin.
///
/// As a complex number the origin of such a body is at `c + a z^k + b w^k` after `k` equal time
/// intervals, with the rotations `w` of the body and `z` of its carrier in one interval; `b` is the
/// offset of the origin from the pin.
fn pin(motion: &dyn Motion) -> Option<[f64; 3]> {
    let minus = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a - c, b - d];
    let times = |[a, b]: [f64; 2], [c, d]: [f64; 2]| [a * c - b * d, a * d + b * c];
    let over = |[a, b]: [f64; 2], [c, d]: [f64; 2]| {
        let square = c * c + d * d;
        [(a * c + b * d) / square, (b * c - a * d) / square]
    };
    let size = |[a, b]: [f64; 2]| a.hypot(b);
    let turning = angular_velocity(motion, 0.0);
    let speed = length(turning).copysign(turning[2]);
    let step = LATER[0] * TAU / speed.abs();
    if !step.is_finite() {
        return None;
    }
    // Directions across the axis of rotation.
    let [x, y, _] = tilted_axes(turning.map(|part| part / speed));
    let in_plane = |point: [f64; 3]| [dot(x, point), dot(y, point)];
    let pose = spatial_pose(motion, 0.0).ok()?;
    let turn = [(speed * step).cos(), (speed * step).sin()];
    let place = |k: u8| spatial_pose(motion, f64::from(k) * step).map(|pose| in_plane(pose.origin)).ok();
    let places = [place(0)?, place(1)?, place(2)?, place(3)?, place(4)?];
    // Differences eliminate the constant term, then the term that rotates with the body.
    let moved = [0, 1, 2, 3].map(|k: usize| minus(places[k + 1], places[k]));
    let round = [0, 1, 2].map(|k: usize| minus(moved[k + 1], times(turn, moved[k])));
    let carrier = over(round[1], round[0]);
    let [floor, relative] = NOWHERE;
    let steady = size(minus(round[2], times(carrier, round[1]))) <= relative * size(round[0])
        && (size(carrier) - 1.0).abs() <= relative
        && size(minus(carrier, turn)) > relative;
    let off = over(minus(moved[0], over(round[0], minus(carrier, turn))), minus(turn, [1.0, 0.0]));
    let farthest = places.into_iter().map(size).fold(0.0, f64::max);
    let from_pin = [0, 1, 2].map(|k: usize| off[0] * x[k] + off[1] * y[k]);
    (steady && size(off) > floor + relative * farthest)
        .then(|| [0, 1, 2].map(|k: usize| -dot(pose.rotation.map(|row| row[k]), from_pin)))
}

/// Returns the rate of a body's [`Orientation::angle`], rad/s.
pub fn rotation_speed(motion: &dyn Motion, time: f64) -> Result<f64, EngineError> {
    let [x, y, z] = Orientation::of(&spatial_pose(motion, time)?).axis();
    let [along_x, along_y, along_z] = angular_velocity(motion, time);
    if z <= OPPOSITE {
        return Ok(-along_z);
    }
    // Complete for a fixed axis, and for one that precesses about e3 at the speed of the body's
    // rotation.
    Ok((along_x * x + along_y * y + along_z * (1.0 + z)) / (1.0 + z))
}
