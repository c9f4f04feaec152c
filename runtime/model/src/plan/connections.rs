//! Plan of elastic connections.

use super::BodyPlan;
use crate::connection::{CondensedShaft, ElasticConnection, Seat};
use crate::dof::DOF_NAMES;
use crate::elastic_body::MassReduction;
use crate::fidelity::{BodyModel, Fidelity, StructureOptions};
use crate::ids::BodyId;
use crate::mechanism::Mechanism;
use crate::prototype::Ignored;
use crate::shaft::SolidShaftMesh;
use calyx_numerics::error::EngineError;

/// Plan of an elastic connection.
#[derive(Clone, Debug)]
pub struct ConnectionPlan {
    /// Name in the scene.
    pub name: String,
    /// Reason for modelling the connection, or for leaving it out.
    pub reason: &'static str,
    /// True if the connection is not modelled.
    pub left_out: bool,
    /// Reduction of the mass of an elastic body: none unless an output concerns vibrations.
    pub mass: MassReduction,
    /// Mesh of a shaft that is modelled as a solid.
    pub shaft_mesh: SolidShaftMesh,
}

/// Plans the elastic connections of a scene with these bodies.
pub(super) fn plan_connections(
    scene: &Mechanism,
    bodies: &[BodyPlan],
    (fidelity, options, vibrations): (Fidelity, &StructureOptions, bool),
) -> Vec<ConnectionPlan> {
    let rigid = fidelity.body_model() == BodyModel::Rigid;
    let plan = |connection: &ElasticConnection| {
        let unwanted = connection.bodies().all(|body| bodies.get(body.0).is_none_or(|plan| plan.left_out));
        let moves = |body: BodyId| scene.bodies.get(body.0).is_some_and(|body| body.free.contains(&true));
        let still = !connection.bodies().any(moves) && !has_elements_on_a_seat(scene, connection);
        let idle = connection.attachments.len() < 2 || still;
        // The mass of a rigid part with one attachment counts.
        let massive =
            connection.mass.iter().any(|&entry| entry != 0.0) || connection.body.is_some() && vibrations;
        ConnectionPlan {
            name: connection.name.clone(),
            reason: match (unwanted, idle) {
                (true, _) => "left out: no output depends on the bodies that it connects",
                (_, true) if !massive => "left out: it connects nothing that moves relative to each other",
                _ if connection.solid_shaft(fidelity).is_some() => {
                    "a solid of revolution, condensed onto its sections"
                }
                _ if connection.body.is_none() => "a stiffness between the frames of its bodies",
                _ if rigid => "rigid at this fidelity: its attachments move together",
                _ => "elastic: condensed onto its attachments",
            },
            left_out: unwanted || (idle && !massive),
            mass: if vibrations { MassReduction::Static } else { MassReduction::None },
            shaft_mesh: SolidShaftMesh::of(options),
        }
    };
    scene.connections.iter().map(plan).collect()
}

/// Returns whether elements run on a seat of an elastic body that is their raceway: it deforms even
/// if its attachments are fixed.
fn has_elements_on_a_seat(scene: &Mechanism, connection: &ElasticConnection) -> bool {
    let rolling = || scene.bearings.iter().filter(|bearing| bearing.rolling().is_some());
    let has_elements = |seat: &Seat| rolling().any(|bearing| bearing.bodies().any(|id| id.0 == seat.body));
    connection.seats().iter().any(has_elements)
}

/// Checks the modelled elastic bodies with their attachments, and the shafts.
///
/// # Errors
/// Those of [`crate::elastic_body::ElasticBody::check`] and [`crate::shaft::Shaft::check_solid`].
pub(super) fn check_bodies(
    scene: &Mechanism,
    plans: &[ConnectionPlan],
    fidelity: Fidelity,
) -> Result<(), EngineError> {
    let modelled = scene.connections.iter().zip(plans).filter(|(_, plan)| !plan.left_out);
    for (connection, _) in modelled {
        if let Some(CondensedShaft { shaft, stations, .. }) = connection.solid_shaft(fidelity) {
            shaft.check_solid(stations).map_err(|error| connection.about_shaft(error))?;
        }
        let Some(body) = &connection.body else { continue };
        body.0.check().map_err(|error| connection.named(error))?;
    }
    Ok(())
}

/// Returns the inputs of the modelled elastic bodies that no analysis takes into account.
pub(super) fn ignored_inputs(scene: &Mechanism, plans: &[ConnectionPlan]) -> Vec<Ignored> {
    let modelled = scene.connections.iter().zip(plans).filter(|(_, plan)| !plan.left_out);
    let of_body = modelled.filter_map(|(connection, _)| Some((&connection.name, connection.body.as_ref()?)));
    of_body
        .flat_map(|(name, body)| {
            let ignored = body.0.ignored().into_iter();
            ignored.map(move |reason| Ignored { input: name.clone(), reason })
        })
        .collect()
}

/// Returns whether a body belongs to an elastic connection.
pub(super) fn is_section(scene: &Mechanism, body: BodyId) -> bool {
    scene.connections_of(body).next().is_some()
}

/// Rejects out-of-plane components of bodies on an elastic connection in a plane model.
pub(super) fn refuse_bending_in_plane(
    scene: &Mechanism,
    body: BodyId,
    free: [bool; 6],
) -> Result<(), EngineError> {
    let Some(connection) = scene.connections_of(body).next() else { return Ok(()) };
    let Some(dof) = [2, 3, 4].into_iter().find(|&dof| free[dof]) else { return Ok(()) };
    if connection.body.is_some() {
        let message = format!(
            "the elastic body \"{}\" moves along and tilts about all axes, which a two-dimensional model does not have",
            connection.name
        );
        return Err(EngineError::new("E0611", message, "leave the elastic body out"));
    }
    let message = format!(
        "\"{}\" bends and moves along its axis ({}), which a two-dimensional model does not have",
        connection.name, DOF_NAMES[dof]
    );
    let help = "give the shaft `free = [\"theta_z\"]`: it then twists only";
    Err(EngineError::new("E0611", message, help).blame("free"))
}
