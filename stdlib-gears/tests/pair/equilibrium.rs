//! Properties of every position: kinematics of involutes, action and reaction, the certificate, the
//! response to a pitch deviation.

use super::CYCLE;
use crate::common::INCH;
use crate::common::pair::{FIRST, PLAIN, PairOptions, RELIEVED, SECOND, TORQUE, Values, pair, system};
use calyx_runtime::analysis::mesh_cycle;
use calyx_runtime::contact::interior_point;
use calyx_runtime::contact::problem::ContactProblem;
use calyx_runtime::observables::Observe;
use calyx_runtime::step::StepResult;
use nalgebra::{DMatrix, DVector};

#[test]
fn unloaded_involutes_have_no_transmission_error() {
    // The standard distance, and larger ones with a contact ratio above one.
    for distance in [3.0, 3.01, 3.03] {
        for edges in [false, true] {
            let options = PairOptions {
                center_distance: distance * INCH,
                moment: 0.0,
                edges,
                ..PairOptions::chapter_5(&PLAIN)
            };
            let (scene, mesh) = pair(&options);
            let system = system(&scene);
            for position in mesh_cycle(&mesh, 6) {
                let step = system.solve(position.time).expect("it rests");
                let values = Values::of(&system, &step);
                assert!(
                    values.transmission_error.abs() < 1e-9,
                    "{distance} in, edges {edges}, cycle {}: {:e}",
                    position.cycle,
                    values.transmission_error
                );
            }
        }
    }
}

#[test]
fn unmodified_involutes_have_exactly_the_torque_ratio_of_their_teeth() {
    for loaded in [0, 1] {
        let options = PairOptions { loaded, ..PairOptions::chapter_5(&PLAIN) };
        let (scene, mesh) = pair(&options);
        let system = system(&scene);
        for position in mesh_cycle(&mesh, 6) {
            let step = system.solve(position.time).expect("equilibrium");
            let [on_pinion, on_gear] = [FIRST, SECOND].map(|body| system.contact_force(&step, body)[5]);
            // Contact forces on both gears oppose the sense in which the pinion drives.
            assert!(on_pinion < 0.0 && on_gear < 0.0);
            assert!((on_gear / on_pinion / 2.0 - 1.0).abs() < 1e-9, "cycle {}", position.cycle);
            let balanced = if loaded == 0 { on_pinion } else { on_gear };
            assert!((balanced / -TORQUE - 1.0).abs() < 1e-12);
        }
    }
}

#[test]
fn action_is_reaction() {
    // Reliefs, tip edges and several patches; frames away from the origin of ground.
    let options = PairOptions {
        origin: [0.7 * INCH, -1.9 * INCH],
        direction: 0.4,
        edges: true,
        ..PairOptions::chapter_5(&RELIEVED)
    };
    let (scene, mesh) = pair(&options);
    let system = system(&scene);
    for cycle in CYCLE {
        let time = mesh.start + cycle * mesh.period;
        let step = system.solve(time).expect("equilibrium");
        let forces = [FIRST, SECOND].map(|body| system.contact_force(&step, body));
        let (mut total, mut size) = ([0.0; 3], [0.0; 3]);
        for (force, body) in forces.iter().zip(&scene.bodies) {
            let frame = body.motion.frame(time);
            // The frame's origin in ground coordinates, -R't.
            let [x, y] = [0, 1].map(|axis| -(frame[axis] * frame[9] + frame[3 + axis] * frame[10]));
            let moment = force[5] + x * force[1] - y * force[0];
            for (k, part) in [force[0], force[1], moment].into_iter().enumerate() {
                total[k] += part;
                size[k] += part.abs();
            }
            assert_eq!([force[2], force[3], force[4]], [0.0; 3]);
        }
        let across = size[0].hypot(size[1]);
        assert!(across > 1e3, "something is transmitted");
        assert!(total[0].hypot(total[1]) < 1e-12 * across && total[2].abs() < 1e-12 * size[2], "{forces:?}");
    }
}

#[test]
fn a_lighter_or_heavier_load_by_a_million_is_solved() {
    for factor in [1e-6, 1e-3, 1e3, 1e6] {
        for edges in [false, true] {
            let options = PairOptions { moment: factor * TORQUE, edges, ..PairOptions::chapter_5(&RELIEVED) };
            let (scene, mesh) = pair(&options);
            let system = system(&scene);
            for cycle in [0.27, 0.6] {
                let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
                assert!(step.certificate.largest() <= 1e-12, "{factor} {cycle}: {:?}", step.certificate);
                let values = Values::of(&system, &step);
                assert!(values.difference(&values) == 0.0, "{values:?}");
                assert!(values.contact_pressure.max(values.edge_pressure) > 0.0);
            }
        }
    }
}

