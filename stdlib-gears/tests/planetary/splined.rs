//! A ring on spline teeth with clearance: only the spline teeth support it, in one contact problem
//! with the gear teeth.

use super::set::{COARSE, DISTANCE, RING_TEETH, SUN_SPEED, SUN_TEETH, Set, SetOptions, TORQUE};
use crate::common::resources;
use calyx_gears::blank::SplineSupport;
use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::contact::interior_point;
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::error::Subject;
use calyx_runtime::load::{Impulse, Wrench};
use calyx_runtime::observables::{Equilibrium, MaxRootStress, Observable, Rotation, SplineToothLoad};
use calyx_runtime::plan::Plan;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{BodyId, Fidelity};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;

/// Duration of one pitch, s.
const PERIOD: f64 = TAU / SUN_TEETH as f64 / SUN_SPEED;
const LUGS: u16 = 12;
/// Outer radius of the ring, m.
const RADIUS: f64 = 155e-3;
/// Torque on the ring, N m.
const RING_TORQUE: f64 = TORQUE * RING_TEETH as f64 / SUN_TEETH as f64;

fn spline(clearance: f64) -> SplineSupport {
    SplineSupport { clearance, stiffness: Some(6e8), first: 0.05, ..SplineSupport::new(LUGS) }
}

fn solve(system: &System<'_>, part: f64) -> StepResult {
    let step = system.solve(part * PERIOD).expect("equilibrium");
    assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
    step
}

fn spline_tooth_forces(set: &Set, at: &Equilibrium<'_>) -> Vec<f64> {
    let force =
        |spline_tooth| SplineToothLoad { body: set.ring, spline_tooth, radial: false }.value(at).value;
    (0..u32::from(LUGS)).map(force).collect()
}

#[test]
fn spline_teeth_carry_the_ring_and_the_ground_is_in_equilibrium() {
    let options = SetOptions { floating: true, seen_from: 23.0, ..SetOptions::four() };
    // Elastic and rigid spline teeth.
    for (clearance, stiffness) in [(20e-6, Some(6e8)), (150e-6, Some(2e9)), (50e-6, None)] {
        let spline = SplineSupport { stiffness, ..spline(clearance) };
        let set = Set::of(&SetOptions { ring: Some(spline), ..options.clone() }).expect("a set");
        let system = set.system();
        for part in [0.2, 11.7] {
            let step = solve(&system, part);
            let at = Equilibrium::new(&system, &step);
            let scale = TORQUE / DISTANCE;
            let mut total = [0.0, 0.0, TORQUE];
            for body in set.planets.iter().copied().chain([set.sun, set.ring, BodyId(2)]) {
                let of = &set.scene.bodies[body.0];
                let (support, spline_teeth) = (at.support(body), at.spline_forces_on(body));
                for (component, _) in of.free.into_iter().enumerate().filter(|(_, free)| *free) {
                    let size = if component < 3 { scale } else { TORQUE };
                    assert!(support[component].abs() <= 1e-10 * size, "{}: {support:?}", of.name);
                }
                let frame = of.motion.frame(step.time);
                let [x, y] = [0, 1].map(|axis| -(frame[axis] * frame[9] + frame[3 + axis] * frame[10]));
                let [fx, fy, moment] =
                    [0, 1, 5].map(|component| support[component] + spline_teeth[component]);
                total[0] += fx;
                total[1] += fy;
                total[2] += moment + x * fy - y * fx;
            }
            assert!(
                total[0].hypot(total[1]) <= 1e-10 * scale && total[2].abs() <= 1e-10 * TORQUE,
                "{total:?}"
            );
            // The torque rotates the ring through half the clearance plus the deflection of its
            // bore, and its spline teeth carry that torque.
            let forces = spline_tooth_forces(&set, &at);
            let torque: f64 = forces.iter().map(|force| RADIUS * force).sum();
            assert!((torque.abs() / RING_TORQUE - 1.0).abs() < 0.02, "{torque} {RING_TORQUE}");
            let turned = at.deviation(set.ring, 5);
            assert!(turned * torque < 0.0 && turned.abs() > 0.3 * clearance / RADIUS, "{turned}");
            // The same problem solved by the interior-point method.
            let (independent, _) = interior_point::solve(&step.problem).expect("a solution");
            let flanks = 2 * usize::from(LUGS);
            let independent = &independent[independent.len() - flanks..];
            let largest = independent.iter().copied().fold(0.0, f64::max);
            for (found, expected) in step.stops.iter().zip(independent) {
                assert!((found - expected).abs() < 1e-5 * largest, "{found} {expected}");
            }
        }
    }
}

