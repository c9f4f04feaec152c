//! Where a bearing is at a time, and what the motions of frames do to it.

use super::{Bearing, Support};
use crate::body::Body;
use crate::freedom::Freedom;
use crate::ids::BodyId;
use crate::motion::{Stance, axle, point_velocity, pose_in_space};
use calyx_contact::solid::Pose;
use calyx_numerics::error::{EngineError, Subject};

type Vector = [f64; 3];

/// A bearing at a time.
pub struct Placed {
    /// m, in ground coordinates.
    pub origin: Vector,
    /// The bearing's x, y and z axes along those of ground.
    pub axes: [Vector; 3],
    /// Of the bodies, about which they turn, m: that of the first race's and that of the second's, which for ground is anywhere.
    axles: [Vector; 2],
    bodies: [Option<BodyId>; 2],
    /// Along and about which the freedoms of either body count.
    freedoms: [[Vector; 3]; 2],
}

/// How far races may part, beside the size of the bodies they are on.
const TOGETHER: f64 = 1e-7;

impl Placed {
    /// # Errors
    /// E0687: the races have parted; E0710: a frame is not a number.
    pub fn at(bodies: &[Body], bearing: &Bearing, time: f64) -> Result<Placed, EngineError> {
        let placed = Placed::of_first_race(bodies, bearing, time)?;
        // The second race stays where it was on its own body.
        let start = Placed::of_first_race(bodies, bearing, 0.0)?;
        let carried = |point: Vector, direction: Vector| -> Result<[Vector; 2], EngineError> {
            let Support::Body(body) = bearing.to else { return Ok([point, direction]) };
            let (then, now) = (pose(bodies, body, 0.0)?, pose(bodies, body, time)?);
            let back = |v: Vector| -> Vector {
                std::array::from_fn(|axis| (0..3).map(|row| then.rotation[row][axis] * v[row]).sum())
            };
            let from = minus(point, then.origin);
            Ok([now.point(back(from)), now.direction(back(direction))])
        };
        let [origin, axis] = carried(start.origin, start.axes[2])?;
        let size = length(minus(placed.origin, placed.axles[0]))
            + body_of(bodies, bearing.body)?.prototype.enclosing_radius();
        let (apart, tilted) = (length(minus(placed.origin, origin)), length(minus(placed.axes[2], axis)));
        if apart > TOGETHER * size || tilted > TOGETHER {
            return Err(parted(bearing, &format!("at Time = {time} s")));
        }
        Ok(placed)
    }

    fn of_first_race(bodies: &[Body], bearing: &Bearing, time: f64) -> Result<Placed, EngineError> {
        let first = pose(bodies, bearing.body, time)?;
        let axle_of = |body: BodyId| body_of(bodies, body).map(|body| axle(body.motion.as_ref()));
        let (second, other, other_axle) = match bearing.to {
            Support::Ground => (Pose::IDENTITY, None, [0.0; 3]),
            Support::Body(body) => (pose(bodies, body, time)?, Some(body), axle_of(body)?),
        };
        let z = first.direction([0.0, 0.0, 1.0]);
        // An axis that lies along x takes y in its place.
        let across = match second.direction([1.0, 0.0, 0.0]) {
            x if dot(x, z).abs() < 0.9 => x,
            _ => second.direction([0.0, 1.0, 0.0]),
        };
        let along = dot(across, z);
        let square: Vector = std::array::from_fn(|k| across[k] - along * z[k]);
        let size = length(square);
        let x = square.map(|entry| entry / size);
        Ok(Placed {
            origin: first.point(bearing.at),
            axes: [x, cross(z, x), z],
            axles: [first.point(axle_of(bearing.body)?), second.point(other_axle)],
            bodies: [Some(bearing.body), other],
            freedoms: [Stance::of(&first).axes, Stance::of(&second).axes],
        })
    }

