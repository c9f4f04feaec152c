//! Checks that every example passes `check` without diagnostics, runs without meshes, and is drawn.

use crate::models::engine;
use calyx::rt::{ParamAssignment, RunError, RunOptions, run};
use calyx::{Module, Override, check_file};
use calyx_runtime::estimate::Estimates;
use calyx_tests::plots::{self, Expected};
use calyx_tests::root;
use serde_json::Value;
use std::collections::BTreeSet;
use std::path::PathBuf;

fn examples() -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join("examples")).expect("there are examples");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<PathBuf> =
        paths.filter(|path| path.extension().is_some_and(|extension| extension == "cx")).collect();
    paths.sort();
    assert!(!paths.is_empty());
    paths
}

/// Examples whose VTU files are checked: external and internal gears, in two and three dimensions.
const PICTURED: [&str; 3] = ["helical_pair", "internal_pair", "planetary"];

/// Examples whose only diagnostic is a warning about unloaded contact, which is a property of the
/// pair: flanks with the mismatch of the published settings, or strongly crowned ones.
const WARNED: [(&str, &str); 5] = [
    ("bevel_planetary", "W0861"),
    ("face_hobbed", "W0861"),
    ("hypoid", "W0861"),
    ("rear_axle", "W0861"),
    ("spiral_bevel", "W0861"),
];

fn warnings(name: &str) -> impl Iterator<Item = &'static str> {
    WARNED.iter().filter(move |(example, _)| *example == name).map(|(_, code)| *code)
}

/// Runs only the pictured examples: the test of executables in `compiler/tests` runs all of them.
#[test]
fn every_example_checks_without_a_diagnostic_and_has_sound_pictures() {
    for path in examples() {
        let checked = check_file(&path).expect("examples can be read");
        let name = path.file_stem().expect("a name").to_string_lossy();
        let mut found: Vec<&str> =
            checked.diagnostics.iter().map(|diagnostic| &diagnostic.code[..]).collect();
        found.sort_unstable();
        assert!(found.into_iter().eq(warnings(&name)), "{}", checked.render());
        let description = &checked.description;
        assert!(!description.doc.is_empty(), "{} says what it is", path.display());
        let named = description.params.iter().map(|param| (&param.name, &param.doc));
        for (name, doc) in named.chain(description.outputs.iter().map(|output| (&output.name, &output.doc))) {
            assert!(!doc.is_empty(), "{}: `{name}` has a doc comment", path.display());
        }
        if !PICTURED.contains(&&*path.file_stem().expect("a name").to_string_lossy()) {
            continue;
        }
        let has = |name: &str| description.params.iter().any(|param| param.name == name);
        // Few positions and coarse meshes, where the example has such params.
        let small = [("steps", "2"), ("face_elements", "2"), ("displacement_order", "2")];
        let given = small
            .iter()
            .filter(|(name, _)| has(name))
            .map(|(name, value)| ParamAssignment::text(*name, *value));
        let given = given.collect();
        let directory = tempfile::tempdir().expect("a directory");
        let options = RunOptions {
            directory: directory.path().into(),
            given,
            quiet: true,
            vtu: true,
            // The test concerns the run itself; error estimates would double its time.
            overrides: Override { error_estimates: Some(Estimates::None), ..Override::default() },
            ..RunOptions::default()
        };
        let module = Module::from_checked(&engine(), checked).expect("examples compile");
        let report = run(module.as_program(), &options)
            .unwrap_or_else(|error| panic!("{}: {error:?}", path.display()));
        assert!(report.findings.is_empty(), "{}: {:?}", path.display(), report.findings);
        let rows = std::fs::read_to_string(directory.path().join("steps.csv")).expect("rows").lines().count();
        let source = std::fs::read_to_string(&path).expect("a source");
        let stress = ["gears.max_root_stress(", "gears.gauge_stress("].iter().any(|ask| source.contains(ask));
        plots::check(directory.path(), Expected { positions: rows - 1, stress, bodies: true });
    }
}

