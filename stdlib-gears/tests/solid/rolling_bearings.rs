//! A helical pair whose first gear is on rolling bearings: displacements against the equilibrium of
//! the bearings alone under the contact forces, tangent bearings, clearance and reversal.

use super::bearings::{FREE, PLACES, scene as on_bearings, solved_at};
use super::pairs::{FIRST, Options};
use crate::common::built;
use crate::common::rolling::{balls, tapered};
use calyx_gears::helix::Hand;
use calyx_runtime::bearing::{Bearing, NonlinearLoad, RollingElements};
use calyx_runtime::contact::active_set::solve;
use calyx_runtime::contact::problem::ContactProblem;
use calyx_runtime::observables::{BearingStiffness, Equilibrium, Observable, Observe};
use calyx_runtime::rolling::{BallKind, Conditions, Elements, Motion, RollingBearing, Row};
use calyx_runtime::scene::{BearingId, Fidelity, GearMesh, Scene, StructureOptions};
use calyx_runtime::step::StepResult;
use calyx_runtime::system::System;
use std::sync::Arc;

const MOTION: Motion = Motion { azimuth: 0.2, ..Motion::REST };

/// Rows of both bearings, the second mirrored, with an axial offset.
fn rows(elements: [Elements; 2], offset: f64) -> [Row; 2] {
    let [near, far] = elements;
    [Row { offset, ..Row::new(near) }, Row { offset, mirrored: true, ..Row::new(far) }]
}

fn arrangements() -> Vec<[Row; 2]> {
    let angle = 0.7;
    let deep = |clearance| balls(BallKind::DeepGroove { clearance });
    vec![
        rows([tapered(31), tapered(31)], 2e-6),
        rows([tapered(31), tapered(31)], -10e-6),
        rows([balls(BallKind::AngularContact { angle }), balls(BallKind::AngularContact { angle })], 0.0),
        rows([deep(12e-6), deep(20e-6)], 0.0),
        rows([balls(BallKind::FourPoint { angle, clearance: 5e-6 }), deep(0.0)], 0.0),
    ]
}

fn scene(rows: &[Row; 2], torque: f64) -> (Scene, GearMesh) {
    moving_scene(rows, torque, MOTION)
}

fn moving_scene(rows: &[Row; 2], torque: f64, motion: Motion) -> (Scene, GearMesh) {
    let options = Options::helical(0.35, Hand::Right);
    let options = Options { free: FREE.to_vec(), backed: false, torque, ..options };
    let bearing = |index: usize| {
        let rows = RollingBearing::new(vec![rows[index].clone()]).expect("valid");
        let elements = RollingElements::new(rows, motion).expect("valid");
        let bearing = Bearing::new(["near", "far"][index], FIRST, PLACES[index], [[0.0; 6]; 6]);
        Bearing { nonlinear: Some(NonlinearLoad::Rolling(Arc::new(elements))), ..bearing }
    };
    on_bearings(&options, &[bearing(0), bearing(1)])
}

