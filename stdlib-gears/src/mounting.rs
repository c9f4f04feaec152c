//! Mounting of two gears so that their teeth touch: the phase of the second gear, and the mesh
//! cycle.
//!
//! With `sense` = +1 the first gear pushes counter-clockwise (its surface 0 touches), with -1
//! clockwise (surface 1). A flank of tooth `k` of a gear rotated by `theta` has its base tangent
//! point at `theta + 2 pi k / N + sense (h - g)`, where `g` is the roll angle of contact and `h`
//! half the base angle of the tooth. On the line of action this is the angle `c - sense a` for the
//! first gear and `c - sense a + pi` for the second, where `c` is the direction of the line of
//! centres and `a` the operating pressure angle.
//!
//! Axes may move, as those of planets do. All angles are relative to the line of centres, whose
//! direction `c` is that of time 0; speeds are relative to it as well.
//!
//! In an internal gear both base tangent points lie in the direction `c - sense a + pi`. The flank
//! of the internal gear that touches is the one on the other side of the tooth, at
//! `theta + 2 pi k / N - sense (h - g)` with the negative roll angle of the internal gear.

use crate::error::{GeometryError, sentence};
use crate::gear::ToothForm;
use crate::mesh_geometry::MeshGeometry;
use calyx_runtime::motion::PlanePose;
use calyx_runtime::scene::{CharacteristicPoint, GearMesh};
use std::f64::consts::{PI, TAU};

/// Relative position of two gears at time 0.
#[derive(Clone, Copy, Debug)]
pub struct Mounting {
    /// Pose of the first gear's frame, including its phase.
    pub first: PlanePose,
    /// Pose of the second gear's frame, without a phase.
    pub second: PlanePose,
    /// Angular velocities relative to the line of centres, rad/s, counter-clockwise.
    pub angular_velocity: [f64; 2],
    /// +1 if the first gear pushes counter-clockwise.
    pub sense: f64,
}

/// Returns the second gear's phase (rad, added to its angle) and the mesh of an external gear with
/// another gear, which may be internal.
///
/// # Errors
/// The motions do not match the numbers of teeth, or there is no motion.
pub fn mount(
    gears: [ToothForm; 2],
    geometry: &MeshGeometry,
    mounting: &Mounting,
) -> Result<(f64, GearMesh), GeometryError> {
    let phase = phase_offset(gears, geometry, mounting);
    Ok((phase, Sides { gears, geometry, mounting }.mesh(phase)?))
}

/// Phase offset: smallest rotation of the second gear that brings rigid teeth into contact, rad.
pub fn phase_offset(gears: [ToothForm; 2], geometry: &MeshGeometry, mounting: &Mounting) -> f64 {
    let sides = Sides { gears, geometry, mounting };
    // Angle of the second gear's tooth that would mate with tooth 0 of the first gear.
    let opposite = sides.second_tooth_at(sides.roll_of_zero());
    nearest_to_zero(opposite - mounting.second.angle, gears[1].pitch_angle())
}

/// Returns the mesh of two gears in their given positions, with the phase of the second one (rad).
///
/// # Errors
/// As [`mount`].
pub fn mesh_as_placed(
    gears: [ToothForm; 2],
    geometry: &MeshGeometry,
    mounting: &Mounting,
    phase: f64,
) -> Result<GearMesh, GeometryError> {
    Sides { gears, geometry, mounting }.mesh(phase)
}

/// Sides of the teeth with which the first gear pushes.
struct Sides<'a> {
    gears: [ToothForm; 2],
    geometry: &'a MeshGeometry,
    mounting: &'a Mounting,
}

