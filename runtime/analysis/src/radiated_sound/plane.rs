//! Rigid plane in front of which a body radiates.

use super::{Placement, SoundRequest, refused};
use calyx_acoustics::{RigidPlane, SoundMethod, SurfaceMesh};
use calyx_model::connection::ElasticConnection;
use calyx_model::elastic_body::{BodyMesh, CellShape, SharedElasticBody};
use calyx_model::mechanism::Mechanism;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, length, minus};
use std::collections::BTreeSet;

/// Distance from the plane, relative to the size of the body, that counts as rounding.
const ROUNDING: f64 = 1e-9;
/// Largest distance of a plane, in sizes of the body: the sound oscillates over the frequency with
/// the way to the plane and back, and each oscillation needs some solutions.
const FARTHEST: f64 = 10.0;

/// Checks that a body is in front of the rigid plane of a request, and not too far away.
///
/// # Errors
/// E0784.
pub(super) fn check(
    scene: &Mechanism,
    (connection, request): (&ElasticConnection, &SoundRequest),
    method: SoundMethod,
) -> Result<(), EngineError> {
    let Some(plane) = Placement::new(scene, connection)?.plane(request)? else { return Ok(()) };
    let name = &connection.name;
    if method != SoundMethod::BoundaryElements {
        return Err(refused(
            format!(
                "the method \"{}\" has no rigid plane: it knows every part of the walls alone",
                method.name()
            ),
            "choose `method = \"boundary_elements\"`, or leave `plane` out",
        )
        .blame("method"));
    }
    let mesh = connection.body.as_ref().and_then(|SharedElasticBody(body)| body.mesh());
    let Some(mesh) = mesh else { return Ok(()) };
    let mm = |length: f64| format!("{:.3} mm", 1e3 * length);
    // Other nodes, such as those of rigid elements, are no walls.
    let walls: BTreeSet<usize> = mesh.cells.iter().flat_map(|(_, nodes)| nodes.iter().copied()).collect();
    let walls: Vec<Vector> = walls.into_iter().map(|node| mesh.points[node]).collect();
    let size = size(&walls);
    let distances = || walls.iter().map(|point| plane.distance(*point));
    let nearest = distances().fold(f64::INFINITY, f64::min);
    if nearest < -ROUNDING * size {
        return Err(refused(
            format!("\"{name}\" reaches {} behind its rigid plane", mm(-nearest)),
            "move the plane, or reverse `plane_normal`, which points into the fluid",
        )
        .blame("plane"));
    }
    if has_wall_in(&mesh, &plane, ROUNDING * size) {
        return Err(refused(
            format!("a wall of \"{name}\" lies in its rigid plane, so no fluid is in front of it"),
            "leave a gap, such as of 1 mm, or leave this wall out of the mesh",
        )
        .blame("plane"));
    }
    let farthest = distances().fold(0.0, f64::max);
    if farthest > FARTHEST * size {
        return Err(refused(
            format!(
                "the rigid plane is {:.1} times the size of \"{name}\" away, and at most {FARTHEST} times are supported",
                farthest / size
            ),
            "leave `plane` out: it changes the sound power by less than the wavelength over twelve times the distance",
        )
        .blame("plane"));
    }
    Ok(())
}

fn has_wall_in(mesh: &BodyMesh, plane: &RigidPlane, tolerance: f64) -> bool {
    let is_in = |node: &usize| plane.distance(mesh.points[*node]).abs() <= tolerance;
    mesh.cells.iter().any(|(shape, nodes)| matches!(shape, CellShape::Shell(_)) && nodes.iter().all(is_in))
}

/// Returns the size of a body, with its mirror image in the rigid plane, m: how fast the sound
/// varies over the frequency and the direction.
pub(super) fn extent(mesh: &SurfaceMesh) -> f64 {
    let own = mesh.vertices().iter().copied();
    let mirrored = mesh.plane().map(|plane| own.clone().map(|vertex| plane.mirror(vertex)));
    size(&own.clone().chain(mirrored.into_iter().flatten()).collect::<Vec<_>>())
}

/// Returns the diagonal of the box that contains points, m.
fn size(points: &[Vector]) -> f64 {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for point in points {
        low = [0, 1, 2].map(|k: usize| low[k].min(point[k]));
        high = [0, 1, 2].map(|k: usize| high[k].max(point[k]));
    }
    length(minus(high, low))
}
