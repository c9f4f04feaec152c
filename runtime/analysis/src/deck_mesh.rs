//! Mesh of a NASTRAN deck, for the sound of results on it.

use calyx_acoustics::Face;
use calyx_acoustics::skin::Solid;
use calyx_acoustics::surface_sound::{DeckMesh, GridPoint};
use calyx_elastic::import::{ImportError, NastranMesh, OpenFile, read_nastran_mesh};

/// Reads the mesh of a deck whose unit of length is `length`, m.
/// [`calyx_acoustics::surface_sound::Vibration::of_nastran`] joins it with results.
///
/// # Errors
/// Those of [`read_nastran_mesh`].
pub fn deck_mesh(path: &str, length: f64, open: &mut OpenFile) -> Result<DeckMesh, ImportError> {
    let NastranMesh { nodes, elements, skipped, .. } = read_nastran_mesh(path, open)?;
    let mut mesh = DeckMesh { length, ..DeckMesh::default() };
    mesh.points = nodes
        .into_iter()
        // The reader accepts labels up to the largest 64-bit integer with a sign.
        .map(|node| GridPoint { label: node.label as i64, position: node.position, axes: node.axes })
        .collect();
    for element in &elements {
        match (element.shape.is_solid(), element.nodes.as_slice()) {
            (false, &[a, b, c]) => mesh.shells.push(Face::Triangle([a, b, c])),
            (false, &[a, b, c, d]) => mesh.shells.push(Face::Quadrilateral([a, b, c, d])),
            (true, &[a, b, c, d]) => mesh.solids.push(Solid::Tetrahedron([a, b, c, d])),
            (true, &[a, b, c, d, e, f]) => mesh.solids.push(Solid::Wedge([a, b, c, d, e, f])),
            (true, &[a, b, c, d, e, f, g, h]) => {
                mesh.solids.push(Solid::Hexahedron([a, b, c, d, e, f, g, h]))
            }
            _ => {}
        }
    }
    if !skipped.is_empty() {
        let all: Vec<String> =
            skipped.iter().map(|other| format!("{} {}", other.count, other.name)).collect();
        mesh.notes.push(format!("elements that are no surface are left out: {}", all.join(", ")));
    }
    Ok(mesh)
}
