//! Gears that do not sit on the middle of their shafts, and axes at the wrong distance.

use crate::helical::{CYCLE, solved};
use crate::pairs::{FIRST, MESH, MODULE, Options, SECOND, TEETH, TORQUE};
use calyx_gears::helix::Hand;
use calyx_runtime::observe::{Observable, TransmissionError, UnloadedTransmissionError};
use std::f64::consts::TAU;

const COS: f64 = 0.939_692_620_785_908_4;

/// Without load the flanks follow the runout along the line of action: a gear that is off its shaft by e shifts them by
/// e sin(turn + pressure angle), and the transmission error has that over the second base radius as its harmonic once a turn.
#[test]
fn runout_is_a_harmonic_of_the_transmission_error_once_a_turn() {
    let e = 5e-6;
    for (options, member) in
        [(Options::spur(), 0), (Options::spur(), 1), (Options::helical(0.35, Hand::Right), 1)]
    {
        let mut eccentricity = [0.0; 2];
        eccentricity[member] = e;
        let options = Options { eccentricity, torque: 0.0, ..options };
        // One turn of the gear in question, at twelve positions.
        let turns = f64::from(TEETH[member]);
        let parts: Vec<f64> = (0..12).map(|k| turns * f64::from(k) / 12.0).collect();
        let mut errors = Vec::new();
        let mut times = Vec::new();
        solved(&options, &parts, |_, system, step| {
            let error = system.value(step, &TransmissionError(MESH)).value;
            let unloaded = system.value(step, &UnloadedTransmissionError(MESH)).value;
            assert!((error - unloaded).abs() < 1e-12);
            errors.push(error);
            times.push(step.time);
        });
        let speed = [TAU, TAU * f64::from(TEETH[0]) / f64::from(TEETH[1])][member];
        let harmonic = |f: fn(f64) -> f64| -> f64 {
            errors.iter().zip(&times).map(|(error, time)| error * f(speed * time) / 6.0).sum()
        };
        let amplitude = harmonic(f64::sin).hypot(harmonic(f64::cos));
        // Helical teeth touch across the axis as spur teeth of their transverse pressure angle.
        let transverse_cos = if options.helix.angle() == 0.0 {
            COS
        } else {
            let normal = f64::tan(20_f64.to_radians());
            // The rack is given across the axis.
            (1.0 / (1.0 + normal * normal)).sqrt()
        };
        let second_base = 0.5 * MODULE * f64::from(TEETH[1]) * transverse_cos;
        let expected = e / second_base;
        assert!((amplitude / expected - 1.0).abs() < 2e-3, "{member}: {amplitude} {expected}");
        // Nothing else but a constant: the gears were phased where they stood at time 0.
        let mean: f64 = errors.iter().sum::<f64>() / 12.0;
        for (error, time) in errors.iter().zip(&times) {
            let wave = harmonic(f64::sin) * (speed * time).sin() + harmonic(f64::cos) * (speed * time).cos();
            assert!((error - mean - wave).abs() < 3e-3 * expected, "{error} {mean} {wave}");
        }
    }
}

/// Under load the torque is carried all the same, and the error moves by the runout.
#[test]
fn a_loaded_pair_with_runout_is_in_equilibrium() {
    let options = Options { eccentricity: [1e-5, -2e-5], ..Options::helical(0.35, Hand::Left) };
    solved(&options, &[0.3, 5.3, 10.3, 15.3], |_, system, step| {
        let moment = system.contact_force(step, FIRST)[5];
        assert!((moment / TORQUE + 1.0).abs() < 1e-10, "{moment}");
    });
}

/// Involutes do not mind the centre distance: torques keep the ratio of the teeth, and no transmission error comes up without load.
#[test]
fn a_wrong_centre_distance_leaves_involutes_their_ratio() {
    for apart in [2e-4, 8e-3] {
        for options in [Options::spur(), Options::helical(0.35, Hand::Right)] {
            let options = Options { apart, ..options };
            solved(&options, &CYCLE, |_, system, step| {
                let [first, second] = [FIRST, SECOND].map(|body| system.contact_force(step, body)[5]);
                let ratio = second / first * f64::from(TEETH[0]) / f64::from(TEETH[1]);
                assert!((ratio - 1.0).abs() < 1e-9, "{apart}: {ratio}");
            });
            solved(&Options { torque: 0.0, ..options }, &CYCLE, |_, system, step| {
                let error =
                    TransmissionError(MESH).value(&calyx_runtime::observe::Equilibrium::new(system, step));
                assert!(error.value.abs() < 1e-12, "{apart}: {}", error.value);
            });
        }
    }
}
