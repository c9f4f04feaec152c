//! Tests of time integration for cylinders and frames on bearings: closed forms, bitwise equality
//! of resumed runs, and rejected input.

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, BearingMatrix};
use calyx_runtime::cache::OperatorCache;
use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{Displacement, Rotation, SupportForce};
use calyx_runtime::resources::Resources;
use calyx_runtime::results::{OutputRequest, Solved};
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, Component, Scene, SurfacePair};
use nalgebra::Complex;
use std::f64::consts::{PI, TAU};
use std::sync::{Arc, LazyLock};

const RADIUS: f64 = 0.02;
const WIDTH: f64 = 0.01;

/// Structure cache that all tests share.
static CACHE: LazyLock<Arc<OperatorCache>> = LazyLock::new(|| Arc::new(OperatorCache::new(usize::MAX)));

/// Creates a steel cylinder above a platen, with a force towards it.
fn cylinder(height: f64, force: f64) -> (Scene, BodyId) {
    let disc = Disc::new(RADIUS, WIDTH, Material::STEEL);
    let mut scene = Scene::default();
    let platen = Arc::new(Platen::new(0.1, WIDTH, Facing::Up));
    let below = scene.add_body(Body::new("platen", platen, SteadyRotation::at_rest([0.0; 2])));
    let falling = scene.add_body(
        Body::new("cylinder", Arc::new(disc), SteadyRotation::at_rest([0.0, RADIUS + height]))
            .free_in(&[Component::Uy, Component::ThetaZ])
            .loaded(Wrench { force: [0.0, -force, 0.0], moment: [0.0, 0.0, 0.3] }),
    );
    scene.add_pair(SurfacePair::new([below, falling], [Platen::SURFACE, Disc::BOTTOM]));
    (scene, falling)
}

fn from_frames(ranges: Vec<TimeRange>) -> DynamicOptions {
    DynamicOptions { from: 0.0, ranges, scheme: Scheme::AVERAGE, rayleigh: [0.0; 2], start: Start::Frames }
}

fn run(
    scene: &Scene,
    outputs: &[OutputRequest],
    dynamics: &DynamicOptions,
    solved: Vec<Solved>,
) -> Vec<Solved> {
    let resources = Resources { cache: Some(CACHE.clone()), ..Resources::default() };
    let options = AnalysisOptions { solved, resources, ..AnalysisOptions::default() };
    let mut history = History::new(scene, outputs, &options, dynamics, &mut ()).expect("it can begin");
    for row in history.by_ref() {
        let certificate = row.expect("it goes on").certificate;
        assert!(certificate.largest() < 1e-10, "{certificate:?}");
    }
    history.solved().to_vec()
}

#[test]
fn what_nothing_touches_falls_and_spins_as_its_mass_says() {
    let (mut scene, body) = cylinder(1e-3, 20.0);
    let outputs = [
        OutputRequest::observing("y", scene.add_observable(Displacement(body, 1))),
        OutputRequest::observing("turn", scene.add_observable(Rotation(body, 2))),
    ];
    let range = TimeRange { keep: 5, ..TimeRange::steady(2e-3, 20) };
    let solved = run(&scene, &outputs, &from_frames(vec![range]), Vec::new());
    assert_eq!(solved.len(), 5);
    let mass = Material::STEEL.density * PI * RADIUS * RADIUS * WIDTH;
    for Solved { row, .. } in &solved {
        let half = 0.5 * row.position.time.powi(2);
        let expected = [-20.0 / mass * half, 0.3 / (0.5 * mass * RADIUS * RADIUS) * half];
        for (found, expected) in row.outputs.iter().zip(expected) {
            assert!((found.value - expected).abs() <= 1e-11 * expected.abs(), "{} {expected}", found.value);
        }
    }
}

#[test]
fn a_cylinder_that_falls_on_a_platen_goes_on_with_the_same_bits() {
    let (mut scene, body) = cylinder(1e-6, 500.0);
    let outputs = [OutputRequest::observing("y", scene.add_observable(Displacement(body, 1)))];
    let first = TimeRange { keep: 4, ..TimeRange::steady(2e-4, 20) };
    let ramp = TimeRange { duration: 1e-4, steps: 7, load: [1.0, 2.0], keep: 3 };
    let dynamics = from_frames(vec![first, ramp]);
    let whole = run(&scene, &outputs, &dynamics, Vec::new());
    assert_eq!(whole.len(), 1 + 5 + 3);
    for done in [1, 4, 6] {
        assert_eq!(run(&scene, &outputs, &dynamics, whole[..done].to_vec()), whole);
    }
}

