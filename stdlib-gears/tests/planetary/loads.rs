//! How planets share the load: by symmetry where there is one, by linear theory where pins are out of place.

use crate::set::{DISTANCE, SUN_SPEED, SUN_TEETH, Set, SetOptions, TORQUE};
use calyx_runtime::observe::Equilibrium;
use calyx_runtime::scene::PairId;
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;

/// s, of one pitch.
const PERIOD: f64 = TAU / SUN_TEETH as f64 / SUN_SPEED;

fn solve(system: &System<'_>, part: f64) -> StepResult {
    let step = system.solve(part * PERIOD).expect("equilibrium");
    assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
    step
}

fn forces(system: &System<'_>, pairs: &[PairId], part: f64) -> Vec<f64> {
    let step = solve(system, part);
    let at = Equilibrium::new(system, &step);
    pairs.iter().map(|&pair| at.force(pair)).collect()
}

/// What of the sun's load each planet bears.
fn shares(system: &System<'_>, pairs: &[PairId], part: f64) -> Vec<f64> {
    let forces = forces(system, pairs, part);
    let total: f64 = forces.iter().sum();
    forces.iter().map(|force| force / total).collect()
}

#[test]
fn every_body_and_the_ground_are_in_equilibrium() {
    let floating = SetOptions { floating: true, seen_from: 23.0, ..SetOptions::four() };
    for options in [SetOptions::three(), floating.clone(), SetOptions { bearings: Some(4e8), ..floating }] {
        let set = Set::of(&options).expect("it goes together");
        let system = set.system();
        for part in [0.2, 0.7, 11.9] {
            let step = solve(&system, part);
            let at = Equilibrium::new(&system, &step);
            let scale = TORQUE / DISTANCE;
            let mut total = [0.0, 0.0, TORQUE];
            let bodies =
                set.planets.iter().copied().chain([set.sun, set.ring, calyx_runtime::scene::BodyId(2)]);
            for body in bodies {
                let of = &set.scene.bodies[body.0];
                let support = at.support(body);
                for (component, free) in of.free.into_iter().enumerate().filter(|(_, free)| *free) {
                    let size = if component < 3 { scale } else { TORQUE };
                    assert!(free && support[component].abs() <= 1e-10 * size, "{}: {support:?}", of.name);
                }
                let frame = of.motion.frame(step.time);
                let [x, y] = [0, 1].map(|axis| -(frame[axis] * frame[9] + frame[3 + axis] * frame[10]));
                total[0] += support[0];
                total[1] += support[1];
                total[2] += support[5] + x * support[1] - y * support[0];
            }
            assert!(
                total[0].hypot(total[1]) <= 1e-10 * scale && total[2].abs() <= 1e-10 * TORQUE,
                "{total:?}"
            );
        }
    }
}

#[test]
fn three_planets_in_phase_share_the_load_equally() {
    for floating in [false, true] {
        let set = Set::of(&SetOptions { floating, ..SetOptions::three() }).expect("it goes together");
        let system = set.system();
        for part in [0.0, 0.21, 0.48, 0.73, 17.6] {
            for pairs in [&set.sun_meshes, &set.ring_meshes] {
                for share in shares(&system, pairs, part) {
                    assert!((share * 3.0 - 1.0).abs() < 1e-9, "{floating} {part}: {share}");
                }
            }
        }
    }
}

