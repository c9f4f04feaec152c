//! Relative position of two gear axes, which are parallel except for misalignment.
//!
//! Meshes are modelled for parallel axes. For axes that deviate slightly, the nominal mesh is that
//! of the sections of both gears by one plane: perpendicular to the mean of the axes, at the middle
//! of the common face width.

use crate::assembly::Misalignment;
use crate::mesh_geometry::MeshGeometry;
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::error::EngineError;
use calyx_runtime::motion::{
    Motion, Orientation, PlanePose, RelocatedMotion, angular_velocity, spatial_pose, tilted_axes,
};
use calyx_runtime::vec3::{cross, dot, length};
use std::f64::consts::{FRAC_PI_2, PI};
use std::sync::Arc;

/// Largest inclination of a body's axis of rotation to its own axis, rad.
const LARGEST_LEAN: f64 = 5.0 * DEGREE;
/// Largest angle between the axes of two meshing gears, rad; larger angles require gears for
/// crossed axes.
pub(crate) const LARGEST_MISALIGNMENT: f64 = 3.0 * DEGREE;
const DEGREE: f64 = PI / 180.0;

/// Axes of two meshing gears at time 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes {
    /// Positions and rotations of the sections of both gears in their common plane.
    pub sections: [PlanePose; 2],
    /// Distance from the middle of each gear's face to the section, along the gear's axis, m.
    pub along: [f64; 2],
    /// Rotation of each body about its own axis ([`Orientation::angle`]), rad.
    pub angles: [f64; 2],
    /// Common face width, m; not positive if the faces do not overlap.
    pub common_width: f64,
    /// Intersection of the second axis with the plane of the sections, in ground coordinates, m.
    pivot: [f64; 3],
    /// Direction vectors of the plane of the sections, and the mean of the axes.
    directions: [[f64; 3]; 3],
}

impl Axes {
    /// Computes the axes of two gears from their poses. The faces extend to both sides of the
    /// origin by half their width (m).
    ///
    /// # Errors
    /// E0648: the axes are not parallel within the permitted misalignment.
    pub fn of(poses: &[Pose; 2], half_widths: [f64; 2]) -> Result<Axes, EngineError> {
        let stances = [0, 1].map(|member: usize| Orientation::of(&poses[member]));
        let [first, second] = stances.map(|stance| stance.axis());
        let angle = length(cross(first, second)).atan2(dot(first, second));
        if angle > LARGEST_MISALIGNMENT {
            return Err(EngineError::new(
                "E0648",
                format!(
                    "the axes of the two gears are {} deg from parallel, which is more than a misalignment",
                    shown(angle / DEGREE)
                ),
                format!(
                    "make the axes parallel to within {} deg; gears on crossed axes are not supported",
                    shown(LARGEST_MISALIGNMENT / DEGREE)
                ),
            )
            .blame("second"));
        }
        let sum = [0, 1, 2].map(|k| first[k] + second[k]);
        let size = length(sum);
        let [x, y, normal] = tilted_axes(sum.map(|part| part / size));
        let places = [0, 1].map(|member: usize| dot(poses[member].origin, normal));
        let low = (places[0] - half_widths[0]).max(places[1] - half_widths[1]);
        let high = (places[0] + half_widths[0]).min(places[1] + half_widths[1]);
        // If the faces coincide, their middle is exact to the last bit.
        let middle = if places[0] == places[1] { places[0] } else { 0.5 * (low + high) };
        let along =
            [0, 1].map(|member: usize| (middle - places[member]) / dot(stances[member].axis(), normal));
        let points = [0, 1].map(|member: usize| {
            let (origin, axis) = (poses[member].origin, stances[member].axis());
            [0, 1, 2].map(|k: usize| origin[k] + axis[k] * along[member])
        });
        let sections = [0, 1].map(|member: usize| {
            let at = points[member];
            // Rotation about the mean of the axes.
            let seen =
                Pose { rotation: [x, y, normal].map(|row| seen_along(row, &poses[member])), ..poses[member] };
            PlanePose { origin: [dot(at, x), dot(at, y)], angle: Orientation::of(&seen).angle }
        });
        Ok(Axes {
            sections,
            along,
            angles: stances.map(|stance| stance.angle),
            common_width: high - low,
            pivot: points[1],
            directions: [x, y, normal],
        })
    }

