//! Compares the spiral bevel pair of `examples/spiral_bevel.cx` with published stresses and with
//! the equilibrium of its forces.

use calyx::rt::{ParamAssignment, RunOptions, run};
use calyx::{Engine, Module, Override, check_file};
use calyx_runtime::estimate::Estimates;
use calyx_tests::root;
use std::collections::BTreeMap;
use std::fs;

/// Published largest principal stress in the pinion's fillets, psi: Vijayakar, Abad and Gunda
/// (2003), table 6.4, edge radius 0.045 inch, finest mesh.
const PUBLISHED_STRESS: f64 = 1.248e5;
const PSI: f64 = 6894.757;
/// The published model does not state all data (place of the tooth thickness, contact of edges).
const STRESS_TOLERANCE: f64 = 0.08;

/// Returns the columns of a run at "medium" with two positions, in SI units.
fn columns() -> BTreeMap<String, Vec<f64>> {
    let checked = check_file(&root().join("examples/spiral_bevel.cx")).expect("examples can be read");
    let module = Module::from_checked(&Engine::default(), checked).expect("examples compile");
    let directory = tempfile::tempdir().expect("a directory");
    let given = [("fidelity", "medium"), ("steps", "2")];
    let options = RunOptions {
        directory: directory.path().into(),
        given: given.iter().map(|(name, value)| ParamAssignment::text(*name, *value)).collect(),
        quiet: true,
        overrides: Override { error_estimates: Some(Estimates::None), ..Override::default() },
        ..RunOptions::default()
    };
    run(module.as_program(), &options).unwrap_or_else(|error| panic!("{error:?}"));
    let text = fs::read_to_string(directory.path().join("steps.csv")).expect("a table of positions");
    let mut lines = text.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<_>>());
    let names = lines.next().expect("a header");
    let rows: Vec<Vec<String>> = lines.collect();
    let column = |index: usize| rows.iter().filter_map(|row| row[index].parse().ok()).collect();
    names.iter().enumerate().map(|(index, name)| (name.clone(), column(index))).collect()
}

#[test]
fn the_pinion_has_its_published_root_stress_and_forces_are_in_equilibrium() {
    let columns = columns();
    let stress = columns["max_root_stress_pinion"].iter().copied().fold(0.0, f64::max) / PSI;
    assert!((stress / PUBLISHED_STRESS - 1.0).abs() < STRESS_TOLERANCE, "{stress} psi");
    // Both bodies are held by their bearings alone, apart from the torque.
    let largest = columns["bearing_force_pinion_offset"][0].abs();
    for direction in ["offset", "radial", "axial"] {
        // The axis of one gear is radial to the other.
        let other = match direction {
            "radial" => "axial",
            "axial" => "radial",
            same => same,
        };
        let pinion = &columns[&format!("bearing_force_pinion_{direction}")];
        let gear = &columns[&format!("bearing_force_gear_{other}")];
        assert_eq!(pinion.len(), 2);
        for (one, reaction) in pinion.iter().zip(gear) {
            assert!((one + reaction).abs() < 1e-9 * largest, "{direction}: {one} {reaction}");
        }
    }
    assert!(columns["load_share"].iter().all(|share| (0.0..=1.0).contains(share)));
    assert!(columns["transmission_error"].iter().all(|lag| *lag > 0.0), "the gear lags");
}
