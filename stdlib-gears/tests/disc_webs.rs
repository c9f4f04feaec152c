//! Webs with their own mesh, compared with the same web in the mesh of the teeth, and their
//! additional features.

use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::web::{DiscWeb, Hub};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::scene::{Fidelity, Prototype, StructureOptions};
use calyx_runtime::structure::BoreSupport;
use calyx_runtime::structure::Chart;
use calyx_runtime::structure::solid::{SegmentLoad, SolidStructure, SurfaceSegment};
use std::sync::Arc;

const MODULE: f64 = 4e-3;
const TEETH: u32 = 24;
const WIDTH: f64 = 30e-3;
const THICKNESS: f64 = 9e-3;
const OFFSET: f64 = 4e-3;
const BORE: f64 = 30e-3;

fn ring() -> Rim {
    Rim::new(82e-3, 74e-3).expect("a rim")
}

fn gear(rim: Rim) -> Arc<GearPrototype> {
    let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    GearBlank::standard(TEETH, rack).face_width(WIDTH).rim(rim).cut().expect("a gear")
}

fn on_disc(disc: DiscWeb) -> Rim {
    ring().on_disc(THICKNESS, OFFSET, BORE, disc).expect("a web")
}

fn plain() -> DiscWeb {
    DiscWeb::plain(THICKNESS, OFFSET)
}

/// Options with a mesh as coarse along the face as the test permits.
fn options() -> StructureOptions {
    StructureOptions { face_elements: Some(2), ..StructureOptions::default() }
}

fn built(rim: Rim) -> Arc<dyn SolidStructure> {
    gear(rim).build_solid(&options(), &Interrupt::never()).expect("a structure")
}

/// Displacements of a tooth and its neighbour by loads on the tooth, at mid-face and at both ends
/// of the face, without the half-space's part, m/N; and the largest root stress next to a load high
/// on the flank at one end of the face, Pa/N.
struct Response {
    own: Vec<f64>,
    next: Vec<f64>,
    stress: f64,
}

fn response(structure: &dyn SolidStructure) -> Response {
    let [_, [from, to]] = structure.surface(0).range();
    let [[start, end], _] = structure.surface(0).range();
    let at = |share: f64, along: f64| {
        SurfaceSegment::from([start + share * (end - start), from + along * (to - from)])
    };
    let segments = [at(0.4, 0.1), at(0.4, 0.5), at(0.7, 0.9)];
    let between = |observed: u32| {
        let mut block = vec![0.0; 9];
        let chart = |tooth| Chart { tooth, surface: 0 };
        structure.add_compliance(chart(observed), &segments, chart(0), &segments, &mut block);
        block
    };
    let load = SegmentLoad { chart: Chart { tooth: 0, surface: 0 }, segment: at(0.7, 0.1), force: 1.0 };
    let stresses = structure.stresses(0, 0, &[load]);
    let stress = stresses.iter().map(|stress| stress.principal()[0]).fold(0.0, f64::max);
    Response { own: between(0), next: between(1), stress }
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, value| most.max(value.abs()))
}

fn largest_difference(one: &[f64], other: &[f64]) -> f64 {
    let differences: Vec<f64> = one.iter().zip(other).map(|(a, b)| a - b).collect();
    largest(&differences)
}

/// A web in either form. With more terms the joint converges to the common mesh.
#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn a_joined_web_becomes_the_web_of_the_common_mesh() {
    let common = response(built(ring().on_web(THICKNESS, OFFSET, BORE).expect("a web")).as_ref());
    let scale = largest(&common.own);
    println!(
        "harmonics, degree: compliance of a tooth and of its neighbour, root stress, against the common mesh"
    );
    let off = [(4, 2), (8, 2), (16, 2), (24, 2)].map(|(harmonics, degree)| {
        let joined =
            response(built(on_disc(DiscWeb { harmonics: Some(harmonics), degree, ..plain() })).as_ref());
        let off = [
            largest_difference(&joined.own, &common.own) / scale,
            largest_difference(&joined.next, &common.next) / scale,
            (joined.stress / common.stress - 1.0).abs(),
        ];
        println!("{harmonics}, {degree}: {off:.5?}");
        off
    });
    for pair in off.windows(2) {
        assert!(pair[1][0] < 0.7 * pair[0][0] && pair[1][1] < pair[0][1], "{pair:?}");
    }
    // The default number of terms of rim and web; further terms change nothing.
    let usual = off[3];
    assert!(usual[0] < 5e-3 && usual[1] < 3e-3 && usual[2] < 3e-3, "{usual:?}");
}

