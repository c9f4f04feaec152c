//! Areas of surfaces by their nodes: the forces of a uniform pressure.

use crate::meshes::{SHAPES, assert_close, block, load};
use calyx_elastic::assembly::System;
use calyx_elastic::model::ShellShape;
use calyx_elastic::surface::node_areas;
use calyx_elastic::{ElasticModel, Element, ElementKind, FixedComponents, NodalLoad, Resources, statics};

/// A block of 2 by 1 by 3 under tension has a uniform strain.
#[test]
fn a_uniform_pressure_stretches_a_block_uniformly() {
    const PRESSURE: f64 = 1e6;
    for shape in SHAPES {
        let mut model = block(shape, [2, 2, 3], |[x, y, z]| [x, 0.5 * y, z]);
        for axis in 0..3 {
            let on_plane =
                model.nodes.iter().enumerate().filter(|(_, node)| node.position[axis].abs() < 1e-9);
            let held: Vec<usize> = on_plane.map(|(index, _)| index).collect();
            let components = std::array::from_fn(|component| component == axis);
            model.fixed.extend(held.into_iter().map(|node| FixedComponents { node, components, value: 0.0 }));
        }
        let top = model.nodes.iter().enumerate().filter(|(_, node)| (node.position[2] - 3.0).abs() < 1e-9);
        let top: Vec<usize> = top.map(|(index, _)| index).collect();
        let areas = node_areas(&model, &top);
        assert_close(areas.iter().sum(), 2.0, 1e-12);
        let force = |(&node, area): (&usize, &f64)| load(node, [0.0, 0.0, PRESSURE * area, 0.0, 0.0, 0.0]);
        let loads: Vec<NodalLoad> = top.iter().zip(&areas).map(force).collect();
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        let solution = statics::solve(&system, &[loads], &resources).expect("supported").remove(0);
        for &node in &top {
            assert_close(solution.displacements[node][2], 3.0 * PRESSURE / 206e9, 1e-9);
        }
    }
}

#[test]
fn shells_have_the_integrals_of_their_shape_functions() {
    let cases = [
        (ShellShape::Triangle3, [1.0 / 3.0, 0.0, 0.0]),
        (ShellShape::Triangle6, [0.0, 1.0 / 3.0, 0.0]),
        (ShellShape::Quadrilateral4, [0.25, 0.0, 0.0]),
        (ShellShape::Quadrilateral8, [-1.0 / 12.0, 1.0 / 3.0, 0.0]),
        (ShellShape::Quadrilateral9, [1.0 / 36.0, 1.0 / 9.0, 4.0 / 9.0]),
    ];
    for (shape, [corner, middle, centre]) in cases {
        let coordinates = shape.node_coordinates();
        let positions: Vec<[f64; 3]> = coordinates.iter().map(|[x, y]| [0.2 * x, 0.3 * y, 1.0]).collect();
        let count = positions.len();
        let kind = ElementKind::Shell { shape, thickness: vec![0.01; 4], offset: 0.0, added_mass: 0.0 };
        let element = Element { label: 1, kind, nodes: (0..count).collect(), material: Some(0) };
        let nodes = crate::meshes::nodes(&positions);
        let model = ElasticModel { nodes, elements: vec![element], ..ElasticModel::default() };
        let areas = node_areas(&model, &(0..count).collect::<Vec<_>>());
        let whole = if shape.is_triangle() { 0.03 } else { 0.24 };
        for (node, area) in areas.iter().enumerate() {
            let corners = shape.corner_count();
            let share = if node < corners {
                corner
            } else if node < 2 * corners {
                middle
            } else {
                centre
            };
            assert!((area - share * whole).abs() < 1e-12, "{shape:?} {node}: {area}");
        }
        assert_eq!(node_areas(&model, &[0, 1]), [0.0, 0.0], "nodes of no whole face");
    }
}
