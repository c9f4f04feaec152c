//! Kinematics of elastic connections: positions and axes at a time, and motions of the attachments
//! due to motions of frames.

use super::ElasticConnection;
use crate::bearing::Support;
use crate::body::Body;
use crate::dof::Dof;
use crate::ids::BodyId;
use crate::motion::{Orientation, axle, point_velocity, spatial_pose};
use calyx_contact::solid::Pose;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::{Vector, cross, dot, length, minus};

/// Motion of an attachment, or force on it: along and about the reference axes.
pub type Six = [f64; 6];

/// Positions and axes of a connection at a time.
pub struct ConnectionState {
    /// Reference axes along those of ground: those of the body of the first attachment, for a shaft
    /// without its rotation.
    pub axes: [Vector; 3],
    attached: Vec<Attached>,
}

/// Attachment at a time, in ground coordinates.
struct Attached {
    body: Option<BodyId>,
    point: Vector,
    /// Position of the body's axis of rotation, to which its DOFs refer.
    axle: Vector,
    /// Directions of the DOFs.
    dofs: [Vector; 3],
}

/// Tolerance of relative motions of the attachments, relative to the size of the connection.
const TOGETHER: f64 = 1e-7;

impl ConnectionState {
    /// Computes the positions and axes of a connection at a time (s).
    ///
    /// # Errors
    /// E0869: the attachments have moved relative to the reference. E0710: a frame is NaN.
    pub fn at(
        bodies: &[Body],
        connection: &ElasticConnection,
        time: f64,
    ) -> Result<ConnectionState, EngineError> {
        let now = ConnectionState::placed(bodies, connection, time)?;
        if time != 0.0 {
            let start = ConnectionState::placed(bodies, connection, 0.0)?;
            let (now_at, start_at) = (now.positions(), start.positions());
            let size = start_at.iter().map(|at| length(*at)).fold(0.0, f64::max);
            let size = size.max(now_at.iter().map(|at| length(*at)).fold(0.0, f64::max));
            if let Some(index) =
                (0..now_at.len()).find(|&k| length(minus(now_at[k], start_at[k])) > TOGETHER * size)
            {
                return Err(parted(bodies, connection, index));
            }
        }
        Ok(now)
    }

    fn placed(
        bodies: &[Body],
        connection: &ElasticConnection,
        time: f64,
    ) -> Result<ConnectionState, EngineError> {
        let mut axes = None;
        let mut attached = Vec::with_capacity(connection.attachments.len());
        let mut latest: Option<(BodyId, Pose, [Vector; 3], Vector)> = None;
        for attachment in &connection.attachments {
            let Support::Body(id) = attachment.to else {
                axes.get_or_insert(Pose::IDENTITY.rotation);
                let dofs = Pose::IDENTITY.rotation;
                attached.push(Attached { body: None, point: attachment.at, axle: [0.0; 3], dofs });
                continue;
            };
            let (pose, dofs, axle) = match latest {
                Some((body, pose, dofs, axle)) if body == id => (pose, dofs, axle),
                _ => {
                    let body = body_of(bodies, id)?;
                    let pose = spatial_pose(body.motion.as_ref(), time)
                        .map_err(|error| error.about(Subject::Body(id.0)))?;
                    (pose, Orientation::of(&pose).axes, pose.point(axle(body.motion.as_ref())))
                }
            };
            latest = Some((id, pose, dofs, axle));
            // A shaft is a body of revolution: in axes that do not rotate with it, its modal
            // coordinates have no Coriolis and centrifugal forces beyond its gyroscopic matrix.
            axes.get_or_insert_with(|| match connection.shaft {
                Some(_) => dofs,
                None => [0, 1, 2].map(|axis: usize| pose.rotation.map(|row| row[axis])),
            });
            attached.push(Attached { body: Some(id), point: pose.point(attachment.at), axle, dofs });
        }
        Ok(ConnectionState { axes: axes.unwrap_or(Pose::IDENTITY.rotation), attached })
    }

    /// Returns the positions of the attachments relative to the first one, along the reference
    /// axes, m.
    pub fn positions(&self) -> Vec<Vector> {
        let Some(first) = self.attached.first() else { return Vec::new() };
        let along = |attached: &Attached| {
            let from = minus(attached.point, first.point);
            self.axes.map(|axis| dot(axis, from))
        };
        self.attached.iter().map(along).collect()
    }

    /// Returns the origin of the coordinates in which the first attachment has this position, in
    /// ground coordinates, m.
    pub fn origin(&self, position: Vector) -> Vector {
        let Some(first) = self.attached.first() else { return [0.0; 3] };
        minus(first.point, self.to_ground(position))
    }

    /// Returns the motions of the attachments, one entry per component, in each of the six
    /// rigid-body motions.
    pub(super) fn rigid_motions(&self) -> [Vec<f64>; 6] {
        let positions = self.positions();
        std::array::from_fn(|motion| {
            let mut axis = [0.0; 3];
            axis[motion % 3] = 1.0;
            let of = |at: &Vector| match motion < 3 {
                true => [axis, [0.0; 3]],
                false => [cross(axis, *at), axis],
            };
            positions.iter().flat_map(|at| of(at).concat()).collect()
        })
    }

