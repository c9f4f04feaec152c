//! Cost of the derivatives of all outputs with respect to a param, as a ratio to a plain run: a
//! load and a flank modification, which keep all structures. Differences of the same order by
//! separate runs take four runs per param: `cargo bench -p calyx --bench sensitivities`.

use calyx::{Engine, Module};
use std::time::Instant;

const MODEL: &str = "import gears;
units mm_N_s;
param torque = 20.0 N*m in 0 N*m .. 50 N*m;
param relief = 6.0 um in 0 um .. 40 um;
var relieved = gears.tip_relief(relief, start_roll_angle = 26 deg, shape = \"quadratic\");
var blank = gears.external(
    24, module = 2 mm, face_width = 10 mm, tooth_thickness = 3.1 mm, modifications = [relieved]);
var pinion = gears.body(
    \"pinion\", blank, free = [\"theta_z\"], moment = torque * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", blank, frame := Rotate(-60 rpm * Time, e3) * Translate(48.05 mm * e1));
var mesh = gears.mesh(pinion, gear, tip_corner_contact = FALSE);
output transmission_error := gears.transmission_error(mesh);
output pressure := gears.max_contact_pressure(mesh);
analyze(
    \"quasi_static\", over = gears.mesh_cycle(mesh, 32), fidelity = \"plane\", error_estimates = \"none\");
";

/// Number of repetitions, of which the fastest counts.
const REPETITIONS: usize = 5;

fn main() {
    let module = Module::from_text(&Engine::default(), "pair.cx", MODEL).expect("it compiles");
    let run = solved(&module, &[]);
    println!("{:<36} {:>10} {:>14}", "pair of spur gears, plane", "ms", "ratio to a run");
    println!("{:<36} {:>10.1} {:>14.2}", "run", 1e3 * run, 1.0);
    for (name, params) in [
        ("by the torque", vec!["torque"]),
        ("by the relief", vec!["relief"]),
        ("both", vec!["torque", "relief"]),
    ] {
        let more = solved(&module, &params) - run;
        println!("{:<36} {:>10.1} {:>14.2}", format!("derivatives {name}"), 1e3 * more, more / run);
    }
}

/// Returns the seconds of a run with all structures in the cache.
fn solved(module: &Module, params: &[&str]) -> f64 {
    let mut instance = module.instantiate();
    instance.request_sensitivities(params.iter().copied()).expect("they are decimal numbers");
    instance.solve().expect("it is solved");
    let time = |_| {
        let started = Instant::now();
        instance.solve().expect("it is solved");
        started.elapsed().as_secs_f64()
    };
    (0..REPETITIONS).map(time).fold(f64::INFINITY, f64::min)
}
