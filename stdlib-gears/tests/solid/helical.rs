//! Exact properties of helical and spur pairs in three dimensions, for any material.

use super::pairs::{FIRST, MESH, MODULE, Options, SECOND, TEETH, TORQUE, system};
use calyx_gears::helix::Hand;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::TransmissionError;
use calyx_runtime::scene::{Component, Scene, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;

const ANGLE: f64 = 0.35;
/// Fractions of the mesh cycle.
pub const CYCLE: [f64; 3] = [0.1, 0.45, 0.8];

/// Solves a pair at fractions of the cycle.
pub fn solved(options: &Options, parts: &[f64], mut look: impl FnMut(&Scene, &System<'_>, &StepResult)) {
    let (scene, mesh) = options.scene();
    let system = system(&scene, StructureOptions::default());
    for part in parts {
        let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
        assert!(step.certificate.largest() <= 1e-11, "{:?}", step.certificate);
        look(&scene, &system, &step);
    }
}

#[test]
fn an_unmodified_helical_pair_pushes_along_its_axis_by_the_tangent_of_its_helix() {
    let reference_radius = 0.5 * MODULE * f64::from(TEETH[0]);
    solved(&Options::helical(ANGLE, Hand::Right), &CYCLE, |_, system, step| {
        let [_, _, axial, _, _, moment] = system.contact_force(step, FIRST);
        assert!((moment / TORQUE + 1.0).abs() < 1e-12, "{moment}");
        let tangential = moment / reference_radius;
        let ratio = axial / tangential;
        assert!((ratio.abs() / ANGLE.tan() - 1.0).abs() < 1e-9, "{ratio} {}", ANGLE.tan());
        // The ratio of the torques equals the ratio of the numbers of teeth.
        let other = system.contact_force(step, SECOND)[5];
        assert!((other / moment * f64::from(TEETH[0]) / f64::from(TEETH[1]) - 1.0).abs() < 1e-9, "{other}");
    });
}

#[test]
fn the_other_hand_is_the_mirror_image() {
    let forces = |hand| {
        let mut all = Vec::new();
        solved(&Options::helical(ANGLE, hand), &CYCLE, |_, system, step| {
            let error = system.value(step, &TransmissionError(MESH)).value;
            let force = system.contact_force(step, FIRST);
            // Mirrored at the mid-face plane.
            let sense = if hand == Hand::Right { 1.0 } else { -1.0 };
            let mirrored = [1.0, 1.0, sense, sense, sense, 1.0];
            all.push((error, std::array::from_fn::<f64, 6, _>(|k| mirrored[k] * force[k])));
        });
        all
    };
    for ((error, force), (mirrored_error, mirrored)) in forces(Hand::Right).iter().zip(&forces(Hand::Left)) {
        assert!((error / mirrored_error - 1.0).abs() < 1e-9, "{error} {mirrored_error}");
        let size = force[5].abs() / MODULE;
        for k in 0..6 {
            let scale = if k < 3 { size } else { force[5].abs() };
            assert!((force[k] - mirrored[k]).abs() < 1e-9 * scale, "{k}: {force:?} {mirrored:?}");
        }
    }
}

/// Sum of the contact forces and moments on all bodies about the origin of ground.
pub fn total(system: &System<'_>, step: &StepResult, origins: &[[f64; 3]]) -> [f64; 6] {
    let mut total = [0.0; 6];
    for (body, [x, y, z]) in [FIRST, SECOND].into_iter().zip(origins) {
        let [fx, fy, fz, mx, my, mz] = system.contact_force(step, body);
        let about = [mx + y * fz - z * fy, my + z * fx - x * fz, mz + x * fy - y * fx];
        for (sum, part) in total.iter_mut().zip([fx, fy, fz].into_iter().chain(about)) {
            *sum += part;
        }
    }
    total
}

#[test]
fn forces_and_moments_of_contact_add_up_to_nothing() {
    let options = Options { face_width: 16.0 * MODULE, ..Options::helical(ANGLE, Hand::Left) };
    let distance = 0.5 * MODULE * f64::from(TEETH[0] + TEETH[1]) * (1.0 + 1e-3);
    solved(&options, &CYCLE, |_, system, step| {
        assert!(step.patches.iter().filter(|patch| patch.force() > 0.0).count() >= 2);
        let total = total(system, step, &[[0.0; 3], [distance, 0.0, 0.0]]);
        let force = TORQUE / (0.5 * MODULE * f64::from(TEETH[0]));
        assert!(total.iter().all(|part| part.abs() <= 1e-10 * force), "{total:?}");
    });
}

#[test]
fn without_load_plain_flanks_touch_without_transmission_error() {
    for options in [Options::spur(), Options::helical(ANGLE, Hand::Right)] {
        solved(&Options { torque: 0.0, ..options }, &CYCLE, |_, system, step| {
            let error = system.value(step, &TransmissionError(MESH)).value;
            assert!(error.abs() < 1e-12, "{error}");
        });
    }
}

#[test]
fn every_pitch_is_like_the_one_before() {
    let mut errors = Vec::new();
    solved(&Options::helical(ANGLE, Hand::Right), &[0.3, 1.3, 2.3], |_, system, step| {
        errors.push(system.value(step, &TransmissionError(MESH)).value);
    });
    assert!(errors.iter().all(|error| (error / errors[0] - 1.0).abs() < 1e-9), "{errors:?}");
}

#[test]
fn a_shaft_that_may_tilt_bears_no_moment_across() {
    // A rotation about the line of action would be unconstrained; a rotation about x is
    // constrained.
    let options = Options { free: vec![Component::ThetaX], ..Options::helical(ANGLE, Hand::Right) };
    solved(&options, &CYCLE, |_, system, step| {
        let [_, _, _, across, _, moment] = system.contact_force(step, FIRST);
        assert!(across.abs() <= 1e-10 * moment.abs(), "{across}");
    });
}
