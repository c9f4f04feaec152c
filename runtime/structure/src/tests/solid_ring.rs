//! Condensed and repeated three-dimensional sectors against the whole ring in one mesh, and free
//! bodies against supported ones.

use super::bodies::{Divisions, STEEL, toothed_ring, toothed_sector};
use crate::condense::{Assembled, Support, condense, match_cuts};
use crate::ring::RingFlexibility;
use calyx_fe::solid::{SolidMesh, SolidModel};
use calyx_fe::{Constraints, PlaneMesh, Solver, SparseVector};
use calyx_numerics::interrupt::Interrupt;
use std::f64::consts::TAU;

const TEETH: u32 = 5;
const SMALL: Divisions = Divisions { rim: 1, tooth_root: 1, flank: 2, thickness: 2, grading: 1.0 };
/// Bore radius of the toothed ring.
const BORE: f64 = 0.75;

/// Returns a section swept along a helix.
fn helical(section: &PlaneMesh) -> SolidModel {
    let place = |[x, y]: [f64; 2], z: f64| {
        let (sin, cos) = (0.6 * z).sin_cos();
        [cos * x - sin * y, sin * x + cos * y, z]
    };
    SolidModel::new(SolidMesh::swept(section, &[0.0, 0.3, 0.5], 2, &place).unwrap(), STEEL)
}

fn assembled(model: &SolidModel) -> Assembled {
    Assembled::solid(&model.mesh, &Interrupt::never(), || Ok(model.stiffness())).expect("room")
}

fn turned([x, y, z]: [f64; 3], angle: f64) -> [f64; 3] {
    let (sin, cos) = angle.sin_cos();
    [cos * x - sin * y, sin * x + cos * y, z]
}

/// Returns the load vector of a unit force at the node nearest to a point, rotated by `angle`.
fn force(model: &SolidModel, point: [f64; 3], direction: [f64; 3], angle: f64) -> SparseVector {
    let (point, direction) = (turned(point, angle), turned(direction, angle));
    let distance = |node: usize| -> f64 {
        (0..3).map(|axis| (model.mesh.nodes[node][axis] - point[axis]).powi(2)).sum()
    };
    let nearest = (0..model.mesh.nodes.len()).min_by(|&a, &b| distance(a).total_cmp(&distance(b))).unwrap();
    (0..3).map(|axis| (3 * nearest + axis, direction[axis])).collect()
}

const POINTS: [([f64; 3], [f64; 3]); 3] = [
    ([1.3, 0.2, 0.0], [0.3, -1.0, 0.2]),
    ([1.4, -0.1, 0.5], [-0.5, 0.7, 0.1]),
    ([0.85, 0.3, 0.3], [1.0, 0.2, -0.8]),
];

