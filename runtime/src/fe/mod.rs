//! Finite elements. Here those in the plane: meshes of quadrilaterals of any order up to cubic, stiffness, loads, solution, stress;
//! in [`revolution`] bodies that are the same all around, by their section; in [`solid`] those in space.

pub mod block;
pub mod builder;
pub mod dissection;
pub mod elimination;
pub mod interpolation;
mod load;
pub mod mesh;
pub mod model;
pub mod quadrature;
pub mod revolution;
pub mod solid;
pub mod solve;
pub mod sparse;
pub mod stress;

pub use block::{Block, Curve, Side, graded, uniform};
pub use builder::{MeshBuilder, MeshError};
pub use interpolation::ElementOrder;
pub use mesh::{ArcLength, EdgeChain, EdgePoint, Element, ElementEdge, Place, PlaneMesh};
pub use model::{PlaneModel, principal_stresses};
pub use revolution::{RevolutionModel, Section, Station};
pub use solve::{Constraints, SolveError, Solver};
pub use sparse::SparseVector;
pub use stress::StressRecovery;
