//! Tests of settings overrides: results are bitwise equal to those of a model with the same
//! settings, `run.json` records them, and invalid ones are rejected by name.

use calyx::{Engine, Instance, Module, Override, Results};
use std::path::Path;

fn model(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples").join(name);
    std::fs::read_to_string(path).expect("the example is there")
}

fn instance(text: &str) -> Instance {
    Module::from_text(&Engine::default(), "model.cx", text).expect("it compiles").instantiate()
}

fn overrides(all: &[(&str, &str)]) -> Override {
    let mut overrides = Override::default();
    all.iter().for_each(|(name, text)| overrides.set(name, text).expect("a setting in its range"));
    overrides
}

/// Returns the bits of all values of all rows.
fn bits(results: &Results) -> Vec<Vec<u64>> {
    let analysis = results.analysis().expect("it analyses");
    let row = |row: &calyx_runtime::results::StepRow| {
        std::iter::once(row.position.time)
            .chain(row.outputs.iter().map(|o| o.value))
            .map(f64::to_bits)
            .collect()
    };
    analysis.rows.iter().map(row).collect()
}

#[test]
fn overrides_give_the_results_of_a_model_with_the_same_settings() {
    let text = model("spur_pair.cx");
    // The model requests a 3-D mesh; the override replaces it by a plane one.
    let mut given = instance(&text);
    given.set("steps", 3).unwrap();
    given.override_analysis(overrides(&[("fidelity", "plane"), ("contact_cells", "7")]));
    let said = text.replace(
        "tip_corner_contact = tip_corner_contact",
        "tip_corner_contact = tip_corner_contact, contact_cells = 7",
    );
    assert_ne!(said, text);
    let mut said = instance(&said);
    said.set("steps", 3).unwrap();
    said.set("fidelity", "plane").unwrap();
    let (given, said) = (given.solve().unwrap(), said.solve().unwrap());
    assert_eq!(bits(&given), bits(&said));
    assert_eq!(given.analysis().unwrap().plan.fidelity.name(), "plane");
}

#[test]
fn meshes_follow_what_is_given() {
    let text = model("spur_pair.cx");
    let options = |given: Override| {
        let mut instance = instance(&text);
        instance.set("steps", 4).unwrap();
        instance.override_analysis(Override { every: Some(2), ..given });
        let results = instance.solve().unwrap();
        let analysis = results.analysis().unwrap();
        (analysis.plan.bodies[0].options, analysis.rows.len())
    };
    let all = [("fidelity", "plane"), ("refinement", "0.5"), ("element_order", "2")];
    let (options, rows) = options(overrides(&all));
    assert_eq!((options.refinement, options.order, options.face_elements), (0.5, 2, None));
    // Two of three uniform positions, since the first one coincides with the start of contact, and
    // the four characteristic points.
    assert_eq!(rows, 6);
}

#[test]
fn what_cannot_be_is_refused_with_what_was_given() {
    let mut helical = instance(&model("helical_pair.cx"));
    helical.override_analysis(overrides(&[("fidelity", "plane")]));
    let error = helical.solve().err().expect("helical teeth have no section").to_string();
    assert!(error.contains("helical"), "{error}");
    let mut dynamic = instance(&model("spur_dynamics.cx"));
    dynamic.override_analysis(overrides(&[("position_stride", "2")]));
    let error = dynamic.solve().err().expect("steps follow each other").to_string();
    assert!(error.starts_with("[E0795]") && error.contains("no step can be left out"), "{error}");
}
