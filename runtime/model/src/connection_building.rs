//! Condenses the elastic bodies and the solid shafts of a planned scene, or takes their matrices
//! from the structure cache.

use crate::connection::{CondensedShaft, ElasticConnection};
use crate::elastic_body::{ElasticBody, MassReduction};
use crate::fidelity::{BodyModel, Fidelity};
use crate::mechanism::Mechanism;
use crate::plan::Plan;
use crate::resources::Resources;
use crate::shaft::SolidShaftMesh;
use crate::structure_building::StructureCounts;
use calyx_numerics::error::EngineError;
use calyx_structure::AttachmentMatrices;
use calyx_structure::cache::{Claim, Key};
use std::sync::Arc;

/// Stiffness of a rigid body relative to the typical stiffness of the elastic one.
const RIGID: f64 = 1e3;
/// The same in the check of restraints, where it is compared with that of bearings.
const COMPARABLE: f64 = 1.0;

/// Returns the connections of a planned scene with their matrices, in the order of the scene.
/// Connections that are left out remain without.
///
/// # Errors
/// Those of [`ElasticBody::condense`] and [`ElasticConnection::check`].
pub fn build_connections(
    scene: &Mechanism,
    plan: &Plan,
    resources: &Resources,
) -> Result<(Vec<ElasticConnection>, StructureCounts), EngineError> {
    let mut counts = StructureCounts::default();
    let one = |(index, connection): (usize, &ElasticConnection)| {
        let planned = plan.connections.get(index).filter(|planned| !planned.left_out);
        if let (Some(shaft), Some(planned)) = (connection.solid_shaft(plan.fidelity), planned) {
            let about = |error: EngineError| connection.about_shaft(error);
            let (matrices, anew) = shaft_matrices(shaft, planned.shaft_mesh, resources).map_err(about)?;
            *if anew { &mut counts.built } else { &mut counts.reused } += 1;
            let stiffness = matrices.stiffness.clone();
            return Ok(ElasticConnection { stiffness, ..connection.with_shaft_modes(planned.mass)? });
        }
        if let (Some(_), Some(planned)) = (&connection.shaft, planned) {
            return connection.with_shaft_modes(planned.mass);
        }
        let (Some(body), Some(planned)) = (&connection.body, planned) else { return Ok(connection.clone()) };
        if is_rigid(plan.fidelity) {
            return connection.rigid(&scene.bodies, RIGID);
        }
        let named = |error: EngineError| match error.code {
            "E0991" | "E0992" => connection.named(error),
            _ => error,
        };
        let (matrices, anew) = matrices(body.0.as_ref(), planned.mass, resources).map_err(named)?;
        *if anew { &mut counts.built } else { &mut counts.reused } += 1;
        connection.condensed(&scene.bodies, &matrices)
    };
    let connections = scene.connections.iter().enumerate().map(one).collect::<Result<_, _>>()?;
    Ok((connections, counts))
}

fn is_rigid(fidelity: Fidelity) -> bool {
    fidelity.body_model() == BodyModel::Rigid
}

/// Returns the connections of a scene with all elastic bodies as stiff links, which resist the same
/// motions as the bodies. Nothing is condensed.
///
/// # Errors
/// Those of [`ElasticConnection::rigid`].
pub fn connections_as_links(scene: &Mechanism) -> Result<Vec<ElasticConnection>, EngineError> {
    scene.connections.iter().map(|connection| connection.rigid(&scene.bodies, COMPARABLE)).collect()
}

/// Returns the stiffness of a solid shaft, from the cache if possible, and whether it was computed.
fn shaft_matrices(
    CondensedShaft { shaft, stations, .. }: &CondensedShaft,
    mesh: SolidShaftMesh,
    resources: &Resources,
) -> Result<(Arc<AttachmentMatrices>, bool), EngineError> {
    let key = Key::of("solid shaft")
        .text(crate::SOURCE)
        .key(&shaft.key())
        .numbers(stations)
        .count(u64::from(mesh.order))
        .count(mesh.fineness as u64)
        .finish();
    let condense = || {
        let stiffness = resources.install(|| shaft.solid_stiffness(stations, mesh, &resources.interrupt))?;
        Ok(AttachmentMatrices { stiffness, ..AttachmentMatrices::default() })
    };
    cached(Some(key), (stations.len(), false), resources, condense)
}

/// Returns the matrices of an elastic body, from the cache if possible, and whether they were
/// computed.
fn matrices(
    body: &dyn ElasticBody,
    mass: MassReduction,
    resources: &Resources,
) -> Result<(Arc<AttachmentMatrices>, bool), EngineError> {
    let condense = || resources.install(|| body.condense(mass, &resources.interrupt));
    let with_mass = mass.has_mass();
    let key = body.key().map(|key| {
        let key = Key::of("attachments").key(&key).flag(with_mass);
        key.numbers(&[mass.highest_frequency()]).finish()
    });
    let attachments = body.positions().len() + usize::from(body.is_grounded());
    cached(key, (attachments, with_mass), resources, condense)
}

/// Returns matrices of a number of attachments, with or without mass: from the cache by their key,
/// or computed.
fn cached(
    key: Option<Key>,
    (attachments, with_mass): (usize, bool),
    resources: &Resources,
    condense: impl Fn() -> Result<AttachmentMatrices, EngineError>,
) -> Result<(Arc<AttachmentMatrices>, bool), EngineError> {
    let (Some(cache), Some(key)) = (resources.cache.as_deref(), key) else {
        return Ok((Arc::new(condense()?), true));
    };
    let mut anew = false;
    let matrices = cache.attachments(key, &resources.interrupt, |claim| {
        let on_disk = claim.and_then(Claim::on_disk);
        let kept = on_disk.and_then(|(store, key)| {
            AttachmentMatrices::restored(&store.read(&key)?, attachments, with_mass)
        });
        if let Some(kept) = kept {
            return Ok(Arc::new(kept));
        }
        anew = true;
        let matrices = condense()?;
        if let Some((store, key)) = on_disk
            && let Some(content) = matrices.stored()
        {
            store.write(&key, &content);
        }
        Ok(Arc::new(matrices))
    })?;
    Ok((matrices, anew))
}
