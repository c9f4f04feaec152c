//! Compares the three ways to run a program: the interpreter, machine code in memory, and machine
//! code linked into an executable. All build the same scene and write bitwise equal results.
#![cfg(unix)]

use crate::models::engine;
use calyx::build::{BuildOptions, build};
use calyx::rt::{ParamAssignment, Program, RunOptions, apply, run};
use calyx::{Interpreted, Module, check_file, check_text};
use calyx_abi::{Context, Purity, SymbolicValue};
use calyx_gears::host::{GearModel, ModelHost};
use calyx_tests::root;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::{Arc, OnceLock};

const SET: [(&str, &str); 4] =
    [("steps", "2"), ("torque", "700"), ("tip_radius", "0.5 mm"), ("fidelity", "plane")];

fn given() -> Vec<ParamAssignment> {
    SET.map(|(name, value)| ParamAssignment::text(name, value)).to_vec()
}

fn example() -> PathBuf {
    root().join("examples/spur_pair.cx")
}

/// Times at which time-dependent quantities are evaluated, s.
const TIMES: [f64; 4] = [0.0, 0.1, 1.4698981493578729, -3.7];

/// Formats all data that a program passes to the engine, with all bits of every number.
fn scene(program: &dyn Program) -> String {
    // The analysis is requested but not performed.
    let mut context = Context::new(Box::new(ModelHost { checking: true, ..ModelHost::default() }));
    context.kernels = program.kernels();
    apply(program, &given(), &mut context).unwrap();
    program.main(&mut context).unwrap();
    let (params, slots) = (format!("{:?}", context.params), context.param_slots.len());
    let host = context.host::<ModelHost>().unwrap();
    let mut text = format!("{params} {slots}\n{:?}\n{:?}\n{:?}\n", host.materials, host.racks, host.rims);
    for gear in host.gears.iter().filter_map(GearModel::cylindrical) {
        writeln!(text, "{:?} {:?} {:?}", gear.gear, gear.modifications, gear.material).unwrap();
        writeln!(text, "{:?} {:?} {:?}", gear.rim, gear.face_width, gear.pitch_errors).unwrap();
    }
    writeln!(text, "{:?}\n{:?}", host.body_gears, host.positions).unwrap();
    for body in &host.scene.bodies {
        let (name, phase) = (&body.name, body.phase);
        writeln!(
            text,
            "{name} {phase:?} {:?} {:?} {:?}",
            body.free,
            body.load.at(0.0).force,
            body.load.at(0.0).moment
        )
        .unwrap();
        for time in TIMES {
            writeln!(text, "{:?} {:?}", body.motion.frame(time), body.motion.rate(time)).unwrap();
        }
    }
    for pair in &host.scene.pairs {
        writeln!(text, "{:?} {:?} {:?} {:?}", pair.bodies, pair.surfaces, pair.grid, pair.mesh).unwrap();
    }
    writeln!(text, "{:?}", host.scene.observables).unwrap();
    for output in &host.outputs {
        writeln!(text, "{} {:?} {}", output.name, output.params, symbolic(&output.value, &output.params))
            .unwrap();
    }
    text
}

fn symbolic(value: &Arc<SymbolicValue>, params: &[f64]) -> String {
    let values = TIMES
        .map(|time| value.evaluate(time, params, &|index| index as f64).expect("a kernel of these inputs"));
    format!("{} {:?} {:?} {:?} {values:?}", value.site, value.repr, value.captured, value.observables)
}

#[test]
fn interpreter_and_machine_code_build_the_same_scene() {
    let text = std::fs::read_to_string(example()).unwrap();
    let checked = || check_text("spur_pair.cx", &text);
    let program = checked().program.unwrap();
    let interpreted = scene(&Interpreted::new(&program, Purity::Effect).unwrap());
    let compiled = scene(Module::from_checked(&engine(), checked()).unwrap().as_program().as_ref());
    assert!(interpreted.lines().count() > 20, "{interpreted}");
    assert_eq!(interpreted, compiled);
}

/// Returns `steps.csv` of a run in this process.
fn steps(program: Arc<dyn Program>) -> String {
    let directory = tempfile::tempdir().unwrap();
    let options = RunOptions {
        directory: directory.path().into(),
        given: given(),
        quiet: true,
        ..RunOptions::default()
    };
    run(program, &options).unwrap();
    std::fs::read_to_string(directory.path().join("steps.csv")).unwrap()
}

#[test]
fn all_three_ways_write_the_same_results() {
    // A run continues on its own thread, so the interpreted program must outlive it.
    let program = Box::leak(Box::new(check_file(&example()).unwrap().program.unwrap()));
    let interpreted = steps(Arc::new(Interpreted::new(program, Purity::Effect).unwrap()));
    assert!(interpreted.lines().count() > 4, "{interpreted}");
    let compiled = steps(Module::from_file(&engine(), example()).unwrap().as_program());
    assert_eq!(interpreted, compiled);

    let directory = tempfile::tempdir().unwrap();
    let mut arguments = vec!["--out".to_owned(), "results".into(), "--quiet".into()];
    arguments.extend(SET.iter().flat_map(|(name, value)| ["--set".into(), format!("{name}={value}")]));
    let output = linked(directory.path(), &arguments);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stdout.is_empty() && output.stderr.is_empty());
    let linked = std::fs::read_to_string(directory.path().join("results/steps.csv")).unwrap();
    assert_eq!(interpreted, linked);
}

