//! Tests of runs by `calyx run` and by executables: kill and resume, embedded tables, help,
//! messages. The messages that only `calyx run` prints are in `cli/`.
#![cfg(unix)]

use super::results;
use serde_json::Value;
use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

fn example() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx")
}

/// Builds an executable of a model in the same directory.
fn build(model: &Path) -> PathBuf {
    let executable = model.with_extension("");
    let built = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .arg("build")
        .args([model, "-o".as_ref(), &executable])
        .output();
    let built = built.expect("calyx starts");
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    executable
}

/// Returns the example with a plane model of its bodies: 3-D models behave equally in these tests
/// and take longer.
fn in_section() -> String {
    let text = fs::read_to_string(example()).expect("the example is there");
    assert!(text.contains("param fidelity = \"medium\""));
    text.replace("param fidelity = \"medium\"", "param fidelity = \"plane\"")
}

fn pair() -> &'static (tempfile::TempDir, PathBuf) {
    static PAIR: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    PAIR.get_or_init(|| {
        let directory = tempfile::tempdir().expect("a directory");
        let model = directory.path().join("pair.cx");
        fs::write(&model, in_section()).expect("writable");
        let executable = build(&model);
        (directory, executable)
    })
}

/// Program that runs the spur pair.
#[derive(Clone, Copy, Debug)]
enum Way {
    CalyxRun,
    Executable,
}

impl Way {
    fn command(self, directory: &Path, arguments: &[&str]) -> Command {
        let (folder, executable) = pair();
        let mut command = match self {
            Way::CalyxRun => Command::new(env!("CARGO_BIN_EXE_calyx")),
            Way::Executable => Command::new(executable),
        };
        if let Way::CalyxRun = self {
            command.arg("run").arg(folder.path().join("pair.cx"));
        } else {
            command.env_clear();
        }
        // All runs need the same structures, and a run with cached structures writes the same
        // bytes.
        let cache = folder.path().join("cache");
        command.args(["--out", "results"]).args(arguments).env("CALYX_CACHE", cache).current_dir(directory);
        command
    }
}

/// Runs a program in a directory; returns exit status, standard output, standard error.
fn said(command: &mut Command) -> (Option<i32>, String, String) {
    let Output { status, stdout, stderr } = command.output().expect("it starts");
    let [out, err] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    (status.code(), out, err)
}

/// Starts a run and kills it when it reports a number of solved positions; 0 is during the building
/// of structures.
fn kill_after(command: &mut Command, positions: u64) {
    end_after(command, positions, "-KILL");
}

/// Starts a run and sends it a signal when it reports a number of solved positions. Without cached
/// structures, the run takes long enough to be ended.
fn end_after(command: &mut Command, positions: u64, signal: &str) {
    command.args(["--progress", "json"]).env("CALYX_CACHE", "off").stderr(Stdio::piped());
    let mut run = command.spawn().expect("it starts");
    let mut lines = BufReader::new(run.stderr.take().expect("piped")).lines();
    let reached = lines.any(|line| {
        let progress: Value = serde_json::from_str(&line.expect("text")).unwrap_or_default();
        progress["done"] == positions
    });
    assert!(reached, "it ended before {positions} positions");
    let sent = Command::new("kill").args([signal, &run.id().to_string()]).status();
    assert!(sent.expect("`kill` is there").success());
    // Discards further output, so that the process does not block on it.
    lines.for_each(drop);
    run.wait().expect("it ends");
}

/// Returns the final files of the run in a directory.
fn results(directory: &Path) -> BTreeMap<String, String> {
    results::results(&directory.join("results"))
}

const SET: [&str; 5] = ["--quiet", "--set", "steps=5", "--fields", "--vtu"];

/// Creates a command that runs the 3-D example.
fn three_dimensional(directory: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
    command.arg("run").arg(example()).args(["--out", "results", "--cache", "kept", "--quiet"]);
    command.args(arguments).current_dir(directory);
    command
}

