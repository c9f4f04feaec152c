//! Tests of the `calyx` command from the user's side. The pages in `cli/` specify its messages;
//! this file tests its output files. A second run condenses nothing.

#[expect(dead_code, reason = "the tests of the readers use all of it")]
#[path = "../../runtime/acoustics/tests/op2_writer.rs"]
mod op2_writer;
pub mod pages;

use pages::hold;
use serde_json::Value;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

fn example() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples/spur_pair.cx")
}

/// Returns the example with a plane model of its bodies: 3-D models behave equally in these tests
/// and take longer.
fn in_section() -> String {
    let text = std::fs::read_to_string(example()).expect("the example is there");
    assert!(text.contains("param fidelity = \"medium\""));
    text.replace("param fidelity = \"medium\"", "param fidelity = \"plane\"")
}

/// Returns the plane example after replacing `old => new` for each line of `edits`.
fn edited(edits: &[&str]) -> String {
    let text = in_section();
    edits.iter().fold(text, |text, edit| {
        let edit = edit.replace("\\n", "\n");
        let (old, new) = edit.split_once(" => ").expect("`old => new`");
        assert!(text.contains(old), "the example has no `{old}`");
        text.replace(old, new)
    })
}

/// `calyx run MODEL.cx 2>&1 | head -1` neither panics nor ends the run.
#[test]
fn closed_pipes_do_not_end_a_command() {
    let directory = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(directory.path().join("m.cx"), "for (i in 0 .. 20000) print(i);\n").expect("a file");
    for arguments in [&["run", "m.cx"][..], &["explain"], &["dump", "m.cx", "--stage", "tree"]] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_calyx"))
            .args(arguments)
            .current_dir(directory.path())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command");
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().expect("the command ends").code(), Some(0), "{arguments:?}");
    }
}

fn calyx(directory: &Path, arguments: &[String]) -> Output {
    calyx_reads(directory, arguments, &[], "")
}

/// Runs the command with environment variables and a text on standard input.
fn calyx_reads(
    directory: &Path,
    arguments: &[String],
    variables: &[(String, String)],
    input: &str,
) -> Output {
    let mut child = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .current_dir(directory)
        .args(arguments)
        .env("CALYX_CACHE", "off")
        .envs(variables.iter().map(|(name, value)| (name, value)))
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("calyx starts");
    // A command that does not read closes its end of the pipe, which is not an error.
    let _ = child.stdin.take().expect("standard input").write_all(input.as_bytes());
    child.wait_with_output().expect("calyx ends")
}

#[test]
fn check_says_what_is_wrong() {
    hold(include_str!("cli/check.md"));
}

#[test]
fn typical_mistakes_are_named_with_place_and_remedy() {
    hold(include_str!("cli/mistakes.md"));
}

#[test]
fn wrong_usage_is_explained() {
    hold(include_str!("cli/usage.md"));
}

#[test]
fn runs_print_and_fail_as_they_should() {
    hold(include_str!("cli/run.md"));
}

#[test]
fn tables_and_own_units_are_read() {
    hold(include_str!("cli/tables.md"));
}

#[test]
fn elastic_bodies() {
    hold(include_str!("cli/elastic-bodies.md"));
}

#[test]
fn builds_say_what_they_lack() {
    hold(include_str!("cli/build.md"));
}

#[test]
fn instances_of_components() {
    hold(include_str!("cli/components.md"));
}

#[test]
fn params_come_from_files_and_options() {
    hold(include_str!("cli/params.md"));
}

#[test]
fn runs_go_on_with_their_own() {
    hold(include_str!("cli/resume.md"));
}

#[test]
fn sweeps_tabulate_their_cases() {
    hold(include_str!("cli/sweep.md"));
}

#[test]
fn optimizations_find_designs_within_constraints() {
    hold(include_str!("cli/optimize.md"));
}

#[test]
fn sensitivities_are_ranked_by_their_effect() {
    hold(include_str!("cli/sensitivities.md"));
}

