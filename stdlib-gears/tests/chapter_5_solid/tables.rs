//! Tables 5.10 to 5.13 of the report: root stress by tip radius of the rack, tooth thickness,
//! number of elements along the face, and their order. The column of its finest template is not
//! converged; the column before it is the reference.

use super::pair::{AT_HIGHEST, AT_LOWEST, CHAPTER_5, Pair, reference};
use calyx_runtime::scene::StructureOptions;

/// First column of a table with the stress of its fineroot column, psi.
fn fineroot(table: &str) -> Vec<[f64; 2]> {
    let reference = reference();
    let number = |row: &serde_json::Value, column: usize| row[column].as_f64().expect("a number");
    reference[table].as_array().expect("rows").iter().map(|row| [number(row, 0), number(row, 2)]).collect()
}

/// Stresses of a table's rows, each within 3 % of the fineroot column.
fn stresses(table: &str, pair: impl Fn(f64) -> Pair) -> Vec<f64> {
    let row = |[value, expected]: [f64; 2]| {
        let stress = pair(value).root_stress("medium", StructureOptions::default());
        let error = stress / expected - 1.0;
        assert!(error.abs() < 0.03, "{table}, {value}: {stress} for {expected}, {error:+.4}");
        stress
    };
    fineroot(table).into_iter().map(row).collect()
}

#[test]
fn root_stress_falls_with_the_tip_radius_as_in_table_5_10() {
    let stresses = stresses("table_5.10_tip_radius", |tip_radius| Pair { tip_radius, ..CHAPTER_5 });
    assert!(stresses.is_sorted_by(|a, b| a > b), "{stresses:?}");
    let ratio = stresses[0] / stresses[stresses.len() - 1];
    assert!((ratio - 1.29).abs() < 0.04, "{ratio}");
}

#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn root_stress_falls_with_the_thickness_of_the_teeth_as_in_table_5_11() {
    let stresses = stresses("table_5.11_tooth_thickness", |thickness| Pair { thickness, ..CHAPTER_5 });
    assert!(stresses.is_sorted_by(|a, b| a > b), "{stresses:?}");
}

#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn root_stress_is_flat_beyond_four_elements_of_order_three_along_the_face() {
    let stress = |face_elements, axial_order| {
        let options = StructureOptions {
            face_elements: Some(face_elements),
            axial_order: Some(axial_order),
            ..StructureOptions::default()
        };
        CHAPTER_5.root_stress("medium", options)
    };
    let start = stress(4, 3);
    for (elements, order) in [(6, 3), (4, 5)] {
        let error = stress(elements, order) / start - 1.0;
        assert!(error.abs() < 0.003, "{elements} elements of order {order}: {error:+.5}");
    }
}

/// Closed forms in slices compared with three-dimensional finite elements, with relief and crown.
#[test]
fn closed_forms_are_near_the_finite_elements() {
    let rolls = [AT_LOWEST, 20.0, AT_HIGHEST];
    let [given, meshed] =
        ["analytic", "medium"].map(|level| CHAPTER_5.solve(level, StructureOptions::default(), &rolls));
    for (given, meshed) in given.iter().zip(&meshed) {
        println!("{given:?}\n{meshed:?}");
        let near = |given: f64, meshed: f64, part: f64| {
            assert!((given - meshed).abs() < part * meshed.abs(), "{given} {meshed}");
        };
        near(given.transmission_error, meshed.transmission_error, 0.05);
        near(given.mesh_stiffness, meshed.mesh_stiffness, 0.05);
        near(given.contact_pressure, meshed.contact_pressure, 0.06);
        near(given.root_stress[0], meshed.root_stress[0], 0.15);
        near(given.root_stress[1], meshed.root_stress[1], 0.15);
    }
}