/// A rigid web only constrains what the joint contains. With the width of the face, it equals a
/// bore constrained by the terms of a series.
#[test]
fn a_stiff_web_is_a_bore_constrained_by_its_series() {
    let stiff = Material { youngs_modulus: 1e8 * Material::STEEL.youngs_modulus, ..Material::STEEL };
    let disc = DiscWeb { harmonics: Some(6), degree: 2, material: Some(stiff), ..DiscWeb::plain(WIDTH, 0.0) };
    let joined = response(built(ring().on_disc(WIDTH, 0.0, BORE, disc).expect("a web")).as_ref());
    let constrained =
        response(built(ring().supported_by(BoreSupport::Means { harmonics: Some(6), degree: 2 })).as_ref());
    let scale = largest(&constrained.own);
    let off = [
        largest_difference(&joined.own, &constrained.own),
        largest_difference(&joined.next, &constrained.next),
    ]
    .map(|off| off / scale);
    assert!(off.iter().all(|off| *off < 1e-6), "{off:?}");
    assert!((joined.stress / constrained.stress - 1.0).abs() < 1e-6);
}

/// Dish, taper, hub and material change the compliance of a tooth; a hub stiffens its web, and the
/// cache key contains all of them. Cached structures have the same bits, in the tables of adjacent
/// teeth and beyond them.
#[test]
fn webs_have_keys_of_their_own_and_are_restored_completely() {
    let hub = Hub { radius: 20e-3, width: 24e-3, offset: 0.0 };
    let soft = Material { youngs_modulus: 70e9, ..Material::STEEL };
    let webs = [
        plain(),
        DiscWeb { hub: Some(hub), ..plain() },
        DiscWeb { inner_thickness: 14e-3, ..plain() },
        DiscWeb { inner_offset: -8e-3, ..plain() },
        DiscWeb { material: Some(soft), ..plain() },
    ]
    .map(|disc| DiscWeb { harmonics: Some(6), ..disc });
    let options = options();
    let mean = |structure: &dyn SolidStructure| response(structure).own[4];
    let built = webs.map(|disc| (gear(on_disc(disc)), built(on_disc(disc))));
    let means = built.each_ref().map(|(_, structure)| mean(structure.as_ref()));
    assert!(means[1] < means[0] && means[2] < means[0] && means[4] > means[0], "{means:?}");
    assert!((means[3] / means[0] - 1.0).abs() > 3e-4, "{means:?}");
    for (one, (gear, _)) in built.iter().enumerate() {
        for (other, _) in &built[..one] {
            assert_ne!(gear.solid_key(&options), other.solid_key(&options));
        }
    }
    let (gear, structure) = &built[1];
    let kept = gear.restore_solid(&options, &structure.stored().expect("kept")).expect("read back");
    let segments = [[0.3, 0.0], [0.7, 0.2]].map(|[share, along]| {
        let [[start, end], [from, to]] = structure.surface(0).range();
        SurfaceSegment::from([start + share * (end - start), from + (0.5 + along) * (to - from)])
    });
    for observed in [0, 1, TEETH / 2] {
        let [first, second] = [structure, &kept].map(|structure| {
            let mut block = vec![0.0; 4];
            let chart = |tooth| Chart { tooth, surface: 0 };
            structure.add_compliance(chart(observed), &segments, chart(0), &segments, &mut block);
            block
        });
        assert!(first.iter().zip(&second).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert!(first.iter().any(|value| *value != 0.0), "tooth {observed} feels it");
    }
    let size = gear.size(Fidelity::Solid(options.template), &options).expect("a size");
    assert!(size.means > 100, "{size:?}");
}
