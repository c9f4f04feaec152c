//! Tests of `calyx sweep`: its rows are those of single runs to the last bit, for any number of
//! threads and after a kill.

use crate::support::pair;
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
