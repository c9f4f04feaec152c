//! Component modes of gears: they are consistent with the static compliance, for every support and
//! flank.

use calyx_gears::blank::{GearBlank, Rim, SplineSupport};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::resources::Resources;
use calyx_runtime::scene::{Prototype, StructureOptions};
use calyx_runtime::structure::{BodyModes, BoreSupport, Chart, Structure};
use std::sync::Arc;

const MODULE: f64 = 4e-3;
const TEETH: u32 = 24;
const FREE: BoreSupport = BoreSupport::Means { harmonics: None, degree: 0 };
const HIGHEST: f64 = 1.0e6;

fn blank(support: BoreSupport) -> GearBlank {
    let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    let blank = GearBlank::standard(TEETH, rack);
    let root = blank.root_diameter;
    let rim = Rim::new(root - MODULE, root - 6.0 * MODULE).expect("a rim").supported_by(support);
    blank.face_width(5.0 * MODULE).rim(rim)
}

fn options() -> StructureOptions {
    StructureOptions { order: 2, ..StructureOptions::default() }
}

fn modes(gear: &GearPrototype) -> Arc<BodyModes> {
    Resources::default().modes(gear, &options(), HIGHEST).expect("modes").expect("a gear has some")
}

fn structure(gear: &GearPrototype) -> Arc<dyn Structure> {
    let shared = gear.build(&options(), &Interrupt::never()).expect("a structure");
    gear.shape(shared, &options()).expect("modified flanks")
}

/// Compares the displacements of flanks by a force on one of them, from the static compliance and
/// from the modes. Returns the largest difference relative to the largest displacement.
fn worst_difference(gear: &GearPrototype) -> f64 {
    let (modes, structure) = (modes(gear), structure(gear));
    let length = structure.profile(0).length();
    let s = [0.3 * length, 0.6 * length];
    let load = Chart { tooth: 0, surface: 0 };
    let of_load = modes.displacements(load, &s);
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for observe in
        [(0, 1), (1, 0), (1, 1), (3, 0), (TEETH - 1, 1)].map(|(tooth, surface)| Chart { tooth, surface })
    {
        let mut block = vec![0.0; 4];
        structure.add_compliance(observe, &s, load, &s, &mut block);
        let shapes = modes.displacements(observe, &s);
        for (k, expected) in block.into_iter().enumerate() {
            let sum: f64 = (0..modes.count())
                .map(|mode| shapes[(k / 2, mode)] * of_load[(k % 2, mode)] / modes.frequencies[mode].powi(2))
                .sum();
            worst = worst.max((sum - expected).abs());
            largest = largest.max(expected.abs());
        }
    }
    worst / largest
}

#[test]
fn modes_reproduce_the_static_compliance() {
    for support in [FREE, BoreSupport::Means { harmonics: Some(4), degree: 0 }] {
        let gear = blank(support).cut().expect("a gear");
        let difference = worst_difference(&gear);
        assert!(difference < 0.05, "{support:?}: {difference}");
    }
}

#[test]
fn modes_reproduce_the_static_compliance_of_a_relieved_flank() {
    let relief = Modification::tip_relief(0.02e-3, 28_f64.to_radians(), ReliefShape::Quadratic);
    let gear = blank(BoreSupport::Rigid).modified(relief).cut().expect("a gear");
    let difference = worst_difference(&gear);
    assert!(difference < 0.05, "{difference}");
}

#[test]
fn gears_without_component_modes_are_refused() {
    let refused = |gear: Arc<GearPrototype>| {
        Resources::default().modes(gear.as_ref(), &options(), HIGHEST).err().expect("refused").code
    };
    let free = blank(BoreSupport::Rigid);
    let splined = free.rim.clone().splined(&SplineSupport::new(7)).expect("a splined rim");
    assert_eq!(refused(free.clone().rim(splined).cut().expect("a gear")), "E0759");
    let helix = Helix::new(15_f64.to_radians(), Hand::Right).expect("a helix");
    let helical = GearBlank { helix, ..free };
    assert_eq!(refused(helical.cut().expect("a gear")), "E0623");
}
