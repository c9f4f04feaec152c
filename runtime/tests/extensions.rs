//! A contact surface, a body, an observable and an analysis that are defined outside of the engine,
//! each in one place: the worked examples of `docs/contributing.md`.
//!
//! An elliptic cam presses on an elastic cylinder. Near its apex the ellipse has the radius of
//! curvature `a²/b`, so the contact is Hertz's (Johnson, Contact Mechanics, eqs. 4.43 to 4.45).

use calyx_runtime::analyses::Analysis;
use calyx_runtime::analysis::{AnalysisOptions, Observer, Position, quasi_static};
use calyx_runtime::disc::Disc;
use calyx_runtime::error::EngineError;
use calyx_runtime::estimate::Estimates;
use calyx_runtime::interrupt::Interrupt;
use calyx_runtime::load::Wrench;
use calyx_runtime::material::{Material, Plane};
use calyx_runtime::method::Method;
use calyx_runtime::motion::SteadyRotation;
use calyx_runtime::observables::{Equilibrium, MaxContactPressure, Observable, Quantity};
use calyx_runtime::observed::Observed;
use calyx_runtime::profile::{Profile, ProfilePoint};
use calyx_runtime::prototype::no_solid_model;
use calyx_runtime::results::{AnalysisResult, OutputRequest};
use calyx_runtime::scene::{
    Body, Component, Fidelity, PairId, Prototype, Scene, StructureOptions, SurfacePair,
};
use calyx_runtime::structure::{RigidStructure, Structure};
use calyx_runtime::validate::Request;
use std::f64::consts::PI;
use std::sync::Arc;

const FACE_WIDTH: f64 = 0.02;

/// Contact surface: an arc of an ellipse about its lowest point, by arc length from its left end.
struct LowerArc {
    /// Semi-axes along x and y, m.
    semi_axes: [f64; 2],
    /// Length of the arc, m.
    length: f64,
}

/// Steps of the midpoint rule along half of the arc.
const STEPS: usize = 2000;

impl LowerArc {
    /// Derivative of the point (a sin t, -b cos t) by its parameter t, and the second derivative.
    fn derivatives(&self, t: f64) -> [[f64; 2]; 2] {
        let ([a, b], (sin, cos)) = (self.semi_axes, t.sin_cos());
        [[a * cos, b * sin], [-a * sin, b * cos]]
    }

    /// Parameter of the point at a distance along the arc from the apex, m.
    fn parameter(&self, distance: f64) -> f64 {
        let step = distance / STEPS as f64;
        let rate = |t: f64| {
            let [[x, y], _] = self.derivatives(t);
            x.hypot(y).recip()
        };
        (0..STEPS).fold(0.0, |t, _| t + step * rate(t + 0.5 * step * rate(t)))
    }
}

impl Profile for LowerArc {
    fn length(&self) -> f64 {
        self.length
    }

    fn at(&self, s: f64) -> ProfilePoint {
        let t = self.parameter(s - 0.5 * self.length);
        let ([a, b], (sin, cos)) = (self.semi_axes, t.sin_cos());
        let [[x, y], [second_x, second_y]] = self.derivatives(t);
        let speed = x.hypot(y);
        ProfilePoint {
            position: [a * sin, -b * cos],
            tangent: [x / speed, y / speed],
            normal: [y / speed, -x / speed],
            curvature: (x * second_y - y * second_x) / speed.powi(3),
        }
    }
}

/// Body: a rigid cam with this surface.
struct Cam {
    semi_axes: [f64; 2],
}

impl Cam {
    /// Index of its only surface.
    const SURFACE: u32 = 0;
}

impl Prototype for Cam {
    fn check(&self, _: &StructureOptions, three_dimensional: bool) -> Result<(), EngineError> {
        if three_dimensional { Err(no_solid_model()) } else { Ok(()) }
    }

    fn build(&self, _: &StructureOptions, _: &Interrupt) -> Result<Arc<dyn Structure>, EngineError> {
        let arc = LowerArc { semi_axes: self.semi_axes, length: 0.5 * self.semi_axes[0] };
        Ok(Arc::new(RigidStructure::new(vec![Arc::new(arc)], 1)))
    }

    fn enclosing_radius(&self) -> f64 {
        self.semi_axes[0].max(self.semi_axes[1])
    }

    fn face_width(&self) -> f64 {
        FACE_WIDTH
    }
}

/// Observable: the vertical part of the force on a pair, N.
#[derive(Clone, Copy, Debug, PartialEq)]
struct VerticalForce(PairId);

impl Observable for VerticalForce {
    fn quantity(&self) -> Quantity {
        Quantity::repeating("vertical_force", "N")
    }

    fn value(&self, at: &Equilibrium<'_>) -> Observed {
        let vertical = at.contacts(self.0).map(|contact| contact.force() * contact.normal()[1].abs());
        Observed::number(vertical.sum())
    }

    fn pair_of(&self) -> Option<PairId> {
        Some(self.0)
    }
}

/// Analysis: equilibria under the same position at equal steps of time, as a test rig that raises
/// the load in stages.
struct LoadStages {
    stages: usize,
}

