//! Serialization of modes for the structure cache: everything but the contact curves.

use super::super::stored::{StoredSurface, Table, from_bytes, to_bytes};
use super::{BodyModes, RingMode, SectorFields};
use crate::profile::Profile;
use faer::Mat;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Tables of fields: real and imaginary parts.
type Parts<'a> = Vec<[Table<'a>; 2]>;

#[derive(Serialize, Deserialize)]
struct StoredModes<'a> {
    frequencies: Vec<f64>,
    coupling: Vec<[f64; 3]>,
    rigid_mass: [[f64; 3]; 3],
    #[serde(borrow)]
    gyroscopic: Table<'a>,
    centrifugal: Vec<f64>,
    teeth: u32,
    harmonics: Vec<u32>,
    modes: Vec<RingMode>,
    surfaces: Vec<StoredSurface>,
    directions: usize,
    #[serde(borrow)]
    displacements: Parts<'a>,
    #[serde(borrow)]
    stresses: Parts<'a>,
}

fn tables(parts: &[[Mat<f64>; 2]]) -> Parts<'static> {
    parts.iter().map(|[re, im]| [Table::from(re), Table::from(im)]).collect()
}

/// Returns the matrices if they have as many columns as there are fields.
fn matrices(parts: &Parts<'_>, fields: usize) -> Option<Vec<[Mat<f64>; 2]>> {
    let both = |[re, im]: &[Table<'_>; 2]| {
        let (re, im) = (re.matrix()?, im.matrix()?);
        let fit = re.ncols() == fields && im.ncols() == fields && re.nrows() == im.nrows();
        fit.then_some([re, im])
    };
    parts.iter().map(both).collect()
}

impl BodyModes {
    /// Serializes the modes for [`Self::restored`], without modified surfaces.
    pub fn stored(&self) -> Option<Vec<u8>> {
        let fields = &*self.fields;
        to_bytes(&StoredModes {
            frequencies: self.frequencies.clone(),
            coupling: self.coupling.clone(),
            rigid_mass: self.rigid_mass,
            gyroscopic: Table::from(&self.gyroscopic),
            centrifugal: self.centrifugal.clone(),
            teeth: fields.teeth,
            harmonics: fields.harmonics.clone(),
            modes: fields.modes.clone(),
            surfaces: fields.surfaces.iter().map(StoredSurface::of).collect(),
            directions: fields.directions,
            displacements: tables(&fields.displacements),
            stresses: tables(&fields.stresses),
        })
    }

    /// Restores modes from bytes, with the curves that they were built with. `None` if the bytes
    /// contain something else.
    pub fn restored(bytes: &[u8], profiles: &[Arc<dyn Profile>]) -> Option<Self> {
        let stored: StoredModes = from_bytes(bytes)?;
        let (count, fields) = (stored.frequencies.len(), stored.harmonics.len());
        let sound = stored.surfaces.len() == profiles.len()
            && stored.directions * profiles.len() == stored.displacements.len()
            && [stored.coupling.len(), stored.centrifugal.len(), stored.modes.len()] == [count; 3]
            && stored.modes.iter().all(|mode| mode.field < fields);
        if !sound {
            return None;
        }
        let surfaces = stored.surfaces.into_iter().zip(profiles).map(|(stored, profile)| stored.on(profile));
        let fields = SectorFields {
            teeth: stored.teeth,
            modes: stored.modes,
            surfaces: surfaces.collect::<Option<_>>()?,
            directions: stored.directions,
            displacements: matrices(&stored.displacements, fields)?,
            stresses: matrices(&stored.stresses, fields)?,
            harmonics: stored.harmonics,
        };
        Some(Self {
            frequencies: stored.frequencies,
            coupling: stored.coupling,
            rigid_mass: stored.rigid_mass,
            gyroscopic: stored.gyroscopic.matrix().filter(|matrix| matrix.nrows() == count)?,
            centrifugal: stored.centrifugal,
            fields: Arc::new(fields),
            modified_surfaces: None,
        })
    }
}
