//! Rims and their supports: thin rims on free bores, and the reactions of the supports of pairs.

use crate::common::built;
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, RadialFit, Rim, SplineSupport};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    MaxRootCompression, Observable, SplineToothLoad, SupportForce, SupportMoment, TransmissionError,
};
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::{
    Body, BodyId, Component, Fidelity, PairId, Prototype, Scene, StructureOptions, Template,
};
use calyx_runtime::structure::{BoreSupport, Chart, SurfaceLoad};
use std::f64::consts::TAU;
use std::sync::Arc;

const MODULE: f64 = 4e-3;
const TEETH: u32 = 40;
const FREE: BoreSupport = BoreSupport::Means { harmonics: None, degree: 1 };

/// Gear on a rim whose thickness below the spaces is this number of tooth heights (backup ratio).
fn gear(teeth: u32, backup: f64, support: BoreSupport) -> Arc<GearPrototype> {
    let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    let blank = GearBlank::standard(teeth, rack);
    let (root, height) = (0.5 * blank.root_diameter, 2.25 * MODULE);
    let bore_radius = root - backup * height;
    let ring = root - 0.5 * MODULE.min(backup * height);
    let rim = Rim::new(2.0 * ring, 2.0 * bore_radius).expect("a rim").supported_by(support);
    blank.face_width(5.0 * MODULE).rim(rim).cut().expect("a gear")
}

/// Fillet stresses over all positions of a tooth relative to a force high on the flank of another
/// tooth, in two dimensions: the largest tension, the largest compression, and the largest range at
/// any point.
fn root_stresses(backup: f64, support: BoreSupport, options: &StructureOptions) -> [f64; 3] {
    let gear = gear(TEETH, backup, support);
    let structure = gear.build(options, &Interrupt::never()).expect("a structure");
    let s = 0.8 * gear.flanks()[0].length();
    let load = [SurfaceLoad { chart: Chart { tooth: 0, surface: 0 }, s, force: 1e5 }];
    let mut largest = [0.0_f64; 3];
    for surface in 0..2 {
        let around: Vec<_> = (0..TEETH).map(|tooth| structure.stresses(tooth, surface, &load)).collect();
        for place in 0..around[0].len() {
            let at = || around.iter().map(|stresses| stresses[place].1);
            let (most, least) = (at().fold(0.0, f64::max), at().fold(0.0, f64::min));
            for (largest, value) in largest.iter_mut().zip([most, -least, most - least]) {
                *largest = largest.max(value);
            }
        }
    }
    largest
}

/// The rim thickness factor of AGMA 2001: thick rims have no effect, and for thin rims the stress
/// range of a tooth grows faster the thinner the rim is. A ring flattens under the force, which
/// compresses the roots there: the compression grows under the force, and the tension where the
/// ring bends the other way. On a rigid bore there is no such effect.
#[test]
fn root_stress_grows_as_a_free_rim_gets_thin() {
    let options = StructureOptions::default();
    let thick = root_stresses(3.0, FREE, &options);
    let ratios = [0.5, 0.7, 1.0, 1.5, 2.0];
    let factors = |support: BoreSupport| {
        ratios.map(|backup| {
            let found = root_stresses(backup, support, &options);
            [0, 1, 2].map(|kind| found[kind] / thick[kind])
        })
    };
    let (free, rigid) = (factors(FREE), factors(BoreSupport::Rigid));
    println!("backup ratio: tension, compression, range on a free bore; on a rigid one");
    for ((ratio, free), rigid) in ratios.iter().zip(&free).zip(&rigid) {
        println!("{ratio}: {free:.3?} {rigid:.3?}");
    }
    let ranges = free.map(|[_, _, range]| range);
    assert!(ranges.windows(2).all(|pair| pair[0] > pair[1]), "{ranges:?}");
    assert!(ranges[0] > 1.4 && (1.0..1.2).contains(&ranges[4]), "{ranges:?}");
    assert!(free[0][1] > 1.4, "compression grows: {free:?}");
    assert!(rigid.iter().all(|[_, _, range]| *range < 1.05), "{rigid:?}");
    // A finer mesh agrees.
    let finer = StructureOptions { refinement: 2.0, ..options };
    let error = root_stresses(0.5, FREE, &finer)[2] / (ranges[0] * thick[2]) - 1.0;
    println!("the finer mesh: {error:.1e}");
    assert!(error.abs() < 0.02, "{error:.1e}");
}

