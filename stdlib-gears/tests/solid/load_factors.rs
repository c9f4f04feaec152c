//! Load factors of perfect and of misaligned elastic pairs, against closed forms of ISO 6336-1.

use super::pairs::{MESH, Options};
use crate::common::built;
use calyx_gears::assembly::Misalignment;
use calyx_gears::helix::Hand;
use calyx_runtime::observables::{
    DynamicFactor, FaceLoadFactor, MeshForce, MeshStiffness, Observable, Observe, RootFaceLoadFactor,
    TransverseLoadFactor,
};
use calyx_runtime::scene::{Fidelity, StructureOptions};

/// An angle that makes a model three-dimensional without effect on its results.
const NEARLY_ALIGNED: f64 = 1e-7;

fn pair(helix_angle: f64, misalignment: f64) -> Options {
    let misalignment = Misalignment { in_action: misalignment, off_action: 0.0 };
    let options = match helix_angle > 0.0 {
        true => Options::helical(helix_angle, Hand::Right),
        false => Options::spur(),
    };
    Options { backed: false, half_cells: [6, 8], misalignment, ..options }
}

/// Values of observables, averaged over uniform positions of the cycle.
fn means<const N: usize>(options: &Options, positions: usize, observables: [&dyn Observable; N]) -> [f64; N] {
    let (scene, mesh) = options.scene();
    let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
    let mut sums = [0.0; N];
    for position in 0..positions {
        let cycle = (position as f64 + 0.5) / positions as f64;
        let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
        for (sum, observable) in sums.iter_mut().zip(observables) {
            *sum += system.value(&step, observable).value / positions as f64;
        }
    }
    sums
}

/// Without modifications and misalignment, K_Hbeta of spur teeth is 1 to the accuracy of the
/// contact grid. On helical teeth, where the side faces cut the contact lines, it has an end effect
/// and is 1.010 and 1.013 at 0.1 and 0.2 rad.
///
/// K_Halpha is 1 where one pair carries all of the load at some position. Where two pairs always
/// share it, the share of a pair is not exactly that of the length of its contact line; the factor
/// is below 1 and does not depend on the contact grid.
#[test]
fn perfect_pairs_have_a_face_load_factor_of_one_apart_from_end_effects() {
    for (helix_angle, end_effect) in [(0.0, 1e-3), (0.1, 0.012), (0.2, 0.02), (0.35, 0.025)] {
        let aligned = pair(helix_angle, NEARLY_ALIGNED);
        let observables: [&dyn Observable; 4] = [
            &FaceLoadFactor(MESH),
            &RootFaceLoadFactor::new(MESH, 0.25),
            &TransverseLoadFactor(MESH),
            &DynamicFactor(MESH),
        ];
        let [face, root, transverse, dynamic] = means(&aligned, 1, observables);
        println!("{helix_angle}: {face} {root} {transverse} {dynamic}");
        assert!(face >= 1.0 - 1e-9 && face < 1.0 + end_effect, "{helix_angle}: {face}");
        assert!((root - face.powf(16.0 / 21.0)).abs() < 1e-12, "{root} {face}");
        // One pair of spur or slightly helical teeth carries all of the load for a part of the
        // cycle.
        if helix_angle < 0.2 {
            assert!((transverse - 1.0).abs() < 1e-9, "{helix_angle}: {transverse}");
        } else {
            let finer = Options { half_cells: [9, 12], ..aligned };
            let [on_finer_grid] = means(&finer, 1, [&TransverseLoadFactor(MESH)]);
            assert!((transverse - on_finer_grid).abs() < 0.005, "{transverse} {on_finer_grid}");
            assert!((0.9..1.0).contains(&transverse), "{helix_angle}: {transverse}");
        }
        // The force of a static equilibrium.
        assert!((dynamic - 1.0).abs() < 1e-9, "{helix_angle}: {dynamic}");
    }
}

/// All positions of a cycle have the value of the cycle, and the next cycle has the same one.
#[test]
fn a_load_factor_is_that_of_the_cycle() {
    let (scene, mesh) = pair(0.35, 3e-4).scene();
    let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
    let at = |cycle: f64| {
        let step = system.solve(mesh.start + cycle * mesh.period).expect("equilibrium");
        system.value(&step, &FaceLoadFactor(MESH)).value
    };
    let first = at(0.0);
    assert_eq!(at(0.3).to_bits(), first.to_bits());
    assert_eq!(at(0.99).to_bits(), first.to_bits());
    assert!((at(1.5) / first - 1.0).abs() < 1e-6);
}

/// ISO 6336-1, method C: K_Hbeta = 1 + c_gamma F_betay/(2 F_m/b), for a stiffness without coupling
/// along the face. The closed-form teeth spread a load along the face, up to a length of about 1.5
/// modules, but not beyond its ends. The sides of the face are therefore stiffer than c_gamma under
/// the antisymmetric load of a misalignment. The deviation decreases with the width of the face.
#[test]
fn a_misaligned_pair_approaches_method_c_on_a_wide_face() {
    let deviation = |wide: f64| {
        let wider = |options: Options| Options {
            face_width: wide * options.face_width,
            torque: wide * options.torque,
            ..options
        };
        let aligned = wider(pair(0.0, NEARLY_ALIGNED));
        let [stiffness, force] = means(&aligned, 8, [&MeshStiffness(MESH), &MeshForce(MESH)]);
        let by_load = 0.25;
        let angle = by_load * force / (stiffness * aligned.face_width);
        let [factor] = means(&wider(pair(0.0, angle)), 1, [&FaceLoadFactor(MESH)]);
        let deviation = (factor - 1.0) / (0.5 * by_load) - 1.0;
        println!("{wide}: {factor} {deviation}");
        deviation
    };
    let [narrow, wide, wider] = [1.0, 4.0, 16.0].map(deviation);
    assert!(narrow > wide && wide > wider, "{narrow} {wide} {wider}");
    assert!((0.0..0.7).contains(&narrow) && (-0.05..0.15).contains(&wider), "{narrow} {wider}");
}
