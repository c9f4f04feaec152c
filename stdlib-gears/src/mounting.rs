//! Mounting two gears so that they touch: the second one's phase, and the cycle of their mesh.
//!
//! With `sense` = +1 the first gear pushes counter-clockwise (its surface 0 touches), with -1 clockwise (surface 1).
//! A flank of tooth `k` of a gear turned by `theta` has its base tangent point at `theta + 2 pi k / N + sense (h - g)`,
//! where `g` is the roll angle of contact and `h` half the base angle of the tooth; on the line of action that is the
//! angle `c - sense a` for the first gear and `c - sense a + pi` for the second, where `c` is the direction of the line of
//! centres and `a` the operating pressure angle.

use crate::error::{GeometryError, sentence};
use crate::external::ExternalGear;
use crate::mesh_geometry::MeshGeometry;
use calyx_runtime::motion::PlanePose;
use calyx_runtime::scene::{CharacteristicPoint, GearMesh};
use std::f64::consts::{PI, TAU};

/// How two gears stand to each other at time 0.
#[derive(Clone, Copy, Debug)]
pub struct Mounting {
    /// Of the first gear's frame, with its phase.
    pub first: PlanePose,
    /// Of the second gear's frame, without a phase.
    pub second: PlanePose,
    /// rad/s, counter-clockwise.
    pub angular_velocity: [f64; 2],
    /// +1 if the first gear pushes counter-clockwise.
    pub sense: f64,
}

/// The second gear's phase (rad, added to its angle) and the mesh of two external gears.
///
/// # Errors
/// The motions do not fit the numbers of teeth, or there is no motion.
pub fn mount_external(
    gears: [&ExternalGear; 2],
    geometry: &MeshGeometry,
    mounting: &Mounting,
) -> Result<(f64, GearMesh), GeometryError> {
    let [first, second] = gears;
    let [pitch, second_pitch] = [first.pitch_angle(), second.pitch_angle()];
    let sense = mounting.sense;
    let centres = [0, 1].map(|i| mounting.second.origin[i] - mounting.first.origin[i]);
    let line_of_centres = centres[1].atan2(centres[0]);
    let pressure_angle = geometry.operating_pressure_angle;
    let speed = check_speeds(gears, mounting.angular_velocity)?;

    // Roll angle of the first gear's tooth 0, were it in contact: with the gear's angle at zero, and at time 0.
    let roll_at_zero = first.half_base_angle + pressure_angle - sense * line_of_centres;
    let roll_of_zero = roll_at_zero + sense * mounting.first.angle;
    // Angle of the second gear's tooth that touches that one.
    let opposite = line_of_centres
        + PI
        + sense * (geometry.second_roll(roll_of_zero) - second.half_base_angle - pressure_angle);
    let phase = nearest_to_zero(opposite - mounting.second.angle, second_pitch);

    let points = geometry.first_roll;
    // The first gear moves as it pushes, or it is driven back while it pushes.
    let forward = sense * speed > 0.0;
    let step = if forward { pitch } else { -pitch };
    let enters = if forward { points.start_of_active_profile } else { points.end_of_active_profile };
    let period = pitch / speed.abs();
    let rate = sense * speed;
    // The first tooth to enter at or after time 0.
    let start = ((enters - roll_of_zero) / rate).rem_euclid(period);
    let tooth = (sense * (enters - rate * start - roll_of_zero) / pitch).round();
    let second_angle = mounting.second.angle + phase + mounting.angular_velocity[1] * start;
    let second_place = line_of_centres
        + PI
        + sense * (geometry.second_roll(enters) - second.half_base_angle - pressure_angle);
    let second_tooth = ((second_place - second_angle) / second_pitch).round();

    let leaves = geometry.contact_ratio.fract() * period;
    let names = if forward { ["SAP", "EAP", "LPSTC", "HPSTC"] } else { ["EAP", "SAP", "HPSTC", "LPSTC"] };
    let point = |index: usize, time, after| CharacteristicPoint { name: names[index], time, after };
    let characteristic =
        vec![point(0, 0.0, true), point(1, leaves, false), point(2, leaves, true), point(3, period, false)];
    let mesh = GearMesh {
        teeth: [first.teeth, second.teeth],
        base_radii: geometry.base_radius,
        drive_sense: sense,
        sign: 1.0,
        entering: [index(tooth, first.teeth), index(second_tooth, second.teeth)],
        start,
        period,
        characteristic,
        roll: [enters, enters + step],
        path: [points.start_of_active_profile, points.end_of_active_profile],
        roll_at_zero,
    };
    Ok((phase, mesh))
}

/// The first gear's speed, if both speeds fit the numbers of teeth.
fn check_speeds(gears: [&ExternalGear; 2], speeds: [f64; 2]) -> Result<f64, GeometryError> {
    let [first, second] = speeds;
    let fitting = -first * f64::from(gears[0].teeth) / f64::from(gears[1].teeth);
    if first == 0.0 {
        return Err(GeometryError::error(
            "E0650",
            "first",
            sentence!["the first gear does not turn, so its mesh has no cycle"],
            sentence!["let the frames turn with Time, like `Rotate(3 rpm * Time, e3)`"],
        ));
    }
    if (second - fitting).abs() > 1e-9 * fitting.abs() {
        return Err(GeometryError::error(
            "E0651",
            "second",
            sentence![
                "the second gear turns ", number second / first, " times as fast as the first, but with ",
                number f64::from(gears[0].teeth), " and ", number f64::from(gears[1].teeth), " teeth it must turn ",
                number fitting / first, " times"
            ],
            sentence![
                "let the second frame's angle be minus the first's times the first's teeth over the second's"
            ],
        ));
    }
    Ok(first)
}

/// The tooth a whole, possibly negative, number of pitches on.
fn index(tooth: f64, teeth: u32) -> u32 {
    tooth.rem_euclid(f64::from(teeth)) as u32
}

/// `angle` less whole multiples of `pitch`, as near to zero as can be.
fn nearest_to_zero(angle: f64, pitch: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    turned - (turned / pitch).round() * pitch
}
