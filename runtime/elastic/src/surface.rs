//! Tributary areas of the nodes of a surface.

use crate::model::{ElasticModel, ElementKind, SolidShape};
use calyx_numerics::vec3::{cross, length, minus};
use std::collections::HashSet;

/// Corners of the faces of solid elements.
fn faces(shape: SolidShape) -> &'static [&'static [usize]] {
    match shape {
        SolidShape::Hexahedron8 | SolidShape::IncompatibleHexahedron8 | SolidShape::Hexahedron20 => {
            &[&[0, 1, 2, 3], &[4, 5, 6, 7], &[0, 1, 5, 4], &[1, 2, 6, 5], &[2, 3, 7, 6], &[3, 0, 4, 7]]
        }
        SolidShape::Wedge6 | SolidShape::Wedge15 => {
            &[&[0, 1, 2], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]]
        }
        SolidShape::Tetrahedron4 | SolidShape::Tetrahedron10 => {
            &[&[0, 1, 2], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]]
        }
    }
}

/// Returns the part of the area of a face that belongs to each of its nodes, corners first: the
/// integrals of their shape functions over a parallelogram or a triangle.
fn shares(nodes: usize) -> &'static [f64] {
    const THIRD: f64 = 1.0 / 3.0;
    const NINTH: f64 = 1.0 / 9.0;
    match nodes {
        3 => &[THIRD; 3],
        4 => &[0.25; 4],
        6 => &[0.0, 0.0, 0.0, THIRD, THIRD, THIRD],
        8 => &[-0.25 * THIRD, -0.25 * THIRD, -0.25 * THIRD, -0.25 * THIRD, THIRD, THIRD, THIRD, THIRD],
        _ => {
            &[0.25 * NINTH, 0.25 * NINTH, 0.25 * NINTH, 0.25 * NINTH, NINTH, NINTH, NINTH, NINTH, 4.0 * NINTH]
        }
    }
}

/// Returns the integral over a surface of the shape function of each of its nodes, m²: the uniform
/// pressure 1 Pa has these forces. The surface consists of the faces of solids and the shells whose
/// nodes are all among `nodes`, taken as plane. All are 0 if there are none.
pub fn node_areas(model: &ElasticModel, nodes: &[usize]) -> Vec<f64> {
    let within: HashSet<usize> = nodes.iter().copied().collect();
    let mut areas = vec![0.0; model.nodes.len()];
    let mut add = |corners: &[usize], others: &[usize]| {
        if !corners.iter().chain(others).all(|node| within.contains(node)) {
            return;
        }
        let at = |k: usize| model.nodes[corners[k]].position;
        let area = match corners.len() {
            3 => 0.5 * length(cross(minus(at(1), at(0)), minus(at(2), at(0)))),
            _ => 0.5 * length(cross(minus(at(2), at(0)), minus(at(3), at(1)))),
        };
        let shares = shares(corners.len() + others.len());
        for (&node, share) in corners.iter().chain(others).zip(shares) {
            areas[node] += share * area;
        }
    };
    for element in &model.elements {
        match element.kind {
            ElementKind::Solid(shape) => {
                let edges = shape.midside_edges();
                let first = element.nodes.len() - edges.len();
                for face in faces(shape) {
                    let corners: Vec<usize> = face.iter().map(|&corner| element.nodes[corner]).collect();
                    let on_face = |edge: &[usize; 2]| edge.iter().all(|end| face.contains(end));
                    let others: Vec<usize> = (0..edges.len())
                        .filter(|&k| on_face(&edges[k]))
                        .map(|k| element.nodes[first + k])
                        .collect();
                    add(&corners, &others);
                }
            }
            ElementKind::Shell { shape, .. } => {
                let (corners, others) = element.nodes.split_at(shape.corner_count());
                add(corners, others);
            }
            ElementKind::Beam(_)
            | ElementKind::Rod { .. }
            | ElementKind::Spring { .. }
            | ElementKind::Mass { .. } => {}
        }
    }
    nodes.iter().map(|&node| areas[node]).collect()
}
