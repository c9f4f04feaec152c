//! The same body in all formats.

use super::files::{Files, open_data, open_in, read};
use calyx_elastic::import::{
    AbaqusOptions, CondensedMatrices, CondensedOptions, GmshOptions, GmshPart, Import, NastranOptions, Units,
    read_abaqus, read_condensed, read_gmsh, read_nastran,
};
use calyx_elastic::model::{ElasticModel, ElementKind, Material, SolidShape};
use std::fmt::Write;

/// Element shape: its kind, corners, edges in the order of NASTRAN, Abaqus and Gmsh.
struct Shape {
    names: [&'static str; 2],
    gmsh: i32,
    corners: &'static [[f64; 3]],
    nastran: &'static [[usize; 2]],
    abaqus: &'static [[usize; 2]],
    gmsh_edges: &'static [[usize; 2]],
}

/// Edges as the manuals of the three programs list them.
const SHAPES: [Shape; 3] = [
    Shape {
        names: ["CHEXA", "C3D20"],
        gmsh: 17,
        corners: &[
            [0.0, 0.0, 0.0],
            [2.0, 0.1, 0.0],
            [2.2, 2.0, 0.1],
            [0.0, 2.0, 0.0],
            [0.1, 0.0, 2.0],
            [2.0, 0.0, 2.1],
            [2.0, 2.3, 2.0],
            [0.0, 2.0, 2.0],
        ],
        nastran: &[
            [0, 1],
            [1, 2],
            [2, 3],
            [3, 0],
            [0, 4],
            [1, 5],
            [2, 6],
            [3, 7],
            [4, 5],
            [5, 6],
            [6, 7],
            [7, 4],
        ],
        abaqus: &[
            [0, 1],
            [1, 2],
            [2, 3],
            [3, 0],
            [4, 5],
            [5, 6],
            [6, 7],
            [7, 4],
            [0, 4],
            [1, 5],
            [2, 6],
            [3, 7],
        ],
        gmsh_edges: &[
            [0, 1],
            [0, 3],
            [0, 4],
            [1, 2],
            [1, 5],
            [2, 3],
            [2, 6],
            [3, 7],
            [4, 5],
            [4, 7],
            [5, 6],
            [6, 7],
        ],
    },
    Shape {
        names: ["CPENTA", "C3D15"],
        gmsh: 18,
        corners: &[
            [3.0, 0.0, 0.0],
            [4.0, 0.1, 0.0],
            [3.1, 1.0, 0.0],
            [3.0, 0.0, 1.0],
            [4.2, 0.0, 1.0],
            [3.0, 1.3, 1.1],
        ],
        nastran: &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 4], [2, 5], [3, 4], [4, 5], [5, 3]],
        abaqus: &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]],
        gmsh_edges: &[[0, 1], [0, 2], [0, 3], [1, 2], [1, 4], [2, 5], [3, 4], [3, 5], [4, 5]],
    },
    Shape {
        names: ["CTETRA", "C3D10"],
        gmsh: 11,
        corners: &[[5.0, 0.0, 0.0], [6.0, 0.1, 0.0], [5.0, 1.0, 0.0], [5.2, 0.0, 1.0]],
        nastran: &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
        abaqus: &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]],
        gmsh_edges: &[[0, 1], [1, 2], [2, 0], [0, 3], [2, 3], [1, 3]],
    },
];

const STEEL: Material = Material {
    youngs_modulus: 2.1e11,
    poissons_ratio: 0.3,
    shear_modulus: 2.1e11 / 2.6,
    density: 7850.0,
    structural_damping: 0.0,
};

/// Nodes of the body in mm with their positions, and nodes of each element in an order of edges.
struct Body {
    nodes: Vec<[f64; 3]>,
    elements: [Vec<Vec<usize>>; 3],
}

