//! Decks A and B with the values that an independent program computed, and broken decks.

use super::files::{open_data, read};
use calyx_elastic::import::{
    Import, NastranOptions, Units, element_mass_properties, mass_properties, read_nastran,
};
use calyx_elastic::model::{ElementKind, SolidShape};
use serde_json::Value;

const OPTIONS: NastranOptions = NastranOptions { units: Units::N_MM_S, subcase: None };
const MM: f64 = 1e-3;
const TONNE: f64 = 1e3;

fn deck(name: &str) -> Import {
    read_nastran(&format!("nastran/{name}.bdf"), &OPTIONS, &mut open_data)
        .unwrap_or_else(|error| panic!("{error}"))
}

fn reference(deck: &str) -> Value {
    let all: Value = serde_json::from_slice(&read("nastran/reference.json")).expect("JSON");
    all[deck].clone()
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("a list").iter().map(|x| x.as_f64().expect("a number")).collect()
}

fn assert_close(name: &str, found: &[f64], expected: &[f64], tolerance: f64) {
    let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    assert_eq!(found.len(), expected.len(), "{name}");
    for (a, b) in found.iter().zip(expected) {
        assert!((a - b).abs() <= tolerance * size, "{name}: {found:?} instead of {expected:?}");
    }
}

/// Card that an element comes from.
fn card(kind: &ElementKind) -> &'static str {
    match kind {
        ElementKind::Solid(SolidShape::Hexahedron8) => "CHEXA",
        ElementKind::Solid(SolidShape::Wedge6) => "CPENTA",
        ElementKind::Solid(SolidShape::Tetrahedron4) => "CTETRA",
        ElementKind::Shell { .. } => "CQUAD4",
        ElementKind::Mass { .. } => "CONM2",
        other => panic!("{other:?}"),
    }
}

fn check_against_reference(name: &str) {
    let (import, reference) = (deck(&format!("deck{name}_101")), reference(name));
    let model = &import.model;
    assert_eq!(model.nodes.len() as u64, reference["n_nodes"].as_u64().expect("a count"));
    for (label, position) in reference["positions_basic"].as_object().expect("positions") {
        let at = model.nodes.binary_search_by_key(&label.parse().expect("a label"), |node| node.label);
        let found = model.nodes[at.expect("the node exists")].position.map(|x| x / MM);
        let error = found.iter().zip(numbers(position)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(error <= 1e-10, "node {label}: {found:?}");
    }
    for (kind, count) in reference["elements"].as_object().expect("counts") {
        let found = model.elements.iter().filter(|element| card(&element.kind) == kind).count();
        assert_eq!(found as u64, count.as_u64().expect("a count"), "{kind}");
    }
    for (label, entry) in reference["connectivity"].as_object().expect("elements") {
        let label: u64 = label.parse().expect("a label");
        let element =
            model.elements.iter().find(|element| element.label == label).expect("the element exists");
        let nodes: Vec<f64> = element.nodes.iter().map(|node| model.nodes[*node].label as f64).collect();
        assert_eq!(card(&element.kind), entry[0].as_str().expect("a card"));
        assert_eq!(nodes, numbers(&entry[2]), "element {label}");
    }
    // The reference has the mass of each element at the mean of its corners, and the inertia about
    // the centre of mass.
    let parts: Vec<(f64, [f64; 3])> = model
        .elements
        .iter()
        .map(|element| {
            let part = element_mass_properties(model, element);
            let count = element.nodes.len() as f64;
            let mean = |i: usize| {
                element.nodes.iter().map(|node| model.nodes[*node].position[i]).sum::<f64>() / count
            };
            (part.mass, if element.material.is_some() { [0, 1, 2].map(mean) } else { part.centre })
        })
        .collect();
    let mass: f64 = parts.iter().map(|(mass, _)| mass).sum();
    let centre = [0, 1, 2].map(|i| parts.iter().map(|(mass, at)| mass * at[i]).sum::<f64>() / mass);
    let mut inertia = [0.0; 6];
    for (mass, at) in &parts {
        let [x, y, z] = [0, 1, 2].map(|i| at[i] - centre[i]);
        let products = [y * y + z * z, x * x + z * z, x * x + y * y, x * y, x * z, y * z];
        (0..6).for_each(|i| inertia[i] += mass * products[i]);
    }
    assert_eq!(mass_properties(model), import.report.mass);
    assert_close("mass", &[import.report.mass.mass / TONNE], &[mass / TONNE], 1e-12);
    assert_close("mass", &[mass / TONNE], &[reference["mass"].as_f64().expect("a mass")], 1e-12);
    assert_close("centre", &centre.map(|x| x / MM), &numbers(&reference["cg"]), 1e-12);
    let expected = numbers(&reference["inertia_about_centre_Ixx_Iyy_Izz_Ixy_Ixz_Iyz"]);
    assert_close("inertia", &inertia.map(|x| x / (TONNE * MM * MM)), &expected, 1e-12);
    // The exact centre differs by the curvature of the sides of deck B.
    assert_close(
        "exact centre",
        &import.report.mass.centre.map(|x| x / MM),
        &numbers(&reference["cg"]),
        1e-3,
    );
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for load in &model.loads {
        let (at, f) = (model.nodes[load.node].position.map(|x| x / MM), &load.load);
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            force[i] += f[i];
            moment[i] += f[3 + i] / MM + at[j] * f[k] - at[k] * f[j];
        }
    }
    let resultant = &reference["load_resultant_about_origin"];
    assert_close("force", &force, &numbers(&resultant["F"]), 1e-12);
    assert_close("moment", &moment, &numbers(&resultant["M"]), 1e-12);
}

#[test]
fn deck_a_of_shells_has_the_positions_mass_and_loads_of_the_reference() {
    check_against_reference("A");
    let model = deck("deckA_101").model;
    let fixed: Vec<[bool; 6]> = model.fixed.iter().map(|entry| entry.components).collect();
    assert_eq!(fixed, [[true; 6]; 40]);
    assert!((model.materials[0].density - 7850.0).abs() < 1e-9);
    assert_eq!(model.materials[0].youngs_modulus, 2.1e11);
}

#[test]
fn deck_b_of_solids_has_the_positions_mass_and_loads_of_the_reference() {
    check_against_reference("B");
    let statics = deck("deckB_101").model;
    let mut modes = deck("deckB_103").model;
    assert_eq!(statics.constraints.len(), 2);
    assert!(modes.loads.is_empty(), "the deck of modes selects no load");
    modes.loads = statics.loads.clone();
    assert_eq!(statics, modes);
}

#[test]
fn broken_decks_are_rejected_at_the_line_of_the_defect() {
    for (name, line, words) in [
        ("broken1", 428, ["CQUAD4 100", "GRID 99999"]),
        ("broken3", 187, ["CHEXA 100 has 6 grid points", "needs 8 or 20"]),
    ] {
        let error = read_nastran(&format!("nastran/{name}.bdf"), &OPTIONS, &mut open_data).unwrap_err();
        assert_eq!(error.line, line, "{error}");
        assert!(words.iter().all(|word| error.message.contains(word)), "{error}");
    }
}
