//! Roller bearings: cylindrical, needle, tapered and spherical.

mod equilibrium;
mod geometry;
mod profile;
mod shape;

pub use equilibrium::{LineContact, RollerState};
pub use geometry::{Rib, RollerGeometry, RollerKind, RollerRow};
pub use profile::Profile;
