//! Tests of plans of sweeps: workers in any order, at the same time and after damage give the files
//! of a sweep on one machine, byte for byte, without the files of the model.

use crate::support::pair;
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::Field;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn command(directory: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.args(arguments).env("CALYX_CACHE", "off").current_dir(directory);
    command
}

/// Runs the command and returns its status and what it prints to standard error.
fn calyx(directory: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let Output { status, stderr, .. } = command(directory, arguments).output().expect("it starts");
    (status.code(), String::from_utf8_lossy(&stderr).into_owned())
}

/// Solves a sweep here, and by a plan in another directory that has no other files. Compares the
/// files of both.
fn compare(at: &Path, arguments: &[&str], indices: usize, status: i32, names: &[&str]) {
    let sweep = [&["sweep"], arguments, &["--quiet"]].concat();
    let here = calyx(at, &[&sweep[..], &["--out", "here"]].concat());
    assert_eq!(here.0, Some(status), "{}", here.1);
    let (code, told) = calyx(at, &[&sweep[..], &["--plan", "plan", "--cases-per-index", "3"]].concat());
    assert_eq!(code, Some(0), "{told}");
    let elsewhere = tempfile::tempdir().expect("a folder");
    fs::rename(at.join("plan"), elsewhere.path().join("plan")).expect("moved");
    let mut workers = Vec::new();
    for index in (1..=indices).rev() {
        // Two workers of the first index at the same time.
        for _ in 0..if index == 1 { 2 } else { 1 } {
            let index = index.to_string();
            let work = ["sweep", "--work", "plan", "--index", &index, "--threads", "1", "--quiet"];
            workers.push(command(elsewhere.path(), &work).spawn().expect("it starts"));
        }
    }
    for worker in &mut workers {
        let code = worker.wait().expect("it ends").code();
        assert!(code == Some(0) || code == Some(status), "{code:?}");
    }
    let (code, told) = calyx(elsewhere.path(), &["sweep", "--collect", "plan", "--quiet"]);
    assert_eq!((code, &told), (Some(status), &here.1));
    for name in [&["sweep.parquet"], names].concat() {
        let read = |path: &Path| fs::read(path.join(name)).expect(name);
        assert!(read(&elsewhere.path().join("plan")) == read(&at.join("here")), "{name} differs");
    }
    fs::remove_dir_all(at.join("here")).expect("removed");
}