#[test]
fn sound_of_universal_files() {
    hold(include_str!("cli/sound.md"));
}

#[test]
fn plans_of_sweeps_are_solved_by_workers() {
    hold(include_str!("cli/sweep-plan.md"));
}

#[test]
fn samples_and_study_files_vary_params() {
    hold(include_str!("cli/study.md"));
}

#[test]
fn options_change_the_analysis() {
    hold(include_str!("cli/overriding.md"));
}

#[test]
fn certain_fixes_are_applied() {
    hold(include_str!("cli/fix.md"));
}

#[test]
fn messages_are_json_where_wanted() {
    hold(include_str!("cli/json.md"));
}

#[test]
fn new_models_run() {
    hold(include_str!("cli/new.md"));
}

#[test]
fn codes_are_explained() {
    hold(include_str!("cli/explain.md"));
}

#[test]
fn expressions_are_evaluated() {
    hold(include_str!("cli/eval.md"));
}

#[test]
fn sessions_keep_their_state() {
    hold(include_str!("cli/repl.md"));
}

#[test]
fn every_stage_can_be_seen() {
    hold(include_str!("cli/dump.md"));
}

#[test]
fn formatting() {
    hold(include_str!("cli/fmt.md"));
}

#[test]
fn tests_are_run() {
    hold(include_str!("cli/test.md"));
}

#[test]
fn reference_pages_are_written() {
    hold(include_str!("cli/doc.md"));
}

#[test]
fn text_that_is_not_utf8_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("model.cx"), b"var x = \"\xff\";\n").unwrap();
    let output = calyx(directory.path(), &["check".into(), "model.cx".into()]);
    assert_eq!(output.status.code(), Some(1));
    let err = String::from_utf8_lossy(&output.stderr);
    assert!(err.contains("[E0100]") && err.contains("model.cx:1:10"), "{err}");
}

/// Inputs that are known to make compilers hang, overflow their stack or run out of memory.
#[test]
fn no_text_makes_check_hang_or_crash() {
    let doubling = |element: &str| {
        let functions = (0..24).map(|i| {
            format!(
                "function f{i}(in a) {{ return {}; }}\n",
                element.replace("f(a)", &format!("f{}(a)", i + 1))
            )
        });
        functions.collect::<String>() + "function f24(in a) { return a; }\nvar x = f0(1);\nprint(len([x]));\n"
    };
    let variables = (0..24).map(|i| format!("var x{} = [x{i}, [x{i}, TRUE]];\n", i + 1)).collect::<String>();
    let tokens =
        ["var", "x", "=", "1", ";", "(", ")", "{", "}", "[", "]", "function", "in", "+", "3 mm", ":="];
    // Knuth's multiplicative hash: a reproducible pseudo-random sequence.
    let pick = |i: u32| tokens[(i.wrapping_mul(2_654_435_761) >> 16) as usize % tokens.len()];
    // Exit status 0 with the warning that a limit of the check is reached, which a run does not
    // have; 1 with errors. A crash has no exit status; a panic has 101.
    for (name, status, text) in [
        ("arrays that double", 0, doubling("[f(a), f(a)]")),
        ("tuples that double", 1, doubling("[f(a), [f(a), \"\"]]")),
        ("variables that double", 1, format!("var x0 = 1;\n{variables}")),
        ("brackets", 1, format!("var x = {}1{};", "(".repeat(100_000), ")".repeat(100_000))),
        ("minus signs", 1, format!("var x = {}1;", "-".repeat(100_000))),
        ("blocks", 1, "{".repeat(100_000)),
        ("unknown names", 1, (0..20_000).map(|i| format!("var v{i} = w{i};\n")).collect()),
        ("random tokens", 1, (0..100_000).map(pick).collect::<Vec<_>>().join(" ")),
    ] {
        let directory = tempfile::tempdir().unwrap();
        std::fs::write(directory.path().join("model.cx"), text).unwrap();
        let output = calyx(directory.path(), &["check".into(), "model.cx".into()]);
        let err = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{name}: {:?}\n{err:.2000}", output.status);
        let shown = if status == 0 { "Warning: " } else { "Error: " };
        assert!(err.contains(shown), "{name}: {err:.2000}");
    }
}

