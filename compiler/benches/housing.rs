//! Computing times of `examples/housing.cx`: `cargo bench -p calyx --bench housing`. They cover
//! positions with the elastic housing, with bearings on ground, and with bearings on ground whose
//! axial stiffness gives the gears the same axial displacement, as ratios to the last.

use calyx::{Engine, Module};
use std::path::Path;
use std::time::Instant;

/// Numbers of positions of two analyses; their difference excludes everything else.
const STEPS: [u32; 2] = [8, 40];
/// Repetitions of an analysis, of which the fastest counts.
const RUNS: usize = 3;
/// Axial stiffness of the bearings in the example, and one with the compliance of the walls.
const AXIAL: [&str; 2] = ["var axial_stiffness = 2e8 N/m;", "var axial_stiffness = 3.1e7 N/m;"];

/// Returns the time of an analysis, s.
fn time(module: &Module, elastic: bool, steps: u32) -> f64 {
    let begun = Instant::now();
    let mut instance = module.instantiate();
    instance.set("elastic_housing", elastic).expect("a param");
    instance.set("steps", f64::from(steps)).expect("in range");
    instance.solve().expect("an equilibrium");
    begun.elapsed().as_secs_f64()
}

/// Returns the time of a position, s, with cached matrices.
fn position(module: &Module, elastic: bool) -> f64 {
    let [few, many] =
        STEPS.map(|steps| (0..RUNS).map(|_| time(module, elastic, steps)).fold(f64::INFINITY, f64::min));
    (many - few) / f64::from(STEPS[1] - STEPS[0])
}

fn main() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples");
    let text = std::fs::read_to_string(folder.join("housing.cx")).expect("the example");
    let text = text.replace("fidelity = fidelity);", "fidelity = fidelity, error_estimates = \"none\");");
    let own = tempfile::tempdir().expect("a folder");
    std::fs::copy(folder.join("housing.bdf"), own.path().join("housing.bdf")).expect("the housing");
    let engine = Engine::default();
    let module = |name: &str, text: &str| {
        let path = own.path().join(name);
        std::fs::write(&path, text).expect("a file");
        Module::from_file(&engine, &path).expect("the example compiles")
    };
    assert!(text.contains(AXIAL[0]), "the bearings of the example");
    let (stiff, soft) = (module("housing.cx", &text), module("soft.cx", &text.replace(AXIAL[0], AXIAL[1])));
    let row = |what: &str, time: f64, ratio: f64, of: &str| {
        println!("{what:<52} {:>10.2} ms {ratio:>6.2} of {of}", 1e3 * time);
    };
    let reference = position(&soft, false);
    let ground = "bearings as soft as the housing";
    row("position with bearings as soft as the housing", reference, 1.0, ground);
    for (what, module, elastic) in [
        ("position with the housing", &stiff, true),
        ("position with the bearings of the example", &stiff, false),
    ] {
        let time = position(module, elastic);
        row(what, time, time / reference, ground);
    }
}
