//! Plane contact of elastic bodies: closest approach, contact grids, and the contact problem.
//!
//! An analysis step uses these modules in order: [`approach`] finds the closest approach of two
//! profiles, [`grid`] creates contact cells there, [`assembly`] computes their compliance matrix,
//! [`problem`] states the linear complementarity problem and [`active_set`] solves it.
//! `unloaded_equilibrium` and `rigid_limit` compute the positions of bodies as the load vanishes,
//! [`friction`] adds sliding friction, [`pressure`] evaluates peak pressure and half-width,
//! [`load_boundary`] locates the end of the load between cells for stiffnesses, and [`zone`]
//! separates flanks from edges. [`solid`] contains the three-dimensional counterparts.
//!
//! See `docs/theory/contact.md`.

#![warn(missing_docs)]

pub mod active_set;
pub mod approach;
pub mod assembly;
mod dense;
mod feasibility;
pub mod friction;
pub mod grid;
pub mod interior_point;
pub mod load_boundary;
mod placement;
pub mod pressure;
pub mod problem;
pub mod rigid_limit;
mod scaled;
pub mod solid;
pub mod unloaded_equilibrium;
pub mod zone;

pub use calyx_structure::half_plane;
pub use grid::Cell;
pub use placement::ContactFrame;
pub use placement::Placement;

#[cfg(test)]
mod geometry_tests;
#[cfg(test)]
mod hertz_tests;
#[cfg(test)]
mod solver_tests;
#[cfg(test)]
mod test_profiles;
