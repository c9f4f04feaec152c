//! Helical gears: tools given across the teeth, what follows from the helix, and which gears fit each other.

use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Thickness};
use calyx_gears::derived_quantities::{of_gear, of_mesh};
use calyx_gears::error::Refusal;
use calyx_gears::fillet::Side;
use calyx_gears::flank::Flank;
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::internal_blank::InternalBlank;
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::{Plane, Rack};
use calyx_gears::shaper::Shaper;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::profile::Profile;
use calyx_runtime::scene::{Body, Prototype, Scene, StructureOptions};
use std::f64::consts::PI;
use std::sync::Arc;

const BETA: f64 = 25.0 * PI / 180.0;
const ALPHA: f64 = 20.0 * PI / 180.0;
const NORMAL_MODULE: f64 = 4e-3;

fn normal_rack(tip_radius: f64) -> Rack {
    Rack::new(NORMAL_MODULE, ALPHA, tip_radius * NORMAL_MODULE).expect("a rack").in_plane(Plane::Normal)
}

/// A gear cut by a rack that is given across the teeth, of a standard height.
fn gear(teeth: u32, hand: Hand, angle: f64) -> Arc<GearPrototype> {
    let helix = Helix::new(angle, hand).expect("a helix");
    let rack = normal_rack(0.3);
    let pitch = f64::from(teeth) * rack.transverse(&helix).module;
    let mut blank = GearBlank::standard(teeth, rack);
    blank.helix = helix;
    blank = blank.diameters(pitch + 2.0 * NORMAL_MODULE, pitch - 2.5 * NORMAL_MODULE);
    blank.rim.radius = 0.5 * pitch - 2.0 * NORMAL_MODULE;
    blank.rim.fixed_radius = 0.5 * pitch - 3.5 * NORMAL_MODULE;
    blank.face_width(30e-3).cut().expect("a gear")
}

#[test]
fn a_normal_rack_is_converted_exactly() {
    let helix = Helix::new(BETA, Hand::Left).expect("a helix");
    let rack = normal_rack(0.3).transverse(&helix);
    assert!((rack.module - NORMAL_MODULE / BETA.cos()).abs() < 1e-18);
    assert!((rack.pressure_angle.tan() - ALPHA.tan() / BETA.cos()).abs() < 1e-15);
    assert_eq!(rack.plane, Plane::Transverse);
    // Base pitches across teeth and axis: p_bt cos(beta_b) = p_n cos(alpha_n).
    let base = helix.base_angle(rack.pressure_angle);
    let normal_base_pitch = PI * NORMAL_MODULE * ALPHA.cos();
    assert!((rack.pitch() * rack.pressure_angle.cos() * base.cos() - normal_base_pitch).abs() < 1e-16);
    assert!((base.sin() - BETA.sin() * ALPHA.cos()).abs() < 1e-15);
    // Profile shift and thickness are those of the rack's own plane.
    let shifted = |thickness| {
        let mut blank = GearBlank::standard(30, normal_rack(0.3)).thickness(thickness);
        blank.helix = helix;
        blank = blank.diameters(144e-3, 122e-3);
        blank.rim.radius = 58e-3;
        blank.rim.fixed_radius = 50e-3;
        blank.cut().expect("a gear").form().tooth_thickness
    };
    let by_shift = shifted(Thickness::ProfileShift(0.2));
    let by_thickness = shifted(Thickness::Circular(NORMAL_MODULE * (0.5 * PI + 0.4 * ALPHA.tan())));
    assert!((by_shift - by_thickness).abs() < 1e-17);
    assert!((by_shift * BETA.cos() - NORMAL_MODULE * (0.5 * PI + 0.4 * ALPHA.tan())).abs() < 1e-17);
    // A rack that is given across the axis stays as it is.
    let transverse = Rack::new(NORMAL_MODULE, ALPHA, 0.0).expect("a rack");
    assert_eq!(transverse.transverse(&helix), transverse);
}

