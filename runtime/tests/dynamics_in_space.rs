//! Tests of time integration in three dimensions with rigid rotors on bearings: closed forms for
//! gyroscopic moments, unbalance and reactions, on axes of any direction.

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, BearingMatrix};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::{Motion, RelocatedMotion, SteadyRotation, tilted_axes};
use calyx_runtime::observables::SupportForce;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, Component, Fidelity, Scene};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

const SPEED: f64 = 900.0;
const MASS: f64 = 3.0;
const POLAR: f64 = 0.02;
const DIAMETRAL: f64 = 0.012;
const RADIAL: f64 = 2e7;
const AXIAL: f64 = 1e7;
const TILTING: f64 = 3e4;
/// Position of the bearing on the axis, m.
const AT: f64 = 0.03;

const SPACE: [Component; 5] =
    [Component::Ux, Component::Uy, Component::Uz, Component::ThetaX, Component::ThetaY];

/// Rotates about an axis through the origin by an angle.
fn rotation(axis: [f64; 3], angle: f64) -> [[f64; 3]; 3] {
    let (sin, cos) = angle.sin_cos();
    let [x, y, z] = axis;
    let across = [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let own = if i == j { cos } else { 0.0 };
            own + (1.0 - cos) * axis[i] * axis[j] + sin * across[i][j]
        })
    })
}

fn bearing_matrix() -> BearingMatrix {
    let mut matrix = [[0.0; 6]; 6];
    for (component, stiffness) in [RADIAL, RADIAL, AXIAL, TILTING, TILTING].into_iter().enumerate() {
        matrix[component][component] = stiffness;
    }
    matrix
}

/// A rotor on one bearing, with an inertia about its axis and under a load along its DOFs.
fn rotor(tilt: [[f64; 3]; 3], inertia: Inertia, load: [f64; 6], free: &[Component]) -> Scene {
    let steady: Arc<dyn Motion> = Arc::new(SteadyRotation { origin: [0.1, -0.2], start: 0.7, speed: SPEED });
    let motion = RelocatedMotion::rotated_about(steady, tilt, [0.3, 0.0, 0.1]);
    let axes = tilted_axes(tilt.map(|row| row[2]));
    let along = |from: usize| -> [f64; 3] {
        std::array::from_fn(|k| (0..3).map(|axis| load[from + axis] * axes[axis][k]).sum())
    };
    let mut scene = Scene::default();
    let body = Body::new("rotor", Arc::new(RigidBody), motion)
        .free_in(free)
        .with_added(inertia)
        .loaded(Wrench { force: along(0), moment: along(3) });
    let body = scene.add_body(body);
    scene.add_bearing(Bearing::new("bearing", body, AT, bearing_matrix())).expect("a bearing");
    scene
}

fn options() -> AnalysisOptions {
    AnalysisOptions { fidelity: Fidelity::Analytic, ..AnalysisOptions::default() }
}

fn in_time(start: Start, until: f64, steps: usize) -> DynamicOptions {
    let ranges = vec![TimeRange { keep: steps, ..TimeRange::steady(until, steps) }];
    DynamicOptions { from: 0.0, ranges, scheme: Scheme::AVERAGE, rayleigh: [0.0; 2], start }
}

/// Displacements at the end.
fn end(scene: &Scene, dynamics: &DynamicOptions) -> DVector<f64> {
    let mut history = History::new(scene, &[], &options(), dynamics, &mut ()).expect("it can begin");
    assert!(history.by_ref().all(|row| row.is_ok()));
    DVector::from_column_slice(&history.state().displacement)
}

/// Displacements of the five DOFs at a time after a constant load sets in, with the matrix
/// exponential of the linear equations of motion.
fn exact(load: [f64; 6], until: f64) -> DVector<f64> {
    let mass = DMatrix::from_diagonal(&DVector::from_column_slice(&[MASS, MASS, MASS, DIAMETRAL, DIAMETRAL]));
    // Motion of the bearing's centre: u + theta x AT e3.
    let mut moved = DMatrix::<f64>::identity(5, 5);
    (moved[(0, 4)], moved[(1, 3)]) = (AT, -AT);
    let springs =
        DMatrix::from_diagonal(&DVector::from_column_slice(&[RADIAL, RADIAL, AXIAL, TILTING, TILTING]));
    let stiffness = moved.transpose() * springs * &moved;
    let mut gyroscopic = DMatrix::<f64>::zeros(5, 5);
    (gyroscopic[(3, 4)], gyroscopic[(4, 3)]) = (POLAR * SPEED, -POLAR * SPEED);
    let inverse = mass.try_inverse().expect("a mass");
    let mut first_order = DMatrix::<f64>::zeros(11, 11);
    first_order.view_mut((0, 5), (5, 5)).fill_with_identity();
    first_order.view_mut((5, 0), (5, 5)).copy_from(&(-&inverse * stiffness));
    first_order.view_mut((5, 5), (5, 5)).copy_from(&(-&inverse * gyroscopic));
    let load = DVector::from_column_slice(&load[..5]);
    first_order.view_mut((5, 10), (5, 1)).copy_from(&(&inverse * load));
    (first_order * until).exp().view((0, 10), (5, 1)).column(0).into_owned()
}