/// Mass, spring and damper: damping of the bearing, mass-proportional and stiffness-proportional
/// damping. The support force of a free component is zero.
#[test]
fn damping_of_each_kind_is_that_of_the_closed_form() {
    let (mass, stiffness, force) = (3.0, 4e6, 100.0);
    let natural = f64::sqrt(stiffness / mass);
    let until = 2.3 * TAU / natural;
    let decay = 80.0;
    let damped = (natural * natural - decay * decay).sqrt();
    let along_x = |value: f64| {
        let mut matrix = [[0.0; 6]; 6];
        matrix[0][0] = value;
        matrix
    };
    let kinds = [
        (2.0 * mass * decay, [0.0; 2]),
        (0.0, [2.0 * decay, 0.0]),
        (0.0, [0.0, 2.0 * mass * decay / stiffness]),
    ];
    for (damping, rayleigh) in kinds {
        let (mut scene, _) = cylinder(1.0, 0.0);
        let body = scene.add_body(
            Body::new("frame", Arc::new(RigidBody), SteadyRotation::at_rest([0.5, 0.0]))
                .free_in(&[Component::Ux])
                .loaded(Wrench::of_force([force, 0.0, 0.0])),
        );
        scene.bodies[body.0].added = Inertia::axial(mass, 0.1, 0.0);
        let bearing =
            Bearing { damping: along_x(damping), ..Bearing::new("support", body, 0.0, along_x(stiffness)) };
        scene.add_bearing(bearing).expect("a bearing");
        let outputs = [
            OutputRequest::observing("x", scene.add_observable(Displacement(body, 0))),
            OutputRequest::observing("support", scene.add_observable(SupportForce(body, 0))),
        ];
        let error = |steps: usize| {
            let range = TimeRange { keep: steps, ..TimeRange::steady(until, steps) };
            let dynamics = DynamicOptions { rayleigh, ..from_frames(vec![range]) };
            let solved = run(&scene, &outputs, &dynamics, Vec::new());
            let [x, support] = [0, 1].map(|output: usize| solved[1].row.outputs[output].value);
            assert!(support.abs() < 1e-9 * force, "{support}");
            let t = solved[1].row.position.time;
            let wave = (damped * t).cos() + decay / damped * (damped * t).sin();
            x - force / stiffness * (1.0 - (-decay * t).exp() * wave)
        };
        let (coarse, fine) = (error(400), error(800));
        assert!(((coarse / fine).log2() - 2.0).abs() < 0.02, "{rayleigh:?}: {coarse:e} {fine:e}");
        assert!((fine + (fine - coarse) / 3.0).abs() < 1e-5 * force / stiffness, "{rayleigh:?}");
    }
}

#[test]
fn what_cannot_move_in_time_is_refused() {
    let (scene, _) = cylinder(1e-3, 1.0);
    let refused = |scene: &Scene, options: AnalysisOptions, dynamics: DynamicOptions| {
        History::new(scene, &[], &options, &dynamics, &mut ()).err().map(|error| error.code)
    };
    let plain = || from_frames(vec![TimeRange::steady(1e-3, 2)]);
    let damped = DynamicOptions { rayleigh: [-1.0, 0.0], ..plain() };
    assert_eq!(refused(&scene, AnalysisOptions::default(), damped), Some("E0764"));
    let no_range = from_frames(Vec::new());
    assert_eq!(refused(&scene, AnalysisOptions::default(), no_range), Some("E0764"));
    // A frame without mass is rejected before structures are built.
    let (mut massless, _) = cylinder(1e-3, 1.0);
    let frame = Body::new("frame", Arc::new(RigidBody), SteadyRotation::at_rest([0.5, 0.0]));
    let frame = massless.add_body(frame.free_in(&[Component::Ux]));
    let mut stiffness = [[0.0; 6]; 6];
    stiffness[0][0] = 1e6;
    massless.add_bearing(Bearing::new("support", frame, 0.0, stiffness)).expect("a bearing");
    massless.add_observable(Displacement(frame, 0));
    assert_eq!(refused(&massless, AnalysisOptions::default(), plain()), Some("E0762"));
}

