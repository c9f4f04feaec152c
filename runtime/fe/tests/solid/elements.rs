//! Each kind of element: shape functions, faces, rigid-body motions, mass, invariance, patch tests.

use crate::solid::shapes::{Kind, cube, kinds};
use crate::solid::{GRADIENT, MATERIAL, dot, linear_field, residual, solve, traction};
use calyx_fe::solid::{Cell, Interpolation, SolidElementPoint, SolidModel};
use calyx_fe::{Constraints, ElementOrder};
use nalgebra::DMatrix;
use std::collections::BTreeSet;

fn interpolations() -> Vec<Interpolation> {
    let mut all = [Cell::Hexahedron, Cell::Pentahedron, Cell::Tetrahedron]
        .iter()
        .flat_map(|cell| (1..=3).map(|order| cell.interpolation(order)))
        .collect::<Vec<_>>();
    for (section, axial) in
        [(ElementOrder::CUBIC, 3), (ElementOrder::serendipity(2), 4), (ElementOrder::LINEAR, 7)]
    {
        all.push(Interpolation::axodes(section, axial));
    }
    let section = ElementOrder { sides: [3, 2, 3, 1], interior: [3, 2] };
    let axial = (0..section.node_count()).map(|node| 1 + (node % 4) as u8).collect::<Vec<_>>();
    all.push(Interpolation::Axodes { section, axial: axial.into() });
    all
}

/// A place inside of any cell.
const INSIDE: [f64; 3] = [0.31, 0.22, 0.17];

#[test]
fn shape_functions_are_one_at_their_node_and_zero_at_the_others() {
    for kind in interpolations() {
        let places = kind.node_coordinates();
        assert_eq!(places.len(), kind.node_count(), "{kind:?}");
        for (node, &place) in places.iter().enumerate() {
            for (index, shape) in kind.shapes(place).iter().enumerate() {
                let expected = if index == node { 1.0 } else { 0.0 };
                assert!((shape[0] - expected).abs() < 1e-13, "{kind:?}: function {index} at node {node}");
            }
        }
    }
}

#[test]
fn shape_functions_sum_to_one_reproduce_their_order_and_differentiate_consistently() {
    let step = 1e-5;
    for kind in interpolations() {
        let shapes = kind.shapes(INSIDE);
        let [p, q] = kind.lowest().map(i32::from);
        // A polynomial of the order of each direction, of that order altogether.
        let total = p.min(q);
        let polynomial = |[x, y, z]: [f64; 3]| (0.3 + 0.5 * x - 0.7 * y + 0.4 * z).powi(total) + z.powi(q);
        let sum =
            shapes.iter().zip(kind.node_coordinates()).map(|(shape, place)| shape[0] * polynomial(place));
        assert!((sum.sum::<f64>() - polynomial(INSIDE)).abs() < 1e-13, "{kind:?}");
        for part in 0..4 {
            let sum = shapes.iter().map(|shape| shape[part]).sum::<f64>();
            assert!((sum - if part == 0 { 1.0 } else { 0.0 }).abs() < 1e-12, "{kind:?}");
        }
        for local in 0..3 {
            let [before, after] = [-step, step].map(|step| {
                let mut place = INSIDE;
                place[local] += step;
                kind.shapes(place)
            });
            for (node, shape) in shapes.iter().enumerate() {
                let slope = (after[node][0] - before[node][0]) / (2.0 * step);
                assert!((slope - shape[1 + local]).abs() < 1e-7, "{kind:?}: function {node} by {local}");
            }
        }
    }
}

#[test]
fn faces_lie_on_the_cell_and_point_out_of_it() {
    for cell in [Cell::Hexahedron, Cell::Pentahedron, Cell::Tetrahedron] {
        let mut outward = [0.0; 3];
        for face in 0..cell.face_count() {
            for (at, weight) in cell.face_quadrature(face, 3) {
                let (place, [a, b]) = cell.face_coordinates(face, at);
                assert!(cell.is_on_face(face, place), "{cell:?}, face {face}");
                let normal =
                    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                let out = [0, 1, 2].map(|axis| place[axis] - cell.middle()[axis]);
                assert!(dot(normal, out) > 0.0, "{cell:?}, face {face} points in");
                for axis in 0..3 {
                    outward[axis] += weight * normal[axis];
                }
            }
        }
        assert!(outward.iter().all(|part| part.abs() < 1e-14), "{cell:?} is not closed: {outward:?}");
    }
}