impl LoadStages {
    fn positions(&self) -> Vec<Position> {
        (1..=self.stages).map(|stage| Position::at(stage as f64)).collect()
    }
}

impl Method for LoadStages {
    fn check_options(&self, fidelity: Fidelity) -> Result<(), EngineError> {
        match (self.stages, fidelity) {
            (0, _) => Err(EngineError::new("E0673", "there is no load stage", "give at least one")),
            (_, Fidelity::Rigid) => {
                Err(EngineError::new("E0781", "rigid bodies carry no load", "choose \"plane\""))
            }
            _ => Ok(()),
        }
    }

    fn first_equilibrium(&self) -> Option<f64> {
        Some(1.0)
    }
}

impl Analysis for LoadStages {
    fn problems(&self) -> usize {
        self.stages
    }

    fn sample_times(&self, _: usize) -> Vec<f64> {
        self.positions().iter().map(|position| position.time).collect()
    }

    fn run(
        &self,
        scene: &Scene,
        outputs: &[OutputRequest],
        options: &AnalysisOptions,
        observer: &mut dyn Observer,
    ) -> Result<AnalysisResult, EngineError> {
        Request::new(scene, outputs, self, options).plan(&options.resources.interrupt)?;
        quasi_static(scene, &self.positions(), outputs, options, observer)
    }
}

/// A cam above a disc; the load per stage of time is `force`, N.
fn scene(cam: Cam, radius: f64, force: f64) -> (Scene, PairId) {
    let height = cam.semi_axes[1];
    let mut scene = Scene::default();
    let disc = Arc::new(Disc::new(radius, FACE_WIDTH, Material::STEEL));
    let disc = scene.add_body(Body::new("disc", disc, SteadyRotation::at_rest([0.0, -radius])));
    let cam = scene.add_body(
        Body::new("cam", Arc::new(cam), SteadyRotation::at_rest([0.0, height]))
            .free_in(&[Component::Uy])
            .loaded(move |time: f64| Wrench::of_force([0.0, -force * time, 0.0])),
    );
    let pair = scene.add_pair(SurfacePair::new([cam, disc], [Cam::SURFACE, Disc::TOP]));
    (scene, pair)
}

#[test]
fn extensions_from_outside_solve_a_contact_of_hertz() {
    let (semi_axes, radius, force) = ([0.06, 0.03], 0.05, 1000.0);
    let (mut scene, pair) = scene(Cam { semi_axes }, radius, force);
    let pressure = scene.add_observable(MaxContactPressure(pair));
    let vertical = scene.add_observable(VerticalForce(pair));
    let outputs =
        [OutputRequest::observing("pressure", pressure), OutputRequest::observing("force", vertical)];
    let stages: &dyn Analysis = &LoadStages { stages: 3 };
    let result = stages.run(&scene, &outputs, &AnalysisOptions::default(), &mut ()).expect("load stages");
    assert_eq!((stages.problems(), result.rows.len()), (3, 3));
    assert!(result.certificate.largest() < 1e-12);
    let [a, b] = semi_axes;
    let curvature = b / (a * a) + 1.0 / radius;
    let modulus = Material::STEEL.surface_modulus(Plane::Strain);
    for (stage, row) in result.rows.iter().enumerate() {
        let force = force * (stage + 1) as f64;
        // The cam is rigid, so the modulus is that of the disc.
        let line_load = force / FACE_WIDTH;
        let expected = (line_load * modulus * curvature / PI).sqrt();
        let [pressure, vertical] = [0, 1].map(|output| row.outputs[output].value);
        assert!((pressure / expected - 1.0).abs() < 5e-3, "stage {stage}: {pressure} {expected}");
        assert!((vertical / force - 1.0).abs() < 1e-9, "stage {stage}: {vertical} {force}");
    }
}

#[test]
fn an_analysis_from_outside_is_validated_like_those_of_the_engine() {
    let (mut scene, pair) = scene(Cam { semi_axes: [0.06, 0.03] }, 0.05, 1000.0);
    let vertical = scene.add_observable(VerticalForce(pair));
    let outputs = [OutputRequest::observing("force", vertical)];
    let code = |stages: usize, fidelity: Fidelity| {
        let options = AnalysisOptions { fidelity, ..AnalysisOptions::default() };
        LoadStages { stages }.run(&scene, &outputs, &options, &mut ()).err().map(|error| error.code)
    };
    assert_eq!(code(1, Fidelity::Plane), None);
    assert_eq!(code(0, Fidelity::Plane), Some("E0673"));
    assert_eq!(code(1, Fidelity::Rigid), Some("E0781"));
    // The closed forms contain no discs.
    assert_eq!(code(1, Fidelity::Analytic), Some("E0783"));
    let stages = LoadStages { stages: 1 };
    let options = AnalysisOptions { error_estimates: Estimates::None, ..AnalysisOptions::default() };
    let refused = stages.run_within(0.02, &scene, &outputs, &options, &mut ()).err();
    assert_eq!(refused.map(|error| error.code), Some("E0791"));
}
