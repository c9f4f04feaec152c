//! The report's element: rigid-body motions, zero-energy modes, patch tests, varying thickness,
//! offsets, errors.

use super::support::{DirectorMesh, Model, assert_close, corners, material, places, uniform};
use calyx_elastic::model::Material;
use calyx_elastic::shell::{DirectorNode, DirectorShape, DirectorShell, Integration};
use nalgebra::{DMatrix, Vector3};

const SHAPES: [DirectorShape; 6] = [
    DirectorShape::Quadrilateral(1),
    DirectorShape::Quadrilateral(2),
    DirectorShape::Quadrilateral(3),
    DirectorShape::Triangle(1),
    DirectorShape::Triangle(2),
    DirectorShape::Triangle(3),
];

const RULES: [Integration; 3] = [Integration::Full, Integration::SelectivelyReduced, Integration::Reduced];

/// Curved element of varying thickness with inclined thickness vectors and an offset.
fn curved(shape: DirectorShape) -> Vec<DirectorNode> {
    let node = |[x, y]: [f64; 2]| DirectorNode {
        position: [1.0 + x + 0.1 * y, y - 0.2 * x, 0.2 * x * x - 0.1 * x * y],
        half_thickness: [0.02 * x, -0.01, 0.08 + 0.02 * y],
        offset: 0.5,
    };
    places(shape).into_iter().map(node).collect()
}

fn flat(shape: DirectorShape) -> Vec<DirectorNode> {
    let node = |[x, y]: [f64; 2]| DirectorNode {
        position: [x + 0.1 * y, y - 0.2 * x, 0.0],
        half_thickness: [0.0, 0.0, 0.05],
        offset: 0.0,
    };
    places(shape).into_iter().map(node).collect()
}

/// Rigid-body motions in u and w, as columns.
fn rigid(nodes: &[DirectorNode]) -> DMatrix<f64> {
    let mut modes = DMatrix::zeros(6 * nodes.len(), 6);
    for (index, node) in nodes.iter().enumerate() {
        for axis in 0..3 {
            modes[(6 * index + axis, axis)] = 1.0;
            for (first, vector) in [(0, node.position), (3, node.half_thickness)] {
                let turn = Vector3::ith(axis, 1.0).cross(&Vector3::from(vector));
                (0..3).for_each(|part| modes[(6 * index + first + part, 3 + axis)] = turn[part]);
            }
        }
    }
    modes
}

/// Returns the number of motions without strain energy under the constraint of the thickness.
fn zero_energy_modes(nodes: &[DirectorNode], stiffness: &DMatrix<f64>) -> usize {
    let mut permitted = DMatrix::zeros(6 * nodes.len(), 5 * nodes.len());
    for (index, node) in nodes.iter().enumerate() {
        for axis in 0..3 {
            permitted[(6 * index + axis, 5 * index + axis)] = 1.0;
            for (column, tangent) in node.tangents().into_iter().enumerate() {
                permitted[(6 * index + 3 + axis, 5 * index + 3 + column)] = tangent[axis];
            }
        }
        let constraint = Vector3::from(node.thickness_constraint());
        node.tangents().iter().for_each(|t| assert!(constraint.dot(&Vector3::from(*t)).abs() < 1e-15));
    }
    let reduced = permitted.transpose() * stiffness * permitted;
    let scale = reduced.diagonal().map(|x| x.sqrt().recip());
    let count = reduced.nrows();
    let scaled = DMatrix::from_fn(count, count, |r, c| reduced[(r, c)] * scale[r] * scale[c]);
    scaled.symmetric_eigenvalues().iter().filter(|value| value.abs() < 1e-9).count()
}

/// Zero-energy modes of single flat elements, six of them rigid-body motions: what remains for each
/// shape with full, selectively reduced and reduced integration.
#[test]
fn rigid_body_motions_are_exact_and_mechanisms_are_known() {
    let steel = material(2e11, 0.3, 7850.0);
    for (shape, expected) in SHAPES.into_iter().zip(MODES) {
        for (integration, expected) in RULES.into_iter().zip(expected) {
            for nodes in [flat(shape), curved(shape)] {
                let element = DirectorShell { shape, nodes: &nodes, material: &steel, integration };
                let matrix = element.stiffness().unwrap();
                assert_eq!(matrix, matrix.transpose());
                let ratio = (&matrix * rigid(&nodes)).amax() / matrix.amax();
                assert!(ratio < 1e-13, "{shape:?}: {ratio:.1e}");
            }
            let nodes = flat(shape);
            let element = DirectorShell { shape, nodes: &nodes, material: &steel, integration };
            let count = zero_energy_modes(&nodes, &element.stiffness().unwrap());
            assert_eq!(count, expected, "{shape:?} {integration:?}");
        }
    }
}

