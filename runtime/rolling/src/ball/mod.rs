//! Ball bearings: deep groove, angular contact and four-point contact.

mod contact;
mod equilibrium;
mod geometry;
mod motion;

pub use equilibrium::{BallContact, BallState};
pub use geometry::{BallGeometry, BallKind, BallRow};
pub(crate) use geometry::{STATIC_PRESSURE, check_circle};
pub use motion::{CageSpeed, Motion};
