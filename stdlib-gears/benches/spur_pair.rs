//! Time shares of an analysis of the chapter 5 pair in three dimensions from a cold start; shares
//! are comparable between machines. Arguments select templates: `cargo bench -p calyx-gears --bench
//! spur_pair -- medium finest`. It first prints the cost of levels without meshes relative to the
//! plane model, for the pair without crowns and with them (in three dimensions).

#[path = "../tests/common/mod.rs"]
mod common;
#[allow(dead_code, reason = "tests use the rest")]
#[path = "../tests/chapter_5_solid/pair.rs"]
mod pair;

use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::contact::active_set::solve_until;
use calyx_runtime::contact::solid::{Entries, PatchCells, Pose, Side, compliance, first_guess};
use calyx_runtime::fe::SolveError;
use calyx_runtime::fe::dissection::Dissection;
use calyx_runtime::fe::elimination::eliminate;
use calyx_runtime::fe::solid::SolidModel;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::observables::Observe;
use calyx_runtime::plan::Plan;
use calyx_runtime::scene::{Fidelity, Scene, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::structure::Chart;
use calyx_runtime::structure::solid::SolidStructure;
use calyx_runtime::system::System;
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

/// Uniform positions over the mesh cycle; the characteristic points are added.
const STEPS: usize = 7;

fn main() {
    let named: Vec<String> = std::env::args().skip(1).filter(|name| !name.starts_with("--")).collect();
    let named = if named.is_empty() { vec!["medium".to_owned()] } else { named };
    ladder();
    named.iter().for_each(|name| measure(name));
}

/// Ratio of the time of whole analyses from a cold start at the cheap levels to that of the plane
/// model.
fn ladder() {
    let whole = |crown: f64, fidelity: Fidelity| {
        let (scene, cycle, _) = pair::Pair { crown, ..pair::CHAPTER_5 }.scene();
        let plan = Plan::new(&scene, fidelity, StructureOptions::default()).expect("a plan");
        let mut system = None;
        let structures = timed(|| system = Some(System::new(&scene, &plan).expect("structures")));
        let Some(system) = system else { return [f64::NAN; 2] };
        let positions = timed(|| {
            for at in mesh_cycle(&cycle, STEPS) {
                let step = system.solve(at.time).expect("equilibrium");
                for observable in scene.observables.iter().filter(|o| o.needs() <= fidelity.supports()) {
                    black_box(system.value(&step, observable.as_ref()));
                }
            }
        });
        [structures, positions]
    };
    let plane: f64 = whole(0.0, Fidelity::Plane).iter().sum();
    println!("{:>44} {:>12} {:>12} {:>14}", "milliseconds", "structures", "positions", "over plane");
    for (crown, place) in [(0.0, "two-dimensional"), (pair::CHAPTER_5.crown, "three-dimensional")] {
        for fidelity in [Fidelity::Rigid, Fidelity::Analytic, Fidelity::Plane] {
            let [structures, positions] = whole(crown, fidelity);
            let name = format!(
                "{}, {}",
                fidelity.name(),
                if fidelity == Fidelity::Plane { "two-dimensional" } else { place }
            );
            let share = (structures + positions) / plane;
            println!("{name:>44} {:>12.3} {:>12.3} {share:>14.4}", 1e3 * structures, 1e3 * positions);
        }
    }
}

fn measure(template: &str) {
    let (mut scene, cycle, _) = pair::CHAPTER_5.scene();
    scene.pairs.iter_mut().for_each(|pair| pair.grid.edges = true);
    let fidelity = Fidelity::named(template).expect("a fidelity");
    let plan = Plan::new(&scene, fidelity, StructureOptions::default()).expect("a plan");
    let started = Instant::now();
    let system = System::new(&scene, &plan).expect("structures");
    let structures = started.elapsed().as_secs_f64();
    let positions = mesh_cycle(&cycle, STEPS);
    let mut steps: Vec<StepResult> = Vec::new();
    let solving = timed(|| {
        steps = positions.iter().map(|at| system.solve(at.time).expect("equilibrium")).collect();
    });
    let observing = timed(|| {
        for step in &steps {
            for observable in &scene.observables {
                black_box(system.value(step, observable.as_ref()));
            }
        }
    });
    let whole = structures + solving + observing;
    let line = |what: &str, time: f64| println!("{what:>44} {time:>9.3} {:>8.3}", time / whole);

    println!("{template}, {} positions {:>19} {:>8}", positions.len(), "seconds", "share");
    line("all", whole);
    line("structures of both gears, side by side", structures);
    bodies(&scene, &plan, &line);
    line("positions, one after the other", solving);
    last_rounds(&scene, &plan, &steps, &line);
    line("observables", observing);
    let cells = steps.iter().map(|step| step.problem.cells());
    let loaded = steps.iter().map(|step| step.active.len());
    println!("{:>44} {} to {}", "cells", cells.clone().min().unwrap_or(0), cells.max().unwrap_or(0));
    println!(
        "{:>44} {} to {}",
        "of them loaded",
        loaded.clone().min().unwrap_or(0),
        loaded.max().unwrap_or(0)
    );
}

/// Stages of the setup of both gears, one gear after the other.
fn bodies(scene: &Scene, plan: &Plan, line: &dyn Fn(&str, f64)) {
    let gears = scene.bodies.iter().zip(&plan.bodies);
    let (mut meshing, mut assembly, mut order, mut elimination, mut whole, mut restoring) =
        (0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
    let mut kept = 0;
    for (number, (body, planned)) in gears.enumerate() {
        let gear = pair::CHAPTER_5.gear(number);
        let mut mesh = None;
        meshing += timed(|| mesh = Some(gear.solid_mesh(&planned.options).expect("a mesh")));
        let Some(mesh) = mesh else { continue };
        let nodes = |name: &str| mesh.nodes_on(mesh.face_set(name).expect("a set of faces"));
        let bore = nodes("bore");
        let mut cuts = [nodes("cut_left"), nodes("cut_right")].concat();
        cuts.retain(|node| !bore.contains(node));
        let constrained: Vec<usize> = bore.iter().flat_map(|&node| 3 * node..3 * node + 3).collect();
        let places = mesh.nodes.clone();
        let model = SolidModel::new(mesh, gear.material);
        let mut stiffness = None;
        assembly += timed(|| stiffness = Some(model.stiffness()));
        let Some(stiffness) = stiffness else { continue };
        let mut dissection = None;
        order += timed(|| dissection = Some(Dissection::new(&stiffness, &places, &constrained, &cuts)));
        let Some(dissection) = dissection else { continue };
        elimination += timed(|| {
            black_box(eliminate::<SolveError>(&stiffness, &dissection, &[], &[], || Ok(())).expect("held"));
        });
        let mut structure = None;
        whole += timed(|| {
            structure =
                Some(body.prototype.build_solid(&planned.options, &Interrupt::never()).expect("a structure"));
        });
        let bytes = structure.and_then(|structure| structure.stored()).expect("tables");
        kept += bytes.len();
        restoring += timed(|| {
            black_box(body.prototype.restore_solid(&planned.options, &bytes).is_some());
        });
    }
    line("one after the other", whole);
    line("of it meshing", meshing);
    line("stiffness", assembly);
    line("an order of elimination, of the whole", order);
    line("elimination of the whole, without loads", elimination);
    line("both from their bytes instead", restoring);
    println!("{:>44} {:.1} MB", "bytes", 1e-6 * kept as f64);
}

/// Repeats the last round of each position, in which the grids have their final size.
fn last_rounds(scene: &Scene, plan: &Plan, steps: &[StepResult], line: &dyn Fn(&str, f64)) {
    let build = |(body, planned): (&calyx_runtime::scene::Body, &calyx_runtime::plan::BodyPlan)| {
        body.prototype.build_solid(&planned.options, &Interrupt::never()).expect("a structure")
    };
    let structures: Vec<Arc<dyn SolidStructure>> = scene.bodies.iter().zip(&plan.bodies).map(build).collect();
    let never = Interrupt::never();
    let (mut giving, mut solving) = (0.0, 0.0);
    for step in steps {
        let laid = step.patches.iter().filter_map(|patch| Some((patch, patch.solid()?)));
        let patches: Vec<PatchCells> = laid
            .map(|(patch, grid)| {
                let bodies = scene.pairs[patch.pair].bodies;
                let side = |side: usize| Side {
                    body: bodies[side].0,
                    structure: structures[bodies[side].0].as_ref(),
                    chart: Chart { tooth: patch.teeth[side], surface: patch.surfaces[side] },
                    // Side faces of spur gears do not move when the gears rotate.
                    pose: Pose::IDENTITY,
                };
                PatchCells {
                    sides: [side(0), side(1)],
                    frame: &grid.frame,
                    cells: &grid.cells,
                    beside_faces: grid.beside_faces,
                }
            })
            .collect();
        giving += timed(|| {
            black_box(compliance(&patches, Entries::All, &never).expect("nothing interrupts it"));
        });
        let grids: Vec<_> = step.patches.iter().filter_map(|patch| patch.solid()).collect();
        solving += timed(|| {
            let guess = first_guess(&step.problem, &grids, &never);
            black_box(solve_until(&step.problem, Some(&guess), &never).expect("a solution"));
        });
    }
    line("compliance, last rounds alone", giving);
    line("solution, last rounds alone", solving);
}

fn timed(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}
