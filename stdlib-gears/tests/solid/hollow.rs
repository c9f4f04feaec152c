//! Hollow flanks, which touch at both ends of the face: separate contacts on one contact line.

use super::misaligned::centroid;
use super::pairs::{MODULE, Options};
use crate::common::built;
use calyx_gears::assembly::Misalignment;
use calyx_gears::modification::Modification;
use calyx_runtime::scene::{Fidelity, StructureOptions};

const FACE_WIDTH: f64 = 8.0 * MODULE;
/// Material removed at mid-face, m.
const HOLLOW: f64 = 20e-6;

/// Axial position of the resultant load relative to half the face width, at a misalignment that
/// opens one end of the face by `opening` (m).
fn relative_centroid(opening: f64, torque: f64, half_slices: usize) -> f64 {
    let places: Vec<f64> = (-4..=4).map(|k| f64::from(k) * FACE_WIDTH / 8.0).collect();
    let depth = |z: &f64| HOLLOW * (1.0 - (2.0 * z / FACE_WIDTH).powi(2));
    let depths = places.iter().map(depth).collect();
    let options = Options {
        backed: false,
        torque,
        half_cells: [6, half_slices],
        misalignment: Misalignment { in_action: opening / FACE_WIDTH, off_action: 0.0 },
        modification: Some(Modification::lead_table(places, depths).expect("a table")),
        ..Options::spur()
    };
    let (scene, mesh) = options.scene();
    let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
    // One pair of teeth carries the load.
    let step = system.solve(mesh.start + 0.8 * mesh.period).expect("equilibrium");
    centroid(&system, &step) / (0.5 * FACE_WIDTH)
}

/// The closest approach is at one end of the face. The grid covered this end alone, which carried
/// the whole load.
#[test]
fn both_ends_of_hollow_flanks_carry_the_same_load() {
    for torque in [1.0, 10.0, 100.0] {
        // Rounding decides which end is closer.
        let centroid = relative_centroid(1e-12, torque, 8);
        println!("{torque}: {centroid}");
        assert!(centroid.abs() < 1e-3, "{torque}: {centroid}");
    }
}

/// The farther end touches once the deflection exceeds its gap, although a region between the ends
/// remains open.
#[test]
fn the_farther_end_of_hollow_flanks_touches_under_load() {
    let opening = 4e-6;
    let at = |torque: f64, half_slices: usize| relative_centroid(opening, torque, half_slices).abs();
    let [light, normal, on_finer_grid] = [at(1.0, 8), at(40.0, 8), at(40.0, 16)];
    println!("{light} {normal} {on_finer_grid}");
    assert!(light > 0.9, "{light}");
    assert!(normal < 0.7, "{normal}");
    assert!((normal - on_finer_grid).abs() < 0.03, "{normal} {on_finer_grid}");
    let mirrored = relative_centroid(-opening, 40.0, 8);
    assert!((normal - mirrored.abs()).abs() < 1e-6, "{normal} {mirrored}");
}