/// A rotor on one bearing under a load that sets in suddenly, on axes of three directions: the
/// error is of second order in the time step and vanishes with it.
#[test]
fn a_rotor_moves_as_its_gyroscopic_moment_says() {
    let load = [300.0, -200.0, 100.0, 5.0, 8.0, 0.0];
    let until = 0.02;
    let meant = exact(load, until);
    let axis = [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0];
    for angle in [0.0, 0.4, 1.5] {
        let inertia = Inertia::axial(MASS, POLAR, DIAMETRAL);
        let scene = rotor(rotation(axis, angle), inertia, load, &SPACE);
        let [coarse, fine] = [2000, 4000].map(|steps| end(&scene, &in_time(Start::Frames, until, steps)));
        let ratio = (&coarse - &meant).norm() / (&fine - &meant).norm();
        assert!((ratio - 4.0).abs() < 0.1, "{angle}: {ratio}");
        let extrapolated = &fine + (&fine - &coarse) / 3.0;
        for k in 0..5 {
            assert!((extrapolated[k] / meant[k] - 1.0).abs() < 1e-4, "{angle} {k}: {extrapolated} {meant}");
        }
    }
}

/// The average acceleration method keeps the energy of a rotor with gyroscopic moments, and a run
/// that is resumed has the same bits.
#[test]
fn a_rotor_keeps_its_energy() {
    let load = [300.0, -200.0, 100.0, 5.0, 8.0, 0.0];
    let scene = rotor(rotation([0.0, 1.0, 0.0], 0.8), Inertia::axial(MASS, POLAR, DIAMETRAL), load, &SPACE);
    let dynamics = DynamicOptions {
        ranges: vec![TimeRange { keep: 400, ..TimeRange::steady(0.4, 4000) }],
        ..in_time(Start::Frames, 0.4, 4000)
    };
    let mut history = History::new(&scene, &[], &options(), &dynamics, &mut ()).expect("it can begin");
    let mass = [MASS, MASS, MASS, DIAMETRAL, DIAMETRAL];
    let mut all = Vec::new();
    while let Some(row) = history.next() {
        all.push(row.expect("it goes on"));
        let (x, v) = (&history.state().displacement, &history.state().velocity);
        let (at_x, at_y) = (x[0] + AT * x[4], x[1] - AT * x[3]);
        let strain = RADIAL * (at_x * at_x + at_y * at_y)
            + AXIAL * x[2] * x[2]
            + TILTING * (x[3] * x[3] + x[4] * x[4]);
        let kinetic: f64 = mass.iter().zip(v).map(|(mass, v)| mass * v * v).sum();
        let work: f64 = load.iter().zip(x).map(|(load, x)| load * x).sum();
        let scale = load[0] * load[0] / RADIAL;
        // Initial accelerations come from a step of negligible length, with its energy.
        assert!((0.5 * (strain + kinetic) - work).abs() < 1e-6 * scale, "{strain} {kinetic} {work}");
    }
    for kept in [1, 5, 10] {
        let options = AnalysisOptions { solved: all[..kept].to_vec(), ..options() };
        let resumed = History::new(&scene, &[], &options, &dynamics, &mut ()).expect("it can go on");
        assert_eq!(resumed.map(|row| row.expect("it goes on")).collect::<Vec<_>>(), all[kept..]);
    }
}