/// Params that shorten examples.
const SHORT: [(&str, &str, &str); 2] = [("gearbox_noise", "method", "erp"), ("gearbox_noise", "speeds", "2")];

/// Analyses that a fidelity level does not support: rigid teeth have neither dynamics nor modes of
/// their bodies, and no torque can be locked in a loop of rigid bodies.
const REFUSED: [(&str, &str, &str); 5] = [
    ("gearbox_noise", "rigid", "E0782"),
    ("helical_dynamics", "rigid", "E0781"),
    ("planetary_modes", "rigid", "E0782"),
    ("recirculating", "rigid", "E0717"),
    ("spur_dynamics", "rigid", "E0781"),
];

/// At the fidelity levels without meshes, every example runs and has values of all outputs except
/// those that are rejected by name, each with its location. An unsupported analysis is rejected as
/// a whole by its code. Levels that an example does not offer are selected by a settings override.
#[test]
fn examples_run_at_the_levels_without_meshes() {
    for path in examples() {
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let checked = check_file(&path).expect("examples can be read");
        let params = checked.description.params.clone();
        let module = Module::from_checked(&engine(), checked).expect("examples compile");
        for level in ["rigid", "analytic"] {
            let fidelity = params.iter().find(|param| param.name == "fidelity");
            let offers = fidelity.is_some_and(|param| param.choices.iter().any(|choice| choice == level));
            let mut overrides = Override::default();
            let settings = [("contact_cells", "3"), ("contact_slices", "2"), ("error_estimates", "none")];
            for (name, value) in settings {
                overrides.set(name, value).expect("a setting");
            }
            let mut given = Vec::new();
            match offers {
                true => given.push(ParamAssignment::text("fidelity", level)),
                false => overrides.set("fidelity", level).expect("a fidelity level"),
            }
            if params.iter().any(|param| param.name == "steps") {
                given.push(ParamAssignment::text("steps", "2"));
            }
            let short = SHORT.iter().filter(|(example, ..)| *example == name);
            given.extend(short.map(|(_, param, value)| ParamAssignment::text(*param, *value)));
            let directory = tempfile::tempdir().expect("a directory");
            let options = RunOptions {
                directory: directory.path().into(),
                given,
                quiet: true,
                overrides,
                ..RunOptions::default()
            };
            let report = match run(module.as_program(), &options) {
                Ok(report) => report,
                Err(RunError::Run(error)) => {
                    let refused = (&name[..], level, error.code().unwrap_or_default());
                    assert!(REFUSED.contains(&refused), "{refused:?}: {error:?}");
                    continue;
                }
                Err(error) => panic!("{name} at {level}: {error:?}"),
            };
            let record = std::fs::read_to_string(directory.path().join("run.json")).expect("a record");
            let record: Value = serde_json::from_str(&record).expect("JSON");
            let Some(outputs) = record["outputs"].as_object() else {
                assert_eq!(record["fidelity"], Value::Null, "{name} at {level}");
                continue;
            };
            assert_eq!(record["fidelity"], level);
            let refused = record["refused_outputs"].as_object().expect("those that have none");
            for (output, summary) in outputs {
                let (known, named) = (summary["max"].is_number(), refused.contains_key(output));
                assert!(known != named, "{name} at {level}: {output} {summary}");
            }
            let mut codes: Vec<&str> =
                report.findings.iter().map(|finding| &finding.error.code[..]).collect();
            codes.sort_unstable();
            // Outputs with the same requirements share a warning.
            let needs: BTreeSet<&str> = refused.values().filter_map(Value::as_str).collect();
            let mut expected = vec!["E0780"; needs.len()];
            expected.extend(warnings(&name));
            assert_eq!(codes, expected, "{name} at {level}");
            assert!(report.findings.iter().all(|finding| finding.error.place.is_some()), "{name} at {level}");
        }
    }
}