fn solved<T>(
    fidelity: Fidelity,
    scene: &(Scene, GearMesh),
    look: impl FnOnce(&System<'_>, &StepResult) -> T,
) -> T {
    solved_at(fidelity, scene, |system, step| {
        assert!(step.certificate.largest() <= 1e-10, "{:?}", step.certificate);
        look(system, step)
    })
}

/// The displacement of the gear is that of both bearings as one under the contact forces, which a
/// search of its own finds. Elements orbit with their cages if the rings rotate.
#[test]
fn displacement_is_that_of_the_bearings_under_the_contact_forces() {
    let still = arrangements().into_iter().map(|rows| (rows, MOTION));
    let at_speed = |inner_speed: f64| {
        let moving = Motion { inner_speed, gyroscopic: true, ..MOTION };
        arrangements().into_iter().map(move |rows| (rows, moving))
    };
    for (index, (rows, motion)) in still.chain(at_speed(300.0)).chain(at_speed(3000.0)).enumerate() {
        solved(Fidelity::Analytic, &moving_scene(&rows, 100.0, motion), |system, step| {
            let placed = [0, 1].map(|k| {
                let azimuth = step.time * rows[k].cage_speed(&motion);
                assert!((azimuth.abs() > 1e-3) == (motion != MOTION), "{azimuth}");
                Row { position: PLACES[k], azimuth, ..rows[k].clone() }
            });
            let together = RollingBearing::new(placed.to_vec()).expect("valid");
            let [fx, fy, fz, mx, my, _] = system.contact_force(step, FIRST);
            let conditions =
                Conditions { load: [fx, fy, fz, mx, my], prescribed: [false; 5], start: [0.0; 5] };
            let expected = together.equilibrium(&conditions, &motion).expect("solved").displacement;
            for k in 0..5 {
                let unit = if k < 3 { 1.0 } else { 30e-3 };
                let error = unit * (step.motion[k] - expected[k]);
                assert!(error.abs() < 1e-12, "{index} {k}: {} {}", step.motion[k], expected[k]);
            }
            let support = Equilibrium::new(system, step).support(FIRST);
            for (k, force) in support[..5].iter().enumerate() {
                let unit = if k < 3 { 1.0 } else { 30e-3 };
                assert!((force / unit).abs() < 1e-6 * fx.hypot(fy), "{index} {k}: {force}");
            }
        });
    }
}

/// The stiffness that outputs state is the derivative of the force of the rings, in translation,
/// tilting and coupling, up to its symmetric part, which differs for tilted rings.
#[test]
fn observed_stiffness_is_the_derivative_of_the_force() {
    for (index, rows) in arrangements().iter().enumerate() {
        let scene = scene(rows, 100.0);
        solved(Fidelity::Analytic, &scene, |system, step| {
            let at = Equilibrium::new(system, step);
            for (number, own) in scene.0.bearings.iter().enumerate() {
                let bearing = BearingId(number);
                let deflection = at.bearing(bearing).expect("a bearing").deflection;
                let scale = own.nonlinear.as_ref().expect("elements").typical_stiffness()[0][0];
                let unit = |component: usize| if component < 3 { 1.0 } else { 30e-3 };
                let load = system.nonlinear_load(number, step.time);
                for column in 0..5 {
                    let pushed = |sense: f64| {
                        let mut moved = deflection;
                        moved[column] += sense * 1e-9 / unit(column);
                        own.push(&moved, &[], load.as_ref().map(|load| load.push(&moved)))
                    };
                    let (ahead, behind) = (pushed(1.0), pushed(-1.0));
                    for row in 0..5 {
                        let expected = (behind[row] - ahead[row]) * unit(column) / 2e-9;
                        let found = BearingStiffness { bearing, row, column }.value(&at).value;
                        let error = (found - expected) / (unit(row) * unit(column) * scale);
                        assert!(error.abs() < 1e-3, "{index} {number} {row} {column}: {found} {expected}");
                    }
                }
            }
        });
    }
}

/// Replaces the rolling elements of both bearings by their tangents at these motions of the gear.
fn linearize(scene: &mut Scene, motion: &[f64]) {
    for (index, bearing) in scene.bearings.iter_mut().enumerate() {
        let elements = bearing.nonlinear.take().expect("rolling elements");
        let &[ux, uy, uz, about_x, about_y, ..] = motion else { panic!("five DOFs") };
        let place = PLACES[index];
        let deflection = [ux + place * about_y, uy - place * about_x, uz, about_x, about_y];
        let state = elements.state(None, deflection).expect("finite");
        let tangent = elements.tangent(&state, 0.0);
        (bearing.stiffness, bearing.load) = (tangent.stiffness, tangent.load);
    }
}

/// Linear bearings with the tangents at the solution, and their preload, have the same solution on
/// the same contact grids. Solved from the start they would have other grids, because the sizes
/// follow from the solution on the first grids, where the bearings are not at their tangent.
#[test]
fn linear_bearings_with_the_tangents_have_the_same_solution() {
    for rows in [&arrangements()[0], &arrangements()[3]] {
        let nonlinear = scene(rows, 100.0);
        let expected = solved(Fidelity::Analytic, &nonlinear, |_, step| step.clone());
        let mut linear = scene(rows, 100.0);
        linearize(&mut linear.0, &expected.motion);
        solved(Fidelity::Analytic, &linear, |system, step| {
            let springs = system.springs_at(step.time).expect("springs");
            let load = system.load_at(step.time).expect("a load");
            let load: Vec<f64> = load.iter().zip(&springs.load).map(|(load, own)| load + own).collect();
            let (_, load) = springs.from(&expected.start, &load);
            let problem = ContactProblem { stiffness: springs.stiffness, load, ..expected.problem.clone() };
            let again = solve(&problem, None).expect("solved");
            for k in 0..5 {
                let unit = if k < 3 { 1.0 } else { 30e-3 };
                let error = unit * (again.motion[k] + expected.start[k] - expected.motion[k]);
                assert!(error.abs() < 1e-13, "{k}: {error}");
            }
        });
    }
}

/// A position that is estimated with one cell for each slice has the solution of linear bearings
/// with the tangents, whose position under load follows from solutions with all cells. What
/// remains are other sizes of the grids: the clearances leave the gear a soft direction.
#[test]
fn an_estimated_position_has_the_solution_without_the_estimate() {
    let loose = |clearance| balls(BallKind::DeepGroove { clearance });
    for torque in [100.0, 150.0] {
        let rows = rows([loose(0.9e-3), loose(0.7e-3)], 0.0);
        let nonlinear = scene(&rows, torque);
        let expected = solved(Fidelity::Analytic, &nonlinear, |_, step| step.clone());
        assert!(expected.estimates > 0);
        let mut linear = scene(&rows, torque);
        linearize(&mut linear.0, &expected.motion);
        solved(Fidelity::Analytic, &linear, |_, step| {
            assert_eq!(step.estimates, 0);
            let largest = step.motion[1].abs();
            assert!(largest > 0.5e-3, "{largest}");
            for k in 0..5 {
                let unit = if k < 3 { 1.0 } else { 30e-3 };
                let apart = |one: &[f64], other: &[f64]| unit * (one[k] - other[k]).abs() / largest;
                let (start, motion) =
                    (apart(&expected.start, &step.start), apart(&expected.motion, &step.motion));
                assert!(start < 5e-3 && motion < 1e-3, "{torque} {k}: {start} {motion}");
            }
        });
    }
}

/// In a given state of contact, the motion at an estimated position is a smooth function of the
/// load.
#[test]
fn an_estimated_position_varies_smoothly_with_the_load() {
    let loose = |clearance| balls(BallKind::DeepGroove { clearance });
    let rows = rows([loose(0.9e-3), loose(0.7e-3)], 0.0);
    let expected = solved(Fidelity::Analytic, &scene(&rows, 100.0), |_, step| step.clone());
    let state = expected.contact_state();
    assert!(state.estimates > 0);
    let at = |torque: f64| {
        solved(Fidelity::Analytic, &scene(&rows, torque), |system, step| {
            let found = system.solve_in_state(step.time, &state).expect("solved");
            assert_eq!((found.estimates, found.contact_state()), (state.estimates, state.clone()));
            found.motion
        })
    };
    let [less, same, more] = [100.0 * (1.0 - 1e-4), 100.0, 100.0 * (1.0 + 1e-4)].map(at);
    let sizes = |of: &dyn Fn(usize) -> f64| -> Vec<f64> {
        (0..6).map(|k| of(k).abs() * if k < 3 { 1.0 } else { 30e-3 }).collect()
    };
    let largest = |sizes: Vec<f64>| sizes.into_iter().fold(0.0, f64::max);
    let change = largest(sizes(&|k| more[k] - less[k]));
    let bend = largest(sizes(&|k| more[k] + less[k] - 2.0 * same[k]));
    assert!(bend < 1e-4 * change, "{bend:e} {change:e}");
    let difference = largest(sizes(&|k| same[k] - expected.motion[k]));
    assert!(difference < 1e-9 * change, "{difference:e}");
}

/// A small load closes the clearances of the bearings, and the displacement grows with the load.
#[test]
fn small_loads_close_the_clearance() {
    let rows = &arrangements()[3];
    let radial = |torque: f64| {
        solved(Fidelity::Analytic, &scene(rows, torque), |_, step| step.motion[0].hypot(step.motion[1]))
    };
    let [light, small, full] = [1e-2, 1.0, 100.0].map(radial);
    assert!(light > 0.0 && light < small && small < full && full < 200e-6, "{light} {small} {full}");
}

/// Rigid bodies have bearings at rest.
#[test]
fn rigid_bodies_do_not_deflect_bearings() {
    solved(Fidelity::Rigid, &scene(&arrangements()[0], 100.0), |_, step| {
        assert!(step.motion[..5].iter().all(|motion| motion.abs() < 1e-12), "{:?}", step.motion);
    });
}

/// The bearings balance their loads at all positions of a mesh cycle, at light and heavy loads of
/// both senses.
///
/// Light loads on bearings with clearance are the hardest: some directions have no stiffness at
/// all. An iteration that shortens its steps only by a stiffness of its own, without a search along
/// the step, made 88 contact problems at one of these positions, in cycles with little progress.
#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn equilibrium_at_all_positions() {
    for (index, rows) in arrangements().iter().enumerate() {
        for torque in [1e-2, 1.0, 10.0, 300.0, -100.0] {
            let (scene, mesh) = scene(rows, torque);
            let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
            for k in 0..12 {
                let time = mesh.start + f64::from(k) / 12.0 * mesh.period;
                let step =
                    system.solve(time).unwrap_or_else(|error| panic!("{index} {torque} {k}: {error:?}"));
                let largest = step.certificate.largest();
                assert!(largest <= 1e-9, "{index} {torque} {k}: {:?}", step.certificate);
                // Forces of teeth and bearings balance on the gear.
                let force = system.contact_force(&step, FIRST);
                let support = Equilibrium::new(&system, &step).support(FIRST);
                for axis in 0..5 {
                    let unit = if axis < 3 { 1.0 } else { 30e-3 };
                    let scale = force[0].hypot(force[1]);
                    let residual = support[axis].abs() / unit;
                    assert!(residual <= 1e-8 * scale, "{index} {torque} {k} {axis}: {residual} {scale}");
                }
            }
        }
    }
}

