//! Geometry of unloaded meshes for programs: the Rust side of the mesh geometry in `gears.cx`.

use crate::externs::{defect, entry, host};
use crate::mesh_geometry::MeshGeometry;
use calyx_abi::externs::Handle;
use calyx_abi::{Context, RuntimeError};

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
}

/// Geometry of a mesh.
fn geometry(context: &mut Context, mesh: Handle) -> Result<MeshGeometry, RuntimeError> {
    let host = host(context)?;
    let bodies = entry(&host.scene.pairs, mesh)?.bodies.map(|body| body.0);
    let meeting = host.mesh_records.iter().find(|meeting| meeting.bodies == bodies);
    Ok(meeting.ok_or_else(|| defect("a mesh has no geometry"))?.geometry)
}
