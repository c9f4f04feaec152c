//! Response of a loaded pair on bearings to a small impulse. The peaks of its transfer function are
//! at the natural frequencies about the equilibrium, which the eigenvalue problem gives without
//! time integration.

use crate::common::pair::{COARSE, FIRST, PLAIN, PairOptions, SECOND, TORQUE, pair, system};
use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::observables::Observe;
use calyx_runtime::observables::{Displacement, NaturalFrequency, Rotation};
use calyx_runtime::results::OutputRequest;
use calyx_runtime::scene::{Component, Scene};
use calyx_runtime::signal::{Shape, Uniform, peaks, transfer_function};

/// Time step, s.
const STEP: f64 = 5e-6;
const STEPS: usize = 8192;
/// Angular impulse, N m s. It is so small that teeth stay in contact and the active set does not
/// change.
const BLOW: f64 = 1e-6;
/// Duration of the impulse in steps.
const TAKES: f64 = 4.0;
/// Number of modes of a pair whose gears have plane motion.
const MODES: usize = 6;

/// Pair at a very low speed, each gear on a bearing of its own, the second one with a torsional
/// spring.
fn on_bearings() -> Scene {
    let (mut scene, _) = pair(&PairOptions { speed: 1e-6, ..PairOptions::chapter_5(&PLAIN) });
    scene.pairs[0].grid.half_cells = Some(3);
    scene.pairs[0].grid.width = Some(8e-4);
    scene.observables.clear();
    for (body, stiffness) in [(FIRST, [1.5e8, 0.0]), (SECOND, [4e8, 2e6])] {
        let free = scene.bodies[body.0].clone().free_in(&[Component::Ux, Component::Uy, Component::ThetaZ]);
        scene.bodies[body.0] = free.with_added(Inertia::axial(2.0, 2e-3, 0.0));
        let [radial, torsional] = stiffness;
        let mut matrix = axisymmetric(radial, 0.0, 0.0, torsional);
        // Housings that are stiffer in one direction separate the natural frequencies.
        matrix[1][1] *= 1.7;
        scene.add_bearing(Bearing::new(format!("bearing {}", body.0), body, 0.0, matrix)).expect("a bearing");
    }
    scene
}

#[test]
#[ignore = "takes a minute: .ci/full runs it"]
fn peaks_of_the_transfer_function_are_the_natural_frequencies() {
    let mut scene = on_bearings();
    let system_scene = scene.clone();
    let system = system(&system_scene);
    let step = system.solve(0.0).expect("equilibrium");
    let natural: Vec<f64> =
        (0..MODES).map(|mode| system.value(&step, &NaturalFrequency(mode)).value).collect();

    let struck = scene.bodies[FIRST.0].clone();
    scene.bodies[FIRST.0] = struck.loaded(|time: f64| {
        let passed = time / (TAKES * STEP);
        let impulse = match (0.0..1.0).contains(&passed) {
            true => 2.0 * BLOW / (TAKES * STEP) * (std::f64::consts::PI * passed).sin().powi(2),
            false => 0.0,
        };
        Wrench::of_moment([0.0, 0.0, TORQUE + impulse])
    });
    let observed = [
        scene.add_observable(Rotation(FIRST, 2)),
        scene.add_observable(Displacement(FIRST, 0)),
        scene.add_observable(Displacement(FIRST, 1)),
        scene.add_observable(Rotation(SECOND, 2)),
        scene.add_observable(Displacement(SECOND, 0)),
        scene.add_observable(Displacement(SECOND, 1)),
    ];
    let outputs = observed.map(|id| OutputRequest::observing(format!("{}", id.0), id));
    let duration = STEP * STEPS as f64;
    let dynamics = DynamicOptions {
        from: 0.0,
        ranges: vec![TimeRange::steady(duration, STEPS)],
        scheme: Scheme::AVERAGE,
        // The response has decayed at the end.
        rayleigh: [10.0 / duration, 0.0],
        start: Start::Equilibrium,
    };
    let options = AnalysisOptions { structure: COARSE, ..AnalysisOptions::default() };
    let history = History::new(&scene, &outputs, &options, &dynamics, &mut ()).expect("it can begin");
    let rows: Vec<Vec<f64>> = history
        .map(|solved| solved.expect("it goes on").row.outputs.iter().map(|output| output.value).collect())
        .collect();

    let mut seen = [false; MODES];
    for output in 0..outputs.len() {
        let response =
            Uniform { start: 0.0, step: STEP, values: rows.iter().map(|row| row[output]).collect() };
        let transfer = transfer_function(&response, rows[0][output], BLOW);
        let found = peaks(&transfer.magnitudes, 2 * MODES, Shape::Resonance);
        for peak in &found {
            let frequency = peak.line * transfer.resolution;
            let mode = natural.iter().position(|natural| (frequency - natural).abs() < transfer.resolution);
            mode.into_iter().for_each(|mode| seen[mode] = true);
            // Small peaks are shifted slightly, because they lie on the slopes of larger ones.
            let large = peak.amplitude > 0.4 * found[0].amplitude;
            assert!(mode.is_some() || !large, "output {output}: {frequency} Hz is none of {natural:?}");
        }
    }
    assert_eq!(seen, [true; MODES], "{natural:?}");
}
