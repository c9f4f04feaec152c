//! Checks of requested sound before a structure is built.

use super::request::{JoinedRequests, SoundRequest};
use super::surface::Surface;
use super::{AT_REST, plane, refused};
use calyx_acoustics::SoundMethod;
use calyx_model::connection::ElasticConnection;
use calyx_model::elastic_body::SharedElasticBody;
use calyx_model::fidelity::Fidelity;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::angular_velocity;
use calyx_model::plan::Plan;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::length;

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
    let joined = JoinedRequests::new(sounds, plan.fidelity);
    // Requests that differ in fluid and method have the same surface.
    let mut surfaces: Vec<(&SoundRequest, Surface)> = Vec::new();
    for (index, request) in joined.distinct.iter().enumerate() {
        let about = |error: EngineError| match error.subject {
            None => joined.of_scene(error.about(Subject::Sound(index))),
            Some(_) => joined.of_scene(error),
        };
        let connection = request.connection(scene)?;
        check_body(connection, request, plan).map_err(about)?;
        // These are about the analysis.
        check_lines(&connection.name, lowest_line, highest_frequency)?;
        check_surroundings(scene, (connection, request), plan.fidelity).map_err(about)?;
        let is_same = |(other, _): &(&SoundRequest, Surface)| {
            other.body == request.body && other.plane == request.plane
        };
        if !surfaces.iter().any(is_same) {
            surfaces.push((request, Surface::new(scene, request).map_err(about)?));
        }
        for (_, surface) in surfaces.iter().filter(|known| is_same(known)) {
            surface.check_points(index, request).map_err(about)?;
        }
    }
    Ok(())
}

/// Checks that a body has walls that vibrate.
fn check_body(
    connection: &ElasticConnection,
    request: &SoundRequest,
    plan: &Plan,
) -> Result<(), EngineError> {
    let name = &connection.name;
    let Some(SharedElasticBody(body)) = &connection.body else {
        return Err(refused(
            format!("\"{name}\" is a shaft, which has no surface that radiates"),
            "give an elastic body with a mesh, such as that of `gears.nastran`",
        )
        .blame("body"));
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
        )
        .blame("body"));
    }
    if !body.has_mass() {
        return Err(refused(
            format!("\"{name}\" has no mass, so its vibration is unknown"),
            "give its material a density",
        )
        .blame("body"));
    }
    Ok(())
}

/// Checks that a body has component modes, and the response lines with sound.
fn check_lines(name: &str, lowest_line: Option<f64>, highest_frequency: f64) -> Result<(), EngineError> {
    if highest_frequency <= 0.0 {
        return Err(refused(
            format!("\"{name}\" has no component modes, so its walls follow its attachments"),
            "set `highest_frequency` in `analyze` to the highest frequency of interest, such as 5000 Hz",
        )
        .blame("highest_frequency"));
    }
    match lowest_line.filter(|lowest| *lowest > highest_frequency) {
        None => Ok(()),
        Some(lowest) => Err(refused(
            format!(
                "the lowest line of the forced response at the speed of the model is at {lowest:.0} Hz, above the `highest_frequency` of {highest_frequency:.0} Hz, so there is no sound"
            ),
            format!("set `highest_frequency` in `analyze` above {lowest:.0} Hz, or lower the speed"),
        )
        .blame("highest_frequency")),
    }
}

/// Checks that a body is at rest, and that the method of a request has all that it needs.
fn check_surroundings(
    scene: &Mechanism,
    (connection, request): (&ElasticConnection, &SoundRequest),
    fidelity: Fidelity,
) -> Result<(), EngineError> {
    let name = &connection.name;
    let reference = connection.bodies().next().and_then(|body| scene.bodies.get(body.0));
    let turns = reference.map_or(0.0, |body| length(angular_velocity(body.motion.as_ref(), 0.0)));
    if turns > AT_REST {
        return Err(refused(
            format!("\"{name}\" rotates, and radiated sound is that of a body at rest"),
            "give its frame no rotation",
        )
        .blame("body"));
    }
    let method = request.method_at(fidelity);
    if request.needs_pressures() && method != SoundMethod::BoundaryElements {
        return Err(refused(
            format!("the method \"{}\" has no sound pressure in the fluid", method.name()),
            "choose `method = \"boundary_elements\"`, or leave `method` out",
        )
        .blame("method"));
    }
    plane::check(scene, (connection, request), method)
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