/// A 3-D analysis checks its memory limit first; if rejected, it reports the required memory and a
/// remedy, and leaves no files.
#[test]
fn a_solid_model_that_does_not_fit_into_memory_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    let arguments = ["--set", "fidelity=finest", "--memory-limit", "400MB"];
    let (status, _, err) = said(&mut three_dimensional(directory.path(), &arguments));
    assert_eq!(status, Some(1), "{err}");
    let (_, message) = err.split_once("[E0707] Error: the analysis needs ").expect(&err);
    let (needs, rest) =
        message.split_once(" MB for its next step, and its memory limit leaves ").expect(&err);
    let (leaves, rest) = rest.split_once(" MB").expect(&err);
    let [needs, leaves] = [needs, leaves].map(|number| number.parse::<u32>().expect("a number"));
    assert!(needs > leaves && leaves < 400, "{needs} {leaves}");
    assert!(rest.contains("take a coarser fidelity, fewer elements along the face"), "{err}");
    for folder in ["results", "kept"] {
        let there = fs::read_dir(directory.path().join(folder)).map_or(0, Iterator::count);
        assert_eq!(there, 0, "files in {folder}");
    }
}

/// A resumed run that exceeds its memory limit keeps the solved positions for a later run with a
/// higher limit.
#[test]
fn a_refused_run_of_a_solid_model_resumes_with_more_memory() {
    let small = ["--set", "steps=2", "--set", "face_elements=1", "--set", "displacement_order=1"];
    let [whole, ended] = [(), ()].map(|()| tempfile::tempdir().unwrap());
    let (status, _, err) = said(&mut three_dimensional(whole.path(), &small));
    assert_eq!(status, Some(0), "{err}");
    kill_after(&mut three_dimensional(ended.path(), &[&small[..], &["--threads", "1"]].concat()), 1);
    let of_run = |name: &str| fs::read_to_string(ended.path().join("results").join(name)).expect("text");
    let solved = ["journal.jsonl", "steps.csv"].map(of_run);
    let again = |limit: &str| {
        let arguments = [&small[..], &["--resume", "--memory-limit", limit]].concat();
        said(&mut three_dimensional(ended.path(), &arguments))
    };
    let (status, _, err) = again("20MB");
    assert_eq!(status, Some(1), "{err}");
    assert!(
        err.contains("[E0707] Error: the analysis takes ") && err.contains("its memory limit is 20 MB"),
        "{err}"
    );
    assert_eq!(["journal.jsonl", "steps.csv"].map(of_run), solved);
    let (status, _, err) = again("8GB");
    assert_eq!(status, Some(0), "{err}");
    assert_eq!(results(ended.path()), results(whole.path()));
}

#[test]
fn a_killed_run_goes_on_and_writes_the_same_bytes() {
    let whole = tempfile::tempdir().unwrap();
    let (status, _, err) = said(&mut Way::CalyxRun.command(whole.path(), &SET));
    assert_eq!(status, Some(0), "{err}");
    let expected = results(whole.path());
    let count = expected["steps.csv"].lines().count() as u64 - 1;
    assert!(count > 6, "{}", expected["steps.csv"]);
    // Run, steps and report, five tables, the former name of one of them, three VTU files per
    // position and their lists, two pictures of bodies and their list, the parts of the viewer, the
    // meshes of both gears and a file per position.
    assert_eq!(expected.len() as u64, 3 + 5 + 1 + 3 * count + 3 + 3 + 3 + count, "{:?}", expected.keys());
    let ends = |end: &str| expected.keys().filter(|name| name.ends_with(end)).count();
    assert_eq!([".png", ".surface", ".surface.part"].map(ends), [2, 0, 0], "{:?}", expected.keys());
    assert_eq!(expected["report.html"].matches("data:image/png").count(), 2);
    let moments = [(Way::CalyxRun, 0), (Way::CalyxRun, count / 2), (Way::Executable, count)];
    for (way, positions) in moments {
        let directory = tempfile::tempdir().unwrap();
        kill_after(&mut way.command(directory.path(), &SET), positions);
        let steps = directory.path().join("results/steps.csv");
        let solved = fs::read_to_string(&steps).map_or(0, |steps| steps.lines().count() as u64 - 1);
        assert!(solved >= positions, "{way:?} had written {solved} of {positions} positions");
        // Results are bitwise equal with any number of threads.
        let threads = if let Way::Executable = way { "1" } else { "2" };
        let again = [&SET[..], &["--resume", "--progress", "json", "--threads", threads]].concat();
        let (status, _, err) = said(&mut way.command(directory.path(), &again));
        assert_eq!(status, Some(0), "{way:?} after {positions}: {err}");
        // Solved positions are not solved again.
        let done =
            |line: &str| serde_json::from_str::<Value>(line).ok()?["done"].as_u64().filter(|&done| done > 0);
        let first = err.lines().find_map(done);
        assert!(first.unwrap_or(count + 1) > positions, "{way:?} after {positions} began at {first:?}");
        assert!(results(directory.path()) == expected, "{way:?} after {positions} positions");
    }
}