/// Moves inner points out of their lattice, the boundary of the cube stays.
fn distorted([x, y, z]: [f64; 3]) -> [f64; 3] {
    let bubble = 64.0 * x * (1.0 - x) * y * (1.0 - y) * z * (1.0 - z);
    let skew = (1.0 + 0.5 * x) * (1.0 - 0.4 * y) * (1.0 + 0.3 * z);
    [x + 0.11 * bubble * skew, y - 0.09 * bubble * skew, z + 0.1 * bubble * (2.0 - skew)]
}

#[test]
fn constant_strain_on_distorted_meshes() {
    for kind in kinds() {
        for coordinates in 1..=kind.order() {
            // Distorted inside; with higher coordinates the inner faces are curved.
            let mesh = cube(kind, coordinates, [2, 2, 3], &distorted);
            let boundary = mesh.boundary();
            let model = SolidModel::new(mesh, MATERIAL);
            let mesh = &model.mesh;
            let mut constraints = Constraints::new();
            let outside = boundary.iter().flat_map(|face| {
                let element = &mesh.elements[face.element];
                element.interpolation.face_nodes(face.face).into_iter().map(|local| element.nodes[local])
            });
            for node in outside.collect::<BTreeSet<_>>() {
                for (axis, value) in linear_field(mesh.nodes[node]).into_iter().enumerate() {
                    constraints.prescribe(3 * node + axis, value);
                }
            }
            let name = format!("{kind:?}, coordinates {coordinates}");
            let constrained = constraints.values().len();
            assert!(constrained < model.dof_count(), "{name}: nothing left to find");
            let solved = solve(&model, constraints, &vec![0.0; model.dof_count()]);
            for (node, &position) in mesh.nodes.iter().enumerate() {
                for (axis, exact) in linear_field(position).into_iter().enumerate() {
                    let found = solved[3 * node + axis];
                    assert!((found - exact).abs() < 1e-13, "{name}: displacement {found} is not {exact}");
                }
            }
            let exact = model.stress_of(GRADIENT);
            for element in 0..mesh.elements.len() {
                let found = model.stress(SolidElementPoint { element, local: INSIDE }, &solved);
                for (found, exact) in found.iter().zip(&exact) {
                    assert!(
                        (found - exact).abs() < 1e-9 * MATERIAL.youngs_modulus * 1e-3,
                        "{name}: {found} {exact}"
                    );
                }
            }
            // Tractions on the boundary balance the stress: stiffness and loads integrate alike.
            let set = calyx_fe::solid::FaceSet { faces: boundary, chart: None };
            let load =
                model.face_load(&set, |point| traction(exact, point.normal)).to_full(model.dof_count());
            let left = residual(&model, &solved, &load);
            assert!(left < 1e-12, "{name}: residual {left:e}");
        }
    }
}

/// One box, bent and skew.
fn bent([x, y, z]: [f64; 3]) -> [f64; 3] {
    let turn = 0.4 * z + 0.2 * x;
    let (sin, cos) = turn.sin_cos();
    let [a, b] = [1.0 + 0.8 * x + 0.1 * y * z, 1.2 * y - 0.15 * x * x];
    [a * cos - b * sin, a * sin + b * cos, 0.9 * z + 0.1 * x * y]
}

fn dense(model: &SolidModel) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(model.dof_count(), model.dof_count());
    for entry in model.stiffness().triplet_iter() {
        matrix[(entry.row, entry.col)] = *entry.val;
    }
    matrix
}

