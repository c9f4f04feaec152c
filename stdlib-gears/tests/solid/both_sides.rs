//! Contact on both sides of the teeth: load reversal, and meshes without backlash.

use super::helical::{CYCLE, solved};
use super::pairs::{FIRST, MESH, MODULE, Options, SECOND, TEETH, TORQUE, system};
use crate::common::built;
use calyx_gears::helix::Hand;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::load::Wrench;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    Equilibrium, LoadShare, MaxContactPressure, MeshStiffness, Observable, TransmissionError,
    UnloadedTransmissionError,
};
use calyx_runtime::scene::{Component, Fidelity, GearMesh, PairId, Scene, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Surface pair of the back flanks.
const BACK: PairId = PairId(1);
const STANDARD: f64 = 0.5 * MODULE * (TEETH[0] + TEETH[1]) as f64;

fn both(options: Options) -> Options {
    Options { coast_side_contact: true, ..options }
}

fn base_radii() -> [f64; 2] {
    TEETH.map(|teeth| 0.5 * MODULE * f64::from(teeth) * 20_f64.to_radians().cos())
}

fn force(step: &StepResult, pair: PairId) -> f64 {
    step.patches.iter().filter(|patch| patch.pair == pair.0).map(|patch| patch.force()).sum()
}

/// Normal backlash of a pair that has none at the standard distance.
fn normal_backlash(distance: f64) -> f64 {
    let involute = |angle: f64| angle.tan() - angle;
    let [first, second] = base_radii();
    let angle = ((first + second) / distance).acos();
    2.0 * (first + second) * (involute(angle) - involute(20_f64.to_radians()))
}

/// A reversed load gives the results of a pair designed to drive the other way, at the moment of
/// the same position of the second gear. The transmission error has crossed the backlash.
#[test]
fn a_load_that_reverses_is_carried_by_the_back_sides() {
    let cases = [(Options::spur(), 0.0), (Options::spur(), 0.06), (Options::helical(0.35, Hand::Right), 0.0)];
    for (options, friction) in cases {
        let (mut scene, mesh) = both(options.clone()).scene();
        scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, -TORQUE]));
        let (mut mirror, _) = Options { torque: -TORQUE, ..options }.scene();
        scene.pairs.iter_mut().chain(&mut mirror.pairs).for_each(|pair| pair.friction = friction);
        let speed = -TAU * f64::from(TEETH[0]) / f64::from(TEETH[1]);
        let later = (scene.bodies[1].phase - mirror.bodies[1].phase) / speed;
        let (system, mirrored) =
            (system(&scene, StructureOptions::default()), system(&mirror, StructureOptions::default()));
        let lost = normal_backlash(STANDARD * (1.0 + 1e-3)) / base_radii()[1];
        for part in CYCLE {
            let time = mesh.start + part * mesh.period;
            let (step, other) =
                (system.solve(time).expect("it is held"), mirrored.solve(time + later).expect("it is held"));
            assert!(step.certificate.largest() <= 1e-11, "{:?}", step.certificate);
            assert!(force(&step, MESH) == 0.0 && force(&step, BACK) > 0.0);
            let moment = system.contact_force(&step, FIRST)[5];
            assert!((moment / TORQUE - 1.0).abs() < 1e-10, "{moment}");
            let value = |system: &System<'_>, step: &StepResult, observable: &dyn Observable| {
                system.value(step, observable).value
            };
            let error = value(&system, &step, &TransmissionError(MESH));
            let expected = -lost - value(&mirrored, &other, &TransmissionError(MESH));
            assert!((error / expected - 1.0).abs() < 1e-8, "{error} {expected}");
            assert_eq!(error, value(&system, &step, &TransmissionError(BACK)));
            let unloaded = value(&system, &step, &UnloadedTransmissionError(MESH));
            assert!((unloaded / -lost - 1.0).abs() < 1e-9, "{unloaded} {lost}");
            for (own, other) in [
                (
                    value(&system, &step, &MaxContactPressure(BACK)),
                    value(&mirrored, &other, &MaxContactPressure(MESH)),
                ),
                (value(&system, &step, &MeshStiffness(MESH)), value(&mirrored, &other, &MeshStiffness(MESH))),
                (force(&step, BACK), force(&other, MESH)),
            ] {
                assert!((own / other - 1.0).abs() < 1e-6, "{own} {other}");
            }
            assert_eq!(value(&system, &step, &MaxContactPressure(MESH)), 0.0);
            let share = value(&system, &step, &LoadShare(BACK));
            assert!((0.0..=1.0).contains(&share));
        }
    }
}

