//! Eccentric gears, and axes at a wrong distance.

use super::helical::{CYCLE, solved};
use super::pairs::{FIRST, MESH, MODULE, Options, SECOND, TEETH, TORQUE};
use crate::common::built;
use calyx_gears::helix::Hand;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{Observable, TransmissionError, UnloadedTransmissionError};
use calyx_runtime::scene::{Fidelity, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;

const COS: f64 = 0.939_692_620_785_908_4;

/// As [`solved`], in two dimensions.
fn in_section(options: &Options, parts: &[f64], mut look: impl FnMut(&System<'_>, &StepResult)) {
    let (scene, mesh) = options.scene();
    let structure = StructureOptions { refinement: 0.5, order: 2, ..StructureOptions::default() };
    let system = built(&scene, Fidelity::Plane, structure);
    for part in parts {
        look(&system, &system.solve(mesh.start + part * mesh.period).expect("it can be solved"));
    }
}

/// Without load the flanks follow the runout along the line of action. A gear with eccentricity e
/// shifts them by e sin(rotation + pressure angle), so the transmission error contains this over
/// the second base radius as its harmonic of one rotation.
#[test]
fn runout_is_a_harmonic_of_the_transmission_error_once_a_turn() {
    let e = 5e-6;
    let plane = || Options { backed: false, ..Options::spur() };
    for (options, member, in_plane) in [
        (Options::spur(), 0, false),
        (Options::spur(), 1, false),
        (Options::helical(0.35, Hand::Right), 1, false),
        (plane(), 0, true),
        (plane(), 1, true),
    ] {
        let mut eccentricity = [0.0; 2];
        eccentricity[member] = e;
        let options = Options { eccentricity, torque: 0.0, ..options };
        // One rotation of the eccentric gear, at twelve positions.
        let turns = f64::from(TEETH[member]);
        let parts: Vec<f64> = (0..12).map(|k| turns * f64::from(k) / 12.0).collect();
        let mut errors = Vec::new();
        let mut times = Vec::new();
        let mut look = |system: &System<'_>, step: &StepResult| {
            let error = system.value(step, &TransmissionError(MESH)).value;
            let unloaded = system.value(step, &UnloadedTransmissionError(MESH)).value;
            assert!((error - unloaded).abs() < 1e-12);
            errors.push(error);
            times.push(step.time);
        };
        match in_plane {
            false => solved(&options, &parts, |_, system, step| look(system, step)),
            true => in_section(&options, &parts, |system, step| look(system, step)),
        }
        let speed = [TAU, TAU * f64::from(TEETH[0]) / f64::from(TEETH[1])][member];
        let harmonic = |f: fn(f64) -> f64| -> f64 {
            errors.iter().zip(&times).map(|(error, time)| error * f(speed * time) / 6.0).sum()
        };
        let amplitude = harmonic(f64::sin).hypot(harmonic(f64::cos));
        // In the transverse plane helical teeth touch like spur teeth of their transverse pressure
        // angle.
        let transverse_cos = if options.helix.angle() == 0.0 {
            COS
        } else {
            let normal = f64::tan(20_f64.to_radians());
            // The rack is given in the normal plane.
            (1.0 / (1.0 + normal * normal)).sqrt()
        };
        let second_base = 0.5 * MODULE * f64::from(TEETH[1]) * transverse_cos;
        let expected = e / second_base;
        assert!((amplitude / expected - 1.0).abs() < 2e-3, "{member}: {amplitude} {expected}");
        // The rest is a constant: the gears were phased in their positions at time 0.
        let mean: f64 = errors.iter().sum::<f64>() / 12.0;
        for (error, time) in errors.iter().zip(&times) {
            let wave = harmonic(f64::sin) * (speed * time).sin() + harmonic(f64::cos) * (speed * time).cos();
            assert!((error - mean - wave).abs() < 3e-3 * expected, "{error} {mean} {wave}");
        }
    }
}

/// Under load the torque is transmitted as well, and the transmission error is shifted by the
/// runout.
#[test]
fn a_loaded_pair_with_runout_is_in_equilibrium() {
    let options = Options { eccentricity: [1e-5, -2e-5], ..Options::helical(0.35, Hand::Left) };
    solved(&options, &[0.3, 5.3, 10.3, 15.3], |_, system, step| {
        let moment = system.contact_force(step, FIRST)[5];
        assert!((moment / TORQUE + 1.0).abs() < 1e-10, "{moment}");
    });
}

/// Power balance of eccentric rigid gears about their shafts: T1 dθ1 + T2 dθ2 = 0, while the ratio
/// of their torques follows the runout.
#[test]
fn what_a_gear_off_its_shaft_takes_in_at_one_shaft_its_mate_gives_at_the_other() {
    // A nearly vanishing load makes the teeth rigid.
    let plain = Options { torque: 1e-3 * TORQUE, apart: 8e-3, ..Options::spur() };
    let speeds = [TAU, -TAU * f64::from(TEETH[0]) / f64::from(TEETH[1])];
    for (eccentricity, in_plane) in [([1e-4, 0.0], false), ([0.0, -1.5e-4], false), ([1e-4, -1.5e-4], true)] {
        let options = Options { eccentricity, backed: !in_plane, ..plain.clone() };
        let ratio = f64::from(TEETH[1]) / f64::from(TEETH[0]);
        let mut strays = 0.0f64;
        for part in [0.3, 5.3, 10.3, 15.3] {
            let step = 0.01;
            let mut seen = Vec::new();
            let mut look = |system: &System<'_>, step: &StepResult| {
                let torques = [FIRST, SECOND].map(|body| system.contact_force(step, body)[5]);
                seen.push((step.time, step.motion[0], torques));
            };
            let parts = [part - step, part, part + step];
            match in_plane {
                false => solved(&options, &parts, |_, system, step| look(system, step)),
                true => in_section(&options, &parts, |system, step| look(system, step)),
            }
            let [(before, turned, _), (_, _, [first, second]), (after, turned_after, _)] = seen[..] else {
                panic!("three positions")
            };
            let speed = speeds[0] + (turned_after - turned) / (after - before);
            let (taken, given) = (first * speed, second * speeds[1]);
            assert!((taken / given + 1.0).abs() < 1e-5, "{eccentricity:?} {part}: {taken} {given}");
            assert!((first / options.torque + 1.0).abs() < 1e-10, "{first}");
            strays = strays.max((second / first / ratio - 1.0).abs());
        }
        assert!(strays > 1e-3, "{strays}");
    }
}

/// Involutes are insensitive to the centre distance: torques keep the ratio of the numbers of
/// teeth, and the unloaded transmission error is zero.
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
                let error = TransmissionError(MESH)
                    .value(&calyx_runtime::observables::Equilibrium::new(system, step));
                assert!(error.value.abs() < 1e-12, "{apart}: {}", error.value);
            });
        }
    }
}
