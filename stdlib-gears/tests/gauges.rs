//! Strain gauges in fillets: their positions, comparison with the plane model and with recovered
//! stress nearby, and mirror symmetry.

use crate::common::built;
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim, Thickness};
use calyx_gears::fillet::Side;
use calyx_gears::gauge_externs::{FilletLocation, GaugePlacement};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{FilletSide, Gauge, GaugeReading, MaxRootStress, Observable, Reading};
use calyx_runtime::profile::Profile;
use calyx_runtime::results::Observed;
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, Scene, StructureOptions, Template};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};
use std::sync::Arc;

const FACE: f64 = 30e-3;
const BODIES: [BodyId; 2] = [BodyId(0), BodyId(1)];
const MIDDLE: GaugePlacement =
    GaugePlacement { along: FilletLocation::TangentAngle(0.6), axial: 0.0, direction: 0.0, length: 0.0 };

/// Gear of 20 teeth with transverse module 4 mm.
fn gear(helix_angle: f64, hand: Hand, poissons_ratio: f64) -> Arc<GearPrototype> {
    let module = 4e-3;
    let rack = Rack::new(module, 20.0_f64.to_radians(), 0.3 * module).expect("a rack");
    let helix = Helix::new(helix_angle, hand).expect("a helix");
    GearBlank { helix, ..GearBlank::standard(20, rack) }
        .diameters(86.4e-3, 70e-3)
        .thickness(Thickness::Circular(6.2e-3))
        .face_width(FACE)
        .material(Material { poissons_ratio, ..Material::STEEL })
        .rim(Rim::new(60e-3, 40e-3).expect("a rim"))
        .cut()
        .expect("a gear")
}

/// Pair of two such gears; the first is free to rotate and driven.
fn with_pair(
    gears: [Arc<GearPrototype>; 2],
    moment: f64,
    fidelity: Fidelity,
    test: impl FnOnce(&dyn Fn(&dyn Observable) -> Observed),
) {
    let mut scene = Scene::default();
    let turning = |x, speed| SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
    let [first, second] = gears;
    let first = Body::new("first", first, turning(0.0, 10.0))
        .free_in(&[Component::ThetaZ])
        .loaded(Wrench::of_moment([0.0, 0.0, moment]));
    let second = Body::new("second", second, turning(80e-3, -10.0));
    let bodies = [first, second].map(|body| add_body(&mut scene, body).expect("a body"));
    let options = MeshOptions { tip_corner_contact: false, half_cells: Some(8), ..MeshOptions::default() };
    mesh(&mut scene, bodies[0], bodies[1], &options).expect("they mesh");
    for body in BODIES {
        scene.add_observable(MaxRootStress(body));
    }
    let structure =
        StructureOptions { face_elements: Some(2), axial_order: Some(2), ..StructureOptions::default() };
    let system = built(&scene, fidelity, structure);
    let cycle = scene.pairs[0].mesh.as_ref().expect("a mesh");
    let step = system.solve(cycle.start + 0.6 * cycle.period).expect("equilibrium");
    test(&|observable| system.value(&step, observable));
}

fn gauge(body: BodyId, gear: &GearPrototype, placing: GaugePlacement) -> Gauge {
    let place = placing.on(gear).expect("within the fillet");
    let GaugePlacement { direction, length, .. } = placing;
    Gauge { body, place, direction, length, side: FilletSide::Loaded, tooth: None, material: gear.material }
}

#[test]
fn gauges_are_placed_by_radius_or_tangent_angle() {
    let gear = gear(0.3, Hand::Right, 0.3);
    let fillet = gear.gear.root_fillet(Side::CounterClockwise);
    let form = gear.form();
    for degrees in [25.0_f64, 30.0, 60.0] {
        let [s, axial] =
            GaugePlacement { along: FilletLocation::TangentAngle(degrees.to_radians()), ..MIDDLE }
                .on(&gear)
                .expect("a place");
        let point = fillet.at(s);
        // Towards the root, the tangent of a counter-clockwise fillet inclines away from the
        // centreline.
        let [x, y] = point.tangent;
        assert!(
            ((-x).atan2(y) - (FRAC_PI_2 - degrees.to_radians())).abs() < 1e-9,
            "{degrees}: {:?}",
            point.tangent
        );
        assert_eq!(axial, 0.0);
        let radius = point.position[0].hypot(point.position[1]);
        let [by_radius, _] = GaugePlacement { along: FilletLocation::Radius(radius), ..MIDDLE }
            .on(&gear)
            .expect("the same place");
        assert!((by_radius - s).abs() < 1e-9 * fillet.length());
    }
    for end in [form.form_radius, form.root_radius] {
        assert!(GaugePlacement { along: FilletLocation::Radius(end), ..MIDDLE }.on(&gear).is_ok());
    }
    let refused = |placing: GaugePlacement| placing.on(&gear).expect_err("off the fillet").argument;
    assert_eq!(
        refused(GaugePlacement { along: FilletLocation::Radius(1.001 * form.form_radius), ..MIDDLE }),
        "radius"
    );
    assert_eq!(
        refused(GaugePlacement { along: FilletLocation::Radius(0.999 * form.root_radius), ..MIDDLE }),
        "radius"
    );
    assert_eq!(
        refused(GaugePlacement { along: FilletLocation::TangentAngle(0.0), ..MIDDLE }),
        "tangent_angle"
    );
    assert_eq!(
        refused(GaugePlacement { along: FilletLocation::TangentAngle(1.6), ..MIDDLE }),
        "tangent_angle"
    );
    assert_eq!(refused(GaugePlacement { axial: 0.51 * FACE, ..MIDDLE }), "axial_position");
    assert_eq!(refused(GaugePlacement { axial: f64::NAN, ..MIDDLE }), "axial_position");
    let along = GaugePlacement { length: 2.0 * fillet.length(), ..MIDDLE };
    assert_eq!(refused(along), "length");
    assert_eq!(refused(GaugePlacement { length: -1e-3, ..MIDDLE }), "length");
    // Rotated into the face direction the gauge fits, but not near the end of the face.
    let across = GaugePlacement { direction: FRAC_PI_2, length: 0.2 * FACE, ..MIDDLE };
    assert!(GaugePlacement { axial: 0.39 * FACE, ..across }.on(&gear).is_ok());
    assert_eq!(refused(GaugePlacement { axial: 0.41 * FACE, ..across }), "axial_position");
}

