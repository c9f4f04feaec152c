//! Content of the files of parts and of positions.

use crate::array_file::Arrays;
use crate::mesh::Meshes;
use calyx_runtime::observables::{Fields, ForceOf, Part, PartForce, PartKind, PartMotion, PartOf, Zone};
use serde_json::{Value, json};

/// Index of a part that is not displayed.
const NO_PART: u32 = u32::MAX;

/// Bytes that a position stores for each part: its pose, and the motion of its rings.
pub const BYTES_PER_PART: usize = 12 * size_of::<f64>() + (1 + 3 + 12) * size_of::<f32>();
/// Bytes that a position stores for each loaded contact cell: corners, pressure, kind, and two
/// parts, teeth and surfaces.
pub const BYTES_PER_CELL: usize = (12 + 1 + 1 + 6) * size_of::<f32>();

/// Returns the bytes of the file of parts of a model with its system of units.
pub fn parts(parts: &[Part], (model, units): (&str, &str)) -> Vec<u8> {
    let mut arrays = Arrays::default();
    let part = |part: &Part| {
        let surface = &part.surface;
        let kind = match part.kind {
            PartKind::Gear => "gear",
            PartKind::Shaft => "shaft",
            PartKind::Body => "body",
            PartKind::Bearing => "bearing",
        };
        json!({
            "name": part.name,
            "kind": kind,
            "copies": surface.copies,
            "open": surface.open,
            "without_mesh": surface.without_mesh,
            "points": arrays.single(surface.points.iter().copied()),
            "triangles": arrays.indices(surface.triangles.iter().copied()),
            "edges": arrays.indices(surface.edges.iter().copied()),
            "with_outer": with_outer(&mut arrays, part),
        })
    };
    let parts: Vec<Value> = parts.iter().map(part).collect();
    arrays.file(&json!({ "model": model, "units": units, "parts": parts }))
}

/// Returns the share of the motion of the outer ring in that of each point, if the part has two
/// rings.
fn with_outer(arrays: &mut Arrays, part: &Part) -> Value {
    match part.with_outer.is_empty() {
        true => Value::Null,
        false => arrays.single(part.with_outer.iter().map(|&share| [share])),
    }
}

/// Returns the bytes of the file of a position with its index and time (s). Its meshes are added to
/// `meshes`.
pub fn position((index, time): (usize, f64), fields: &Fields, meshes: &mut Meshes) -> Vec<u8> {
    let mut arrays = Arrays::default();
    let rows = fields.poses.iter().map(|pose| {
        let Some(pose) = pose else { return [f64::NAN; 12] };
        let mut row = [0.0; 12];
        row[..9].copy_from_slice(pose.rotation.as_flattened());
        row[9..].copy_from_slice(&pose.origin);
        row
    });
    let header = json!({
        "position": index,
        "time": time,
        "poses": arrays.double(rows),
        "motions": motions(&mut arrays, &fields.motions),
        "contacts": contacts(&mut arrays, fields),
        "forces": fields.forces.iter().map(|force| self::force(force, &fields.parts)).collect::<Vec<_>>(),
        "meshes": meshes.values(&mut arrays, fields),
    });
    arrays.file(&header)
}

fn motions(arrays: &mut Arrays, motions: &[PartMotion]) -> Value {
    let all = motions.iter().map(|motion| {
        let mut row = [0.0; 12];
        row.copy_from_slice(motion.motions.as_flattened());
        row
    });
    json!({
        "parts": arrays.indices(motions.iter().map(|motion| [motion.part as u32])),
        "at": arrays.single(motions.iter().map(|motion| motion.at)),
        "motions": arrays.single(all),
    })
}

fn contacts(arrays: &mut Arrays, fields: &Fields) -> Value {
    let loaded = || {
        fields.contacts.iter().flat_map(|contact| {
            let cells = contact.cells.iter().filter(|cell| cell.pressure > 0.0);
            cells.map(move |cell| (contact, cell))
        })
    };
    let part_of = |body: &str| {
        let part = fields.parts.iter().position(|part| part.kind == PartKind::Gear && part.name == body);
        part.map_or(NO_PART, |index| index as u32)
    };
    let corners = loaded().map(|(_, cell)| {
        let mut row = [0.0; 12];
        row.copy_from_slice(cell.corners.as_flattened());
        row
    });
    json!({
        "corners": arrays.single(corners),
        "pressures": arrays.single(loaded().map(|(_, cell)| [cell.pressure])),
        "zones": arrays.indices(loaded().map(|(_, cell)| [zone(cell.zone)])),
        "parts": arrays.indices(loaded().map(|(contact, _)| [0, 1].map(|side: usize| part_of(&contact.bodies[side])))),
        "teeth": arrays.indices(loaded().map(|(contact, _)| contact.teeth)),
        "surfaces": arrays.indices(loaded().map(|(contact, _)| contact.surfaces)),
    })
}

/// Returns the number of a zone in files.
fn zone(zone: Option<Zone>) -> u32 {
    match zone {
        Some(Zone::Flank) => 0,
        Some(Zone::Edge) => 1,
        None => 2,
    }
}

fn force(force: &PartForce, parts: &[Part]) -> Value {
    let index = |of: PartOf| parts.iter().position(|part| part.of == of);
    let (kind, of): (&str, Vec<Option<usize>>) = match force.of {
        ForceOf::Bearing(bearing) => ("bearing", vec![index(PartOf::Bearing(bearing))]),
        ForceOf::Mesh(bodies) => ("mesh", bodies.map(|body| index(PartOf::Body(body))).into()),
    };
    let of: Vec<usize> = of.into_iter().flatten().collect();
    json!({
        "kind": kind,
        "name": force.name,
        "point": force.point,
        "force": force.force,
        "moment": force.moment,
        "parts": of,
    })
}
