//! Checks of meshes on general axes, and their findings.

use crate::assembly::gear_of;
use crate::axes::LARGEST_MISALIGNMENT;
use crate::error::{GeometryError, Refusal, sentence};
use calyx_runtime::error::EngineError;
use calyx_runtime::mesh_carrier::{CarrierVelocity, MeshAxes};
use calyx_runtime::motion::{
    Motion, Orientation, angular_velocity, point_velocity, rotation_speed, spatial_pose,
};
use calyx_runtime::scene::{BodyId, Scene};
use calyx_runtime::vec3::{cross, dot, length, minus, scaled, unit};
use std::f64::consts::TAU;

/// Largest velocity of an axis, relative to that of the teeth.
const AT_REST: f64 = 1e-9;
/// Relative tolerance of speeds.
const SAME_SPEED: f64 = 1e-9;
/// Contact ratio below which a warning is issued.
const LEAST_CONTACT_RATIO: f64 = 1.0;

/// Returns whether two bodies mesh on general axes: their axes are not parallel, or one of them is
/// no involute gear.
///
/// # Errors
/// E0710: a frame is NaN or infinite.
pub(crate) fn is_general(scene: &Scene, ids: [BodyId; 2]) -> Result<bool, EngineError> {
    if has_tabulated_teeth(scene, ids) {
        return Ok(true);
    }
    let [first, second] = [axis(scene, ids[0])?, axis(scene, ids[1])?];
    Ok(length(cross(first, second)).atan2(dot(first, second)) > LARGEST_MISALIGNMENT)
}

/// Returns whether one of two bodies is no involute gear.
pub(super) fn has_tabulated_teeth(scene: &Scene, ids: [BodyId; 2]) -> bool {
    ids.iter().any(|id| gear_of(scene, *id).is_none())
}

fn motion(scene: &Scene, id: BodyId) -> &dyn Motion {
    scene.bodies[id.0].motion.as_ref()
}

/// Returns the direction of a body's axis at time 0.
fn axis(scene: &Scene, id: BodyId) -> Result<[f64; 3], EngineError> {
    Ok(Orientation::of(&spatial_pose(motion(scene, id), 0.0)?).axis())
}

/// Axes of two meshing bodies and the motion of their carrier at time 0.
pub(super) struct Carried<'a> {
    motions: [&'a dyn Motion; 2],
    axes: MeshAxes,
    velocity: CarrierVelocity,
    /// True if the carrier moves.
    moves: bool,
}

