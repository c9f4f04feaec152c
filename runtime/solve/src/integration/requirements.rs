//! Checks of the requirements of time integration: elastic teeth, mass, axes of constant direction.

use calyx_fe::inertia::Inertia;
use calyx_model::bearing::Support;
use calyx_model::dof::{DOF_NAMES, Dof};
use calyx_model::elastic_body::SharedElasticBody;
use calyx_model::fidelity::Fidelity;
use calyx_model::frames::solid_pose;
use calyx_model::ids::BodyId;
use calyx_model::mechanism::Mechanism;
use calyx_model::motion::angular_velocity;
use calyx_model::rigid::RigidBody;
use calyx_numerics::error::{EngineError, Subject};
use calyx_numerics::vec3::{cross, length};
use std::any::Any;

/// Checks that a fidelity level has forces, so that bodies vibrate.
///
/// # Errors
/// E0781: its bodies are rigid.
pub fn check_elastic(fidelity: Fidelity) -> Result<(), EngineError> {
    match fidelity {
        Fidelity::Analytic | Fidelity::Plane | Fidelity::Solid(_) => Ok(()),
        Fidelity::Rigid => Err(EngineError::new(
            "E0781",
            "the fidelity level \"rigid\" has no forces, so bodies cannot vibrate on their teeth",
            "",
        )
        .blame("fidelity")),
    }
}

/// Largest component of an angular velocity across the axis of a body that is rounding, relative to
/// the whole.
const ROUNDING: f64 = 1e-8;

/// Checks that the prescribed motion of a body keeps the direction of its axis at a time (s): the
/// DOFs of a body are along axes that keep their directions.
///
/// # Errors
/// E0710: the frame is NaN. E0610: the direction changes.
pub fn check_axis(scene: &Mechanism, body: usize, time: f64) -> Result<(), EngineError> {
    let axis = solid_pose(scene, body, time)?.axis();
    let velocity = angular_velocity(scene.bodies[body].motion.as_ref(), time);
    if length(cross(velocity, axis)) <= ROUNDING * length(velocity) {
        return Ok(());
    }
    let name = &scene.bodies[body].name;
    Err(EngineError::new(
        "E0610",
        format!("the axis of body \"{name}\" changes its direction, which dynamic analyses do not support"),
        "let its frame rotate about its own z axis only; it may move along any path",
    )
    .about(Subject::Body(body)))
}

/// Checks that free bodies have mass.
///
/// # Errors
/// E0762: a free DOF has no inertia.
pub fn check_inertia(scene: &Mechanism, dofs: &[Dof], inertias: &[Inertia]) -> Result<(), EngineError> {
    for dof in dofs {
        let body = &scene.bodies[dof.body];
        let inertia = inertias.get(dof.body).copied().unwrap_or_default();
        let (resists, what, argument) = match dof.component {
            0..3 => (inertia.mass, "mass", "mass"),
            5 => (inertia.about[2][2], "moment of inertia about its axis", "inertia"),
            component => {
                let about = component.saturating_sub(3).min(1);
                (inertia.about[about][about], "moment of inertia about a diameter", "diametral_inertia")
            }
        };
        let restrained = resists.is_finite() && resists > 0.0;
        if !restrained && !connection_resists(scene, dof) {
            if scene.connections_of(BodyId(dof.body)).any(|connection| connection.body.is_some()) {
                let message = format!("the elastic body of the attachment \"{}\" has no mass", body.name);
                let help = "state the density of its materials, or fix the attachment";
                return Err(EngineError::new("E0762", message, help).about(Subject::Body(dof.body)));
            }
            if scene.connections_of(BodyId(dof.body)).any(|connection| connection.shaft.is_some()) {
                let message = format!("\"{}\" is free to move, and its shaft has no mass", body.name);
                let help = "state the density of the material of the shaft";
                return Err(EngineError::new("E0762", message, help).about(Subject::Body(dof.body)));
            }
            let is_plain = (body.prototype.as_ref() as &dyn Any).is::<RigidBody>();
            let remedy = match is_plain {
                true => format!("give it a positive `{argument}`"),
                false => "state the density of its material".to_owned(),
            };
            return Err(EngineError::new(
                "E0762",
                format!("body \"{}\" is free to move and has no {what}", body.name),
                format!("{remedy}, or remove \"{}\" from `free`", DOF_NAMES[dof.component]),
            )
            .blame("free")
            .about(Subject::Body(dof.body)));
        }
    }
    Ok(())
}

/// Returns whether an elastic connection has inertia along a DOF.
fn connection_resists(scene: &Mechanism, dof: &Dof) -> bool {
    scene.connections_of(BodyId(dof.body)).any(|connection| {
        // The mass of an elastic body is condensed later, onto all components of its attachments.
        if let Some(SharedElasticBody(body)) = &connection.body {
            return body.has_mass();
        }
        let size = connection.size();
        let own = connection.attachments.iter().enumerate();
        own.filter(|(_, attachment)| attachment.to == Support::Body(BodyId(dof.body))).any(|(index, _)| {
            let row = 6 * index + dof.component;
            connection.mass.get(row * size + row).is_some_and(|&entry| entry > 0.0)
        })
    })
}
