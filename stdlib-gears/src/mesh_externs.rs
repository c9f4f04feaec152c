//! Geometry of unloaded meshes for programs: the Rust side of the mesh geometry in `gears.cx`.

use crate::externs::{defect, entry, host, refusal};
use crate::host::ModelHost;
use crate::mesh_geometry::MeshGeometry;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};
use calyx_runtime::scene::BodyId;

calyx_abi::externs! {
    Pure fn calyx_gears_contact_ratio(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh)?.contact_ratio)
    }

    Pure fn calyx_gears_overlap_ratio(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh)?.overlap_ratio)
    }

    Pure fn calyx_gears_operating_pressure_angle(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh)?.operating_pressure_angle)
    }

    Pure fn calyx_gears_backlash(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh)?.backlash)
    }

    Pure fn calyx_gears_normal_backlash(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh)?.normal_backlash)
    }

    Pure fn calyx_gears_tip_clearance(context, mesh: Handle, root_of: String) -> f64 {
        let geometry = geometry(context, mesh)?;
        let host = host(context)?;
        let bodies = entry(&host.scene.pairs, mesh)?.bodies;
        let [first, second] = [&host.gear_on("mesh", bodies[0])?.gear, &host.gear_on("mesh", bodies[1])?.gear];
        Ok(if root_of == "first" { geometry.clearance(first, second) } else { geometry.clearance(second, first) })
    }

    Pure fn calyx_gears_working_center_distance(context, mesh: Handle) -> f64 {
        Ok(geometry(context, mesh)?.center_distance)
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

/// Geometry of a mesh.
fn geometry(context: &mut Context, mesh: Handle) -> Result<MeshGeometry, RuntimeError> {
    on_parallel_axes(
        context,
        mesh,
        "use `pairs_in_contact`, whose mean over a mesh cycle is the contact ratio under load",
    )?;
    let host = host(context)?;
    let bodies = entry(&host.scene.pairs, mesh)?.bodies.map(|body| body.0);
    let meeting = host.mesh_records.iter().find(|meeting| meeting.bodies == bodies);
    Ok(meeting.ok_or_else(|| defect("a mesh has no geometry"))?.geometry)
}