impl Sides<'_> {
    /// Direction of contact of the first gear: towards the other axis, or away from it in an
    /// internal gear.
    fn contact(&self) -> f64 {
        let [first, second] = [self.mounting.first.origin, self.mounting.second.origin];
        let line_of_centres = (second[1] - first[1]).atan2(second[0] - first[0]);
        if self.gears[1].internal { line_of_centres + PI } else { line_of_centres }
    }

    /// Roll angle of contact of tooth 0 of the first gear with the gear's angle at zero.
    fn roll_at_zero(&self) -> f64 {
        let pressure_angle = self.geometry.operating_pressure_angle;
        self.gears[0].half_base_angle + pressure_angle - self.mounting.sense * self.contact()
    }

    /// The same roll angle at time 0.
    fn roll_of_zero(&self) -> f64 {
        self.roll_at_zero() + self.mounting.sense * self.mounting.first.angle
    }

    /// Angle of the second gear's tooth that touches the first gear at a roll angle.
    fn second_tooth_at(&self, first_roll: f64) -> f64 {
        let (second, sense) = (self.gears[1], self.mounting.sense);
        let pressure_angle = self.geometry.operating_pressure_angle;
        let flank = second.half_base_angle - second.sense() * self.geometry.second_roll(first_roll);
        if second.internal {
            self.contact() + sense * (flank - pressure_angle)
        } else {
            self.contact() + PI - sense * (flank + pressure_angle)
        }
    }

    fn mesh(&self, phase: f64) -> Result<GearMesh, GeometryError> {
        let Sides { gears: [first, second], geometry, mounting } = *self;
        let [pitch, second_pitch] = [first.pitch_angle(), second.pitch_angle()];
        let sense = mounting.sense;
        let speed = check_speeds([first.teeth, second.teeth], second.sense(), mounting.angular_velocity)?;
        let roll_of_zero = self.roll_of_zero();
        let points = geometry.first_roll;
        // The first gear moves in the direction of its push, or it is driven backwards while it
        // pushes.
        let forward = sense * speed > 0.0;
        let step = if forward { pitch } else { -pitch };
        let enters = if forward { points.start_of_active_profile } else { points.end_of_active_profile };
        let period = pitch / speed.abs();
        let rate = sense * speed;
        // First tooth that enters contact at or after time 0.
        let start = ((enters - roll_of_zero) / rate).rem_euclid(period);
        let tooth = (sense * (enters - rate * start - roll_of_zero) / pitch).round();
        let second_angle = mounting.second.angle + phase + mounting.angular_velocity[1] * start;
        let second_tooth = ((self.second_tooth_at(enters) - second_angle) / second_pitch).round();

        // One end of a helical tooth enters contact before mid-face, and the other leaves it after.
        let early = 0.5 * geometry.overlap_ratio * pitch;
        let leaves = geometry.contact_ratio.fract() * period;
        let names = if forward { ["SAP", "EAP", "LPSTC", "HPSTC"] } else { ["EAP", "SAP", "HPSTC", "LPSTC"] };
        let point = |index: usize, time, after| CharacteristicPoint { name: names[index], time, after };
        Ok(GearMesh {
            teeth: [first.teeth, second.teeth],
            base_radii: geometry.base_radius,
            drive_sense: sense,
            sign: second.sense(),
            entering: [index(tooth, first.teeth), index(second_tooth, second.teeth)],
            start,
            period,
            characteristic: vec![
                point(0, 0.0, true),
                point(1, leaves, false),
                point(2, leaves, true),
                point(3, period, false),
            ],
            roll: [enters, enters + step],
            path: [points.start_of_active_profile - early, points.end_of_active_profile + early],
            overlap_ratio: geometry.overlap_ratio,
            twist: geometry.twist,
            roll_at_zero: self.roll_at_zero(),
            carrier: [0.0; 3],
            phase_offset: 0.0,
            first_contact: None,
        })
    }
}

/// Returns the first gear's speed if both speeds match the numbers of teeth; `sign` is -1 if the
/// second gear is internal.
fn check_speeds(teeth: [u32; 2], sign: f64, speeds: [f64; 2]) -> Result<f64, GeometryError> {
    let [first, second] = speeds;
    let teeth = teeth.map(f64::from);
    let fitting = -sign * first * teeth[0] / teeth[1];
    if first == 0.0 {
        return Err(GeometryError::error(
            "E0650",
            "first",
            sentence![
                "the first gear does not rotate relative to the line of centres, so its mesh has no cycle"
            ],
            sentence!["let the frames rotate with Time, like `Rotate(3 rpm * Time, e3)`"],
        ));
    }
    if (second - fitting).abs() > 1e-9 * fitting.abs() {
        return Err(GeometryError::error(
            "E0651",
            "second",
            sentence![
                "the second gear turns ", number second / first, " times as fast as the first, but with ",
                number teeth[0], " and ", number teeth[1], " teeth it must turn ",
                number fitting / first, " times"
            ],
            if sign > 0.0 {
                sentence![
                    "rotate the second frame by minus the angle of the first, times the teeth of the first gear over those of the second"
                ]
            } else {
                sentence![
                    "a ring gear rotates in the same direction as the gear in it: rotate the second frame by the angle of the first, times the teeth of the first gear over those of the second"
                ]
            },
        ));
    }
    Ok(first)
}

/// Index of the tooth that is an integer number of pitches away, which may be negative.
fn index(tooth: f64, teeth: u32) -> u32 {
    tooth.rem_euclid(f64::from(teeth)) as u32
}

/// `angle` minus the multiple of `pitch` that brings it closest to zero.
fn nearest_to_zero(angle: f64, pitch: f64) -> f64 {
    let turned = angle.rem_euclid(TAU);
    turned - (turned / pitch).round() * pitch
}
