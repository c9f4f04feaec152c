//! A kind of web that is defined outside of the library, in one place: the worked example of
//! `docs/contributing.md`.
//!
//! The thickness of the web is inversely proportional to the square of the radius, between a bore
//! and the rim. Its mass has a closed form, and its compliance lies between those of two discs of
//! constant thickness.

use calyx_gears::blank::{GearBlank, Rim};
use calyx_gears::error::GeometryError;
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::web::{DiscWeb, Joint, Web};
use calyx_runtime::fe::{Section, Station};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::material::Material;
use calyx_runtime::scene::{Fidelity, Prototype, StructureOptions};
use calyx_runtime::structure::Chart;
use calyx_runtime::structure::solid::SurfaceSegment;
use std::f64::consts::TAU;
use std::sync::Arc;

const MODULE: f64 = 4e-3;
const TEETH: u32 = 24;
const WIDTH: f64 = 30e-3;
const BORE: f64 = 30e-3;

/// Web whose thickness decreases with the square of the radius.
#[derive(Clone, Copy)]
struct TaperedWeb {
    /// Thickness where the web meets the rim, m.
    thickness_at_rim: f64,
    /// Number of conical parts that represent the taper.
    parts: u32,
}

impl TaperedWeb {
    /// Converts the dimensions to a section between two radii, m.
    fn section(self, [inner, outer]: [f64; 2]) -> Option<Section> {
        let stations = (0..=self.parts).map(|part| {
            let share = f64::from(part) / f64::from(self.parts);
            // The last station is exactly at the rim.
            let radius = (1.0 - share) * inner + share * outer;
            let half = 0.5 * self.thickness_at_rim * (outer / radius).powi(2);
            Station { radius, ends: [-half, half] }
        });
        Section::new(stations.collect())
    }

    fn under(self, rim: Rim, bore_diameter: f64) -> Result<Rim, GeometryError> {
        let section = self.section([0.5 * bore_diameter, rim.fixed_radius]).expect("a section");
        rim.carried_by(Web::separate(section, None, Joint { harmonics: Some(6), degree: 2 }))
    }
}

fn ring() -> Rim {
    Rim::new(82e-3, 74e-3).expect("a rim")
}

fn gear(rim: Rim) -> Arc<GearPrototype> {
    let rack = Rack::new(MODULE, 20_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    GearBlank::standard(TEETH, rack).face_width(WIDTH).rim(rim).cut().expect("a gear")
}

fn disc(thickness: f64) -> Rim {
    let disc = DiscWeb { harmonics: Some(6), ..DiscWeb::plain(thickness, 0.0) };
    ring().on_disc(thickness, 0.0, BORE, disc).expect("a web")
}

#[test]
fn a_web_from_outside_has_the_mass_of_its_section() {
    let mass = |rim: Rim| gear(rim).inertia().mass;
    let thickness = 4e-3;
    let tapered = TaperedWeb { thickness_at_rim: thickness, parts: 200 };
    let web = mass(tapered.under(ring(), BORE).expect("a web")) - mass(ring());
    let [inner, outer] = [0.5 * BORE, ring().fixed_radius];
    let expected = Material::STEEL.density * TAU * thickness * outer * outer * (outer / inner).ln();
    assert!((web / expected - 1.0).abs() < 1e-4, "{web} {expected}");
}

#[test]
#[ignore = "takes half a minute: .ci/full runs it"]
fn a_web_from_outside_carries_teeth() {
    let options = StructureOptions { face_elements: Some(2), ..StructureOptions::default() };
    let compliance = |rim: Rim| {
        let body = gear(rim).build_solid(&options, &Interrupt::never()).expect("a structure");
        let [[start, end], [from, to]] = body.surface(0).range();
        let middle = SurfaceSegment::from([0.5 * (start + end), 0.5 * (from + to)]);
        let (chart, mut block) = (Chart { tooth: 0, surface: 0 }, vec![0.0]);
        body.add_compliance(chart, &[middle], chart, &[middle], &mut block);
        block[0]
    };
    let tapered = TaperedWeb { thickness_at_rim: 4e-3, parts: 4 }.under(ring(), BORE).expect("a web");
    let [thin, thick] = [4e-3, 4e-3 * (ring().fixed_radius / (0.5 * BORE)).powi(2)];
    let thick = compliance(disc(thick.min(WIDTH)));
    let (thin, tapered) = (compliance(disc(thin)), compliance(tapered));
    assert!(thick < tapered && tapered < thin, "{thick} {tapered} {thin}");
}

/// The key of a stored structure follows from the section, the material and the joint.
#[test]
fn webs_from_outside_with_other_sections_have_other_keys() {
    let options = StructureOptions::default();
    let key = |thickness_at_rim, parts| {
        let rim = TaperedWeb { thickness_at_rim, parts }.under(ring(), BORE).expect("a web");
        gear(rim).solid_key(&options)
    };
    assert!(key(4e-3, 4).is_some());
    assert_eq!(key(4e-3, 4), key(4e-3, 4));
    assert_ne!(key(4e-3, 4), key(5e-3, 4));
    assert_ne!(key(4e-3, 4), key(4e-3, 5));
    // A straight taper is a disc web.
    let section = |thickness: f64| {
        let station = |radius: f64| Station { radius, ends: [-0.5 * thickness, 0.5 * thickness] };
        Section::new(vec![station(0.5 * BORE), station(ring().fixed_radius)]).expect("a section")
    };
    let joint = Joint { harmonics: Some(6), degree: 2 };
    let straight = ring().carried_by(Web::separate(section(4e-3), None, joint)).expect("a web");
    assert_eq!(gear(straight.clone()).solid_key(&options), gear(disc(4e-3)).solid_key(&options));
    let joint = Joint { degree: 1, ..joint };
    let other = ring().carried_by(Web::separate(section(4e-3), None, joint)).expect("a web");
    assert_ne!(gear(straight.clone()).solid_key(&options), gear(other).solid_key(&options));
    let inputs: Vec<_> = gear(straight).ignored(Fidelity::Plane).into_iter().map(|one| one.input).collect();
    assert_eq!(inputs, ["web"]);
}

#[test]
fn a_web_that_does_not_meet_its_rim_is_rejected() {
    let section = TaperedWeb { thickness_at_rim: 4e-3, parts: 2 }.section([15e-3, 36e-3]).expect("a section");
    let web = Web::separate(section, None, Joint { harmonics: None, degree: 2 });
    let refused = ring().carried_by(web).expect_err("the rim begins at 37 mm");
    assert_eq!((refused.code, refused.argument), ("E0665", "inner_diameter"));
}