/// Three planets and twelve spline teeth are equivalent after a third of a rotation. With almost no
/// clearance and the torque loading all spline teeth in one direction, their forces equal those of
/// spline teeth without clearance; the outside of the mesh is a circle to within a millionth. The
/// load is small, because the contact layout of bodies that move with their frames is built in
/// place, and that of deflecting bodies is not.
#[test]
fn without_clearance_spline_teeth_bear_as_those_without_play() {
    let options = |clearance| SetOptions {
        ring: Some(spline(clearance)),
        moment: TORQUE / 30.0,
        ..SetOptions::three()
    };
    let sets = [1e-9, 0.0].map(|clearance| {
        let mut set = Set::of(&options(clearance)).expect("a set");
        set.scene.add_observable(MaxRootStress(set.ring));
        set
    });
    let [with_clearance, bound] = [0, 1].map(|k: usize| {
        let system = sets[k].system();
        let step = solve(&system, 0.3);
        let at = Equilibrium::new(&system, &step);
        let stress = MaxRootStress(sets[k].ring).value(&at).value;
        let shares: Vec<f64> = sets[k].ring_meshes.iter().map(|&pair| at.force(pair)).collect();
        (spline_tooth_forces(&sets[k], &at), stress, shares)
    });
    let largest = bound.0.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
    assert!(bound.0.iter().all(|force| force * bound.0[0] > 0.0), "{:?}", bound.0);
    for (spline_tooth, (found, expected)) in with_clearance.0.iter().zip(&bound.0).enumerate() {
        assert!((found - expected).abs() < 3e-5 * largest, "{found} {expected}");
        let third = with_clearance.0[(spline_tooth + 4) % 12];
        assert!((found - third).abs() < 1e-9 * largest, "{found} {third}");
    }
    assert!(
        bound.1 > 0.0 && (with_clearance.1 / bound.1 - 1.0).abs() < 3e-5,
        "{} {}",
        with_clearance.1,
        bound.1
    );
    for share in &with_clearance.2 {
        assert!((share / with_clearance.2[0] - 1.0).abs() < 1e-9, "{:?}", with_clearance.2);
    }
}

/// Closed forms do not contain the bending of a ring between its loaded spline teeth. A rigid ring
/// rotates until all of its spline teeth carry load.
#[test]
fn splines_with_clearance_without_meshes() {
    let clearance = 40e-6;
    let set = Set::of(&SetOptions { ring: Some(spline(clearance)), ..SetOptions::three() }).expect("a set");
    let plan = |fidelity| Plan::new(&set.scene, fidelity, COARSE);
    let refused = plan(Fidelity::Analytic).expect_err("it has no closed form");
    assert_eq!((refused.code, refused.subject), ("E0783", Some(Subject::Body(set.ring.0))));
    assert!(refused.message.contains("\"ring\""), "{}", refused.message);
    let system = set.system_at(Fidelity::Rigid);
    for part in [0.1, 0.6] {
        let step = system.solve(part * PERIOD).expect("it rests");
        let at = Equilibrium::new(&system, &step);
        // Half of the clearance is on either side of each spline tooth; the ring is driven in the
        // direction in which the sun's torque rotates it through the planets.
        let [x, y, turn] = [0, 1, 5].map(|component| at.deviation(set.ring, component));
        assert!((turn.abs() * RADIUS / (0.5 * clearance) - 1.0).abs() < 1e-9, "{turn}");
        assert!(x.hypot(y) < 1e-9 * clearance, "{x} {y}");
        // Planets on fixed pins transmit the rotation to the sun.
        let ratio = at.deviation(set.sun, 5) / turn;
        assert!((ratio.abs() * f64::from(SUN_TEETH) / f64::from(RING_TEETH) - 1.0).abs() < 1e-6, "{ratio}");
    }
}

