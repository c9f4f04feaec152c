//! Computing times of whole transmissions: `cargo bench -p calyx --bench transmissions`. They cover
//! 11 positions of `rear_axle.cx` and `transfer_case.cx` at "medium", without and with structures
//! of an earlier run, in positions at "analytic", and the forced response of `countershaft.cx` at
//! 500 speeds.

use calyx::{Engine, Instance, Module};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// Number of positions.
const POSITIONS: f64 = 11.0;

/// Time of a run and of two of its stages, s.
struct Times {
    all: f64,
    structures: f64,
    positions: f64,
}

fn example(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(name)
}

/// Runs a model with some params.
fn time(module: &Module, set: impl Fn(&mut Instance) -> Result<(), calyx::Error>) -> Times {
    let begun = Instant::now();
    let mut instance = module.instantiate();
    set(&mut instance).expect("in range");
    let results = instance.solve().expect("it is solved");
    let all = begun.elapsed().as_secs_f64();
    let timing = results.timing().expect("an analysis");
    let stage = |name: &str| {
        timing.stages.iter().find(|(known, _)| *known == name).map_or(0.0, |(_, time)| time.as_secs_f64())
    };
    Times { all, structures: stage("structures"), positions: stage("positions") }
}

fn print(what: &str, Times { all, structures, positions }: &Times, more: &str) {
    println!("{what:<52} {all:>8.1} {structures:>12.1} {positions:>11.1}   {more}");
}

fn main() {
    println!("{:<52} {:>8} {:>12} {:>11}", "", "all, s", "structures", "positions");
    for name in ["rear_axle.cx", "transfer_case.cx"] {
        // A separate engine has no stored structures of other runs.
        let engine = Engine::default();
        let module = Module::from_file(&engine, example(name)).expect("the example compiles");
        let at = |fidelity: &'static str| {
            time(&module, |instance| {
                instance.set("fidelity", fidelity)?;
                instance.set("steps", POSITIONS)
            })
        };
        let analytic = at("analytic");
        print(&format!("{name}, 11 positions, analytic"), &analytic, "");
        for run in ["medium", "medium with its structures"] {
            let times = at(run.split(' ').next().unwrap_or(run));
            let ratio = format!("a position takes {:.1} of analytic", times.positions / analytic.positions);
            print(&format!("{name}, 11 positions, {run}"), &times, &ratio);
        }
    }
    let text = std::fs::read_to_string(example("countershaft.cx")).expect("the example");
    let folder = tempfile::tempdir().expect("a folder");
    let with_speeds = |count: usize| {
        let path = folder.path().join(format!("speeds_{count}.cx"));
        std::fs::write(&path, text.replace("speeds = 111", &format!("speeds = {count}"))).expect("a file");
        let module = Module::from_file(&Engine::default(), &path).expect("the example compiles");
        time(&module, |instance| instance.set("forced_response", true))
    };
    assert!(text.contains("speeds = 111"), "the speeds of the example");
    let [few, many] = [2, 500].map(with_speeds);
    print("countershaft.cx, forced response, 2 speeds", &few, "");
    let ratio = format!("{:.2} of 2 speeds", many.all / few.all);
    print("countershaft.cx, forced response, 500 speeds", &many, &ratio);
}
