//! Sound that elastic bodies radiate in a forced response: transmission error, mesh force, bearing
//! forces, velocity of the surface, sound.
//!
//! The velocities of the surface are combinations of patterns, one by unit velocity of each
//! coordinate of the body. In these the sound power at a frequency is a Hermitian form, which does
//! not depend on the speed. It is computed at some frequencies and interpolated, so that every
//! speed and harmonic costs a few scalar products. The coupling is one-way.
//!
//! See `docs/theory/acoustics.md`.

mod check;
mod directions;
mod fields;
mod frequencies;
mod motion;
mod plane;
mod request;
mod results;
mod shapes;
mod solver;
mod surface;
mod vibration;

pub(crate) use check::{check, check_harmonics};
pub use directions::{CoordinatePlane, Direction};
pub use fields::{FieldRequest, FieldShape};
pub(crate) use motion::{SurfaceMotion, Vibrating};
pub(crate) use request::position_of;
pub use request::{JoinedRequests, SoundRequest};
pub(crate) use results::SKIN_LINES;
pub use results::{PanelSummary, RadiatedSound, Skin, SoundField, SoundPoint, SurfaceSummary, Weighting};
pub use solver::SkinField;
pub use surface::SurfaceSize;
pub use vibration::SurfaceVibration;

use calyx_acoustics::{AcousticError, RigidPlane, SoundMethod};
use calyx_model::connection::{ConnectionState, ElasticConnection};
use calyx_model::elastic_body::SharedElasticBody;
use calyx_model::mechanism::Mechanism;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, dot, minus, plus, scaled};
use calyx_solve::system::System;
use frequencies::Field;
use shapes::BodyShapes;
use solver::Solver;
use std::sync::Arc;
use std::time::{Duration, Instant};
use surface::Surface;

/// Key of the sound among the derived results of a system.
const DERIVED: (usize, i64) = (usize::MAX, 0);
/// Angular velocity of a body that counts as rounding, rad/s.
const AT_REST: f64 = 1e-9;

/// Coordinates of an elastic body relative to ground.
struct Placement {
    state: ConnectionState,
    origin: Vector,
}

impl Placement {
    fn new(scene: &Mechanism, connection: &ElasticConnection) -> Result<Placement, EngineError> {
        let state = ConnectionState::at(&scene.bodies, connection, 0.0)?;
        let first =
            connection.body.as_ref().and_then(|SharedElasticBody(body)| body.positions().first().copied());
        let origin = state.origin(first.unwrap_or_default());
        Ok(Placement { state, origin })
    }

    /// Transforms a direction from ground axes to those of the body.
    fn direction(&self, ground: Vector) -> Vector {
        self.state.axes.map(|axis| dot(axis, ground))
    }

    /// Transforms a point from ground coordinates to those of the body, m.
    fn point(&self, ground: Vector) -> Vector {
        self.direction(minus(ground, self.origin))
    }

    /// Transforms a point from the coordinates of the body to those of ground, m.
    fn ground(&self, point: Vector) -> Vector {
        let parts = self.state.axes.iter().zip(point);
        parts.fold(self.origin, |sum, (axis, part)| plus(sum, scaled(*axis, part)))
    }

    fn plane(&self, request: &SoundRequest) -> Result<Option<RigidPlane>, EngineError> {
        let plane = request.plane.map(|[point, normal]| {
            RigidPlane::new(self.point(point), self.direction(normal)).map_err(engine_error)
        });
        plane.transpose()
    }
}

/// Rounds a length to micrometres and returns it in mm.
fn mm(metres: f64) -> f64 {
    (metres * 1e6).round() / 1e3 + 0.0
}

/// Returns the middle of the box that contains points.
fn middle(points: &[Vector]) -> Vector {
    [0, 1, 2].map(|k: usize| {
        let ends = points.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], point| {
            [low.min(point[k]), high.max(point[k])]
        });
        0.5 * (ends[0] + ends[1])
    })
}

fn refused(message: impl Into<String>, help: impl Into<String>) -> EngineError {
    EngineError::new("E0784", message, help)
}

/// Converts an error of the acoustic solution.
fn engine_error(error: AcousticError) -> EngineError {
    let help = error.help().to_owned();
    match error {
        AcousticError::Interrupted(error) => error,
        other => refused(format!("the radiated sound cannot be computed: {other}"), help),
    }
}

/// Sound of all requests of a scene, with what can be shared by other systems with the same bodies.
pub(crate) struct Sound {
    /// Results by distinct request.
    pub results: Vec<RadiatedSound>,
    /// Requests of the scene.
    pub requests: JoinedRequests,
    /// Harmonic of each line; `None` for sidebands and the mean value.
    pub harmonics: Vec<Option<usize>>,
    /// Time of its computation, without the vibration.
    pub time: Duration,
    fields: Vec<Arc<Field>>,
    shapes: Vec<Arc<BodyShapes>>,
}

impl Sound {
    /// Returns the result of a request of the scene.
    pub fn result(&self, request: usize) -> Option<&RadiatedSound> {
        self.results.get(self.requests.request(request)?)
    }
}

/// Returns the sound that a system has computed; `None` before.
pub(crate) fn of_system(system: &System<'_>) -> Option<Arc<Sound>> {
    system.derived.find(DERIVED)
}

