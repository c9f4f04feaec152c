//! Gears on bearings in three dimensions: lever arms, tilt, and the load distribution along the
//! face.

use super::pairs::{FIRST, MESH, MODULE, Options, SECOND, TORQUE};
use crate::common::built;
use calyx_gears::assembly::Misalignment;
use calyx_gears::helix::Hand;
use calyx_runtime::bearing::{Bearing, BearingMatrix, axisymmetric};
use calyx_runtime::contact::solid::Pose;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::{RelocatedMotion, SteadyRotation, moved_by};
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{
    BearingTilt, Direction, Displacement, Equilibrium, FaceLoadFactor, MaxLineLoad, Rotation,
};
use calyx_runtime::scene::{
    BearingId, Body, BodyId, Component, Fidelity, GearMesh, Scene, StructureOptions, Template,
};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::sync::Arc;

const ANGLE: f64 = 0.35;
/// Radial and axial stiffness, N/m.
const K: [f64; 2] = [3e8, 1e8];
/// Positions of two bearings next to an overhung gear, m.
pub(super) const PLACES: [f64; 2] = [0.03, 0.075];
pub(super) const FREE: [Component; 5] =
    [Component::Ux, Component::Uy, Component::Uz, Component::ThetaX, Component::ThetaY];

fn options(helical: bool) -> Options {
    let options = if helical { Options::helical(ANGLE, Hand::Right) } else { Options::spur() };
    Options { free: FREE.to_vec(), ..options }
}

/// The bearings of a shaft; the first one also carries axial load.
fn pair_of_bearings(factor: f64) -> [Bearing; 2] {
    let matrix = |axial: f64| axisymmetric(factor * K[0], factor * axial, 0.0, 0.0);
    [Bearing::new("near", FIRST, PLACES[0], matrix(K[1])), Bearing::new("far", FIRST, PLACES[1], matrix(0.0))]
}

pub(super) fn scene(options: &Options, bearings: &[Bearing]) -> (Scene, GearMesh) {
    let (mut scene, mesh) = options.scene();
    for bearing in bearings {
        scene.add_bearing(bearing.clone()).expect("a bearing");
    }
    (scene, mesh)
}