/// Runs the example's executable in an empty environment, in its own directory.
fn linked(directory: &Path, arguments: &[String]) -> Output {
    static LINKED: OnceLock<(tempfile::TempDir, PathBuf)> = OnceLock::new();
    let (_, executable) = LINKED.get_or_init(|| link(&example()));
    Command::new(executable).args(arguments).env_clear().current_dir(directory).output().unwrap()
}

fn link(model: &Path) -> (tempfile::TempDir, PathBuf) {
    let directory = tempfile::tempdir().unwrap();
    let options = BuildOptions::executable(directory.path().join("model"));
    let built = build(&check_file(model).unwrap(), &options).unwrap_or_else(|error| panic!("{error}"));
    (directory, built[0].path.clone())
}

#[test]
fn executables_explain_themselves_and_their_errors() {
    let directory = tempfile::tempdir().unwrap();
    // Arguments, exit status, and parts of standard output or error, in this order.
    let table: [(&[&str], i32, &[&str]); 6] = [
        (
            &["--help"],
            0,
            &[
                "Spur pair",
                "torque",
                "1000 lbf*inch",
                "0 .. 5000",
                "Torque on the pinion.",
                "steps",
                "32",
                "2 .. 10000, whole",
                "transmission_error",
                "--set <NAME=VALUE>",
            ],
        ),
        (&["--set", "torque"], 2, &["'torque' for '--set <NAME=VALUE>': there is no `=`"]),
        (&["--set", "torqe=3"], 2, &["no param called `torqe`", "did you mean `torque`?"]),
        (&["--set", "tip_radius=1"], 2, &["`tip_radius` = 1 inch", "0.005 inch .. 0.045 inch"]),
        (&["--frob"], 2, &["--frob"]),
        (
            &["--set", "center_distance=2.98", "--set", "tooth_thickness=0.08", "--set", "tip_relief=0.005"],
            1,
            &["error[E06", "help: "],
        ),
    ];
    for (arguments, status, parts) in table {
        let arguments: Vec<String> = arguments.iter().map(|argument| (*argument).into()).collect();
        let output = linked(directory.path(), &arguments);
        let shown = if status == 0 { output.stdout } else { output.stderr };
        let shown = String::from_utf8_lossy(&shown);
        assert_eq!(output.status.code(), Some(status), "{arguments:?}: {shown}");
        let mut rest = &shown[..];
        for part in parts {
            let at = rest.find(part).unwrap_or_else(|| panic!("{arguments:?} lacks `{part}`: {shown}"));
            rest = &rest[at + part.len()..];
        }
    }
    // An error of the model shows its line.
    let model = directory.path().join("index.cx");
    std::fs::write(&model, "param n = 1 in 0 .. 10;\nvar a = [1, 2, 3];\nprint(a[n]);\n").unwrap();
    let (_kept, executable) = link(&model);
    let run = |n: &str| {
        Command::new(&executable).args(["--quiet", "--set", n]).current_dir(&directory).output().unwrap()
    };
    assert_eq!(String::from_utf8_lossy(&run("n=2").stdout), "3\n");
    let failed = run("n=7");
    let err = String::from_utf8_lossy(&failed.stderr);
    assert_eq!(failed.status.code(), Some(1));
    assert!(err.contains("index.cx:3:9") && err.contains(" 3 | print(a[n]);\n   |         ^\n"), "{err}");
}

/// Errors of an executable include the argument at fault and the calls, and can be caught, using
/// only the program's own tables.
#[test]
fn executables_place_and_catch_errors() {
    let text = "import gears;\nparam radius = 0.3 mm;\nparam caught = FALSE;\nparam endless = FALSE;\n\
                function rack(in r) { return gears.rack(module = 2 mm, tip_radius = r - 0 mm); }\n\
                if (caught) try rack(radius); catch (e) print(e.code, e.place);\n\
                else if (!endless) rack(radius);\n\
                while (endless) { }\n";
    let folder = tempfile::tempdir().unwrap();
    let model = folder.path().join("racks.cx");
    std::fs::write(&model, text).unwrap();
    let (_kept, executable) = link(&model);
    let run = |arguments: &[&str]| {
        let output = Command::new(&executable)
            .args(["--quiet", "--set", "radius=-1 mm"])
            .args(arguments)
            .env_clear()
            .current_dir(folder.path())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr).replace(&folder.path().display().to_string(), ".");
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned(), said)
    };
    let (status, _, said) = run(&[]);
    assert_eq!(status, Some(1), "{said}");
    for part in ["error[E0314]", "racks.cx:5:69", "^^^^^^^^", "in `rack`, called at ./racks.cx:7:20"] {
        assert!(said.contains(part), "{part} is not in\n{said}");
    }
    let (status, out, said) = run(&["--set", "caught=TRUE"]);
    assert_eq!(status, Some(0), "{said}");
    assert!(out.starts_with("E0314 ") && out.ends_with("racks.cx:5:69\n"), "{out}");
    let (status, _, said) = run(&["--set", "endless=TRUE", "--time-limit", "50ms"]);
    assert!(status == Some(1) && said.contains("error[E0707]") && said.contains("racks.cx:8:8"), "{said}");
}
