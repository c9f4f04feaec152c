//! Imported decks against the results of other programs.

use crate::import::files::open_data;
use crate::meshes::assert_close;
use calyx_elastic::assembly::System;
use calyx_elastic::import::{Import, NastranOptions, Units, read_nastran};
use calyx_elastic::model::Components;
use calyx_elastic::modes::{Request, natural_modes};
use calyx_elastic::{ElasticModel, Element, FixedComponents, Node, Resources, statics};
use faer::sparse::SparseColMat;
use nalgebra::DMatrix;
use serde_json::Value;
use std::collections::BTreeMap;

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
    // The reference has seven digits. Presumably its iteration did not converge to the last modes:
    // a dense eigensolver on the same matrices confirms those found here.
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

/// Divides each quadrilateral into four. A node between two fixed ones is fixed.
fn refined(model: &ElasticModel) -> ElasticModel {
    let mut fine = ElasticModel { elements: Vec::new(), fixed: Vec::new(), ..model.clone() };
    let mut fixed: BTreeMap<usize, Components> = BTreeMap::new();
    for entry in &model.fixed {
        let components = fixed.entry(entry.node).or_default();
        (0..6).for_each(|k| components[k] |= entry.components[k]);
    }
    let mut between: BTreeMap<Vec<usize>, usize> = BTreeMap::new();
    for element in &model.elements {
        let mut mean = |corners: &[usize]| {
            let mut corners = corners.to_vec();
            corners.sort_unstable();
            *between.entry(corners.clone()).or_insert_with(|| {
                let sum = corners.iter().fold([0.0; 3], |sum: [f64; 3], &corner| {
                    [0, 1, 2].map(|axis| sum[axis] + model.nodes[corner].position[axis])
                });
                let position = sum.map(|sum| sum / corners.len() as f64);
                let common = corners.iter().map(|corner| fixed.get(corner).copied().unwrap_or_default());
                let common = common.reduce(|a, b| std::array::from_fn(|k| a[k] && b[k]));
                let node = fine.nodes.len();
                if let Some(components) = common.filter(|components| components.contains(&true)) {
                    fixed.insert(node, components);
                }
                fine.nodes.push(Node {
                    label: 1_000_000 + node as u64,
                    position,
                    ..model.nodes[corners[0]].clone()
                });
                node
            })
        };
        let c = &element.nodes;
        let sides = [0, 1, 2, 3].map(|k| mean(&[c[k], c[(k + 1) % 4]]));
        let centre = mean(c);
        for k in 0..4 {
            let nodes = vec![c[k], sides[k], centre, sides[(k + 3) % 4]];
            fine.elements.push(Element { nodes, ..element.clone() });
        }
    }
    let entry = |(node, components)| FixedComponents { node, components, value: 0.0 };
    fine.fixed = fixed.into_iter().map(entry).collect();
    fine
}

#[test]
fn deck_a_converges_to_the_displacement_and_frequencies_of_a_fine_mesh() {
    let model = refined(&refined(&deck("deckA_101").model));
    let resources = Resources::default();
    let system = System::new(&model, &resources).expect("valid");
    let reference = &reference()["A_converged"];
    let cases = std::slice::from_ref(&model.loads);
    let solution = statics::solve(&system, cases, &resources).expect("supported").remove(0);
    let top = model.nodes.iter().position(|node| node.label == 59).expect("the node");
    let expected = reference["uz_top_centre"].as_f64().expect("a number");
    assert_close(solution.displacements[top][2] / 1e-3, expected, 5e-3);
    let mass = system.mass(&resources).expect("valid");
    let found =
        natural_modes(&system, &mass, Request::Count(6), &resources).expect("converges").frequencies();
    for (found, expected) in found.into_iter().zip(numbers(&reference["frequencies_hz"])) {
        assert_close(found, expected, 5e-3);
    }
}