/// With Poisson's ratio zero every section of a spur gear is in plane strain, and the strain along
/// the face vanishes.
#[test]
fn without_transverse_contraction_gauges_read_what_the_plane_says() {
    let gears = || [Hand::Right, Hand::Left].map(|hand| gear(0.0, hand, 0.0));
    let placings = [(25.0_f64, -9e-3), (35.0, 1.3e-3), (45.0, 14e-3)].map(|(degrees, axial)| {
        GaugePlacement { along: FilletLocation::TangentAngle(degrees.to_radians()), axial, ..MIDDLE }
    });
    let mut plane = Vec::new();
    let read = |value: &dyn Fn(&dyn Observable) -> Observed| {
        let mut all = Vec::new();
        for body in BODIES {
            for placing in placings {
                for (direction, length) in [(0.0, 0.0), (0.0, 0.8e-3), (FRAC_PI_4, 0.0), (FRAC_PI_2, 1e-3)] {
                    let gauge =
                        gauge(body, &gears()[body.0], GaugePlacement { direction, length, ..placing });
                    all.push(value(&GaugeReading(gauge, Reading::Strain)).value);
                }
            }
        }
        all
    };
    with_pair(gears(), 200.0, Fidelity::Plane, |value| plane = read(value));
    with_pair(gears(), 200.0, Fidelity::Solid(Template::FineRoot), |value| {
        for (index, (space, plane)) in read(value).chunks(4).zip(plane.chunks(4)).enumerate() {
            for (direction, (found, expected)) in space.iter().zip(plane).enumerate() {
                // Agreement to within the difference of the meshed sections.
                assert!(
                    (found - expected).abs() < 0.012 * plane[0],
                    "{index} {direction}: {space:?} {plane:?}"
                );
            }
        }
    });
}

#[test]
fn gauges_read_the_stress_that_is_recovered_and_its_mirror_image() {
    let mut of_right = Vec::new();
    for (hand, other, sign) in [(Hand::Right, Hand::Left, 1.0), (Hand::Left, Hand::Right, -1.0)] {
        let gears = [hand, other].map(|hand| gear(0.3, hand, 0.3));
        with_pair(gears.clone(), 200.0, Fidelity::Solid(Template::Medium), |value| {
            let mut readings = Vec::new();
            for body in BODIES {
                let gear = &gears[body.0];
                let stress = value(&MaxRootStress(body));
                let place = stress.location.expect("a loaded gear has a location of its largest stress");
                let axial = place.axial.expect("a solid has points along the face");
                let largest = GaugePlacement { along: FilletLocation::Radius(place.radius), axial, ..MIDDLE };
                let read = |placing: GaugePlacement, reading| {
                    value(&GaugeReading(gauge(body, gear, placing), reading)).value
                };
                let found = read(largest, Reading::LargestPrincipal);
                assert!((found / stress.value - 1.0).abs() < 1e-4, "{found} {}", stress.value);
                // Among gauges in all directions one reads the principal strain, none reads more,
                // and the sum of two perpendicular gauges is invariant.
                let smallest = read(largest, Reading::SmallestPrincipal);
                let around: Vec<f64> = (0..36)
                    .map(|fives| {
                        read(
                            GaugePlacement { direction: f64::from(5 * fives).to_radians(), ..largest },
                            Reading::Stress,
                        )
                    })
                    .collect();
                let most = around.iter().copied().fold(0.0, f64::max);
                assert!(
                    most <= found * (1.0 + 1e-9) && most > found - 0.01 * (found - smallest),
                    "{most} {found}"
                );
                for (a, b) in around.iter().zip(&around[18..]) {
                    assert!((a + b - found - smallest).abs() < 1e-3 * found, "{a} {b} {found} {smallest}");
                }
                for (axial, direction, length) in [(6e-3, 0.5, 0.0), (-11e-3, -0.8, 1e-3), (9e-3, 1.2, 2e-3)]
                {
                    let placing =
                        GaugePlacement { axial: sign * axial, direction: sign * direction, length, ..MIDDLE };
                    readings.push(read(placing, Reading::Strain));
                }
            }
            // Exchanging the hands of a pair mirrors everything at mid-face. Two elements meet
            // exactly there, and the gauge reads one of them.
            match sign > 0.0 {
                true => of_right = readings,
                false => {
                    for (left, right) in readings.iter().zip(&of_right) {
                        assert!((left - right).abs() < 1e-6 * of_right[0].abs(), "{readings:?} {of_right:?}");
                    }
                }
            }
        });
    }
}