    /// Returns the mean direction of both axes, a unit vector.
    pub fn normal(&self) -> [f64; 3] {
        self.directions[2]
    }

    /// Returns the second gear's motion with a misaligned axis, where the first gear drives with
    /// this sense (+1 is counter-clockwise).
    pub fn misaligned(
        &self,
        motion: Arc<dyn Motion>,
        geometry: &MeshGeometry,
        sense: f64,
        misalignment: Misalignment,
    ) -> RelocatedMotion {
        let [first, second] = self.sections.map(|section| section.origin);
        let centres = (second[1] - first[1]).atan2(second[0] - first[0]);
        // Direction of the line of action out of the first gear: a right angle beyond its tangent
        // point on the base circle, see `mounting`.
        let contact = if geometry.internal { centres + PI } else { centres };
        let action = contact + sense * (FRAC_PI_2 - geometry.operating_pressure_angle);
        // Perpendicular to the line of action, towards the first axis.
        let off = contact + PI - sense * geometry.operating_pressure_angle;
        let off = if geometry.internal { off + PI } else { off };
        let Misalignment { in_action, off_action } = misalignment;
        let [x, y] = [0, 1].map(|k: usize| {
            let of = |angle: f64| [angle.cos(), angle.sin()][k];
            off_action * of(off) - in_action * of(action)
        });
        // Displacement of the axis per unit of its length, and the rotation that causes it.
        let tilt = x.hypot(y);
        let tip = [x, y].map(|part| if tilt > 0.0 { part / tilt * tilt.sin() } else { 0.0 });
        let [swung_x, swung_y, swung_z] = tilted_axes([tip[0], tip[1], tilt.cos()]);
        let d = self.directions;
        // The same rotation about ground axes: transform into the plane of the sections, rotate,
        // and transform back.
        let rotation = [0, 1, 2].map(|row: usize| {
            [0, 1, 2].map(|column: usize| {
                let swung = [swung_x, swung_y, swung_z];
                (0..3).map(|k| (0..3).map(|l| d[l][row] * swung[k][l]).sum::<f64>() * d[k][column]).sum()
            })
        });
        RelocatedMotion::rotated_about(motion, rotation, self.pivot)
    }
}

/// Checks that a gear on parallel axes rotates about its own axis, e3 of its frame, except for a
/// misalignment.
///
/// # Errors
/// E0610: it does not. E0710: its frame is NaN or infinite at time 0.
pub(crate) fn rotates_about_own_axis(motion: &dyn Motion) -> Result<(), EngineError> {
    let axis = Orientation::of(&spatial_pose(motion, 0.0)?).axis();
    let turning = angular_velocity(motion, 0.0);
    let lean = length(cross(turning, axis)).atan2(dot(turning, axis).abs());
    if lean <= LARGEST_LEAN {
        return Ok(());
    }
    Err(EngineError::new(
        "E0610",
        format!("the gear rotates about an axis that leans {} deg from e3 of its frame, its own axis", shown(lean / DEGREE)),
        "begin the product of the frame with the rotation about e3, like `Rotate(speed * Time, e3) * Rotate(90 deg, e2) * Translate(...)` for an axis along e1 of ground",
    )
    .blame("frame"))
}

/// Rounds a number to three digits for display.
fn shown(number: f64) -> f64 {
    format!("{number:.2e}").parse().unwrap_or(number)
}

/// Row of the matrix that rotates coordinates of a body into those along a direction.
fn seen_along(direction: [f64; 3], pose: &Pose) -> [f64; 3] {
    let [a, b, c] = pose.rotation;
    std::array::from_fn(|k| direction[0] * a[k] + direction[1] * b[k] + direction[2] * c[k])
}
