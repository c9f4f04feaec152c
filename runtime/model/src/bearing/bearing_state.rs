//! Kinematics of bearings: their position and axes at a time, and deflections due to motions of
//! frames.

use super::{Bearing, Support};
use crate::body::Body;
use crate::dof::Dof;
use crate::ids::BodyId;
use crate::motion::{Orientation, axle, point_velocity, spatial_pose};
use calyx_contact::solid::Pose;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::{Vector, cross, dot, length, minus};

/// Position and axes of a bearing at a time.
pub struct BearingState {
    /// Origin in ground coordinates, m.
    pub origin: Vector,
    /// x, y and z axes of the bearing along those of ground.
    pub axes: [Vector; 3],
    /// Centres of rotation of the two bodies, m, that of the first race's body first; arbitrary for
    /// ground.
    axles: [Vector; 2],
    bodies: [Option<BodyId>; 2],
    /// Directions of the DOFs of either body.
    dofs: [[Vector; 3]; 2],
}

/// Tolerance of the separation of the races, relative to the size of the bodies.
const TOGETHER: f64 = 1e-7;

impl BearingState {
    /// Computes the position and axes of a bearing at a time (s).
    ///
    /// # Errors
    /// E0687: the races have separated; E0710: a frame is NaN.
    pub fn at(bodies: &[Body], bearing: &Bearing, time: f64) -> Result<BearingState, EngineError> {
        let placed = BearingState::first_race(bodies, bearing, time)?;
        // The second race remains fixed to its own body.
        let start = BearingState::first_race(bodies, bearing, 0.0)?;
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

    fn first_race(bodies: &[Body], bearing: &Bearing, time: f64) -> Result<BearingState, EngineError> {
        let first = pose(bodies, bearing.body, time)?;
        let axle_of = |body: BodyId| body_of(bodies, body).map(|body| axle(body.motion.as_ref()));
        let (second, other, other_axle) = match bearing.to {
            Support::Ground => (Pose::IDENTITY, None, [0.0; 3]),
            Support::Body(body) => (pose(bodies, body, time)?, Some(body), axle_of(body)?),
        };
        let z = first.direction([0.0, 0.0, 1.0]);
        // If the axis is along x, use y instead.
        let across = match second.direction([1.0, 0.0, 0.0]) {
            x if dot(x, z).abs() < 0.9 => x,
            _ => second.direction([0.0, 1.0, 0.0]),
        };
        let along = dot(across, z);
        let square: Vector = std::array::from_fn(|k| across[k] - along * z[k]);
        let size = length(square);
        let x = square.map(|entry| entry / size);
        Ok(BearingState {
            origin: first.point(bearing.at),
            axes: [x, cross(z, x), z],
            axles: [first.point(axle_of(bearing.body)?), second.point(other_axle)],
            bodies: [Some(bearing.body), other],
            dofs: [Orientation::of(&first).axes, Orientation::of(&second).axes],
        })
    }

    /// Returns the deflection along and about the bearing's axes by a unit of a DOF: m per m or
    /// rad, and rad per rad.
    pub fn deflection(&self, dof: &Dof) -> [f64; 6] {
        let [first, second] = [0, 1].map(|race| self.moved(race, dof));
        std::array::from_fn(|k| first[k] - second[k])
    }

    /// Returns the motion of a race at the bearing's origin, along and about its axes, by a unit of
    /// a DOF.
    fn moved(&self, race: usize, dof: &Dof) -> [f64; 6] {
        if self.bodies[race] != Some(BodyId(dof.body)) {
            return [0.0; 6];
        }
        let axis = self.dofs[race][dof.component % 3];
        let is_rotation = dof.component >= 3;
        let moved = if is_rotation { cross(axis, minus(self.origin, self.axles[race])) } else { axis };
        let about = if is_rotation { axis } else { [0.0; 3] };
        let [x, y, z] = self.axes.map(|along| dot(along, moved));
        let [about_x, about_y, about_z] = self.axes.map(|along| dot(along, about));
        [x, y, z, about_x, about_y, about_z]
    }

    /// Returns the motions of both races at the bearing's origin, along and about its axes, m and
    /// rad, at these values of the DOFs.
    pub fn motions(&self, dofs: &[Dof], values: &[f64]) -> [[f64; 6]; 2] {
        [0, 1].map(|race| {
            let mut sum = [0.0; 6];
            for (dof, value) in dofs.iter().zip(values) {
                let unit = self.moved(race, dof);
                sum.iter_mut().zip(unit).for_each(|(sum, part)| *sum += value * part);
            }
            sum
        })
    }

    /// Transforms a vector from bearing to ground axes.
    pub fn to_ground(&self, v: Vector) -> Vector {
        std::array::from_fn(|k| (0..3).map(|axis| self.axes[axis][k] * v[axis]).sum())
    }

    /// Transforms a force and a moment on the first race, along the bearing's axes, to a force and
    /// a moment on a connected body about its axis of rotation, along ground axes.
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

/// Checks that at time 0 the first body rotates only about the bearing's axis, relative to the
/// second.
pub(super) fn check_races(bodies: &[Body], bearing: &Bearing) -> Result<(), EngineError> {
    let placed = BearingState::at(bodies, bearing, 0.0)?;
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
    let other_loads =
        |axis: usize| -> Vector { std::array::from_fn(|k| placed.origin[k] + radius * placed.axes[axis][k]) };
    // Rotation about the axis does not move points of the axis.
    let speed = [0, 1].map(|axis| length(relative(other_loads(axis)))).into_iter().fold(0.0, f64::max);
    let fastest =
        [relative(placed.origin), relative(other_loads(2))].map(length).into_iter().fold(0.0, f64::max);
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
    spatial_pose(body_of(bodies, body)?.motion.as_ref(), time)
        .map_err(|error| error.about(Subject::Body(body.0)))
}

/// Returns a body of the scene.
///
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
