//! Tests of executables and bundles made by `calyx build`, which run without a Calyx installation:
//! with an empty environment and in another directory. Their results are bitwise equal to those of
//! `calyx run`. Code for another engine is rejected.
#![cfg(unix)]

use calyx::build::{Linker, library};
use calyx_abi::Fingerprint;
use calyx_codegen::{ObjectOptions, compile_object};
use serde_json::Value;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

fn examples() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples")
}

/// Returns all models below a directory.
fn models(directory: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(directory).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => found.extend(models(&path)),
            false => {
                found.extend(path.extension().is_some_and(|extension| extension == "cx").then_some(path))
            }
        }
    }
    found
}

fn calyx(arguments: &[&str]) -> Output {
    let output = Command::new(env!("CARGO_BIN_EXE_calyx")).args(arguments).output().unwrap();
    assert!(output.status.success(), "calyx {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    output
}

/// Runs an executable in an empty environment.
fn alone(executable: &Path, directory: &Path, arguments: &[&str]) -> Output {
    alone_with("off", executable, directory, arguments)
}

/// Runs an executable in an empty environment with a cache directory, or with "off".
fn alone_with(cache: &str, executable: &Path, directory: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(executable);
    command.args(arguments).env_clear().env("CALYX_CACHE", cache).current_dir(directory).output().unwrap()
}

fn shown(path: &Path) -> &str {
    path.to_str().unwrap()
}

/// Examples that take long: only in `.ci/full`, at their own fidelity.
const LONG: [&str; 11] = [
    "bevel_planetary",
    "countershaft",
    "flexible_shafts",
    "gearbox_noise",
    "helical_on_bearings",
    "helical_on_tapered_bearings",
    "planetary_carrier",
    "planetary_differential",
    "rear_axle",
    "recirculating",
    "split_path",
];

/// The largest example has rigid bodies, because executables and `calyx run` share the engine.
#[test]
fn short_examples_run_alone_and_write_the_same_bits() {
    examples_run_alone_and_write_the_same_bits(|name| match name {
        name if LONG.contains(&name) => None,
        "transfer_case" => Some(&["--fidelity", "rigid"]),
        _ => Some(&[]),
    });
}

/// Long: part of `.ci/full`.
#[test]
#[ignore = "long; part of .ci/full"]
fn long_examples_run_alone_at_their_own_fidelity() {
    examples_run_alone_and_write_the_same_bits(|_| Some(&[]));
}

/// Runs all examples with further options by name; `None` leaves one out. Two at a time: examples
/// are mostly sequential.
fn examples_run_alone_and_write_the_same_bits(
    further: impl Fn(&str) -> Option<&'static [&'static str]> + Sync,
) {
    let models = models(&examples());
    assert!(models.len() > 1, "{models:?}");
    let next = AtomicUsize::new(0);
    let work = || {
        while let Some(model) = models.get(next.fetch_add(1, Ordering::Relaxed)) {
            // Few positions and coarse meshes, where the example has such params.
            let text = fs::read_to_string(model).unwrap();
            // One example covers the contact of solid meshes.
            let solid = text.contains("param fidelity = \"medium\"") && !model.ends_with("helical_pair.cx");
            let rigid = solid.then_some("fidelity=rigid");
            let set: Vec<&str> = ["steps=3", "face_elements=2", "displacement_order=2"]
                .into_iter()
                .chain(rigid)
                .filter(|given| {
                    given.split('=').next().is_some_and(|name| text.contains(&format!("param {name}")))
                })
                .collect();
            // A coarse contact grid too: the solution takes most of the time.
            let options = ["--error-estimates", "none", "--contact-cells", "6"];
            let name = model.file_stem().and_then(|name| name.to_str()).unwrap();
            let Some(further) = further(name) else { continue };
            let options: Vec<&str> = options.iter().chain(further).copied().collect();
            runs_alone_and_writes_the_same_bits(model, &set, &options, &[]);
        }
    };
    thread::scope(|scope| {
        scope.spawn(work);
        scope.spawn(work);
    });
}

