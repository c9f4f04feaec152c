//! Basic outputs of a pair in three dimensions: the outputs of the plane model, computed from cells
//! on surfaces.

use crate::common::built;
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_gears::blank::{GearBlank, Rim, Thickness};
use calyx_gears::helix::{Hand, Helix};
use calyx_gears::rack::Rack;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    Coordinate, Efficiency, Equilibrium, FaceLoadFactor, FrictionLoss, LoadedFace, MaxContactPressure,
    MaxLineLoad, MaxRootCompression, MaxRootStress, MaxSlidingVelocity, Maximum, MaximumLocation,
    MeshStiffness, Observable, PairLoad, PairsInContact, SecantStiffness, SupportForce, SupportMoment,
    TransmissionError, UnloadedTransmissionError,
};
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, PairId, Scene, StructureOptions, Template};

const TORQUE: f64 = 200.0;
const SPEED: f64 = 10.0;
const FACE: f64 = 30e-3;
pub const MESH: PairId = PairId(0);
pub const BODIES: [BodyId; 2] = [BodyId(0), BodyId(1)];

/// Two gears of 20 teeth with transverse module 4 mm, of opposite hands if they are helical; the
/// first is free to rotate and drives.
pub fn scene(helix_angle: f64) -> Scene {
    let module = 4e-3;
    let rack = Rack::new(module, 20.0_f64.to_radians(), 0.3 * module).expect("a rack");
    let gear = |hand| {
        let blank = GearBlank {
            helix: Helix::new(helix_angle, hand).expect("a helix"),
            ..GearBlank::standard(20, rack)
        };
        blank
            .diameters(86.4e-3, 70e-3)
            .thickness(Thickness::Circular(6.2e-3))
            .face_width(FACE)
            .rim(Rim::new(60e-3, 40e-3).expect("a rim"))
            .cut()
            .expect("a gear")
    };
    let turning = |x, speed| SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
    let mut scene = Scene::default();
    let pinion = Body::new("pinion", gear(Hand::Right), turning(0.0, SPEED))
        .free_in(&[Component::ThetaZ])
        .loaded(Wrench::of_moment([0.0, 0.0, TORQUE]));
    let wheel = Body::new("wheel", gear(Hand::Left), turning(80e-3, -SPEED));
    let bodies = [pinion, wheel].map(|body| add_body(&mut scene, body).expect("a body"));
    let options = MeshOptions { tip_corner_contact: false, half_cells: Some(8), ..MeshOptions::default() };
    mesh(&mut scene, bodies[0], bodies[1], &options).expect("they mesh");
    for body in BODIES {
        scene.add_observable(MaxRootStress(body));
    }
    scene
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * a.abs().max(b.abs())
}

