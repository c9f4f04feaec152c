//! Load sharing among planets: by symmetry where there is one, by linear theory for pin position
//! errors.

use super::set::{DISTANCE, PLANET_TEETH, SUN_SPEED, SUN_TEETH, Set, SetOptions, TORQUE};
use calyx_runtime::material::Material;
use calyx_runtime::observables::{
    Equilibrium, FilletSide, Gauge, GaugeReading, MaxRootStress, Observable, Reading,
};
use calyx_runtime::scene::{BodyId, PairId};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;

/// Duration of one pitch, s.
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

/// Share of the sun's load on each planet.
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
            let bodies = set.planets.iter().copied().chain([set.sun, set.ring, BodyId(2)]);
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

/// Half a rotation maps the set of four to itself, with the sun half a pitch further: opposite
/// planets carry the same load, half a mesh cycle apart. No symmetry maps a planet to its
/// neighbour.
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

/// Fraction of the cycle at which errors of planets are evaluated.
const PART: f64 = 0.3;

/// Forces of the sun on the planets of a set of three whose second planet has an error.
fn with_errors(options: SetOptions) -> Vec<f64> {
    let set = Set::of(&options).expect("it goes together");
    forces(&set.system(), &set.sun_meshes, PART)
}

/// For a set without errors: derivative of the force on a planet by the rotation of the sun along
/// the line of action, with the forces.
fn stiffness() -> (f64, Vec<f64>) {
    let with = |moment: f64| {
        let set = Set::of(&SetOptions { moment, ..SetOptions::three() }).expect("it goes together");
        let system = set.system();
        let turned = solve(&system, PART).motion[0] * set.mesh(set.sun_meshes[0]).base_radii[0];
        (forces(&system, &set.sun_meshes, PART), turned)
    };
    let ((even, low), (more, high)) = (with(TORQUE), with(1.05 * TORQUE));
    ((more[0] - even[0]) / (high - low), even)
}

/// Checks the load shift of parallel springs of which the second one recedes by `gives`. It loses
/// the stiffness times this distance, minus its share of the redistributed load. With a sun on a
/// fixed axis between three planets, two thirds remain.
fn bears_less(found: &[f64], gives: f64) {
    let (stiffness, even) = stiffness();
    let shift: Vec<f64> = found.iter().zip(&even).map(|(found, even)| found - even).collect();
    let expected = -2.0 / 3.0 * stiffness * gives;
    assert!((shift[1] / expected - 1.0).abs() < 0.03, "{shift:?} {expected}");
    for other in [shift[0], shift[2]] {
        assert!((other / shift[1] + 0.5).abs() < 0.02, "{shift:?}");
    }
}

/// Distance by which a planet recedes along its two lines of action if its pin has the
/// circumferential position error `error`, from the operating pressure angles.
fn gives_by_pin(error: f64) -> f64 {
    let set = Set::of(&SetOptions::three()).expect("it goes together");
    let [planet_radius, ring_radius] = set.mesh(set.ring_meshes[1]).base_radii;
    let sun_radius = planet_radius * 27.0 / 35.0;
    error * ((sun_radius + planet_radius) / DISTANCE + (ring_radius - planet_radius) / DISTANCE)
}

/// A set of three in which the pin of the second planet has the circumferential position error
/// `error`. (The first planet phases the ring.)
fn with_pin(error: f64) -> SetOptions {
    SetOptions { pin_errors: vec![[0.0; 2], [0.0, error], [0.0; 2]], ..SetOptions::three() }
}

/// A planet whose pin is displaced circumferentially by `e` recedes by `e (cos a + cos b)` along
/// its two lines of action. A floating sun moves until all planets carry the same force.
#[test]
fn a_pin_out_of_place_shifts_load_as_linear_theory_says() {
    let error = 1e-6;
    let found = with_errors(with_pin(error));
    bears_less(&found, gives_by_pin(error));
    let set = Set::of(&with_pin(error)).expect("it goes together");
    let mesh = set.mesh(set.ring_meshes[1]);
    let phase_offset = mesh.phase_offset.abs() * mesh.base_radii[1];
    assert!((phase_offset / gives_by_pin(error) - 1.0).abs() < 1e-3, "{phase_offset}");
    // Opposite errors have opposite effects.
    bears_less(&with_errors(with_pin(-error)), gives_by_pin(-error));
    // A floating sun shares its load equally, up to the ten-thousandth by which directions rotate.
    let floating = with_errors(SetOptions { floating: true, ..with_pin(10.0 * error) });
    for force in &floating {
        assert!((force / floating[0] - 1.0).abs() < 2e-3, "{floating:?}");
    }
}

