//! Results do not depend on units, nor on how a body lies.

use calyx_fe::material::{Material, Plane};
use calyx_fe::{
    Block, Constraints, Curve, ElementOrder, MeshBuilder, PlaneModel, Side, Solver, StressRecovery, graded,
    uniform,
};

struct Solution {
    displacements: Vec<f64>,
    surface_stress: f64,
}

/// Curved bracket of two blocks, scaled and rotated, fixed at one end and pulled at the other along
/// its own x axis.
fn bracket(length: f64, modulus: f64, angle: f64) -> Solution {
    let turned = move |[x, y]: [f64; 2]| {
        let (sin, cos) = angle.sin_cos();
        [length * (cos * x - sin * y), length * (sin * x + cos * y)]
    };
    let curve = |inner: Curve| Curve::new(move |u| turned(inner.at(u)));
    let arc = |radius, from, to| curve(Curve::arc([0.0; 2], radius, from, to));
    let line = |from, to| curve(Curve::line(from, to));
    let mut builder = MeshBuilder::new();
    builder.block(
        Block::new(
            line([1.0, 0.0], [2.0, 0.0]),
            arc(2.0, 0.0, 1.5),
            radial(1.0, 2.0, 1.5, turned),
            arc(1.0, 0.0, 1.5),
        )
        .divided(uniform(3), graded(4, 2.0))
        .named(Side::Top, "end")
        .named(Side::Left, "inside"),
    );
    builder.block(
        Block::new(
            line([1.0, -1.0], [2.2, -1.0]),
            line([2.2, -1.0], [2.0, 0.0]),
            line([1.0, 0.0], [2.0, 0.0]),
            line([1.0, -1.0], [1.0, 0.0]),
        )
        .divided(uniform(3), uniform(2))
        .named(Side::Bottom, "wall"),
    );
    let mesh = builder.finish(ElementOrder::QUADRATIC).expect("the blocks conform");
    let material = Material { youngs_modulus: modulus, poissons_ratio: 0.3, density: 1.0 };
    let model = PlaneModel::new(mesh, material, Plane::Strain);
    let mut constraints = Constraints::new();
    for node in model.mesh.chain_nodes(model.mesh.chain("wall").expect("named")) {
        constraints.fix_node(node);
    }
    let traction = [1e-3 * modulus * angle.cos(), 1e-3 * modulus * angle.sin()];
    let load = model.edge_load(model.mesh.chain("end").expect("named"), |_, _| traction);
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let displacements = solver.solve_one(&load.to_full(model.dof_count())).expect("solves");
    let chain = model.mesh.chain("inside").expect("named");
    let row = StressRecovery::new(&model).surface_row(chain, 0.5 * chain.range()[1]).expect("on the chain");
    let surface_stress = row.dot(&displacements);
    Solution { displacements, surface_stress }
}

fn radial(
    from: f64,
    to: f64,
    angle: f64,
    turned: impl Fn([f64; 2]) -> [f64; 2] + Send + Sync + 'static,
) -> Curve {
    Curve::new(move |u| {
        let radius = (1.0 - u) * from + u * to;
        turned([radius * angle.cos(), radius * angle.sin()])
    })
}

fn largest(values: &[f64]) -> f64 {
    values.iter().map(|value| value.abs()).fold(0.0, f64::max)
}

#[test]
fn units_scale_out() {
    let reference = bracket(1.0, 1.0, 0.0);
    assert!(largest(&reference.displacements) > 1e-3 && reference.surface_stress.abs() > 1e-3);
    for (length, modulus) in [(3.7e4, 3.7e4), (3.7e4, 3.7e-4), (3.7e-4, 3.7e4), (3.7e-4, 3.7e-4)] {
        let scaled = bracket(length, modulus, 0.0);
        for (scaled, reference_value) in scaled.displacements.iter().zip(&reference.displacements) {
            let error = (scaled / length - reference_value).abs();
            assert!(error < 1e-9 * largest(&reference.displacements), "length {length}, modulus {modulus}");
        }
        assert!((scaled.surface_stress / modulus / reference.surface_stress - 1.0).abs() < 1e-9);
    }
}

#[test]
fn turning_the_body_turns_the_result() {
    let reference = bracket(1.0, 1.0, 0.0);
    for angle in [0.3_f64, 1.9, -2.7] {
        let turned = bracket(1.0, 1.0, angle);
        let (sin, cos) = angle.sin_cos();
        for (turned, straight) in turned.displacements.chunks(2).zip(reference.displacements.chunks(2)) {
            let expected = [cos * straight[0] - sin * straight[1], sin * straight[0] + cos * straight[1]];
            for axis in 0..2 {
                assert!((turned[axis] - expected[axis]).abs() < 1e-10 * largest(&reference.displacements));
            }
        }
        assert!((turned.surface_stress / reference.surface_stress - 1.0).abs() < 1e-10);
    }
}

#[test]
fn equal_models_give_equal_bits() {
    let (one, other) = (bracket(1.0, 2.0, 0.4), bracket(1.0, 2.0, 0.4));
    assert_eq!(one.displacements, other.displacements);
}
