//! Cost of a case of a sweep whose cases differ in a load only: the time per case less that of the
//! analysis, and the speed-up of two threads. The model has gears of equal geometry in all cases,
//! and few positions, so that the overhead shows: `cargo bench -p calyx --bench sweep`.

use calyx::rt::sweep::{Axis, Sweep};
use calyx::{Engine, EngineConfig, Module};
use std::time::Instant;

/// Number of cases.
const CASES: usize = 1000;

const MODEL: &str = "import gears;
units mm_N_s;
param torque = 20 N*m in 0 N*m .. 50 N*m;
var blank = gears.external(24, module = 2 mm, face_width = 10 mm, tooth_thickness = 3.1 mm);
var pinion = gears.body(
    \"pinion\", blank, free = [\"theta_z\"], moment = torque * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", blank, frame := Rotate(-60 rpm * Time, e3) * Translate(48.05 mm * e1));
var mesh = gears.mesh(pinion, gear, tip_corner_contact = FALSE);
output transmission_error := gears.transmission_error(mesh);
analyze(
    \"quasi_static\", over = gears.mesh_cycle(mesh, 4), fidelity = \"rigid\", error_estimates = \"none\");
";

fn main() {
    let module = Module::from_text(&Engine::default(), "pair.cx", MODEL).expect("it compiles");
    let mut analysis = 0.0;
    let mut instance = module.instantiate();
    for case in 0..CASES {
        instance.set_si("torque", 10.0 + case as f64 / CASES as f64).expect("in range");
        let results = instance.solve().expect("it is solved");
        let timing = &results.analysis().expect("an analysis").timing;
        analysis += timing.stages.iter().map(|(_, time)| time.as_secs_f64()).sum::<f64>() / CASES as f64;
    }
    let [one, two] =
        [1, 2].map(|threads| (0..3).map(|_| sweep(&module, threads)).fold(f64::INFINITY, f64::min));
    println!("{:<44} {:>10} {:>10}", "case of a sweep that varies a load", "ms", "ratio");
    let row = |name: &str, time: f64| println!("{name:<44} {:>10.3} {:>10.2}", 1e3 * time, time / analysis);
    row("analysis", analysis);
    row("case, one thread", one);
    row("overhead", one - analysis);
    row("case, two threads", two);
    println!("speed-up of two threads: {:.2}", one / two);
}

/// Solves all cases in a new directory; returns seconds per case.
fn sweep(module: &Module, threads: usize) -> f64 {
    let directory = tempfile::tempdir().expect("a folder");
    let axis = Axis::parse(&format!("torque=10..30:{CASES}"), module.description()).expect("an axis");
    let sweep = Sweep {
        axes: vec![axis],
        engine: Engine::new(EngineConfig { threads, ..EngineConfig::default() }),
        workers: threads,
        ..Sweep::new(module.as_program(), directory.path().to_owned())
    };
    let started = Instant::now();
    let outcome = sweep.run(|_, _| {}).expect("it is solved");
    assert_eq!((outcome.table.rows.len(), outcome.table.failures()), (CASES, 0));
    started.elapsed().as_secs_f64() / CASES as f64
}