/// Sound that a forced response computes with its vibration.
#[derive(Clone)]
pub(crate) struct SoundTask<'a> {
    /// Requests of the scene; none for a forced response alone.
    pub requests: &'a [SoundRequest],
    /// Plan of the analysis.
    pub plan: &'a Plan,
    /// Highest frequency of the component modes, Hz.
    pub highest_frequency: f64,
    /// Sound of a system with the same bodies, whose fields are valid.
    pub shared: Option<Arc<Sound>>,
}

/// Models of the bodies of all requests: surfaces, velocity patterns and, after the response, the
/// fields in the fluid.
pub(crate) struct SoundModels {
    models: Vec<Vibrating>,
    shapes: Vec<Arc<BodyShapes>>,
    requests: JoinedRequests,
    methods: Vec<SoundMethod>,
    shared: Option<Arc<Sound>>,
    /// Time of the preparation.
    time: Duration,
}

/// Spectral lines of a response.
pub(crate) struct Lines<'a> {
    /// Frequency of each line over the rotational frequency.
    pub orders: &'a [f64],
    /// Harmonic of each line; `None` for sidebands and the mean value.
    pub harmonics: &'a [Option<usize>],
    /// Highest frequency with sound, Hz.
    pub highest: f64,
    /// Multiple of the difference from half of the positions that is the estimated error.
    pub caution: f64,
}

impl SoundModels {
    /// Prepares the bodies of all requests; `highest_line` is the highest frequency of a line, Hz.
    ///
    /// # Errors
    /// Those of [`check()`], and of the condensation of a body.
    pub fn new(
        system: &System<'_>,
        task: &SoundTask<'_>,
        highest_line: f64,
        resources: &Resources,
    ) -> Result<SoundModels, EngineError> {
        let started = Instant::now();
        let SoundTask { plan, highest_frequency, .. } = *task;
        let joined = JoinedRequests::new(task.requests, plan.fidelity);
        let requests = &joined.distinct;
        let highest = highest_frequency.min(highest_line);
        let surface = |request: &SoundRequest| Surface::new(system.scene, request);
        let surfaces: Vec<Surface> = requests.iter().map(surface).collect::<Result<_, _>>()?;
        let known = task.shared.as_ref().map_or(&[][..], |sound| &sound.shapes);
        let mut shapes: Vec<Arc<BodyShapes>> = Vec::new();
        for request in requests {
            let own: Vec<&Surface> = surfaces
                .iter()
                .zip(requests)
                .filter(|(_, other)| other.body == request.body)
                .map(|(own, _)| own)
                .collect();
            let mass = plan.connections[request.body.0].mass;
            let body = (request.body, request.connection(system.scene)?, mass);
            let found: Vec<Arc<BodyShapes>> = shapes.iter().chain(known).cloned().collect();
            shapes.push(BodyShapes::find(body, &own, &found, resources)?);
        }
        let model = |((request, surface), shapes): ((&SoundRequest, Surface), &Arc<BodyShapes>)| {
            resources.install(|| Vibrating::new(system, request, (surface, highest), shapes, resources))
        };
        Ok(SoundModels {
            models: requests.iter().zip(surfaces).zip(&shapes).map(model).collect::<Result<_, _>>()?,
            shapes,
            methods: requests.iter().map(|request| request.method_at(plan.fidelity)).collect(),
            requests: joined,
            shared: task.shared.clone(),
            time: started.elapsed(),
        })
    }

    /// Returns the models of the bodies, by request.
    pub fn vibrating(&self) -> &[Vibrating] {
        &self.models
    }

    /// Computes the sound of all speeds, of which the last one is that of the model, and stores it
    /// in the system. `motions` has the motion of each surface by speed and request.
    ///
    /// # Errors
    /// Those of the acoustic solution and of the interrupt.
    pub fn finish(
        self,
        system: &System<'_>,
        lines: &Lines<'_>,
        (speeds, motions): (&[f64], &[Vec<SurfaceMotion>]),
        resources: &Resources,
    ) -> Result<Arc<Sound>, EngineError> {
        let started = Instant::now();
        let (mut results, mut fields) = (Vec::new(), Vec::new());
        for (index, (model, request)) in self.models.iter().zip(&self.requests.distinct).enumerate() {
            let own: Vec<&SurfaceMotion> = motions.iter().map(|motions| &motions[index]).collect();
            let known = self.shared.as_ref().and_then(|sound| sound.fields.get(index)).cloned();
            let field = match known {
                Some(field) => field,
                None => {
                    let find = || Field::new(model, self.methods[index], lines, (speeds, &own), resources);
                    Arc::new(resources.install(find)?)
                }
            };
            let mut result = RadiatedSound::new((model, request), &field, lines, (speeds, &own));
            // Results of perturbed solves are compared, and not shown.
            if let (None, Some(motion)) = (&self.shared, own.last()) {
                let solver = Solver::new(model, self.methods[index], &resources.interrupt);
                resources.install(|| result.add_skin(model, &solver, motion))?;
                let lines = result.lines_with_sound();
                result.vibration = Some(SurfaceVibration::new(model, &self.shapes[index], motion, &lines));
            }
            results.push(result);
            fields.push(field);
        }
        let sound = Sound {
            results,
            requests: self.requests,
            harmonics: lines.harmonics.to_vec(),
            time: self.time + started.elapsed(),
            fields,
            shapes: self.shapes,
        };
        system.derived.get_or_create(DERIVED, || sound).ok_or_else(|| refused("the sound is lost", ""))
    }
}