impl<'a> Carried<'a> {
    /// Determines the carrier in which both axes are at rest.
    ///
    /// # Errors
    /// E0710: a frame is NaN or infinite. E0886: the axes move relative to each other.
    pub fn of(scene: &'a Scene, ids: [BodyId; 2]) -> Result<Carried<'a>, Refusal> {
        let motions = ids.map(|id| motion(scene, id));
        let axes = MeshAxes::at(motions, 0.0)?;
        let velocity = axes.carrier_velocity(motions, 0.0);
        let mut moves = false;
        for (side, argument) in [(0, "first"), (1, "second")] {
            let body = &scene.bodies[ids[side].0];
            let (point, direction) = (axes.points[side], axes.directions[side]);
            let turning = angular_velocity(motions[side], 0.0);
            let fastest = length(turning).max(length(velocity.angular));
            let rim = fastest * body.prototype.enclosing_radius().max(length(minus(point, axes.points[0])));
            let moving = point_velocity(motions[side], 0.0, point);
            let leans = cross(minus(turning, velocity.angular), direction);
            let apart = length(minus(moving, velocity.at(point))) > AT_REST * rim;
            if apart || length(leans) > AT_REST * fastest {
                return Err(EngineError::new(
                    "E0886",
                    format!("the axis of \"{}\" moves relative to that of its mate", body.name),
                    "begin the product of each frame with the rotation about its axis, e3, and end both with the motion of the same carrier, like `Rotate(speed * Time, e3) * Rotate(90 deg, e2) * Translate(...) * Rotate(carrier * Time, e3)`",
                )
                .blame(argument)
                .into());
            }
            // Rounding errors of fixed axes count as zero.
            moves |= length(moving) > AT_REST * rim
                || length(cross(turning, direction)) > AT_REST * length(turning);
        }
        Ok(Carried { motions, axes, velocity, moves })
    }

    /// Returns the angular velocity of the carrier along ground axes, rad/s; zero if the axes are
    /// at rest.
    pub fn angular_velocity(&self) -> [f64; 3] {
        if self.moves { self.velocity.angular } else { [0.0; 3] }
    }

    /// Returns the speed of a member about its own axis relative to the carrier, rad/s.
    fn speed(&self, side: usize) -> Result<f64, EngineError> {
        if !self.moves {
            return rotation_speed(self.motions[side], 0.0);
        }
        let relative = minus(angular_velocity(self.motions[side], 0.0), self.velocity.angular);
        Ok(dot(relative, self.axes.directions[side]))
    }
}

/// Returns the speeds of both bodies about their axes, relative to their carrier, if they match the
/// numbers of teeth.
///
/// # Errors
/// E0650, E0651.
pub(super) fn check_speeds(carried: &Carried<'_>, teeth: [u32; 2]) -> Result<[f64; 2], Refusal> {
    let speeds = [carried.speed(0)?, carried.speed(1)?];
    let ratio = f64::from(teeth[0]) / f64::from(teeth[1]);
    let carrier = length(carried.angular_velocity());
    if speeds[0].abs() <= SAME_SPEED * carrier {
        return Err(GeometryError::error(
            "E0650",
            "first",
            match carried.moves {
                true => sentence!["the first gear does not rotate relative to the carrier of both axes, so its mesh has no cycle"],
                false => sentence!["the first gear does not rotate, so its mesh has no cycle"],
            },
            sentence!["let the frames rotate with Time, like `Rotate(3 rpm * Time, e3) * ...`"],
        )
        .into());
    }
    let fitting = (speeds[0] * ratio).abs();
    // Speeds relative to a carrier are differences.
    if (speeds[1].abs() - fitting).abs() > SAME_SPEED * fitting.max(carrier) {
        return Err(GeometryError::error(
            "E0651",
            "second",
            sentence![
                "the second gear turns ", number (speeds[1] / speeds[0]).abs(), " times as fast as the first, but with ",
                number f64::from(teeth[0]), " and ", number f64::from(teeth[1]), " teeth it must turn ",
                number ratio, " times"
            ],
            sentence![
                "rotate the second frame about its own axis by the angle of the first, times the teeth of the first gear over those of the second; on a carrier, such as the case of a differential, both frames end with its motion"
            ],
        )
        .into());
    }
    Ok(speeds)
}

/// Checks that the tooth traces of two cylindrical gears agree where the gears meet, so that
/// crossed helical gears are not taken for a wrong frame.
///
/// # Errors
/// E0648: the traces cross. E0884: internal teeth, or axes that intersect.
pub(super) fn trace_angle(scene: &Scene, ids: [BodyId; 2]) -> Result<(), Refusal> {
    let [Some(first), Some(second)] = ids.map(|id| gear_of(scene, id)) else { return Ok(()) };
    if first.form().internal || second.form().internal {
        let help = "place the axes of a gear and of its ring parallel to each other";
        return Err(EngineError::new("E0884", "internal gears mesh on parallel axes only", help)
            .blame("second")
            .into());
    }
    let axes = [axis(scene, ids[0])?, axis(scene, ids[1])?];
    if length(cross(axes[0], axes[1])) <= LARGEST_MISALIGNMENT {
        let message = "the axes of the two gears have opposite directions";
        let help = "let e3 of both frames have the same direction; then the gears rotate in opposite senses";
        return Err(EngineError::new("E0648", message, help).blame("second").into());
    }
    let origin = |id: BodyId| spatial_pose(motion(scene, id), 0.0).map(|pose| pose.origin);
    let apart = minus(origin(ids[1])?, origin(ids[0])?);
    let crossing = unit(cross(axes[0], axes[1]));
    let distance = dot(apart, crossing);
    let least = 0.5 * (first.form().base_radius + second.form().base_radius);
    if distance.abs() < least {
        return Err(GeometryError::error(
            "E0884",
            "second",
            sentence![
                "the axes of these cylindrical gears pass each other at a distance of only ", length distance.abs()
            ],
            sentence![
                "crossed helical gears need a centre distance of about the sum of their pitch radii, ",
                length first.form().pitch_radius + second.form().pitch_radius, "; intersecting axes need bevel gears"
            ],
        )
        .into());
    }
    // From the first axis to the second along their common perpendicular.
    let across = scaled(crossing, distance.signum());
    let trace = |axis: [f64; 3], outwards: [f64; 3], angle: f64| {
        let around = cross(axis, outwards);
        [0, 1, 2].map(|k: usize| axis[k] * angle.cos() + around[k] * angle.sin())
    };
    let one = trace(axes[0], across, first.helix.signed_angle());
    let other = trace(axes[1], scaled(across, -1.0), second.helix.signed_angle());
    let angle = length(cross(one, other)).atan2(dot(one, other).abs());
    if angle <= LARGEST_MISALIGNMENT {
        return Ok(());
    }
    let shaft = length(cross(axes[0], axes[1])).atan2(dot(axes[0], axes[1]));
    let sum = (first.helix.signed_angle() + second.helix.signed_angle()).abs();
    Err(GeometryError::error(
        "E0648",
        "second",
        sentence![
            "the axes of the two gears are ", angle shaft, " from parallel, and their teeth cross at ", angle angle,
            " where the gears meet"
        ],
        sentence![
            "make the axes parallel to within ", angle LARGEST_MISALIGNMENT,
            ", or let crossed helical gears have the shaft angle that is the sum of their helix angles (right-handed ones positive), ",
            angle sum, ", in the other sense of rotation if it is that already"
        ],
    )
    .into())
}

/// Error about flanks that have no point of contact.
pub(super) fn no_contact(reversed: bool) -> GeometryError {
    let help = match reversed {
        true => sentence![
            "let the second gear turn about its axis in the other sense: its teeth would then touch those of the first"
        ],
        false => sentence![
            "check the frames: the axis of a gear is e3 of its frame, and the teeth of both gears must overlap where they meet"
        ],
    };
    GeometryError::error(
        "E0884",
        "second",
        sentence!["the driving flanks of these gears do not face each other anywhere at time 0"],
        help,
    )
}

/// Error about a misalignment.
pub(super) fn misaligned() -> EngineError {
    EngineError::new(
        "E0885",
        "`misalignment` refers to the plane of action of gears on parallel axes",
        "leave it out, and displace or tilt the `frame` of a gear",
    )
    .blame("misalignment")
}

/// Error about a loop of meshes that cannot be assembled.
pub(super) fn unfit_loop(angle: f64) -> GeometryError {
    GeometryError::error(
        "E0887",
        "second",
        sentence![
            "these gears cannot be assembled: both are phased by earlier meshes, and the second gear would have to turn by ",
            angle angle, " to touch the first"
        ],
        sentence!["check the numbers of teeth and the positions of the axes in the loop"],
    )
}

/// Warning about flanks that touch at edges only.
pub(super) fn edge_contact(tabulated: bool) -> GeometryError {
    let help = match tabulated {
        true => sentence![
            "check the frames and the helix or spiral angles: contact of the flanks is usual. Or the flanks are hollow: see the ease-off in the report"
        ],
        false => sentence!["check the frames and the helix or spiral angles: contact of the flanks is usual"],
    };
    GeometryError::warning(
        "W0860",
        "second",
        sentence!["without load these gears touch at edges of their teeth only"],
        help,
    )
}

/// Warning about interrupted contact.
pub(super) fn low_contact_ratio(ratio: f64, tabulated: bool) -> Option<GeometryError> {
    let help = match tabulated {
        true => sentence![
            "with less ease-off along the path of contact (see the report) or higher teeth, pairs overlap; under load they may do so anyway: declare an output of `gears.pairs_in_contact` to see it"
        ],
        false => sentence!["give the teeth more depth or a larger face width"],
    };
    (ratio < LEAST_CONTACT_RATIO).then(|| {
        GeometryError::warning(
            "W0861",
            "second",
            sentence![
                "without load a pair of teeth is in contact for ", number ratio, " pitches only: edges touch in between"
            ],
            help,
        )
    })
}

/// Warning about teeth that leave large spaces. Both angles are rotations of the second gear.
pub(super) fn large_backlash(backlash: f64, pitch: f64) -> GeometryError {
    let teeth = (TAU / pitch).round();
    GeometryError::warning(
        "W0868",
        "second",
        sentence![
            "the second gear, with ", number teeth, " teeth, has a backlash of ", angle backlash, ", which is ",
            number 100.0 * backlash / pitch, " % of its pitch"
        ],
        sentence![
            "compare the tooth thickness of both gears with the drawing: their sum is usually a little less than the circular pitch"
        ],
    )
}

/// Warning about teeth that fill the spaces.
pub(super) fn no_backlash(overlap: f64, tabulated: bool) -> GeometryError {
    let help = match tabulated {
        true => sentence![
            "reduce the tooth thickness of a gear (`thickness` of `bevel_gear.gear`), or check the frames and the alignment"
        ],
        false => sentence!["reduce `tooth_thickness`, or place the axes farther apart"],
    };
    GeometryError::warning(
        "W0862",
        "second",
        sentence![
            "the gears have no backlash: their coast flanks overlap by ", length overlap,
            ". Contact is searched on the driving flanks only"
        ],
        help,
    )
}
