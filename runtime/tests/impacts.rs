//! Tests of impacts without damping: time integration must not generate energy. Oscillators with
//! clearance pass through many impacts, on stops and on the contact of an elastic cylinder. Out of
//! contact, the energy follows from speed and height alone.
//!
//! A step in which contact begins does too little work, one in which it ends too much, of second
//! order in the ratio of step to contact time. Both must average out: the limit is that of one
//! impact, for any number of impacts.

use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, Stop};
use calyx_runtime::disc::{Disc, Facing, Platen};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::Material;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Displacement;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, BodyId, Component, GridOptions, Scene, StructureOptions, SurfacePair};
use std::f64::consts::PI;
use std::sync::Arc;

const RADIUS: f64 = 0.02;
const WIDTH: f64 = 0.01;
/// Largest relative energy gain of an oscillator.
const GAIN: f64 = 1e-3;

/// Creates a cylinder at this height above a platen, free in the vertical direction.
fn cylinder(height: f64) -> (Scene, BodyId) {
    let mut scene = Scene::default();
    let platen = Arc::new(Platen::new(0.1, WIDTH, Facing::Up));
    let below = scene.add_body(Body::new("platen", platen, SteadyRotation::at_rest([0.0; 2])));
    let disc = Arc::new(Disc::new(RADIUS, WIDTH, Material::STEEL));
    let above = Body::new("cylinder", disc, SteadyRotation::at_rest([0.0, RADIUS + height]));
    let above = scene.add_body(above.free_in(&[Component::Uy]));
    scene.add_pair(SurfacePair::new([below, above], [Platen::SURFACE, Disc::BOTTOM]));
    (scene, above)
}

/// Returns times, positions and speeds of the only DOF, step by step, until the given number of
/// `impacts` has begun.
fn followed(
    mut scene: Scene,
    (body, component, dof): (BodyId, usize, usize),
    (step, impacts): (f64, usize),
    touches: impl Fn(f64) -> bool,
) -> Vec<[f64; 3]> {
    let outputs = [OutputRequest::observing("place", scene.add_observable(Displacement(body, component)))];
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(200_000.0 * step, 200_000)],
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        start: Start::Frames,
    };
    let coarse = StructureOptions { refinement: 0.5, order: 2, ..StructureOptions::default() };
    let options = AnalysisOptions { structure: coarse, ..AnalysisOptions::default() };
    let mut history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
    let (mut states, mut seen, mut touched) = (Vec::new(), 0, false);
    while seen <= impacts {
        let row = history.next().expect("a position").expect("a solution");
        assert!(row.certificate.largest() < 1e-10, "{:?}", row.certificate);
        let (place, speed) = (row.row.outputs[0].value, history.state().velocity[dof]);
        seen += usize::from(touches(place) && !touched);
        touched = touches(place);
        states.push([row.row.position.time, place, speed]);
    }
    states
}

/// Returns the largest gain and loss relative to the first energy.
fn changes(energies: &[f64]) -> [f64; 2] {
    let first = energies[0];
    let most = |sign: f64| energies.iter().map(|energy| sign * (energy / first - 1.0)).fold(0.0, f64::max);
    [most(1.0), most(-1.0)]
}

/// A mass that moves between the walls of its bearing.
#[test]
fn a_mass_between_walls_keeps_its_energy() {
    let (mass, stiffness, clearance, speed, step) = (1.0, 1e7, 2e-5, 0.1, 2e-5);
    let (mut scene, _) = cylinder(1.0);
    let impulse = 4.0 * step;
    let body = Body::new("frame", Arc::new(RigidBody), SteadyRotation::at_rest([0.5, 0.0]))
        .free_in(&[Component::Ux])
        .with_added(Inertia::axial(mass, 1e-3, 0.0))
        .loaded(move |time: f64| match time < impulse {
            true => Wrench::of_force([mass * speed / impulse, 0.0, 0.0]),
            false => Wrench::NONE,
        });
    let body = scene.add_body(body);
    let wall = |sign: f64| Stop::Wall { clearance, direction: [sign, 0.0, 0.0, 0.0, 0.0, 0.0], stiffness };
    let walls =
        Bearing { stops: vec![wall(1.0), wall(-1.0)], ..Bearing::new("walls", body, 0.0, [[0.0; 6]; 6]) };
    scene.add_bearing(walls).expect("a bearing");
    let states = followed(scene, (body, 0, 1), (step, 1000), |place| place.abs() >= clearance);
    let flying = states.iter().filter(|[time, place, _]| *time > impulse && place.abs() < clearance);
    let energies: Vec<f64> = flying.map(|[_, _, speed]| speed * speed).collect();
    let [gained, lost] = changes(&energies);
    assert!(gained < GAIN && lost < 3.0 * GAIN, "gained {gained:e}, lost {lost:e}");
}

/// A cylinder that a force presses against a platen and that bounces on its elastic surface: its
/// energy is known from the initial position.
#[test]
fn a_bouncing_cylinder_rises_no_higher_than_it_fell_from() {
    let (height, force, step) = (4e-6, 1e4, 5e-7);
    let (mut scene, body) = cylinder(height);
    scene.bodies[body.0] = scene.bodies[body.0].clone().loaded(Wrench::of_force([0.0, -force, 0.0]));
    scene.pairs[0].grid = GridOptions { half_cells: Some(4), width: Some(6e-4), ..GridOptions::default() };
    let states = followed(scene, (body, 1, 0), (step, 200), |place| place <= -height);
    let mass = Material::STEEL.density * PI * RADIUS * RADIUS * WIDTH;
    let flying = states.iter().filter(|[_, place, _]| *place > -height);
    let energies: Vec<f64> =
        flying.map(|[_, place, speed]| 0.5 * mass * speed * speed + force * (height + place)).collect();
    assert!((energies[0] / (force * height) - 1.0).abs() < 1e-9, "{:e}", energies[0]);
    let [gained, lost] = changes(&energies);
    assert!(gained < GAIN && lost < 3.0 * GAIN, "gained {gained:e}, lost {lost:e}");
}
