//! Compares contact grids with few and with many slices where a tip edge carries load and crosses
//! the slices obliquely: the transmission error of the pair of chapter 6 of the report, whose
//! contact starts at the tip of the pinion. Outermost cells of edges carry no load.

use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{Fidelity, Scene, StructureOptions};
use calyx_runtime::system::System;
use calyx_tests::scenes::scene_of;

/// Parts of a mesh cycle.
const POSITIONS: [f64; 4] = [0.05, 0.16, 0.32, 0.71];

/// Results at a position.
struct Solved {
    /// Rotation of the pinion, rad.
    rotation: f64,
    /// Force on edges, N.
    on_edges: f64,
    /// Force on the outermost cells of edges, N.
    outermost: f64,
}

fn solved(scene: &Scene) -> Vec<Solved> {
    let plan = Plan::new(scene, Fidelity::Analytic, StructureOptions::default()).expect("a plan");
    let system = System::with(scene, &plan, &Resources::default()).expect("a system");
    let mesh = scene.pairs[0].mesh.as_ref().expect("a mesh");
    let at = |part: f64| {
        let step = system.solve(mesh.start + part * mesh.period).expect("a solution");
        let mut solved = Solved { rotation: step.motion[0].abs(), on_edges: 0.0, outermost: 0.0 };
        for patch in &step.patches {
            let grid = patch.solid().expect("a solid patch");
            for slice in &grid.slices {
                let on_edge: Vec<usize> = slice.cells.clone().filter(|&cell| grid.cells[cell].edge).collect();
                solved.on_edges += on_edge.iter().map(|&cell| patch.forces[cell]).sum::<f64>();
                let ends = [slice.cells.start, slice.cells.end.saturating_sub(1)];
                let outermost = on_edge.iter().filter(|cell| ends.contains(cell));
                solved.outermost += outermost.map(|&cell| patch.forces[cell]).sum::<f64>();
            }
        }
        solved
    };
    POSITIONS.into_iter().map(at).collect()
}

/// Teeth deflect by as much as the radius of the edge. If a body yielded along the normals of the
/// rounding, its outermost cells would yield least, and carry load where the gap is largest.
#[test]
fn a_rounded_edge_carries_its_load_where_it_begins() {
    let heavily_loaded = [("torque", "1000 N*m"), ("tip_relief", "0 um")];
    for (pair, params) in [("spiral_bevel", &[][..]), ("helical_pair", &heavily_loaded)] {
        for (solved, part) in solved(&scene_of(pair, params)).into_iter().zip(POSITIONS) {
            let Solved { on_edges, outermost, .. } = solved;
            assert!(on_edges > 100.0 && outermost == 0.0, "{pair} at {part}: {on_edges} {outermost} N");
        }
    }
}

/// The force on edges converges more slowly than the rotation, since it is that of a few cells at
/// the end of the load: the usual grid misses up to 8 %.
#[test]
fn an_oblique_edge_carries_as_much_load_on_few_slices_as_on_many() {
    let mut scene = scene_of("spiral_bevel", &[]);
    let mut with_slices = |factor: usize| {
        scene.pairs.iter_mut().for_each(|pair| pair.grid.half_slices *= factor);
        solved(&scene)
    };
    let [usual, twice, four_times] = [1, 2, 2].map(&mut with_slices);
    for (index, part) in POSITIONS.into_iter().enumerate() {
        let fine = &four_times[index];
        let rotation = usual[index].rotation / fine.rotation - 1.0;
        let [usual_force, twice_force] = [&usual, &twice].map(|of| of[index].on_edges / fine.on_edges - 1.0);
        println!(
            "{part}: rotation {rotation:.4}, of {:.0} N on edges {usual_force:.3} {twice_force:.3}",
            fine.on_edges
        );
        assert!(rotation.abs() < 2e-3, "{part}: {rotation}");
        assert!(usual_force.abs() < 0.15, "{part}: {usual_force}");
        assert!(twice_force.abs() < 0.05, "{part}: {twice_force}");
    }
}
