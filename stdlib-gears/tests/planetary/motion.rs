//! Moving axes: every observer sees the same loads, and the cycle of a mesh is that of its teeth.

use super::set::{DISTANCE, Planet, RING_TEETH, SUN_SPEED, SUN_TEETH, Set, SetOptions};
use calyx_runtime::motion::{Motion, axle};
use calyx_runtime::observables::{
    Efficiency, Equilibrium, LoadShare, MaxContactPressure, MaxRootStress, MaxSlidingVelocity, MeshStiffness,
    Observable, PairLoad, SecantStiffness, TransmissionError, UnloadedTransmissionError,
};
use std::f64::consts::TAU;

/// Values that do not depend on the observer: for every mesh, and for the fillets of sun and ring.
fn seen(set: &Set, time: f64) -> Vec<f64> {
    let mut set = set.clone();
    for body in [set.sun, set.ring] {
        // Stress is only recovered if it is observed.
        set.scene.add_observable(MaxRootStress(body));
    }
    let system = set.system();
    let step = system.solve(time).expect("equilibrium");
    assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
    let at = Equilibrium::new(&system, &step);
    let mut values = Vec::new();
    for &pair in set.sun_meshes.iter().chain(&set.ring_meshes) {
        let observables: [Box<dyn Observable>; 10] = [
            Box::new(TransmissionError(pair)),
            Box::new(UnloadedTransmissionError(pair)),
            Box::new(LoadShare(pair)),
            Box::new(PairLoad(pair, 0)),
            Box::new(PairLoad(pair, 1)),
            Box::new(MaxContactPressure(pair)),
            Box::new(MaxSlidingVelocity(pair)),
            Box::new(Efficiency(pair, 0.05)),
            Box::new(MeshStiffness(pair)),
            Box::new(SecantStiffness(pair)),
        ];
        values.extend(observables.iter().map(|observable| observable.value(&at).value));
        values.push(at.force(pair));
    }
    let stresses = [set.sun, set.ring].map(|body| MaxRootStress(body).value(&at).value);
    assert!(stresses.iter().all(|stress| *stress > 0.0));
    values.extend(stresses);
    values
}

#[test]
fn a_set_seen_from_the_carrier_the_ring_the_sun_and_elsewhere_bears_the_same_loads() {
    let options = SetOptions { floating: true, ..SetOptions::four() };
    let ring = -SUN_SPEED * f64::from(SUN_TEETH) / f64::from(RING_TEETH);
    let at_rest = Set::of(&options).expect("it goes together");
    let period = at_rest.mesh(at_rest.sun_meshes[0]).period;
    for part in [0.1, 0.55, 40.3] {
        let time = part * period;
        let expected = seen(&at_rest, time);
        for seen_from in [ring, SUN_SPEED, 37.0] {
            let set = Set::of(&SetOptions { seen_from, ..options.clone() }).expect("it goes together");
            for (index, (found, expected)) in seen(&set, time).iter().zip(&expected).enumerate() {
                let scale = expected.abs().max(if index % 11 < 2 { 1e-3 } else { 1e-6 });
                assert!(
                    (found - expected).abs() <= 1e-9 * scale,
                    "{seen_from} {part} {index}: {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn the_cycle_of_a_mesh_is_that_of_its_teeth_wherever_it_is_seen_from() {
    for seen_from in [0.0, -30.0, SUN_SPEED] {
        let set = Set::of(&SetOptions { seen_from, ..SetOptions::three() }).expect("it goes together");
        assert!(set.warnings.is_empty(), "{:?}", set.warnings);
        for &pair in set.sun_meshes.iter().chain(&set.ring_meshes) {
            let mesh = set.mesh(pair);
            let period = TAU / f64::from(SUN_TEETH) / SUN_SPEED;
            assert!((mesh.period / period - 1.0).abs() < 1e-12, "{} {period}", mesh.period);
            assert!((mesh.carrier[2] + seen_from).abs() < 1e-9, "{}", mesh.carrier[2]);
            assert!(mesh.phase_offset.abs() < 1e-12);
        }
    }
}

/// Without load rigid teeth touch, and the transmission error is zero, after any number of
/// rotations.
#[test]
fn unloaded_involutes_have_no_transmission_error_on_moving_axes() {
    for seen_from in [0.0, 61.0] {
        let set = Set::of(&SetOptions { seen_from, ..SetOptions::four() }).expect("it goes together");
        let system = set.system();
        for time in [0.0, 0.013, 1.7] {
            let step = system.solve(time).expect("equilibrium");
            let at = Equilibrium::new(&system, &step);
            for &pair in &set.sun_meshes {
                let error = UnloadedTransmissionError(pair).value(&at).value;
                assert!(error.abs() < 1e-9, "{seen_from} {time}: {error:e}");
            }
        }
    }
}

/// An eccentric planet rotates about its pin, and its line of centres stays fixed.
#[test]
fn a_planet_off_its_pin_turns_about_the_pin() {
    for speed in [0.0, 11.0, -30.0] {
        let off = [20e-6, -50e-6];
        let motion = Planet { pin: [DISTANCE, 0.0], carrier: [0.4, speed], own: [0.2, -77.0], off };
        let [x, y, z] = axle(&motion);
        assert!((x + off[0]).abs() < 1e-12 && (y + off[1]).abs() < 1e-12 && z == 0.0, "{speed}: {x} {y} {z}");
        let (before, after, rate) = (motion.frame(0.3 - 1e-6), motion.frame(0.3 + 1e-6), motion.rate(0.3));
        assert!(
            (0..12).all(|k| ((after[k] - before[k]) / 2e-6 - rate[k]).abs() < 1e-6),
            "the test's own rate"
        );
        let (before, after, second) =
            (motion.rate(0.3 - 1e-6), motion.rate(0.3 + 1e-6), motion.acceleration(0.3));
        assert!(
            (0..12).all(|k| ((after[k] - before[k]) / 2e-6 - second[k]).abs() < 1e-3),
            "nor its second derivative"
        );
    }
}
