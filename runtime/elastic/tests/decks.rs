//! Imported decks against the results of other programs.

use crate::import::files::open_data;
use crate::meshes::assert_close;
use calyx_elastic::assembly::System;
use calyx_elastic::import::{Import, NastranOptions, Units, read_nastran};
use calyx_elastic::modes::{Request, natural_modes};
use calyx_elastic::{Resources, statics};
use faer::sparse::SparseColMat;
use nalgebra::DMatrix;
use serde_json::Value;

fn deck(name: &str) -> Import {
    let options = NastranOptions { units: Units::N_MM_S, subcase: None };
    read_nastran(&format!("nastran/{name}.bdf"), &options, &mut open_data)
        .unwrap_or_else(|error| panic!("{error}"))
}

fn reference() -> Value {
    serde_json::from_str(include_str!("data/deck_results.json")).expect("JSON")
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

#[test]
fn deck_b_has_the_displacements_of_the_reference() {
    let import = deck("deckB_101");
    let model = &import.model;
    let resources = Resources::default();
    let system = System::new(model, &resources).expect("valid");
    let solution =
        statics::solve(&system, std::slice::from_ref(&model.loads), &resources).expect("supported").remove(0);
    for (label, entry) in reference()["B"]["displacements"].as_object().expect("nodes") {
        let label: u64 = label.parse().expect("a label");
        let node = model.nodes.iter().position(|node| node.label == label).expect("the node");
        let expected = numbers(entry);
        for component in 0..6 {
            let unit = if component < 3 { 1e-3 } else { 1.0 };
            assert_close(solution.displacements[node][component] / unit, expected[component], 1e-6);
        }
    }
}

#[test]
fn deck_b_has_the_frequencies_of_the_reference() {
    let import = deck("deckB_103");
    let resources = Resources::default();
    let system = System::new(&import.model, &resources).expect("valid");
    let mass = system.mass(&resources).expect("valid");
    let found =
        natural_modes(&system, &mass, Request::Count(6), &resources).expect("converges").frequencies();
    // The reference has seven digits, but its iteration did not converge to the last modes.
    let tolerances = [1e-6, 3e-5, 3e-5, 3e-5, 2e-4, 2e-3];
    let reference = numbers(&reference()["B"]["frequencies"]);
    for ((found, expected), tolerance) in found.iter().zip(reference).zip(tolerances) {
        assert!(*found < expected * (1.0 + 1e-6), "Ritz values converge from above");
        assert_close(*found, expected, tolerance);
    }
    // A dense solver has no iteration.
    let unknowns = system.unknowns();
    let dense = |matrix: &SparseColMat<usize, f64>| {
        let mut full = DMatrix::zeros(system.dof_count(), system.dof_count());
        matrix.triplet_iter().for_each(|entry| full[(entry.row, entry.col)] = *entry.val);
        full.select_rows(&unknowns).select_columns(&unknowns)
    };
    let factor = dense(&mass).cholesky().expect("definite").l();
    let half = factor.solve_lower_triangular(&dense(&system.stiffness)).expect("regular");
    let reduced = factor.solve_lower_triangular(&half.transpose()).expect("regular");
    let mut values: Vec<f64> = reduced.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    for (found, value) in found.iter().zip(values) {
        assert_close(*found, value.sqrt() / std::f64::consts::TAU, 1e-9);
    }
}
