//! Sound that elastic bodies radiate in a forced response: transmission error, mesh force, bearing
//! forces, velocity of the surface, sound.
//!
//! The velocities of the surface are combinations of patterns, one by unit velocity of each
//! coordinate of the body. In these the sound power at a frequency is a Hermitian form, which does
//! not depend on the speed. It is computed at some frequencies and interpolated, so that every
//! speed and harmonic costs a few scalar products. The coupling is one-way.
//!
//! See `docs/theory/acoustics.md`.

mod directions;
mod fields;
mod frequencies;
mod motion;
mod plane;
mod results;
mod shapes;
mod solver;
mod surface;

pub use directions::{CoordinatePlane, Direction};
pub use fields::{FieldRequest, FieldShape};
pub(crate) use motion::{SurfaceMotion, Vibrating};
pub use results::{PanelSummary, RadiatedSound, Skin, SoundField, SoundPoint, SurfaceSummary, Weighting};
pub use solver::SkinField;
pub use surface::surface_size;

use calyx_acoustics::{AcousticError, Fluid, RigidPlane};
use calyx_model::connection::{ConnectionState, ElasticConnection};
use calyx_model::elastic_body::SharedElasticBody;
use calyx_model::fidelity::Fidelity;
use calyx_model::ids::ConnectionId;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::angular_velocity;
use calyx_model::plan::Plan;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_numerics::vec3::{Vector, dot, length, minus, plus, scaled};
use calyx_solve::system::System;
use frequencies::Field;
use shapes::BodyShapes;
use solver::Solver;
use std::sync::Arc;
use surface::Surface;

/// Key of the sound among the derived results of a system.
const DERIVED: (usize, i64) = (usize::MAX, 0);
/// Angular velocity of a body that counts as rounding, rad/s.
const AT_REST: f64 = 1e-9;

/// Fidelity level of the last link, from velocities to sound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SoundLevel {
    /// Equivalent radiated power: plane waves everywhere. It needs no equations.
    EquivalentPower,
    /// Rayleigh integral: every part of the surface radiates as in a plane baffle, and all
    /// interfere.
    Rayleigh,
    /// Boundary elements.
    BoundaryElements,
}

impl SoundLevel {
    /// All levels, the cheapest first.
    pub const ALL: [SoundLevel; 3] = [Self::EquivalentPower, Self::Rayleigh, Self::BoundaryElements];

    /// Returns the name in models and files.
    pub fn name(self) -> &'static str {
        match self {
            Self::EquivalentPower => "erp",
            Self::Rayleigh => "rayleigh",
            Self::BoundaryElements => "boundary_elements",
        }
    }

    /// Returns the level of a name.
    pub fn named(name: &str) -> Option<SoundLevel> {
        Self::ALL.into_iter().find(|level| level.name() == name)
    }

    /// Returns the level that belongs to a fidelity of the bodies: boundary elements to finite
    /// elements, the Rayleigh integral to closed forms.
    pub fn of_fidelity(fidelity: Fidelity) -> SoundLevel {
        match fidelity {
            Fidelity::Rigid | Fidelity::Analytic | Fidelity::Plane => Self::Rayleigh,
            Fidelity::Solid(_) => Self::BoundaryElements,
        }
    }
}

/// Request for the sound of an elastic body.
#[derive(Clone, Debug, PartialEq)]
pub struct SoundRequest {
    /// Connection of the elastic body.
    pub body: ConnectionId,
    /// Fluid around it.
    pub fluid: Fluid,
    /// Level; `None` for that of the fidelity.
    pub level: Option<SoundLevel>,
    /// Point (m) and normal of a rigid plane in front of which the body is, in ground coordinates.
    pub plane: Option<[Vector; 2]>,
    /// Points at which the pressure is requested, in ground coordinates, m.
    pub points: Vec<Vector>,
    /// Field meshes on which the pressure is requested.
    pub fields: Vec<FieldRequest>,
}

