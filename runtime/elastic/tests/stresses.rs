//! Stresses at nodes: uniform strains of solids, stretched and bent shells, surfaces of shells.

use crate::meshes::{SHAPES, block, nodes, steel};
use calyx_elastic::model::ShellShape;
use calyx_elastic::shell::{ShellElement, surface_stresses};
use calyx_elastic::stress::nodal_stresses_of;
use calyx_elastic::{ElasticModel, Element, ElementKind};
use calyx_numerics::stress::{Stress, von_mises};

/// Asserts that stresses agree up to rounding.
fn close(what: &str, found: [f64; 6], expected: [f64; 6]) {
    let size = expected.iter().fold(1.0_f64, |size, part| size.max(part.abs()));
    let difference = (0..6).map(|k| (found[k] - expected[k]).abs()).fold(0.0, f64::max);
    assert!(difference < 1e-9 * size, "{what}: {found:?} instead of {expected:?}");
}

#[test]
fn uniform_strain_of_solids_has_the_stress_of_hookes_law() {
    // Displacement gradient.
    let gradient = [[1e-3, 2e-3, -1e-3], [3e-3, -2e-3, 1e-3], [-1e-3, 4e-3, 2e-3]];
    let strain = |i: usize, j: usize| 0.5 * (gradient[i][j] + gradient[j][i]);
    let (modulus, ratio) = (206e9, 0.3);
    let (shear, trace) = (0.5 * modulus / (1.0 + ratio), strain(0, 0) + strain(1, 1) + strain(2, 2));
    let lame = modulus * ratio / ((1.0 + ratio) * (1.0 - 2.0 * ratio));
    let direct = |i: usize| lame * trace + 2.0 * shear * strain(i, i);
    let expected = [
        direct(0),
        direct(1),
        direct(2),
        2.0 * shear * strain(1, 2),
        2.0 * shear * strain(2, 0),
        2.0 * shear * strain(0, 1),
    ];
    for shape in SHAPES {
        let twisted = |[x, y, z]: [f64; 3]| [x + 0.1 * y * z, y - 0.07 * x, z + 0.05 * x * y];
        let model = block(shape, [2, 2, 2], twisted);
        let moved = |at: [f64; 3]| -> [f64; 6] {
            let by = |row: usize| (0..3).map(|k| gradient[row][k] * at[k]).sum();
            [by(0), by(1), by(2), 0.0, 0.0, 0.0]
        };
        let displacements: Vec<[f64; 6]> = model.nodes.iter().map(|node| moved(node.position)).collect();
        let found = nodal_stresses_of(&model, &displacements).expect("valid");
        assert_eq!(found.stresses.len(), model.nodes.len());
        for (stress, error) in found.stresses.into_iter().zip(found.errors) {
            close(&format!("{shape:?}"), stress, expected);
            assert!(error < 1e-9 * von_mises(expected), "{shape:?}: {error}");
        }
    }
}

/// Returns the displacement of a smooth field at a point, and its stress.
fn waves(at: [f64; 3]) -> ([f64; 3], Stress) {
    let directions = [[0.7, 0.4, -0.3], [-0.5, 0.6, 0.4], [0.3, -0.5, 0.8]];
    let phase = |k: usize| 0.3 * k as f64 + (0..3).map(|axis| directions[k][axis] * at[axis]).sum::<f64>();
    let gradient = |k: usize, axis: usize| 1e-4 * directions[k][axis] * phase(k).cos();
    let (modulus, ratio) = (206e9, 0.3);
    let shear = 0.5 * modulus / (1.0 + ratio);
    let trace: f64 = (0..3).map(|k| gradient(k, k)).sum();
    let direct = |k: usize| 2.0 * shear * (gradient(k, k) + ratio / (1.0 - 2.0 * ratio) * trace);
    let tangential = |a: usize, b: usize| shear * (gradient(a, b) + gradient(b, a));
    let stress = [direct(0), direct(1), direct(2), tangential(1, 2), tangential(2, 0), tangential(0, 1)];
    ([0, 1, 2].map(|k| 1e-4 * phase(k).sin()), stress)
}

/// The largest estimated error is at least the largest error, at most 2.5 times as large, falls as
/// the elements become smaller, and no node has an error of more than 1.4 times its estimate.
#[test]
fn estimated_errors_of_stresses_follow_the_errors() {
    for shape in SHAPES {
        let largest = |count: usize| {
            let size = 2.0 / count as f64;
            let model = block(shape, [count; 3], |at| at.map(|k| size * k));
            let field: Vec<_> = model.nodes.iter().map(|node| waves(node.position)).collect();
            let moved: Vec<[f64; 6]> = field.iter().map(|&([x, y, z], _)| [x, y, z, 0.0, 0.0, 0.0]).collect();
            let found = nodal_stresses_of(&model, &moved).expect("valid");
            let mut largest = [0.0_f64; 3];
            for ((_, exact), (stress, estimate)) in field.iter().zip(found.stresses.iter().zip(found.errors))
            {
                let error = von_mises(std::array::from_fn(|k| stress[k] - exact[k]));
                largest = [largest[0].max(error), largest[1].max(estimate), largest[2].max(error / estimate)];
            }
            largest
        };
        let sizes = [3, 6].map(largest);
        for [error, estimate, ratio] in sizes {
            assert!((1.0..2.5).contains(&(estimate / error)), "{shape:?}: {estimate} for {error}");
            assert!(ratio < 1.4, "{shape:?}: {ratio}");
        }
        let [error, estimate] = [0, 1].map(|k: usize| sizes[0][k] / sizes[1][k]);
        assert!(estimate > 0.7 * error, "{shape:?}: {estimate} instead of {error}");
    }
}