    /// Returns the motions of the attachments due to a unit of a DOF, m per m or rad and rad per
    /// rad, for the attachments that it moves.
    pub fn moved(&self, dof: &Dof) -> Vec<(usize, Six)> {
        let own = self.attached.iter().enumerate().filter(|(_, to)| to.body == Some(BodyId(dof.body)));
        let of = |(index, attached): (usize, &Attached)| {
            let axis = attached.dofs[dof.component % 3];
            let [shift, turn] = match dof.component < 3 {
                true => [axis, [0.0; 3]],
                false => [cross(axis, minus(attached.point, attached.axle)), axis],
            };
            let along = |v: Vector| self.axes.map(|reference| dot(reference, v));
            let ([a, b, c], [d, e, f]) = (along(shift), along(turn));
            (index, [a, b, c, d, e, f])
        };
        own.map(of).collect()
    }

    /// Returns the motions of all attachments at these values of the DOFs.
    pub fn motions(&self, dofs: &[Dof], values: &[f64]) -> Vec<Six> {
        let mut motions = vec![[0.0; 6]; self.attached.len()];
        for (dof, value) in dofs.iter().zip(values) {
            for (index, unit) in self.moved(dof) {
                motions[index].iter_mut().zip(unit).for_each(|(sum, part)| *sum += value * part);
            }
        }
        motions
    }

    /// Transforms a vector from reference to ground axes.
    pub fn to_ground(&self, v: Vector) -> Vector {
        std::array::from_fn(|k| (0..3).map(|axis| self.axes[axis][k] * v[axis]).sum())
    }

    /// Transforms forces on all attachments, along the reference axes, to a force and a moment on a
    /// body about its axis of rotation, along ground axes.
    pub fn wrench_on(&self, body: BodyId, forces: &[Six]) -> Six {
        let mut wrench = [0.0; 6];
        for (attached, &[fx, fy, fz, mx, my, mz]) in self.attached.iter().zip(forces) {
            if attached.body == Some(body) {
                let (force, moment) = (self.to_ground([fx, fy, fz]), self.to_ground([mx, my, mz]));
                let turned = cross(minus(attached.point, attached.axle), force);
                for k in 0..3 {
                    wrench[k] += force[k];
                    wrench[3 + k] += moment[k] + turned[k];
                }
            }
        }
        wrench
    }

    /// Checks that at time 0 the attachments move like points of the reference, which may rotate.
    pub(super) fn check_velocities(
        &self,
        bodies: &[Body],
        connection: &ElasticConnection,
    ) -> Result<(), EngineError> {
        let velocity = |body: Option<BodyId>, point: Vector| -> Result<Vector, EngineError> {
            let Some(id) = body else { return Ok([0.0; 3]) };
            Ok(point_velocity(body_of(bodies, id)?.motion.as_ref(), 0.0, point))
        };
        let Some(reference) = self.attached.first() else { return Ok(()) };
        let size = self.positions().into_iter().map(length).fold(0.0, f64::max);
        // Speed of a point at this distance from the first attachment, for comparison.
        let mut fastest = 0.0_f64;
        for axis in self.axes {
            let point = std::array::from_fn(|k| reference.point[k] + size * axis[k]);
            fastest = fastest.max(length(velocity(reference.body, point)?));
        }
        for (index, attached) in self.attached.iter().enumerate() {
            let (own, carried) =
                (velocity(attached.body, attached.point)?, velocity(reference.body, attached.point)?);
            let fastest = fastest.max(length(own)).max(length(carried));
            if length(minus(own, carried)) > TOGETHER * fastest {
                return Err(parted(bodies, connection, index));
            }
        }
        Ok(())
    }
}

fn parted(bodies: &[Body], connection: &ElasticConnection, attachment: usize) -> EngineError {
    let what = match connection.attachments[attachment].to {
        Support::Ground => "ground".into(),
        Support::Body(id) => {
            bodies.get(id.0).map_or_else(String::new, |body| format!("body \"{}\"", body.name))
        }
    };
    EngineError::new(
        "E0869",
        format!("{what} moves away from its attachment to the elastic connection \"{}\"", connection.name),
        "let the frames of all connected bodies move together: build each from the frame of the first one",
    )
}

/// Returns a body of the scene.
///
/// # Errors
/// E0653: the scene has no such body.
fn body_of(bodies: &[Body], body: BodyId) -> Result<&Body, EngineError> {
    bodies.get(body.0).ok_or_else(|| {
        EngineError::new(
            "E0653",
            format!("an elastic connection is on body {}, and the scene has {}", body.0, bodies.len()),
            "give what `add_body` of this very scene returned",
        )
        .blame("body")
    })
}