#[test]
fn a_run_killed_among_its_final_files_gets_them_all() {
    let [whole, ended] = [0; 2].map(|_| tempfile::tempdir().unwrap());
    let set = ["--quiet", "--set", "steps=2"];
    assert_eq!(said(&mut Way::CalyxRun.command(whole.path(), &set)).0, Some(0));
    kill_after(&mut Way::CalyxRun.command(ended.path(), &set), 3);
    let [from, to] = [&whole, &ended].map(|directory| directory.path().join("results/run.json"));
    fs::copy(from, to).unwrap();
    let (status, _, err) =
        said(&mut Way::CalyxRun.command(ended.path(), &[&set[..], &["--resume"]].concat()));
    assert_eq!(status, Some(0), "{err}");
    assert_eq!(results(ended.path()), results(whole.path()));
}

#[test]
fn a_journal_that_was_cut_off_is_gone_on_with() {
    let directory = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| {
        said(&mut Way::CalyxRun.command(directory.path(), &[&["--set", "steps=2"], arguments].concat()))
    };
    assert_eq!(run(&["--quiet"]).0, Some(0));
    let expected = results(directory.path());
    kill_after(&mut Way::CalyxRun.command(directory.path(), &["--quiet", "--set", "steps=2"]), 3);
    let journal = directory.path().join("results/journal.jsonl");
    let text = fs::read(&journal).unwrap();
    let ends: Vec<usize> = (1..=text.len()).filter(|&end| text[end - 1] == b'\n').collect();
    // Remaining length of the journal, and its number of complete positions.
    let cuts =
        [(ends[3], Some(3)), (ends[3] - 1, Some(2)), (ends[2] + 17, Some(2)), (ends[0], Some(0)), (40, None)];
    for (length, whole) in cuts {
        for name in ["run.json", "timing.json", "steps.csv"] {
            let _ = fs::remove_file(directory.path().join("results").join(name));
        }
        fs::write(&journal, &text[..length]).unwrap();
        let (status, _, err) = run(&["--resume"]);
        assert_eq!(status, Some(0), "{err}");
        let line = match whole {
            Some(count) => format!("resuming after {count} positions"),
            None => "contains nothing to resume".into(),
        };
        assert!(err.contains(&line), "{length} bytes: {err}");
        assert!(results(directory.path()) == expected, "{length} bytes");
    }
    // A run ended by Ctrl-C can be resumed too.
    end_after(&mut Way::CalyxRun.command(directory.path(), &["--quiet", "--set", "steps=2"]), 1, "-INT");
    assert_eq!(run(&["--resume", "--quiet"]).0, Some(0));
    assert!(results(directory.path()) == expected);
    // A new run over an interrupted one mentions that it could be resumed.
    kill_after(&mut Way::CalyxRun.command(directory.path(), &["--quiet", "--set", "steps=2"]), 3);
    let (status, _, err) = run(&[]);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("; --resume would continue after them"), "{err}");
    // With another model or other params the run cannot be resumed.
    fs::remove_file(directory.path().join("results/run.json")).unwrap();
    fs::write(&journal, &text).unwrap();
    let (status, _, err) =
        said(&mut Way::Executable.command(directory.path(), &["--resume", "--set", "steps=4"]));
    assert_eq!(status, Some(2), "{err}");
    assert!(err.contains("`steps` was 2 and is 4 now"), "{err}");
    assert!(fs::read(&journal).unwrap() == text, "a refused run leaves everything as it was");
}