/// A gear on a bearing is displaced by force over stiffness, whichever side of its teeth carries
/// load; a bearing relieves the pressure in a mesh without backlash.
#[test]
fn both_sides_carry_on_bearings() {
    let stiffness = 2e8;
    let sprung = |options: &Options, torque: f64| {
        let across = vec![Component::Ux, Component::Uy];
        let (mut scene, mesh) = both(Options { free: across, ..options.clone() }).scene();
        scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, torque]));
        let bearing = Bearing::new("bearing", FIRST, 0.0, axisymmetric(stiffness, 0.0, 0.0, 0.0));
        scene.add_bearing(bearing).expect("a bearing");
        (scene, mesh)
    };
    let constrained = |options: &Options, torque: f64| {
        let (mut scene, mesh) = both(options.clone()).scene();
        scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, torque]));
        (scene, mesh)
    };
    let solve = |(scene, mesh): (Scene, GearMesh)| {
        let system = system(&scene, StructureOptions::default());
        let step = system.solve(mesh.start + 0.45 * mesh.period).expect("it is held");
        assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
        let support = Equilibrium::new(&system, &step).support(FIRST);
        let constrained = scene.bearings.is_empty();
        assert!(
            constrained || support[..2].iter().all(|part| part.abs() < 1e-10 * TORQUE / MODULE),
            "{support:?}"
        );
        let [x, y, ..] = system.contact_force(&step, FIRST);
        (
            [force(&step, MESH), force(&step, BACK)],
            system.value(&step, &TransmissionError(MESH)).value,
            [x, y],
        )
    };
    let spur = Options::spur();
    let [first, second] = base_radii();
    for torque in [TORQUE, -TORQUE] {
        let ([drive, back], error, _) = solve(sprung(&spur, torque));
        let (_, rigid, _) = solve(constrained(&spur, torque));
        assert!((drive + back) * first / TORQUE - 1.0 < 1e-9 && drive.min(back) == 0.0, "{drive} {back}");
        let given = torque / first / stiffness / second;
        assert!(((error - rigid) / given - 1.0).abs() < 1e-3, "{error} {rigid} {given}");
    }
    let tight = Options { apart: -1e-4, torque: 0.0, ..spur };
    let ([drive, back], _, [x, _]) = solve(sprung(&tight, 0.0));
    let ([constrained_drive, _], ..) = solve(constrained(&tight, 0.0));
    assert!(
        (drive / back - 1.0).abs() < 1e-9 && drive < constrained_drive,
        "{drive} {back} {constrained_drive}"
    );
    // The displacement of the axes replaces deflection of the teeth: the secant stiffness is the
    // same with less overlap.
    let moved = -x / stiffness;
    assert!(x < 0.0, "{x}");
    let overlap = 1e-4 * STANDARD;
    let left = 1.0 - moved.abs() / overlap;
    assert!((drive / constrained_drive / left - 1.0).abs() < 0.05, "{drive} {constrained_drive} {left}");
}

/// Under the drive load the back flanks do not touch, and nothing changes except for rounding.
#[test]
fn back_sides_that_do_not_touch_change_nothing() {
    let errors = |options: Options| {
        let mut errors = Vec::new();
        solved(&options, &CYCLE, |_, system, step| {
            errors.push(system.value(step, &TransmissionError(MESH)).value);
        });
        errors
    };
    let (one, other) = (errors(Options::spur()), errors(both(Options::spur())));
    for (one, other) in one.iter().zip(&other) {
        assert!((one / other - 1.0).abs() < 1e-9, "{one} {other}");
    }
}

