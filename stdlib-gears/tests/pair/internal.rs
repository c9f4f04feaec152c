//! A pinion in an internal gear: the properties of external pairs hold for internal ones.

use super::CYCLE;
use crate::common::built;
use crate::common::pair::{
    COARSE, FIRST, Member, PairOptions, SECOND, Values, member, pair, solve_at, steel, system,
};
use calyx_gears::blank::Rim;
use calyx_gears::external::ExternalGearData;
use calyx_gears::internal::{InternalGear, InternalGearData};
use calyx_gears::modification::{Modification, ReliefShape};
use calyx_gears::prototype::GearPrototype;
use calyx_gears::rack::Rack;
use calyx_gears::shaper::Shaper;
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::bearing::{Bearing, Stop, axisymmetric};
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::observables::Observe;
use calyx_runtime::plan::Plan;
use calyx_runtime::restraint_check;
use calyx_runtime::scene::{Component, Fidelity};
use calyx_runtime::structure::BoreSupport;
use std::sync::LazyLock;

const MODULE: f64 = 4e-3;
const FACE: f64 = 30e-3;
const DISTANCE: f64 = 80e-3;
/// Torque on the pinion, N m.
const TORQUE: f64 = 200.0;

fn pinion() -> Member {
    let rack = Rack::new(MODULE, 20.0_f64.to_radians(), 0.3 * MODULE).expect("a rack");
    let data = ExternalGearData {
        teeth: 20,
        rack,
        tooth_thickness: 6.2e-3,
        outer_radius: 43.2e-3,
        root_radius: 35e-3,
        tip_edge_radius: None,
    };
    member(data, FACE)
}

fn ring(relief: f64) -> Member {
    let shaper =
        Shaper::new(25, MODULE, 20.0_f64.to_radians(), 1.25 * MODULE, 0.2 * MODULE).expect("a shaper");
    let gear = InternalGear::new(InternalGearData {
        teeth: 60,
        shaper,
        tooth_thickness: 6.2e-3,
        minor_radius: 116.8e-3,
        root_radius: 125e-3,
        tip_edge_radius: None,
    })
    .expect("a sound gear");
    let rim = Rim { radius: 127e-3, fixed_radius: 137e-3, web: None, support: BoreSupport::Rigid };
    let relief =
        (relief > 0.0).then(|| Modification::tip_relief(relief, 18_f64.to_radians(), ReliefShape::Quadratic));
    let modifications = relief.into_iter().collect();
    Member::new(GearPrototype::new(gear, modifications, steel(), rim, FACE, Vec::new()).expect("a gear"))
}

static PLAIN: LazyLock<[Member; 2]> = LazyLock::new(|| [pinion(), ring(0.0)]);
static RELIEVED: LazyLock<[Member; 2]> = LazyLock::new(|| [PLAIN[0].clone(), ring(12e-6)]);

fn options(gears: &[Member; 2]) -> PairOptions {
    PairOptions { center_distance: DISTANCE, moment: TORQUE, ..PairOptions::chapter_5(gears) }
}

#[test]
fn unloaded_involutes_have_no_transmission_error() {
    for distance in [DISTANCE, 0.998 * DISTANCE] {
        for (moment, edges) in [(0.0, false), (0.0, true), (-1e-9, false)] {
            let (scene, mesh) =
                pair(&PairOptions { center_distance: distance, moment, edges, ..options(&PLAIN) });
            let system = system(&scene);
            for position in mesh_cycle(&mesh, 6) {
                let step = system.solve(position.time).expect("it rests");
                let error = Values::of(&system, &step).transmission_error;
                assert!(error.abs() < 1e-9, "{distance} {moment} {edges} {}: {error:e}", position.cycle);
            }
        }
    }
}

#[test]
fn unmodified_involutes_have_exactly_the_torque_ratio_of_their_teeth() {
    for loaded in [0, 1] {
        let (scene, mesh) = pair(&PairOptions { loaded, ..options(&PLAIN) });
        let system = system(&scene);
        for position in mesh_cycle(&mesh, 6) {
            let step = system.solve(position.time).expect("equilibrium");
            let [on_pinion, on_ring] = [FIRST, SECOND].map(|body| system.contact_force(&step, body)[5]);
            assert!((on_ring / on_pinion / -3.0 - 1.0).abs() < 1e-9, "cycle {}", position.cycle);
            let balanced = if loaded == 0 { on_pinion } else { on_ring };
            assert!((balanced / -TORQUE - 1.0).abs() < 1e-12);
            assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
        }
    }
}

#[test]
fn a_loaded_ring_lags() {
    for loaded in [0, 1] {
        let (scene, mesh) = pair(&PairOptions { loaded, ..options(&PLAIN) });
        let system = system(&scene);
        let step = system.solve(mesh.start + 0.27 * mesh.period).expect("equilibrium");
        let values = Values::of(&system, &step);
        assert!(values.transmission_error > 0.0 && values.mesh_stiffness > 0.0, "{loaded}: {values:?}");
        assert!(values.root_stress.iter().all(|stress| *stress > 0.0), "{values:?}");
    }
}

