//! Planetary sets at the fidelity levels without meshes: exact properties hold, and the error of
//! closed forms is small.

use super::set::{SUN_SPEED, SUN_TEETH, Set, SetOptions, TORQUE};
use calyx_runtime::observables::{Equilibrium, MaxRootStress, MeshStiffness, Observable, TransmissionError};
use calyx_runtime::scene::{Fidelity, PairId};
use std::f64::consts::TAU;

const PERIOD: f64 = TAU / SUN_TEETH as f64 / SUN_SPEED;
const PARTS: [f64; 3] = [0.1, 0.45, 0.8];

/// At each position, for every mesh with the sun and then every mesh with the ring: force (N),
/// transmission error (rad) and stiffness; and the stresses of sun and ring.
fn seen(options: &SetOptions, fidelity: Fidelity) -> Vec<(Vec<[f64; 3]>, [f64; 2])> {
    let mut set = Set::of(options).expect("it goes together");
    for body in [set.sun, set.ring] {
        set.scene.add_observable(MaxRootStress(body));
    }
    let system = set.system_at(fidelity);
    let at = |part: &f64| {
        let step = system.solve(part * PERIOD).expect("equilibrium");
        assert!(step.certificate.largest() <= 1e-12, "{:?}", step.certificate);
        let at = Equilibrium::new(&system, &step);
        let mesh = |pair: &PairId| {
            let error = TransmissionError(*pair).value(&at).value;
            [at.force(*pair), error, MeshStiffness(*pair).value(&at).value]
        };
        let meshes = set.sun_meshes.iter().chain(&set.ring_meshes).map(mesh).collect();
        (meshes, [set.sun, set.ring].map(|body| MaxRootStress(body).value(&at).value))
    };
    PARTS.iter().map(at).collect()
}

/// Three planets are equivalent after a third of a rotation, and so are their meshes: each carries
/// a third of the torque at any position, with closed forms and with finite elements, whose
/// transmission error and stiffness are similar.
#[test]
fn equal_planets_share_equally_and_give_as_finite_elements() {
    let [given, meshed] =
        [Fidelity::Analytic, Fidelity::Plane].map(|fidelity| seen(&SetOptions::three(), fidelity));
    for ((given, stresses), (meshed, of_mesh)) in given.iter().zip(&meshed) {
        let (with_sun, with_ring) = given.split_at(3);
        for alike in [with_sun, with_ring] {
            for mesh in alike {
                let same = |k: usize| (mesh[k] / alike[0][k] - 1.0).abs() < 1e-9;
                assert!((0..3).all(same), "{mesh:?} {:?}", alike[0]);
            }
        }
        for (mesh, expected) in given.iter().zip(meshed) {
            assert!((mesh[0] / expected[0] - 1.0).abs() < 1e-9, "{mesh:?} {expected:?}");
            assert!((mesh[1] / expected[1] - 1.0).abs() < 0.02, "{mesh:?} {expected:?}");
            assert!((mesh[2] / expected[2] - 1.0).abs() < 0.02, "{mesh:?} {expected:?}");
        }
        for (stress, expected) in stresses.iter().zip(of_mesh) {
            // According to ISO 6336, on coarse elements: the internal teeth of the ring have the
            // largest error.
            assert!((stress / expected - 1.0).abs() < 0.25, "{stress} {expected}");
        }
    }
}

/// A sun that floats between three planets moves until all of them carry the same force, whatever
/// their pin position errors are: statics requires it.
#[test]
fn a_floating_sun_makes_three_planets_bear_alike() {
    let options = SetOptions {
        floating: true,
        pin_errors: vec![[0.0, 30e-6], [0.0; 2], [10e-6, -20e-6]],
        ..SetOptions::three()
    };
    for (meshes, _) in seen(&options, Fidelity::Analytic) {
        for mesh in &meshes[..3] {
            // Pin position errors rotate the lines of action by ten-thousandths of a radian.
            assert!((mesh[0] / meshes[0][0] - 1.0).abs() < 2e-3, "{meshes:?}");
        }
    }
}

/// Rigid involutes have no transmission error, on rotating axes as on fixed ones.
#[test]
fn rigid_sets_have_no_transmission_error() {
    for options in
        [SetOptions::three(), SetOptions { moment: TORQUE / 10.0, seen_from: 61.0, ..SetOptions::four() }]
    {
        let set = Set::of(&options).expect("it goes together");
        let system = set.system_at(Fidelity::Rigid);
        for part in PARTS {
            let step = system.solve(part * PERIOD).expect("it rests");
            let at = Equilibrium::new(&system, &step);
            for &pair in &set.sun_meshes {
                let error = TransmissionError(pair).value(&at).value;
                assert!(error.abs() < 1e-9, "{part}: {error:e}");
            }
        }
    }
}
