//! Misalignment of meshes: displacement and tilt of the gears relative to each other due to the
//! deflection of shafts, bearings and housings.
//!
//! On parallel axes it refers to the plane of action and the plane normal to it (ISO 6336-1). On
//! general axes it consists of the errors of offset, of both axial positions and of the shaft
//! angle, called E, P, G and Sigma for bevel gears.

use super::mesh_cycle::common_face;
use super::{Equilibrium, Needs, Observable, Quantity};
use calyx_model::ids::{BodyId, PairId};
use calyx_model::observed::Observed;
use calyx_model::pairs::{FirstContact, GearMesh};
use calyx_numerics::vec3::{Vector, cross, dot, minus, plus, scaled, unit};
use std::f64::consts::{FRAC_PI_2, PI};

/// Component of a misalignment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MisalignmentComponent {
    /// Slope in the plane of action, rad: positive if it brings the drive flanks together at the
    /// end of the face towards e3.
    SlopeInPlane,
    /// Slope in the plane normal to it, rad: positive if it brings the axes together at that end.
    SlopeOutOfPlane,
    /// Displacement in the plane of action, m: positive if it brings the drive flanks together.
    OffsetInPlane,
    /// Displacement in the plane normal to it, m: positive if it brings the axes together.
    OffsetOutOfPlane,
    /// Error of the offset of crossed axes (E), m.
    Offset,
    /// Withdrawal of the first gear along its axis (P), m.
    FirstAxial,
    /// Withdrawal of the second gear along its axis (G), m.
    SecondAxial,
    /// Error of the shaft angle (Sigma), rad.
    ShaftAngle,
}

impl MisalignmentComponent {
    /// Returns whether the component refers to parallel axes.
    pub fn is_of_parallel_axes(self) -> bool {
        use MisalignmentComponent as Of;
        matches!(self, Of::SlopeInPlane | Of::SlopeOutOfPlane | Of::OffsetInPlane | Of::OffsetOutOfPlane)
    }

    fn is_angle(self) -> bool {
        use MisalignmentComponent as Of;
        matches!(self, Of::SlopeInPlane | Of::SlopeOutOfPlane | Of::ShaftAngle)
    }
}

/// Misalignment of a mesh by the deviations of both gears from their prescribed motions; NaN for a
/// component of other axes than those of the mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Misalignment(pub PairId, pub MisalignmentComponent);

impl Observable for Misalignment {
    fn quantity(&self) -> Quantity {
        match self.1.is_angle() {
            true => Quantity::repeating("misalignment", "rad"),
            false => Quantity::repeating("misalignment", "m"),
        }
    }

