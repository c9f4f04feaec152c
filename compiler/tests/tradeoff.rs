//! Tests of `calyx tradeoff` from the user's side: its output, reuse of finished runs, and
//! resumption after a kill.

use crate::support::pair;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

/// Returns a plane pair whose model requests a slow 3-D mesh.
fn model_text() -> String {
    pair("", "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 5), fidelity = \"finest\");\n")
}

/// Fidelity levels without meshes, which are solved quickly.
const GRIDS: [&str; 4] = ["--fidelities", "rigid,analytic", "--settings", "contact_cells,position_stride"];

fn tradeoff(directory: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.args(["tradeoff", "pair.cx"]).args(arguments);
    command.env("CALYX_CACHE", "off").current_dir(directory);
    command
}

fn said(mut command: Command) -> (Option<i32>, String, String) {
    let output = command.output().expect("it starts");
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (output.status.code(), out, err)
}

/// Returns the files of all runs, without their computing times.
fn runs(results: &Path) -> BTreeMap<String, String> {
    let mut all = BTreeMap::new();
    for run in fs::read_dir(results.join("runs")).expect("runs") {
        let run = run.unwrap().path();
        for file in fs::read_dir(&run).unwrap().map(|file| file.unwrap().path()) {
            let name = file.strip_prefix(results).unwrap().display().to_string();
            let differs = ["timing.json", "report.html", ".calyx-run"].iter().any(|end| name.ends_with(end));
            if file.is_file() && !differs {
                all.insert(name, fs::read_to_string(&file).expect("text"));
            }
        }
    }
    all
}

/// Returns the errors in the table, by setting and output.
fn errors(results: &Path) -> BTreeMap<(String, String), Vec<String>> {
    let mut reader = csv::Reader::from_path(results.join("tradeoff.csv")).expect("a table");
    let columns = reader.headers().unwrap().clone();
    let at = |name: &str| columns.iter().position(|column| column == name).expect(name);
    let (setting, output, error, last) = (at("setting"), at("output"), at("error"), at("peak_to_peak"));
    let row = |row: csv::StringRecord| {
        let parts = (error..=last).map(|column| row[column].to_owned()).collect();
        ((row[setting].to_owned(), row[output].to_owned()), parts)
    };
    reader.records().map(|record| row(record.unwrap())).collect()
}

#[test]
fn a_killed_comparison_goes_on_to_the_same_files() {
    let directory = tempfile::tempdir().unwrap();
    let directory = directory.path();
    fs::write(directory.join("pair.cx"), model_text()).unwrap();
    let (status, out, err) = said(tradeoff(directory, &[&GRIDS[..], &["--out", "whole"]].concat()));
    assert_eq!(status, Some(0), "{err}");
    for part in [
        "[1] transmission_error",
        "[2] max_contact_pressure",
        "analytic contact_cells=48",
        "all outputs within",
        "reference",
    ] {
        assert!(out.contains(part), "{part} in\n{out}");
    }
    let whole = directory.join("whole");
    let (table, expected) = (errors(&whole), runs(&whole));
    // The level, half and twice its cells, a half and a quarter of its positions, and the same for
    // rigid teeth, which have no cells; two outputs each.
    assert_eq!(table.len(), 16, "{table:?}");
    // Rigid teeth have no pressures.
    assert_eq!(table[&("rigid".to_owned(), "max_contact_pressure".to_owned())], vec![""; 6]);
    let document: Value =
        serde_json::from_str(&fs::read_to_string(whole.join("tradeoff.json")).unwrap()).unwrap();
    assert_eq!(document["reference"], "analytic contact_cells=48");
    let number = |setting: &str, output: &str| {
        table[&(setting.to_owned(), output.to_owned())][0].parse::<f64>().expect("a number")
    };
    // Errors of pressures grow with coarser grids.
    assert_eq!(number("analytic contact_cells=48", "transmission_error"), 0.0);
    let [fine, coarse] =
        ["analytic", "analytic contact_cells=12"].map(|setting| number(setting, "max_contact_pressure"));
    assert!(0.0 < fine && fine < coarse && coarse < 0.2, "{fine} {coarse}");
    assert!(
        number("analytic position_stride=4", "transmission_error") > number("analytic", "transmission_error")
    );
    assert!(fs::read_to_string(whole.join("tradeoff.svg")).unwrap().contains("max_contact_pressure"));
    assert!(!whole.join("structures").exists());

    // Killed in the middle and resumed.
    let (settings, out) = (5, directory.join("killed"));
    let going = [&GRIDS[..], &["--out", "killed", "--progress", "json"]].concat();
    let mut run = tradeoff(directory, &going).stderr(Stdio::piped()).stdout(Stdio::null()).spawn().unwrap();
    let mut lines = BufReader::new(run.stderr.take().expect("piped")).lines();
    let reached = lines.any(|line| {
        let progress: Value = serde_json::from_str(&line.expect("text")).unwrap_or_default();
        progress["done"] == settings
    });
    assert!(reached, "it ended before {settings} settings");
    run.kill().expect("it runs");
    run.wait().expect("it ends");
    assert!(!out.join("tradeoff.csv").exists());
    let first =
        fs::metadata(out.join("runs/analytic/run.json")).expect("the first is finished").modified().unwrap();
    let (status, _, err) = said(tradeoff(directory, &going));
    assert_eq!(status, Some(0), "{err}");
    assert_eq!(errors(&out), table);
    assert_eq!(runs(&out), expected);
    // Finished runs are reused.
    assert_eq!(fs::metadata(out.join("runs/analytic/run.json")).unwrap().modified().unwrap(), first);

    // Another torque requires another comparison.
    let (status, _, err) = said(tradeoff(
        directory,
        &["--fidelities", "analytic", "--settings", "none", "--out", "whole", "--set", "torque=40"],
    ));
    assert_eq!(status, Some(0), "{err}");
    let steps = |runs: &BTreeMap<String, String>| runs["runs/analytic/steps.csv"].clone();
    assert_ne!(steps(&runs(&whole)), steps(&expected));
}

#[test]
fn levels_that_a_model_cannot_be_analysed_at_are_listed_with_the_reason() {
    let directory = tempfile::tempdir().unwrap();
    let directory = directory.path();
    fs::write(directory.join("pair.cx"), model_text()).unwrap();
    let (status, out, err) = said(tradeoff(
        directory,
        &["--fidelities", "plane,medium", "--settings", "none", "--longest", "0.001ms"],
    ));
    assert_eq!((status, out.as_str()), (Some(1), ""), "{err}");
    assert!(err.contains("no setting can be run: ") && err.contains("--longest is 1 us"), "{err}");
    let (status, _, err) = said(tradeoff(directory, &["--fidelities", "plane", "--reference", "exact"]));
    assert_eq!(status, Some(1));
    assert!(err.contains("unknown setting `exact`; the settings of this model are plane, "), "{err}");
    let (status, _, err) = said(tradeoff(directory, &["--set", "torque=1000"]));
    assert_eq!(status, Some(2));
    assert!(err.contains("`torque` = 1000 N*m is outside its range"), "{err}");
}
