//! Finite elements of extreme shapes and materials.

use super::case::{Case, off, worst};
use calyx_runtime::fe::{
    Block, Constraints, Curve, ElementOrder, MeshBuilder, PlaneModel, Side, Solver, uniform,
};
use calyx_runtime::material::{Material, Plane};
use std::f64::consts::FRAC_PI_2;

pub fn cases() -> Vec<Case> {
    vec![
        Case::holds(
            "A strip in tension: elongation",
            "aspect ratios of elements of 0.25 and 250, orders 1 to 3",
            1e-6,
            "force over stiffness: exact except for rounding",
            || {
                let thickness = [1.0, 1e-3];
                worst(thickness.into_iter().flat_map(|thick| [1, 2, 3].map(|order| pulled(thick, order))))
            },
        ),
        Case::holds(
            "A thick cylinder under internal pressure: radial displacement of the bore",
            "Poisson's ratio 0.49, 0.4999, 0.499999, cubic elements",
            1e-2,
            "Lamé: the elements do not lock",
            || worst([0.49, 0.4999, 0.499999].map(|ratio| widened(ratio, 2.0))),
        ),
        Case::holds(
            "The same",
            "a wall thickness of a thousandth of the radius, six elements of 15 deg",
            0.1,
            "Lamé",
            || widened(0.3, 1.001),
        ),
    ]
}

const MODULUS: f64 = 2e11;

/// Strip of length 1 m, a row of four elements, in tension.
fn pulled(thickness: f64, order: u8) -> f64 {
    let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, thickness], [0.0, thickness]];
    let block = Block::quadrilateral(corners)
        .divided(uniform(4), uniform(1))
        .named(Side::Left, "wall")
        .named(Side::Right, "end");
    let mesh = MeshBuilder::new().block(block).finish(ElementOrder::full(order)).expect("one block");
    let material = Material { youngs_modulus: MODULUS, poissons_ratio: 0.3, density: 0.0 };
    let model = PlaneModel::new(mesh, material, Plane::Stress);
    let mut constraints = Constraints::new();
    let wall = model.mesh.chain_nodes(model.mesh.chain("wall").expect("named"));
    for &node in &wall {
        constraints.prescribe(2 * node, 0.0);
    }
    constraints.prescribe(2 * wall[0] + 1, 0.0);
    let end = model.mesh.chain("end").expect("named");
    let load = model.edge_load(end, |_, _| [1e6, 0.0]);
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let solved = solver.solve_one(&load.to_full(model.dof_count())).expect("solves");
    let nodes = model.mesh.chain_nodes(end);
    worst(nodes.iter().map(|node| off(solved[2 * node], 1e6 / MODULUS)))
}

/// Quarter of a cylinder of inner radius 1 m under internal pressure, in plane strain.
fn widened(ratio: f64, outer: f64) -> f64 {
    let pressure = 1e6;
    let block = Block::new(
        Curve::line([1.0, 0.0], [outer, 0.0]),
        Curve::arc([0.0; 2], outer, 0.0, FRAC_PI_2),
        Curve::line([0.0, 1.0], [0.0, outer]),
        Curve::arc([0.0; 2], 1.0, 0.0, FRAC_PI_2),
    )
    .divided(uniform(6), uniform(6))
    .named(Side::Bottom, "on_x")
    .named(Side::Top, "on_y")
    .on_profile(Side::Left, "bore", [0.0, FRAC_PI_2]);
    let mesh = MeshBuilder::new().block(block).finish(ElementOrder::CUBIC).expect("one block");
    let material = Material { youngs_modulus: MODULUS, poissons_ratio: ratio, density: 0.0 };
    let model = PlaneModel::new(mesh, material, Plane::Strain);
    let mesh = &model.mesh;
    let mut constraints = Constraints::new();
    for (chain, axis) in [("on_x", 1), ("on_y", 0)] {
        for node in mesh.chain_nodes(mesh.chain(chain).expect("named")) {
            constraints.prescribe(2 * node + axis, 0.0);
        }
    }
    let bore = mesh.chain("bore").expect("named");
    let load = model.edge_load(bore, |s, _| [pressure * s.cos(), pressure * s.sin()]);
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let solved = solver.solve_one(&load.to_full(model.dof_count())).expect("solves");
    let (e, nu) = (MODULUS / (1.0 - ratio * ratio), ratio / (1.0 - ratio));
    let square = outer * outer;
    let known = pressure / (square - 1.0) / e * ((1.0 - nu) + (1.0 + nu) * square);
    let at = |node: usize| {
        let [x, y] = mesh.nodes[node];
        solved[2 * node] * x + solved[2 * node + 1] * y
    };
    worst(mesh.chain_nodes(bore).into_iter().map(|node| off(at(node), known)))
}