/// Creates a frame with a mass at x = 0.5 m that is free to translate, without bearings.
fn frame(motion: SteadyRotation, mass: f64) -> Body {
    Body::new("frame", Arc::new(RigidBody), motion)
        .free_in(&[Component::Ux, Component::Uy])
        .with_added(Inertia::axial(mass, 0.1, 0.0))
}

/// Returns a stiffness matrix with values along x and y, N/m.
fn across(x: f64, y: f64) -> BearingMatrix {
    let mut matrix = [[0.0; 6]; 6];
    (matrix[0][0], matrix[1][1]) = (x, y);
    matrix
}

/// Two masses on bearings, initially at rest under a step force: the error of the whole engine is
/// of second order in the time step, and the solution converges to the exact motion.
#[test]
fn steps_are_of_the_second_order_and_go_towards_the_exact_motion() {
    let (masses, ground, between, force, until) = ([2.0, 1.0], 3e5, 2e5, 3.0, 0.03);
    let (mut scene, _) = cylinder(1.0, 0.0);
    let rest = SteadyRotation::at_rest([0.5, 0.0]);
    let first = scene.add_body(frame(rest, masses[0]).loaded(Wrench::of_force([force, 0.0, 0.0])));
    let second = scene.add_body(frame(rest, masses[1]));
    scene.bodies[second.0].name = "second".into();
    scene.add_bearing(Bearing::new("ground", first, 0.0, across(ground, ground))).expect("a bearing");
    let spring = Bearing::new("between", second, 0.0, across(between, between)).between(first);
    scene.add_bearing(spring).expect("a bearing");
    let outputs = [first, second].map(|body| {
        OutputRequest::observing(format!("{}", body.0), scene.add_observable(Displacement(body, 0)))
    });
    let found: Vec<[f64; 2]> = (0..6)
        .map(|halvings| {
            let steps = 500 << halvings;
            let range = TimeRange { keep: steps, ..TimeRange::steady(until, steps) };
            let solved = run(&scene, &outputs, &from_frames(vec![range]), Vec::new());
            [0, 1].map(|output: usize| solved[1].row.outputs[output].value)
        })
        .collect();
    // Modal superposition with modes (1, shape) for the roots of det(K - square M).
    let exact = {
        let [m1, m2] = masses;
        let (trace, product) = ((ground + between) / m1 + between / m2, ground * between / (m1 * m2));
        let root = (0.25 * trace * trace - product).sqrt();
        let mut x = [0.0; 2];
        for square in [0.5 * trace - root, 0.5 * trace + root] {
            let shape = [1.0, between / (between - square * m2)];
            let mass = m1 + m2 * shape[1] * shape[1];
            let amplitude = force / mass / square * (1.0 - (square.sqrt() * until).cos());
            x = [0, 1].map(|k: usize| x[k] + amplitude * shape[k]);
        }
        x
    };
    let error = |k: usize| (found[k][0] - exact[0]).hypot(found[k][1] - exact[1]);
    for k in 0..5 {
        let order = (error(k) / error(k + 1)).log2();
        assert!((order - 2.0).abs() < 0.02, "halving {k}: {order}");
    }
    // Richardson extrapolation of the last three solutions.
    let once = |k: usize, i: usize| found[k + 1][i] + (found[k + 1][i] - found[k][i]) / 3.0;
    for i in 0..2 {
        let towards = once(4, i) + (once(4, i) - once(3, i)) / 15.0;
        assert!((towards - exact[i]).abs() < 1e-8 * exact[0].hypot(exact[1]), "{towards} {}", exact[i]);
    }
}