const SHELLS: [ShellShape; 5] = [
    ShellShape::Triangle3,
    ShellShape::Triangle6,
    ShellShape::Quadrilateral4,
    ShellShape::Quadrilateral8,
    ShellShape::Quadrilateral9,
];
const THICKNESS: f64 = 0.02;

/// Positions of a distorted element in the plane z = 0 with straight sides.
fn flat(shape: ShellShape) -> Vec<[f64; 3]> {
    let corner = [[0.0, 0.0], [1.1, 0.1], [0.9, 1.2], [-0.1, 0.8]];
    let at = |[u, v]: [f64; 2]| match shape.is_triangle() {
        true => [1.1 * u - 0.1 * v, 0.1 * u + 0.8 * v, 0.0],
        false => {
            let weight = |k: usize| {
                let sign = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]][k];
                0.25 * (1.0 + sign[0] * u) * (1.0 + sign[1] * v)
            };
            let sum = |axis: usize| (0..4).map(|k| weight(k) * corner[k][axis]).sum();
            [sum(0), sum(1), 0.0]
        }
    };
    shape.node_coordinates().into_iter().map(at).collect()
}

#[test]
fn bent_and_stretched_shells_have_the_stresses_of_plates() {
    let material = steel();
    let (stretch, curvature, offset) = (2e-4, 0.05, 0.003);
    let plane = 206e9 / (1.0 - 0.09);
    for shape in SHELLS {
        let positions = flat(shape);
        let thickness = vec![THICKNESS; shape.corner_count()];
        let shell = ShellElement {
            shape,
            positions: &positions,
            thickness: &thickness,
            offset,
            material: &material,
            added_mass: 0.0,
        };
        // The mid-surface is stretched along x and bent about y: w = curvature x² / 2.
        let motion = |&[x, _, _]: &[f64; 3]| {
            let turn = -curvature * x;
            [stretch * x - turn * offset, 0.0, 0.5 * curvature * x * x, 0.0, turn, 0.0]
        };
        let moved: Vec<[f64; 6]> = positions.iter().map(motion).collect();
        for surfaces in surface_stresses(&shell, &moved).expect("valid") {
            for (side, found) in [-1.0, 1.0].into_iter().zip(surfaces) {
                let strain = stretch - side * 0.5 * THICKNESS * curvature;
                let expected = [plane * strain, 0.3 * plane * strain, 0.0, 0.0, 0.0, 0.0];
                close(&format!("{shape:?} {side}"), found, expected);
            }
        }
    }
}

/// Nodes of a shell have the outer surface with the larger stress; other nodes have no stress.
#[test]
fn nodes_have_the_larger_stress_of_both_surfaces() {
    let positions = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [5.0, 0.0, 0.0]];
    let kind = ElementKind::Shell {
        shape: ShellShape::Quadrilateral4,
        thickness: vec![THICKNESS; 4],
        offset: 0.0,
        added_mass: 0.0,
    };
    let model = ElasticModel {
        nodes: nodes(&positions),
        materials: vec![steel()],
        elements: vec![Element { label: 1, kind, nodes: vec![0, 1, 2, 3], material: Some(0) }],
        ..ElasticModel::default()
    };
    let (stretch, curvature) = (1e-4, 0.05);
    let motion =
        |&[x, _, _]: &[f64; 3]| [stretch * x, 0.0, 0.5 * curvature * x * x, 0.0, -curvature * x, 0.0];
    let moved: Vec<[f64; 6]> = positions.iter().map(motion).collect();
    let found = nodal_stresses_of(&model, &moved).expect("valid");
    // Both act in the same sense on the surface against the normal.
    let strain = stretch + 0.5 * THICKNESS * curvature;
    let plane = 206e9 / (1.0 - 0.09);
    let expected = [plane * strain, 0.3 * plane * strain, 0.0, 0.0, 0.0, 0.0];
    found.stresses[..4].iter().for_each(|&stress| close("node", stress, expected));
    assert!(found.stresses[4].iter().all(|part| part.is_nan()));
    // A single element has no estimate.
    assert!(found.errors.iter().all(|error| error.is_nan()));
    assert!((von_mises(expected) / (plane * strain) - 0.79_f64.sqrt()).abs() < 1e-12);
}
