//! Plane finite elements: meshes of quadrilaterals of any order up to cubic, stiffness, loads, solution, stress.

pub mod block;
pub mod builder;
pub mod interpolation;
pub mod mesh;
pub mod quadrature;
pub mod sparse;

pub use block::{Block, Curve, Side, graded, uniform};
pub use builder::{MeshBuilder, MeshError};
pub use interpolation::ElementOrder;
pub use mesh::{ArcLength, EdgeChain, EdgePoint, Element, ElementEdge, Place, PlaneMesh};
pub use sparse::SparseVector;
