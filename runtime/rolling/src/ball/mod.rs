//! Ball bearings: deep groove, angular contact and four-point contact.

mod contact;
mod equilibrium;
mod geometry;
mod motion;

pub use equilibrium::{BallContact, BallState};
pub(crate) use geometry::check_circle;
pub use geometry::{BallGeometry, BallKind, BallRow};
pub use motion::{CageSpeed, Motion};
