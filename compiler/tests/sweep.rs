//! Tests of `calyx sweep`: its rows are those of single runs to the last bit, for any number of
//! threads and after a kill.

use crate::support::pair;
use calyx::rt::Override;
use calyx::rt::ParamAssignment;
use calyx::rt::sweep::{Axis, Sweep};
use calyx::{Engine, EngineConfig, Module};
use calyx_runtime::estimate::Estimates;
use serde_json::Value;
use std::fs;
use std::path::Path;
use std::process::Command;

/// A pair whose torque, tip radius and fidelity vary.
fn model() -> String {
    pair("", "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 4), fidelity = \"analytic\");\n")
}

fn calyx(directory: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.args(arguments).env("CALYX_CACHE", "off").current_dir(directory);
    let output = command.output().expect("it starts");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[test]
fn rows_are_those_of_single_runs_at_any_number_of_threads_and_after_a_kill() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    fs::write(at.join("pair.cx"), model()).expect("written");
    let axes = ["sweep", "pair.cx", "--over", "torque=10..30:3", "--quiet"];
    let sweep = |threads: &str, out: &str| {
        let (status, told) = calyx(at, &[&axes[..], &["--threads", threads, "--out", out]].concat());
        assert_eq!(status, Some(0), "{told}");
        fs::read_to_string(at.join(out).join("sweep.csv")).expect("a table")
    };
    let whole = sweep("1", "one");
    assert_eq!(sweep("4", "four"), whole);

    // Killed after the first case, in the middle of the line of the second.
    let journal = at.join("one/cases.jsonl");
    let text = fs::read_to_string(&journal).expect("a journal");
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    assert_eq!(lines.len(), 4, "{text}");
    let cut = lines[..2].concat() + &lines[2][..lines[2].len() / 2];
    fs::write(&journal, cut).expect("written");
    fs::remove_file(at.join("one/sweep.csv")).expect("removed");
    assert_eq!(sweep("2", "one"), whole);
    let resumed = fs::read_to_string(&journal).expect("a journal");
    assert!(resumed.starts_with(&lines[..2].concat()) && resumed.lines().count() == 4, "{resumed}");

    // Each case is a line of the journal with the numbers of a single run.
    for (line, torque) in lines[1..].iter().zip(["10", "20", "30"]) {
        let line: Value = serde_json::from_str(line).expect("JSON");
        let set = format!("torque={torque}");
        let (status, told) = calyx(at, &["run", "pair.cx", "--set", &set, "--out", torque, "--quiet"]);
        assert_eq!(status, Some(0), "{told}");
        let run = fs::read_to_string(at.join(torque).join("run.json")).expect("a run");
        let run: Value = serde_json::from_str(&run).expect("JSON");
        let outputs = line["row"]["outputs"].as_object().expect("outputs");
        assert!(!outputs.is_empty());
        for (name, statistics) in outputs {
            for statistic in ["min", "mean", "max", "peak_to_peak"] {
                assert_eq!(statistics[statistic], run["outputs"][name][statistic], "{name} {statistic}");
            }
        }
    }
}

