//! Complete model before the analysis: a mechanism with its observables.

pub use calyx_model::body::Body;
pub use calyx_model::dof::{Component, DOF_NAMES};
pub use calyx_model::fidelity::{BodyModel, Fidelity, StructureOptions, Template};
pub use calyx_model::ids::{BearingId, BodyId, ConnectionId, ObservableId, PairId};
pub use calyx_model::mechanism::Mechanism;
pub use calyx_model::pairs::{CharacteristicPoint, FirstContact, GearMesh, GridOptions, SurfacePair};
pub use calyx_model::prototype::{Ignored, Prototype, ToothFlanks, ToothMeridian};

use crate::forced_response::ForcedResponseRequest;
use crate::observables::{CampbellRequest, ModesRequest, Observable};
use crate::radiated_sound::{SoundRequest, position_of};
use calyx_model::target::{Examined, Target};
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// Complete model. The first analysis freezes it.
///
/// A scene is a [`Mechanism`] with observables, and dereferences to the mechanism.
#[derive(Clone, Default)]
pub struct Scene {
    /// Simulated mechanism.
    pub mechanism: Mechanism,
    /// Observables, indexed by [`ObservableId`].
    pub observables: Vec<Arc<dyn Observable>>,
    /// Request for a table of the modes at the first position.
    pub modes_table: Option<ModesRequest>,
    /// Request for a Campbell diagram about the first position.
    pub campbell_diagram: Option<CampbellRequest>,
    /// Request for a forced response over the speed.
    pub forced_response: Option<ForcedResponseRequest>,
    /// Requests for the sound that elastic bodies radiate in the forced response.
    pub sounds: Vec<SoundRequest>,
}

impl Scene {
    /// Adds an observable, or returns the existing id of an equal one.
    pub fn add_observable(&mut self, observable: impl Observable) -> ObservableId {
        let known = self.observables.iter().position(|known| known.as_ref().equals(observable.as_any()));
        let at = known.unwrap_or_else(|| {
            self.observables.push(Arc::new(observable));
            self.observables.len() - 1
        });
        ObservableId(at)
    }

    /// Adds a request for radiated sound, or joins its points and field meshes with those of an
    /// equal one.
    pub fn add_sound(&mut self, request: SoundRequest) -> AddedSound {
        let without_points = |request: &SoundRequest| SoundRequest {
            points: Vec::new(),
            fields: Vec::new(),
            ..request.clone()
        };
        let wanted = without_points(&request);
        let known = self.sounds.iter().position(|known| without_points(known) == wanted);
        let at = known.unwrap_or_else(|| {
            self.sounds.push(wanted);
            self.sounds.len() - 1
        });
        let SoundRequest { points, fields, .. } = &mut self.sounds[at];
        AddedSound {
            sound: at,
            points: request.points.iter().map(|point| position_of(points, point)).collect(),
            fields: request.fields.iter().map(|field| position_of(fields, field)).collect(),
        }
    }
}

/// Indices of a request for radiated sound, and of its points and field meshes within it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AddedSound {
    /// Index of the request.
    pub sound: usize,
    /// Indices of the points.
    pub points: Vec<usize>,
    /// Indices of the field meshes.
    pub fields: Vec<usize>,
}

impl Deref for Scene {
    type Target = Mechanism;

    fn deref(&self) -> &Mechanism {
        &self.mechanism
    }
}

impl DerefMut for Scene {
    fn deref_mut(&mut self) -> &mut Mechanism {
        &mut self.mechanism
    }
}

impl Examined for Scene {
    fn mechanism(&self) -> &Mechanism {
        &self.mechanism
    }

    fn targets(&self) -> Vec<Target> {
        self.observables.iter().map(|observable| observable.target()).collect()
    }

    fn examines_modes(&self) -> bool {
        self.modes_table.is_some() || self.campbell_diagram.is_some() || self.forced_response.is_some()
    }

    fn tabulated_modes(&self) -> Option<usize> {
        let campbell = self.campbell_diagram.as_ref().and_then(|request| request.modes);
        campbell.max(self.modes_table.as_ref().and_then(|request| request.count))
    }
}