#[test]
fn every_position_is_certified_and_agrees_with_an_independent_solver() {
    for (gears, edges) in [(&PLAIN, false), (&RELIEVED, true)] {
        let (scene, mesh) = pair(&PairOptions { edges, ..PairOptions::chapter_5(gears) });
        let system = system(&scene);
        for (index, position) in mesh_cycle(&mesh, 8).into_iter().enumerate() {
            let step = system.solve(position.time).expect("equilibrium");
            assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
            if index % 4 == 0 {
                agrees_with_clarabel(&step);
            }
        }
    }
}

fn agrees_with_clarabel(step: &StepResult) {
    let (forces, motion) = interior_point::solve(&step.problem).expect("it solves it too");
    let own: Vec<f64> = step.patches.iter().flat_map(|patch| patch.forces.iter().copied()).collect();
    let objective = step.problem.objective(&own, &step.motion);
    let independent = step.problem.objective(&forces, &motion);
    assert!((independent / objective - 1.0).abs() < 1e-9, "{objective} {independent}");
    let cells: Vec<_> = step.patches.iter().flat_map(|patch| patch.cells().iter().copied()).collect();
    let pressures = |forces: &[f64]| -> Vec<f64> {
        cells.iter().zip(forces).map(|(cell, force)| force / cell.width()).collect()
    };
    let [own, independent] = [pressures(&own), pressures(&forces)];
    let peak = own.iter().copied().fold(0.0, f64::max);
    for (own, independent) in own.iter().zip(&independent) {
        assert!((own - independent).abs() < 1e-3 * peak, "{own} {independent} of {peak}");
    }
}

/// Change of each patch's force by a small increase of the gaps of one patch with a fixed active
/// set: the response of the mesh compliance itself.
fn tangent_response(step: &StepResult, opened: usize, growth: f64) -> Vec<f64> {
    let problem: &ContactProblem = &step.problem;
    let (n, m, active) = (problem.cells(), problem.dofs(), &step.active);
    let patch_of: Vec<usize> = step
        .patches
        .iter()
        .enumerate()
        .flat_map(|(index, patch)| std::iter::repeat_n(index, patch.cells().len()))
        .collect();
    // A dp + C dx = -de, C' dp = 0.
    let size = active.len() + m;
    let matrix = DMatrix::from_fn(size, size, |i, j| match (i < active.len(), j < active.len()) {
        (true, true) => problem.compliance[active[i] * n + active[j]],
        (true, false) => problem.arms[active[i] * m + j - active.len()],
        (false, true) => problem.arms[active[j] * m + i - active.len()],
        (false, false) => 0.0,
    });
    let right =
        DVector::from_fn(
            size,
            |i, _| {
                if i < active.len() && patch_of[active[i]] == opened { -growth } else { 0.0 }
            },
        );
    let change = matrix.lu().solve(&right).expect("a stable contact");
    let mut by_patch = vec![0.0; step.patches.len()];
    for (i, &cell) in active.iter().enumerate() {
        by_patch[patch_of[cell]] += change[i];
    }
    by_patch
}

#[test]
fn a_pitch_error_moves_load_by_stiffness_times_error() {
    let options = PairOptions::chapter_5(&PLAIN);
    let (scene, mesh) = pair(&options);
    let nominal = system(&scene);
    let time = mesh.start + 0.27 * mesh.period;
    let step = nominal.solve(time).expect("equilibrium");
    assert_eq!(step.patches.len(), 2, "two pairs of teeth share the load");
    let base_radius = PLAIN[0].gear().base_radius;
    // A fiftieth of a micrometre along the line of action: the load changes by about half a
    // percent.
    for along in [2e-8, -2e-8] {
        for (opened, patch) in step.patches.iter().enumerate() {
            // The pinion pushes counter-clockwise: a tooth with a positive pitch deviation closes
            // its gap.
            let gears = [PLAIN[0].with_pitch_error(patch.teeth[0], along / base_radius), PLAIN[1].clone()];
            let (scene, _) = pair(&PairOptions { gears, ..options.clone() });
            let moved = system(&scene).solve(time).expect("equilibrium");
            let expected = tangent_response(&step, opened, -along);
            assert!(expected[opened] * along > 0.0);
            for (k, expected) in expected.iter().enumerate() {
                let change = moved.patches[k].force() - step.patches[k].force();
                assert!((change / expected - 1.0).abs() < 0.01, "{along} {k}: {change} {expected}");
            }
        }
    }
}
