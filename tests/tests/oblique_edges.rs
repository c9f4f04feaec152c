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

#[test]
fn an_oblique_edge_carries_as_much_load_on_few_slices_as_on_many() {
    let mut scene = scene_of("spiral_bevel", &[]);
    let usual = solved(&scene);
    for pair in &mut scene.pairs {
        pair.grid.half_slices *= 4;
    }
    for ((found, fine), part) in usual.iter().zip(solved(&scene)).zip(POSITIONS) {
        let [rotation, force] = [0, 1].map(|k| found[k] / fine[k] - 1.0);
        println!("{part}: rotation {rotation:.4}, force on edges {} N {force:.3}", fine[1]);
        assert!(rotation.abs() < 0.01, "{part}: {rotation}");
        assert!(force.abs() < 0.25, "{part}: {force}");
    }
}
