//! Compares contact grids with few and with many slices where a tip edge carries load and crosses
//! the slices obliquely: the transmission error of the pair of chapter 6 of the report, whose
//! contact starts at the tip of the pinion.

use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{Fidelity, Scene, StructureOptions};
use calyx_runtime::system::System;
use calyx_tests::scenes::scene_of;

/// Parts of a mesh cycle.
const POSITIONS: [f64; 4] = [0.05, 0.16, 0.32, 0.71];

/// Returns the rotation of the pinion, rad, and the force on edges, N, at every position.
fn solved(scene: &Scene) -> Vec<[f64; 2]> {
    let plan = Plan::new(scene, Fidelity::Analytic, StructureOptions::default()).expect("a plan");
    let system = System::with(scene, &plan, &Resources::default()).expect("a system");
    let mesh = scene.pairs[0].mesh.as_ref().expect("a mesh");
    let at = |part: f64| {
        let step = system.solve(mesh.start + part * mesh.period).expect("a solution");
        let on_edges = step.patches.iter().flat_map(|patch| {
            let cells = patch.solid().map(|grid| &grid.cells[..]).unwrap_or_default();
            cells.iter().zip(&patch.forces).filter(|(cell, _)| cell.edge).map(|(_, force)| *force)
        });
        [step.motion[0].abs(), on_edges.sum()]
    };
    POSITIONS.into_iter().map(at).collect()
}

/// The force on edges converges more slowly than the rotation, since it is that of a few cells at
/// the end of the load: the usual grid misses up to 37 %.
#[test]
fn an_oblique_edge_carries_as_much_load_on_few_slices_as_on_many() {
    let mut scene = scene_of("spiral_bevel", &[]);
    let mut with_slices = |factor: usize| {
        scene.pairs.iter_mut().for_each(|pair| pair.grid.half_slices *= factor);
        solved(&scene)
    };
    let [usual, twice, four_times] = [1, 2, 2].map(&mut with_slices);
    for index in 0..POSITIONS.len() {
        let part = POSITIONS[index];
        let [_, force] = four_times[index];
        let change = |of: &[[f64; 2]], k: usize| of[index][k] / four_times[index][k] - 1.0;
        let [rotation, usual_force, twice_force] = [change(&usual, 0), change(&usual, 1), change(&twice, 1)];
        println!(
            "{part}: rotation {rotation:.4}, of {force:.0} N on edges {usual_force:.3} {twice_force:.3}"
        );
        assert!(rotation.abs() < 0.01, "{part}: {rotation}");
        assert!(usual_force.abs() < 0.5, "{part}: {usual_force}");
        assert!(twice_force.abs() < 0.1, "{part}: {twice_force}");
    }
}
