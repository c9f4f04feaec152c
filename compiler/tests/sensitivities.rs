//! Derivatives of outputs with respect to params: agreement with high-precision differences of
//! separate runs, closed forms, kinks, and errors.

use calyx::rt::run_directory::{Kind as DirectoryKind, RunDirectory};
use calyx::rt::sensitivity_journal::{SENSITIVITY_JOURNAL, SensitivityJournal};
use calyx::rt::{Cancel, Results};
use calyx::{Engine, EngineConfig, Instance, Module};
use calyx_runtime::sensitivity::{Kind, Sensitivity};
use std::fs;
use std::path::Path;
use std::sync::Arc;
use tempfile::TempDir;

/// A pair of spur gears, with a load, a flank modification, a position of an axis and a property of
/// a structure as params.
const PAIR: &str = "import gears;
units mm_N_s;
param torque = 20.0 N*m in 0 N*m .. 50 N*m;
param relief = 6.0 um in 0 um .. 40 um;
param distance = 48.05 mm in 48.0 mm .. 48.2 mm;
param modulus = 206.5 GPa in 100 GPa .. 300 GPa;
param teeth = 24 in 12 .. 60;
var steel = gears.material(youngs_modulus = modulus, poissons_ratio = 0.3);
var relieved = gears.tip_relief(relief, start_roll_angle = 26 deg, shape = \"quadratic\");
var blank = gears.external(
    24, module = 2 mm, face_width = 10 mm, tooth_thickness = 3.1 mm, material = steel, modifications = [relieved]);
var pinion = gears.body(
    \"pinion\", blank, free = [\"theta_z\"], moment = torque * e3, frame := Rotate(60 rpm * Time, e3));
var gear = gears.body(\"gear\", blank, frame := Rotate(-60 rpm * Time, e3) * Translate(distance * e1));
var mesh = gears.mesh(pinion, gear, tip_corner_contact = FALSE);
output transmission_error := gears.transmission_error(mesh);
output pressure := gears.max_contact_pressure(mesh);
output root_stress := gears.max_root_stress(pinion);
output share := gears.load_share(mesh);
output doubled := 2 * torque;
analyze(
    \"quasi_static\", over = gears.mesh_cycle(mesh, 5), fidelity = \"plane\", error_estimates = \"none\");
";

/// A pair whose gears are both free and loaded, on torsion springs.
const SPRUNG: &str = "import gears;
units mm_N_s;
param first_moment = 20.0 N*m in 0 N*m .. 50 N*m;
param second_moment = 5.0 N*m in 0 N*m .. 50 N*m;
var blank = gears.external(24, module = 2 mm, face_width = 10 mm, tooth_thickness = 3.1 mm);
var first = gears.body(
    \"first\", blank, free = [\"theta_z\"], moment = first_moment * e3, frame := Rotate(60 rpm * Time, e3));
var second = gears.body(
    \"second\", blank, free = [\"theta_z\"], moment = second_moment * e3,
    frame := Rotate(-60 rpm * Time, e3) * Translate(48.05 mm * e1));
var first_spring = gears.bearing(\"first spring\", first, torsional_stiffness = 4e4 N*m/rad);
var second_spring = gears.bearing(\"second spring\", second, torsional_stiffness = 9e4 N*m/rad);
var mesh = gears.mesh(first, second, tip_corner_contact = FALSE);
output first_rotation := gears.rotation(first, \"z\");
output second_rotation := gears.rotation(second, \"z\");
analyze(
    \"quasi_static\", over = gears.mesh_cycle(mesh, 5), fidelity = \"analytic\", error_estimates = \"none\");
";

fn instance(text: &str) -> Instance {
    Module::from_text(&Engine::default(), "pair.cx", text).expect("it compiles").instantiate()
}

fn solved(text: &str, params: &[&str]) -> Results {
    let mut instance = instance(text);
    instance.request_sensitivities(params.iter().copied()).expect("they are decimal numbers");
    instance.solve().expect("it is solved")
}

fn of<'r>(results: &'r Results, param: &str) -> &'r Sensitivity {
    results.sensitivities().iter().find(|own| own.param.name == param).expect("it was requested")
}

/// Returns the outputs at all positions with another value of a param, SI.
fn outputs_at(instance: &mut Instance, param: &str, value: f64) -> Vec<Vec<f64>> {
    instance.set_si(param, value).expect("it is in range");
    let results = instance.solve().expect("it is solved");
    let rows = &results.analysis().expect("an analysis").rows;
    rows.iter().map(|row| row.outputs.iter().map(|output| output.value).collect()).collect()
}

/// Independent route: central differences of separate runs, which find the state of contact again.
#[test]
fn derivatives_agree_with_differences_of_separate_runs() {
    let params = ["torque", "relief", "distance"];
    let results = solved(PAIR, &params);
    let mut instance = instance(PAIR);
    for param in params {
        let own = of(&results, param);
        assert_eq!(own.kind, Kind::SameStructures, "{param}");
        // Values have noise of 1e-11, from the iterations for contact points.
        let step = 3e-4 * own.param.scale();
        let [below, above] = [-step, step].map(|by| outputs_at(&mut instance, param, own.param.value + by));
        instance.reset(param).unwrap();
        for output in 0..own.positions[0].len() {
            let name = &results.description().outputs[output].name;
            let largest =
                own.positions.iter().map(|row| row[output].value().abs()).fold(f64::MIN_POSITIVE, f64::max);
            for (position, row) in own.positions.iter().enumerate() {
                let found = row[output];
                let expected = (above[position][output] - below[position][output]) / (2.0 * step);
                let off = (found.value() - expected).abs() / largest;
                assert!(off < 1e-6, "{param}, {name}, {position}: {found:?}, not {expected}");
                // An output that does not depend on the param has rounding only.
                let is_small = found.error < 1e-6 * largest || found.value().abs() < found.error;
                assert!(is_small, "{param}, {name}, {position}: {found:?} of {largest:e}");
            }
        }
    }
}

/// Characteristic positions move with the distance of the axes, and with them the weights of a
/// mean.
#[test]
fn means_follow_the_positions() {
    let own = of(&solved(PAIR, &["distance"]), "distance").clone();
    let mut instance = instance(PAIR);
    let step = 1e-4 * own.param.scale();
    let [below, above] = [-step, step].map(|by| {
        instance.set_si("distance", own.param.value + by).expect("it is in range");
        let results = instance.solve().expect("it is solved");
        ["transmission_error", "pressure", "root_stress"]
            .map(|output| results.summary_si(output).unwrap().mean)
    });
    for output in 0..3 {
        let found = own.statistics[output].mean;
        let expected = (above[output] - below[output]) / (2.0 * step);
        assert!((found.value() / expected - 1.0).abs() < 1e-5, "{output}: {found:?}, not {expected}");
        let at_positions: f64 = own.positions.iter().map(|row| row[output].value()).sum();
        let plain = at_positions / own.positions.len() as f64;
        assert!((plain / expected - 1.0).abs() > 1e-3, "{output}: the weights matter");
    }
}

#[test]
fn a_param_of_a_structure_is_labelled_and_accurate() {
    let results = solved(PAIR, &["modulus"]);
    let own = of(&results, "modulus");
    assert_eq!(own.kind, Kind::ChangedStructures);
    let mut instance = instance(PAIR);
    let step = 1e-3 * own.param.value;
    let [below, above] = [-step, step].map(|by| outputs_at(&mut instance, "modulus", own.param.value + by));
    for (position, row) in own.positions.iter().enumerate() {
        let expected = (above[position][0] - below[position][0]) / (2.0 * step);
        assert!((row[0].value() / expected - 1.0).abs() < 1e-5, "{:?}, not {expected}", row[0]);
    }
}

/// Pressures of flanks without modification are those of Hertz: with one tooth pair in contact they
/// grow with the square root of the load, on the scaled grid exactly.
#[test]
fn the_pressure_of_a_single_pair_follows_hertz() {
    let results = solved(PAIR, &["torque"]);
    let own = of(&results, "torque");
    let rows = &results.analysis().unwrap().rows;
    let mut singles = 0;
    for (row, derivatives) in rows.iter().zip(&own.positions) {
        let share = row.outputs[3].value;
        if share == 1.0 {
            singles += 1;
            let elasticity = derivatives[1].value() * own.param.value / row.outputs[1].value;
            assert!((elasticity - 0.5).abs() < 2e-3, "{elasticity}");
        }
    }
    assert!(singles >= 2, "{singles}");
}

/// Reciprocity (Betti): the rotation of one gear by a moment on the other is that of the other by a
/// moment on the one, also with contact that follows the load.
#[test]
fn derivatives_by_loads_are_reciprocal() {
    let results = solved(SPRUNG, &["first_moment", "second_moment"]);
    let [first, second] = ["first_moment", "second_moment"].map(|param| of(&results, param));
    assert_eq!(first.kind, Kind::SameStructures, "closed forms are not stored");
    for (by_first, by_second) in first.positions.iter().zip(&second.positions) {
        let [of_second, of_first] = [by_first[1].value(), by_second[0].value()];
        // Grids follow the load: derivatives contain those of the error of discretization.
        assert!((of_second / of_first - 1.0).abs() < 1e-3, "{of_second} {of_first}");
        assert!(by_first[0].value() > 0.0 && of_second < 0.0);
    }
}

#[test]
fn outputs_of_params_alone_have_exact_derivatives() {
    let results = solved(PAIR, &["torque"]);
    let own = of(&results, "torque");
    let doubled = own.statistics[4];
    assert!((doubled.max.value() - 2.0).abs() < 1e-9 && (doubled.mean.value() - 2.0).abs() < 1e-9);
    assert_eq!(doubled.peak_to_peak.value(), 0.0);
}

#[test]
fn derivatives_do_not_depend_on_the_number_of_threads() {
    let sensitivities = |threads| {
        let engine = Engine::new(EngineConfig { threads, ..EngineConfig::default() });
        let mut instance = Module::from_text(&engine, "pair.cx", PAIR).unwrap().instantiate();
        instance.request_sensitivities(["distance"]).unwrap();
        format!("{:?}", instance.solve().unwrap().sensitivities())
    };
    assert_eq!(sensitivities(1), sensitivities(3));
}

/// Returns an instance that stores derivatives in a directory, which it locks.
fn storing(directory: &Path, params: &[&str]) -> Instance {
    let mut instance = instance(PAIR);
    instance.request_sensitivities(params.iter().copied()).unwrap();
    let locked = RunDirectory::lock(directory, DirectoryKind::Sensitivities, false).unwrap();
    let journal = SensitivityJournal::of_instance(&instance, Arc::new(locked), &[]).unwrap();
    instance.store_sensitivities(Arc::new(journal));
    instance
}

#[test]
fn interrupted_derivatives_continue_to_the_same_bits() {
    let directory = TempDir::new().unwrap();
    let params = ["torque", "relief", "distance"];
    let mut interrupted = storing(directory.path(), &params);
    let cancel = Cancel::default();
    interrupted.set_cancel(cancel.clone());
    interrupted.on_progress(move |now| {
        if now.stage == "sensitivities" && now.done == 1 {
            cancel.cancel();
        }
    });
    assert!(interrupted.solve().is_err());
    drop(interrupted);
    let stored = || fs::read_to_string(directory.path().join(SENSITIVITY_JOURNAL)).unwrap();
    let first = stored();
    assert_eq!(first.lines().count(), 2, "a head and the torque");

    let shown = |results: &Results| format!("{:?}", results.sensitivities());
    let continued = storing(directory.path(), &params);
    let found = shown(&continued.solve().unwrap());
    drop(continued);
    assert_eq!(found, shown(&solved(PAIR, &params)));
    let all = stored();
    assert!(all.starts_with(&first) && all.lines().count() == 4, "{all}");
    let again = storing(directory.path(), &params);
    assert_eq!(shown(&again.solve().unwrap()), found);
    drop(again);
    assert_eq!(stored(), all, "nothing is computed again");

    // A line that lacks a position does not count.
    let mut lines: Vec<String> = all.lines().map(str::to_owned).collect();
    let mut line: serde_json::Value = serde_json::from_str(&lines[1]).unwrap();
    line["positions"].as_array_mut().unwrap().pop();
    lines[1] = line.to_string();
    fs::write(directory.path().join(SENSITIVITY_JOURNAL), lines.join("\n") + "\n").unwrap();
    let damaged = storing(directory.path(), &params);
    assert_eq!(shown(&damaged.solve().unwrap()), found);
    drop(damaged);

    let mut other = storing(directory.path(), &["torque"]);
    other.set("torque", "21 N*m").unwrap();
    assert_eq!(other.solve().unwrap().sensitivities()[0].param.value, 21.0);
}

#[test]
fn params_without_decimal_numbers_are_refused() {
    let mut instance = instance(PAIR);
    let message = |error: calyx::rt::Error| error.to_string();
    let refused = message(instance.request_sensitivities(["teeth"]).unwrap_err());
    assert!(refused.contains("`teeth` takes no decimal numbers"), "{refused}");
    let unknown = message(instance.request_sensitivities(["torqe"]).unwrap_err());
    assert!(unknown.contains("no param called `torqe`"), "{unknown}");
}

/// At the end of its range a param is varied to one side.
#[test]
fn the_end_of_a_range_has_one_side() {
    let text = PAIR.replace("relief = 6.0 um in 0 um", "relief = 6.0 um in 6.0 um");
    let results = solved(&text, &["relief"]);
    let whole = solved(PAIR, &["relief"]);
    for (row, expected) in of(&results, "relief").positions.iter().zip(&of(&whole, "relief").positions) {
        let off = (row[0].value() - expected[0].value()).abs();
        assert!(off <= row[0].error + expected[0].error, "{:?} {:?}", row[0], expected[0]);
    }
}

/// Requests of a model give the same derivatives as those of a program.
#[test]
fn a_model_requests_derivatives() {
    let requests = "gears.sensitivity(\"transmission_error\", \"torque\");
gears.sensitivity(\"pressure\", \"relief\");
analyze(";
    let text = PAIR.replace("analyze(", requests);
    let results = instance(&text).solve().expect("it is solved");
    let table = results.model_sensitivities().expect("the model requests derivatives");
    let shown: Vec<&str> = table.shown.iter().map(|&output| table.outputs[output].name.as_str()).collect();
    assert_eq!(shown, ["transmission_error", "pressure"]);
    let all = solved(PAIR, &["torque", "relief"]);
    for (own, other) in results.sensitivities().iter().zip(all.sensitivities()) {
        for (row, expected) in own.positions.iter().zip(&other.positions) {
            assert_eq!(row[..2], expected[..2], "{}", own.param.name);
            assert!(row[2].value().is_nan(), "an output that is not requested");
        }
    }
    assert!(all.model_sensitivities().is_none(), "the model requests none");
    // A request of the program replaces those of the model.
    let replaced = solved(&text, &["distance"]);
    assert_eq!(replaced.sensitivities().len(), 1);
    assert_eq!(replaced.sensitivities()[0].param.name, "distance");
}

/// A calculation has no analysis, but derivatives.
#[test]
fn a_calculation_requests_derivatives() {
    let text = "import gears;
units mm_N_s;
param torque = 120.5 N*m;
output squared := torque^2;
gears.sensitivity(\"squared\", \"torque\");
";
    let results = instance(text).solve().expect("it is calculated");
    let rows = results.model_sensitivities().expect("derivatives").rows();
    assert_eq!(rows.len(), 1);
    let derivative = rows[0].derivative.expect("smooth");
    // In N*mm, the unit of the model, by N*m.
    assert!((derivative / (2.0 * 120.5e3 * 1e3) - 1.0).abs() < 1e-9, "{:?}", rows[0]);
}

/// An output that nobody requests may have no value next to the value of a param.
#[test]
fn outputs_without_request_do_not_matter() {
    let text = "import gears;
param r = 0.5 in 0.1 .. 1.0;
output a := 3 * r;
output bad := sqrt(r - 0.5);
gears.sensitivity(\"a\", \"r\");
";
    let results = instance(text).solve().expect("it is calculated");
    let rows = results.model_sensitivities().expect("derivatives").rows();
    assert!((rows[0].derivative.expect("smooth") - 3.0).abs() < 1e-9, "{:?}", rows[0]);
}