fn body() -> Body {
    let mut nodes = Vec::new();
    let mut elements: [Vec<Vec<usize>>; 3] = Default::default();
    for shape in &SHAPES {
        let first = nodes.len();
        nodes.extend_from_slice(shape.corners);
        let middles = nodes.len();
        for [a, b] in shape.nastran {
            let (a, b) = (shape.corners[*a], shape.corners[*b]);
            nodes.push([0, 1, 2].map(|i| 0.5 * (a[i] + b[i])));
        }
        for (order, edges) in [shape.nastran, shape.abaqus, shape.gmsh_edges].into_iter().enumerate() {
            let middle = |edge: &[usize; 2]| {
                let same = |known: &[usize; 2]| known == edge || *known == [edge[1], edge[0]];
                middles + shape.nastran.iter().position(same).expect("the edge exists")
            };
            let all = (first..middles).chain(edges.iter().map(middle));
            elements[order].push(all.collect());
        }
    }
    Body { nodes, elements }
}

fn text_of(write: impl FnOnce(&mut String) -> std::fmt::Result) -> Vec<u8> {
    let mut text = String::new();
    write(&mut text).expect("text grows");
    text.into_bytes()
}

fn nastran(body: &Body) -> Vec<u8> {
    text_of(|text| {
        writeln!(text, "MAT1,1,2.1+5,,.3,7.85-9\nPSOLID,1,1")?;
        for (at, [x, y, z]) in body.nodes.iter().enumerate() {
            writeln!(text, "GRID*,{},,{x:?},{y:?}\n*,{z:?}", at + 1)?;
        }
        for (at, (shape, nodes)) in SHAPES.iter().zip(&body.elements[0]).enumerate() {
            write!(text, "{:8}{:8}{:8}", shape.names[0], at + 1, 1)?;
            for (field, node) in nodes.iter().enumerate() {
                if field >= 6 && (field - 6) % 8 == 0 {
                    write!(text, "\n+       ")?;
                }
                write!(text, "{:8}", node + 1)?;
            }
            writeln!(text)?;
        }
        Ok(())
    })
}

fn abaqus(body: &Body) -> Vec<u8> {
    text_of(|text| {
        writeln!(text, "*HEADING\n** comment\n*NODE, NSET=ALL")?;
        for (at, [x, y, z]) in body.nodes.iter().enumerate() {
            writeln!(text, "{}, {x:?}, {y:?}, {z:?}", at + 1)?;
        }
        for (at, (shape, nodes)) in SHAPES.iter().zip(&body.elements[1]).enumerate() {
            writeln!(text, "*Element, type={}, ELSET=\"Body\"", shape.names[1])?;
            write!(text, "{}", at + 1)?;
            for (index, node) in nodes.iter().enumerate() {
                write!(text, ",{}{}", if index == 10 { "\n" } else { " " }, node + 1)?;
            }
            writeln!(text)?;
        }
        writeln!(text, "*Solid Section, elset=BODY, material=Steel")?;
        writeln!(text, "*MATERIAL, NAME=steel\n*ELASTIC\n2.1E5, 0.3\n*DENSITY\n7.85D-9")
    })
}

fn gmsh_text(body: &Body) -> Vec<u8> {
    text_of(|text| {
        let count = body.nodes.len();
        writeln!(text, "$MeshFormat\n4.1 0 8\n$EndMeshFormat")?;
        writeln!(text, "$Nodes\n1 {count} 1 {count}\n3 1 0 {count}")?;
        (1..=count).try_for_each(|tag| writeln!(text, "{tag}"))?;
        body.nodes.iter().try_for_each(|[x, y, z]| writeln!(text, "{x:?} {y:?} {z:?}"))?;
        writeln!(text, "$EndNodes\n$Elements\n3 3 1 3")?;
        for (at, (shape, nodes)) in SHAPES.iter().zip(&body.elements[2]).enumerate() {
            write!(text, "3 1 {} 1\n{}", shape.gmsh, at + 1)?;
            nodes.iter().try_for_each(|node| write!(text, " {}", node + 1))?;
            writeln!(text)?;
        }
        writeln!(text, "$EndElements")
    })
}