/// At a centre distance smaller than the teeth permit, both sides carry load: without torque by the
/// same force, and the axes are pushed apart by 2 N sin(pressure angle). A torque is the difference
/// of both forces times the base radius.
#[test]
fn a_tight_mesh_carries_on_both_sides() {
    for options in [Options::spur(), Options::helical(0.35, Hand::Left)] {
        for torque in [0.0, 0.02 * TORQUE, -0.02 * TORQUE] {
            let apart = -1e-4;
            let options = both(Options { torque, apart, ..options.clone() });
            let helix = options.helix.angle();
            solved(&options, &CYCLE, |_, system, step| {
                let [drive, back] = [force(step, MESH), force(step, BACK)];
                assert!(drive > 0.0 && back > 0.0, "{drive} {back}");
                // In helical gears only the transverse part of the normal force transmits torque.
                let base_helix = (helix.tan() * 20_f64.to_radians().cos()).atan();
                let arm = base_radii()[0] * base_helix.cos();
                // The drive side of the mesh follows from the direction of its load.
                let difference = (drive - back) * arm;
                assert!((difference - torque.abs()).abs() < 1e-9 * drive * arm, "{difference} {torque}");
                let angle = ((base_radii()[0] + base_radii()[1]) / (STANDARD * (1.0 + apart))).acos();
                let apart = (drive + back) * base_helix.cos() * angle.sin();
                let [x, ..] = system.contact_force(step, FIRST);
                assert!((x / -apart - 1.0).abs() < 1e-6, "{x} {apart}");
                let [other, ..] = system.contact_force(step, SECOND);
                assert!((other / apart - 1.0).abs() < 1e-6, "{other} {apart}");
            });
        }
    }
}

/// A gear that is free to move towards its mate and is pressed into it crosses the backlash and
/// wedges: F = 2 N sin(pressure angle there).
#[test]
fn a_gear_pressed_into_its_mate_wedges() {
    let pressed = 300.0;
    let (mut scene, mesh) = both(Options { free: vec![Component::Ux], ..Options::spur() }).scene();
    scene.bodies[0].load = Arc::new(Wrench::of_force([pressed, 0.0, 0.0]));
    let system = system(&scene, StructureOptions::default());
    for part in CYCLE {
        let step = system.solve(mesh.start + part * mesh.period).expect("it is held");
        assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
        let [drive, back] = [force(&step, MESH), force(&step, BACK)];
        assert!((drive / back - 1.0).abs() < 1e-9, "{drive} {back}");
        // Without backlash the axes are at the standard distance.
        let expected = pressed / (2.0 * 20_f64.to_radians().sin());
        assert!((drive / expected - 1.0).abs() < 1e-6, "{drive} {expected}");
    }
}

/// The same in two dimensions: a reversed load on the other flanks, and a mesh without backlash and
/// without load.
#[test]
fn both_sides_carry_in_the_plane() {
    let structure = StructureOptions { refinement: 0.5, order: 2, ..StructureOptions::default() };
    let plane = |scene: &Scene, part: f64, mesh: &GearMesh| {
        let system = built(scene, Fidelity::Plane, structure);
        let step = system.solve(mesh.start + part * mesh.period).expect("it is held");
        assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
        let error = system.value(&step, &TransmissionError(MESH)).value;
        ([force(&step, MESH), force(&step, BACK)], error, system.contact_force(&step, FIRST))
    };
    let options = both(Options { backed: false, ..Options::spur() });
    let (mut scene, mesh) = options.scene();
    let ([drive, back], driven, _) = plane(&scene, 0.8, &mesh);
    assert!(drive > 0.0 && back == 0.0);
    scene.bodies[0].load = Arc::new(Wrench::of_moment([0.0, 0.0, -TORQUE]));
    let ([drive, back], reversed, _) = plane(&scene, 0.8, &mesh);
    assert!(drive == 0.0 && back > 0.0);
    let lost = normal_backlash(STANDARD * (1.0 + 1e-3)) / base_radii()[1];
    // One tooth pair touches on the drive side, and two pairs on the back side: their deflection is
    // about two thirds.
    assert!((0.5..0.8).contains(&((-reversed - lost) / driven)), "{reversed} {driven} {lost}");

    let (scene, mesh) = Options { apart: -1e-4, torque: 0.0, ..options }.scene();
    let ([drive, back], _, support) = plane(&scene, 0.8, &mesh);
    assert!(drive > 0.0 && (drive / back - 1.0).abs() < 1e-9, "{drive} {back}");
    let angle = ((base_radii()[0] + base_radii()[1]) / (STANDARD * (1.0 - 1e-4))).acos();
    let width = 8.0 * MODULE;
    assert!((support[0] / (-2.0 * drive * width * angle.sin()) - 1.0).abs() < 1e-6, "{support:?} {drive}");
}