#[test]
fn solid_models_have_every_output_of_plane_models() {
    for helix_angle in [0.0, 0.3_f64] {
        let scene = scene(helix_angle);
        let structure =
            StructureOptions { face_elements: Some(2), axial_order: Some(2), ..StructureOptions::default() };
        let system = built(&scene, Fidelity::Solid(Template::Medium), structure);
        let cycle = scene.pairs[0].mesh.as_ref().expect("a mesh");
        for part in [0.1, 0.6] {
            let step = system.solve(cycle.start + part * cycle.period).expect("equilibrium");
            let seen = |observable: &dyn Observable| system.value(&step, observable);
            let value = |observable: &dyn Observable| seen(observable).value;
            let at = Equilibrium::new(&system, &step);

            // The normal force is inclined by the base helix angle; its transverse part transmits
            // the torque.
            let base_radius = cycle.base_radii[0];
            let base_helix = (helix_angle.tan() * base_radius / 40e-3).atan();
            let normal: f64 = (-2..=2).map(|pair| value(&PairLoad(MESH, pair))).sum();
            assert!(
                close(normal * base_helix.cos() * base_radius, TORQUE, 1e-9),
                "{helix_angle} {part}: {normal}"
            );
            let [x, y, z] = [0, 1, 2].map(|axis| value(&SupportForce(BODIES[0], axis)));
            assert!(close(x.hypot(y).hypot(z), normal, 1e-9), "{x} {y} {z}");
            assert!((z.abs() - helix_angle.tan() * TORQUE / 40e-3).abs() < 1e-8 * normal, "{z}");
            assert!(value(&SupportMoment(BODIES[0], 2)).abs() < 1e-9 * TORQUE);
            assert!(close(value(&SupportMoment(BODIES[1], 2)).abs(), TORQUE, 1e-9));

            // The slices of a patch carry its force, and the force loads its cells.
            let mean = at.contacts(MESH).map(|contact| {
                let slices = contact.slices();
                let force: f64 = slices.iter().map(|slice| slice.force).sum();
                assert!((force - contact.force()).abs() <= 1e-12 * normal);
                force / slices.iter().map(|slice| slice.length).sum::<f64>()
            });
            let largest_mean = mean.filter(|mean| mean.is_finite()).fold(0.0, f64::max);
            assert!(value(&MaxLineLoad(MESH)) >= largest_mean);
            let factor = value(&FaceLoadFactor(MESH));
            assert!((1.0..3.0).contains(&factor), "{helix_angle} {part}: {factor}");
            let loaded = value(&LoadedFace(MESH));
            assert!(loaded > 0.5 && loaded <= 1.0, "{loaded}");

            // Positions on the face; `gauges.rs` tests the readings of gauges there.
            let pressed = seen(&MaxContactPressure(MESH)).location.expect("something is pressed");
            assert!(pressed.axial.is_some_and(|axial| axial.abs() <= 0.5 * FACE), "{pressed:?}");
            for body in BODIES {
                let stress = seen(&MaxRootStress(body));
                let place = stress.location.expect("a loaded gear has a location of its largest stress");
                let axial = place.axial.expect("a solid has points along the face");
                let location =
                    MaximumLocation { body, maximum: Maximum::RootStress, coordinate: Coordinate::Axial };
                assert_eq!(value(&location), axial);
                assert!(value(&MaxRootCompression(body)) > 0.5 * stress.value);
            }
            let fields = at.fields();
            let largest = fields.fillets.iter().flat_map(|fillet| fillet.sections.iter().flatten());
            let largest = largest.map(|stress| stress.principal[0]).fold(0.0, f64::max);
            let observed = BODIES.map(|body| value(&MaxRootStress(body)));
            assert_eq!(largest, observed[0].max(observed[1]));

            // Unmodified teeth have no transmission error without load.
            let unloaded = value(&UnloadedTransmissionError(MESH));
            let moved = value(&TransmissionError(MESH)) - unloaded;
            assert!(unloaded.abs() < 1e-9 && moved > 1e-5, "{unloaded} {moved}");
            let secant = value(&SecantStiffness(MESH));
            assert!(close(secant, TORQUE / base_radius / (moved * cycle.base_radii[1]), 1e-9));
            // The contact width grows with the load, so the stiffness against additional force
            // exceeds the secant stiffness.
            let tangent = value(&MeshStiffness(MESH)) / secant;
            assert!((1.0..1.1).contains(&tangent), "{tangent}");
            // The sliding velocity is at most that at the ends of the path, and dissipates its part
            // of the power.
            let ends =
                cycle.path.map(|roll| (roll - 20.0_f64.to_radians().tan()).abs() * base_radius * 2.0 * SPEED);
            let fastest = value(&MaxSlidingVelocity(MESH));
            assert!(fastest > 0.0 && fastest <= 1.001 * ends[0].max(ends[1]), "{fastest} {ends:?}");
            let loss = value(&FrictionLoss(MESH, 0.05));
            // Each cell dissipates its part; with one pair of spur teeth all cells slide at the
            // same velocity.
            let pairs = value(&PairsInContact(MESH));
            match helix_angle == 0.0 && pairs == 1.0 {
                true => assert!(close(loss, 0.05 * normal * fastest, 1e-3), "{loss} {fastest}"),
                false => assert!(loss > 0.0 && loss < 0.05 * normal * fastest, "{loss} {fastest}"),
            }
            // In spur gears of a contact ratio below two, one or two tooth pairs carry the load.
            assert!(helix_angle > 0.0 || pairs == if part < 0.5 { 2.0 } else { 1.0 }, "{part}: {pairs}");
            assert!(close(value(&Efficiency(MESH, 0.05)), 1.0 - loss / (TORQUE * SPEED), 1e-9));
        }
    }
}
