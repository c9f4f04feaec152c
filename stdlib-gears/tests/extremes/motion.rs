//! Time steps far below and above the periods of the motion, and times far from zero.

use super::case::{Case, Refusal, off, worst};
use calyx_runtime::analysis::AnalysisOptions;
use calyx_runtime::bearing::{Bearing, axisymmetric};
use calyx_runtime::disc::{Facing, Platen};
use calyx_runtime::dynamics::{DynamicOptions, History, Scheme, Start, TimeRange};
use calyx_runtime::error::EngineError;
use calyx_runtime::inertia::Inertia;
use calyx_runtime::load::Wrench;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::Displacement;
use calyx_runtime::results::OutputRequest;
use calyx_runtime::rigid::RigidBody;
use calyx_runtime::scene::{Body, Component, Scene, SurfacePair};
use std::f64::consts::TAU;
use std::sync::Arc;

pub fn cases() -> Vec<Case> {
    vec![
        Case::holds(
            "A mass on a spring, released under a load",
            "2000 steps of 1e-9 periods",
            1e-5,
            "the closed form, 2e-11 of the final amplitude: no digits are lost",
            || {
                let swung = Oscillator { step: 1e-9, ..SOFT }.moved(2000);
                let phase: f64 = TAU * 2000e-9;
                // 1 - cos, without cancellation.
                off(swung, 2.0 * (0.5 * phase).sin().powi(2) * SOFT.rest())
            },
        ),
        Case::holds(
            "The same",
            "a hundred steps of a million periods, by \"backward_difference\"",
            1e-9,
            "statics",
            || {
                let scheme = Scheme::named("backward_difference").expect("it is known");
                off(Oscillator { step: 1e6, scheme, ..SOFT }.moved(100), SOFT.rest())
            },
        ),
        Case::holds(
            "The same",
            "a hundred steps of a million periods, by \"average_acceleration\": amplitude",
            2.0,
            "at most twice the static deflection: the oscillation is not resolved, and does not grow",
            || worst([99, 100].map(|steps| Oscillator { step: 1e6, ..SOFT }.moved(steps) / SOFT.rest())),
        ),
        Case::holds(
            "The same",
            "masses of 1e-12 kg and 1e12 kg, springs of 1e-6 N/m and 1e18 N/m",
            2e-3,
            "the closed form",
            || {
                let pairs =
                    [1e-12, 1e12].into_iter().flat_map(|mass| [1e-6, 1e18].map(|spring| (mass, spring)));
                worst(pairs.map(|(mass, spring)| {
                    let oscillator = Oscillator { mass, spring, step: 0.005, ..SOFT };
                    off(oscillator.moved(100), 2.0 * oscillator.rest())
                }))
            },
        ),
        Case::holds(
            "The same",
            "start at 1e5 s, steps of 1e-6 s",
            1e-3,
            "the same with a start at 0 s",
            || {
                let oscillator = Oscillator { spring: 1e7, step: 1e-6 * (1e7_f64).sqrt() / TAU, ..SOFT };
                off(Oscillator { from: 1e5, ..oscillator }.moved(100), oscillator.moved(100))
            },
        ),
        Case::refused(
            "The same",
            "start at 1e5 s, steps of 1e-13 s",
            "E0763",
            "the steps are below the resolution of a double at these times",
            || {
                let oscillator =
                    Oscillator { spring: 1e7, step: 1e-13 * (1e7_f64).sqrt() / TAU, from: 1e5, ..SOFT };
                oscillator.history(10).err().map(Refusal::from)
            },
        ),
    ]
}

/// Mass on a spring under a constant load, from rest.
#[derive(Clone, Copy)]
struct Oscillator {
    /// Mass, kg.
    mass: f64,
    /// Stiffness, N/m.
    spring: f64,
    /// Time step in periods.
    step: f64,
    scheme: Scheme,
    /// Start time, s.
    from: f64,
}

const SOFT: Oscillator = Oscillator { mass: 1.0, spring: 1.0, step: 1.0, scheme: Scheme::AVERAGE, from: 0.0 };
/// Load, N.
const LOAD: f64 = 1.0;

impl Oscillator {
    fn rest(&self) -> f64 {
        LOAD / self.spring
    }

    fn scene(&self) -> Scene {
        let mut scene = Scene::default();
        let platen = |facing| Arc::new(Platen::new(0.1, 0.01, facing));
        let at = |y: f64| SteadyRotation::at_rest([0.0, y]);
        let below = scene.add_body(Body::new("below", platen(Facing::Up), at(-1.0)));
        let above = scene.add_body(Body::new("above", platen(Facing::Down), at(0.0)));
        scene.add_pair(SurfacePair::new([below, above], [Platen::SURFACE; 2]));
        let body = Body::new("mass", Arc::new(RigidBody), SteadyRotation::at_rest([0.5, 0.0]))
            .free_in(&[Component::Ux])
            .with_added(Inertia::axial(self.mass, self.mass, 0.0))
            .loaded(Wrench::of_force([LOAD, 0.0, 0.0]));
        let body = scene.add_body(body);
        let spring = Bearing::new("spring", body, 0.0, axisymmetric(self.spring, 0.0, 0.0, 0.0));
        scene.add_bearing(spring).expect("a bearing");
        scene
    }

    fn history(&self, steps: usize) -> Result<f64, EngineError> {
        let mut scene = self.scene();
        let body = calyx_runtime::scene::BodyId(2);
        let outputs = [OutputRequest::observing("x", scene.add_observable(Displacement(body, 0)))];
        let period = TAU * (self.mass / self.spring).sqrt();
        let duration = self.step * period * steps as f64;
        let dynamics = DynamicOptions {
            from: self.from,
            ranges: vec![TimeRange { keep: steps, ..TimeRange::steady(duration, steps) }],
            scheme: self.scheme,
            rayleigh: [0.0; 2],
            start: Start::Frames,
        };
        let options = AnalysisOptions::default();
        let mut last = f64::NAN;
        for row in History::new(&scene, &outputs, &options, &dynamics, &mut ())? {
            last = row?.row.outputs[0].value;
        }
        Ok(last)
    }

    /// Displacement after a number of steps, m.
    fn moved(&self, steps: usize) -> f64 {
        self.history(steps).expect("it can be followed")
    }
}