const MODES: [[usize; 3]; 6] = [[6, 8, 12], [6, 7, 13], [6, 7, 13], [6, 7, 7], [6, 6, 6], [6, 6, 6]];

#[test]
fn mass_of_rigid_motions_is_exact() {
    let steel = material(2e11, 0.3, 7850.0);
    for shape in SHAPES {
        let nodes = flat(shape);
        let element =
            DirectorShell { shape, nodes: &nodes, material: &steel, integration: Integration::Full };
        let modes = rigid(&nodes);
        let inertia = modes.transpose() * element.mass().unwrap() * &modes;
        // The map from the reference element has determinant 1.02.
        let area = 1.02 * if matches!(shape, DirectorShape::Triangle(_)) { 0.5 } else { 4.0 };
        let mass = 7850.0 * 0.1 * area;
        assert_close(inertia[(0, 0)], mass, 1e-13, "mass");
        // Moments of x^2, x y and y^2 over the reference element.
        let [xx, xy] = if matches!(shape, DirectorShape::Triangle(_)) {
            [1.0 / 6.0, 1.0 / 12.0]
        } else {
            [1.0 / 3.0, 0.0]
        };
        let across = 0.1 * 0.1 / 12.0;
        let about_x = mass * (xx - 0.4 * xy + 0.04 * xx + across);
        let about_y = mass * (xx + 0.2 * xy + 0.01 * xx + across);
        assert_close(inertia[(3, 3)], about_x, 1e-12, "inertia about x");
        assert_close(inertia[(4, 4)], about_y, 1e-12, "inertia about y");
    }
}

/// Motion of a node at x and y: translations of the mid-surface and rotations.
type Field = fn(f64, f64) -> ([f64; 3], [f64; 2]);

const MEMBRANE: [Field; 3] = [
    |x, _| ([1e-3 * x, 0.0, 0.0], [0.0; 2]),
    |_, y| ([0.0, 1e-3 * y, 0.0], [0.0; 2]),
    |x, y| ([1e-3 * y, 1e-3 * x, 0.0], [0.0; 2]),
];

const BENDING: [Field; 3] = [
    |x, _| ([0.0, 0.0, 0.5 * x * x], [0.0, -x]),
    |_, y| ([0.0, 0.0, 0.5 * y * y], [y, 0.0]),
    |x, y| ([0.0, 0.0, x * y], [x, -y]),
];

/// Distorted mesh of the unit square with straight sides; a regular one if `wave` is zero.
fn patch(triangles: bool, order: u8, wave: f64, offset: f64) -> DirectorMesh {
    let lines = uniform(3);
    let node = |[u, v]: [f64; 2]| DirectorNode {
        position: [u, v, -0.05 * offset],
        half_thickness: [0.0, 0.0, 0.05],
        offset,
    };
    let mut mesh = DirectorMesh::grid(triangles, order, &lines, &lines, node);
    mesh.straighten(|[x, y, z]| {
        let inside = |t: f64| t > 0.01 && t < 0.99;
        if inside(x) && inside(y) {
            [x + wave * (17.0 * x + 39.0 * y).sin(), y + wave * (15.0 * y - 29.0 * x).sin(), z]
        } else {
            [x, y, z]
        }
    });
    mesh
}

fn check_patch(mesh: &DirectorMesh, integration: Integration, field: Field, what: &str) {
    let steel = material(2.0, 0.3, 0.0);
    let mut model = Model::new(mesh.nodes.len());
    mesh.each(&steel, integration, |nodes, element| {
        model.add_stiffness(nodes, element.stiffness().unwrap());
    });
    let motion = |node: usize| {
        let at = mesh.nodes[node];
        let (u, turn) = field(at.position[0], at.position[1]);
        let half = at.half_thickness[2];
        let w = [turn[1] * half, -turn[0] * half, 0.0];
        // The field is that of the mid-surface.
        [u[0] - at.offset * w[0], u[1] - at.offset * w[1], u[2], w[0], w[1], 0.0]
    };
    for (node, &[u, v]) in mesh.parameters.iter().enumerate() {
        model.fix(node, &[5]);
        let border = |t: f64| t == 0.0 || t == 1.0;
        if border(u) || border(v) {
            for (component, value) in motion(node).into_iter().enumerate() {
                model.constraints.prescribe(6 * node + component, value);
            }
        }
    }
    let found = model.solve();
    let largest = (0..mesh.nodes.len()).flat_map(motion).fold(0.0_f64, |m, x| m.max(x.abs()));
    for node in 0..mesh.nodes.len() {
        for (component, value) in motion(node).into_iter().enumerate() {
            let error = (found[6 * node + component] - value).abs() / largest;
            assert!(error < 1e-10, "{what}: node {node} component {component}: {error:.1e}");
        }
    }
}

