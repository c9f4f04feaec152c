//! Friction on a single tooth pair that carries the whole load: ratio of the torques from statics.

use crate::common::pair::{FIRST, MESH, PLAIN, PairOptions, SECOND, TORQUE, pair, system};
use calyx_runtime::observables::Observe;

#[test]
fn torques_are_those_of_statics() {
    let friction = 0.06;
    for loaded in [0, 1] {
        let options = PairOptions { loaded, ..PairOptions::chapter_5(&PLAIN) };
        let (mut scene, mesh) = pair(&options);
        scene.pairs[MESH.0].friction = friction;
        let system = system(&scene);
        let [rb1, rb2] = mesh.base_radii;
        let path = (options.center_distance.powi(2) - (rb1 + rb2).powi(2)).sqrt();
        let pitch = path * rb1 / (rb1 + rb2);
        let mut signs = [false; 2];
        for cycle in [0.52, 0.6, 0.7, 0.8, 0.9, 0.98] {
            let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
            assert!(step.certificate.largest() < 1e-12, "{:?}", step.certificate);
            let rho1 = rb1 * (mesh.roll[0] + cycle * (mesh.roll[1] - mesh.roll[0]));
            let rho2 = path - rho1;
            // Profiles slide towards the pitch point before it and away from it after it.
            let s = (rho1 - pitch).signum();
            signs[usize::from(s > 0.0)] = true;
            let expected = (rb2 + s * friction * rho2) / (rb1 + s * friction * rho1);
            let [on_pinion, on_gear] = [FIRST, SECOND].map(|body| system.contact_force(&step, body)[5]);
            assert!(
                (on_gear / on_pinion / expected - 1.0).abs() < 1e-9,
                "cycle {cycle}: {}",
                on_gear / on_pinion
            );
            let balanced = if loaded == 0 { on_pinion } else { on_gear };
            assert!((balanced / -TORQUE - 1.0).abs() < 1e-12);
        }
        assert_eq!(signs, [true; 2], "the pitch point lies between the positions");
    }
}

#[test]
fn friction_takes_power_and_drags_action_as_reaction() {
    // Also with two tooth pairs at a time.
    let (mut scene, mesh) = pair(&PairOptions::chapter_5(&PLAIN));
    let torque_ratio = |friction: f64, cycle: f64, scene: &mut calyx_runtime::scene::Scene| {
        scene.pairs[MESH.0].friction = friction;
        let system = system(scene);
        let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
        let [first, second] = [FIRST, SECOND].map(|body| system.contact_force(&step, body));
        for axis in 0..2 {
            let size = first[axis].abs().max(second[axis].abs());
            assert!((first[axis] + second[axis]).abs() < 1e-12 * size, "{first:?} {second:?}");
        }
        second[5] / first[5]
    };
    for cycle in [0.02, 0.3, 0.83] {
        let [free, dragged] = [0.0, 0.08].map(|friction| torque_ratio(friction, cycle, &mut scene));
        assert!((free / 2.0 - 1.0).abs() < 1e-9);
        assert!(dragged < free && dragged > 0.95 * free, "cycle {cycle}: {dragged} of {free}");
    }
}