/// Binary mesh, with numbers in the order of bytes that `swapped` states.
pub fn gmsh_binary(swapped: bool) -> Vec<u8> {
    let body = body();
    let mut data = b"$MeshFormat\n4.1 1 8\n".to_vec();
    let ordered = |mut bytes: Vec<u8>| {
        if swapped {
            bytes.reverse();
        }
        bytes
    };
    let int = |value: i32| ordered(value.to_le_bytes().to_vec());
    let size = |value: usize| ordered((value as u64).to_le_bytes().to_vec());
    let double = |value: f64| ordered(value.to_le_bytes().to_vec());
    data.extend(int(1));
    data.extend(b"\n$EndMeshFormat\n$Entities\n");
    [0, 0, 0, 1].iter().for_each(|count| data.extend(size(*count)));
    data.extend(int(1));
    (0..6).for_each(|_| data.extend(double(0.0)));
    data.extend(size(1));
    data.extend(int(7));
    data.extend(size(1));
    data.extend(int(-5));
    data.extend(b"\n$EndEntities\n$Nodes\n");
    let count = body.nodes.len();
    [1, count, 1, count].iter().for_each(|value| data.extend(size(*value)));
    [3, 1, 0].iter().for_each(|value| data.extend(int(*value)));
    data.extend(size(count));
    (1..=count).for_each(|tag| data.extend(size(tag)));
    body.nodes.iter().flatten().for_each(|x| data.extend(double(*x)));
    data.extend(b"\n$EndNodes\n$Elements\n");
    [3, 3, 1, 3].iter().for_each(|value| data.extend(size(*value)));
    for (at, (shape, nodes)) in SHAPES.iter().zip(&body.elements[2]).enumerate() {
        [3, 1, shape.gmsh].iter().for_each(|value| data.extend(int(*value)));
        data.extend(size(1));
        data.extend(size(at + 1));
        nodes.iter().for_each(|node| data.extend(size(node + 1)));
    }
    data.extend(b"\n$EndElements\n");
    data
}

pub fn gmsh_options() -> GmshOptions {
    GmshOptions { length: 1e-3, parts: vec![GmshPart { physical: None, material: STEEL, thickness: None }] }
}

fn file(content: Vec<u8>) -> Files {
    Files::from([("main".to_owned(), content)])
}

/// Model without sets, whose names differ between the formats.
fn geometry(import: Import) -> ElasticModel {
    ElasticModel { sets: Default::default(), ..import.model }
}

#[test]
fn a_body_in_all_formats_gives_one_model() {
    let body = body();
    let options = NastranOptions { units: Units::N_MM_S, subcase: None };
    let expected = read_nastran("main", &options, &mut open_in(&file(nastran(&body)))).expect("a valid deck");
    let mass = expected.report.mass;
    let expected = geometry(expected);
    let abaqus_options = AbaqusOptions { units: Units::N_MM_S };
    let found =
        read_abaqus("main", &abaqus_options, &mut open_in(&file(abaqus(&body)))).expect("a valid file");
    let all: Vec<usize> = (0..body.nodes.len()).collect();
    assert_eq!(found.model.sets["ALL"], all);
    assert_same(&geometry(found), &expected);
    for content in [gmsh_text(&body), gmsh_binary(false), gmsh_binary(true)] {
        let is_binary = !content.is_ascii();
        let found = read_gmsh("main", &gmsh_options(), &mut open_in(&file(content))).expect("a valid mesh");
        assert_eq!(found.model.sets.keys().next().map(String::as_str), is_binary.then_some("group 3 7"));
        assert_same(&geometry(found), &expected);
    }
    // Midside nodes are at the middle of the edges in the order of the model.
    for (element, shape) in expected.elements.iter().zip(&SHAPES) {
        for (edge, node) in shape.nastran.iter().zip(&element.nodes[shape.corners.len()..]) {
            let ends = edge.map(|end| expected.nodes[element.nodes[end]].position);
            for i in 0..3 {
                let middle = 0.5 * (ends[0][i] + ends[1][i]);
                assert!((expected.nodes[*node].position[i] - middle).abs() < 1e-15);
            }
        }
    }
    // Volume of straight-sided elements: sum over tetrahedra from the centre to triangles of the
    // faces is exact for plane faces; the tetrahedron has the closed form.
    let tetrahedron = calyx_elastic::import::element_mass_properties(&expected, &expected.elements[2]);
    let [a, b, c] = [[1.0, 0.1, 0.0], [0.0, 1.0, 0.0], [0.2, 0.0, 1.0_f64]];
    let determinant = a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
        + a[2] * (b[0] * c[1] - b[1] * c[0]);
    assert!((tetrahedron.mass - 7850e-9 * determinant / 6.0).abs() < 1e-18);
    assert!(mass.mass > tetrahedron.mass);
}