/// The linear element represents curvature only where its sides are parallel and its shear is
/// reduced.
#[test]
fn constant_membrane_strain_and_curvature_are_exact() {
    for shape in SHAPES {
        let (triangles, order) = match shape {
            DirectorShape::Quadrilateral(order) => (false, order),
            DirectorShape::Triangle(order) => (true, order),
        };
        for integration in [Integration::Full, Integration::SelectivelyReduced] {
            for offset in [0.0, 0.8] {
                let what = format!("{shape:?} {integration:?} offset {offset}");
                for field in MEMBRANE {
                    check_patch(&patch(triangles, order, 0.09, offset), integration, field, &what);
                }
                for field in BENDING.into_iter().filter(|_| order > 1) {
                    check_patch(&patch(triangles, order, 0.09, offset), integration, field, &what);
                }
            }
        }
    }
    for field in BENDING {
        check_patch(&patch(false, 1, 0.0, 0.0), Integration::SelectivelyReduced, field, "linear");
    }
}

/// Constant transverse shear on distorted meshes: energy, and no transverse force on inner nodes.
#[test]
fn constant_transverse_shear_is_exact() {
    let steel = material(2.0, 0.3, 0.0);
    for shape in SHAPES {
        let (triangles, order) = match shape {
            DirectorShape::Quadrilateral(order) => (false, order),
            DirectorShape::Triangle(order) => (true, order),
        };
        let mesh = patch(triangles, order, 0.09, 0.0);
        let mut model = Model::new(mesh.nodes.len());
        mesh.each(&steel, Integration::SelectivelyReduced, |nodes, element| {
            model.add_stiffness(nodes, element.stiffness().unwrap());
        });
        let mut motion = vec![0.0; model.load.len()];
        for (node, at) in mesh.nodes.iter().enumerate() {
            motion[6 * node + 2] = 1e-3 * at.position[0];
        }
        let forces = model.forces(&motion);
        let energy = forces.iter().zip(&motion).map(|(f, u)| f * u).sum::<f64>();
        let resultant = 5.0 / 6.0 * steel.shear_modulus * 0.1 * 1e-3;
        assert_close(energy, 1e-3 * resultant, 1e-12, &format!("{shape:?}"));
        let inside = |t: f64| t > 0.0 && t < 1.0;
        for node in mesh.nodes_where(|[u, v]| inside(u) && inside(v)) {
            assert!(forces[6 * node + 2].abs() < 1e-12 * resultant, "{shape:?} node {node}");
        }
    }
}

/// Cantilever whose thickness varies linearly, under a force at its end: the deflection by
/// Timoshenko's beam theory, with the integrals of M^2 / (E I) and Q^2 / (kappa G A) in closed
/// form.
#[test]
fn a_cantilever_of_varying_thickness_bends_as_a_beam() {
    let (length, [root, tip]) = (10.0, [0.2_f64, 0.1]);
    let steel = material(1e7, 0.0, 0.0);
    let slope = (tip - root) / length;
    let thickness = |x: f64| root + slope * x;
    // With t = root + slope x: (length - x) = (tip - t) / slope, and dx = dt / slope.
    let antiderivative = |t: f64| -tip * tip / (2.0 * t * t) + 2.0 * tip / t + t.ln();
    let bending = 12.0 / 1e7 * (antiderivative(tip) - antiderivative(root)) / slope.powi(3);
    let shear = 1.2 / steel.shear_modulus * (tip / root).ln() / slope;
    let node = |[u, v]: [f64; 2]| DirectorNode {
        position: [length * u, v, 0.0],
        half_thickness: [0.0, 0.0, 0.5 * thickness(length * u)],
        offset: 0.0,
    };
    let mesh = DirectorMesh::grid(false, 3, &uniform(8), &[0.0, 1.0], node);
    let mut model = Model::new(mesh.nodes.len());
    mesh.each(&steel, Integration::SelectivelyReduced, |nodes, element| {
        model.add_stiffness(nodes, element.stiffness().unwrap());
    });
    for (node, &[u, v]) in mesh.parameters.iter().enumerate() {
        model.fix(node, &[5]);
        if u == 0.0 {
            model.fix(node, &[0, 1, 2, 3, 4]);
        }
        if u == 1.0 {
            // Consistent with cubic displacements.
            model.load[6 * node + 2] = if v == 0.0 || v == 1.0 { 0.125 } else { 0.375 };
        }
    }
    let found = model.solve()[6 * mesh.nodes_where(|at| at == [1.0, 0.0])[0] + 2];
    // The section is inclined by at most 0.005: theory of order 0.005^2.
    assert_close(found, bending + shear, 3e-5, "deflection");
}