#[test]
fn results_repeat_after_a_pitch_and_mirror() {
    for (gears, edges) in [(&PLAIN, false), (&RELIEVED, true)] {
        let options = PairOptions { edges, ..options(gears) };
        let (scene, mesh) = pair(&options);
        let system = system(&scene);
        let mut found = Vec::new();
        for cycle in CYCLE {
            let at = |pitches: f64| {
                let step = system.solve(mesh.start + (cycle + pitches) * mesh.period).expect("equilibrium");
                assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
                Values::of(&system, &step)
            };
            let without_share = |values: Values| Values { load_share: 0.0, ..values };
            let first = at(0.0);
            found.push(first);
            for pitches in [1.0, 7.0, 65.0] {
                let difference = without_share(at(pitches)).difference(&without_share(first));
                assert!(difference < 1e-8, "cycle {cycle}, {pitches} pitches on: {difference:e}");
            }
        }
        let mirrored = PairOptions { moment: -options.moment, speed: -options.speed, ..options.clone() };
        let elsewhere = PairOptions { origin: [0.03, -0.2], direction: 2.1, start: 0.7, ..options.clone() };
        for (what, other) in [("mirrored", mirrored), ("elsewhere", elsewhere)] {
            for (values, expected) in solve_at(&other, &CYCLE).iter().zip(&found) {
                let difference = values.difference(expected);
                assert!(difference < 1e-8, "{what}: {difference:e}\n{values:?}\n{expected:?}");
            }
        }
    }
}

/// Closed forms of a pinion in an internal gear, supported at its outside, compared with finite
/// elements; nothing is fitted. Root stresses of the internal teeth, at the 60 degrees of ISO
/// 6336-3, have the largest error. Rigid teeth are conjugate.
#[test]
fn closed_forms_are_near_the_finite_elements() {
    let (scene, mesh) = pair(&options(&PLAIN));
    let [rigid, given, meshed] = [Fidelity::Rigid, Fidelity::Analytic, Fidelity::Plane].map(|fidelity| {
        let system = built(&scene, fidelity, COARSE);
        let at = |cycle: &f64| {
            Values::of(&system, &system.solve(mesh.start + cycle * mesh.period).expect("equilibrium"))
        };
        CYCLE.iter().map(at).collect::<Vec<Values>>()
    });
    for ((rigid, given), meshed) in rigid.iter().zip(&given).zip(&meshed) {
        assert!(rigid.transmission_error.abs() < 1e-9, "{rigid:?}");
        let near = |given: f64, meshed: f64, part: f64| {
            assert!((given - meshed).abs() < part * meshed.abs(), "{given} {meshed}");
        };
        near(given.transmission_error, meshed.transmission_error, 0.05);
        near(given.mesh_stiffness, meshed.mesh_stiffness, 0.05);
        // The cells of a grid are fitted to each model, and at the ends of the path there are few.
        near(given.contact_pressure, meshed.contact_pressure, 0.12);
        assert!((given.load_share - meshed.load_share).abs() < 0.02, "{given:?} {meshed:?}");
        for gear in 0..2 {
            near(given.root_stress[gear], meshed.root_stress[gear], 0.25);
        }
    }
}

/// An internal gear is stiffer with a thicker rim; a relief unloads the ends of the path.
#[test]
fn rim_and_relief_do_what_they_should() {
    let cycle = [0.02];
    let plain = solve_at(&options(&PLAIN), &cycle)[0];
    let relieved = solve_at(&options(&RELIEVED), &cycle)[0];
    assert!(relieved.transmission_error > plain.transmission_error, "{plain:?} {relieved:?}");
    assert!(relieved.load_share < plain.load_share, "{plain:?} {relieved:?}");
}

/// A pinion that can move towards the axis of the internal gear, with a stop on one side. The line
/// of action determines which side constrains it, and the restraint check knows this before the
/// solution.
#[test]
fn what_holds_a_pinion_in_a_ring_is_known_before_it_is_solved() {
    let mut constrained = Vec::new();
    for side in [1.0, -1.0] {
        let (mut scene, mesh) = pair(&options(&PLAIN));
        scene.bodies[FIRST.0] = scene.bodies[FIRST.0].clone().free_in(&[Component::Ux]);
        let wall = Stop::Wall { clearance: 0.0, direction: [side, 0.0, 0.0, 0.0, 0.0, 0.0], stiffness: 1e9 };
        let bearing = Bearing::new("wall", FIRST, 0.0, axisymmetric(0.0, 0.0, 0.0, 0.0));
        scene.add_bearing(Bearing { stops: vec![wall], ..bearing }).expect("a bearing");
        let plan = Plan::new(&scene, Fidelity::Plane, COARSE).expect("a plan");
        let early = restraint_check::check(&scene, &plan, mesh.start, &Interrupt::never())
            .map_err(|error| error.code);
        let solved =
            system(&scene).solve(mesh.start + 0.3 * mesh.period).map(|_| ()).map_err(|error| error.code);
        assert_eq!(early, solved, "{side}");
        constrained.push(solved);
    }
    constrained.sort();
    assert_eq!(constrained, [Ok(()), Err("E0714")]);
}
