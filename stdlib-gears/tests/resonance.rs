//! x
mod common;

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::observe::{MeshStiffness, Rotation};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{GearMesh, Scene};
use common::pair::{COARSE, FIRST, MESH, PLAIN, PairOptions, RELIEVED, TORQUE, pair, system};

fn scene(gears: &[common::pair::Member; 2], cells: usize) -> (Scene, GearMesh) {
    let (mut scene, mesh) = pair(&PairOptions { speed: 1.0, ..PairOptions::chapter_5(gears) });
    scene.pairs[0].grid.half_cells = Some(cells);
    scene.pairs[0].grid.width = Some(8e-4);
    scene.observables.clear();
    scene.bodies[FIRST.0] = scene.bodies[FIRST.0].clone().with_added(Inertia::axial(0.0, 2e-3, 0.0));
    scene.observe(Rotation(FIRST, 2));
    (scene, mesh)
}

#[test]
fn debug_tables() {
    for (name, gears) in [("PLAIN", &*PLAIN), ("RELIEVED", &*RELIEVED)] {
        let (scene, mesh) = scene(gears, 4);
        let system = system(&scene);
        println!(
            "TABLE {name} J {} rb {:?} start {} period {} T {TORQUE}",
            scene.bodies[0].inertia().polar(),
            mesh.base_radii,
            mesh.start,
            mesh.period
        );
        for k in 0..64 {
            let step = system.solve(mesh.period * k as f64 / 64.0).expect("equilibrium");
            println!(
                "ROW {name} {k} {:e} {:e}",
                system.value(&step, &Rotation(FIRST, 2)).value,
                system.value(&step, &MeshStiffness(MESH)).value
            );
        }
        for cells in [3, 8] {
            let (mut s, mesh) = self::scene(gears, cells);
            s.bodies[0].motion = std::sync::Arc::new(calyx_runtime::motion::SteadyRotation {
                origin: [0.0; 2],
                start: 0.0,
                speed: 300.0,
            });
            s.bodies[1].motion = std::sync::Arc::new(calyx_runtime::motion::SteadyRotation {
                origin: [3.0 * 0.0254, 0.0],
                start: 0.0,
                speed: -150.0,
            });
            let outputs = [OutputRequest::observing("t", calyx_runtime::scene::ObservableId(0))];
            let dynamics = DynamicOptions {
                from: 0.0,
                ranges: vec![TimeRange::steady(5.0 * mesh.period / 300.0, 400)],
                scheme: Scheme::AVERAGE,
                rayleigh: [1000.0, 0.0],
                highest_frequency: 0.0,
                start: Start::Equilibrium,
            };
            let options = AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() };
            let mut history = History::new(&s, &outputs, &options, &dynamics, &mut ()).expect("x");
            history.next();
            let begun = std::time::Instant::now();
            while let Some(row) = history.next() {
                row.expect("row");
            }
            println!("COST {name} {cells} {:.1} us a step", begun.elapsed().as_secs_f64() / 400.0 * 1e6);
        }
    }
}
