//! Solid elements: patch tests on distorted meshes, rigid-body motions, mass, invariance.

use crate::meshes::{SHAPES, assert_close, block, rotated, steel};
use calyx_elastic::assembly::System;
use calyx_elastic::model::SolidShape;
use calyx_elastic::solid::{SolidElement, mass, stiffness};
use calyx_elastic::stress::nodal_stresses_of;
use calyx_elastic::{ElasticModel, FixedComponents, Resources, statics};
use nalgebra::DVector;

/// Moves the inner nodes of a block of 3 by 3 by 3 cells.
fn distorted(at: [f64; 3]) -> [f64; 3] {
    if at.iter().any(|&x| x == 0.0 || x == 3.0) {
        return at;
    }
    let shift = |k: usize| 0.22 * (1.3 * at[0] + 2.1 * at[1] + 3.7 * at[2] + 1.9 * k as f64).sin();
    [0, 1, 2].map(|k| at[k] + shift(k))
}

/// Returns a linear field of displacements.
fn linear([x, y, z]: [f64; 3]) -> [f64; 3] {
    [1e-3 * x + 2e-3 * y - 1e-3 * z, 3e-3 * x - 2e-3 * y + 1e-3 * z, -1e-3 * x + 4e-3 * y + 2e-3 * z]
}

#[test]
fn distorted_meshes_reproduce_constant_strain() {
    for shape in SHAPES {
        let mut model = block(shape, [3, 3, 3], distorted);
        for (node, at) in model.nodes.iter().map(|node| node.position).enumerate() {
            if at.iter().any(|&x| x.abs() < 1e-12 || (x - 3.0).abs() < 1e-12) {
                for component in 0..3 {
                    let mut components = [false; 6];
                    components[component] = true;
                    model.fixed.push(FixedComponents { node, components, value: linear(at)[component] });
                }
            }
        }
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        assert!(system.unknowns().len() >= 24, "{shape:?} has no inner nodes");
        let solution = &statics::solve(&system, &[Vec::new()], &resources).expect("supported")[0];
        for (node, found) in model.nodes.iter().zip(&solution.displacements) {
            let expected = linear(node.position);
            for axis in 0..3 {
                let error = (found[axis] - expected[axis]).abs();
                assert!(error < 1e-14, "{shape:?}: {error:e} at {:?}", node.position);
            }
        }
    }
}

/// Returns the positions of one element of a shape with moved corners.
fn single(model: &ElasticModel) -> Vec<[f64; 3]> {
    model.elements[0].nodes.iter().map(|&node| model.nodes[node].position).collect()
}

#[test]
fn elements_have_six_rigid_body_motions_and_no_other_mode_without_energy() {
    for shape in SHAPES {
        let warp =
            |at: [f64; 3]| [at[0] + 0.2 * at[1] * at[2], at[1] - 0.1 * at[0], at[2] + 0.15 * at[0] * at[1]];
        let positions = single(&block(shape, [1, 1, 1], warp));
        let material = steel();
        let element = SolidElement { shape, positions: &positions, material: &material };
        let mut values: Vec<f64> =
            stiffness(&element).expect("valid").symmetric_eigenvalues().iter().copied().collect();
        values.sort_by(f64::total_cmp);
        let largest = values[values.len() - 1];
        assert!(values[5].abs() < 1e-13 * largest, "{shape:?}: {:e}", values[5] / largest);
        assert!(values[6] > 1e-4 * largest, "{shape:?}: {:e}", values[6] / largest);
    }
}

