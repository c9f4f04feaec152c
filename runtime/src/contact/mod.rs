//! Contact: where surfaces approach, which cells could carry pressure, and the pressures that hold the bodies.
//!
//! A step of an analysis goes through these modules in order: [`approach`] finds where two profiles come closest,
//! [`grid`] lays cells there, [`assembly`] builds their compliance, [`problem`] states the contact problem and
//! [`active_set`] solves it; `rest` and `rigid_limit` say where bodies are as the load vanishes; [`friction`] adds what slides; [`pressure`] reads peak pressure
//! and half-width off the solution, and [`zone`] separates flanks from edges. [`solid`] is the same in space.

pub mod active_set;
pub(crate) mod approach;
pub(crate) mod assembly;
pub mod clarabel_check;
mod dense;
mod feasibility;
pub mod friction;
pub(crate) mod grid;
pub mod half_plane;
mod placement;
pub mod pressure;
pub mod problem;
pub(crate) mod rest;
pub(crate) mod rigid_limit;
pub mod solid;
pub mod zone;

pub use grid::Cell;
pub use placement::ContactFrame;
pub(crate) use placement::Placement;

#[cfg(test)]
mod geometry_tests;
#[cfg(test)]
mod hertz_tests;
#[cfg(test)]
mod solver_tests;
#[cfg(test)]
mod test_profiles;