/// Teeth that are thinner by `d` at the pitch circle enter both meshes late, by `d cos(a)` in
/// total.
#[test]
fn thinner_teeth_of_a_planet_shift_load_as_linear_theory_says() {
    let thinner = 1e-6;
    let thicknesses = vec![None, Some(4.45e-3 - thinner), None];
    let found = with_errors(SetOptions { thicknesses, ..SetOptions::three() });
    bears_less(&found, thinner * 24.6_f64.to_radians().cos());
}

/// Runout of a planet: the centre of its teeth is off its axis. At the rotation angle at which the
/// centre is displaced circumferentially, the effect equals that of a pin position error. Half a
/// rotation of the planet later, the effect is opposite.
#[test]
fn runout_of_a_planet_is_a_pin_out_of_place_that_turns_with_it() {
    let error = 1e-6;
    // The circumferential direction at this time in the planet's frame.
    let turned = -SUN_SPEED * f64::from(SUN_TEETH) / f64::from(PLANET_TEETH) * PART * PERIOD;
    let around = |size: f64| [-size * (-turned).sin(), size * (-turned).cos()];
    for size in [error, -error] {
        let runouts = vec![[0.0; 2], around(size), [0.0; 2]];
        let found = with_errors(SetOptions { runouts, ..SetOptions::three() });
        let as_pin = with_errors(with_pin(size));
        bears_less(&found, gives_by_pin(size));
        for (found, expected) in found.iter().zip(&as_pin) {
            assert!((found / expected - 1.0).abs() < 1e-5, "{found} {expected}");
        }
    }
}

/// Unequally spaced planets at feasible positions. Moving all of them by one position gives the
/// same set at another time, because a position is 27/126 of a pitch of the sun.
#[test]
fn unequally_spaced_planets_a_place_further_on_bear_the_same_later() {
    let places = [0.0, 31.0, 60.0, 94.0];
    let set = |by: f64| {
        let options = SetOptions::of(places.map(|place| TAU * (place + by) / 126.0).to_vec());
        Set::of(&options).expect("it goes together")
    };
    let (now, further) = (set(0.0), set(1.0));
    for part in [0.1, 0.6] {
        let expected = shares(&now.system(), &now.sun_meshes, part);
        let found = shares(&further.system(), &further.sun_meshes, part + 27.0 / 126.0);
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 1e-9, "{part}: {found} {expected}");
        }
        // No symmetry makes the shares equal.
        assert!(expected.iter().any(|share| (share - expected[0]).abs() > 1e-4), "{expected:?}");
    }
}

/// The sun loads one flank of a planet's teeth, the ring the other.
#[test]
fn a_gauge_names_the_flank_beside_which_it_is() {
    let mut set = Set::of(&SetOptions::three()).expect("it goes together");
    for body in [set.planets[0], set.sun, set.ring] {
        // Stress is only recovered if it is observed.
        set.scene.add_observable(MaxRootStress(body));
    }
    let system = set.system();
    let step = solve(&system, PART);
    let at = Equilibrium::new(&system, &step);
    let read = |body: BodyId, side: FilletSide| {
        let material = Material::new(206e9, 0.3, 7850.0).expect("steel");
        let place = [1e-3, 0.0];
        let gauge = Gauge { body, place, direction: 0.0, length: 0.0, side, tooth: None, material };
        GaugeReading(gauge, Reading::Stress).value(&at).value
    };
    let [planet, sun, ring] = [set.planets[0], set.sun, set.ring].map(|body| {
        [FilletSide::Flank(0), FilletSide::Flank(1), FilletSide::Loaded, FilletSide::Other]
            .map(|side| read(body, side))
    });
    // The sun pushes counter-clockwise and is loaded on that flank. The planets rotate in the
    // opposite direction and push on that flank of the ring.
    assert!(sun[0] == sun[2] && sun[1] == sun[3] && sun[0] > sun[1], "{sun:?}");
    assert!(ring[0] == ring[2] && ring[1] == ring[3] && ring[0] > ring[1], "{ring:?}");
    assert!(planet[2] == planet[0].max(planet[1]), "{planet:?}");
    assert!(planet[0] > 0.0 && planet[1] > 0.0 && planet[0] != planet[1], "{planet:?}");
}
