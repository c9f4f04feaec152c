//! The solid elements against what theory says of them.

mod convergence;
mod dof_sets;
mod elements;
mod recovery;
mod shapes;
mod sweep;

use calyx_fe::material::Material;
use calyx_fe::solid::SolidModel;
use calyx_fe::{Constraints, Solver};

/// Material similar to steel; no test depends on its values.
const MATERIAL: Material = Material { youngs_modulus: 2.1e11, poissons_ratio: 0.3, density: 7800.0 };

/// Displacement gradient of the fields of constant strain, with a rotation in it.
const GRADIENT: [[f64; 3]; 3] =
    [[1.1e-3, -0.7e-3, 0.3e-3], [0.4e-3, -0.9e-3, 0.8e-3], [-0.5e-3, 0.2e-3, 0.6e-3]];

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// A field of constant strain.
fn linear_field(at: [f64; 3]) -> [f64; 3] {
    GRADIENT.map(|row| 2e-4 + dot(row, at))
}

/// `n . stress`, the stress in the order xx, yy, zz, yz, zx, xy.
fn traction([xx, yy, zz, yz, zx, xy]: [f64; 6], normal: [f64; 3]) -> [f64; 3] {
    [[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]].map(|row| dot(row, normal))
}

/// Largest difference of the stiffness times a field and a load, relative to the largest term of
/// the products.
fn residual(model: &SolidModel, field: &[f64], load: &[f64]) -> f64 {
    let stiffness = model.stiffness();
    let mut forces = load.iter().map(|force| -force).collect::<Vec<_>>();
    let mut largest = 0.0_f64;
    for entry in stiffness.triplet_iter() {
        let force = entry.val * field[entry.col];
        forces[entry.row] += force;
        largest = largest.max(force.abs());
    }
    forces.iter().map(|force| force.abs()).fold(0.0, f64::max) / largest
}

fn solve(model: &SolidModel, constraints: Constraints, load: &[f64]) -> Vec<f64> {
    let solver = Solver::new(&model.stiffness(), constraints).expect("the constraints hold it");
    solver.solve_one(load).expect("there is memory")
}