/// Two rows that carry axial force in one sense only balance one sense of the torque of a helical
/// gear. The other is an error that names a bearing.
#[test]
fn a_missing_axial_support_is_an_error() {
    let solve = |torque: f64| {
        let [near, far] = rows([tapered(31), tapered(31)], 0.0);
        let (scene, mesh) = scene(&[near, Row { mirrored: false, ..far }], torque);
        let system = built(&scene, Fidelity::Analytic, StructureOptions::default());
        system.solve(mesh.start + 0.45 * mesh.period).map_err(|error| (error.code, error.message))
    };
    let [forward, backward] = [100.0, -100.0].map(solve);
    let (code, message) = match (forward, backward) {
        (Ok(_), Err(error)) | (Err(error), Ok(_)) => error,
        other => panic!("{other:?}"),
    };
    assert_eq!(code, "E0726", "{message}");
    assert!(message.contains("\"near\"") || message.contains("\"far\""), "{message}");
    assert!(message.contains("static load rating C0"), "{message}");
}

/// A further bearing whose clearance stays open, and one that barely touches, leave the equilibrium
/// of the others as it is.
#[test]
fn bearings_without_load_do_not_prevent_the_equilibrium() {
    let rows = &arrangements()[0];
    let motion = |clearances: &[f64]| {
        let (mut scene, mesh) = scene(rows, 10.0);
        for &clearance in clearances {
            let row = Row::new(balls(BallKind::DeepGroove { clearance }));
            let alone = RollingBearing::new(vec![row]).expect("valid");
            let elements = RollingElements::new(alone, MOTION).expect("valid");
            let name = format!("{clearance}");
            let bearing = Bearing::new(name, FIRST, PLACES[0], [[0.0; 6]; 6]);
            scene
                .add_bearing(Bearing {
                    nonlinear: Some(NonlinearLoad::Rolling(Arc::new(elements))),
                    ..bearing
                })
                .expect("a bearing");
        }
        solved(Fidelity::Analytic, &(scene, mesh), |_, step| step.motion.clone())
    };
    let [alone, open] = [motion(&[]), motion(&[100e-6])];
    for k in 0..5 {
        assert!((alone[k] - open[k]).abs() <= 1e-6 * alone[k].abs(), "{k}: {} {}", alone[k], open[k]);
    }
    // The bearing touches at a clearance of twice the displacement at its place.
    let place = PLACES[0];
    let displacement = (alone[0] + place * alone[4]).hypot(alone[1] - place * alone[3]);
    for part in [0.99, 1.0, 1.01] {
        motion(&[2.0 * part * displacement]);
    }
}