/// An unbalanced rotor from the position of its bearing: forced and free vibrations, and the same
/// force as the reaction of a rotor that cannot move.
#[test]
fn an_unbalanced_rotor_moves_in_a_circle() {
    let (unbalance, until) = (1e-3, 0.0123);
    let inertia = Inertia { moment: [unbalance, 0.0, 0.0], ..Inertia::axial(MASS, POLAR, DIAMETRAL) };
    let tilt = rotation([0.0, 1.0, 0.0], 0.8);
    let free = [Component::Ux, Component::Uy];
    let scene = rotor(tilt, inertia, [0.0; 6], &free);
    let [coarse, fine] = [4000, 8000].map(|steps| end(&scene, &in_time(Start::Frames, until, steps)));
    let found = &fine + (&fine - &coarse) / 3.0;
    // Along the DOFs the body's x axis starts at this angle.
    let steady = SteadyRotation { origin: [0.1, -0.2], start: 0.7, speed: SPEED };
    let frame = RelocatedMotion::rotated_about(Arc::new(steady), tilt, [0.3, 0.0, 0.1]).frame(0.0);
    let axes = tilted_axes(tilt.map(|row| row[2]));
    let at = |axis: usize| (0..3).map(|k| frame[k] * axes[axis][k]).sum::<f64>();
    let start = at(1).atan2(at(0));
    let natural = f64::sqrt(RADIAL / MASS);
    let size = unbalance * SPEED * SPEED / (RADIAL - MASS * SPEED * SPEED);
    // Phase, and initial value and rate of the circle, along both DOFs.
    let (quarter, (sin, cos)) = (-0.5 * std::f64::consts::PI, start.sin_cos());
    let meant = [(0.0, [cos, -SPEED * sin]), (quarter, [sin, SPEED * cos])];
    for (k, (phase, [from, rate])) in meant.into_iter().enumerate() {
        let forced = (start + SPEED * until + phase).cos();
        let own = -from * (natural * until).cos() - rate / natural * (natural * until).sin();
        let meant = size * (forced + own);
        assert!((found[k] - meant).abs() < 1e-5 * size.abs(), "{k}: {} {meant}", found[k]);
    }

    // Only the axial component is free, so the radial force is the support's.
    let mut scene = rotor(tilt, inertia, [0.0; 6], &[Component::Uz]);
    let body = calyx_runtime::scene::BodyId(0);
    let outputs = [0, 1, 2].map(|axis| {
        OutputRequest::observing(format!("f{axis}"), scene.add_observable(SupportForce(body, axis)))
    });
    let dynamics = in_time(Start::Equilibrium, until, 10);
    let history = History::new(&scene, &outputs, &options(), &dynamics, &mut ()).expect("it can begin");
    for solved in history {
        let row = solved.expect("it is solved").row;
        let angle = start + SPEED * row.position.time;
        let force = -unbalance * SPEED * SPEED;
        for axis in 0..3 {
            let meant = force * (angle.cos() * axes[0][axis] + angle.sin() * axes[1][axis]);
            let found = row.outputs[axis].value;
            assert!((found - meant).abs() < 1e-9 * force.abs(), "{axis}: {found} {meant}");
        }
    }
}

/// An axis that turns is refused, with its body.
#[test]
fn an_axis_that_changes_its_direction_is_refused() {
    #[derive(Clone, Copy)]
    struct Tumbling;
    impl Motion for Tumbling {
        fn frame(&self, time: f64) -> [f64; 12] {
            let (sin, cos) = time.sin_cos();
            [1.0, 0.0, 0.0, 0.0, cos, sin, 0.0, -sin, cos, 0.0, 0.0, 0.0]
        }
        fn rate(&self, time: f64) -> [f64; 12] {
            let (sin, cos) = time.sin_cos();
            [0.0, 0.0, 0.0, 0.0, -sin, cos, 0.0, -cos, -sin, 0.0, 0.0, 0.0]
        }
        fn acceleration(&self, time: f64) -> [f64; 12] {
            let (sin, cos) = time.sin_cos();
            [0.0, 0.0, 0.0, 0.0, -cos, -sin, 0.0, sin, -cos, 0.0, 0.0, 0.0]
        }
    }
    let mut scene = Scene::default();
    let body = Body::new("arm", Arc::new(RigidBody), Tumbling)
        .free_in(&SPACE)
        .with_added(Inertia::axial(MASS, POLAR, DIAMETRAL));
    let body = scene.add_body(body);
    let table = scene.add_body(Body::new("table", Arc::new(RigidBody), Tumbling));
    let bearing = Bearing::new("bearing", body, AT, bearing_matrix()).between(table);
    scene.add_bearing(bearing).expect("a bearing");
    let dynamics = in_time(Start::Frames, 1e-3, 2);
    let refused = History::new(&scene, &[], &options(), &dynamics, &mut ()).err().expect("refused");
    assert_eq!(refused.code, "E0610");
    assert!(refused.message.contains("\"arm\""), "{}", refused.message);
}