/// Two layers of different modulus and thickness on common nodes at their interface.
#[test]
fn offset_layers_are_a_composite_section() {
    let (length, moment) = (4.0, 1e-3);
    let layers = [(2.0, 0.1, -1.0), (1.0, 0.2, 1.0)];
    let (mut a, mut b, mut d) = (0.0, 0.0, 0.0);
    for (e, t, side) in layers {
        let z = 0.5 * t * side;
        a += e * t;
        b += e * t * z;
        d += e * (f64::powi(t, 3) / 12.0 + t * z * z);
    }
    let curvature = moment / (d - b * b / a);
    for order in [2, 3] {
        // Thickness derivatives differ between the layers: both refer to the first layer's zeta.
        let half = 0.05;
        let mesh = |t: f64, side: f64| {
            DirectorMesh::grid(false, order, &uniform(3), &[0.0, 1.0], |[u, v]| DirectorNode {
                position: [length * u, v, 0.0],
                half_thickness: [0.0, 0.0, 0.5 * t],
                offset: side,
            })
        };
        let first = mesh(0.1, -1.0);
        let mut model = Model::new(first.nodes.len());
        for (e, t, side) in layers {
            mesh(t, side).each(&material(e, 0.0, 0.0), Integration::Full, |nodes, element| {
                let mut matrix = element.stiffness().unwrap();
                for index in 0..nodes.len() {
                    let factor = 0.5 * t / half;
                    let mut columns = matrix.columns_mut(6 * index + 3, 3);
                    columns *= factor;
                    let mut rows = matrix.rows_mut(6 * index + 3, 3);
                    rows *= factor;
                }
                model.add_stiffness(nodes, matrix);
            });
        }
        let weights: &[f64] = if order == 2 { &[1.0, 4.0, 1.0] } else { &[1.0, 3.0, 3.0, 1.0] };
        let total = weights.iter().sum::<f64>();
        for (node, &[u, v]) in first.parameters.iter().enumerate() {
            model.fix(node, &[5]);
            if u == 0.0 {
                model.fix(node, &[0, 1, 2, 3, 4]);
            }
            if u == 1.0 {
                let weight = weights[(v * f64::from(order)).round() as usize] / total;
                model.load[6 * node + 3] = -moment / half * weight;
            }
        }
        let found = model.solve();
        let tip = first.nodes_where(|at| at == [1.0, 0.0])[0];
        assert_close(found[6 * tip + 2], 0.5 * curvature * length * length, 1e-9, "deflection");
        assert_close(found[6 * tip], b / a * curvature * length, 1e-9, "axial displacement");
    }
}

#[test]
fn bad_elements_are_rejected_with_their_reason() {
    let error = |shape: DirectorShape, alter: fn(&mut Vec<DirectorNode>, &mut Material)| {
        let mut nodes = flat(DirectorShape::Quadrilateral(2));
        let mut steel = material(2e11, 0.3, 7850.0);
        alter(&mut nodes, &mut steel);
        let element =
            DirectorShell { shape, nodes: &nodes, material: &steel, integration: Integration::Full };
        element.stiffness().unwrap_err().message
    };
    let shape = DirectorShape::Quadrilateral(2);
    let cases = [
        (error(DirectorShape::Quadrilateral(4), |_, _| {}), "order of the shell element is 4"),
        (error(DirectorShape::Triangle(2), |_, _| {}), "6 nodes has 9"),
        (error(shape, |nodes, _| nodes[0].offset = f64::NAN), "node 1 of the shell element is not finite"),
        (error(shape, |nodes, _| nodes[3].half_thickness = [0.0; 3]), "no thickness at its node 4"),
        (error(shape, |nodes, _| nodes.iter_mut().for_each(|n| n.half_thickness[2] = -0.05)), "folded"),
        (error(shape, |nodes, _| nodes.iter_mut().for_each(|n| n.position[1] = 0.0)), "no area"),
        (error(shape, |_, steel| steel.youngs_modulus = -1.0), "Young's modulus"),
    ];
    for (message, reason) in cases {
        assert!(message.contains(reason), "{reason}: {message}");
    }
    assert_eq!(corners(shape), [0, 2, 8, 6]);
}
