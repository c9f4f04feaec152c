//! Meshes of decks for results: grid points with their axes, corners of elements, and cards that
//! the reader of bodies rejects.

use super::files::{Files, open_in};
use calyx_elastic::import::{ImportError, NastranMesh, NastranMeshShape, read_nastran_mesh};

/// Deck with composites, springs, a fluid, midside nodes, an equation and an included file.
const DECK: &str = "\
SOL 103
CEND
BEGIN BULK
DEQATN  10      F(A,B) = A + B
        + SQRT(A)
CORD2C,5,,1.,0.,0.,1.,0.,1.
,2.,0.,0.
GRID,1,,0.,0.,0.
GRID,2,5,1.,90.,0.,5
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
GRID,11,,0.5,0.,0.
GRID,12,,1.,0.5,0.
GRID,20,,0.,0.,1.,-1
PCOMP,1,,,,,,,
,1,.001,0.,,1,.001,90.
PSOLID,7,7,,,,,PFLUID
PSOLID,8,8
CQUAD8,1,1,1,2,3,4,11,12
CQUADR,2,1,1,2,3,4
CQUAD4,3,1,1,2,3,3
CTRIAR,4,1,1,2,3
CTETRA,5,7,1,2,3,20
CTETRA,6,8,1,2,3,20
CBUSH,7,9,1,2
CBUSH,8,9,3,2
CBAR    10      2       1       2       0.      0.      1.              +X     1
+X     1
INCLUDE 'more.bdf'
ENDDATA
";

fn read(deck: &str) -> Result<NastranMesh, ImportError> {
    let mut files = Files::new();
    files.insert("main.bdf".into(), deck.as_bytes().to_vec());
    files.insert("more.bdf".into(), b"CTRIA6,9,1,1,2,3\n".to_vec());
    read_nastran_mesh("main.bdf", &mut open_in(&files))
}

#[test]
fn decks_have_a_mesh() {
    let mesh = read(DECK).expect("a mesh");
    let labels: Vec<u64> = mesh.nodes.iter().map(|node| node.label).collect();
    assert_eq!(labels, [1, 2, 3, 4, 11, 12, 20]);
    // The angle 90° about the axis through x = 1 is y = 1; the radial direction is y there.
    let node = &mesh.nodes[1];
    let expected = [[0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    let difference = |a: [f64; 3], b: [f64; 3]| (0..3).map(|k| (a[k] - b[k]).abs()).fold(0.0, f64::max);
    assert!(difference(node.position, [1.0, 1.0, 0.0]) < 1e-15, "{:?}", node.position);
    assert!((0..3).all(|k| difference(node.axes[k], expected[k]) < 1e-15), "{:?}", node.axes);
    use NastranMeshShape::{Quadrilateral, Tetrahedron, Triangle};
    let mut elements: Vec<(u64, NastranMeshShape, &[usize])> =
        mesh.elements.iter().map(|element| (element.label, element.shape, &element.nodes[..])).collect();
    elements.sort_by_key(|(label, ..)| *label);
    let quadrilateral: &[usize] = &[0, 1, 2, 3];
    let triangle: &[usize] = &[0, 1, 2];
    assert_eq!(
        elements,
        [
            (1, Quadrilateral, quadrilateral),
            (2, Quadrilateral, quadrilateral),
            (3, Triangle, triangle),
            (4, Triangle, triangle),
            (6, Tetrahedron, &[0, 1, 2, 6]),
            (9, Triangle, triangle),
        ]
    );
    let skipped: Vec<(&str, usize)> =
        mesh.skipped.iter().map(|other| (other.name.as_str(), other.count)).collect();
    assert_eq!(skipped, [("fluid element", 1), ("CBUSH", 2), ("CBAR", 1)]);
    assert_eq!(mesh.files, ["main.bdf", "more.bdf"]);
}

#[test]
fn wrong_meshes_are_rejected() {
    let rejected = |old: &str, new: &str, line: usize, part: &str| {
        assert!(DECK.contains(old), "{old}");
        let error = read(&DECK.replace(old, new)).expect_err(part);
        assert!(error.message.contains(part) && !error.help.is_empty(), "{part}: {}", error.message);
        assert_eq!((error.line, error.file.as_str()), (line, "main.bdf"), "{}", error.message);
    };
    rejected("CTRIAR,4,1,1,2,3", "CTRIAR,4,1,1,2,33", 22, "refers to GRID 33, which is not defined");
    rejected("CTRIAR,4,1,1,2,3", "CTRIAR,4,1,1,2,2", 22, "the same grid point twice");
    rejected("CTRIAR,4,1,1,2,3", "CTRIAR,4,1,1,2", 22, "is blank");
    rejected("CBUSH,7,9,1,2", "CPYRAM,7,8,1,2,3,4,20", 25, "is a pyramid");
    rejected("GRID,2,5", "GRID,2,6", 9, "coordinate system 6, which is not defined");
    rejected("'more.bdf'", "'lost.bdf'", 29, "cannot be read");
}
