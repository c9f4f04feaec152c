//! Dynamic analysis of the chapter 5 pair: cost of a time step for a mesh with at least four times
//! the unknowns, and duration of 10,000 steps. The former is a ratio of the fastest of alternating
//! chunks of steps, and comparable between machines.

#[path = "../tests/common/mod.rs"]
mod common;

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::observables::TransmissionError;
use calyx_runtime::plan::Plan;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{Fidelity, Scene, StructureOptions};
use common::pair::{COARSE, MESH, PairOptions, RELIEVED, pair};
use std::time::Instant;

const STEPS: usize = 10_000;
/// Number of steps timed together; one row is stored per chunk.
const CHUNK: usize = 100;

fn main() {
    // With rigid bodies on elastic teeth, and with modes.
    println!(
        "{:>12} {:>10} {:>8} {:>18} {:>20} {:>22}",
        "modes to", "modes", "cells", "step, us", "with more unknowns", "10,000 steps, s"
    );
    for highest in [0.0, 60e3] {
        for half_cells in [8, 24] {
            measure(highest, half_cells);
        }
    }
}

fn measure(highest_frequency: f64, half_cells: usize) {
    let (mut scene, mesh) = pair(&PairOptions { speed: 300.0, ..PairOptions::chapter_5(&RELIEVED) });
    scene.pairs[0].grid.half_cells = Some(half_cells);
    scene.pairs[0].grid.width = Some(8e-4);
    scene.observables.clear();
    let outputs =
        [OutputRequest::observing("transmission_error", scene.add_observable(TransmissionError(MESH)))];
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange { keep: CHUNK, ..TimeRange::steady(5.0 * mesh.period, STEPS) }],
        scheme: Scheme::AVERAGE,
        rayleigh: [2000.0, 0.0],
        start: Start::Equilibrium,
    };
    let meshes = [COARSE, StructureOptions { refinement: 2.0 * COARSE.refinement, order: 3, ..COARSE }];
    let unknowns = meshes.map(|structure| unknowns(&scene, structure));
    let options = meshes.map(|structure| AnalysisOptions {
        structure,
        highest_frequency,
        ..AnalysisOptions::default()
    });
    let [mut coarse, mut fine] = options
        .each_ref()
        .map(|options| History::new(&scene, &outputs, options, &dynamics, &mut ()).expect("it can begin"));
    let modes = coarse.modal_coordinates();
    let (mut fastest, mut whole) = ([f64::INFINITY; 2], [0.0; 2]);
    for chunk in 0..=STEPS / CHUNK {
        for (history, (fastest, whole)) in
            [&mut coarse, &mut fine].into_iter().zip(fastest.iter_mut().zip(&mut whole))
        {
            let begun = Instant::now();
            history.next().expect("a row").expect("it goes on");
            let took = begun.elapsed().as_secs_f64();
            // The first row is the start.
            if chunk > 0 {
                *fastest = fastest.min(took / CHUNK as f64);
                *whole += took;
            }
        }
    }
    let [one, other] = fastest;
    let ratio = format!("{:.3} ({:.1} x)", other / one, unknowns[1] as f64 / unknowns[0] as f64);
    println!(
        "{:>9} Hz {modes:>10} {:>8} {:>18.1} {ratio:>20} {:>22.2}",
        highest_frequency,
        2 * half_cells + 1,
        1e6 * one,
        whole[0]
    );
}

/// Number of unknowns of both gears.
fn unknowns(scene: &Scene, structure: StructureOptions) -> usize {
    let plan = Plan::new(scene, Fidelity::Plane, structure).expect("it can be planned");
    let sizes = RELIEVED.iter().zip(&plan.bodies).filter_map(|(member, body)| {
        calyx_runtime::scene::Prototype::size(member.prototype.as_ref(), Fidelity::Plane, &body.options)
    });
    sizes.map(|size| size.body_dofs()).sum()
}