fn json(path: PathBuf) -> Value {
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is not a number"))
}

/// Runs the example with few positions; returns run.json, standard error, and the directory.
fn run_example(arguments: &[&str]) -> (Value, String, tempfile::TempDir) {
    let directory = tempfile::tempdir().unwrap();
    std::fs::write(directory.path().join("pair.cx"), in_section()).unwrap();
    let mut all = vec!["run".to_owned(), "pair.cx".into(), "--set".into(), "steps=2".into()];
    all.extend(arguments.iter().map(|argument| (*argument).to_owned()));
    let output = calyx(directory.path(), &all);
    let err = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{err}");
    assert!(output.stdout.is_empty(), "the model prints nothing");
    (json(directory.path().join("pair.cx.run/run.json")), err, directory)
}

const OUTPUTS: [(&str, &str, &str); 8] = [
    ("transmission_error", "rad", "urad"),
    ("transmission_error_length", "m", "microinch"),
    ("load_share", "", ""),
    ("mesh_stiffness", "N/m", "lbf/inch"),
    ("max_contact_pressure", "Pa", "psi"),
    ("max_edge_pressure", "Pa", "psi"),
    ("max_root_stress_pinion", "Pa", "psi"),
    ("max_root_stress_gear", "Pa", "psi"),
];

