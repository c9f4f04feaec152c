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
mod attachment_matrices;
mod bore;
pub(crate) mod bore_coupling;
pub(crate) mod bore_interface;
pub(crate) mod bspline;
pub mod cache;
mod condense;
pub(crate) mod deformed;
pub(crate) mod elastic;
mod error;
mod far_coupling;
pub mod half_plane;
mod interface;
pub(crate) mod kernel;
pub(crate) mod mesh_cells;
mod modes;
pub mod outer_surface;
pub mod profile;
pub mod raceway;
mod revolved_web;
pub(crate) mod rigid;
pub(crate) mod ring;
pub(crate) mod sampling;
pub mod solid;
pub(crate) mod spline_teeth;
mod stored;
mod structure_size;
pub mod surface;

pub use any::AnyStructure;
pub use attachment_matrices::{AttachmentMatrices, ComponentModes, RacewayMatrices};
pub use bore::BoreSupport;
pub use deformed::{BodyLoads, DeformedSector, DisplacedSector, MeshedBody, VisualizationMesh};
pub use elastic::{ElasticStructure, MeshSupport, RingSource, SurfaceSource};
pub use error::StructureError;
pub use interface::{Chart, ModifiedSurface, StressPoint, Structure, SurfaceLoad};
pub use modes::BodyModes;
pub use raceway::Raceway;
pub use revolved_web::RevolvedWeb;
pub use rigid::RigidStructure;
pub use sampling::SplitOptions;
pub use spline_teeth::{SplineTeeth, SplineToothForce};
pub use structure_size::StructureSize;

use calyx_numerics::dense;

#[cfg(any(test, feature = "fixtures"))]
#[allow(dead_code, missing_docs, unused_imports, reason = "bodies that tests of other crates use too")]
pub mod tests;
