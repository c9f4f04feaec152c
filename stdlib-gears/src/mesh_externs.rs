//! Geometry of unloaded meshes for programs: the Rust side of the mesh geometry in `gears.cx`.

use crate::externs::{defect, entry, host, refusal};
use crate::host::ModelHost;
use crate::mesh_geometry::MeshGeometry;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::scene::BodyId;

calyx_abi::externs! {
    Pure fn calyx_gears_contact_ratio(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh, UNDER_LOAD)?.contact_ratio)
    }

    Pure fn calyx_gears_overlap_ratio(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh, UNDER_LOAD)?.overlap_ratio)
    }

    Pure fn calyx_gears_operating_pressure_angle(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh, FROM_FORCES)?.operating_pressure_angle)
    }

    Pure fn calyx_gears_backlash(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh, ROTATION)?.backlash)
    }

    Pure fn calyx_gears_normal_backlash(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh, ROTATION)?.normal_backlash)
    }

    Pure fn calyx_gears_angular_backlash(context, mesh: Handle) -> f64 {
        let host = host(context)?;
        let pair = entry(&host.scene.pairs, mesh)?;
        if pair.mesh.as_ref().is_none_or(|mesh| mesh.first_contact.is_none()) {
            let geometry = geometry(context, mesh, ROTATION)?;
            return Ok(geometry.backlash * geometry.operating_pressure_angle.cos() / geometry.base_radius[1]);
        }
        host.general_backlash.get(&(mesh.0 as usize)).copied().ok_or_else(|| {
            refusal("E0888", "mesh", "the backlash of this mesh is unknown: its coast flanks do not come into contact", COAST_FLANKS)
        })
    }

    Pure fn calyx_gears_tip_clearance(context, mesh: Handle, root_of: String) -> f64 {
        let geometry = geometry(context, mesh, CLEARANCE)?;
        let host = host(context)?;
        let bodies = entry(&host.scene.pairs, mesh)?.bodies;
        let [first, second] = [&host.gear_on("mesh", bodies[0])?.gear, &host.gear_on("mesh", bodies[1])?.gear];
        Ok(if root_of == "first" { geometry.clearance(first, second) } else { geometry.clearance(second, first) })
    }

    Pure fn calyx_gears_working_center_distance(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh, AXES)?.center_distance)
    }

    Pure fn calyx_gears_gear_of(context, body: Handle) -> Handle {
        let body = crate::externs::body(context, "body", body)?;
        gear_handle(host(context)?, "body", body)
    }

    Pure fn calyx_gears_gear_in(context, mesh: Handle, member: String) -> Handle {
        let host = host(context)?;
        let body = entry(&host.scene.pairs, mesh)?.bodies[usize::from(member == "second")];
        gear_handle(host, "mesh", body)
    }
}

// Remedies on general axes, by quantity.
const UNDER_LOAD: &str =
    "use `pairs_in_contact`, whose mean over a mesh cycle is the contact ratio under load";
const ROTATION: &str = "use `angular_backlash`, the rotation of the second gear while the first is fixed";
const FROM_FORCES: &str = "the direction of the force follows from the mesh forces and the flanks in contact";
const CLEARANCE: &str = "compare the tips of one gear with the root of the other on the drawing";
const AXES: &str = "the positions of the axes are those of the frames of both bodies";
const COAST_FLANKS: &str = "check the frames of the bodies and the tooth thicknesses";

/// Handle of the gear of a body.
fn gear_handle(host: &ModelHost, argument: &str, body: BodyId) -> Result<Handle, RuntimeError> {
    host.gear_model_on(argument, body)?;
    let gear = host.body_gears.get(body.0).copied().flatten();
    gear.map(|gear| Handle(gear as u64)).ok_or_else(|| defect("the gear of a body is unknown"))
}

/// Checks that a mesh is one of involute gears on parallel axes, on which the involute geometry and
/// the load factors of ISO 6336-1 are defined.
pub(crate) fn on_parallel_axes(
    context: &mut Context,
    mesh: Handle,
    instead: &str,
) -> Result<(), RuntimeError> {
    let pair = entry(&host(context)?.scene.pairs, mesh)?;
    if pair.mesh.as_ref().is_none_or(|mesh| mesh.first_contact.is_none()) {
        return Ok(());
    }
    let message = "this quantity is defined for involute gears on parallel axes, and the axes of this mesh are not parallel";
    Err(refusal("E0888", "mesh", message, instead))
}

/// Geometry of a mesh on parallel axes; `instead` is the remedy for other meshes.
fn geometry(context: &mut Context, mesh: Handle, instead: &str) -> Result<MeshGeometry, RuntimeError> {
    on_parallel_axes(context, mesh, instead)?;
    let host = host(context)?;
    let bodies = entry(&host.scene.pairs, mesh)?.bodies.map(|body| body.0);
    let meeting = host.mesh_records.iter().find(|meeting| meeting.bodies == bodies);
    Ok(meeting.ok_or_else(|| defect("a mesh has no geometry"))?.geometry)
}