#[test]
fn the_run_directory_of_the_example_is_complete() {
    let (run, err, directory) = run_example(&["--set", "tip_radius=0.5 mm", "--set", "torque=500"]);
    let directory = directory.path().join("pair.cx.run");

    let params: Vec<&String> = run["params"].as_object().unwrap().keys().collect();
    assert_eq!(
        params,
        [
            "torque",
            "center_distance",
            "tip_radius",
            "tooth_thickness",
            "tip_relief",
            "pinion_relief_start",
            "gear_relief_start",
            "lead_crown",
            "tip_corner_contact",
            "steps",
            "fidelity",
            "face_elements",
            "displacement_order"
        ]
    );
    assert_eq!(run["params"]["tip_radius"]["value"], 0.5e-3);
    // 1 lbf*inch = 4.4482216152605 N * 0.0254 m
    let torque = 500.0 * 4.4482216152605 * 0.0254;
    assert!((number(&run["params"]["torque"]["value"]) - torque).abs() < 1e-13 * torque);
    assert_eq!(run["params"]["torque"]["display"]["value"], 500.0);
    assert_eq!(run["params"]["torque"]["display"]["unit"], "lbf*inch");
    assert_eq!(run["params"]["tip_corner_contact"]["value"], true);
    assert_eq!(run["params"]["fidelity"]["value"], "plane");

    let outputs = run["outputs"].as_object().unwrap();
    assert_eq!(outputs.keys().collect::<Vec<_>>(), OUTPUTS.map(|output| output.0));
    let table = std::fs::read_to_string(directory.join("steps.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table.lines().map(|line| line.split(',').collect()).collect();
    // Both uniform positions, and the characteristic points; the start of active profile coincides
    // with the start of the cycle.
    let points: Vec<&str> = rows[1..].iter().map(|row| row[4]).collect();
    for point in ["SAP", "EAP", "LPSTC", "HPSTC"] {
        assert!(points.contains(&point), "{points:?}");
    }
    assert_eq!(run["positions"], rows.len() - 1);
    for (name, unit, shown) in OUTPUTS {
        let output = &outputs[name];
        assert_eq!(
            (output["unit"].as_str(), output["display"]["unit"].as_str()),
            (Some(unit), Some(shown)),
            "{name}"
        );
        assert_ne!(output["doc"], "", "{name}");
        let column = rows[0].iter().position(|header| *header == name).unwrap();
        let values: Vec<f64> = rows[1..].iter().map(|row| row[column].parse().unwrap()).collect();
        let (min, max) = (number(&output["min"]), number(&output["max"]));
        assert_eq!(min, values.iter().copied().fold(f64::INFINITY, f64::min), "{name}");
        assert_eq!(max, values.iter().copied().fold(f64::NEG_INFINITY, f64::max), "{name}");
        assert_eq!(number(&output["peak_to_peak"]), max - min, "{name}");
        assert!((min..=max).contains(&number(&output["mean"])), "{name}");
        let at = output["max_at"]["step"].as_u64().unwrap() as usize;
        assert_eq!(values[at], max, "{name}");
        let place = &output["max_at"]["location"];
        if name.contains("stress") || name == "max_contact_pressure" {
            let body = if name.ends_with("gear") { "gear" } else { "pinion" };
            assert_eq!(place["body"], body, "{name}");
            assert!(place["tooth"].is_u64() && number(&place["radius"]) > 0.02, "{name}: {place}");
        }
    }
    let pressure = &outputs["max_contact_pressure"];
    let psi = 4.4482216152605 / (0.0254 * 0.0254);
    let shown = number(&pressure["display"]["max"]) * psi;
    assert!((shown - number(&pressure["max"])).abs() < 1e-12 * shown);
    assert!(number(&pressure["max_at"]["location"]["roll_angle"]) > 0.0);

    for residual in ["complementarity", "penetration", "tension", "equilibrium"] {
        assert!(number(&run["certificate"][residual]) <= 1e-12, "{residual}");
    }
    assert_eq!(run["calyx"], env!("CARGO_PKG_VERSION"));
    let hash = run["source"]["sha256"].as_str().unwrap();
    assert!(hash.len() == 64 && hash.chars().all(|c| c.is_ascii_hexdigit()));
    assert_eq!(run["source"]["files"][0]["sha256"], hash);

    let timing = json(directory.join("timing.json"));
    let stages = timing["stages"].as_object().unwrap();
    for stage in ["check", "compile", "program", "plan", "structures", "positions"] {
        assert!(stages.contains_key(stage), "{stage}");
    }
    let sum: f64 = stages.values().map(number).sum();
    assert!((sum - number(&timing["total"])).abs() <= 1e-9 * sum);
    assert_eq!(timing["structures"], serde_json::json!({ "built": 2, "reused": 0 }));

    // The summary fits into a terminal; it uses the model's units.
    assert!(err.contains("max_contact_pressure       psi "), "{err}");
    assert!(err.lines().all(|line| line.chars().count() <= 128), "{err}");
    // An input that the plane model ignores is reported and recorded.
    assert_eq!(run["ignored_inputs"].as_object().unwrap().keys().collect::<Vec<_>>(), ["lead_crown"]);
    assert_eq!(err.matches("warning: `lead_crown` is not used as given").count(), 1);
}

#[test]
fn quiet_is_quiet_and_what_is_zero_is_not_ignored() {
    let (run, err, directory) = run_example(&["--set", "lead_crown=0", "--quiet"]);
    assert_eq!(err, "");
    assert_eq!(run["ignored_inputs"], serde_json::json!({}));
    // A run that fails before its first position leaves the results of an earlier one unchanged.
    let model = edited(&["[\"theta_z\"],\n    moment => [\"theta_z\", \"u_x\"],\n    moment"]);
    std::fs::write(directory.path().join("pair.cx"), model).unwrap();
    let arguments = ["run", "pair.cx", "--set", "steps=2"].map(str::to_owned);
    let before = std::fs::read(directory.path().join("pair.cx.run/run.json")).expect("results");
    let failed = calyx(directory.path(), &arguments);
    assert_eq!(failed.status.code(), Some(1));
    let err = String::from_utf8_lossy(&failed.stderr).into_owned();
    assert!(err.contains("those of an earlier run and were not changed"), "{err}");
    assert_eq!(std::fs::read(directory.path().join("pair.cx.run/run.json")).expect("results"), before);
}

/// A run reuses cached structures of an earlier one, unless the cache is disabled; results are
/// bitwise equal.
#[test]
fn a_second_run_condenses_nothing() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("pair.cx"), in_section()).expect("writable");
    let run = |out: &str, more: &[&str]| {
        let arguments = ["run", "pair.cx", "--quiet", "--set", "steps=2", "--out", out];
        let arguments: Vec<String> = arguments.iter().chain(more).map(|&word| word.to_owned()).collect();
        assert_eq!(calyx(folder.path(), &arguments).status.code(), Some(0));
        let timing = json(folder.path().join(out).join("timing.json"));
        let rows = std::fs::read_to_string(folder.path().join(out).join("steps.csv")).expect("rows");
        (timing["structures"].clone(), rows)
    };
    let (built, expected) = run("first", &["--cache", "kept"]);
    assert_eq!(built, serde_json::json!({ "built": 2, "reused": 0 }));
    assert_eq!(
        run("second", &["--cache", "kept"]),
        (serde_json::json!({ "built": 0, "reused": 2 }), expected.clone())
    );
    assert_eq!(run("third", &["--no-cache"]), (built.clone(), expected.clone()));
    assert_eq!(run("fourth", &["--cache", "off"]), (built, expected));
    assert!(!folder.path().join("off").exists());
}

