//! A pinion in an internal gear in three dimensions, spur and helical: the same exact ratios as in
//! the plane.

use crate::common::built;
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim, Thickness};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    MaxContactPressure, MaxRootStress, MeshStiffness, PairsInContact, SecantStiffness, TransmissionError,
    UnloadedTransmissionError,
};
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, PairId, Scene, StructureOptions, Template};
use std::f64::consts::PI;

const MODULE: f64 = 4e-3;
const TORQUE: f64 = 200.0;
const FIRST: BodyId = BodyId(0);
const SECOND: BodyId = BodyId(1);

/// 20 teeth in 60 of module 4 mm, face width 30 mm; the pinion is free to rotate and loaded
/// counter-clockwise or clockwise.
fn scene(helix_angle: f64, moment: f64) -> Scene {
    let pressure = 20.0_f64.to_radians();
    let rack = Rack::new(MODULE, pressure, 0.3 * MODULE).expect("a rack");
    let shaper = Shaper::new(25, MODULE, pressure, 1.25 * MODULE, 0.2 * MODULE).expect("a shaper");
    let helix = Helix::new(helix_angle, Hand::Right).expect("a helix");
    let thickness = Thickness::Circular(6.2e-3);
    let pinion = GearBlank { helix, ..GearBlank::standard(20, rack) }
        .diameters(86.4e-3, 70e-3)
        .thickness(thickness)
        .face_width(30e-3)
        .rim(Rim::new(60e-3, 40e-3).expect("a rim"));
    let ring = GearBlank {
        helix,
        thickness,
        face_width: 30e-3,
        rim: Rim::outer(256e-3, 280e-3).expect("a rim"),
        ..GearBlank::standard(60, shaper)
    };
    let mut scene = Scene::default();
    let turning = |distance, speed| SteadyRotation { origin: [distance, 0.0], start: 0.0, speed };
    let pinion = Body::new("pinion", pinion.cut().expect("a gear"), turning(0.0, 1.0))
        .free_in(&[Component::ThetaZ])
        .loaded(Wrench::of_moment([0.0, 0.0, moment]));
    let ring = Body::new("ring", ring.cut().expect("a ring"), turning(80e-3, 1.0 / 3.0));
    let bodies = [add_body(&mut scene, pinion).expect("a body"), add_body(&mut scene, ring).expect("a body")];
    let options = MeshOptions { tip_corner_contact: false, half_cells: Some(8), ..MeshOptions::default() };
    mesh(&mut scene, bodies[0], bodies[1], &options).expect("they mesh");
    scene.add_observable(MaxRootStress(FIRST));
    scene.add_observable(MaxRootStress(SECOND));
    scene
}

#[test]
fn ratios_of_torques_and_axial_forces_are_exact() {
    for (helix_angle, moment) in [(0.0, TORQUE), (0.3, TORQUE), (0.3, -TORQUE)] {
        let scene = scene(helix_angle, moment);
        let structure =
            StructureOptions { face_elements: Some(2), axial_order: Some(2), ..StructureOptions::default() };
        let system = built(&scene, Fidelity::Solid(Template::Medium), structure);
        let cycle = scene.pairs[0].mesh.as_ref().expect("a mesh");
        for part in [0.1, 0.7] {
            let step = system.solve(cycle.start + part * cycle.period).expect("equilibrium");
            let [pinion, ring] = [FIRST, SECOND].map(|body| system.contact_force(&step, body));
            assert!((pinion[5] / -moment - 1.0).abs() < 1e-9, "{pinion:?}");
            assert!(
                (ring[5] / pinion[5] / -3.0 - 1.0).abs() < 1e-9,
                "{helix_angle} {part}: {pinion:?} {ring:?}"
            );
            // The torque on the pinion's right-hand teeth causes an axial force.
            let axial = helix_angle.tan() * moment / 40e-3;
            assert!((pinion[2] - axial).abs() < 1e-9 * (moment / 40e-3).abs(), "{} {axial}", pinion[2]);
            let size = pinion[..3].iter().map(|part| part * part).sum::<f64>().sqrt();
            for axis in 0..3 {
                assert!((pinion[axis] + ring[axis]).abs() < 1e-10 * size, "{pinion:?} {ring:?}");
            }
            assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
            let value = |observable: &dyn calyx_runtime::observables::Observable| {
                system.value(&step, observable).value
            };
            let error = value(&TransmissionError(PairId(0)));
            // Unmodified teeth have no transmission error without load.
            let unloaded = value(&UnloadedTransmissionError(PairId(0)));
            assert!(unloaded.abs() < 1e-9 && error > 1e-6, "the ring lags: {error} {unloaded}");
            // Force divided by the displacement of the mesh that it causes.
            let force = moment.abs() / cycle.base_radii[0];
            let secant = value(&SecantStiffness(PairId(0)));
            assert!((secant * error * cycle.base_radii[1] / force - 1.0).abs() < 1e-6, "{secant}");
            let tangent = value(&MeshStiffness(PairId(0))) / secant;
            assert!((1.0..1.1).contains(&tangent), "{tangent}");
            // Hertzian pressure at mid-face of one pair of spur teeth; both flanks curve in the
            // same direction: p = sqrt(F E' (1 / r_1 - 1 / r_2) / (2 pi b)).
            let pressure = system.value(&step, &MaxContactPressure(PairId(0)));
            let place = pressure.location.expect("something is pressed");
            let alone = value(&PairsInContact(PairId(0))) == 1.0;
            if helix_angle == 0.0 && alone {
                let roll = place.roll_angle.expect("on a flank");
                let [first, second] = cycle.base_radii;
                let apart = (second - first) * 20.0_f64.to_radians().tan();
                let radii = [first * roll, first * roll + apart];
                let curvature = 1.0 / radii[0] - 1.0 / radii[1];
                let reduced = Material::STEEL.surface_modulus(Plane::Strain) / 2.0;
                let hertz = (force / 30e-3 * reduced * curvature / PI).sqrt();
                assert!((pressure.value / hertz - 1.0).abs() < 0.05, "{} {hertz}", pressure.value);
            }
            assert!(value(&MaxRootStress(FIRST)) > 1e7 && value(&MaxRootStress(SECOND)) > 1e7);
        }
    }
}
