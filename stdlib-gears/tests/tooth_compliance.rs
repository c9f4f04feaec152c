//! What the meshes are for: compliance of a tooth and stress in its fillet, converging under refinement.

mod common;

use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::sector_mesh::{Refinement, sector_mesh};
use calyx_runtime::fe::PlaneModel;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::profile::Profile;
use calyx_runtime::structure::{
    Chart, ElasticStructure, RingSource, SplitOptions, Structure, SurfaceLoad, SurfaceSource,
};
use common::{INCH, chapter_5};
use std::sync::Arc;

const PSI: f64 = 6894.757293168361;

/// Pinion of the report's chapter 5: compliance at two points of the flank and largest fillet stress under its load at
/// 24.3 degrees of roll.
fn pinion(refinement: &Refinement) -> ([f64; 3], f64) {
    let gear = chapter_5(20);
    let flanks = [Side::CounterClockwise, Side::Clockwise]
        .map(|side| Arc::new(Flank::new(&gear, &[], side).expect("a flank")));
    let mesh = sector_mesh(&gear, flanks.clone(), 0.6 * INCH, refinement).expect("a mesh");
    let steel = Material { youngs_modulus: 3e7 * PSI, poissons_ratio: 0.3, density: 7850.0 };
    let model = PlaneModel::new(mesh, steel, Plane::Strain);
    let surfaces = [0, 1].map(|surface| SurfaceSource {
        profile: flanks[surface].clone() as Arc<dyn Profile>,
        chain: format!("flank_{surface}"),
        sharp: [false, true],
        stress_chain: Some(format!("fillet_{surface}")),
        stress_places_per_edge: 4,
    });
    let ring = RingSource { sectors: 20, cuts: ["cut_right", "cut_left"], bore: "bore", coupled: 2 };
    let structure =
        ElasticStructure::ring(&model, &ring, &surfaces, &SplitOptions::default()).expect("a structure");
    let chart = Chart { tooth: 0, surface: 0 };
    let at = |degrees: f64| flanks[0].s_at_roll(degrees.to_radians());
    let (low, high) = (at(12.0), at(28.0));
    let mut block = [0.0; 4];
    structure.add_compliance(chart, &[low, high], chart, &[low, high], &mut block);
    // Load share one: torque over base radius, over a face of one inch.
    let load = SurfaceLoad { chart, s: at(24.3), force: 1064.178 * 4.4482216152605 / INCH };
    let stresses = structure.stresses(0, 0, &[load]);
    let largest = stresses.iter().map(|(_, stress)| *stress).fold(f64::NEG_INFINITY, f64::max);
    ([block[0], block[1], block[3]], largest / PSI)
}

#[test]
fn compliance_and_fillet_stress_converge() {
    let (coarse, coarse_stress) = pinion(&Refinement::COARSE);
    let (medium, medium_stress) = pinion(&Refinement::MEDIUM);
    // The medium mesh is within 2e-4 and 3e-3 of the fine one.
    for k in 0..3 {
        assert!((coarse[k] - medium[k]).abs() < 5e-3 * medium[k].abs(), "{coarse:?} against {medium:?}");
    }
    assert!(
        (coarse_stress - medium_stress).abs() < 1.5e-2 * medium_stress,
        "{coarse_stress}, {medium_stress}"
    );
    // Finite elements of a general program: 32968 psi at this roll (where the load is spread over the contact).
    assert!((medium_stress - 32968.0).abs() < 0.01 * 32968.0, "{medium_stress}");
}