/// Runs of a sample: its rows are those of single runs with the text of the table as values, with a
/// fidelity level as an axis, and a sweep that was killed continues with the same files.
#[test]
fn samples_are_those_of_single_runs_at_any_number_of_threads_and_after_a_kill() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    fs::write(at.join("pair.cx"), model()).expect("written");
    let study = "[axes]\nfidelity = [\"rigid\", \"analytic\"]\n\n[tolerances]\ntorque = \"normal(20 N*m, 2 N*m)\"\n\n[sampling]\nsamples = 3\nseed = 4\n";
    fs::write(at.join("study.toml"), study).expect("written");
    let sweep = |threads: &str, out: &str| {
        let arguments = ["sweep", "pair.cx", "--study", "study.toml", "--quiet"];
        let (status, told) = calyx(at, &[&arguments[..], &["--threads", threads, "--out", out]].concat());
        assert_eq!(status, Some(0), "{told}");
        let names = ["sweep.csv", "sweep.html", "sample_statistics.csv", "explained_variation.csv"];
        names.map(|name| fs::read_to_string(at.join(out).join(name)).expect(name))
    };
    let whole = sweep("1", "one");
    assert_eq!(sweep("3", "three"), whole);
    let journal = at.join("one/cases.jsonl");
    let text = fs::read_to_string(&journal).expect("a journal");
    assert_eq!(text.lines().count(), 7, "{text}");
    fs::write(&journal, &text[..text.len() / 2]).expect("written");
    assert_eq!(sweep("2", "one"), whole);

    let rows = table(&at.join("one/sweep.csv"));
    assert_eq!(rows.len(), 6);
    for row in [&rows[0], &rows[5]] {
        let set = format!("torque={}", row["torque [N*m]"]);
        let run =
            ["run", "pair.cx", "--set", &set, "--fidelity", &row["fidelity"], "--out", "run", "--quiet"];
        let (status, told) = calyx(at, &run);
        assert_eq!(status, Some(0), "{told}");
        let run = fs::read_to_string(at.join("run/run.json")).expect("a run");
        let run: Value = serde_json::from_str(&run).expect("JSON");
        let line = text.lines().nth(row["case"].parse::<usize>().expect("a number")).expect("a line");
        let line: Value = serde_json::from_str(line).expect("JSON");
        let outputs = line["row"]["outputs"].as_object().expect("outputs");
        assert!(!outputs.is_empty());
        for (name, statistics) in outputs {
            for statistic in ["min", "mean", "max", "peak_to_peak"] {
                assert_eq!(statistics[statistic], run["outputs"][name][statistic], "{name} {statistic}");
            }
        }
    }
}

#[test]
fn failed_cases_and_those_of_changed_tables_are_solved_again() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let write = |name: &str, text: &str| fs::write(at.join(name), text).expect("written");
    write(
        "table.cx",
        "param file = \"one.csv\" in [\"one.csv\", \"two.csv\"];\noutput y := column(read_table(file), \"x\", 1)[0];\n",
    );
    write("one.csv", "x\n3\n");
    let sweep = || {
        let (status, told) = calyx(at, &["sweep", "table.cx", "--over", "file=*"]);
        let mut reader = csv::Reader::from_path(at.join("table.cx.sweep/sweep.csv")).expect("a table");
        let rows: Vec<csv::StringRecord> = reader.records().map(|row| row.expect("a row")).collect();
        let largest: Vec<String> = rows.iter().map(|row| row[4].to_owned()).collect();
        (status, largest, told)
    };
    let (status, largest, told) = sweep();
    assert_eq!((status, &largest[..]), (Some(1), &["3".to_owned(), String::new()][..]), "{told}");
    write("two.csv", "x\n7\n");
    let (status, largest, told) = sweep();
    assert_eq!((status, &largest[..]), (Some(0), &["3".to_owned(), "7".to_owned()][..]), "{told}");
    assert!(told.contains("1 case was solved before"), "{told}");
    write("two.csv", "x\n11\n");
    let (status, largest, told) = sweep();
    assert_eq!((status, &largest[..]), (Some(0), &["3".to_owned(), "11".to_owned()][..]), "{told}");
}

/// Cases that differ in loads and flanks share the structures of the two gears. Gears without
/// profile modifications have their own: theirs take half the time. The benchmark `sweep` has 1,000
/// cases.
#[test]
fn cases_that_differ_in_loads_and_flanks_share_structures() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    let module = Module::from_file(&Engine::default(), &path).unwrap_or_else(|error| panic!("{error}"));
    let axis = |text: &str| Axis::parse(text, module.description()).expect("an axis");
    let built = |reliefs: &str| {
        let folder = tempfile::tempdir().expect("a folder");
        let engine = Engine::new(EngineConfig { threads: 2, ..EngineConfig::default() });
        let sweep = Sweep {
            given: vec![ParamAssignment::text("fidelity", "plane"), ParamAssignment::text("steps", "2")],
            overrides: Override { error_estimates: Some(Estimates::None), ..Override::default() },
            axes: ["torque=500,1500", reliefs, "pinion_relief_start=25,28"].map(axis).to_vec(),
            engine: engine.clone(),
            workers: 2,
            ..Sweep::new(module.as_program(), folder.path().to_owned())
        };
        let outcome = sweep.run(|_, _| {}).expect("it is solved");
        assert_eq!((outcome.table.rows.len(), outcome.table.failures()), (8, 0));
        engine.kept().misses
    };
    assert_eq!(built("tip_relief=0.0005,0.001"), 2);
    assert_eq!(built("tip_relief=0,0.001"), 4);
}