/// A bundle of a model is equivalent to its linked executable.
#[test]
fn a_bundle_runs_alone_and_writes_the_same_bits() {
    let model = examples().join("spur_pair.cx");
    runs_alone_and_writes_the_same_bits(&model, &["steps=2", "fidelity=plane"], &[], &["--bundle"]);
}

/// A calculation: outputs without an analysis, optional arguments of the library, and a `switch`
/// over an enumeration.
#[test]
fn a_calculation_runs_alone_and_writes_the_same_bits() {
    let directory = tempfile::tempdir().unwrap();
    let model = directory.path().join("calculation.cx");
    fs::write(
        &model,
        "import gears; units mm_N_s; enum Fit { loose, tight }
         param fit = Fit.loose; param addendum = 0 mm in 0 mm .. 5 mm; param d = 20 mm;
         function play(in fit: Fit) {
             var play;
             switch (fit) { case Fit.loose: play = 0.1; break; case Fit.tight: play = 1 / 3; }
             return play;
         }
         var shaper = gears.shaper(teeth = 20, module = 2 mm, tip_radius = 0.4 mm,
             addendum = if (addendum == 0 mm) none else addendum);
         var blank = gears.internal(teeth = 60, shaper = shaper, face_width = 20 mm, minor_diameter = 117 mm,
             root_diameter = 125 mm, material = gears.material(206 GPa, 0.3),
             rim = gears.outer_rim(diameter = 130 mm, outer_diameter = 140 mm));
         output radius := gears.base_radius(blank) * play(fit);
         output stress := [16 * 100 N*m / (pi * (d * i)^3) for i in 1 .. 4];",
    )
    .unwrap();
    for how in [&[][..], &["--bundle"][..]] {
        runs_alone_and_writes_the_same_bits(&model, &["fit=tight", "d=30 mm"], &[], how);
    }
    runs_alone_and_writes_the_same_bits(&model, &["addendum=2.5"], &[], &[]);
}

/// Anonymous functions that capture values, elements and functions, in a component and outside.
#[test]
fn captured_values_run_alone_and_write_the_same_bits() {
    let directory = tempfile::tempdir().unwrap();
    let model = directory.path().join("captures.cx");
    fs::write(&model, include_str!("data/captures.cx")).unwrap();
    for how in [&[][..], &["--bundle"][..]] {
        runs_alone_and_writes_the_same_bits(&model, &["level=6 mm", "low.load=7 N"], &[], how);
    }
}

/// Compares an executable with `calyx run` for a model with the given params, run options and build
/// options.
fn runs_alone_and_writes_the_same_bits(model: &Path, set: &[&str], options: &[&str], how: &[&str]) {
    let directory = tempfile::tempdir().unwrap();
    let [elsewhere, results, cache, executable] =
        ["elsewhere", "results", "cache", "model"].map(|name| directory.path().join(name));
    fs::create_dir(&elsewhere).unwrap();
    let set: Vec<&str> =
        set.iter().flat_map(|given| ["--set", given]).chain(options.iter().copied()).collect();
    // Both runs share the structure cache, whose contents are bitwise reproducible.
    let keeping = ["--quiet", "--cache", shown(&cache), "--out", shown(&results)];
    let from_command = calyx(&[&["run", shown(model)], &keeping[..], &set].concat());

    calyx(&[&["build", shown(model), "-o", shown(&executable)], how].concat());
    let options = [&["--quiet", "--out", "here"], &set[..]].concat();
    let output = alone_with(shown(&cache), &executable, &elsewhere, &options);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(output.stdout, from_command.stdout, "{}", model.display());
    assert!(output.stderr.is_empty(), "{}", String::from_utf8_lossy(&output.stderr));

    let here = elsewhere.join("here");
    let steps = |run: &Path| fs::read(run.join("steps.csv")).ok();
    assert_eq!(steps(&here), steps(&results), "{}", model.display());
    let outputs = |run: &Path| {
        let json: Value = serde_json::from_slice(&fs::read(run.join("run.json")).unwrap()).unwrap();
        (json["outputs"].clone(), json["params"].clone(), json["source"]["sha256"].clone())
    };
    assert_eq!(outputs(&here), outputs(&results), "{}", model.display());
}