#[test]
fn the_fillet_is_the_envelope_of_an_ellipse() {
    let gear = gear(25, Hand::Right, BETA);
    let external = gear.gear.external().expect("external");
    let rack = external.rack;
    let (across, along) = (rack.tip_radius, rack.tip_radius / BETA.cos());
    let fillet = external.root_fillet(Side::CounterClockwise);
    let centre_depth = external.pitch_radius - external.root_radius - across;
    let halfwidth = external.rack_tip_centre_halfwidth;
    for k in 0..=20 {
        let s = fillet.fillet_length() * f64::from(k) / 20.0;
        let point = fillet.at(s);
        let [x, y] = point.position;
        // The rack's tooth that cuts the space has its middle at half a pitch where the gear has not turned.
        let measure = |turn: f64| {
            let angle = PI / 25.0 + turn;
            let (sine, cosine) = angle.sin_cos();
            let (radial, tangential) = (x * cosine + y * sine, y * cosine - x * sine);
            let centre = -external.pitch_radius * turn - halfwidth;
            let deep = radial - (external.pitch_radius - centre_depth);
            ((tangential - centre) / along).hypot(deep / across)
        };
        let least =
            (-20_000..=20_000).map(|step| measure(f64::from(step) * 2e-5)).fold(f64::INFINITY, f64::min);
        assert!((least - 1.0).abs() < 1e-6, "at {s}: {least}");
        // Length and curvature agree with the points.
        if (1..20).contains(&k) {
            let h = 1e-3 * fillet.fillet_length();
            let [before, after] = [s - h, s + h].map(|s| fillet.at(s));
            for axis in 0..2 {
                let tangent = (after.position[axis] - before.position[axis]) / (2.0 * h);
                let bend = (after.tangent[axis] - before.tangent[axis]) / (2.0 * h);
                assert!((tangent - point.tangent[axis]).abs() < 2e-6);
                assert!((bend + point.curvature * point.normal[axis]).abs() < 1e-4 * point.curvature.abs());
            }
        }
    }
    let flank = Flank::new(external, &[], Side::CounterClockwise).expect("a flank");
    let (a, b) = (flank.at(0.0), fillet.at(0.0));
    for axis in 0..2 {
        assert!((a.position[axis] - b.position[axis]).abs() < 1e-15);
        assert!((a.normal[axis] - b.normal[axis]).abs() < 1e-12);
    }
}

fn meshed(
    first: Arc<GearPrototype>,
    second: Arc<GearPrototype>,
    distance: f64,
) -> Result<f64, Vec<&'static str>> {
    let ratio = f64::from(first.gear.teeth()) / f64::from(second.gear.teeth());
    let speed = -second.form().sense() * ratio;
    let mut scene = Scene::default();
    let turning = |distance, speed| SteadyRotation { origin: [distance, 0.0], start: 0.0, speed };
    let ids = [
        add_body(&mut scene, Body::new("first", first, turning(0.0, 1.0))).expect("a body"),
        add_body(&mut scene, Body::new("second", second, turning(distance, speed))).expect("a body"),
    ];
    match mesh(&mut scene, ids[0], ids[1], &MeshOptions::default()) {
        Ok(meshed) => {
            let cycle = scene.pairs[meshed.pair.0].mesh.as_ref().expect("a mesh");
            // Ends of the teeth touch before and after mid-face does.
            let overlap = cycle.path[1]
                - cycle.path[0]
                - meshed.geometry.contact_ratio * 2.0 * PI / f64::from(cycle.teeth[0]);
            assert!(
                (overlap - meshed.geometry.overlap_ratio * 2.0 * PI / f64::from(cycle.teeth[0])).abs()
                    < 1e-12
            );
            Ok(meshed.geometry.overlap_ratio)
        }
        Err(Refusal::Geometry(errors)) => Err(errors.iter().map(|error| error.code).collect()),
        Err(Refusal::Engine(error)) => Err(vec![error.code]),
    }
}