/// OP2 files have the sound of the same motion in a punch file; alone they have no mesh, and
/// truncated ones an error with the place.
#[test]
fn sound_of_op2_files() {
    use op2_writer::{Form, Layout, Op2, Quantity, Written, by_frequency, punch};
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write =
        |name: &str, content: &[u8]| std::fs::write(folder.path().join(name), content).expect("written");
    let corner = |label: i64, axis: u32| f64::from(u8::from((label - 1) >> axis & 1 == 1));
    let mut deck = String::from("BEGIN BULK\n");
    for label in 1..=8 {
        let [x, y, z] = [0, 1, 2].map(|axis| 0.1 * corner(label, axis));
        deck += &format!("GRID,{label},,{x:.2},{y:.2},{z:.2}\n");
    }
    deck += "CHEXA,1,1,1,2,4,3,5,6\n,8,7\nENDDATA\n";
    let values = (1..=8).map(|label| (label, [0, 1, 2].map(|axis| [corner(label, axis), 0.0])));
    let written = Written {
        subcase: 1,
        mode: None,
        frequency: 500.0,
        quantity: Quantity::Velocity,
        form: Form::Polar,
        values: values.collect(),
    };
    let all = [written];
    let mut op2 = Op2::new(Layout { is_big_endian: true, ..Layout::LITTLE });
    op2.block("OUGV1", 0, &by_frequency(&all));
    op2.key(0);
    write("cube.bdf", deck.as_bytes());
    write("cube.op2", &op2.bytes);
    write("cut.op2", &op2.bytes[..1000]);
    write("cube.pch", punch(&all, false).as_bytes());
    let sound = |arguments: &[&str]| -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_calyx"));
        command.arg("sound").args(arguments).args(["--method", "rayleigh", "--force", "--out", "sound"]);
        command.current_dir(folder.path()).output().expect("the command ends")
    };
    let [of_op2, of_punch] =
        ["cube.op2", "cube.pch"].map(|results| sound(&["cube.bdf", "--results", results]));
    let said = String::from_utf8_lossy(&of_op2.stderr);
    assert_eq!(of_op2.status.code(), Some(0), "{said}");
    assert!(said.contains("skipped: values of scalar points"), "{said}");
    assert_eq!(of_op2.stdout, of_punch.stdout);
    assert!(String::from_utf8_lossy(&of_op2.stdout).contains("500"));
    for (arguments, part) in [
        (&["cube.op2"][..], "error[E0784]: cube.op2: the file has results of NASTRAN without their mesh"),
        (
            &["cube.bdf", "--results", "cut.op2"],
            "error[E0784]: cut.op2: table OUGV1, byte 1000: the file ends",
        ),
    ] {
        let output = sound(arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(1) && said.contains(part), "{said}");
    }
}

