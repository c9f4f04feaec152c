//! Invariance of the results: another pitch, the opposite flanks, the opposite order, another
//! position, another scale, positions solved before.

use super::CYCLE;
use crate::common::INCH;
use crate::common::pair::{
    PLAIN, PairOptions, RELIEVED, Scale, TORQUE, Values, chapter_5_member, pair, solve_at, system,
};
use std::f64::consts::PI;

/// Cases without modifications and with tip relief, with and without contact on tip edges.
fn chapter_5_cases() -> Vec<PairOptions> {
    [&PLAIN, &RELIEVED]
        .into_iter()
        .flat_map(|gears| [true, false].map(|edges| PairOptions { edges, ..PairOptions::chapter_5(gears) }))
        .collect()
}

fn assert_same(found: &[Values], expected: &[Values], tolerance: f64, what: &str) {
    for ((found, expected), cycle) in found.iter().zip(expected).zip(CYCLE) {
        let difference = found.difference(expected);
        assert!(difference < tolerance, "{what}, cycle {cycle}: {difference:e}\n{found:?}\n{expected:?}");
    }
}

#[test]
fn results_repeat_after_a_pitch() {
    for options in chapter_5_cases() {
        let (scene, mesh) = pair(&options);
        let system = system(&scene);
        for cycle in CYCLE {
            // All values except the load share, which belongs to one tooth pair.
            let at = |pitches: f64| {
                let step = system.solve(mesh.start + (cycle + pitches) * mesh.period).expect("equilibrium");
                Values { load_share: 0.0, ..Values::of(&system, &step) }
            };
            let first = at(0.0);
            for pitches in [1.0, 7.0, 33.0] {
                let difference = at(pitches).difference(&first);
                assert!(difference < 1e-8, "cycle {cycle}, {pitches} pitches on: {difference:e}");
            }
        }
    }
}

#[test]
fn drive_and_coast_give_the_same_answer() {
    for options in chapter_5_cases() {
        let expected = solve_at(&options, &CYCLE);
        let mirrored = PairOptions { moment: -options.moment, speed: -options.speed, ..options.clone() };
        assert_same(&solve_at(&mirrored, &CYCLE), &expected, 1e-9, "mirrored");

        // If the moment opposes the rotation, a pair traverses the path of contact in the opposite
        // direction.
        let braking = PairOptions { moment: -options.moment, ..options.clone() };
        let (_, mesh) = pair(&options);
        let ratio = mesh.characteristic[1].time / mesh.period;
        let backward: Vec<f64> = CYCLE.iter().map(|cycle| (ratio - cycle).rem_euclid(1.0)).collect();
        let without_share = |values: Vec<Values>| {
            values.into_iter().map(|v| Values { load_share: 0.0, ..v }).collect::<Vec<_>>()
        };
        let found = without_share(solve_at(&braking, &backward));
        assert_same(&found, &without_share(expected), 1e-8, "braking");
    }
}

/// The same pair with the gear listed first; all positions are unchanged.
fn swapped(options: &PairOptions) -> PairOptions {
    let (scene, _) = pair(options);
    let [first, second] = options.gears.clone();
    let ratio = f64::from(second.gear().teeth) / f64::from(first.gear().teeth);
    PairOptions {
        gears: [second, first],
        loaded: 1 - options.loaded,
        start: scene.bodies[1].phase,
        speed: -options.speed / ratio,
        origin: [options.center_distance, 0.0],
        direction: PI,
        ..options.clone()
    }
}

/// Values of a swapped pair converted to those of the pair: the transmission error is that of the
/// other member.
fn unswapped(values: Values, ratio: f64) -> Values {
    let [second, first] = values.root_stress;
    Values { transmission_error: values.transmission_error / ratio, root_stress: [first, second], ..values }
}

#[test]
fn swapping_the_members_changes_names_only() {
    let compare = |options: &PairOptions, swapped: &PairOptions| {
        let found: Vec<Values> =
            solve_at(swapped, &CYCLE).into_iter().map(|values| unswapped(values, 2.0)).collect();
        assert_same(&found, &solve_at(options, &CYCLE), 1e-8, "swapped");
    };
    for options in chapter_5_cases() {
        compare(&options, &swapped(&options));
    }
    // Unmodified gears on the nominal path are symmetric: the gear may be loaded and the pinion
    // support it.
    let options = PairOptions::chapter_5(&PLAIN);
    let gear_loaded = PairOptions { loaded: 0, moment: 2.0 * TORQUE, ..swapped(&options) };
    compare(&options, &gear_loaded);
}

#[test]
fn the_whole_scene_turned_and_shifted_gives_the_same_answer() {
    for options in chapter_5_cases() {
        let angle = 37.0_f64.to_radians();
        let moved = PairOptions {
            start: options.start + angle,
            direction: options.direction + angle,
            origin: [0.7 * INCH, -1.9 * INCH],
            ..options.clone()
        };
        assert_same(&solve_at(&moved, &CYCLE), &solve_at(&options, &CYCLE), 1e-9, "turned");
    }
}

#[test]
fn positions_solved_before_do_not_change_a_bit() {
    for options in chapter_5_cases() {
        let (scene, mesh) = pair(&options);
        let times = CYCLE.map(|cycle| mesh.start + cycle * mesh.period);
        let forward = system(&scene);
        let expected = times.map(|time| forward.solve(time).expect("equilibrium"));
        let backward = system(&scene);
        for (time, expected) in times.iter().zip(&expected).rev() {
            let step = backward.solve(*time).expect("equilibrium");
            assert_eq!(step.motion, expected.motion);
            for (patch, expected) in step.patches.iter().zip(&expected.patches) {
                assert_eq!(patch.forces, expected.forces);
            }
            assert_eq!(Values::of(&backward, &step), Values::of(&forward, expected));
        }
    }
}

#[test]
fn scaling_modulus_forces_and_lengths_scales_the_answer() {
    let cycles = [0.27, 0.51];
    let expected = solve_at(&PairOptions { edges: true, ..PairOptions::chapter_5(&RELIEVED) }, &cycles);
    for (length, modulus) in [(3.7e4, 3.7e-4), (3.7e-4, 3.7e4), (1.0, 3.7e4)] {
        let scale = Scale { length, modulus };
        let gears = [20, 40].map(|teeth| chapter_5_member(teeth, 0.0005, scale));
        let scaled = PairOptions {
            center_distance: 3.0 * INCH * length,
            moment: TORQUE * modulus * length.powi(3),
            edges: true,
            ..PairOptions::chapter_5(&gears)
        };
        for (found, expected) in solve_at(&scaled, &cycles).iter().zip(&expected) {
            let [first, second] = found.root_stress;
            let unscaled = Values {
                mesh_stiffness: found.mesh_stiffness / (modulus * length),
                contact_pressure: found.contact_pressure / modulus,
                edge_pressure: found.edge_pressure / modulus,
                root_stress: [first / modulus, second / modulus],
                ..*found
            };
            let difference = unscaled.difference(expected);
            assert!(difference < 1e-9, "{length} {modulus}: {difference:e}\n{unscaled:?}\n{expected:?}");
        }
    }
}