/// Half a turn takes the set of four into itself, with the sun half a pitch on: opposite planets bear the same, half a mesh cycle apart. Nothing
/// takes a planet to its neighbour.
#[test]
fn of_four_planets_only_opposite_ones_share_equally() {
    let set = Set::of(&SetOptions::four()).expect("it goes together");
    assert!(set.warnings.is_empty(), "{:?}", set.warnings);
    let system = set.system();
    let mut means = [0.0; 4];
    for sample in 0..8 {
        let part = f64::from(sample) / 8.0 + 0.03;
        let now = shares(&system, &set.sun_meshes, part);
        let later = shares(&system, &set.sun_meshes, part + 0.5);
        for (planet, opposite) in [(0, 2), (1, 3), (2, 0), (3, 1)] {
            assert!((now[planet] - later[opposite]).abs() < 1e-9, "{part}: {now:?} {later:?}");
        }
        means = std::array::from_fn(|planet| means[planet] + now[planet] / 8.0);
    }
    assert!((means[0] - means[2]).abs() < 1e-9 && (means[1] - means[3]).abs() < 1e-9, "{means:?}");
    assert!((means[0] - means[1]).abs() > 1e-5, "{means:?}");
}

/// A planet whose pin is moved on around by `e` gives way by `e (cos a + cos b)` along its two lines of action. Of springs side by side it then
/// bears less by their stiffness times that, less what all share of it: a sun that rests between three planets leaves two thirds. One that
/// floats goes where all bear the same.
#[test]
fn a_pin_out_of_place_shifts_load_as_linear_theory_says() {
    let error = 1e-6;
    let part = 0.3;
    let with = |error: f64, floating: bool, moment: f64| {
        let options = SetOptions { floating, moment, ..SetOptions::three() };
        // Not of the first one, which phases the ring.
        let pin_errors = vec![[0.0; 2], [0.0, error], [0.0; 2]];
        let set = Set::of(&SetOptions { pin_errors, ..options }).expect("it goes together");
        let system = set.system();
        let step = solve(&system, part);
        let turned = step.motion[0];
        let radius = set.mesh(set.sun_meshes[0]).base_radii[0];
        let found = forces(&system, &set.sun_meshes, part);
        (found, turned * radius, set.mesh(set.ring_meshes[1]).clone())
    };
    let (even, low, _) = with(0.0, false, TORQUE);
    let (more, high, _) = with(0.0, false, 1.05 * TORQUE);
    let stiffness = (more[0] - even[0]) / (high - low);
    let (found, _, ring) = with(error, false, TORQUE);
    // Operating pressure angles, by the base radii.
    let [planet_radius, ring_radius] = ring.base_radii;
    let sun_radius = planet_radius * 27.0 / 35.0;
    let cosines = [(sun_radius + planet_radius) / DISTANCE, (ring_radius - planet_radius) / DISTANCE];
    let gives = error * (cosines[0] + cosines[1]);
    assert!((ring.stand_off.abs() * ring_radius / gives - 1.0).abs() < 1e-3, "{} {gives}", ring.stand_off);
    let shift: Vec<f64> = found.iter().zip(&even).map(|(found, even)| found - even).collect();
    let expected = -2.0 / 3.0 * stiffness * gives;
    assert!((shift[1] / expected - 1.0).abs() < 0.03, "{shift:?} {expected}");
    for other in [shift[0], shift[2]] {
        assert!((other / shift[1] + 0.5).abs() < 0.02, "{shift:?}");
    }
    // Opposite errors shift opposite ways.
    let (back, ..) = with(-error, false, TORQUE);
    assert!(((back[1] - even[1]) / shift[1] + 1.0).abs() < 0.02, "{back:?}");
    // A floating sun shares out evenly what it bears, but for the tenth of a thousandth that directions turn.
    let (floating, ..) = with(10.0 * error, true, TORQUE);
    for force in &floating {
        assert!((force / floating[0] - 1.0).abs() < 2e-3, "{floating:?}");
    }
}

/// Thinner teeth come late in both meshes: that planet bears less.
#[test]
fn a_planet_with_thinner_teeth_bears_less() {
    let thicknesses = vec![None, Some(4.446e-3), None];
    let set = Set::of(&SetOptions { thicknesses, ..SetOptions::three() }).expect("it goes together");
    let system = set.system();
    let found = shares(&system, &set.sun_meshes, 0.3);
    assert!(found[1] < found[0] - 1e-3 && (found[0] - found[2]).abs() < 2e-3, "{found:?}");
}
