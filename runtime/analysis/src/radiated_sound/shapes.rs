//! Displacements of the surface nodes of elastic bodies by units of their unknowns, shared by the
//! requests of a body and by perturbed solves.

use super::refused;
use super::surface::Surface;
use calyx_model::connection::ElasticConnection;
use calyx_model::elastic_body::{MassReduction, MotionShapes, SharedElasticBody};
use calyx_model::ids::ConnectionId;
use calyx_model::resources::Resources;
use calyx_numerics::error::EngineError;
use calyx_structure::ComponentModes;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Relative difference of squared frequencies and of couplings of component modes that counts as
/// rounding.
const SAME: f64 = 1e-6;

/// Displacements of nodes of a body.
#[derive(Debug)]
pub(crate) struct BodyShapes {
    body: ConnectionId,
    mass: MassReduction,
    /// Displacements by unknown and node.
    pub shapes: MotionShapes,
    /// Index of each node among those of the shapes.
    pub places: BTreeMap<usize, usize>,
}

impl PartialEq for BodyShapes {
    fn eq(&self, other: &Self) -> bool {
        let Self { body, mass, shapes, places } = self;
        (*body, *mass, places) == (other.body, other.mass, &other.places)
            && shapes.displacements == other.shapes.displacements
    }
}

impl BodyShapes {
    /// Returns the displacements of the nodes of all surfaces of a body: those of another system
    /// with the same body and nodes, or new ones.
    ///
    /// # Errors
    /// Those of the condensation of the body and of the interrupt.
    pub fn find(
        (body, connection, mass): (ConnectionId, &ElasticConnection, MassReduction),
        surfaces: &[&Surface],
        known: &[Arc<BodyShapes>],
        resources: &Resources,
    ) -> Result<Arc<BodyShapes>, EngineError> {
        let all: BTreeSet<usize> =
            surfaces.iter().flat_map(|surface| surface.skin.nodes.iter().flatten().copied()).collect();
        let is_same = |known: &&Arc<BodyShapes>| {
            known.body == body && known.mass == mass && known.places.keys().eq(all.iter())
        };
        if let Some(known) = known.iter().find(is_same) {
            return Ok(known.clone());
        }
        let lost = || refused(format!("the motion of \"{}\" is unknown", connection.name), "import its mesh");
        let Some(SharedElasticBody(elastic)) = &connection.body else { return Err(lost()) };
        let nodes: Vec<usize> = all.iter().copied().collect();
        let find = || elastic.motion_shapes(mass, &nodes, &resources.interrupt);
        let shapes = resources.install(find)?.ok_or_else(lost)?;
        let places = nodes.into_iter().enumerate().map(|(place, node)| (node, place)).collect();
        Ok(Arc::new(BodyShapes { body, mass, shapes, places }))
    }
}

/// Checks that the component modes of the shapes are those of the vibrations: their frequencies,
/// and their couplings with the attachments, which distinguish the signs and rotations of modes.
pub(super) fn check_modes(
    name: &str,
    shapes: &MotionShapes,
    modes: &ComponentModes,
) -> Result<(), EngineError> {
    let is_near = |one: f64, other: f64, size: f64| (one - other).abs() <= SAME * size;
    let same_frequencies = shapes.eigenvalues.len() == modes.eigenvalues.len()
        && shapes
            .eigenvalues
            .iter()
            .zip(&modes.eigenvalues)
            .all(|(one, other)| is_near(*one, *other, other.abs()));
    // Ground is a further attachment of bodies with supports of their own, and the first rows are
    // those of the attachments then as well.
    let largest = modes.coupling.iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let couplings = shapes.coupling.iter().zip(&modes.coupling);
    let same_couplings = shapes.coupling.len() <= modes.coupling.len()
        && couplings.into_iter().all(|(one, other)| is_near(*one, *other, largest));
    if same_frequencies && same_couplings {
        return Ok(());
    }
    Err(refused(
        format!("the component modes of \"{name}\" in the structure cache are not those of its mesh"),
        "delete the structure cache, and please report the model",
    ))
}
