//! The pair far from its published parameters: every case is in equilibrium to rounding and follows
//! the expected trends of mechanics.

use super::pair::{AT_HIGHEST, CHAPTER_5, PLAIN, Pair, Values};
use calyx_runtime::scene::StructureOptions;

/// Solves the position just before the next pair enters, on the coarsest template.
fn solve(pair: Pair, elements: usize, order: usize) -> Values {
    let options = StructureOptions {
        face_elements: Some(elements),
        axial_order: Some(order),
        ..StructureOptions::default()
    };
    let values = pair.solve("medium", options, &[AT_HIGHEST])[0];
    let Values { transmission_error, mesh_stiffness, contact_pressure, root_stress: [pinion, wheel], .. } =
        values;
    for value in [transmission_error, mesh_stiffness, contact_pressure, pinion, wheel] {
        assert!(
            value > 0.0 && value.is_finite(),
            "{pair:?}, {elements} elements of order {order}: {values:?}"
        );
    }
    assert!(values.residual < 1e-10, "{pair:?}, {elements} elements of order {order}: {:e}", values.residual);
    values
}

/// The transmission error grows less than the torque, because the contact spreads; root stress even
/// less where crowns are flattened.
#[test]
fn from_one_to_five_thousand() {
    let torques = [1.0, 10.0, 100.0, 1000.0, 5000.0];
    let crowned = torques.map(|torque| solve(Pair { torque, ..CHAPTER_5 }, 2, 3));
    for (pair, torque) in crowned.windows(2).zip(torques.windows(2)) {
        let by_torque = |of: fn(&Values) -> f64| [of(&pair[0]) / torque[0], of(&pair[1]) / torque[1]];
        let falls = |[before, after]: [f64; 2]| after < before && after > 0.0;
        assert!(falls(by_torque(|v| v.root_stress[0])), "{torque:?}: {pair:?}");
        assert!(falls(by_torque(|v| v.root_stress[1])), "{torque:?}: {pair:?}");
        assert!(falls(by_torque(|v| v.contact_pressure)), "{torque:?}: {pair:?}");
        assert!(pair[0].mesh_stiffness < pair[1].mesh_stiffness, "{torque:?}: {pair:?}");
    }
    // Without crown and relief the pressure is proportional to the square root of the load.
    let plain = [10.0, 1000.0].map(|torque| solve(Pair { torque, ..PLAIN }, 2, 3).contact_pressure);
    assert!((plain[1] / plain[0] / 10.0 - 1.0).abs() < 0.01, "{plain:?}");
}

#[test]
fn deep_modifications_carry_on_less_of_the_flanks() {
    let usual = solve(CHAPTER_5, 2, 3);
    let crowned = solve(Pair { crown: 0.005, ..CHAPTER_5 }, 2, 3);
    assert!(crowned.contact_pressure > 1.5 * usual.contact_pressure, "{crowned:?}");
    assert!(crowned.mesh_stiffness < usual.mesh_stiffness, "{crowned:?}");
    assert!(crowned.root_stress[0] > usual.root_stress[0], "{crowned:?}");
    // At this position contact is below the start of the relief.
    let relieved = solve(Pair { relief: 0.004, ..CHAPTER_5 }, 2, 3);
    assert!((relieved.root_stress[0] / usual.root_stress[0] - 1.0).abs() < 0.02, "{relieved:?}");
}

/// Faces as narrow as a disc or as wide as a shaft: at the same line load the plane part of the
/// result is unchanged.
#[test]
fn narrow_and_wide_faces() {
    let at = |face_width: f64, elements, order| {
        solve(Pair { face_width, torque: 1000.0 * face_width, ..PLAIN }, elements, order)
    };
    let [narrow, usual, wide] = [at(0.05, 1, 2), at(1.0, 2, 3), at(6.0, 2, 5)];
    for values in [narrow, wide] {
        let change = values.transmission_error / usual.transmission_error - 1.0;
        // Plane stress and plane strain differ by nine percent.
        assert!(change.abs() < 0.12, "{change}: {values:?}");
        let change = values.root_stress[0] / usual.root_stress[0] - 1.0;
        assert!(change.abs() < 0.06, "{change}: {values:?}");
    }
    assert!(narrow.transmission_error > wide.transmission_error, "plane stress is softer");
}

#[test]
fn rims_from_thin_to_solid() {
    let errors = [[1.39, 3.39], [1.20, 2.40], [0.3, 0.4]]
        .map(|bores| solve(Pair { bores, ..PLAIN }, 1, 3).transmission_error);
    // A rigid bore adds the more stiffness the nearer it is to the teeth.
    assert!(errors.is_sorted(), "{errors:?}");
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn contraction_from_none_to_nearly_all() {
    let ratios = [0.0, 0.3, 0.49];
    let errors =
        ratios.map(|poissons_ratio| solve(Pair { poissons_ratio, ..PLAIN }, 1, 3).transmission_error);
    // Bending in plane strain is proportional to 1 - nu^2, which falls by 9 and 16 %; the ends are
    // free, and shear is proportional to 1 + nu.
    assert!(errors.windows(2).all(|pair| (pair[1] / pair[0] - 1.0).abs() < 0.16), "{errors:?}");
}

/// The tip of the second tool is fully rounded: its tooth has no tip land.
#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn sharp_and_round_tools() {
    for tip_radius in [0.004, 0.0497] {
        solve(Pair { tip_radius, ..CHAPTER_5 }, 1, 3);
    }
}

#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn from_one_linear_element_along_the_face_to_one_of_order_seven() {
    let best = solve(CHAPTER_5, 4, 3).root_stress[0];
    for (elements, order, bound) in [(1, 1, 0.4), (1, 7, 0.01), (8, 1, 0.03)] {
        let error = solve(CHAPTER_5, elements, order).root_stress[0] / best - 1.0;
        assert!(error.abs() < bound, "{elements} of order {order}: {error}");
    }
}
