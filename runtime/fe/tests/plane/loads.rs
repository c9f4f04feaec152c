//! Loads along chains, places by arc length, and solving.

use crate::plane::{MATERIAL, distance};
use calyx_fe::material::Plane;
use calyx_fe::{
    Block, Constraints, Curve, ElementOrder, MeshBuilder, PlaneModel, Side, SolveError, Solver, graded,
};

const RADIUS: f64 = 0.03;
const ANGLE: f64 = 1.2;

/// Sector of a ring whose outer arc is both a profile (clockwise, from 2 mm) and a chain of the
/// mesh.
fn sector(order: u8) -> PlaneModel {
    let block = Block::new(
        Curve::line([0.02, 0.0], [RADIUS, 0.0]),
        Curve::arc([0.0; 2], RADIUS, 0.0, ANGLE),
        Curve::line([0.02 * ANGLE.cos(), 0.02 * ANGLE.sin()], [RADIUS * ANGLE.cos(), RADIUS * ANGLE.sin()]),
        Curve::arc([0.0; 2], 0.02, 0.0, ANGLE),
    )
    .divided(graded(2, 0.5), graded(6, 3.0))
    .on_profile(Side::Right, "profile", [0.002 + RADIUS * ANGLE, 0.002])
    .named(Side::Right, "mesh");
    let mesh = MeshBuilder::new().block(block).finish(ElementOrder::full(order)).expect("one block");
    PlaneModel::new(mesh, MATERIAL, Plane::Strain)
}

/// The sum of a load over all nodes.
fn total(load: &[(usize, f64)]) -> [f64; 2] {
    [0, 1].map(|axis| load.iter().filter(|(dof, _)| dof % 2 == axis).map(|entry| entry.1).sum())
}

#[test]
fn the_total_of_a_load_on_a_profile_is_the_integral_over_the_profile() {
    for order in 1..=3 {
        let model = sector(order);
        let chain = model.mesh.chain("profile").expect("named");
        for [from, to] in [[0.002, 0.002 + RADIUS * ANGLE], [0.0071, 0.0233], [0.011, 0.0112]] {
            let load = model.edge_load_between(chain, [from, to], |s, _| [3e5 * s * s, (80.0 * s).sin()]);
            let exact = [1e5 * (to.powi(3) - from.powi(3)), ((80.0 * from).cos() - (80.0 * to).cos()) / 80.0];
            let found = total(&load.entries);
            for axis in 0..2 {
                assert!((found[axis] - exact[axis]).abs() < 1e-12 * exact[axis].abs(), "{found:?} {exact:?}");
            }
        }
    }
}

#[test]
fn a_pressure_on_the_mesh_has_the_resultant_of_its_chord() {
    // The integral of the normal along any curve is its rotated chord, exactly for every
    // interpolation of the arc.
    for order in 1..=3 {
        let model = sector(order);
        let load = model.edge_load(model.mesh.chain("mesh").expect("named"), |_, point| point.normal);
        let (start, end) = ([RADIUS, 0.0], [RADIUS * ANGLE.cos(), RADIUS * ANGLE.sin()]);
        let found = total(&load.entries);
        assert!(distance(found, [end[1] - start[1], start[0] - end[0]]) < 1e-13 * RADIUS, "{found:?}");
    }
}

#[test]
fn places_by_arc_length_lie_there() {
    let model = sector(3);
    let mesh = &model.mesh;
    let profile = mesh.chain("profile").expect("named");
    assert!(profile.edges.windows(2).all(|pair| (pair[0].s[1] - pair[1].s[0]).abs() < 1e-15));
    for part in 0..=40 {
        let s = 0.002 + RADIUS * ANGLE * f64::from(part) / 40.0;
        let point = mesh.chain_point(profile, s).expect("on the profile");
        let angle = ANGLE - (s - 0.002) / RADIUS;
        let (sin, cos) = angle.sin_cos();
        // Error of cubic coordinates: the fourth power of a tenth, times the fourth derivative of
        // the arc over 4!.
        assert!(distance(point.position, [RADIUS * cos, RADIUS * sin]) < 2e-5 * RADIUS);
        assert!(distance(point.normal, [cos, sin]) < 1e-3 && distance(point.tangent, [sin, -cos]) < 1e-3);
    }
    assert!(mesh.chain_point(profile, 0.0019).is_none() && mesh.chain_point(profile, 1.0).is_none());

    let chain = mesh.chain("mesh").expect("named");
    assert!((chain.range()[1] / (RADIUS * ANGLE) - 1.0).abs() < 1e-5);
    for part in 0..=40 {
        let s = chain.range()[1] * f64::from(part) / 40.0;
        let (index, t) = mesh.locate(chain, s).expect("on the chain");
        assert!(
            (mesh.arc_length(chain.measure, &chain.edges[index], t) - s).abs() < 1e-12 * chain.range()[1]
        );
    }
}

#[test]
fn many_loads_solve_like_each_alone_and_fulfil_the_equations() {
    let model = sector(2);
    let stiffness = model.stiffness();
    let chain = model.mesh.chain("profile").expect("named");
    let mut constraints = Constraints::new();
    for (node, at) in model.mesh.nodes.iter().enumerate() {
        if at[1] == 0.0 {
            constraints.prescribe_node(node, [1e-7, -2e-7]);
        }
    }
    let constrained = constraints.clone();
    let solver = Solver::new(&stiffness, constraints).expect("held");
    let loads = [0.01, 0.02, 0.03].map(|s| {
        let point = model.mesh.chain_point(chain, s).expect("on the profile");
        model.displacement_row(point.place, point.normal.map(|part| -1e4 * part)).to_full(model.dof_count())
    });
    let together = faer::Mat::from_fn(model.dof_count(), 3, |row, column| loads[column][row]);
    let together = solver.solve(together.as_ref()).expect("solves");
    for (column, load) in loads.iter().enumerate() {
        let alone = solver.solve_one(load).expect("solves");
        let mut residual = load.clone();
        for entry in stiffness.triplet_iter() {
            residual[entry.row] -= entry.val * alone[entry.col];
        }
        let size = alone.iter().map(|value| value.abs()).fold(0.0, f64::max);
        for dof in 0..model.dof_count() {
            assert!((alone[dof] - together[(dof, column)]).abs() < 1e-12 * size);
            match constrained.values().get(&dof) {
                Some(&value) => assert_eq!(alone[dof], value),
                None => assert!(residual[dof].abs() < 1e-9 * 1e4),
            }
        }
    }
}

#[test]
fn a_body_free_to_move_is_refused() {
    let model = sector(2);
    let stiffness = model.stiffness();
    // Nothing held; one point held, about which it turns.
    let mut pinned = Constraints::new();
    pinned.fix_node(0);
    for constraints in [Constraints::new(), pinned] {
        assert_eq!(Solver::new(&stiffness, constraints).err(), Some(SolveError::Singular));
    }
}

#[test]
fn a_body_constrained_everywhere_has_what_is_prescribed() {
    let model = sector(1);
    let mut constraints = Constraints::new();
    for node in 0..model.mesh.nodes.len() {
        constraints.prescribe_node(node, [node as f64, -1.0]);
    }
    let solver = Solver::new(&model.stiffness(), constraints).expect("held");
    let solved = solver.solve_one(&vec![1.0; model.dof_count()]).expect("solves");
    for (node, solved) in solved.chunks(2).enumerate() {
        assert_eq!(solved, [node as f64, -1.0]);
    }
}
