//! Attachment regions and connections, and the check for mechanisms.

use crate::meshes::{assert_close, beam, block, chain, circular, clamped, load};
use calyx_elastic::assembly::System;
use calyx_elastic::attachment::{Attachment, Connection, Region, attach};
use calyx_elastic::check::check;
use calyx_elastic::model::SolidShape;
use calyx_elastic::{ElasticError, ElasticModel, FixedComponents, Resources, statics};
use std::f64::consts::PI;

/// Returns a ring of inner radius 1 and outer radius 2 about z with the height 1.
pub fn ring(around: usize) -> ElasticModel {
    let angle = |x: f64| x * 2.0 * PI / around as f64;
    let mut model = block(SolidShape::Hexahedron8, [around, 2, 2], |[x, y, z]| {
        let radius = 2.0 - 0.5 * y;
        [radius * angle(x).cos(), radius * angle(x).sin(), 0.5 * z]
    });
    // The last nodes around are the first ones.
    let merged = |node: usize| if node % (around + 1) == around { node - around } else { node };
    for element in &mut model.elements {
        element.nodes.iter_mut().for_each(|node| *node = merged(*node));
    }
    model
}

#[test]
fn regions_select_nodes() {
    let mut model = block(SolidShape::Hexahedron8, [2, 2, 2], |at| at);
    model.sets.insert("first".into(), vec![3, 1]);
    let bore = ring(8);
    let cylinder = Region::Cylinder {
        origin: [0.0; 3],
        axis: [0.0, 0.0, 2.0],
        radius: 1.0,
        heights: [0.2, 1.0],
        tolerance: 1e-9,
    };
    // Merged nodes still exist, but have no elements and belong to no surface.
    assert_eq!(cylinder.nodes(&bore).expect("nodes").len(), 2 * 8);
    let cases = [
        (Region::Set("first".into()), vec![1, 3]),
        (Region::Labels(vec![27, 1]), vec![0, 26]),
        (Region::Nearest([1.1, 0.9, 1.2]), vec![13]),
        (Region::Box { lowest: [0.5, 0.5, 1.5], highest: [2.0, 2.0, 2.0] }, vec![22, 23, 25, 26]),
        (Region::Plane { origin: [0.0; 3], normal: [0.0, 0.0, 1.0], tolerance: 1e-9 }, (0..9).collect()),
    ];
    for (region, expected) in cases {
        assert_eq!(region.nodes(&model).expect("nodes"), expected, "{region:?}");
    }
    for region in [Region::Set("second".into()), Region::Box { lowest: [5.0; 3], highest: [6.0; 3] }] {
        assert!(region.nodes(&model).is_err());
    }
}

/// Returns the displacement of a bore's attachment node under a load, and its strain energy.
fn loaded_bore(connection: Connection) -> ([f64; 6], f64) {
    let mut model = ring(16);
    let outer = Region::Cylinder {
        origin: [0.0; 3],
        axis: [0.0, 0.0, 1.0],
        radius: 2.0,
        heights: [0.0, 1.0],
        tolerance: 1e-9,
    };
    let components = [true, true, true, false, false, false];
    let fixed = outer.nodes(&model).expect("nodes").into_iter();
    model.fixed.extend(fixed.map(|node| FixedComponents { components, ..clamped(node) }));
    let region = Region::Cylinder {
        origin: [0.0; 3],
        axis: [0.0, 0.0, 1.0],
        radius: 1.0,
        heights: [0.0, 1.0],
        tolerance: 1e-9,
    };
    let attachment = Attachment { name: "bore".into(), position: Some([0.0, 0.0, 0.5]), region, connection };
    // Nodes that were merged belong to no element.
    let used: Vec<usize> = model.elements.iter().flat_map(|element| element.nodes.clone()).collect();
    let found = attachment.region.nodes(&model).expect("nodes").into_iter();
    let labels = found.filter(|node| used.contains(node)).map(|node| model.nodes[node].label).collect();
    let attachment = Attachment { region: Region::Labels(labels), ..attachment };
    let nodes = attach(&mut model, &attachment).expect("attached");
    assert_eq!(model.sets["bore"], nodes);
    let resources = Resources::default();
    let system = System::new(&model, &resources).expect("valid");
    let loads = vec![load(nodes[0], [1e6, 2e6, 3e6, 1e5, 2e5, 3e5])];
    let solution = statics::solve(&system, &[loads], &resources).expect("supported").remove(0);
    (solution.displacements[nodes[0]], solution.strain_energy)
}

