//! Finite elements. This module is two-dimensional: meshes of quadrilaterals up to cubic order,
//! stiffness, loads, solution, stress. [`revolution`] contains bodies of revolution, meshed in
//! their section, and [`solid`] three-dimensional elements.
//!
//! See `docs/theory/finite-elements.md`.

#![warn(missing_docs)]

mod axial_section;
pub mod block;
pub mod builder;
pub mod dissection;
pub mod elimination;
pub mod inertia;
pub mod interpolation;
mod load;
pub mod material;
pub mod memoized;
pub mod mesh;
pub mod model;
pub mod revolution;
pub mod solid;
pub mod solve;
pub mod sparse;
pub mod stress;
mod strips;

pub use axial_section::{AxialCut, AxialSection, station_name};
pub use block::{Block, Curve, Side, graded, uniform};
pub use builder::{MeshBuilder, MeshError};
pub use calyx_numerics::quadrature;
pub use interpolation::ElementOrder;
pub use mesh::{ArcLength, EdgeChain, EdgePoint, Element, ElementEdge, ElementPoint, PlaneMesh};
pub use model::{PlaneModel, principal_stresses};
pub use revolution::{RevolutionModel, Section, Station};
pub use solve::{Constraints, SolveError, Solver};
pub use sparse::SparseVector;
pub use stress::StressRecovery;

/// Fingerprint of this crate's source: stored structures depend on it.
pub const SOURCE: &str = env!("CALYX_SOURCE");