#[test]
fn hands_fit_on_parallel_axes() {
    let distance = 0.5 * 75.0 * NORMAL_MODULE / BETA.cos() + 0.1e-3;
    let overlap =
        meshed(gear(25, Hand::Left, BETA), gear(50, Hand::Right, BETA), distance).expect("they fit");
    assert!((overlap - 30e-3 * BETA.sin() / (PI * NORMAL_MODULE)).abs() < 1e-14);
    let same = meshed(gear(25, Hand::Left, BETA), gear(50, Hand::Left, BETA), distance);
    assert_eq!(same, Err(vec!["E0645"]));
    // Another angle at the same normal module is another base pitch across the axis, too.
    let other = meshed(gear(25, Hand::Left, BETA), gear(50, Hand::Right, 0.4), distance);
    assert_eq!(other.expect_err("refused")[0], "E0646");

    let module = NORMAL_MODULE / BETA.cos();
    let pressure = (ALPHA.tan() / BETA.cos()).atan();
    let ring = |hand| {
        let shaper =
            Shaper::new(24, module, pressure, NORMAL_MODULE * 1.25, 0.2 * NORMAL_MODULE).expect("a shaper");
        let mut blank = InternalBlank::standard(80, shaper);
        blank.helix = Helix::new(BETA, hand).expect("a helix");
        blank.face_width = 30e-3;
        blank.minor_diameter = 80.0 * module - 1.6 * NORMAL_MODULE;
        blank.root_diameter = 80.0 * module + 2.5 * NORMAL_MODULE;
        blank.cut().expect("a ring")
    };
    let inside = 0.5 * 55.0 * module - 0.05e-3;
    assert!(meshed(gear(25, Hand::Left, BETA), ring(Hand::Left), inside).is_ok());
    assert_eq!(meshed(gear(25, Hand::Left, BETA), ring(Hand::Right), inside), Err(vec!["E0645"]));
    assert_eq!(meshed(ring(Hand::Left), gear(25, Hand::Left, BETA), inside), Err(vec!["E0639"]));
}

#[test]
fn a_plane_model_refuses_a_helical_gear() {
    let error = gear(25, Hand::Left, BETA).build(&StructureOptions::default(), &Interrupt::default());
    let error = error.err().expect("refused");
    assert_eq!((error.code, error.argument), ("E0623", Some("helix_angle")));
}

/// The transverse section of a helical gear is a spur gear, whose structure a cache may hold: the plan refuses the gear whatever the
/// plane of its rack is.
#[test]
fn a_plan_in_the_plane_refuses_helical_gears_of_either_rack() {
    for rack in [normal_rack(0.3), normal_rack(0.3).in_plane(Plane::Transverse)] {
        let helix = Helix::new(BETA, Hand::Left).expect("a helix");
        let pitch = 25.0 * rack.transverse(&helix).module;
        let mut blank =
            GearBlank::standard(25, rack).diameters(pitch + 2.0 * NORMAL_MODULE, pitch - 2.5 * NORMAL_MODULE);
        blank.helix = helix;
        blank.rim.radius = 0.5 * pitch - 2.0 * NORMAL_MODULE;
        blank.rim.fixed_radius = 0.5 * pitch - 3.5 * NORMAL_MODULE;
        let gear = blank.cut().expect("a gear");
        let check = |in_space| gear.check(&StructureOptions::default(), in_space).map_err(|error| error.code);
        assert_eq!(check(false), Err("E0623"));
        assert_eq!(check(true), Ok(()));
    }
}

