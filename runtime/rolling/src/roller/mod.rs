//! Roller bearings: cylindrical, needle, tapered and spherical.

mod body;
mod contact_model;
mod elastic;
mod equilibrium;
mod geometry;
mod integral;
mod near;
mod profile;
mod row;
mod shape;
mod state;
mod strip_solver;
pub mod strips;

pub use contact_model::{ContactModel, ElasticContact};

pub use geometry::{Rib, RollerGeometry, RollerKind};
pub use profile::Profile;
pub use row::RollerRow;
pub(crate) use row::STATIC_PRESSURE;
pub(crate) use state::RollerStart;
pub use state::{LineContact, RollerState};
