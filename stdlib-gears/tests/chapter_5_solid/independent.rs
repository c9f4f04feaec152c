//! The pair compared with independent three-dimensional finite-element models, and with the plane
//! model where both are equivalent.

use super::pair::{AT_HIGHEST, AT_LOWEST, CHAPTER_5, PLAIN, Pair, Values, reference};
use calyx_runtime::scene::StructureOptions;

fn near(name: &str, found: f64, expected: f64, tolerance: f64) {
    let error = found / expected - 1.0;
    assert!(error.abs() < tolerance, "{name}: {found} for {expected}, {error:+.4}");
}

#[test]
fn root_stress_and_transmission_error_agree_with_independent_models() {
    let reference = reference();
    for (name, pair) in [("no_modification", PLAIN), ("tip_relief_and_crown", CHAPTER_5)] {
        let expected = &reference["independent"][name];
        let values = pair.solve("fineroot", StructureOptions::default(), &[AT_LOWEST, 9.0, AT_HIGHEST]);
        for (member, key) in ["max_root_stress_pinion", "max_root_stress_gear"].into_iter().enumerate() {
            let found = values.iter().map(|v| v.root_stress[member]).fold(0.0, f64::max);
            near(key, found, expected[key].as_f64().expect("a stress"), 0.01);
        }
        if let Some(range) = expected["te_min_max_inch"].as_array() {
            // Largest where the relieved gear begins to carry alone.
            let largest = values.iter().map(|v| v.transmission_error).fold(0.0, f64::max);
            near("largest transmission error", largest, range[1].as_f64().expect("an error"), 0.01);
        }
    }
}

#[test]
fn crowned_flanks_press_as_independent_models_say() {
    let reference = &reference()["crowned_0.0003_pressure"];
    let pair = Pair { relief: 0.0, crown: 0.0003, ..CHAPTER_5 };
    let values =
        pair.solve("fineroot", StructureOptions::default(), &[reference["roll"].as_f64().expect("a roll")]);
    let expected = reference["independent_finite_element"].as_f64().expect("a pressure");
    near("pressure", values[0].contact_pressure, expected, 0.02);
}

/// With Poisson's ratio zero nothing bulges at the side faces, and every section of an unmodified
/// spur pair is in plane strain.
#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn without_transverse_contraction_a_solid_spur_pair_equals_the_plane_one() {
    let pair = Pair { poissons_ratio: 0.0, ..PLAIN };
    let rolls = [AT_LOWEST, 20.0, AT_HIGHEST];
    let [plane, space] =
        ["plane", "fineroot"].map(|fidelity| pair.solve(fidelity, StructureOptions::default(), &rolls));
    let largest =
        |values: &[Values], member: usize| values.iter().map(|v| v.root_stress[member]).fold(0.0, f64::max);
    for (member, name) in ["pinion", "gear"].into_iter().enumerate() {
        // The meshes differ: each is within 0.3 % of its limit.
        near(name, largest(&space, member), largest(&plane, member), 0.005);
    }
    // The displacement of a bearing is force over stiffness in both models.
    let sprung = Pair { bearing: Some(2e8), ..pair };
    let [plane_sprung, space_sprung] =
        ["plane", "fineroot"].map(|fidelity| sprung.solve(fidelity, StructureOptions::default(), &rolls));
    for k in 0..rolls.len() {
        let [in_plane, three_dimensional] = [(&plane_sprung, &plane), (&space_sprung, &space)]
            .map(|(sprung, constrained)| sprung[k].transmission_error - constrained[k].transmission_error);
        near("what the bearing gives", three_dimensional, in_plane, 1e-6);
        near("mesh stiffness on it", space_sprung[k].mesh_stiffness, plane_sprung[k].mesh_stiffness, 0.006);
    }
    for (plane, space) in plane.iter().zip(&space) {
        near("transmission error", space.transmission_error, plane.transmission_error, 0.002);
        near("mesh stiffness", space.mesh_stiffness, plane.mesh_stiffness, 0.006);
        // The largest pressure along the face: it is sensitive to errors of the free side faces and
        // of the polynomials along the face.
        near("pressure", space.contact_pressure, plane.contact_pressure, 0.005);
    }
}
