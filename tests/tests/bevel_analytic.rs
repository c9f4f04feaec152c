//! Compares the closed forms of bevel, hypoid, face-hobbed and straight bevel pairs and of a face
//! gear with finite elements.

use calyx::rt::{ParamAssignment, RunOptions, run};
use calyx::{Engine, Module, Override, check_file};
use calyx_runtime::estimate::Estimates;
use calyx_tests::root;
use std::collections::BTreeMap;
use std::fs;
use std::sync::LazyLock;

static ENGINE: LazyLock<Engine> = LazyLock::new(Engine::default);
const POSITIONS: usize = 4;
/// Largest deviations, in the order of [`deviations`]. Pinions on a free bore are the most
/// compliant ones, and closed forms assume a rigid bore.
const BOUNDS: [f64; 7] = [0.45, 4.0, 0.1, 0.15, 0.3, 0.35, 0.45];

/// Columns of the table of an example at a fidelity level, in SI units.
fn columns(example: &str, fidelity: &str) -> BTreeMap<String, Vec<f64>> {
    let checked = check_file(&root().join("examples").join(format!("{example}.cx"))).expect("a model");
    let module = Module::from_checked(&ENGINE, checked).expect("the model compiles");
    let directory = tempfile::tempdir().expect("a directory");
    let steps = POSITIONS.to_string();
    let options = RunOptions {
        directory: directory.path().into(),
        given: [("fidelity", fidelity), ("steps", &steps)]
            .map(|(name, value)| ParamAssignment::text(name, value))
            .into(),
        quiet: true,
        overrides: Override { error_estimates: Some(Estimates::None), ..Override::default() },
        engine: ENGINE.clone(),
        ..RunOptions::default()
    };
    run(module.as_program(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    let text = fs::read_to_string(directory.path().join("steps.csv")).expect("a table");
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let names = lines.next().expect("a header");
    let rows: Vec<Vec<String>> = lines.collect();
    let column = |index: usize| rows.iter().filter_map(|row| row[index].parse().ok()).collect();
    names.iter().enumerate().map(|(index, name)| (name.clone(), column(index))).collect()
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

fn extremes(values: &[f64]) -> [f64; 2] {
    [f64::min, f64::max].map(|of| values.iter().copied().reduce(of).expect("values"))
}

/// Deviations from finite elements: mean transmission error, its peak to peak relative to that of
/// the elements and to the mean, load share (largest difference), largest contact pressure, and
/// largest root stresses.
fn deviations(example: &str) -> [f64; 7] {
    let [closed, meshed] = ["analytic", "medium"].map(|fidelity| columns(example, fidelity));
    let both = |output: &str| [&closed[output], &meshed[output]];
    let error = both("transmission_error");
    let means = error.map(|values| mean(values));
    let peaks = error.map(|values| extremes(values)).map(|[low, high]| high - low);
    let shares = both("load_share");
    let share = shares[0].iter().zip(shares[1]).map(|(one, other)| (one - other).abs()).fold(0.0, f64::max);
    let largest = |output: &str| {
        let [one, other] = both(output).map(|values| extremes(values)[1]);
        one / other - 1.0
    };
    [
        means[0] / means[1] - 1.0,
        peaks[0] / peaks[1] - 1.0,
        (peaks[0] - peaks[1]) / means[1].abs(),
        share,
        largest("max_contact_pressure"),
        largest("max_root_stress_pinion"),
        largest("max_root_stress_gear"),
    ]
}

/// The table of `docs/howto/bevel.md`: run with `--nocapture`.
#[test]
#[ignore = "takes many minutes: .ci/full runs it"]
fn closed_forms_of_bevel_gears_are_near_the_finite_elements() {
    for example in ["straight_bevel", "spiral_bevel", "hypoid", "face_hobbed", "face_gear"] {
        let found = deviations(example);
        let percent = found.map(|part| format!("{:.1} %", 100.0 * part));
        println!("| `{example}` | {} |", percent.join(" | "));
        for (off, bound) in found.iter().zip(BOUNDS) {
            assert!(off.abs() < bound, "{example}: {found:?}");
        }
    }
}
