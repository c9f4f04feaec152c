//! Content of the files: parts, and positions.

use crate::array_file::Arrays;
use calyx_runtime::elastic_body::CellShape;
use calyx_runtime::observables::{
    ElasticBodyField, Fields, ForceOf, Part, PartForce, PartKind, PartOf, SectorField,
};
use calyx_runtime::structure::outer_surface::{Cell, CellKind, Skin};
use calyx_runtime::structure::rotated_tensor;
use calyx_runtime::vec3::minus;
use serde_json::{Value, json};

/// Pose of a part: rotation matrix by rows, and origin.
type Pose = ([[f64; 3]; 3], [f64; 3]);

/// Index of a part that is not displayed.
const NO_PART: u32 = u32::MAX;

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
            "points": arrays.single(surface.points.iter().copied()),
            "triangles": arrays.indices(surface.triangles.iter().copied()),
            "edges": arrays.indices(surface.edges.iter().copied()),
        })
    };
    let parts: Vec<Value> = parts.iter().map(part).collect();
    arrays.file(&json!({ "model": model, "units": units, "parts": parts }))
}

/// Returns the bytes of the file of a position with its index and time (s).
pub fn position((index, time): (usize, f64), fields: &Fields) -> Vec<u8> {
    let mut arrays = Arrays::default();
    let poses: Vec<Option<Pose>> =
        fields.poses.iter().map(|pose| pose.map(|pose| (pose.rotation, pose.origin))).collect();
    let rows = poses.iter().map(|pose| {
        let Some((rotation, origin)) = pose else { return [f64::NAN; 12] };
        let mut row = [0.0; 12];
        row[..9].copy_from_slice(rotation.as_flattened());
        row[9..].copy_from_slice(origin);
        row
    });
    let header = json!({
        "position": index,
        "time": time,
        "poses": arrays.double(rows),
        "contacts": contacts(&mut arrays, fields),
        "forces": fields.forces.iter().map(|force| self::force(force, &fields.parts)).collect::<Vec<_>>(),
        "meshes": meshes(&mut arrays, fields, &poses),
    });
    arrays.file(&header)
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
        "parts": arrays.indices(loaded().map(|(contact, _)| [0, 1].map(|side: usize| part_of(&contact.bodies[side])))),
        "teeth": arrays.indices(loaded().map(|(contact, _)| contact.teeth)),
    })
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

/// Mesh of a part in ground coordinates.
struct Deformed<'a> {
    part: usize,
    copies: Vec<u32>,
    points: &'a [[f64; 3]],
    displacements: &'a [[f64; 3]],
    stresses: &'a [[f64; 6]],
    skin: Skin,
}

fn meshes(arrays: &mut Arrays, fields: &Fields, poses: &[Option<Pose>]) -> Vec<Value> {
    let mut all = Vec::new();
    let placed = |is_own: &dyn Fn(&Part) -> bool| {
        let part = fields.parts.iter().position(is_own)?;
        Some((part, poses.get(part)?.as_ref()?))
    };
    for body in &fields.bodies {
        let Some((part, pose)) = placed(&|part| part.of == PartOf::Body(body.number)) else { continue };
        let ends = ends(&fields.parts[part]);
        for sector in &body.sectors {
            let extruded = is_plane(sector).then(|| extruded(sector, ends));
            let mesh = of_sector(extruded.as_ref().unwrap_or(sector), part);
            all.push(written(arrays, &mesh, pose));
        }
    }
    for body in &fields.elastic_bodies {
        let is_own = |part: &Part| matches!(part.of, PartOf::Connection(_)) && part.name == body.body;
        let Some((part, pose)) = placed(&is_own) else { continue };
        all.push(written(arrays, &elastic_body(body, part), pose));
    }
    all
}

/// Returns the mesh in the coordinates of its part.
fn written(arrays: &mut Arrays, mesh: &Deformed<'_>, (rotation, origin): &Pose) -> Value {
    let columns: [[f64; 3]; 3] = [0, 1, 2].map(|axis: usize| rotation.map(|row| row[axis]));
    let own = |v: [f64; 3]| columns.map(|column| column[0] * v[0] + column[1] * v[1] + column[2] * v[2]);
    let nodes = || mesh.skin.nodes.iter();
    json!({
        "part": mesh.part,
        "copies": mesh.copies,
        "open": mesh.skin.open,
        "points": arrays.single(nodes().map(|&node| own(minus(mesh.points[node], *origin)))),
        "displacements": arrays.single(nodes().map(|&node| own(mesh.displacements[node]))),
        "stresses": arrays.single(nodes().map(|&node| rotated_tensor(&columns, mesh.stresses[node]))),
        "triangles": arrays.indices(mesh.skin.triangles.iter().copied()),
        "edges": arrays.indices(mesh.skin.edges.iter().copied()),
    })
}

fn is_plane(sector: &SectorField) -> bool {
    sector.cells.iter().any(|cell| cell.len() == 4)
}

fn of_sector(sector: &SectorField, part: usize) -> Deformed<'_> {
    let cells = sector.cells.iter().zip(&sector.elements).map(|(corners, &element)| Cell {
        kind: CellKind::Hexahedron,
        corners,
        element,
    });
    Deformed {
        part,
        copies: vec![sector.tooth],
        points: &sector.points,
        displacements: &sector.displacements,
        stresses: &sector.stresses,
        skin: Skin::new(cells, |_| false),
    }
}

fn elastic_body(body: &ElasticBodyField, part: usize) -> Deformed<'_> {
    let cells = body.cells.iter().enumerate();
    let cells =
        cells.map(|(index, (shape, nodes)): (usize, &(CellShape, Vec<usize>))| shape.cell(nodes, index));
    Deformed {
        part,
        copies: vec![0],
        points: &body.points,
        displacements: &body.displacements,
        stresses: &body.stresses,
        skin: Skin::new(cells, |_| false),
    }
}

/// Returns the axial ends of a part in its coordinates, m.
fn ends(part: &Part) -> [f64; 2] {
    let z = part.surface.points.iter().map(|point| point[2]);
    z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)])
}

/// Extrudes a plane sector between two axial positions: plane strain is the same in all sections.
fn extruded(sector: &SectorField, ends: [f64; 2]) -> SectorField {
    let count = sector.points.len();
    let twice = |values: &[[f64; 3]]| values.iter().chain(values).copied().collect();
    let points = ends.iter().flat_map(|&z| sector.points.iter().map(move |&[x, y, _]| [x, y, z])).collect();
    let cell =
        |cell: &Vec<usize>| cell.iter().copied().chain(cell.iter().map(|corner| corner + count)).collect();
    SectorField {
        tooth: sector.tooth,
        points,
        cells: sector.cells.iter().map(cell).collect(),
        elements: sector.elements.clone(),
        displacements: twice(&sector.displacements),
        stresses: sector.stresses.iter().chain(&sector.stresses).copied().collect(),
    }
}