/// Returns the orders from -4 to 4 of the path (x + i y) of a body over one revolution with the
/// given number of steps, after the initial transient has decayed.
fn orders_of_path(
    mut scene: Scene,
    body: BodyId,
    steps: usize,
    step: f64,
    damping: f64,
) -> Vec<Complex<f64>> {
    let outputs = [0, 1].map(|axis| {
        OutputRequest::observing(format!("{axis}"), scene.add_observable(Displacement(body, axis)))
    });
    let turns = (60.0 / damping / (step * steps as f64)).ceil() as usize;
    let before =
        TimeRange { keep: turns * steps, ..TimeRange::steady((turns * steps) as f64 * step, turns * steps) };
    let ranges = vec![before, TimeRange::steady(steps as f64 * step, steps)];
    let dynamics = DynamicOptions { rayleigh: [damping, 0.0], ..from_frames(ranges) };
    let solved = run(&scene, &outputs, &dynamics, Vec::new());
    let path: Vec<Complex<f64>> = solved[solved.len() - steps..]
        .iter()
        .map(|solved| Complex::new(solved.row.outputs[0].value, solved.row.outputs[1].value))
        .collect();
    let order = |n: i32| {
        let turned = |(k, place): (usize, &Complex<f64>)| {
            place * Complex::from_polar(1.0, -TAU * f64::from(n) * (k + 1) as f64 / steps as f64)
        };
        path.iter().enumerate().map(turned).sum::<Complex<f64>>() / steps as f64
    };
    (-4..=4).map(order).collect()
}

/// Checks two orders against expected values, and that all others vanish.
fn assert_orders(found: &[Complex<f64>], expected: [(i32, Complex<f64>); 2]) {
    let size = expected[0].1.norm().max(expected[1].1.norm());
    for (order, found) in (-4..).zip(found) {
        let meant =
            expected.iter().find(|(there, _)| *there == order).map_or(Complex::default(), |(_, z)| *z);
        assert!((found - meant).norm() < 1e-9 * size, "order {order}: {found} {meant}");
    }
}

/// With the trapezoidal rule a steady vibration has the frequency `2/h tan(omega h/2)` instead of
/// omega, and is otherwise exact; so are its orders.
#[test]
fn orders_of_turning_bodies_seen_from_ground_are_exact() {
    let (mass, [kx, ky], damping) = (2.0, [2e5, 1e5], 80.0);
    let (mean, half) = (0.5 * (kx + ky), 0.5 * (kx - ky));
    let (steps, step) = (240, 2.5e-4);
    let speed = TAU / (steps as f64 * step);
    let answer = |order: f64| {
        let omega = 2.0 / step * (0.5 * order * speed * step).tan();
        Complex::new(mean - mass * omega * omega, mass * damping * omega)
    };
    let turning = SteadyRotation { origin: [0.5, 0.0], start: 0.0, speed };

    // An unbalance in a non-rotating bearing: once per revolution, forward and backward whirl.
    let unbalance = 1e-4;
    let (mut scene, _) = cylinder(1.0, 0.0);
    let off = Inertia { moment: [unbalance, 0.0, 0.0], ..Inertia::default() };
    let rotor = scene.add_body(frame(turning, mass).with_added(off));
    scene.add_bearing(Bearing::new("standing", rotor, 0.0, across(kx, ky))).expect("a bearing");
    let pull = unbalance * speed * speed;
    let forwards = Complex::from(pull) / (answer(1.0) - half * half / answer(-1.0).conj());
    let backwards = -half * forwards.conj() / answer(-1.0);
    let found = orders_of_path(scene, rotor, steps, step, damping);
    assert_orders(&found, [(1, forwards), (-1, backwards)]);

    // A weight on a shaft with unequal bending stiffnesses: static deflection, and twice per
    // revolution.
    let weight = 20.0;
    let (mut scene, _) = cylinder(1.0, 0.0);
    let shaft = scene.add_body(Body::new("shaft", Arc::new(RigidBody), turning));
    let disc = frame(turning, mass).loaded(Wrench::of_force([0.0, -weight, 0.0]));
    let disc = scene.add_body(disc);
    scene.add_bearing(Bearing::new("bending", disc, 0.0, across(kx, ky)).between(shaft)).expect("a bearing");
    let sag = Complex::new(0.0, -weight) / (Complex::from(mean) - half * half / answer(2.0).conj());
    let twice = -half * sag.conj() / answer(2.0);
    let found = orders_of_path(scene, disc, steps, step, damping);
    assert_orders(&found, [(0, sag), (2, twice)]);
}