/// An executable with this machine's instruction sets writes results bitwise equal to those of a
/// portable one.
#[test]
fn instructions_of_this_machine_change_no_bit() {
    let directory = tempfile::tempdir().unwrap();
    let model = directory.path().join("model.cx");
    fs::write(
        &model,
        "var x = 0.1; var i = 0; while (i < 200) { x = floor(1000*sin(x)*3.7)/999 + x*x/7; i = i + 1; } print(x);\n\
         var y := x*Time^2 + sqrt(Time)*Time^(3/2); print(y at Time = 0.3 s);\n",
    )
    .unwrap();
    let printed = ["baseline", "native"].map(|cpu| {
        let executable = directory.path().join(cpu);
        calyx(&["build", shown(&model), "--target-cpu", cpu, "-o", shown(&executable)]);
        let output = alone(&executable, directory.path(), &["--quiet"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    });
    assert!(printed[0].lines().count() == 2 && printed[0] == printed[1], "{printed:?}");
}

/// A build leaves no temporary files next to the executable, whether it succeeds or fails.
#[test]
fn what_is_not_finished_is_not_seen() {
    let directory = tempfile::tempdir().unwrap();
    let model = directory.path().join("model.cx");
    fs::write(&model, "print(1);\n").unwrap();
    let names = || {
        let entries = fs::read_dir(directory.path()).unwrap();
        let mut names: Vec<_> =
            entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    };
    let failed = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .args(["build", shown(&model)])
        .env("CC", "false")
        .output()
        .unwrap();
    assert_eq!(failed.status.code(), Some(1));
    assert_eq!(names(), ["model.cx"]);
    calyx(&["build", shown(&model), "--emit", "exe,obj,lib"]);
    assert_eq!(names(), ["libmodel.a", "model", "model.cx", "model.o"]);
}

/// A bundle accepts the options of a linked executable, requires no linker, and is rejected if
/// damaged.
#[test]
fn bundles_are_executables_of_their_model() {
    let directory = tempfile::tempdir().unwrap();
    let [model, bundle, linked] = ["model.cx", "bundle", "linked"].map(|name| directory.path().join(name));
    fs::write(
        &model,
        "/// Twice the number.\nunits SI;\n/// A length.\nparam x = 1 m in 0 m .. 2 m;\nprint(2*x);\n",
    )
    .unwrap();
    calyx(&["build", shown(&model), "-o", shown(&linked)]);
    let built = Command::new(env!("CARGO_BIN_EXE_calyx"))
        .args(["build", shown(&model), "--bundle", "-o", shown(&bundle)])
        .env_clear()
        .output()
        .unwrap();
    assert!(built.status.success(), "{}", String::from_utf8_lossy(&built.stderr));
    let cases: [(&[&str], i32); 4] =
        [(&["--help"], 0), (&["--set", "x=3"], 2), (&["run"], 2), (&["--set", "x=0.5", "--quiet"], 0)];
    for (arguments, status) in cases {
        let [one, other] = [&bundle, &linked].map(|executable| {
            let output = alone(executable, directory.path(), arguments);
            let name = executable.file_name().unwrap().to_str().unwrap();
            let said = [output.stdout, output.stderr]
                .map(|text| String::from_utf8(text).unwrap().replace(name, "NAME"));
            (output.status.code(), said)
        });
        assert_eq!(one, other, "{arguments:?}");
        assert_eq!(one.0, Some(status), "{arguments:?}: {one:?}");
    }
    // A byte of the module, before checksum, length and mark.
    let mut bytes = fs::read(&bundle).unwrap();
    let place = bytes.len() - 60;
    bytes[place] ^= 1;
    // A running file cannot be written, and a child process of another thread may still run this
    // one.
    fs::remove_file(&bundle).unwrap();
    fs::write(&bundle, bytes).unwrap();
    fs::set_permissions(&bundle, fs::metadata(&linked).unwrap().permissions()).unwrap();
    let output = alone(&bundle, directory.path(), &[]);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("error: the model in this executable is damaged\n  help: copy it again"), "{said}");
}

/// Code that was compiled for another engine is rejected before it runs.
#[test]
fn code_of_another_version_is_refused() {
    let directory = tempfile::tempdir().unwrap();
    let checked = calyx::check_text("model.cx", "print(\"ran\");\n");
    let description = calyx_lang::description::to_json(&checked.description).unwrap();
    let [object, executable] = ["model.o", "model"].map(|name| directory.path().join(name));
    let link = |abi: Fingerprint, description: &str| {
        let options = ObjectOptions { entry: true, ..ObjectOptions::new("model", description, abi) };
        fs::write(&object, compile_object(checked.program.as_ref().unwrap(), &options).unwrap()).unwrap();
        let Linker { program, arguments } = Linker::from_environment();
        let linked = Command::new(program)
            .args(arguments)
            .args([&object, &library::find(None, library::Needs::Interface).unwrap()])
            .args(["-lm", "-lpthread", "-ldl", "-o"])
            .arg(&executable)
            .output()
            .unwrap();
        assert!(linked.status.success(), "{}", String::from_utf8_lossy(&linked.stderr));
        let output = alone(&executable, directory.path(), &["--quiet"]);
        let said = String::from_utf8(output.stderr).unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), said)
    };
    let ours = calyx_gears::library::FINGERPRINT;
    assert_eq!(link(ours, &description), (Some(0), "ran\n".into(), String::new()));
    let (status, out, said) = link(Fingerprint(1), &description);
    assert_eq!((status, &*out), (Some(1), ""));
    for part in
        ["another version of Calyx", "help: compile the model again", "0000000000000001", &ours.to_string()]
    {
        assert!(said.contains(part), "{part} is not in {said}");
    }
    let (status, out, said) = link(ours, "{");
    assert_eq!((status, &*out), (Some(1), ""));
    assert!(said.contains("description is damaged"), "{said}");
}