#[test]
fn mass_is_that_of_a_rigid_block() {
    for shape in SHAPES {
        // Affine cells: the integrals are polynomials of the shape functions.
        let model = block(shape, [2, 1, 2], |[x, y, z]| rotated([0.3 * x, 0.5 * y, 0.2 * z]));
        let resources = Resources::default();
        let system = System::new(&model, &resources).expect("valid");
        let rigid = system.rigid_mass(&system.mass(&resources).expect("valid"), rotated([0.3, 0.25, 0.2]));
        let mass = 7850.0 * 0.6 * 0.5 * 0.4;
        let about = [
            0.5_f64.powi(2) + 0.4_f64.powi(2),
            0.6_f64.powi(2) + 0.4_f64.powi(2),
            0.6_f64.powi(2) + 0.5_f64.powi(2),
        ];
        let inertia = about.map(|sum| mass * sum / 12.0);
        for i in 0..3 {
            for j in 0..6 {
                let expected = if i == j { mass } else { 0.0 };
                assert!((rigid[(i, j)] - expected).abs() < 1e-11 * mass, "{shape:?}: {rigid}");
            }
            let axis = rotated([0, 1, 2].map(|k| f64::from(u8::from(k == i))));
            let moment: f64 =
                (0..3).map(|a| (0..3).map(|b| axis[a] * rigid[(3 + a, 3 + b)] * axis[b]).sum::<f64>()).sum();
            assert_close(moment, inertia[i], 1e-11);
        }
    }
}

#[test]
fn mass_of_a_distorted_hexahedron_is_that_of_its_volume() {
    let positions = single(&block(SHAPES[0], [1, 1, 1], |[x, y, z]| [x * (1.0 + y), y, z * (1.0 + 0.5 * x)]));
    let material = steel();
    let element = SolidElement { shape: SHAPES[0], positions: &positions, material: &material };
    let total: f64 = mass(&element).expect("valid").iter().sum::<f64>() / 3.0;
    // Jacobian determinant (1 + y) (1 + x / 2) in the unit cube's coordinates.
    assert_close(total, 7850.0 * 1.5 * 1.25, 1e-12);
}

#[test]
fn inverted_elements_are_rejected() {
    let mut positions = single(&block(SHAPES[0], [1, 1, 1], |at| at));
    positions.swap(0, 4);
    let material = steel();
    let error = stiffness(&SolidElement { shape: SHAPES[0], positions: &positions, material: &material });
    assert!(error.expect_err("inverted").message.contains("inverted or degenerate"));
}

/// Pure bending of a bar of one layer of cells: displacements of beam theory with Poisson's
/// contraction have its stresses and energy. Without incompatible modes the energy is larger by
/// half, because the cells cannot curve.
#[test]
fn incompatible_modes_bend_without_locking() {
    let (curvature, [length, height, width]) = (1e-3, [4.0, 0.5, 1.0]);
    let bent = |[x, y, z]: [f64; 3]| {
        let contraction = 0.3 * (y * y - z * z);
        [curvature * x * y, -0.5 * curvature * (x * x + contraction), -0.3 * curvature * y * z]
    };
    let energy = |shape| {
        let place = |[x, y, z]: [f64; 3]| [x, height * (y - 0.5), width * (z - 0.5)];
        let model = block(shape, [4, 1, 1], place);
        let mut displacements = Vec::new();
        for node in &model.nodes {
            let [x, y, z] = bent(node.position);
            displacements.push([x, y, z, 0.0, 0.0, 0.0]);
        }
        let mut energy = 0.0;
        for element in &model.elements {
            let positions: Vec<_> = element.nodes.iter().map(|&node| model.nodes[node].position).collect();
            let moved = element.nodes.iter().flat_map(|&node| displacements[node][..3].to_vec());
            let moved = DVector::from_iterator(3 * positions.len(), moved);
            let solid = SolidElement { shape, positions: &positions, material: &model.materials[0] };
            energy += 0.5 * moved.dot(&(stiffness(&solid).expect("valid") * &moved));
        }
        let stresses = nodal_stresses_of(&model, &displacements).expect("valid");
        (energy, model, stresses)
    };
    let (found, model, stresses) = energy(SolidShape::IncompatibleHexahedron8);
    let second_moment = width * height.powi(3) / 12.0;
    let exact = 0.5 * 206e9 * second_moment * curvature * curvature * length;
    assert_close(found, exact, 1e-12);
    for (node, stress) in model.nodes.iter().zip(stresses.stresses) {
        let expected = 206e9 * curvature * node.position[1];
        assert_close(stress[0], expected, 1e-10);
        assert!(stress[1..].iter().all(|other| other.abs() < 1e-10 * expected.abs()), "{stress:?}");
    }
    assert!(energy(SolidShape::Hexahedron8).0 > 1.4 * exact);
}