impl SoundRequest {
    /// Returns the level at a fidelity.
    pub fn level_at(&self, fidelity: Fidelity) -> SoundLevel {
        match self.level {
            Some(level) => level,
            None if self.needs_pressures() || self.plane.is_some() => SoundLevel::BoundaryElements,
            None => SoundLevel::of_fidelity(fidelity),
        }
    }

    /// Returns true if pressures in the fluid are requested.
    fn needs_pressures(&self) -> bool {
        !self.points.is_empty() || !self.fields.is_empty()
    }

    fn connection<'s>(&self, scene: &'s Mechanism) -> Result<&'s ElasticConnection, EngineError> {
        scene.connections.get(self.body.0).ok_or_else(|| {
            refused("the scene has no such elastic body", "give a body of this model that is imported")
        })
    }
}

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

/// Checks everything about the requested sound that is known before a structure is built, at a
/// highest frequency of the component modes (Hz). `lowest_line` is the lowest frequency of the
/// forced response at the speed of the model, Hz.
///
/// # Errors
/// E0784: there is no forced response, or no line with sound; a body has no surface, mass or
/// component modes, rotates, is behind the rigid plane, or encloses a point; or a field mesh does
/// not fit. E0785: the surface of a body is open.
pub(crate) fn check(
    scene: &Mechanism,
    (sounds, lowest_line): (&[SoundRequest], Option<f64>),
    plan: &Plan,
    highest_frequency: f64,
) -> Result<(), EngineError> {
    if !sounds.is_empty() && lowest_line.is_none() {
        return Err(refused(
            "the model observes radiated sound, but has no forced response whose vibration radiates",
            "add `gears.forced_response(mesh, highest_speed = 6000 rpm);` before `analyze`",
        ));
    }
    // Requests that differ in fluid and method have the same surface.
    let mut surfaces: Vec<(&SoundRequest, Surface)> = Vec::new();
    for request in sounds {
        let connection = request.connection(scene)?;
        let name = &connection.name;
        let Some(SharedElasticBody(body)) = &connection.body else {
            return Err(refused(
                format!("\"{name}\" is a shaft, which has no surface that radiates"),
                "give an elastic body with a mesh, such as that of `gears.nastran`",
            ));
        };
        if plan.fidelity == Fidelity::Rigid {
            return Err(refused(
                format!("\"{name}\" is rigid at the fidelity \"rigid\", so its walls do not vibrate"),
                "choose a fidelity level with elastic bodies, such as \"analytic\"",
            ));
        }
        if plan.connections.get(request.body.0).is_none_or(|planned| planned.left_out) {
            return Err(refused(
                format!("nothing moves \"{name}\", so it radiates no sound"),
                "mount bearings on its attachments",
            ));
        }
        if !body.has_mass() {
            return Err(refused(
                format!("\"{name}\" has no mass, so its vibration is unknown"),
                "give its material a density",
            ));
        }
        if highest_frequency <= 0.0 {
            return Err(refused(
                format!("\"{name}\" has no component modes, so its walls follow its attachments"),
                "set `highest_frequency` in `analyze` to the highest frequency of interest, such as 5000 Hz",
            )
            .blame("highest_frequency"));
        }
        if let Some(lowest) = lowest_line.filter(|lowest| *lowest > highest_frequency) {
            return Err(refused(
                format!(
                    "the lowest line of the forced response at the speed of the model is at {lowest:.0} Hz, above the `highest_frequency` of {highest_frequency:.0} Hz, so there is no sound"
                ),
                format!("set `highest_frequency` in `analyze` above {lowest:.0} Hz, or lower the speed"),
            )
            .blame("highest_frequency"));
        }
        let reference = connection.bodies().next().and_then(|body| scene.bodies.get(body.0));
        let turns = reference.map_or(0.0, |body| length(angular_velocity(body.motion.as_ref(), 0.0)));
        if turns > AT_REST {
            return Err(refused(
                format!("\"{name}\" rotates, and radiated sound is that of a body at rest"),
                "give its frame no rotation",
            ));
        }
        let level = request.level_at(plan.fidelity);
        if request.needs_pressures() && level != SoundLevel::BoundaryElements {
            return Err(refused(
                format!("the method \"{}\" has no sound pressure in the fluid", level.name()),
                "choose `method = \"boundary_elements\"`, or leave `method` out",
            )
            .blame("method"));
        }
        plane::check(scene, (connection, request), level)?;
        let is_same = |(other, _): &(&SoundRequest, Surface)| {
            other.body == request.body && other.plane == request.plane
        };
        if !surfaces.iter().any(is_same) {
            surfaces.push((request, Surface::new(scene, request)?));
        }
        for (_, surface) in surfaces.iter().filter(|known| is_same(known)) {
            surface.check_points(request)?;
        }
    }
    Ok(())
}