fn assert_same(found: &ElasticModel, expected: &ElasticModel) {
    assert_eq!(found.elements, expected.elements);
    assert_eq!(found.nodes.len(), expected.nodes.len());
    for (a, b) in found.nodes.iter().zip(&expected.nodes) {
        assert_eq!((a.label, a.axes), (b.label, b.axes));
        assert!((0..3).all(|i| (a.position[i] - b.position[i]).abs() <= 1e-15), "{a:?} {b:?}");
    }
    let constants = |model: &ElasticModel| {
        let material = &model.materials[0];
        [material.youngs_modulus, material.poissons_ratio, material.shear_modulus, material.density]
    };
    for (a, b) in constants(found).iter().zip(constants(expected)) {
        assert!((a - b).abs() <= 1e-12 * b, "{a} {b}");
    }
    let quadratic = [SolidShape::Hexahedron20, SolidShape::Wedge15, SolidShape::Tetrahedron10];
    for (element, shape) in found.elements.iter().zip(quadratic) {
        assert_eq!(element.kind, ElementKind::Solid(shape));
    }
}

#[test]
fn a_condensed_body_in_all_formats_gives_the_same_matrices() {
    let read = |name: &str, units: Units| -> CondensedMatrices {
        let options = CondensedOptions { units, stiffness: None, mass: None };
        read_condensed(&format!("import/condensed.{name}"), &options, &mut open_data).expect("a valid body")
    };
    let npz = read("npz", Units::N_M_S);
    assert_eq!(npz, read("csv", Units::N_M_S));
    let mut punch = read("pch", Units::N_MM_S);
    let labels: Vec<&str> = punch.nodes.iter().map(|node| node.label.as_str()).collect();
    assert_eq!(labels, ["7", "12"]);
    for (node, label) in punch.nodes.iter_mut().zip(["left", "right"]) {
        label.clone_into(&mut node.label);
    }
    assert_eq!(npz.components, punch.components);
    assert_eq!(npz.nodes, punch.nodes);
    let close = |a: &nalgebra::DMatrix<f64>, b: &nalgebra::DMatrix<f64>| (a - b).amax() <= 1e-15 * b.amax();
    assert!(close(&npz.stiffness, &punch.stiffness));
    assert!(close(npz.mass.as_ref().expect("a mass"), punch.mass.as_ref().expect("a mass")));
    assert_eq!(npz.stiffness[(1, 1)], 3e4);
}

#[test]
fn damaged_archives_are_rejected() {
    let archive = read("import/condensed.npz");
    let find = |bytes: &[u8], last: bool| {
        let mut windows = archive.windows(bytes.len());
        let at = if last { windows.rposition(|w| w == bytes) } else { windows.position(|w| w == bytes) };
        at.expect("the bytes are there")
    };
    // The mass matrix is stored without compression: its data begin 128 bytes after the magic
    // number.
    let (data, name, end) =
        (find(b"\x93NUMPY", false) + 128, find(b"stiffness", true), find(b"PK\x05\x06", true));
    for (at, value, words) in [
        (data, 7, "the checksum of the array `mass` is wrong"),
        (name, b'S', "the archive has no array `stiffness`"),
        (end, b'Q', "not a ZIP archive"),
        (end + 16, 0xff, "directory of the archive"),
    ] {
        let mut damaged = archive.clone();
        damaged[at] = value;
        let options = CondensedOptions { units: Units::N_M_S, stiffness: None, mass: None };
        let error = read_condensed("body.npz", &options, &mut |_| Ok(damaged.clone())).expect_err(words);
        assert!(error.message.contains(words), "{error}");
        assert_eq!((error.file.as_str(), error.line), ("body.npz", 1));
    }
    let options = CondensedOptions { units: Units::N_M_S, stiffness: None, mass: None };
    let error = read_condensed("body.xlsx", &options, &mut open_data).expect_err("no format");
    assert!(error.help.contains("npz"), "{error:?}");
}