#[test]
fn condensed_helical_sectors_agree_with_the_whole_mesh() {
    let sector = helical(&toothed_sector(TEETH, 1.0, SMALL).0.mesh);
    let nodes = |name: &str| sector.mesh.nodes_on(sector.mesh.face_set(name).unwrap());
    let angle = TAU / f64::from(TEETH);
    let bore = nodes("bore");
    let equations = assembled(&sector);
    let cuts =
        match_cuts(&equations.positions, &nodes("cut_first"), &nodes("cut_last"), &bore, angle).unwrap();
    let loads: Vec<_> = POINTS.iter().map(|&(at, along)| force(&sector, at, along, 0.0)).collect();
    let constrained = equations.dofs_of(&bore);
    let condensed = condense(
        &equations,
        &Support::Constrained(&constrained),
        Some(&cuts),
        &loads,
        &loads,
        &Interrupt::never(),
    )
    .unwrap();
    let ring =
        RingFlexibility::new(condensed.stiffness.as_ref().unwrap(), TEETH, 2, &Interrupt::never()).unwrap();

    let whole = helical(&toothed_ring(TEETH, SMALL));
    let mut constrained = Constraints::new();
    for (node, [x, y, _]) in whole.mesh.nodes.iter().enumerate() {
        if (x.hypot(*y) - BORE).abs() < 0.01 {
            for axis in 0..3 {
                constrained.prescribe(3 * node + axis, 0.0);
            }
        }
    }
    let solver = Solver::new(&whole.stiffness(), constrained).unwrap();
    for (column, &(at, along)) in POINTS.iter().enumerate() {
        let displacement =
            solver.solve_one(&force(&whole, at, along, 0.0).to_full(whole.dof_count())).unwrap();
        let scale = condensed.own[(column, column)];
        for offset in 0..=2 {
            for (row, &(observed, direction)) in POINTS.iter().enumerate() {
                let direct = force(&whole, observed, direction, angle * f64::from(offset)).dot(&displacement);
                let cuts = ring.at(offset) * condensed.on_cuts.col(column);
                let through = condensed.on_cuts.col(row).transpose() * &cuts;
                let by_rows = condensed.rows_cuts.row(row) * &cuts;
                let first = if offset == 0 { 1.0 } else { 0.0 };
                let error = (through + first * condensed.own[(row, column)] - direct).abs() / scale;
                assert!(error < 1e-9, "offset {offset}: {error:.1e}");
                let error = (by_rows + first * condensed.rows_own[(row, column)] - direct).abs() / scale;
                assert!(error < 1e-9, "rows, offset {offset}: {error:.1e}");
            }
        }
    }
}

/// Loads in equilibrium deform a free body like a supported one, in forms that vanish for
/// rigid-body motions.
#[test]
fn a_free_body_deforms_like_a_constrained_one_under_balanced_loads() {
    let sector = helical(&toothed_sector(TEETH, 1.0, SMALL).0.mesh);
    let equations = assembled(&sector);
    let motions = sector.rigid_body_modes();
    // Pairs of opposite forces along the line through two nodes: strains of that line, up to a
    // factor.
    let pairs = [(3, 70), (12, 41), (55, 8)];
    let pair = |(a, b): (usize, usize)| -> SparseVector {
        let [from, to] = [a, b].map(|node| sector.mesh.nodes[node]);
        (0..3)
            .flat_map(|axis| [(3 * a + axis, from[axis] - to[axis]), (3 * b + axis, to[axis] - from[axis])])
            .collect()
    };
    let balanced: Vec<_> = pairs.iter().map(|&nodes| pair(nodes)).collect();
    let single = force(&sector, POINTS[0].0, POINTS[0].1, 0.0);
    let loads = [balanced.clone(), vec![single]].concat();
    let mass = sector.mass();
    let free = Support::Free { mass: &mass, motions: &motions };
    let free = condense(&equations, &free, None, &loads, &balanced, &Interrupt::never()).unwrap();
    let bore = sector.mesh.nodes_on(sector.mesh.face_set("bore").unwrap());
    // Statically determinate support at three nodes.
    let [a, b, c] = [bore[0], bore[bore.len() - 1], bore[bore.len() / 2]];
    let mut statically = Constraints::new();
    for dof in [3 * a, 3 * a + 1, 3 * a + 2, 3 * b + 1, 3 * b + 2, 3 * c] {
        statically.prescribe(dof, 0.0);
    }
    let solver = Solver::new(&equations.stiffness, statically).unwrap();
    for (column, load) in balanced.iter().enumerate() {
        let displacement = solver.solve_one(&load.to_full(sector.dof_count())).unwrap();
        let scale = free.own[(column, column)];
        for (row, form) in balanced.iter().enumerate() {
            let direct = form.dot(&displacement);
            assert!((free.own[(row, column)] - direct).abs() < 1e-9 * scale);
            assert!((free.rows_own[(row, column)] - direct).abs() < 1e-9 * scale);
        }
    }
    // Inertia balances a load that is not in equilibrium.
    let last = loads.len() - 1;
    assert!(free.own[(last, last)] > 0.0);
    assert_eq!(free.own[(0, last)].to_bits(), free.own[(last, 0)].to_bits());
}
