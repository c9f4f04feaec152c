//! Roller bearings: cylindrical, needle, tapered and spherical.

mod equilibrium;
mod geometry;
mod profile;
mod shape;

pub use equilibrium::{LineContact, RollerState};
pub(crate) use geometry::STATIC_PRESSURE;
pub use geometry::{Rib, RollerGeometry, RollerKind, RollerRow};
pub use profile::Profile;
