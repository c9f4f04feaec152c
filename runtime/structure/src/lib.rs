//! Elastic compliance of bodies relative to the body's frame, at their loadable surfaces.
//!
//! Displacements are elastic only: rigid-body motion belongs to the frame. The models in this
//! crate are plane models, per unit of face width: forces in N/m, compliances in m/(N/m).
//! [`solid`] contains three-dimensional bodies.
//!
//! See `docs/theory/compliance.md` and `docs/theory/substructures.md`.

#![warn(missing_docs)]

pub mod analytic;
mod any;
mod bore;
pub(crate) mod bore_coupling;
pub mod cache;
mod condense;
pub(crate) mod deformed;
pub(crate) mod elastic;
mod error;
pub mod half_plane;
mod interface;
pub(crate) mod kernel;
pub(crate) mod loose_lugs;
pub(crate) mod lugs;
mod modes;
pub mod profile;
pub(crate) mod rigid;
pub(crate) mod ring;
pub(crate) mod sampling;
mod size;
pub mod solid;
pub(crate) mod spline;
mod stored;
pub mod surface;
mod web;

pub use any::AnyStructure;
pub use bore::BoreHold;
pub use deformed::{BodyLoads, DeformedSector, Drawable, MeshedBody, turned_tensor};
pub use elastic::{ElasticStructure, Hold, RingSource, SurfaceSource};
pub use error::StructureError;
pub use interface::{Chart, ReshapedSurface, StressPlace, Structure, SurfaceLoad};
pub use lugs::{LugForce, Lugs};
pub use modes::BodyModes;
pub use rigid::RigidStructure;
pub use sampling::SplitOptions;
pub use size::StructureSize;
pub use web::RevolvedWeb;

use calyx_numerics::dense;

#[cfg(any(test, feature = "fixtures"))]
#[allow(dead_code, missing_docs, unused_imports, reason = "bodies that tests of other crates use too")]
pub mod tests;
