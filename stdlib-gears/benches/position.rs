//! Cost of a position, of a structure, and of an analysis that only changes the torque. The cost of
//! a position does not depend on the mesh, so four times the unknowns must hardly change it.
//! Sectors of a ring are joined by doubling, so the cost of a structure grows with the logarithm of
//! the number of teeth. Ratios are comparable between machines, times are not.

#[path = "../tests/common/mod.rs"]
mod common;

use calyx_runtime::analysis::{AnalysisOptions, Steps, mesh_cycle};
use calyx_runtime::cache::OperatorCache;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::observables::Observe;
use calyx_runtime::resources::Resources;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{ObservableId, Prototype, StructureOptions};
use common::pair::{PLAIN, PairOptions, TORQUE, member, pair, system_of};
use common::standard_data;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

fn main() {
    println!("chapter 5 pair, {:>10} {:>16} {:>8}", "mesh", "ms per position", "ratio");
    let coarse = position(1.0);
    println!("{:>26} {:>16.3} {:>8.3}", "default", 1e3 * coarse, 1.0);
    let fine = position(2.0);
    println!("{:>26} {:>16.3} {:>8.3}", "4 times the unknowns", 1e3 * fine, fine / coarse);

    another_torque();

    println!("structure of a gear, {:>5} {:>16} {:>8}", "teeth", "ms", "ratio");
    let mut first = None;
    for teeth in [20, 64, 640] {
        let time = structure(teeth);
        let ratio = time / *first.get_or_insert(time);
        println!("{teeth:>26} {:>16.1} {ratio:>8.3}", 1e3 * time);
    }
}

/// Time shares of an analysis of the chapter 5 pair with all outputs, with cached structures from
/// an analysis at another torque.
fn another_torque() {
    let (mut scene, mesh) = pair(&PairOptions { edges: true, ..PairOptions::chapter_5(&PLAIN) });
    for (body, member) in scene.bodies.iter_mut().zip(PLAIN.iter()) {
        body.prototype = member.prototype.clone();
    }
    let positions = mesh_cycle(&mesh, 16);
    let observing = |index| OutputRequest::observing(format!("output {index}"), ObservableId(index));
    let outputs: Vec<_> = (0..scene.observables.len()).map(observing).collect();
    let cache = Arc::new(OperatorCache::new(1 << 30));
    let resources = Resources { cache: Some(cache), ..Resources::default() };
    let options = AnalysisOptions { resources, ..AnalysisOptions::default() };
    let whole = |torque: f64| {
        let mut scene = scene.clone();
        scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, torque]));
        let started = Instant::now();
        let steps = Steps::new(&scene, &positions, &outputs, &options).expect("structures");
        let before = started.elapsed().as_secs_f64();
        black_box(steps.finish().expect("equilibrium"));
        (before, started.elapsed().as_secs_f64())
    };
    let (_, first) = whole(TORQUE);
    let runs = (0..20).map(|run| whole(TORQUE * (1.0 - 0.01 * f64::from(run))));
    let (before, fastest) =
        runs.fold((0.0, f64::INFINITY), |best, run| if run.1 < best.1 { run } else { best });
    println!("an analysis of {:>11} {:>16} {:>8}", "positions", "ms", "ratio");
    println!("{:>26} {:>16.1} {:>8.3}", format!("{}, the first", positions.len()), 1e3 * first, 1.0);
    println!("{:>26} {:>16.1} {:>8.3}", "at another torque", 1e3 * fastest, fastest / first);
    println!("{:>26} {:>16.3} {:>8.3}", "before its positions", 1e3 * before, before / first);
}

/// Seconds per position of the chapter 5 pair including stresses: the fastest of several cycles.
fn position(refinement: f64) -> f64 {
    let (scene, mesh) = pair(&PairOptions { edges: true, ..PairOptions::chapter_5(&PLAIN) });
    let system = system_of(&scene, StructureOptions { refinement, ..StructureOptions::default() });
    let positions = mesh_cycle(&mesh, 16);
    let cycle = fastest(10, || {
        for position in &positions {
            let step = system.solve(position.time).expect("equilibrium");
            for observable in &scene.observables {
                black_box(system.value(&step, observable.as_ref()));
            }
        }
    });
    cycle / positions.len() as f64
}

/// Seconds to mesh and condense a gear.
fn structure(teeth: u32) -> f64 {
    let gear = member(standard_data(teeth, 0.0, 0.25), 0.01);
    // Bypasses the member's own build, which caches its result.
    fastest(3, || {
        black_box(
            gear.prototype.build(&StructureOptions::default(), &Interrupt::never()).expect("a structure"),
        );
    })
}

/// Seconds of the fastest of several runs, which is the least disturbed one.
fn fastest(runs: usize, mut run: impl FnMut()) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}
