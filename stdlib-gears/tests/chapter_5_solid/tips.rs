//! Teeth without relief at the ends of the path of contact: patches end at tip edges or lie on
//! them. With Poisson's ratio zero the plane model provides the reference, on a mesh of its own
//! that is much finer there.

use super::pair::{PLAIN, Pair};
use calyx_runtime::scene::StructureOptions;

/// Roll angles at which a pair enters, the leaving pair is away from the tip edge, reaches it and
/// has left the nominal path, and the next pair enters early.
const ROLLS: [f64; 5] = [6.9, 14.8, 15.6, 15.9, 24.6];

/// Hertzian line pressure where one pair begins to carry alone, psi, at roll 15.68 deg
/// (`hertz_line_no_modification_psi` of the data).
const HERTZ: f64 = 170_224.0;

#[test]
fn on_and_beside_tip_edges_a_solid_spur_pair_equals_the_plane_one() {
    for tip_corner_contact in [false, true] {
        let pair = Pair { poissons_ratio: 0.0, tip_corner_contact, ..PLAIN };
        let [plane, space] =
            ["plane", "medium"].map(|fidelity| pair.solve(fidelity, StructureOptions::default(), &ROLLS));
        for ((plane, space), roll) in plane.iter().zip(&space).zip(ROLLS) {
            let off = |found: f64, expected: f64| (found / expected - 1.0).abs();
            let at = format!("roll {roll}, tip corner contact {tip_corner_contact}: {space:?} for {plane:?}");
            // The elements of the template are stiffer than a tip.
            assert!(off(space.transmission_error, plane.transmission_error) < 0.015, "{at}");
            assert!(off(space.contact_pressure, plane.contact_pressure) < 0.01, "{at}");
            assert_eq!(space.edge_pressure > 0.0, plane.edge_pressure > 0.0, "{at}");
            // On a rounded edge the pressure is resolved; where a flank is cut off, it grows as the
            // cells are refined.
            let resolved = tip_corner_contact && plane.edge_pressure > 3.0 * plane.contact_pressure;
            assert!(!resolved || off(space.edge_pressure, plane.edge_pressure) < 0.05, "{at}");
        }
    }
}

/// With lateral contraction all polynomials along the face contribute: the compliance matrix near
/// the tip edge must remain that of an elastic body (positive definite).
#[test]
fn teeth_without_relief_or_crown_run_up_to_their_tips() {
    for tip_corner_contact in [false, true] {
        let pair = Pair { tip_corner_contact, ..PLAIN };
        let values = pair.solve("medium", StructureOptions::default(), &ROLLS);
        for (values, roll) in values.iter().zip(ROLLS) {
            // Alone or with a second pair, on flanks or on edges: loads are carried, and no cells
            // have opposing forces.
            assert!(values.contact_pressure < 1.02 * HERTZ, "{roll}: {values:?}");
            assert!(
                values.root_stress.iter().all(|&stress| stress > 0.0 && stress < 4e4),
                "{roll}: {values:?}"
            );
        }
    }
}