/// Checks that a forced response with a number of harmonics has those whose sound is observed.
///
/// # Errors
/// E0784: it has fewer.
pub(crate) fn check_harmonics(
    count: usize,
    mut observed: impl Iterator<Item = usize>,
) -> Result<(), EngineError> {
    match observed.find(|harmonic| *harmonic > count) {
        None => Ok(()),
        Some(harmonic) => Err(refused(
            format!("the sound of harmonic {harmonic} is observed, and the forced response has {count}"),
            format!("give `gears.forced_response` the argument `harmonics = {harmonic}`"),
        )
        .blame("harmonic")),
    }
}

/// Sound of all requests of a scene, with what can be shared by other systems with the same bodies.
pub(crate) struct Sound {
    /// Results by request.
    pub results: Vec<RadiatedSound>,
    /// Harmonic of each line; `None` for sidebands and the mean value.
    pub harmonics: Vec<Option<usize>>,
    fields: Vec<Arc<Field>>,
    shapes: Vec<Arc<BodyShapes>>,
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
    requests: Vec<SoundRequest>,
    levels: Vec<SoundLevel>,
    shared: Option<Arc<Sound>>,
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
    /// Those of [`check`], and of the condensation of a body.
    pub fn new(
        system: &System<'_>,
        task: &SoundTask<'_>,
        highest_line: f64,
        resources: &Resources,
    ) -> Result<SoundModels, EngineError> {
        let SoundTask { requests, plan, highest_frequency, .. } = *task;
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
            requests: requests.to_vec(),
            levels: requests.iter().map(|request| request.level_at(plan.fidelity)).collect(),
            shared: task.shared.clone(),
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
        let (mut results, mut fields) = (Vec::new(), Vec::new());
        for (index, (model, request)) in self.models.iter().zip(&self.requests).enumerate() {
            let own: Vec<&SurfaceMotion> = motions.iter().map(|motions| &motions[index]).collect();
            let known = self.shared.as_ref().and_then(|sound| sound.fields.get(index)).cloned();
            let field = match known {
                Some(field) => field,
                None => {
                    let find = || Field::new(model, self.levels[index], lines, (speeds, &own), resources);
                    Arc::new(resources.install(find)?)
                }
            };
            let mut result = RadiatedSound::new((model, request), &field, lines, (speeds, &own));
            // Results of perturbed solves are compared, and not shown.
            if let (None, Some(motion)) = (&self.shared, own.last()) {
                let solver = Solver::new(model, self.levels[index], &resources.interrupt);
                resources.install(|| result.add_skin(model, &solver, motion))?;
            }
            results.push(result);
            fields.push(field);
        }
        let sound = Sound { results, harmonics: lines.harmonics.to_vec(), fields, shapes: self.shapes };
        system.derived.get_or_create(DERIVED, || sound).ok_or_else(|| refused("the sound is lost", ""))
    }
}