/// Directory with a model, its executable, and an empty directory.
struct Standing {
    folder: tempfile::TempDir,
    executable: PathBuf,
}

impl Standing {
    fn of(model: &str, files: &[(&str, &str)]) -> Standing {
        let folder = tempfile::tempdir().expect("a directory");
        fs::create_dir(folder.path().join("elsewhere")).expect("a directory");
        for (name, text) in [("model.cx", model)].iter().chain(files) {
            fs::write(folder.path().join(name), text).expect("writable");
        }
        let executable = build(&folder.path().join("model.cx"));
        Standing { folder, executable }
    }

    fn run(&self, arguments: &[&str]) -> (Option<i32>, String, String) {
        let elsewhere = self.folder.path().join("elsewhere");
        let mut command = Command::new(&self.executable);
        said(command.args(arguments).env_clear().env("CALYX_CACHE", "off").current_dir(elsewhere))
    }
}

#[test]
fn tables_travel_with_an_executable() {
    let model = "param file = \"roll.csv\" in [\"roll.csv\", \"other.csv\"];\n\
                 var t = read_table(file);\nprint(column(t, \"depth\", 1 mm));\n";
    let standing =
        Standing::of(model, &[("roll.csv", "depth [mm]\n1\n2\n"), ("other.csv", "depth [mm]\n3\n")]);
    // Files that were embedded at compilation are not read again.
    fs::remove_file(standing.folder.path().join("roll.csv")).unwrap();
    let (status, out, err) = standing.run(&["--quiet"]);
    assert_eq!((status, &*out, &*err), (Some(0), "[0.001 m, 0.002 m]\n", ""));
    let run = fs::read_to_string(standing.folder.path().join("elsewhere/model.run/run.json")).unwrap();
    assert!(run.contains("\"name\": \"roll.csv\""), "{run}");
    // Tables for other params are not embedded, and are not read from the directory of the model.
    let other = ["--quiet", "--set", "file=other.csv"];
    let (status, _, err) = standing.run(&other);
    assert_eq!(status, Some(1), "{err}");
    for part in [
        "error[E0730]: `other.csv` cannot be read: it does not travel with the program, and there is no such file in this \
         directory",
        "model.cx:2:20",
        " 2 | var t = read_table(file);",
        "^^^^",
    ] {
        assert!(err.contains(part), "{part} is not in\n{err}");
    }
    // They are read from the current directory.
    let elsewhere = standing.folder.path().join("elsewhere");
    fs::write(elsewhere.join("other.csv"), "depth [mm]\n4\n").unwrap();
    assert_eq!(standing.run(&other).1, "[0.004 m]\n");
    // With `--tables`, files are read from that directory only.
    fs::create_dir(elsewhere.join("measured")).unwrap();
    fs::write(elsewhere.join("measured/roll.csv"), "depth [mm]\n5\n").unwrap();
    assert_eq!(standing.run(&["--quiet", "--tables", "measured"]).1, "[0.005 m]\n");
    let (status, _, err) = standing.run(&["--tables", "measured", "--set", "file=other.csv"]);
    assert!(status == Some(1) && err.contains("cannot be read: there is no such file in measured"), "{err}");
}