    fn needs(&self) -> Needs {
        Needs::Motions
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let front = at.front(self.0);
        let Some((mesh, bodies)) = at.mesh(front) else { return Observed::number(f64::NAN) };
        let axes = bodies.map(|body| DisplacedAxis::of(at, body));
        Observed::number(match mesh.first_contact {
            None => on_parallel_axes(at, mesh, bodies, &axes, self.1),
            Some(contact) => on_general_axes(at, bodies, &axes, contact, self.1),
        })
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Axis of a body and its deviation from the prescribed one, along ground axes.
struct DisplacedAxis {
    origin: Vector,
    /// Transverse directions and the axis.
    directions: [Vector; 3],
    displacement: Vector,
    /// Tilt; the rotation about the axis does not move it.
    tilt: Vector,
}

impl DisplacedAxis {
    fn of(at: &Equilibrium<'_>, body: BodyId) -> DisplacedAxis {
        let directions = at.system.axes(body.0, at.time());
        let along = |from: usize, count: usize| {
            (0..count).fold([0.0; 3], |sum, k| plus(sum, scaled(directions[k], at.deviation(body, from + k))))
        };
        DisplacedAxis {
            origin: at.system.origin(body.0, at.time()),
            directions,
            displacement: along(0, 3),
            tilt: along(3, 2),
        }
    }

    fn direction(&self) -> Vector {
        self.directions[2]
    }

    /// Displacement of the axis next to a point.
    fn displacement_at(&self, point: Vector) -> Vector {
        let along = dot(minus(point, self.origin), self.direction());
        plus(self.displacement, cross(self.tilt, scaled(self.direction(), along)))
    }
}

fn on_parallel_axes(
    at: &Equilibrium<'_>,
    mesh: &GearMesh,
    bodies: [BodyId; 2],
    [first, second]: &[DisplacedAxis; 2],
    component: MisalignmentComponent,
) -> f64 {
    let [x, y, axis] = first.directions;
    let centres = minus(second.origin, first.origin);
    let [across, up] = [dot(centres, x), dot(centres, y)];
    let internal = mesh.sign < 0.0;
    let pressure_angle =
        ((mesh.base_radii[0] + mesh.sign * mesh.base_radii[1]).abs() / across.hypot(up)).acos();
    let contact = up.atan2(across) + if internal { PI } else { 0.0 };
    // Directions of the line of action out of the first gear and, normal to it, towards the first
    // axis.
    let action = contact + mesh.drive_sense * (FRAC_PI_2 - pressure_angle);
    let towards = contact - mesh.drive_sense * pressure_angle + if internal { 0.0 } else { PI };
    let in_plane = |angle: f64| plus(scaled(x, angle.cos()), scaled(y, angle.sin()));
    let [start, end] = common_face(at, bodies);
    let middle = plus(first.origin, scaled(axis, 0.5 * (start + end)));
    let slope = cross(minus(second.tilt, first.tilt), axis);
    let offset = minus(second.displacement_at(middle), first.displacement_at(middle));
    match component {
        MisalignmentComponent::SlopeInPlane => -dot(slope, in_plane(action)),
        MisalignmentComponent::SlopeOutOfPlane => dot(slope, in_plane(towards)),
        MisalignmentComponent::OffsetInPlane => -dot(offset, in_plane(action)),
        MisalignmentComponent::OffsetOutOfPlane => dot(offset, in_plane(towards)),
        _ => f64::NAN,
    }
}

fn on_general_axes(
    at: &Equilibrium<'_>,
    bodies: [BodyId; 2],
    axes: &[DisplacedAxis; 2],
    contact: FirstContact,
    component: MisalignmentComponent,
) -> f64 {
    let directions = [0, 1].map(|side: usize| axes[side].direction());
    let nearest = nearest_points([0, 1].map(|side: usize| axes[side].origin), directions);
    // Directions from the crossing point to the teeth, which keep their side.
    let start = bodies.map(|body| (at.system.origin(body.0, 0.0), at.system.axes(body.0, 0.0)[2]));
    let crossing = nearest_points(start.map(|(origin, _)| origin), start.map(|(_, axis)| axis));
    let to_teeth = [0, 1].map(|side: usize| {
        let along = dot(minus(contact.point, crossing[side]), start[side].1);
        scaled(directions[side], along.signum())
    });
    let [first, second] = to_teeth;
    let relative = minus(axes[0].displacement_at(nearest[0]), axes[1].displacement_at(nearest[1]));
    // Offset of the first gear, positive as in the coordinates of `bevel_contact`.
    let across = unit(cross(second, first));
    let cosine = dot(first, second);
    let square = 1.0 - cosine * cosine;
    match component {
        MisalignmentComponent::Offset => dot(relative, across),
        // `relative` is a withdrawal of the first gear minus one of the second, and an offset.
        MisalignmentComponent::FirstAxial => (dot(relative, first) - cosine * dot(relative, second)) / square,
        MisalignmentComponent::SecondAxial => {
            (cosine * dot(relative, first) - dot(relative, second)) / square
        }
        // A rotation of the first gear about `across` turns it away from the second.
        MisalignmentComponent::ShaftAngle => dot(minus(axes[0].tilt, axes[1].tilt), across),
        _ => f64::NAN,
    }
}

/// Returns the points of two lines that are nearest to the other line.
fn nearest_points(origins: [Vector; 2], [first, second]: [Vector; 2]) -> [Vector; 2] {
    let apart = minus(origins[1], origins[0]);
    let cosine = dot(first, second);
    let square = 1.0 - cosine * cosine;
    let [along_first, along_second] = [dot(apart, first), dot(apart, second)];
    [
        plus(origins[0], scaled(first, (along_first - cosine * along_second) / square)),
        plus(origins[1], scaled(second, (cosine * along_first - along_second) / square)),
    ]
}
