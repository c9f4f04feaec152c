//! What a position costs, and a structure. A position touches no mesh, so four times the unknowns must hardly change it; a
//! ring is joined by doubling, so its cost grows like the logarithm of the number of teeth. Ratios travel between machines,
//! times do not.

#[path = "../tests/common/mod.rs"]
mod common;

use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::scene::{Prototype, StructureOptions};
use common::pair::{PLAIN, PairOptions, member, pair, system_of};
use common::standard_data;
use std::hint::black_box;
use std::time::Instant;

fn main() {
    println!("chapter 5 pair, {:>10} {:>16} {:>8}", "mesh", "ms per position", "ratio");
    let coarse = position(1.0);
    println!("{:>26} {:>16.3} {:>8.3}", "default", 1e3 * coarse, 1.0);
    let fine = position(2.0);
    println!("{:>26} {:>16.3} {:>8.3}", "4 times the unknowns", 1e3 * fine, fine / coarse);

    println!("structure of a gear, {:>5} {:>16} {:>8}", "teeth", "ms", "ratio");
    let mut first = None;
    for teeth in [20, 64, 640] {
        let time = structure(teeth);
        let ratio = time / *first.get_or_insert(time);
        println!("{teeth:>26} {:>16.1} {ratio:>8.3}", 1e3 * time);
    }
}

/// Seconds a position of the chapter 5 pair takes, stresses and all: the fastest of some cycles.
fn position(refinement: f64) -> f64 {
    let (scene, mesh) = pair(&PairOptions { edges: true, ..PairOptions::chapter_5(&PLAIN) });
    let system = system_of(&scene, StructureOptions { refinement, ..StructureOptions::default() });
    let positions = mesh_cycle(&mesh, 16);
    let cycle = fastest(10, || {
        for position in &positions {
            let step = system.solve(position.time).expect("equilibrium");
            for observable in &scene.observables {
                black_box(system.value(&step, *observable));
            }
        }
    });
    cycle / positions.len() as f64
}

/// Seconds to mesh and condense a gear.
fn structure(teeth: u32) -> f64 {
    let gear = member(standard_data(teeth, 0.0, 0.25), 0.01);
    // Not the member's own build, which keeps what it has built.
    fastest(3, || {
        black_box(
            gear.prototype.build(&StructureOptions::default(), &Interrupt::never()).expect("a structure"),
        );
    })
}

/// Seconds of the fastest of some runs: the one least disturbed.
fn fastest(runs: usize, mut run: impl FnMut()) -> f64 {
    (0..runs)
        .map(|_| {
            let start = Instant::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .fold(f64::INFINITY, f64::min)
}
