//! Distance between a bearing and the attachments of elastic bodies that it is mounted on.
//!
//! A bearing acts at one point of both its bodies. Any body could reach that point by a rigid arm,
//! so a bearing that is mounted on the wrong attachment has an equilibrium like any other. The
//! extents of the attachments show the mistake.

use crate::bearing::{Bearing, Support};
use crate::body::Body;
use crate::connection::ElasticConnection;
use crate::elastic_body::AttachmentExtent;
use crate::ids::BodyId;
use crate::motion::spatial_pose;
use calyx_contact::solid::Pose;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, dot, length, minus};

/// Distance of a bearing from an attachment, relative to the size of its region, from which it is
/// reported. Smaller ones are tolerances of meshes, such as shells in the middle of a wall.
const REPORTED: f64 = 0.1;
/// The same distance from which the bearing is rejected.
const REJECTED: f64 = 1.0;
/// Distance of a bearing from the axis of a cylinder, relative to its radius, from which it is
/// reported.
const OFF_AXIS: f64 = 0.05;
/// Angle between the axis of a bearing and that of its cylinder from which it is reported, rad.
const TILTED: f64 = 0.1;

/// A bearing away from an attachment that it is mounted on.
#[derive(Clone, Debug, PartialEq)]
pub struct MisplacedBearing {
    /// Distance in words, with the remedy (E0993).
    pub error: EngineError,
    /// True if the bearing is too far away to be mounted there; false if a rigid arm between both
    /// could be intended.
    pub impossible: bool,
}

/// Checks that a bearing is where it is mounted, at time 0. Returns the worst finding.
///
/// # Errors
/// E0710: a frame is NaN.
pub fn misplaced(
    bodies: &[Body],
    connections: &[ElasticConnection],
    bearing: &Bearing,
) -> Result<Option<MisplacedBearing>, EngineError> {
    let Some(first) = bodies.get(bearing.body.0) else { return Ok(None) };
    let pose = spatial_pose(first.motion.as_ref(), 0.0)?;
    let (point, axis) = (pose.point(bearing.at), pose.direction([0.0, 0.0, 1.0]));
    let mut worst: Option<MisplacedBearing> = None;
    for id in bearing.bodies() {
        let Some((position, extent)) = attachment(connections, id) else { continue };
        let body = &bodies[id.0];
        let placed = spatial_pose(body.motion.as_ref(), 0.0)?;
        let back = |v: Vector| back(&placed, v);
        // The frame of an attachment has its origin at the attachment.
        let from = back(minus(point, placed.origin));
        let at: Vector = std::array::from_fn(|k| position[k] + from[k]);
        let on_first = id == bearing.body;
        let found = distance_finding(bearing, &body.name, (at, position), &extent, on_first)
            .or_else(|| axis_finding(bearing, &body.name, (at, back(axis)), &extent));
        if worst.as_ref().is_none_or(|worst| !worst.impossible) {
            worst = found.or(worst);
        }
    }
    Ok(worst)
}

/// Returns the position and the extent of the attachment that a body is, in the coordinates of the
/// elastic body.
fn attachment(connections: &[ElasticConnection], id: BodyId) -> Option<(Vector, AttachmentExtent)> {
    connections.iter().find_map(|connection| {
        let body = &connection.body.as_ref()?.0;
        let index =
            connection.attachments.iter().position(|attachment| attachment.to == Support::Body(id))?;
        Some((*body.positions().get(index)?, *body.extents().get(index)?))
    })
}

/// Transforms a vector from ground axes to those of a body.
fn back(pose: &Pose, v: Vector) -> Vector {
    std::array::from_fn(|axis| (0..3).map(|row| pose.rotation[row][axis] * v[row]).sum())
}

fn distance_finding(
    bearing: &Bearing,
    name: &str,
    (at, position): (Vector, Vector),
    extent: &AttachmentExtent,
    on_first: bool,
) -> Option<MisplacedBearing> {
    let distance = extent.distance(at).min(length(minus(at, position)));
    if distance <= REPORTED * extent.size || distance == 0.0 {
        return None;
    }
    let impossible = distance > REJECTED * extent.size;
    let [x, y, z] = at.map(mm);
    let message = format!(
        "the bearing \"{}\" is {} mm away from \"{name}\", on which it is mounted and whose region is {} mm wide: it is at ({x}, {y}, {z}) mm in the coordinates of the elastic body",
        bearing.name,
        mm(distance),
        mm(extent.size)
    );
    let help = match (on_first, impossible) {
        (true, _) => "give `at` from the attachment, which is the origin of its frame",
        (false, true) => {
            "mount the bearing on the attachment at its position, or correct the frames and `at`; an arm between them is a part of the elastic body"
        }
        (false, false) => {
            "correct the frames or `at`, or enlarge the region, unless a rigid arm of this length is intended"
        }
    };
    let argument = if on_first { "at" } else { "to" };
    let error = EngineError::new("E0993", message, help).blame(argument);
    Some(MisplacedBearing { error, impossible })
}

fn axis_finding(
    bearing: &Bearing,
    name: &str,
    (at, direction): (Vector, Vector),
    extent: &AttachmentExtent,
) -> Option<MisplacedBearing> {
    let (axis, radius) = extent.cylinder?;
    let distance = axis.distance(at);
    let angle = dot(axis.direction, direction).abs().min(1.0).acos();
    let size = mm(radius);
    let (message, help) = if distance > OFF_AXIS * radius {
        let message = format!(
            "the bearing \"{}\" is {} mm off the axis of \"{name}\", a cylinder of radius {size} mm",
            bearing.name,
            mm(distance)
        );
        (
            message,
            "correct the frames, `at` or `center` of the cylinder, unless this eccentricity is intended",
        )
    } else if angle > TILTED {
        let message = format!(
            "the axis of the bearing \"{}\" is {} degrees to that of \"{name}\", a cylinder of radius {size} mm",
            bearing.name,
            (angle.to_degrees() * 10.0).round() / 10.0
        );
        (
            message,
            "correct `axis` of the cylinder or the frame of the body, whose e3 is the axis of the bearing",
        )
    } else {
        return None;
    };
    let error = EngineError::new("E0993", message, help).blame("to");
    Some(MisplacedBearing { error, impossible: distance > REJECTED * radius })
}

/// Rounds a length to micrometres and converts it to mm.
fn mm(metres: f64) -> f64 {
    (metres * 1e6).round() / 1e3 + 0.0
}