#[test]
fn collected_files_are_those_of_a_sweep_on_one_machine() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let write = |name: &str, text: &str| fs::write(at.join(name), text).expect("written");
    let analysis =
        "analyze(\"quasi_static\", over = gears.mesh_cycle(mesh, 2), error_estimates = \"none\");\n";
    write("pair.cx", &pair("", analysis));
    let axes = ["pair.cx", "--over", "torque=10 N*m..30 N*m:3log", "--over", "fidelity=rigid,analytic"];
    compare(at, &axes, 2, 0, &["sweep.csv", "sweep.html"]);

    // Tables and modules that depend on the case, printed text, and a case that fails.
    write("scale.cx", "function twice(in x) { return 2 * x; }\n");
    write(
        "sum.cx",
        "import scale;
/// Torque.
param torque = 10 N*m in 0 N*m .. 100 N*m;
/// Speed.
param speed = 100 rpm in 0 rpm .. 1000 rpm;
param file = \"one.csv\" in [\"one.csv\", \"two.csv\"];
param offset = 0.5 in 0 .. 2;
if (torque > 70 N*m) throw(\"too much\");
print(\"torque\", torque, offset);
output power := torque * speed;
output y := scale.twice(column(read_table(file), \"x\", 1)[0]) * torque + offset * 1 N*m;
",
    );
    write("one.csv", "x\n3\n");
    write("two.csv", "x\n0.1\n");
    write(
        "cases.csv",
        "name,torque,speed,file,duration\na,10 N*m,300 rpm,one.csv,3 hour\nb,20 N*m,200 rpm,two.csv,1 hour\n\
         c,30 N*m,250 rpm,two.csv,40 min\nd,60 N*m,250 rpm,one.csv,0\n",
    );
    let cycle = ["sweep.csv", "sweep.html", "component_loads.csv", "duty_cycle.csv", "printed.txt"];
    let given = ["sum.cx", "--cases", "cases.csv", "--set", "offset=0.1", "--damage-slope", "5"];
    compare(at, &given, 2, 0, &cycle);
    let axes = ["sum.cx", "--over", "torque=10..80:4", "--over", "file=*", "--objective", "min y"];
    let two = [&axes[..], &["--objective", "max power.min"]].concat();
    compare(at, &two, 3, 1, &["sweep.csv", "sweep.html", "printed.txt"]);

    let study = "[axes]\nfile = [\"two.csv\", \"one.csv\"]\n[tolerances]\ntorque = \"normal(20 N*m, 2 N*m)\"\n\
                 speed = \"uniform(100..200)\"\n[sampling]\nsamples = 4\nseed = 4\nmethod = \"sobol\"\n";
    write("study.toml", study);
    let sample = ["sweep.csv", "sweep.html", "sample_statistics.csv", "explained_variation.csv"];
    compare(at, &["sum.cx", "--study", "study.toml"], 3, 0, &sample);
}

const MODEL: &str = "param width = 2 mm in 0 mm .. 20 mm;\noutput area := width * width;\n";

/// Plans five cases in indices of two.
fn planned(at: &Path) {
    fs::write(at.join("model.cx"), MODEL).expect("written");
    let plan = ["sweep", "model.cx", "--over", "width=1..5:5", "--plan", "plan", "--cases-per-index", "2"];
    let (status, told) = calyx(at, &[&plan[..], &["--quiet"]].concat());
    assert_eq!(status, Some(0), "{told}");
}

fn work(at: &Path, index: usize) -> (Option<i32>, String) {
    calyx(at, &["sweep", "--work", "plan", "--index", &index.to_string()])
}

#[test]
fn damaged_and_foreign_journals_lose_their_own_cases_only() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    planned(at);
    for index in 1..=3 {
        let (status, told) = work(at, index);
        assert_eq!(status, Some(0), "{told}");
    }
    let collect = || calyx(at, &["sweep", "--collect", "plan"]);
    assert_eq!(collect().0, Some(0));
    let table = || fs::read_to_string(at.join("plan/sweep.csv")).expect("a table");
    let whole = table();
    let journal = |name: &str| at.join("plan/results").join(name);
    let read = |name: &str| fs::read_to_string(journal(name)).expect(name);

    // A byte of the first case changes, the third case is cut off, and a journal has another plan.
    let text = read("0001.1.jsonl");
    assert!(text.contains("1e-6"), "{text}");
    fs::write(journal("0001.1.jsonl"), text.replacen("1e-6", "7e-6", 1)).expect("written");
    let text = read("0002.1.jsonl");
    fs::write(journal("0002.1.jsonl"), &text[..text.len() - 9]).expect("written");
    let text = read("0003.1.jsonl");
    fs::write(journal("0003.1.jsonl"), text.replacen("\"plan\":\"", "\"plan\":\"0", 1)).expect("written");
    let (status, told) = collect();
    assert_eq!(status, Some(1), "{told}");
    for expected in [
        "warning: line 2 of plan/results/0001.1.jsonl is damaged, and its case is ignored",
        "warning: plan/results/0003.1.jsonl is not a journal of this plan, and its cases are ignored",
        "error: 3 of 5 cases are missing: indices 1-3",
        "for each index, run `calyx sweep --work plan --index 1`, then collect again",
    ] {
        assert!(told.contains(expected), "{told}");
    }
    let (status, told) = work(at, 1);
    assert!(status == Some(0) && told.contains("index 1: 2 of 2 cases solved, 1 of them before"), "{told}");
    assert!(journal("0001.2.jsonl").exists());
    // A worker without work writes no file.
    assert_eq!(work(at, 1).0, Some(0));
    assert!(!journal("0001.3.jsonl").exists());
    for index in [2, 3] {
        assert_eq!(work(at, index).0, Some(0));
    }
    assert_eq!(collect().0, Some(0));
    assert_eq!(table(), whole);
}

#[test]
fn damaged_and_outdated_plans_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    planned(at);
    let changed = |name: &str, old: &str, new: &str, expected: &str| {
        let path = at.join("plan").join(name);
        let text = fs::read_to_string(&path).expect(name);
        assert!(text.contains(old), "{text}");
        fs::write(&path, text.replacen(old, new, 1)).expect("written");
        for arguments in [&["--work", "plan", "--index", "1"][..], &["--collect", "plan"]] {
            let (status, told) = calyx(at, &[&["sweep"], arguments].concat());
            assert!(status == Some(2) && told.contains(expected) && told.contains("  help: "), "{told}");
        }
        fs::write(&path, text).expect("written");
    };
    changed("plan.json", "\"cases\": 5", "\"cases\": 6", "plan/plan.json is damaged: it was changed");
    changed("plan.json", "\"indices\": 3", "\"indices\": 4", "the number of indices does not fit");
    changed("plan.json", "\"cases_per_index\": 2", "\"cases_per_index\": 0", "plan/plan.json is damaged");
    changed("plan.json", "\"cases\"", "\"case\"", "plan/plan.json is damaged: missing field `cases`");
    changed("plan.json", "}", "", "plan/plan.json is damaged");
    changed("plan.json", "\"format\": 1", "\"format\": 9", "has format 9 and was written by Calyx 0.1.0");
    changed("plan.json", "\"calyx\": \"", "\"calyx\": \"9", "was written by Calyx 90.1.0 (engine");
    changed("plan.json", "\"engine\": \"", "\"engine\": \"0", "was written by Calyx 0.1.0 (engine 0");
    changed("model.json", "mm", "cm", "plan/model.json is damaged: it was changed");
    changed("cases.json", "0.001", "0.002", "plan/cases.json is damaged: it was changed");
    fs::remove_file(at.join("plan/cases.json")).expect("removed");
    let (status, told) = work(at, 1);
    assert!(status == Some(2) && told.contains("cannot read plan/cases.json"), "{told}");
}

/// The Parquet file has the columns, values and units of the table.
#[test]
fn parquet_files_have_the_columns_of_the_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = folder.path();
    let model =
        "param width = 2 mm in 0 mm .. 20 mm;\nparam round = TRUE;\nparam kind = \"a\" in [\"a\", \"b\"];
if (width > 15 mm) throw(\"too wide\");\noutput area := width * width in mm^2;\n";
    fs::write(at.join("model.cx"), model).expect("written");
    fs::write(
        at.join("cases.csv"),
        "name,width,round,kind\none,1 mm,TRUE,a\ntwo,0.3 mm,FALSE,b\nthree,16 mm,TRUE,b\n",
    )
    .expect("written");
    let (status, told) = calyx(at, &["sweep", "model.cx", "--cases", "cases.csv", "--out", "out", "--quiet"]);
    assert_eq!(status, Some(1), "{told}");
    let file = fs::File::open(at.join("out/sweep.parquet")).expect("a file");
    let reader = SerializedFileReader::new(file).expect("Parquet");
    let metadata = reader.metadata().file_metadata().key_value_metadata().expect("metadata").clone();
    let units = metadata.iter().find(|entry| entry.key == "units").and_then(|entry| entry.value.clone());
    let units: serde_json::Value = serde_json::from_str(&units.expect("units")).expect("JSON");
    let statistics = ["min", "mean", "max", "peak_to_peak", "max_error"];
    assert_eq!(units["width"], "mm");
    assert!(statistics.iter().all(|statistic| units[format!("area.{statistic}")] == "mm^2"), "{units}");

    let mut table = csv::Reader::from_path(at.join("out/sweep.csv")).expect("a table");
    let headings: Vec<String> = table.headers().expect("headings").iter().map(str::to_owned).collect();
    let mut rows = reader.get_row_iter(None).expect("rows");
    for record in table.records() {
        let (record, row) = (record.expect("a row"), rows.next().expect("a row").expect("a row"));
        assert_eq!(row.len(), headings.len());
        for ((cell, heading), (name, field)) in record.iter().zip(&headings).zip(row.get_column_iter()) {
            assert_eq!(heading.split(" [").next(), Some(name.as_str()));
            match field {
                Field::Null => assert_eq!(cell, "", "{name}"),
                Field::Double(value) => assert_eq!(cell.parse::<f64>().ok(), Some(*value), "{name}"),
                Field::Long(value) => assert_eq!(cell, value.to_string(), "{name}"),
                Field::Bool(value) => assert_eq!(cell.to_lowercase(), value.to_string(), "{name}"),
                Field::Str(text) => assert_eq!(cell, text, "{name}"),
                other => panic!("{name}: {other}"),
            }
        }
        assert!(matches!(row.get_column_iter().nth(2), Some((_, Field::Double(_)))));
    }
    assert!(rows.next().is_none());
}