/// The local compliance of a tooth on a thick rim does not depend on the support of the bore.
#[test]
fn a_thick_rim_makes_the_bore_support_irrelevant() {
    let options = StructureOptions::default();
    let [free, rigid] = [FREE, BoreSupport::Rigid].map(|support| root_stresses(4.0, support, &options)[0]);
    assert!((free / rigid - 1.0).abs() < 0.02, "{free:e}, {rigid:e}");
}

/// A pair whose second gear has a thin rim with this support.
fn pair(support: BoreSupport) -> Scene {
    let mut scene = Scene::default();
    let gears = [gear(20, 1.0, BoreSupport::Rigid), gear(TEETH, 0.8, support)];
    let speed = TAU;
    let motion = SteadyRotation { origin: [0.0; 2], start: 0.0, speed };
    let moment = Wrench::of_moment([0.0, 0.0, 200.0]);
    let first = Body::new("first", gears[0].clone(), motion).free_in(&[Component::ThetaZ]).loaded(moment);
    let first = add_body(&mut scene, first).expect("a body");
    let origin = [0.5 * MODULE * 60.0 * (1.0 + 1e-3), 0.0];
    let motion = SteadyRotation { origin, start: 0.0, speed: -0.5 * speed };
    let second = add_body(&mut scene, Body::new("second", gears[1].clone(), motion)).expect("a body");
    let options = MeshOptions { half_cells: Some(6), half_slices: 3, ..MeshOptions::default() };
    mesh(&mut scene, first, second, &options).expect("they mesh");
    scene
}

/// Reaction forces and moment of the support of the second gear of [`pair`], its transmission
/// error, and its root compression.
fn solved(support: BoreSupport, fidelity: Fidelity) -> ([f64; 3], f64, f64) {
    let coarse = StructureOptions {
        refinement: 0.5,
        face_elements: Some(2),
        axial_order: Some(2),
        ..StructureOptions::default()
    };
    let mut scene = pair(support);
    scene.add_observable(MaxRootCompression(BodyId(1)));
    let system = built(&scene, fidelity, coarse);
    let mesh = scene.pairs[0].mesh.clone().expect("a mesh");
    let step = system.solve(mesh.start + 0.8 * mesh.period).expect("it can be solved");
    assert!(step.certificate.largest() <= 1e-11, "{:?}", step.certificate);
    let value = |observable: &dyn Observable| system.value(&step, observable).value;
    let supports = [
        value(&SupportForce(BodyId(1), 0)),
        value(&SupportForce(BodyId(1), 1)),
        value(&SupportMoment(BodyId(1), 2)),
    ];
    if let BoreSupport::SplineTeeth(spline_teeth) = support {
        // About the gear's axis the reaction equals that of its support.
        let radius = gear(TEETH, 0.8, support).rim.fixed_radius;
        let around = |spline_tooth| value(&SplineToothLoad { body: BodyId(1), spline_tooth, radial: false });
        let torque = radius * (0..u32::from(spline_teeth.count)).map(around).sum::<f64>();
        println!("{} spline teeth carry {torque} of {} N m", spline_teeth.count, supports[2]);
        assert!((torque / supports[2] - 1.0).abs() < 1e-3);
    }
    (supports, value(&TransmissionError(PairId(0))), value(&MaxRootCompression(BodyId(1))))
}

fn assert_equal_reactions(fidelity: Fidelity, answers: &[([f64; 3], f64, f64)]) {
    for (supports, ..) in &answers[1..] {
        for (found, expected) in supports.iter().zip(answers[0].0) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{fidelity:?}: {found:e} {expected:e}");
        }
    }
}

/// A mean constraint of the bore has the same reactions as a rigid support: the whole load. The
/// compliance of the gear increases.
#[test]
fn all_bore_supports_have_the_same_reactions() {
    for fidelity in [Fidelity::Plane, Fidelity::Solid(Template::Medium)] {
        let answers = [BoreSupport::Rigid, BoreSupport::Means { harmonics: Some(2), degree: 1 }, FREE]
            .map(|support| solved(support, fidelity));
        assert_equal_reactions(fidelity, &answers);
        let errors: Vec<f64> = answers.iter().map(|answer| answer.1.abs()).collect();
        let stresses: Vec<f64> = answers.iter().map(|answer| answer.2).collect();
        println!("{fidelity:?}: transmission errors {errors:?}, root compressions {stresses:?}");
        assert!(errors[0] < errors[1] && errors[1] < errors[2], "{fidelity:?}: {errors:?}");
        assert!(stresses[0] < stresses[2], "{fidelity:?}: {stresses:?}");
    }
}