    /// The deflection, along and about the bearing's axes, by a unit of a freedom: m per m or rad, and rad per rad.
    pub fn deflection(&self, freedom: &Freedom) -> [f64; 6] {
        let mut deflection = [0.0; 6];
        for (side, sign) in [(0, 1.0), (1, -1.0)] {
            if self.bodies[side] != Some(BodyId(freedom.body)) {
                continue;
            }
            let axis = self.freedoms[side][freedom.component % 3].map(|part| sign * part);
            let turns = freedom.component >= 3;
            let moved = if turns { cross(axis, minus(self.origin, self.axles[side])) } else { axis };
            for (row, along) in self.axes.iter().enumerate() {
                deflection[row] += dot(*along, moved);
                if turns {
                    deflection[3 + row] += dot(*along, axis);
                }
            }
        }
        deflection
    }

    /// A vector given along the bearing's axes, along those of ground.
    pub fn to_ground(&self, v: Vector) -> Vector {
        std::array::from_fn(|k| (0..3).map(|axis| self.axes[axis][k] * v[axis]).sum())
    }

    /// What a force and a moment on the first race, along the bearing's axes, are on a body it connects: a force and a moment about the
    /// body's axle, along ground axes.
    pub fn wrench_on(&self, body: BodyId, force: [f64; 6]) -> [f64; 6] {
        let [fx, fy, fz, mx, my, mz] = force;
        let (force, moment) = (self.to_ground([fx, fy, fz]), self.to_ground([mx, my, mz]));
        let mut wrench = [0.0; 6];
        for (side, sign) in [(0, 1.0), (1, -1.0)] {
            if self.bodies[side] == Some(body) {
                let turned = cross(minus(self.origin, self.axles[side]), force);
                for k in 0..3 {
                    wrench[k] += sign * force[k];
                    wrench[3 + k] += sign * (moment[k] + turned[k]);
                }
            }
        }
        wrench
    }
}

/// That the first body turns about the bearing's axis alone, as seen from the second, as the scene begins.
pub(super) fn check_races(bodies: &[Body], bearing: &Bearing) -> Result<(), EngineError> {
    let placed = Placed::at(bodies, bearing, 0.0)?;
    let first = body_of(bodies, bearing.body)?;
    let second = match bearing.to {
        Support::Ground => None,
        Support::Body(body) => Some(body_of(bodies, body)?),
    };
    let radius = first.prototype.enclosing_radius();
    let relative = |point: Vector| {
        let velocity = |body: &Body| point_velocity(body.motion.as_ref(), 0.0, point);
        second.map_or(velocity(first), |second| minus(velocity(first), velocity(second)))
    };
    let beside =
        |axis: usize| -> Vector { std::array::from_fn(|k| placed.origin[k] + radius * placed.axes[axis][k]) };
    // Points of the axis rest, whatever turns about it moves.
    let speed = [0, 1].map(|axis| length(relative(beside(axis)))).into_iter().fold(0.0, f64::max);
    let fastest = [relative(placed.origin), relative(beside(2))].map(length).into_iter().fold(0.0, f64::max);
    if fastest > TOGETHER * speed.max(fastest) {
        return Err(parted(bearing, "as the frames move"));
    }
    Ok(())
}

fn parted(bearing: &Bearing, when: &str) -> EngineError {
    EngineError::new(
        "E0687",
        format!("the races of bearing \"{}\" do not stay together {when}", bearing.name),
        "put it on the axis about which the body turns: `at` is along e3 of the body's own frame, and what it is mounted on (`to`) moves with that axis",
    )
    .blame("at")
}

fn pose(bodies: &[Body], body: BodyId, time: f64) -> Result<Pose, EngineError> {
    pose_in_space(body_of(bodies, body)?.motion.as_ref(), time)
        .map_err(|error| error.about(Subject::Body(body.0)))
}

/// # Errors
/// E0653: the scene has no such body.
fn body_of(bodies: &[Body], body: BodyId) -> Result<&Body, EngineError> {
    bodies.get(body.0).ok_or_else(|| {
        EngineError::new(
            "E0653",
            format!("a bearing is on body {}, and the scene has {}", body.0, bodies.len()),
            "give what `add_body` of this very scene returned",
        )
        .blame("body")
    })
}

fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn length(a: Vector) -> f64 {
    dot(a, a).sqrt()
}