/// Runs a tolerance study of the example at a cheap level, and returns value and interval of each
/// statistic; a bound is missing if the samples are too few for it.
fn tolerance_study(
    at: &Path,
    method: &str,
    (samples, seed): (usize, &str),
) -> Vec<(String, f64, [Option<f64>; 2])> {
    let (count, out) = (samples.to_string(), format!("{method}{samples}"));
    let tolerances = [
        "torque=normal(1000, 50)",
        "center_distance=normal(2.999..3.001)",
        "tooth_thickness=uniform(0.155..0.157)",
        "tip_relief=uniform(0.0003..0.0007)",
    ];
    let sampled = tolerances.iter().flat_map(|tolerance| ["--sample", tolerance]);
    let mut arguments =
        vec!["sweep", "spur_pair.cx", "--method", method, "--samples", &count, "--seed", seed];
    arguments.extend(["--out", &out, "--quiet", "--error-estimates", "none", "--set", "steps=2"]);
    arguments.extend(["--set", "fidelity=analytic", "--set", "tip_corner_contact=FALSE"]);
    arguments.extend(["--contact-cells", "3", "--contact-slices", "2"]);
    arguments.extend(sampled);
    let (status, told) = calyx(at, &arguments);
    assert_eq!(status, Some(0), "{told}");
    let number = |text: &str| (!text.is_empty()).then(|| text.parse::<f64>().expect("a number"));
    let rows = table(&at.join(out).join("sample_statistics.csv"));
    let statistic = |row: &std::collections::BTreeMap<String, String>| {
        let name = format!("{}.{} {}", row["output"], row["statistic"], row["quantity"]);
        let value = number(&row["value"]).expect("a value");
        (name, value, ["low", "high"].map(|bound| number(&row[bound])))
    };
    rows.iter().map(statistic).collect()
}

/// Statistics of a study agree with those of 20 times as many independent samples within their
/// intervals of 95 %: those of Latin hypercubes and Sobol points overlap with the intervals of the
/// larger study, and at least 95 % of the percentiles of the larger study are within them. Of
/// independent samples, whose errors are larger, most are.
#[test]
#[ignore = "long; part of .ci/full"]
fn intervals_of_studies_contain_the_results_of_larger_ones() {
    const SAMPLES: usize = 400;
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let example = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx");
    fs::copy(example, at.join("spur_pair.cx")).expect("copied");
    let large = tolerance_study(at, "random", (20 * SAMPLES, "8"));
    for method in ["latin_hypercube", "sobol", "random"] {
        let small = tolerance_study(at, method, (SAMPLES, "7"));
        assert_eq!(small.len(), large.len());
        let (mut counts, mut contained) = ([0; 2], [0; 2]);
        for ((name, own, [low, high]), (_, value, [least, most])) in small.iter().zip(&large) {
            // Values that do not vary differ by rounding.
            let rounding = 1e-9 * value.abs().max(own.abs());
            let above = |bound: &Option<f64>, value: f64| bound.is_none_or(|bound| value >= bound - rounding);
            let below = |bound: &Option<f64>, value: f64| bound.is_none_or(|bound| value <= bound + rounding);
            let kind = usize::from(name.contains("percentile"));
            counts[kind] += 1;
            if above(low, *value) && below(high, *value) {
                contained[kind] += 1;
            } else {
                println!("{method}: {name} {own} in {low:?} .. {high:?}, {value} in {least:?} .. {most:?}");
            }
            let overlap =
                above(low, most.unwrap_or(f64::INFINITY)) && below(high, least.unwrap_or(f64::NEG_INFINITY));
            assert!(overlap || kind == 0 || method == "random", "{method}: {name}");
        }
        println!("{method}: {contained:?} of {counts:?} moments and percentiles");
        let share = contained[1] as f64 / counts[1] as f64;
        // The percentiles of a sample depend on each other: if it has too few large values of a
        // param, it misses the percentile 99 of all outputs that follow this param.
        assert!(share >= if method == "random" { 0.85 } else { 0.95 }, "{method}: {share}");
    }
}

