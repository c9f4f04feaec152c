//! Motion in time of cylinders and frames on bearings: closed forms, bits of runs that go on, and what is refused.

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::Bearing;
use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observe::{Displacement, Rotation, SupportForce};
use calyx_runtime::results::{OutputRequest, Solved};
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, Component, Fidelity, Scene, SurfacePair, Template};
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

const RADIUS: f64 = 0.02;
const WIDTH: f64 = 0.01;

/// A steel cylinder above a platen, on which a force drives it.
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
    DynamicOptions {
        from: 0.0,
        ranges,
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        highest_frequency: 0.0,
        start: Start::Frames,
    }
}

fn run(
    scene: &Scene,
    outputs: &[OutputRequest],
    dynamics: &DynamicOptions,
    solved: Vec<Solved>,
) -> Vec<Solved> {
    let options = AnalysisOptions { solved, ..AnalysisOptions::default() };
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
        OutputRequest::observing("y", scene.observe(Displacement(body, 1))),
        OutputRequest::observing("turn", scene.observe(Rotation(body, 2))),
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
    let outputs = [OutputRequest::observing("y", scene.observe(Displacement(body, 1)))];
    let first = TimeRange { keep: 4, ..TimeRange::steady(2e-4, 20) };
    let ramp = TimeRange { duration: 1e-4, steps: 7, load: [1.0, 2.0], keep: 3 };
    let dynamics = from_frames(vec![first, ramp]);
    let whole = run(&scene, &outputs, &dynamics, Vec::new());
    assert_eq!(whole.len(), 1 + 5 + 3);
    for done in [1, 4, 6] {
        assert_eq!(run(&scene, &outputs, &dynamics, whole[..done].to_vec()), whole);
    }
}

/// Mass, spring and damper: the bearing's own, a part of the mass, a part of the stiffness. All that acts on a free frame adds up to nothing.
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
            OutputRequest::observing("x", scene.observe(Displacement(body, 0))),
            OutputRequest::observing("support", scene.observe(SupportForce(body, 0))),
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
    // Neither is built before it is known: a frame without mass, and bodies in space.
    let (mut massless, _) = cylinder(1e-3, 1.0);
    let frame = Body::new("frame", Arc::new(RigidBody), SteadyRotation::at_rest([0.5, 0.0]));
    let frame = massless.add_body(frame.free_in(&[Component::Ux]));
    let mut stiffness = [[0.0; 6]; 6];
    stiffness[0][0] = 1e6;
    massless.add_bearing(Bearing::new("support", frame, 0.0, stiffness)).expect("a bearing");
    massless.observe(Displacement(frame, 0));
    assert_eq!(refused(&massless, AnalysisOptions::default(), plain()), Some("E0762"));
    let solid = AnalysisOptions { fidelity: Fidelity::Solid(Template::Medium), ..AnalysisOptions::default() };
    assert_eq!(refused(&scene, solid, plain()), Some("E0761"));
}
