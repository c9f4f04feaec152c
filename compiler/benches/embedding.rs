//! Cost of embedding a model: an instance with its own params compared to compiling the model, and
//! a position from a run compared to one solved by the engine alone. The results are ratios within
//! one run; the times only show the order of magnitude: `cargo bench -p calyx --bench embedding`.

use calyx::rt::apply;
use calyx::{Engine, Instance, Module};
use calyx_abi::Context;
use calyx_gears::host::ModelHost;
use calyx_runtime::cache::OperatorCache;
use calyx_runtime::observables::Observe;
use calyx_runtime::plan::Plan;
use calyx_runtime::resources::Resources;
use calyx_runtime::results::StepRow;
use calyx_runtime::scene::{Fidelity, StructureOptions};
use calyx_runtime::system::System;
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

/// Positions of an analysis.
const STEPS: i32 = 64;

fn main() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    let engine = Engine::default();
    let compile = fastest(10, || {
        black_box(Module::from_file(&engine, &path).expect("the example compiles"));
    });
    let module = Module::from_file(&engine, &path).expect("the example compiles");
    let [torque, distance, relief] =
        ["torque", "center_distance", "tip_relief"].map(|name| module.param(name).expect("a param"));
    let set = fastest(1000, || {
        let mut instance = module.instantiate();
        instance.set(torque, 700.0).expect("in range");
        instance.set(distance, (76.3, "mm")).expect("in range");
        instance.set_si(relief, 1e-5).expect("in range");
        black_box(instance);
    });
    println!("{:<52} {:>10} {:>10}", "spur pair", "us", "ratio");
    row("check and compile", compile, compile);
    row("instantiate, set three params", set, compile);

    let mut instance = module.instantiate();
    instance.set("steps", STEPS).expect("in range");
    instance.set("fidelity", "plane").expect("in range");
    // Builds the structures; later runs use those stored in the engine.
    instance.solve().expect("the example is solved");
    let text = std::fs::read_to_string(&path).expect("the example");
    let direct = direct(&text);
    let mut times = [f64::INFINITY; 3];
    for _ in 0..10 {
        for (time, measured) in times.iter_mut().zip([direct(), stepping(&instance), solving(&instance)]) {
            *time = time.min(measured);
        }
    }
    println!("{:<52} {:>10} {:>10}", "a position of the spur pair", "us", "ratio");
    row("System::solve, values, row", times[0], times[0]);
    row("for step in instance.run()?", times[1], times[0]);
    row("instance.solve()?, a run's beginning included", times[2], times[0]);
}

/// Solves the same scene without an instance; returns seconds per position.
fn direct(text: &str) -> impl Fn() -> f64 {
    // Creates positions without solving them.
    let (model, _) = text.split_once("analyze(").expect("it ends with its analysis");
    let unsolved = format!("{model}var cycle = gears.mesh_cycle(mesh, steps);");
    let module = Module::from_text(&Engine::default(), "spur_pair.cx", &unsolved).expect("it compiles");
    let program = module.as_program();
    let mut context = Context::new(Box::new(ModelHost::new(module.description())));
    context.kernels = program.kernels();
    let steps =
        [calyx::ParamAssignment::value("steps", STEPS), calyx::ParamAssignment::text("fidelity", "plane")];
    apply(program.as_ref(), &steps, &mut context).expect("params");
    program.main(&mut context).expect("it runs");
    let host = std::mem::take(context.host::<ModelHost>().expect("its host"));
    let resources = Resources { cache: Some(Arc::new(OperatorCache::new(1 << 30))), ..Resources::default() };
    move || {
        let plan =
            Plan::new(&host.scene, Fidelity::Plane, StructureOptions::default()).expect("it can be planned");
        let system = System::with(&host.scene, &plan, &resources).expect("it can be built");
        let positions = &host.positions[0];
        let mut began = Instant::now();
        for (index, position) in positions.iter().enumerate() {
            let step = system.solve(position.time).expect("equilibrium");
            let observed: Vec<_> = host
                .scene
                .observables
                .iter()
                .map(|observable| system.value(&step, observable.as_ref()))
                .collect();
            black_box(StepRow::new(position.clone(), &host.outputs, &observed, step.warnings.clone()));
            if index == 0 {
                began = Instant::now();
            }
        }
        began.elapsed().as_secs_f64() / (positions.len() - 1) as f64
    }
}

/// Requests every position; returns seconds per position after the first.
fn stepping(instance: &Instance) -> f64 {
    let mut run = instance.run().expect("a run");
    let count = run.next().expect("a position").expect("solved").count();
    let began = Instant::now();
    run.by_ref().for_each(|step| {
        black_box(step.expect("solved"));
    });
    let time = began.elapsed().as_secs_f64() / (count - 1) as f64;
    run.finish().expect("solved");
    time
}

/// Solves all positions; returns seconds per position, including the preparation of the run.
fn solving(instance: &Instance) -> f64 {
    let began = Instant::now();
    let results = instance.solve().expect("solved");
    began.elapsed().as_secs_f64() / results.steps().len() as f64
}

fn row(name: &str, time: f64, whole: f64) {
    println!("{name:<52} {:>10.1} {:>10.4}", 1e6 * time, time / whole);
}

/// Returns the time of the fastest of several runs, s: the one least disturbed.
fn fastest(runs: usize, mut run: impl FnMut()) -> f64 {
    let time = |_| {
        let began = Instant::now();
        run();
        began.elapsed().as_secs_f64()
    };
    (0..runs).map(time).fold(f64::INFINITY, f64::min)
}
