//! Vibration of all coordinates: against the same coordinates as quantities, and the power balance.

use super::tests::{coordinates, oscillator, parametric};
use super::*;
use std::f64::consts::TAU;

/// All coordinates agree with quantities, also if a mode has no inertia.
#[test]
fn coordinates_agree_with_quantities() {
    let system = parametric(10);
    for highest in [2.0, 0.01] {
        let forced = ForcedVibration::with_coordinates(&system, &coordinates(&system), highest);
        let forced = forced.expect("a finite system");
        assert_eq!(forced.natural_frequencies().len() < 2, highest < 1.0);
        for speed in [0.0, 0.3 * highest, highest] {
            let Response { quantities, motion } = forced.response(speed).expect("a finite response");
            let displacements = motion.expect("prepared").displacements;
            for (coordinate, quantity) in quantities.iter().enumerate() {
                for (line, expected) in quantity.iter().enumerate() {
                    let found = displacements[line][coordinate];
                    assert!((found - expected).norm() < 1e-11 * quantity[1].norm(), "{found} {expected}");
                }
            }
        }
    }
    let without = ForcedVibration::new(&system, &[], 2.0).expect("a finite system");
    assert_eq!(without.response(1.0).expect("a finite response").motion, None);
}

/// The damping of an oscillator dissipates the power of its spring.
#[test]
fn the_damping_force_has_the_closed_form() {
    let system = oscillator(0.03, 3);
    let forced = ForcedVibration::with_coordinates(&system, &[], 4.0).expect("a finite system");
    for speed in [0.5, 2.0, 3.0] {
        let Motion { displacements, damping_forces } =
            forced.response(speed).and_then(|response| response.motion).expect("prepared");
        let velocity = displacements[1][0] * Complex::new(0.0, 100.0 * speed);
        let expected = velocity * (2.0 * 0.03 * 200.0 * 2.0);
        assert!((damping_forces[1][0] - expected).norm() < 1e-12 * expected.norm());
        let spring = 8e4 * (displacements[1][0] - 3e-6);
        let powers = [spring, damping_forces[1][0]].map(|force| (force * velocity.conj()).re);
        assert!((powers[0] + powers[1]).abs() < 1e-10 * powers[1], "{powers:?}");
    }
}

/// The mean power of the varying spring equals the power that dampers and modal damping dissipate.
#[test]
fn the_varying_stiffness_provides_what_is_dissipated() {
    let system = parametric(24);
    let forced = ForcedVibration::with_coordinates(&system, &[], 2.0).expect("a finite system");
    let speed = 1.3;
    let Motion { displacements, damping_forces } =
        forced.response(speed).and_then(|response| response.motion).expect("prepared");
    let at = |amplitudes: &[DVector<Complex<f64>>], time: f64| {
        let terms = amplitudes.iter().enumerate();
        let turned = terms.map(|(line, value)| value * Complex::from_polar(1.0, TAU * line as f64 * time));
        turned.sum::<DVector<Complex<f64>>>().map(|value| value.re)
    };
    let rate = |(line, value): (usize, &DVector<Complex<f64>>)| {
        value * Complex::new(0.0, speed * system.frequency * line as f64)
    };
    let velocities: Vec<_> = displacements.iter().enumerate().map(rate).collect();
    let count = system.stiffness.len();
    let (mut provided, mut dissipated) = (0.0, 0.0);
    for (sample, stiffness) in system.stiffness.iter().enumerate() {
        let time = sample as f64 / count as f64;
        let velocity = at(&velocities, time);
        let spring = stiffness * (at(&displacements, time) - &system.statics[sample]);
        provided -= velocity.dot(&spring);
        dissipated += velocity.dot(&(at(&damping_forces, time) + &system.damping * &velocity));
    }
    assert!((provided / dissipated - 1.0).abs() < 1e-6, "{provided} {dissipated}");
}
