//! Natural frequency of a simply supported plate with shear deformation and rotary inertia.

use super::support::{DirectorMesh, Mesh, Model, SHAPES, assert_close, material, product, uniform};
use calyx_elastic::model::ShellShape;
use calyx_elastic::shell::{DirectorNode, Integration};
use std::f64::consts::PI;

const SIDE: f64 = 1.0;
const THICKNESS: f64 = 0.1;

/// Square of the circular frequency of the first mode of a Mindlin plate with hard simple support.
///
/// Deflection and rotations are w = W f, grad f times R, with f a product of sines and
/// k^2 = 2 (pi / a)^2: two degrees of freedom in closed form.
fn exact() -> f64 {
    let steel = material(2e11, 0.3, 7850.0);
    let k = 2.0 * (PI / SIDE).powi(2);
    let bending = steel.youngs_modulus * THICKNESS.powi(3) / (12.0 * (1.0 - 0.3 * 0.3));
    let shear = 5.0 / 6.0 * steel.shear_modulus * THICKNESS;
    let (mass, inertia) = (7850.0 * THICKNESS, 7850.0 * THICKNESS.powi(3) / 12.0);
    // Stiffness [[shear k, -shear k], [-shear k, shear k + bending k^2]], mass [mass, inertia k].
    let (p, q) = (mass * inertia * k, -(shear * k * inertia * k + (shear * k + bending * k * k) * mass));
    let r = shear * k * bending * k * k;
    (-q - (q * q - 4.0 * p * r).sqrt()) / (2.0 * p)
}

/// Returns the lowest eigenvalue by inverse iteration.
fn lowest(model: &Model) -> f64 {
    let solver = model.solver().unwrap();
    let mut shape = vec![0.0; model.load.len()];
    shape.iter_mut().skip(2).step_by(6).for_each(|w| *w = 1.0);
    let mut value = 0.0;
    for _ in 0..12 {
        let inertia = product(&model.mass, &shape);
        let next = solver.solve_one(&inertia).unwrap();
        let (force, mass) = (inertia, product(&model.mass, &next));
        let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        value = dot(&force, &next) / dot(&mass, &next);
        let scale = dot(&mass, &next).sqrt().recip();
        shape = next.into_iter().map(|x| x * scale).collect();
    }
    value
}

#[test]
fn rotations_give_the_frequency_of_a_mindlin_plate() {
    let steel = material(2e11, 0.3, 7850.0);
    for shape in SHAPES {
        let linear = matches!(shape, ShellShape::Triangle3 | ShellShape::Quadrilateral4);
        let lines = uniform(if linear { 12 } else { 6 });
        let mesh = Mesh::grid(shape, &lines, &lines, |[u, v]| [0.5 * SIDE * u, 0.5 * SIDE * v, 0.0]);
        let mut model = Model::of_mesh(&mesh, THICKNESS, 0.0, &steel);
        model.fix_all(&mesh.nodes(|_| true), &[0, 1]);
        model.fix_all(&mesh.nodes(|[u, _]| u == 0.0), &[4]);
        model.fix_all(&mesh.nodes(|[_, v]| v == 0.0), &[3]);
        model.fix_all(&mesh.nodes(|[u, _]| u == 1.0), &[2, 3]);
        model.fix_all(&mesh.nodes(|[_, v]| v == 1.0), &[2, 4]);
        let found = lowest(&model).sqrt();
        println!("{shape:?}: {:.2e}", found / exact().sqrt() - 1.0);
        let allowed = match shape {
            ShellShape::Triangle3 => 5e-3,
            ShellShape::Quadrilateral4 => 2e-3,
            _ => 2e-4,
        };
        assert_close(found, exact().sqrt(), allowed, &format!("{shape:?}"));
    }
}

#[test]
fn cubic_report_elements_give_the_frequency_of_a_mindlin_plate() {
    let steel = material(2e11, 0.3, 7850.0);
    let lines = uniform(4);
    let mesh = DirectorMesh::grid(false, 3, &lines, &lines, |[u, v]| DirectorNode {
        position: [0.5 * SIDE * u, 0.5 * SIDE * v, 0.0],
        half_thickness: [0.0, 0.0, 0.5 * THICKNESS],
        offset: 0.0,
    });
    let mut model = Model::new(mesh.nodes.len());
    mesh.each(&steel, Integration::SelectivelyReduced, |nodes, element| {
        model.add_stiffness(nodes, element.stiffness().unwrap());
        model.add_mass(nodes, element.mass().unwrap());
    });
    for (node, &[u, v]) in mesh.parameters.iter().enumerate() {
        model.fix(node, &[0, 1, 5]);
        for (at, across, along) in [(u, 3, 4), (v, 4, 3)] {
            if at == 0.0 {
                model.fix(node, &[across]);
            } else if at == 1.0 {
                model.fix(node, &[2, along]);
            }
        }
    }
    assert_close(lowest(&model).sqrt(), exact().sqrt(), 1e-7, "frequency");
}
