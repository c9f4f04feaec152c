//! Contact: where surfaces approach, which cells could carry pressure, and the pressures that hold the bodies.
//!
//! A step of an analysis goes through these modules in order: [`approach`] finds where two profiles come closest,
//! [`grid`] lays cells there, [`assembly`] builds their compliance, [`problem`] states the contact problem and
//! [`active_set`] solves it; `unloaded_equilibrium` and `rigid_limit` say where bodies are as the load vanishes; [`friction`] adds what slides; [`pressure`] reads peak pressure
//! and half-width off the solution, and [`zone`] separates flanks from edges. [`solid`] is the same in space.

#![warn(missing_docs)]

pub mod active_set;
pub mod approach;
pub mod assembly;
mod dense;
mod feasibility;
pub mod friction;
pub mod grid;
pub mod interior_point;
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