#[test]
fn an_executable_explains_itself() {
    let model = "/// Turns a thing.\n///\n/// At length: how it turns.\nunits mm_N_s;\n\
                 /// How wide.\n///\n/// Wider is stiffer.\nparam width = 3 mm in 1 mm .. 20 mm;\n\
                 param wide = TRUE;\n/// How it is made.\nparam kind = \"plane\" in [\"plane\", \"solid\"];\n\
                 print(width, wide, kind);\n";
    let standing = Standing::of(model, &[]);
    let version = format!("model (compiled by Calyx {}, engine ", env!("CARGO_PKG_VERSION"));
    // Arguments, exit status, and parts of the output, in this order.
    let table: [(&[&str], i32, &[&str]); 7] = [
        (
            &["-h"],
            0,
            &[
                "Turns a thing.\n",
                "Usage: model [OPTIONS]",
                "width",
                "3 mm",
                "1 .. 20",
                "How wide.",
                "wide",
                "TRUE",
                "kind",
                "\"plane\" or \"solid\"",
                "Params:",
                "--set <NAME=VALUE>",
                "--print-params",
                "Results:",
                "--resume",
                "Limits:",
                "--threads",
            ],
        ),
        (
            &["--help"],
            0,
            &["Turns a thing.", "At length: how it turns.", "Wider is stiffer.", "--tables <DIR>"],
        ),
        (&["--version"], 0, &[&version]),
        (&["--print-params"], 0, &["json-schema.org", "\"x-unit\": \"mm\""]),
        (&["--set", "width"], 2, &["'width' for '--set <NAME=VALUE>': there is no `=`"]),
        (
            &["--set", "width=1 s"],
            2,
            &["`width` cannot be `1 s`: that is a time, and its default is in mm, a length"],
        ),
        (&["--set", "width=30"], 2, &["`width` = 30 mm is outside its range, 1 mm .. 20 mm"]),
    ];
    for (arguments, status, parts) in table {
        let (ended, out, err) = standing.run(arguments);
        let shown = if status == 0 { out } else { err };
        assert_eq!(ended, Some(status), "{arguments:?}: {shown}");
        let mut rest = &shown[..];
        for part in parts {
            let at = rest.find(part).unwrap_or_else(|| panic!("{arguments:?} lacks `{part}`: {shown}"));
            rest = &rest[at + part.len()..];
        }
        let fits = |line: &str| line.chars().count() <= 100;
        assert!(!arguments[0].ends_with('h') || shown.lines().all(fits), "{shown}");
    }
    assert!(!standing.run(&["-h"]).1.contains("Wider is stiffer"));
    let (status, out, err) = standing.run(&["--json", "--params", "/dev/null/none.toml"]);
    assert!(status == Some(2) && out.is_empty() && err.contains("cannot read"), "{err}");
    let (status, out, err) = standing.run(&["--json", "--set", "width=4"]);
    let document: Value = serde_json::from_str(&out).expect("one document");
    assert_eq!((status, &document["params"]["width"]["display"]["value"]), (Some(0), &Value::from(4.0)));
    assert!(err.starts_with("4 mm TRUE plane\n") && err.contains("results are in model.run"), "{err}");
}

/// Diagnostics have the same locations as those of `calyx check`; a NaN error names the command
/// that finds its source.
#[test]
fn an_executable_places_what_it_says() {
    let spur_pair = in_section();
    let old = "output load_share := gears.load_share(mesh);";
    assert!(spur_pair.contains(old) && spur_pair.contains("free = [\"theta_z\"]"));
    let model = spur_pair
        .replace(old, "param offset = 0;\noutput load_share := log(gears.load_share(mesh) - offset);")
        .replace("var mesh =", "var idle = gears.body(\"idle\", gear_blank,\n    free = [\"theta_z\"],\n    frame := Translate(9 inch * e1));\nvar mesh =");
    let standing = Standing::of(&model, &[]);
    let (status, _, err) = standing.run(&["--set", "steps=2", "--set", "offset=2"]);
    assert_eq!(status, Some(1), "{err}");
    for part in [
        "error[E0721]: output `load_share` is not a number at Time =",
        "note: with these params, `calyx run ",
    ] {
        assert!(err.contains(part), "{part} is not in\n{err}");
    }
    let (status, _, err) = standing.run(&["--set", "steps=2", "--set", "offset=-1"]);
    assert_eq!(status, Some(0), "{err}");
    for part in [
        "warning[W0715]: nothing constrains body \"idle\"",
        "    free = [\"theta_z\"],",
        "           ^^^^^^^^^^^",
        "help: ",
    ] {
        assert!(err.contains(part), "{part} is not in\n{err}");
    }
}