/// `cargo install` installs no runtime library: the executable is then a copy of `calyx`, and a
/// message reports this.
#[test]
fn without_the_runtime_library_an_executable_is_a_copy() {
    let folder = tempfile::tempdir().expect("a directory");
    let bin = folder.path().join("bin");
    fs::create_dir(&bin).unwrap();
    let calyx = bin.join("calyx");
    fs::copy(env!("CARGO_BIN_EXE_calyx"), &calyx).unwrap();
    fs::write(folder.path().join("model.cx"), "print(42);").unwrap();
    let build = |library: Option<&str>| {
        let mut command = Command::new(&calyx);
        command.args(["build", "model.cx"]).current_dir(folder.path()).env("HOME", folder.path());
        command.env_remove("XDG_DATA_HOME").env_remove("CALYX_RT_LIBRARY");
        library.map(|library| command.env("CALYX_RT_LIBRARY", library));
        // A process that another test starts meanwhile may have the copy open for writing.
        let output = loop {
            match command.output() {
                Err(error) if error.kind() == ErrorKind::ExecutableFileBusy => thread::yield_now(),
                output => break output.expect("calyx starts"),
            }
        };
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    // An explicitly named library has no fallback.
    let (status, err) = build(Some("missing.a"));
    assert_eq!(status, Some(1), "{err}");
    let (status, err) = build(None);
    assert_eq!(status, Some(0), "{err}");
    assert!(err.contains("a copy of `calyx` with the model") && err.contains("was not found"), "{err}");
    let ran = Command::new(folder.path().join("model")).current_dir(folder.path()).output();
    assert_eq!(String::from_utf8_lossy(&ran.expect("it starts").stdout), "42\n");
}
