//! Shell elements with transverse shear (Reissner 1945, Mindlin 1951), both as solids that are
//! linear in the thickness coordinate.
//!
//! - [`DirectorShell`]: the element of the report, with displacements and their thickness derivatives
//!   at each node, of order one to three. It joins solids.
//! - [`ShellElement`]: elements of imported meshes, with three translations and three rotations at
//!   each node, without shear and membrane locking.
//!
//! See `docs/theory/shells.md`.

mod assumed;
mod director;
mod element;
mod geometry;
mod interpolation;
mod joint;
mod kinematics;
mod stress;

pub use director::{DirectorNode, DirectorShape, DirectorShell, Integration};
pub use element::{mass, pressure_load, stiffness};
pub use geometry::ShellElement;
pub use joint::coupling;
pub use stress::surface_stresses;