#[test]
fn exactly_six_motions_without_energy() {
    for kind in kinds() {
        for coordinates in 1..=kind.order() {
            let model = SolidModel::new(cube(kind, coordinates, [1; 3], &bent), MATERIAL);
            let matrix = dense(&model);
            assert_eq!(matrix, matrix.transpose(), "{kind:?} is not symmetric to the bit");
            let mut values = matrix.symmetric_eigenvalues().iter().copied().collect::<Vec<_>>();
            values.sort_by(f64::total_cmp);
            let largest = values[values.len() - 1];
            assert!(values[5].abs() < 1e-13 * largest, "{kind:?}: sixth {:e}", values[5] / largest);
            // The smallest elastic eigenvalue of a single linear pentahedron is near 1e-2 of the
            // largest one; that of thin cubic ones is near 1e-4.
            assert!(values[6] > 1e-6 * largest, "{kind:?}: seventh {:e}", values[6] / largest);
        }
    }
}

#[test]
fn turning_the_body_turns_the_stiffness() {
    let axes = nalgebra::Rotation3::from_euler_angles(0.7, -0.4, 1.1).into_inner();
    for kind in kinds() {
        let turned = |at: [f64; 3]| {
            let at = axes * nalgebra::Vector3::from(bent(at));
            [at[0] + 0.3, at[1] - 2.0, at[2] + 0.7]
        };
        let [a, b] = [&bent as &dyn Fn([f64; 3]) -> [f64; 3], &turned]
            .map(|bend| dense(&SolidModel::new(cube(kind, kind.order(), [1; 3], bend), MATERIAL)));
        let mut turn = DMatrix::zeros(a.nrows(), a.nrows());
        for node in 0..a.nrows() / 3 {
            turn.view_mut((3 * node, 3 * node), (3, 3)).copy_from(&axes);
        }
        let difference = &turn * a * turn.transpose() - &b;
        let left = difference.amax() / b.amax();
        assert!(left < 1e-13, "{kind:?}: {left:e}");
    }
}

#[test]
fn mass_has_the_total_and_the_moments_of_the_volume() {
    for kind in kinds() {
        for coordinates in 1..=kind.order() {
            let model = SolidModel::new(cube(kind, coordinates, [2, 1, 2], &bent), MATERIAL);
            let mass = model.mass();
            let modes = model.rigid_body_modes();
            let product = |a: usize, b: usize| {
                mass.triplet_iter()
                    .map(|entry| modes[a][entry.row] * entry.val * modes[b][entry.col])
                    .sum::<f64>()
            };
            // Volume and moments by a finer quadrature.
            let (mut volume, mut about_x, mut first_z) = (0.0, 0.0, 0.0);
            for (index, element) in model.mesh.elements.iter().enumerate() {
                for (local, weight) in element.interpolation.cell().quadrature([9, 9]) {
                    let place = SolidElementPoint { element: index, local };
                    let [a, b, c] = model.mesh.jacobian(place);
                    let cross =
                        [b[1] * c[2] - b[2] * c[1], b[2] * c[0] - b[0] * c[2], b[0] * c[1] - b[1] * c[0]];
                    let weight = weight * dot(a, cross) * MATERIAL.density;
                    let [_, y, z] = model.mesh.position(place);
                    volume += weight;
                    about_x += weight * (y * y + z * z);
                    first_z += weight * z;
                }
            }
            let close = |found: f64, exact: f64| (found - exact).abs() < 1e-12 * about_x.max(volume);
            for axis in 0..3 {
                assert!(close(product(axis, axis), volume), "{kind:?}, coordinates {coordinates}");
            }
            assert!(close(product(3, 3), about_x), "{kind:?}, coordinates {coordinates}");
            // A turn about x moves y by -z.
            assert!(close(product(1, 3), -first_z), "{kind:?}, coordinates {coordinates}");
        }
    }
}

#[test]
fn the_same_bits_with_one_thread_and_with_many() {
    let model = SolidModel::new(cube(Kind::Swept(3, 3), 3, [5, 5, 4], &bent), MATERIAL);
    let matrices = [1, 2, 5].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| (model.stiffness(), model.mass()))
    });
    for (stiffness, mass) in &matrices[1..] {
        assert_eq!(stiffness.val(), matrices[0].0.val());
        assert_eq!(mass.val(), matrices[0].1.val());
    }
}