/// The first Ctrl-C ends the run like any other error of the model, and so does the signal of a
/// batch system.
#[cfg(unix)]
#[test]
fn an_interrupt_ends_the_run() {
    use std::io::{BufRead, BufReader};
    let folder = tempfile::tempdir().expect("a temporary folder");
    let model = folder.path().join("model.cx");
    let text = "param endless = FALSE;\nprint(\"begins\");\ntry { while (endless) { } } catch () { }\n";
    std::fs::write(&model, text).expect("writable");
    for signal in ["-INT", "-TERM"] {
        let mut run = Command::new(env!("CARGO_BIN_EXE_calyx"))
            .args(["run", "model.cx", "--quiet", "--set", "endless=TRUE"])
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command starts");
        let mut line = String::new();
        BufReader::new(run.stdout.take().expect("piped")).read_line(&mut line).expect("a line");
        assert_eq!(line, "begins\n");
        let sent = Command::new("kill").args([signal, &run.id().to_string()]).status();
        assert!(sent.expect("`kill` is there").success());
        let output = run.wait_with_output().expect("it ends");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{said}");
        assert!(said.contains("[E0704] Error: the run was cancelled"), "{said}");
    }
}

/// A cancelled run keeps its solved positions with their provenance; JSON progress contains the
/// number of positions.
#[cfg(unix)]
#[test]
fn a_run_that_is_ended_keeps_what_it_solved() {
    use std::io::{BufRead, BufReader, Read};
    let folder = tempfile::tempdir().expect("a temporary folder");
    std::fs::write(folder.path().join("pair.cx"), in_section()).expect("writable");
    let mut run = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .args(["run", "pair.cx", "--quiet", "--no-cache", "--progress", "json", "--set", "steps=5000"])
        .current_dir(folder.path())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .expect("the command starts");
    let mut err = BufReader::new(run.stderr.take().expect("piped"));
    let mut stages = Vec::new();
    loop {
        let mut line = String::new();
        assert!(err.read_line(&mut line).expect("text") > 0, "it ended after {stages:?}");
        let progress: Value = serde_json::from_str(&line).expect("one object a line");
        if progress["done"] == 0 {
            assert!(progress["total"].is_null() && progress["seconds_left"].is_null(), "{line}");
            stages.push(progress["stage"].as_str().expect("a name").to_owned());
        } else {
            assert!(
                progress["total"].as_u64() > Some(5000) && number(&progress["seconds_left"]) > 0.0,
                "{line}"
            );
        }
        if progress["done"] == 2 {
            break;
        }
    }
    assert_eq!(stages, ["structures", "positions"]);
    let sent = Command::new("kill").args(["-INT", &run.id().to_string()]).status();
    assert!(sent.expect("`kill` is there").success());
    let mut rest = String::new();
    err.read_to_string(&mut rest).expect("text");
    assert_eq!(run.wait().expect("it ends").code(), Some(1), "{rest}");
    assert!(rest.contains("[E0704] Error: the run was cancelled"), "{rest}");

    let directory = folder.path().join("pair.cx.run");
    let run = json(directory.join("run.json"));
    assert_eq!(run["incomplete"]["code"], "E0704");
    assert!(run["outputs"].is_null() && run["params"]["steps"]["value"] == 5000.0, "{run}");
    let rows = std::fs::read_to_string(directory.join("steps.csv")).expect("rows").lines().count() - 1;
    assert!(rows >= 2 && run["positions"] == rows, "{rows}: {run}");
    assert!(!directory.join("timing.json").exists());
}
