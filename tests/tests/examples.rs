//! Every example is right as it stands, and runs.

use calyx::rt::{Given, RunOptions, run};
use calyx::{Engine, Module, check_file};
use calyx_tests::{pictures, root};

#[test]
fn every_example_checks_without_a_word_and_runs() {
    let mut count = 0;
    for entry in std::fs::read_dir(root().join("examples")).expect("there are examples") {
        let path = entry.expect("an entry").path();
        if path.extension().is_none_or(|extension| extension != "cx") {
            continue;
        }
        count += 1;
        let checked = check_file(&path).expect("examples can be read");
        assert!(checked.diagnostics.is_empty(), "{}", checked.render());
        let description = &checked.description;
        assert!(!description.doc.is_empty(), "{} says what it is", path.display());
        let named = description.params.iter().map(|param| (&param.name, &param.doc));
        for (name, doc) in named.chain(description.outputs.iter().map(|output| (&output.name, &output.doc))) {
            assert!(!doc.is_empty(), "{}: `{name}` has a doc comment", path.display());
        }
        let has = |name: &str| description.params.iter().any(|param| param.name == name);
        // Few positions and small meshes, where the example lets them be chosen.
        let small = [("steps", "2"), ("face_elements", "2"), ("displacement_order", "2")];
        let given =
            small.iter().filter(|(name, _)| has(name)).map(|(name, value)| Given::text(*name, *value));
        let given = given.collect();
        let directory = tempfile::tempdir().expect("a directory");
        let options = RunOptions {
            directory: directory.path().into(),
            given,
            quiet: true,
            vtu: true,
            ..RunOptions::default()
        };
        let module = Module::from_checked(&Engine::default(), checked).expect("examples compile");
        let report = run(module.as_program(), &options)
            .unwrap_or_else(|error| panic!("{}: {error:?}", path.display()));
        assert!(report.findings.is_empty(), "{}: {:?}", path.display(), report.findings);
        let rows = std::fs::read_to_string(directory.path().join("steps.csv")).expect("rows").lines().count();
        let source = std::fs::read_to_string(&path).expect("a source");
        let stress = ["gears.max_root_stress(", "gears.gauge_stress("].iter().any(|ask| source.contains(ask));
        pictures::check(directory.path(), rows - 1, stress);
    }
    assert!(count > 0);
}