fn splined(spline: &SplineSupport, backup: f64) -> BoreSupport {
    let rigid = gear(TEETH, backup, BoreSupport::Rigid);
    rigid.rim.clone().splined(spline).expect("spline teeth").support
}

/// Spline teeth carry the whole load, whatever the ratio of their number to that of the gear teeth.
/// The force of each is larger if there are fewer, if they are softer, or if they constrain the
/// bore circumferentially only.
#[test]
fn spline_teeth_carry_the_whole_load() {
    let seven = SplineSupport::new(7);
    let soft = Some(5e9);
    let diameter = RadialFit { stiffness: None };
    let ways = [
        SplineSupport { spline_teeth: 26, radial: Some(diameter), ..seven },
        SplineSupport { radial: Some(diameter), ..seven },
        seven,
        SplineSupport { stiffness: soft, ..seven },
    ];
    for fidelity in [Fidelity::Plane, Fidelity::Solid(Template::Medium)] {
        let supports = [BoreSupport::Rigid].into_iter().chain(ways.iter().map(|spline| splined(spline, 0.8)));
        let answers: Vec<_> = supports.map(|support| solved(support, fidelity)).collect();
        assert_equal_reactions(fidelity, &answers);
        let errors: Vec<f64> = answers.iter().map(|answer| answer.1.abs()).collect();
        println!("{fidelity:?}: transmission errors {errors:?}");
        assert!(errors.windows(2).all(|pair| pair[0] < pair[1]), "{fidelity:?}: {errors:?}");
    }
}

/// The coarsest mesh of a gear resolves all harmonics that the gear permits.
#[test]
fn the_coarsest_mesh_resolves_the_spline_teeth_that_a_gear_may_have() {
    let coarse = StructureOptions {
        refinement: 0.5,
        face_elements: Some(1),
        axial_order: Some(2),
        ..StructureOptions::default()
    };
    let spline = SplineSupport { axial_order: 2, ..SplineSupport::new(26) };
    let rim = gear(20, 1.0, BoreSupport::Rigid).rim.clone();
    let gear = gear(20, 1.0, rim.splined(&spline).expect("spline teeth").support);
    gear.build(&coarse, &Interrupt::never()).expect("a plane structure");
    gear.build_solid(&coarse, &Interrupt::never()).expect("a solid structure");
    let found = gear
        .rim
        .clone()
        .supported_by(BoreSupport::Rigid)
        .splined(&SplineSupport { spline_teeth: 27, ..spline })
        .expect("spline teeth");
    let blank =
        GearBlank::standard(20, Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack"));
    let refused =
        blank.rim(Rim { support: found.support, ..gear.rim.clone() }).cut().err().expect("too many");
    assert!(format!("{refused:?}").contains("E0656"), "{refused:?}");
}

/// Structures with different supports have different keys, and a web separates the plane model from
/// its bore.
#[test]
fn the_bore_support_is_part_of_the_structure_key() {
    let options = StructureOptions::default();
    let ways = [
        BoreSupport::Rigid,
        FREE,
        BoreSupport::Means { harmonics: Some(3), degree: 1 },
        BoreSupport::Means { harmonics: Some(3), degree: 2 },
        splined(&SplineSupport::new(9), 1.0),
        splined(&SplineSupport { first: 0.1, ..SplineSupport::new(9) }, 1.0),
        splined(&SplineSupport { axial_order: 0, first: 0.1, ..SplineSupport::new(9) }, 1.0),
    ];
    let gears = ways.map(|support| gear(TEETH, 1.0, support));
    for (index, one) in gears.iter().enumerate() {
        for other in &gears[..index] {
            assert!(one.solid_key(&options) != other.solid_key(&options));
        }
    }
    let [rigid, free, third, fourth, spline_teeth, turned, mean] = gears.map(|gear| gear.key(&options));
    assert!(spline_teeth != free && spline_teeth != turned && turned == mean);
    assert!(rigid != free && free != third && rigid != third);
    assert!(third == fourth, "a plane model has no axial order");
    // Only the contact problem uses the clearance and the stiffness of the spline teeth.
    let with_clearance = [(50e-6, None), (80e-6, Some(1e9))].map(|(clearance, stiffness)| {
        gear(TEETH, 1.0, splined(&SplineSupport { clearance, stiffness, ..SplineSupport::new(9) }, 1.0))
            .key(&options)
    });
    assert!(
        with_clearance[0] == with_clearance[1]
            && with_clearance[0] != spline_teeth
            && with_clearance[0] != free
    );
}