/// A pair on two ball bearings and springs, with outputs of some of the recorded loads.
fn on_bearings() -> String {
    let gears = "import gears;
units mm_N_s;
param torque = 20 N*m in 0 N*m .. 50 N*m;
param speed = 60 rpm in 0 rpm .. 6000 rpm;
print(\"torque\", torque);
var blank = gears.external(24, module = 2 mm, face_width = 10 mm, tooth_thickness = 3.1 mm);
var shaft = gears.shaft(
    \"shaft\",
    segments = [gears.shaft_segment(length = 80 mm, diameter = 30 mm)],
    material = \"steel\",
    frame := Translate(-40 mm * e3) * Rotate(speed * Time, e3));
gears.shaft_load(shaft, at = 0 mm, moment = torque * e3);
var pinion = gears.mount(\"pinion\", blank, on = shaft, at = 40 mm, hub_width = 10 mm);
function ball(in name, in at) {
    return gears.ball_bearing(
        name, shaft, at = at * e3, count = 8, ball_diameter = 8 mm, pitch_diameter = 45 mm);
}
var left = ball(\"left\", 10 mm);
var right = ball(\"right\", 70 mm);
var guide = gears.bearing(\"guide\", shaft, at = 5 mm * e3, radial_stiffness = 1e6 N/m, axial_stiffness = 1e6 N/m);
var gear = gears.body(\"gear\", blank, frame := Rotate(-speed * Time, e3) * Translate(48.05 mm * e1));
var mesh = gears.mesh(pinion, gear, tip_corner_contact = FALSE);
output radial_force := gears.bearing_force(left, \"radial\");
output moment := gears.bearing_moment(right, \"x\");
output transmission_error := gears.transmission_error(mesh);
output pressure := gears.max_contact_pressure(mesh);
output slope := gears.misalignment_slope(mesh);
output life := gears.bearing_life(left);
output loss := gears.friction_loss(mesh, 0.05);
output bearing_loss := gears.bearing_friction_loss(left, 20 mm^2/s);
";
    let analysis = "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 4), fidelity = \"analytic\", error_estimates = \"none\");\n";
    format!("{gears}{analysis}")
}

/// Rows of a CSV file by column.
fn table(path: &Path) -> Vec<std::collections::BTreeMap<String, String>> {
    let mut reader = csv::Reader::from_path(path).unwrap_or_else(|error| panic!("{path:?}: {error}"));
    reader.deserialize().map(|row| row.expect("a row")).collect()
}

#[test]
fn loads_of_components_are_those_of_outputs_and_a_duty_cycle_follows_from_them() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    fs::write(at.join("pair.cx"), on_bearings()).expect("written");
    let cases = "name,torque,speed,duration\nlow,10 N*m,3000 rpm,3\nhigh,40 N*m,1000 rpm,1\n";
    fs::write(at.join("cases.csv"), cases).expect("written");
    let (status, told) =
        calyx(at, &["sweep", "pair.cx", "--over", "torque=10,40", "--set", "speed=3000 rpm"]);
    assert_eq!(status, Some(0), "{told}");
    let directory = at.join("pair.cx.sweep");
    assert!(!directory.join("component_loads.csv").exists());
    let arguments =
        ["sweep", "pair.cx", "--cases", "cases.csv", "--damage-slope", "6.61", "--damage-slope", "2"];
    let (status, told) = calyx(at, &arguments);
    assert_eq!(status, Some(0), "{told}");
    // The first sweep has recorded no loads, so that its case is solved again.
    assert!(!told.contains("solved before"), "{told}");

    let number = |text: &str| text.parse::<f64>().unwrap_or_else(|_| panic!("`{text}`"));
    let close = |value: f64, expected: f64, what: &str| {
        assert!((value - expected).abs() <= 1e-12 * expected.abs(), "{what}: {value} is not {expected}");
    };
    let rows = table(&directory.join("sweep.csv"));
    let loads = table(&directory.join("component_loads.csv"));
    let load = |name: &str, quantity: &str, case: &str| {
        let row = loads.iter().find(|row| row["component"] == name && row["quantity"] == quantity);
        number(&row.unwrap_or_else(|| panic!("no {quantity} of {name}: {loads:?}"))[case])
    };
    for (row, case) in rows.iter().zip(["low", "high"]) {
        let output = |column: &str| number(&row[column]);
        close(load("left", "radial_force", case), output("radial_force.mean [N]"), "radial force");
        close(load("left", "radial_force_max", case), output("radial_force.max [N]"), "radial force");
        let mesh = "pinion / gear";
        close(load(mesh, "contact_pressure", case), output("pressure.max [MPa]"), "pressure");
        close(load(mesh, "friction_loss", case), output("loss.mean [W]"), "loss");
        close(load("left", "friction_loss", case), output("bearing_loss.mean [W]"), "loss of a bearing");
        let slope = load(mesh, "misalignment_slope", case);
        close(slope, output("slope.mean [urad]"), "slope");
        // The torque of the contact is that on the shaft.
        let torque = if case == "low" { 10.0 } else { 40.0 };
        assert!((load(mesh, "torque", case) / torque - 1.0).abs() < 1e-9);
        assert!(
            (load("right", "speed", case) / if case == "low" { 3000.0 } else { 1000.0 } - 1.0).abs() < 1e-9
        );
        assert!(
            (load(mesh, "transmission_error", case) > 0.0) && (load("guide", "radial_force", case) > 0.0)
        );
    }

    let values = table(&directory.join("duty_cycle.csv"));
    let value = |name: &str, quantity: &str, exponent: &str| {
        let is = |row: &&std::collections::BTreeMap<String, String>| {
            row["name"] == name && row["quantity"] == quantity && row["exponent"] == exponent
        };
        number(
            &values.iter().find(is).unwrap_or_else(|| panic!("no {quantity} of {name}: {values:?}"))["value"],
        )
    };
    // Three quarters of the time at 3000 rpm and one quarter at 1000 rpm: nine to one.
    let mean = |low: f64, high: f64, p: f64| ((9.0 * low.powf(p) + high.powf(p)) / 10.0).powf(1.0 / p);
    let (low, high) = (load("left", "equivalent_load", "low"), load("left", "equivalent_load", "high"));
    let tolerant =
        |value: f64, expected: f64| assert!((value / expected - 1.0).abs() < 1e-9, "{value} {expected}");
    tolerant(value("left", "equivalent_load", "3"), mean(low, high, 3.0));
    tolerant(value("pinion / gear", "equivalent_torque", "6.61"), mean(10.0, 40.0, 6.61));
    tolerant(value("pinion / gear", "equivalent_torque", "2"), mean(10.0, 40.0, 2.0));
    let hours = |case: &str, rpm: f64| load("left", "life", case) / (60.0 * rpm);
    let life = 1.0 / (0.75 / hours("low", 3000.0) + 0.25 / hours("high", 1000.0));
    tolerant(value("left", "life", ""), life);
    tolerant(value("left", "mean_speed", ""), 2500.0);
    // L = (C/P)^3 with one C. Both are means over the positions, of P and of 1/L.
    let [one, other] =
        [("low", low), ("high", high)].map(|(case, force)| force.powi(3) * load("left", "life", case));
    assert!((one / other - 1.0).abs() < 1e-6, "{one} {other}");
    let page = fs::read_to_string(directory.join("sweep.html")).expect("a page");
    assert!(page.contains("guide has springs instead of rolling elements"), "the page has no reason");
    assert!(page.contains("No life of right:"), "the page has no reason");
    let printed = fs::read_to_string(directory.join("printed.txt")).expect("printed text");
    assert!(printed.starts_with("# case 1 low\n") && printed.contains("\n# case 2 high\n"), "{printed}");

    // After a kill, or with all cases in the journal, the files have the same bytes.
    let names = ["sweep.csv", "component_loads.csv", "duty_cycle.csv", "printed.txt", "sweep.html"];
    let files = || names.map(|name| fs::read(directory.join(name)).expect(name));
    let whole = files();
    let journal = directory.join("cases.jsonl");
    let text = fs::read_to_string(&journal).expect("a journal");
    let cut = text.len() - 50;
    fs::write(&journal, &text[..cut]).expect("written");
    let (status, told) = calyx(at, &arguments);
    assert!(status == Some(0) && told.contains("1 case was solved before"), "{told}");
    assert!(files() == whole);
    // A journal of another format is replaced.
    fs::write(&journal, text.replace("\"journal\":2", "\"journal\":1")).expect("written");
    let (status, told) = calyx(at, &arguments);
    assert!(status == Some(0) && !told.contains("solved before"), "{told}");
    assert!(files() == whole);
    // A sweep without load cases has none of their files.
    let (status, told) = calyx(at, &["sweep", "pair.cx", "--over", "torque=10,40"]);
    assert_eq!(status, Some(0), "{told}");
    assert!(!directory.join("component_loads.csv").exists() && !directory.join("duty_cycle.csv").exists());
}