/// Rows of the forces on all spline teeth and the rotation of the ring, step by step. Modes are
/// requested for the bodies, but the ring on its spline teeth has none.
fn in_time(set: &mut Set, ranges: Vec<TimeRange>, scheme: Scheme, rayleigh: f64) -> Vec<(f64, Vec<f64>)> {
    let ring = set.ring;
    let spline_teeth = (0..u32::from(LUGS)).map(|spline_tooth| {
        set.scene.add_observable(SplineToothLoad { body: ring, spline_tooth, radial: false })
    });
    let mut observed: Vec<_> = spline_teeth.collect();
    observed.push(set.scene.add_observable(Rotation(ring, 2)));
    let outputs: Vec<_> =
        observed.iter().map(|&id| OutputRequest::observing(format!("{}", id.0), id)).collect();
    let dynamics =
        DynamicOptions { from: 0.0, ranges, scheme, rayleigh: [rayleigh, 0.0], start: Start::Equilibrium };
    let highest_frequency = 2e3;
    let options = AnalysisOptions {
        structure: COARSE,
        resources: resources(),
        highest_frequency,
        ..AnalysisOptions::default()
    };
    let history = History::new(&set.scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
    let ignored =
        history.plan().ignored.iter().find(|ignored| ignored.input == "highest_frequency").expect("a value");
    assert!(ignored.reason.contains("\"ring\"") && !ignored.reason.contains("\"sun\""), "{}", ignored.reason);
    history
        .map(|solved| {
            let row = solved.expect("it goes on").row;
            (row.position.time, row.outputs.iter().map(|output| output.value).collect())
        })
        .collect()
}

fn on_loose_lugs(speed: f64) -> Set {
    let ring = Some(spline(30e-6));
    Set::of(&SetOptions { ring, speed, ..SetOptions::three() }).expect("a set")
}

/// Slow motion agrees with statics, spline tooth by spline tooth, while the gear teeth move by a
/// part of their pitch.
#[test]
fn slow_motion_of_a_ring_on_splines_with_clearance_is_statics() {
    let (speed, scheme) = (1e-4 * SUN_SPEED, Scheme::named("backward_difference").expect("it is known"));
    let mut set = on_loose_lugs(speed);
    let pitch = PERIOD * SUN_SPEED / speed;
    let rows =
        in_time(&mut set, vec![TimeRange { keep: 3, ..TimeRange::steady(0.3 * pitch, 6) }], scheme, 0.0);
    let system = set.system();
    for (time, found) in &rows {
        let step = system.solve(*time).expect("equilibrium");
        let at = Equilibrium::new(&system, &step);
        let expected = spline_tooth_forces(&set, &at);
        let largest = expected.iter().fold(0.0_f64, |most, force| most.max(force.abs()));
        for (found, expected) in found.iter().zip(&expected) {
            assert!((found - expected).abs() < 2e-2 * largest, "{time}: {found} {expected}");
        }
    }
    assert_eq!(rows.len(), 3);
}

/// After an impulse the ring moves back and forth between the flanks of its spline teeth, and
/// damping returns it to its equilibrium.
#[test]
fn a_impulse_on_a_ring_on_splines_with_clearance_dies_down_to_its_equilibrium() {
    let mut set = on_loose_lugs(1e-6 * SUN_SPEED);
    let step = 1e-5;
    let momentum = Wrench::of_moment([0.0, 0.0, 0.5]);
    let ring = set.ring;
    set.scene.bodies[ring.0].impulses.push(Impulse { at: 0.0, duration: 4.0 * step, momentum });
    let rows = in_time(&mut set, vec![TimeRange::steady(100.0 * step, 100)], Scheme::AVERAGE, 1.5e4);
    let turn = |row: usize| rows[row].1[usize::from(LUGS)];
    let swing = (1..20).map(|row| (turn(row) - turn(0)).abs()).fold(0.0, f64::max);
    assert!(swing > 0.0 && (turn(100) - turn(0)).abs() < 0.1 * swing, "{swing:e} {:e}", turn(100) - turn(0));
}
