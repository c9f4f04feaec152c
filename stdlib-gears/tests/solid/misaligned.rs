//! Misaligned axes: load that moves to one end of the face, and invariants.

use super::helical::{CYCLE, solved, total};
use super::pairs::{FIRST, MESH, MODULE, Options, SECOND, TEETH, TORQUE, system};
use crate::common::built;
use calyx_gears::assembly::Misalignment;
use calyx_gears::helix::Hand;
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::motion::tilted_axes;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    Equilibrium, FaceLoadFactor, LoadedFace, MaxContactPressure, MeshStiffness, Observable, TransmissionError,
};
use calyx_runtime::scene::{Fidelity, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;

const BASE_RADIUS: f64 = 0.5 * MODULE * TEETH[0] as f64 * 0.939_692_620_785_908_4;

fn in_action(angle: f64) -> Misalignment {
    Misalignment { in_action: angle, off_action: 0.0 }
}

fn value(system: &System<'_>, step: &StepResult, observable: &dyn Observable) -> f64 {
    system.value(step, observable).value
}

/// Axial position of the resultant load, m from the middle of the face.
pub fn centroid(system: &System<'_>, step: &StepResult) -> f64 {
    let at = Equilibrium::new(system, step);
    let (mut force, mut moment) = (0.0, 0.0);
    for slice in at.contacts(MESH).flat_map(|contact| contact.slices()) {
        force += slice.force;
        moment += slice.force * slice.point[2];
    }
    moment / force
}

#[test]
fn a_pair_that_leans_as_a_whole_has_the_same_results() {
    let axis = [0.6 * 0.06_f64.sin(), -0.8 * 0.06_f64.sin(), 0.06_f64.cos()];
    // The rows of `swung` are images of axes.
    let rotation = [0, 1, 2].map(|i| [0, 1, 2].map(|j: usize| tilted_axes(axis)[j][i]));
    let place = Pose { rotation, origin: [0.3, -0.2, 0.1] };
    let edges = |options: Options| Options { edges: true, ..options };
    let helical = || Options::helical(0.35, Hand::Right);
    let pairs = [Options::spur(), helical(), edges(Options::spur()), edges(helical())];
    // The helical pairs vary by 2e-9, the others by less than 1e-10. Rounding determines which
    // cells the ends of the face cut.
    for (options, of_error) in pairs.into_iter().zip([1e-9, 1e-8, 1e-9, 1e-8]) {
        let options = Options { misalignment: in_action(1e-4), ..options };
        let all = |options: Options| {
            let mut all = Vec::new();
            solved(&options, &CYCLE, |_, system, step| {
                let observed: [&dyn Observable; 4] = [
                    &TransmissionError(MESH),
                    &FaceLoadFactor(MESH),
                    &MeshStiffness(MESH),
                    &MaxContactPressure(MESH),
                ];
                all.push(observed.map(|observable| value(system, step, observable)));
            });
            all
        };
        let (here, there) = (all(options.clone()), all(Options { place, ..options }));
        for (one, other) in here.iter().zip(&there) {
            for k in 0..4 {
                // The peak pressure depends on few cells, and the load factor on one window;
                // rounding determines where the ends of the face cut them.
                let tolerance = [of_error, 1e-8, 1e-8, 1e-6][k];
                assert!((one[k] / other[k] - 1.0).abs() < tolerance, "{k}: {here:?} {there:?}");
            }
        }
    }
}

#[test]
fn a_misalignment_of_nothing_changes_nothing() {
    let errors = |place: Pose| {
        let mut errors = Vec::new();
        solved(&Options { place, ..Options::spur() }, &CYCLE, |_, system, step| {
            errors.push(value(system, step, &TransmissionError(MESH)).to_bits());
        });
        errors
    };
    // Rotated forth and back: the matrix has entries that differ from zero by rounding only.
    let almost = Pose { rotation: tilted_axes([1e-17, -1e-17, 1.0]), ..Pose::IDENTITY };
    let (aligned, close) = (errors(Pose::IDENTITY), errors(almost));
    for (one, other) in aligned.into_iter().zip(close).map(|(a, b)| (f64::from_bits(a), f64::from_bits(b))) {
        assert!((one - other).abs() < 1e-12 * one.abs(), "{one} {other}");
    }
}

/// The load moves towards the end where the flanks approach each other; opposite misalignments are
/// mirror images.
#[test]
fn opposite_misalignments_are_mirror_images() {
    let of = |angle: f64| {
        let mut all = Vec::new();
        solved(&Options { misalignment: in_action(angle), ..Options::spur() }, &CYCLE, |_, system, step| {
            all.push([
                centroid(system, step),
                value(system, step, &TransmissionError(MESH)),
                value(system, step, &FaceLoadFactor(MESH)),
                value(system, step, &MaxContactPressure(MESH)),
            ]);
        });
        all
    };
    let (towards, away) = (of(3e-4), of(-3e-4));
    for (one, other) in towards.iter().zip(&away) {
        assert!(one[0] > 0.5 * MODULE, "{one:?}");
        assert!((one[0] + other[0]).abs() < 1e-8 * one[0], "{one:?} {other:?}");
        for k in 1..4 {
            assert!((one[k] / other[k] - 1.0).abs() < 1e-8, "{k}: {one:?} {other:?}");
        }
    }
}

/// A tilt in the plane perpendicular to the plane of action moves flanks along each other, without
/// a first-order effect.
#[test]
fn a_tilt_off_the_plane_of_action_hardly_matters() {
    let shift = |misalignment| {
        let mut shifts = Vec::new();
        solved(&Options { misalignment, ..Options::spur() }, &CYCLE, |_, system, step| {
            shifts.push(centroid(system, step));
        });
        shifts
    };
    let angle = 2e-4;
    let (full, none) = (shift(in_action(angle)), shift(Misalignment { in_action: 0.0, off_action: angle }));
    for (full, none) in full.iter().zip(&none) {
        assert!(none.abs() < 1e-2 * full, "{full} {none}");
    }
}

/// Misaligned rigid teeth touch at one end of the face. The gap in the middle is half of the face
/// width times the angle.
#[test]
fn without_load_misaligned_teeth_touch_at_one_end() {
    let angle = 1e-3;
    let options = Options { misalignment: in_action(angle), torque: 0.0, ..Options::spur() };
    let second_base_radius = BASE_RADIUS * f64::from(TEETH[1]) / f64::from(TEETH[0]);
    let expected = -angle * 0.5 * options.face_width / second_base_radius;
    solved(&options, &CYCLE, |_, system, step| {
        let error = value(system, step, &TransmissionError(MESH));
        assert!((error.abs() / expected.abs() - 1.0).abs() < 2e-3, "{error} {expected}");
    });
}

/// Teeth that touch at one end only: edge loads are finite, and all forces are in equilibrium.
#[test]
fn teeth_that_touch_at_one_end_are_in_equilibrium() {
    for options in [Options::spur(), Options::helical(0.35, Hand::Left)] {
        let options = Options { misalignment: in_action(4e-3), torque: 0.3 * TORQUE, ..options };
        let distance = 0.5 * MODULE * f64::from(TEETH[0] + TEETH[1]) * (1.0 + options.apart);
        solved(&options, &CYCLE, |_, system, step| {
            let loaded = value(system, step, &LoadedFace(MESH));
            assert!((0.02..0.9).contains(&loaded), "{loaded}");
            let pressure = value(system, step, &MaxContactPressure(MESH));
            let edge = value(system, step, &calyx_runtime::observables::MaxEdgePressure(MESH));
            let largest = pressure.max(edge);
            assert!((0.5e9..2e10).contains(&largest), "{largest}");
            let moment = system.contact_force(step, FIRST)[5];
            assert!((moment / (0.3 * TORQUE) + 1.0).abs() < 1e-10, "{moment}");
            let total = total(system, step, &[[0.0; 3], [distance, 0.0, 0.0]]);
            let force = TORQUE / (0.5 * MODULE * f64::from(TEETH[0]));
            assert!(total.iter().all(|part| part.abs() <= 1e-10 * force), "{total:?}");
            // About its own axis the second gear carries the first one's moment times the gear
            // ratio, up to the square of the angle.
            let other = system.contact_force(step, SECOND)[5];
            let ratio = other / moment * f64::from(TEETH[0]) / f64::from(TEETH[1]);
            assert!((ratio - 1.0).abs() < 1e-2, "{ratio}");
        });
    }
}

/// Shift of the load by misalignment. With a stiffness c per face width b, force F and angle f in
/// the plane of action, the load is linear along the face as long as all of it carries load. Its
/// centre is off the middle by c f b³ / 12 F, and K_Hbeta = 1 + c f b² / 2 F (ISO 6336-1, stiff
/// bodies under the teeth). Here c is the mesh stiffness of teeth and rims under a uniform load,
/// for K_Hbeta its mean over the mesh cycle.
///
/// The coupling of the teeth along the face makes them stiffer under a load of alternating sign
/// than under a uniform one, because compliance decreases with the wavenumber. The centre is
/// therefore 16 % farther off than c predicts. The free ends of a face are more compliant than its
/// middle and carry less than the straight line, which brings the largest load back to the
/// prediction within 2 %.
#[test]
fn the_load_moves_as_that_of_a_uniform_stiffness() {
    let structure = StructureOptions {
        refinement: 0.5,
        order: 2,
        face_elements: Some(2),
        axial_order: Some(4),
        ..StructureOptions::default()
    };
    let aligned = Options { backed: false, half_cells: [6, 8], ..Options::spur() };
    const POSITIONS: usize = 8;
    let part = 0.8;
    // Centre of the load, K_Hbeta of the cycle, and stiffness, at a position and in the cycle.
    let solve = |misalignment| {
        let (scene, mesh) = Options { misalignment, ..aligned.clone() }.scene();
        let system = system(&scene, structure);
        let at = |part: f64| {
            let step = system.solve(mesh.start + part * mesh.period).expect("it can be solved");
            assert!(step.certificate.largest() <= 1e-11, "{:?}", step.certificate);
            step
        };
        let step = at(part);
        let uniform = (0..POSITIONS).map(|position| (position as f64 + 0.5) / POSITIONS as f64);
        let stiffness = uniform.map(|part| value(&system, &at(part), &MeshStiffness(MESH)));
        [
            centroid(&system, &step),
            value(&system, &step, &FaceLoadFactor(MESH)),
            value(&system, &step, &MeshStiffness(MESH)),
            stiffness.sum::<f64>() / POSITIONS as f64,
        ]
    };
    let angle = 1e-4;
    let ([middle, even, stiffness, mean_stiffness], [shift, factor, ..]) =
        (solve(in_action(0.0)), solve(in_action(angle)));
    let (force, face) = (TORQUE / BASE_RADIUS, aligned.face_width);
    let by_load = |stiffness: f64| stiffness / face * angle * face * face / force;
    let (expected_shift, expected_factor) =
        (by_load(stiffness) * face / 12.0, 1.0 + 0.5 * by_load(mean_stiffness));
    assert!(middle.abs() < 1e-6 * face, "{middle}");
    assert!((1.0..1.18).contains(&(shift / expected_shift)), "{shift} {expected_shift}");
    assert!(
        ((factor / even - 1.0) / (expected_factor - 1.0) - 1.0).abs() < 0.02,
        "{factor} {even} {expected_factor}"
    );
}

/// The closest approach of misaligned gears is at the end of the face. The grid on the side of it
/// that exists must reach the end of the load. It was half as long as its corrections intended, and
/// the load per length was too large by a fifth.
#[test]
fn the_grid_of_a_misaligned_pair_covers_its_load() {
    for angle in [2e-4, 5e-4, -5e-4] {
        let face_width = 12.0 * MODULE;
        let options =
            Options { backed: false, face_width, misalignment: in_action(angle), ..Options::spur() };
        let (scene, mesh) = options.scene();
        let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
        for part in CYCLE {
            let step = system.solve(mesh.start + part * mesh.period).expect("equilibrium");
            let at = Equilibrium::new(&system, &step);
            for contact in at.contacts(MESH) {
                let mut slices: Vec<[f64; 2]> =
                    contact.slices().iter().map(|slice| [slice.point[2], slice.force]).collect();
                slices.sort_by(|a, b| a[0].total_cmp(&b[0]));
                let inner = if slices[0][1] > 0.0 { slices[slices.len() - 1] } else { slices[0] };
                println!("{angle} {part}: {inner:?} {}", slices.len());
                let half = 0.5 * (slices[1][0] - slices[0][0]);
                let at_the_other_end = inner[0].abs() + half > 0.49 * face_width;
                assert!(inner[1] == 0.0 || at_the_other_end, "{angle} {part}: {slices:?}");
            }
        }
    }
}