#[test]
fn rigid_bores_are_stiffer_than_fourier_surfaces_and_averages() {
    let axis = [0.0, 0.0, 1.0];
    let (rigid, least) = loaded_bore(Connection::Rigid);
    let fourier =
        |harmonics: &[u32]| loaded_bore(Connection::Fourier { axis, harmonics: harmonics.to_vec() });
    let (same, of_none) = fourier(&[]);
    for component in 0..6 {
        assert_close(same[component], rigid[component], 1e-10);
    }
    let (_, of_two) = fourier(&[0, 2]);
    let (_, of_four) = fourier(&[0, 2, 3, 4]);
    let (_, of_average) = loaded_bore(Connection::Average);
    assert_close(of_none, least, 1e-10);
    assert!(of_two >= least * (1.0 - 1e-12) && of_four >= of_two * (1.0 - 1e-12) && of_average > of_four);
    let error = attach(
        &mut ring(8),
        &Attachment {
            name: "bore".into(),
            position: None,
            region: Region::Nearest([1.0, 0.0, 0.0]),
            connection: Connection::Fourier { axis, harmonics: vec![1] },
        },
    );
    assert!(error.expect_err("order 1").message.contains("attachment \"bore\""));
}

#[test]
fn harmonics_that_nodes_do_not_resolve_are_rejected() {
    // Eight angles resolve order 3; order 4 would be seen as its cosine alone.
    let attached = |harmonics: &[u32]| {
        let connection = Connection::Fourier { axis: [0.0, 0.0, 1.0], harmonics: harmonics.to_vec() };
        let mut model = ring(8);
        let surface = Attachment {
            name: "bore".into(),
            position: Some([0.0; 3]),
            region: Region::Nodes((0..model.nodes.len()).collect()),
            connection,
        };
        attach(&mut model, &surface)
    };
    let error = attached(&[0, 50]).expect_err("order 50");
    assert!(error.message.contains("harmonic 50 is not resolved by nodes at"), "{}", error.message);
    assert!(error.help.contains("use harmonics up to"), "{}", error.help);
    assert!(attached(&[0, 2]).is_ok());
}

#[test]
fn mechanisms_are_reported_by_their_nodes() {
    let resources = Resources::default();
    let report = |model: &ElasticModel| {
        check(&System::new(model, &resources).expect("valid"), &resources).expect("checked")
    };
    let mut model = chain(&beam(circular(0.02), [0.0, 1.0, 0.0]), 1.0, 4);
    let free = report(&model);
    assert_eq!((free.parts.as_slice(), free.mechanisms.len()), ([(1, 5, 6)].as_slice(), 0));
    // A hinge about all axes in the middle of a clamped chain: rotation of the free half.
    model.fixed.push(clamped(0));
    assert_eq!(report(&model).free_motion_count(), 0);
    if let calyx_elastic::ElementKind::Beam(properties) = &mut model.elements[2].kind {
        properties.released[0] = [false, false, false, false, true, true];
    }
    let hinged = report(&model);
    assert_eq!(hinged.mechanisms.len(), 2, "{hinged:?}");
    let system = System::new(&model, &resources).expect("valid");
    let error = statics::solve(&system, &[vec![load(4, [0.0, 1.0, 0.0, 0.0, 0.0, 0.0])]], &resources);
    let Err(ElasticError::Mechanism { message, nodes, .. }) = error else { panic!("a mechanism") };
    assert!(message.contains("mechanisms") && nodes.iter().all(|&node| node >= 4), "{message}");
    // A node of a solid has no rotational stiffness: fixing its rotations supports nothing.
    let mut solid = block(SolidShape::Hexahedron8, [2, 2, 2], |at| at);
    solid.fixed.push(clamped(0));
    assert_eq!(report(&solid).free_motion_count(), 3);
    // Two parts and a node without elements.
    let mut two = block(SolidShape::Tetrahedron4, [1, 1, 1], |at| at);
    let other = block(SolidShape::Tetrahedron4, [1, 1, 1], |at| [at[0] + 5.0, at[1], at[2]]);
    let first = two.nodes.len();
    two.nodes.extend(other.nodes);
    two.elements.extend(other.elements.into_iter().map(|mut element| {
        element.nodes.iter_mut().for_each(|node| *node += first);
        element
    }));
    two.nodes.push(calyx_elastic::Node { label: 0, position: [9.0; 3], axes: crate::meshes::BASIC });
    two.nodes.iter_mut().zip(1..).for_each(|(node, label)| node.label = label);
    let found = report(&two);
    assert_eq!(found.parts, [(1, 8, 6), (9, 8, 6)]);
    assert_eq!(found.without_stiffness, [17]);
    let system = System::new(&two, &resources).expect("valid");
    let error = statics::solve(&system, &[vec![]], &resources).expect_err("free");
    assert!(error.to_string().contains("12 free rigid-body motions: of 2 connected parts"), "{error}");
}
