//! Models as text, solved: what tests of shafts, rotors, carriers and elastic bodies share.

use calyx::{Engine, Module, check_text};
use calyx_runtime::forced_response::ForcedResponse;
use std::collections::BTreeMap;
use std::fs;
use std::sync::LazyLock;

/// Summary of an output over the positions, SI.
#[derive(Clone, Copy, Debug)]
struct Summary {
    least: f64,
    mean: f64,
    most: f64,
}

/// Engine of all tests: they share its cache of structures, and condense each gear once.
static ENGINE: LazyLock<Engine> = LazyLock::new(Engine::default);

pub fn engine() -> Engine {
    ENGINE.clone()
}

/// Summary of each output of a model, which is next to these files (name, content).
fn summaries(text: &str, files: &[(&str, &str)]) -> BTreeMap<String, Summary> {
    let folder = tempfile::tempdir().expect("a folder");
    for (name, content) in files {
        fs::write(folder.path().join(name), content).expect("written");
    }
    let path = folder.path().join("model.cx");
    fs::write(&path, text).expect("written");
    let module = Module::from_file(&engine(), &path).unwrap_or_else(|error| panic!("{error}"));
    let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
    let outputs = text.lines().filter_map(|line| line.trim().strip_prefix("output "));
    let of = |name: &str| {
        let found = results.summary_si(name).unwrap_or_else(|error| panic!("{name}: {error}"));
        (name.to_owned(), Summary { least: found.min, mean: found.mean, most: found.max })
    };
    outputs.filter_map(|line| line.split(" :=").next()).map(of).collect()
}

/// Mean of each output of a model over the positions, SI.
pub fn means(text: &str) -> BTreeMap<String, f64> {
    summaries(text, &[]).into_iter().map(|(name, found)| (name, found.mean)).collect()
}

/// Smallest and largest value of each output of a model over the positions, SI.
pub fn ranges(text: &str) -> BTreeMap<String, [f64; 2]> {
    ranges_with(text, &[])
}

/// Like [`ranges`], of a model next to these files (name, content).
pub fn ranges_with(text: &str, files: &[(&str, &str)]) -> BTreeMap<String, [f64; 2]> {
    summaries(text, files).into_iter().map(|(name, found)| (name, [found.least, found.most])).collect()
}

/// Asserts that a value differs from another by at most a fraction of it.
pub fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let difference = (found - expected).abs();
    assert!(difference <= tolerance * expected.abs(), "{what}: {found} instead of {expected}");
}

/// Codes of the diagnostics of a model.
pub fn codes(text: &str) -> Vec<String> {
    check_text("model.cx", text).diagnostics.into_iter().map(|found| found.code.clone()).collect()
}

/// Returns the values of the outputs by position and output, SI, and the forced response.
pub fn solved(text: &str) -> (Vec<Vec<f64>>, Option<ForcedResponse>) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("model.cx");
    fs::write(&path, text).expect("written");
    let module = Module::from_file(&engine(), &path).unwrap_or_else(|error| panic!("{error}"));
    let results = module.instantiate().solve().unwrap_or_else(|error| panic!("{error}"));
    let result = results.analysis().expect("an analysis");
    let rows = result.rows.iter().map(|row| row.outputs.iter().map(|output| output.value).collect());
    (rows.collect(), result.forced_response.clone())
}