#[test]
fn what_follows_from_a_helix_is_told() {
    let gears = [gear(25, Hand::Left, BETA), gear(50, Hand::Right, BETA)];
    let told = of_gear(&gears[0]);
    let value = |symbol: &str| told.iter().find(|quantity| quantity.symbol == symbol).expect("told").value;
    assert!((value("m_n") - NORMAL_MODULE).abs() < 1e-17);
    assert!((value("alpha_n") - ALPHA).abs() < 1e-14);
    assert!((value("p_z") - 25.0 * PI * NORMAL_MODULE / BETA.sin()).abs() < 1e-14);
    let spur = GearBlank::standard(25, Rack::new(4e-3, ALPHA, 1e-3).expect("a rack")).cut().expect("a gear");
    assert!(of_gear(&spur).iter().all(|quantity| quantity.symbol != "beta"));

    let externals = [0, 1].map(|index: usize| gears[index].gear.external().expect("external").clone());
    let distance = 0.5 * 75.0 * NORMAL_MODULE / BETA.cos();
    let plain = calyx_gears::mesh_geometry::MeshGeometry::external(&externals[0], &externals[1], distance);
    let wound = calyx_gears::mesh_geometry::HelicalTeeth { first: gears[0].helix, width: 30e-3 };
    let mesh = plain.expect("a mesh").across(&externals[0], &wound);
    let told = of_mesh([gears[0].form(), gears[1].form()], &mesh);
    let value = |symbol: &str| told.iter().find(|quantity| quantity.symbol == symbol).expect("told").value;
    assert!((value("epsilon_gamma") - value("epsilon_alpha") - value("epsilon_beta")).abs() < 1e-15);
    assert!(value("epsilon_beta") > 1.0);
}

/// ISO 21771: coefficients and measurements of a helical gear are those of the normal section, in
/// which its rack was given.
#[test]
fn derived_values_count_in_the_plane_of_the_rack() {
    let (teeth, shift, beta) = (23_u32, 0.37, 28.0_f64.to_radians());
    let rack = Rack::new(NORMAL_MODULE, ALPHA, 0.2 * NORMAL_MODULE).expect("a rack");
    let rack = rack.in_plane(Plane::Normal);
    let pitch = f64::from(teeth) * NORMAL_MODULE / beta.cos();
    let raised = 2.0 * shift * NORMAL_MODULE;
    let mut blank = GearBlank::standard(teeth, rack)
        .diameters(pitch + 2.0 * NORMAL_MODULE + raised, pitch - 2.5 * NORMAL_MODULE + raised)
        .thickness(Thickness::ProfileShift(shift));
    blank.helix = Helix::new(beta, Hand::Right).expect("a helix");
    blank.rim.radius = 0.5 * blank.root_diameter - 0.5 * NORMAL_MODULE;
    blank.rim.fixed_radius = 0.5 * blank.root_diameter - 2.0 * NORMAL_MODULE;
    blank.face_width = 40e-3;
    let told = of_gear(&blank.cut().expect("a gear"));
    let quantity = |symbol: &str| told.iter().find(|quantity| quantity.symbol == symbol).expect("told");
    let close = |symbol: &str, expected: f64| {
        let found = quantity(symbol).value;
        assert!((found / expected - 1.0).abs() < 1e-12, "{symbol}: {found}, not {expected}");
    };
    close("x", shift);
    close("s_n", NORMAL_MODULE * (0.5 * PI + 2.0 * shift * ALPHA.tan()));
    let transverse = (ALPHA.tan() / beta.cos()).atan();
    let involute = |angle: f64| angle.tan() - angle;
    // Span: W_k = m_n cos(alpha_n) ((k - 0.5) pi + z inv(alpha_t)) + 2 x m_n sin(alpha_n).
    let spanned: f64 =
        quantity("W_k").note.split_whitespace().nth(1).and_then(|k| k.parse().ok()).expect("k");
    let z = f64::from(teeth);
    let turned = (spanned - 0.5) * PI + z * involute(transverse);
    close("W_k", NORMAL_MODULE * ALPHA.cos() * turned + raised * ALPHA.sin());
    // Over balls: inv(alpha_K) = D / (z m_n cos(alpha_n)) - (pi/2 - 2 x tan(alpha_n)) / z +
    // inv(alpha_t).
    let ball = calyx_gears::derived_quantities::PIN * NORMAL_MODULE;
    let value = ball / (z * NORMAL_MODULE * ALPHA.cos()) - (0.5 * PI - 2.0 * shift * ALPHA.tan()) / z
        + involute(transverse);
    let (mut low, mut high) = (0.0, 1.5);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        *(if involute(middle) < value { &mut low } else { &mut high }) = middle;
    }
    let centres = pitch * transverse.cos() / low.cos();
    close("M_d", centres * (0.5 * PI / z).cos() + ball);
    assert!(quantity("M_d").note.contains("normal modules"));
}
