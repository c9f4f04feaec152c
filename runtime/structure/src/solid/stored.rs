//! Serialization of three-dimensional bodies for the structure cache: see
//! [`crate::stored`].

use super::Mirror;
use super::axial_modes::AxialModes;
use super::elastic::{ElasticSolid, SurfaceTables};
use super::surface_metric::SurfaceMetric;
use crate::sampling::EdgeCoordinate;
use crate::stored::{StoredBore, StoredFar, StoredOffset, from_bytes, spline, to_bytes};
use crate::surface::Surface;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Serialized [`ElasticSolid`] without its contact surfaces.
#[derive(Serialize, Deserialize)]
struct StoredSolid<'a> {
    teeth: u32,
    surface_modulus: f64,
    kink: f64,
    /// Point and normal of each mirror plane.
    mirrors: [[[f64; 3]; 2]; 2],
    modes: AxialModes,
    surfaces: Vec<StoredSurface>,
    #[serde(borrow)]
    offsets: Vec<StoredOffset<'a>>,
    #[serde(borrow)]
    far: Option<StoredFar<'a>>,
    #[serde(borrow)]
    bore: Option<StoredBore<'a>>,
}

#[derive(Serialize, Deserialize)]
struct StoredSurface {
    nodes: Vec<f64>,
    stretch: EdgeCoordinate,
    stretched: Vec<f64>,
    range: [f64; 2],
    turned: Vec<f64>,
    stress_points: Vec<([f64; 2], [f64; 3])>,
    metric: Option<SurfaceMetric>,
}

impl ElasticSolid {
    pub(super) fn to_bytes(&self) -> Option<Vec<u8>> {
        let surface = |known: &SurfaceTables| StoredSurface {
            nodes: known.spline.nodes().to_vec(),
            stretch: known.stretch.clone(),
            stretched: known.stretched.nodes().to_vec(),
            range: known.range,
            turned: known.turned.clone(),
            stress_points: known.stress_points.clone(),
            metric: known.metric.clone(),
        };
        to_bytes(&StoredSolid {
            teeth: self.teeth,
            surface_modulus: self.surface_modulus,
            kink: self.kink,
            mirrors: self.mirrors.map(|mirror| [mirror.point, mirror.normal]),
            modes: self.modes.clone(),
            surfaces: self.surfaces.iter().map(surface).collect(),
            offsets: self.offsets.iter().map(StoredOffset::of).collect(),
            far: self.far.as_ref().map(StoredFar::of),
            bore: self.bore.as_ref().map(StoredBore::of),
        })
    }

    /// Restores a structure from the bytes of [`stored`](super::SolidStructure::stored), with the
    /// surfaces that it was built with. `None` if the bytes contain something else.
    pub fn restored(bytes: &[u8], surfaces: Vec<Arc<dyn Surface>>) -> Option<Self> {
        let stored: StoredSolid = from_bytes(bytes)?;
        let modes = stored.modes;
        let known = |(stored, surface): (StoredSurface, Arc<dyn Surface>)| {
            if stored.metric.as_ref().is_some_and(|metric| !metric.is_sound(&modes)) {
                return None;
            }
            Some(SurfaceTables {
                surface,
                spline: spline(stored.nodes)?,
                stretch: stored.stretch,
                stretched: spline(stored.stretched)?,
                range: stored.range,
                turned: stored.turned,
                stress_points: stored.stress_points,
                metric: stored.metric,
            })
        };
        if stored.surfaces.len() != surfaces.len() {
            return None;
        }
        // A stored bore coupling must be valid.
        let bore = match stored.bore {
            Some(bore) => Some(bore.coupling()?),
            None => None,
        };
        let far = match &stored.far {
            Some(far) => Some(far.coupling()?),
            None => None,
        };
        Some(Self {
            teeth: stored.teeth,
            surface_modulus: stored.surface_modulus,
            kink: stored.kink,
            mirrors: stored.mirrors.map(|[point, normal]| Mirror { point, normal }),
            surfaces: stored.surfaces.into_iter().zip(surfaces).map(known).collect::<Option<_>>()?,
            offsets: StoredOffset::all_tables(&stored.offsets)?,
            modes,
            far,
            bore,
        })
    }
}
