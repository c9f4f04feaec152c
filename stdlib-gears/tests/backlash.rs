//! Load reversal in time: the gear loses contact on one side of its teeth, crosses the backlash,
//! hits the other side and returns, again and again without damping. The static stiffness and the
//! backlash account for all of its energy.

use crate::common::pair::{COARSE, FIRST, PLAIN, TORQUE, system};
use calyx_gears::assembly::{MeshOptions, add_body, mesh};
use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::fe::quadrature::gauss_legendre;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{MeshForce, Rotation};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{Body, BodyId, Component, PairId, Scene};

/// Centre distance, m; the teeth fill their spaces at 3 inches.
const DISTANCE: f64 = 3.005 * crate::common::INCH;
const STANDARD: f64 = 3.0 * crate::common::INCH;
/// Ratio of the reversed load to the initial one.
const REVERSED: f64 = -0.25;
/// Time step, s.
const STEP: f64 = 2e-6;
const STEPS: usize = 3000;

/// The pair at a very low speed. Its load rises during the second before time 0, at which it
/// reverses.
pub fn reversing() -> (Scene, [PairId; 2]) {
    let mut scene = Scene::default();
    let load = |time: f64| match time <= 0.0 {
        true => Wrench::of_moment([0.0, 0.0, TORQUE * (1.0 + time)]),
        false => Wrench::of_moment([0.0, 0.0, REVERSED * TORQUE]),
    };
    let turning = |x: f64, speed: f64| SteadyRotation { origin: [x, 0.0], start: 0.0, speed };
    let first = Body::new("first", PLAIN[0].prototype.clone(), turning(0.0, 1e-9))
        .free_in(&[Component::ThetaZ])
        .with_added(Inertia::axial(0.0, 2e-3, 0.0))
        .loaded(load);
    let second = Body::new("second", PLAIN[1].prototype.clone(), turning(DISTANCE, -0.5e-9));
    let bodies: Vec<BodyId> =
        [first, second].into_iter().map(|body| add_body(&mut scene, body).expect("a body")).collect();
    let options = MeshOptions {
        tip_corner_contact: false,
        half_cells: Some(6),
        grid_width: Some(8e-4),
        coast_side_contact: true,
        ..MeshOptions::default()
    };
    let meshed = mesh(&mut scene, bodies[0], bodies[1], &options).expect("a mesh");
    (scene, [meshed.pair, meshed.back.expect("back sides")])
}

/// Strain energy of the teeth under the load at time 0, J: the work of the load as it rises.
fn strain_energy(scene: &Scene) -> f64 {
    let system = system(scene);
    let turn = |part: f64| {
        let step = system.solve(part - 1.0).expect("equilibrium");
        system.value(&step, &Rotation(FIRST, 2)).value
    };
    let mean: f64 = gauss_legendre(6).iter().map(|(at, weight)| 0.5 * weight * turn(0.5 * (1.0 + at))).sum();
    TORQUE * (turn(1.0) - mean)
}

#[test]
fn a_load_that_reverses_sends_the_gear_to_and_fro_without_loss() {
    let (mut scene, [front, back]) = reversing();
    let inertia = scene.bodies[FIRST.0].inertia().polar();
    let constrained = strain_energy(&scene);
    let outputs = [
        OutputRequest::observing("turn", scene.add_observable(Rotation(FIRST, 2))),
        OutputRequest::observing("front", scene.add_observable(MeshForce(front))),
        OutputRequest::observing("back", scene.add_observable(MeshForce(back))),
    ];
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(STEP * STEPS as f64, STEPS)],
        scheme: Scheme::AVERAGE,
        rayleigh: [0.0; 2],
        start: Start::Equilibrium,
    };
    let options = AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() };
    let mut history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
    let mut states = Vec::new();
    while let Some(solved) = history.next() {
        let outputs = solved.expect("it goes on").row.outputs;
        let [turn, front, back] = [0, 1, 2].map(|k: usize| outputs[k].value);
        states.push([turn, history.state().velocity[0], front, back]);
    }

    // Free flight, and the energy in it minus the work of the load on the way.
    let begun = states[0][0];
    let flying: Vec<&[f64; 4]> = states.iter().filter(|[_, _, front, back]| front + back == 0.0).collect();
    let energy =
        |[turn, speed, ..]: &[f64; 4]| 0.5 * inertia * speed * speed - REVERSED * TORQUE * (turn - begun);
    let fastest = flying.iter().map(|state| state[1].abs()).fold(0.0, f64::max);
    let kinetic = 0.5 * inertia * fastest * fastest;
    let off: Vec<f64> = flying.iter().map(|state| (energy(state) - constrained) / kinetic).collect();
    let most = off.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = off.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(most < 1e-3 && least > -1e-3, "gained {most:e}, lost {:e} of {kinetic:e} J", -least);

    // The gear hits both sides, time after time.
    let strikes =
        |side: usize| states.windows(2).filter(|pair| pair[0][side] == 0.0 && pair[1][side] > 0.0).count();
    assert!(strikes(2) >= 3 && strikes(3) >= 3, "{} {}", strikes(2), strikes(3));

    // The distance between the impacts is the backlash, on the base circle.
    let involute = |angle: f64| angle.tan() - angle;
    let radii: f64 = PLAIN.iter().map(|member| member.gear().base_radius).sum();
    let angle = |distance: f64| (radii / distance).acos();
    let backlash = 2.0 * radii * (involute(angle(DISTANCE)) - involute(angle(STANDARD)));
    let ends = flying.iter().map(|state| state[0]);
    let wide = ends.clone().fold(f64::NEG_INFINITY, f64::max) - ends.fold(f64::INFINITY, f64::min);
    let lever = PLAIN[0].gear().base_radius;
    assert!((wide * lever / backlash - 1.0).abs() < 0.005, "{:e} {backlash:e}", wide * lever);
}