fn solved<T>(scene: &(Scene, GearMesh), look: impl FnOnce(&System<'_>, &StepResult) -> T) -> T {
    solved_at(Fidelity::Solid(Template::Medium), scene, look)
}

pub(super) fn solved_at<T>(
    fidelity: Fidelity,
    (scene, mesh): &(Scene, GearMesh),
    look: impl FnOnce(&System<'_>, &StepResult) -> T,
) -> T {
    let system = built(scene, fidelity, StructureOptions::default());
    let step = system.solve(mesh.start + 0.45 * mesh.period).expect("it can be solved");
    assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
    look(&system, &step)
}

#[test]
fn an_overhung_gear_on_two_bearings_tilts_as_levers_say() {
    // Lever arms are those of the first gear, with and without misalignment of the second gear's
    // axis.
    for in_action in [0.0, 4e-4] {
        let misalignment = Misalignment { in_action, off_action: 0.0 };
        let scene = scene(&Options { misalignment, ..options(true) }, &pair_of_bearings(1.0));
        tilts_as_levers_say(Fidelity::Solid(Template::Medium), &scene);
    }
}

/// Closed-form models have the same lever arms, and tilting teeth move the load to one end, the
/// more the softer the bearings are. With rigid teeth the bearings are unloaded in the limit of
/// vanishing load.
#[test]
fn an_overhung_gear_without_meshes() {
    let options = Options { backed: false, ..options(true) };
    let stiff = scene(&options, &pair_of_bearings(1.0));
    tilts_as_levers_say(Fidelity::Analytic, &stiff);
    let uneven = |scene: &(Scene, GearMesh)| {
        solved_at(Fidelity::Analytic, scene, |system, step| system.value(step, &FaceLoadFactor(MESH)).value)
    };
    let [soft, stiff_one, hard] =
        [0.3, 1.0, 1e3].map(|factor| uneven(&scene(&options, &pair_of_bearings(factor))));
    assert!(soft > stiff_one && stiff_one > hard && hard >= 1.0, "{soft} {stiff_one} {hard}");
    solved_at(Fidelity::Rigid, &stiff, |_, step| {
        let [constrained, turn] = [&step.motion[..5], &step.motion[5..]];
        assert!(constrained.iter().all(|motion| motion.abs() < 1e-12), "{constrained:?}");
        assert!(turn[0].abs() < 1e-9, "{turn:?}");
    });
}

fn tilts_as_levers_say(fidelity: Fidelity, scene: &(Scene, GearMesh)) {
    solved_at(fidelity, scene, |system, step| {
        let [fx, fy, fz, mx, my, _] = system.contact_force(step, FIRST);
        let span = PLACES[1] - PLACES[0];
        // The moment about y of a force along x at z is z fx; about x it is -z fy.
        for (force, moment, tilt, axis, sense) in [(fx, my, 4, 0, 1.0), (fy, mx, 3, 1, -1.0)] {
            let moment = sense * moment;
            let far = (moment - force * PLACES[0]) / span;
            let near = force - far;
            let [near_given, far_given] = [near, far].map(|force| force / K[0]);
            let slope = (far_given - near_given) / span;
            let expected = [near_given - slope * PLACES[0], sense * slope];
            let found = [step.motion[axis], step.motion[tilt]];
            for (found, expected) in found.iter().zip(expected) {
                assert!((found / expected - 1.0).abs() < 1e-9, "{found} {expected}");
            }
            let at = system.value(step, &BearingTilt(BearingId(1), Direction::Ground(tilt - 3))).value;
            assert!((at - step.motion[tilt]).abs() < 1e-18);
        }
        assert!((step.motion[2] * K[1] / fz - 1.0).abs() < 1e-9, "{fz}");
        assert_eq!(system.value(step, &Displacement(FIRST, 2)).value, step.motion[2]);
        assert_eq!(system.value(step, &Rotation(FIRST, 1)).value, step.motion[4]);
    });
}

/// Radial and axial stiffness at z, referred to the origin of the body.
fn moved([radial, axial]: [f64; 2], z: f64) -> BearingMatrix {
    let mut matrix = axisymmetric(radial, axial, radial * z * z, 0.0);
    // u_x + z theta_y and u_y - z theta_x are the displacements of the bearing.
    for (u, theta, arm) in [(0, 4, z), (1, 3, -z)] {
        matrix[u][theta] = radial * arm;
        matrix[theta][u] = radial * arm;
    }
    matrix
}

#[test]
fn two_bearings_are_one_with_the_sum_of_their_matrices_at_one_place() {
    let [near, far] = [moved(K, PLACES[0]), moved([K[0], 0.0], PLACES[1])];
    let sum: BearingMatrix = std::array::from_fn(|i| std::array::from_fn(|j| near[i][j] + far[i][j]));
    let one = Bearing::new("one", FIRST, 0.0, sum);
    let motion =
        |bearings: &[Bearing]| solved(&scene(&options(true), bearings), |_, step| step.motion.clone());
    let (two, one) = (motion(&pair_of_bearings(1.0)), motion(&[one]));
    for (two, one) in two.iter().zip(&one) {
        assert!((two - one).abs() < 1e-9 * one.abs().max(1e-6), "{two} {one}");
    }
}

#[test]
fn everything_is_in_equilibrium() {
    let (scene, mesh) = scene(&options(true), &pair_of_bearings(1.0));
    solved(&(scene.clone(), mesh), |system, step| {
        let at = Equilibrium::new(system, step);
        let support = at.support(FIRST);
        assert!(support.iter().all(|part| part.abs() < 1e-10 * TORQUE / MODULE), "{support:?}");
        // About the origin of ground, where the first gear's frame is.
        let mut sum = [0.0, 0.0, 0.0, 0.0, 0.0, TORQUE];
        for bearing in [BearingId(0), BearingId(1)] {
            let borne = at.bearing(bearing).expect("it is there").wrench_on(FIRST);
            (0..6).for_each(|k| sum[k] += borne[k]);
        }
        let [fx, fy, fz, mx, my, mz] = at.support(SECOND);
        let x = 0.5 * MODULE * 51.0 * (1.0 + 1e-3);
        let other = [fx, fy, fz, mx, my - x * fz, mz + x * fy];
        (0..6).for_each(|k| sum[k] += other[k]);
        assert!(sum.iter().all(|part| part.abs() < 1e-10 * TORQUE / MODULE), "{sum:?}");
    });
}

/// The scene with its first gear fixed, except for rotation, in the position to which the bearings
/// of another scene have moved it, and rotated until rigid teeth touch under only the moment about
/// its inclined axis.
fn constrained_at(scene: &Scene, mesh: &GearMesh, motion: &[f64], moment: [f64; 3]) -> (Scene, f64) {
    let &[x, y, z, about_x, about_y, _] = motion else { panic!("six freedoms") };
    let pose = moved_by(&Pose::IDENTITY, [x, y, z, about_x, about_y, 0.0]);
    let mut constrained = scene.clone();
    constrained.bearings.clear();
    constrained.bodies[0].motion =
        Arc::new(RelocatedMotion { motion: constrained.bodies[0].motion.clone(), pose });
    constrained.bodies[0].free = [false, false, false, false, false, true];
    let mut turn = 0.0;
    for _ in 0..3 {
        constrained.bodies[0].load = Arc::new(Wrench::NONE);
        let more = solved(&(constrained.clone(), mesh.clone()), |_, step| step.motion[0]);
        constrained.bodies[0].phase += more;
        turn += more;
    }
    let axis = pose.direction([0.0, 0.0, 1.0]);
    let about: f64 = (0..3).map(|k| moment[k] * axis[k]).sum();
    constrained.bodies[0].load = Arc::new(Wrench::of_moment(axis.map(|part| part * about)));
    (constrained, turn)
}

/// A shaft on soft bearings that the load displaces by a tenth of a module and tilts: the solution
/// equals that of the shaft fixed there.
#[test]
fn a_shaft_that_is_carried_far_is_solved_where_it_is_carried() {
    let soft = |name: &str, at: f64, radial: f64, axial: f64, apart: f64| Bearing {
        unloaded: [-apart, 0.0, 0.0, 0.0, 0.0, 0.0],
        ..Bearing::new(name, FIRST, at, axisymmetric(radial, axial, 0.0, 0.0))
    };
    for helical in [false, true] {
        let bearings = [soft("one", -0.04, 1.2e7, 2e7, 0.2e-3), soft("other", 0.04, 1.25e7, 0.0, 0.2e-3)];
        let (mut scene, mesh) = scene(&options(helical), &bearings);
        // One grid for both scenes.
        scene.pairs[0].grid.width = Some(0.4e-3);
        let of = |system: &System<'_>, step: &StepResult| {
            // The load along the face at this position; a load factor is that of the cycle.
            let largest = system.value(step, &MaxLineLoad(MESH)).value;
            (step.motion.clone(), system.contact_force(step, FIRST), largest)
        };
        let (motion, force, largest) = solved(&(scene.clone(), mesh.clone()), |system, step| {
            assert!(step.warnings.is_empty(), "{:?}", step.warnings);
            assert!(step.start.iter().any(|&moved| moved != 0.0));
            let support = Equilibrium::new(system, step).support(FIRST);
            assert!(support.iter().all(|part| part.abs() < 1e-10 * TORQUE / MODULE), "{support:?}");
            of(system, step)
        });
        assert!(motion[0].hypot(motion[1]) > 0.2e-3 && motion[3].hypot(motion[4]) > 2e-5, "{motion:?}");
        let (constrained, before) =
            constrained_at(&scene, &mesh, &motion, [3, 4, 5].map(|k: usize| -force[k]));
        let (own, constrained_force, constrained_largest) = solved(&(constrained, mesh), of);
        for k in 0..6 {
            // Cells at the ends of the face are cut differently: the centre of the load agrees to
            // some thousandths of a millimetre.
            let most = if k < 3 { 1e-5 * TORQUE / (20.0 * MODULE) } else { 2e-4 * TORQUE };
            assert!((force[k] - constrained_force[k]).abs() < most, "{force:?} {constrained_force:?}");
        }
        assert!((motion[5] - before - own[0]).abs() < 1e-4 * own[0].abs(), "{motion:?} {before} {own:?}");
        assert!((largest / constrained_largest - 1.0).abs() < 1e-3, "{largest} {constrained_largest}");
    }
}

/// Axial position of the resultant load, m from the middle of the face.
fn centre(system: &System<'_>, step: &StepResult) -> f64 {
    let [fx, fy, _, mx, my, _] = system.contact_force(step, FIRST);
    (my * fx - mx * fy) / (fx * fx + fy * fy)
}

#[test]
fn the_load_of_an_overhung_gear_goes_to_the_side_of_its_bearings() {
    for helical in [false, true] {
        let looked = |factor: f64| {
            solved(&scene(&options(helical), &pair_of_bearings(factor)), |system, step| {
                (system.value(step, &FaceLoadFactor(MESH)).value, centre(system, step))
            })
        };
        let [(stiff, aligned), (soft, shifted), (softer, farther)] = [1e4, 1.0, 0.3].map(looked);
        assert!(aligned < shifted && shifted < farther, "{aligned} {shifted} {farther}");
        if !helical {
            assert!(stiff < soft && soft < softer, "{stiff} {soft} {softer}");
        }
    }
}

/// A shaft in a tube, both free, on bearings with full matrices at different positions: the
/// compliance matrix is symmetric (Maxwell-Betti reciprocity).
#[test]
fn what_one_load_does_to_another_dof_is_mutual() {
    let (scene, mesh) = Options::spur().scene();
    let full = |seed: f64| -> BearingMatrix {
        let root: BearingMatrix = std::array::from_fn(|i| {
            let unit = if i < 3 { 2e4 } else { 4e2 };
            std::array::from_fn(|j| unit * (seed * (3.7 * i as f64 + 1.3 * j as f64 + 1.0).powi(2)).sin())
        });
        std::array::from_fn(|i| std::array::from_fn(|j| (0..6).map(|k| root[i][k] * root[j][k]).sum()))
    };
    let all = [
        Component::Ux,
        Component::Uy,
        Component::Uz,
        Component::ThetaX,
        Component::ThetaY,
        Component::ThetaZ,
    ];
    let bodies = [BodyId(2), BodyId(3)];
    let compliance = |freedom: usize| {
        let mut scene = scene.clone();
        for (index, name) in ["shaft", "tube"].into_iter().enumerate() {
            let mut load = [0.0; 6];
            if freedom / 6 == index {
                load[freedom % 6] = 1.0;
            }
            let [fx, fy, fz, mx, my, mz] = load;
            let body =
                Body::new(name, scene.bodies[0].prototype.clone(), SteadyRotation::at_rest([0.4, 0.1]));
            scene.add_body(body.free_in(&all).loaded(Wrench { force: [fx, fy, fz], moment: [mx, my, mz] }));
        }
        for (name, at, seed) in [("a", 0.02, 1.1), ("b", -0.03, 2.3)] {
            let bearing = Bearing::new(name, bodies[0], at, full(seed)).between(bodies[1]);
            scene.add_bearing(bearing).expect("a bearing");
        }
        scene.add_bearing(Bearing::new("c", bodies[1], 0.05, full(0.7))).expect("a bearing");
        scene.add_observable(Displacement(bodies[1], 0));
        let scene = (scene, mesh.clone());
        solved(&scene, |system, step| {
            let at = Equilibrium::new(system, step);
            bodies.map(|body| std::array::from_fn::<f64, 6, _>(|k| at.deviation(body, k))).concat()
        })
    };
    let matrix: Vec<Vec<f64>> = (0..12).map(compliance).collect();
    for i in 0..12 {
        for j in 0..i {
            let size = (matrix[i][i] * matrix[j][j]).sqrt();
            assert!(
                (matrix[i][j] - matrix[j][i]).abs() < 1e-8 * size,
                "{i} {j}: {} {}",
                matrix[i][j],
                matrix[j][i]
            );
        }
    }
    // In stiff directions a unit force moves the tube by the compliance of its own bearing.
    assert!(matrix.iter().enumerate().all(|(k, row)| row[k] > 0.0));
}
