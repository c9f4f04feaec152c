//! Rolling bearings with rigid rings, at the fidelity `analytic`: Hertz contacts of balls and
//! laminae of rollers.
//!
//! A [`RollingBearing`] is a set of rows of balls or rollers. [`RollingBearing::evaluate`] computes
//! the load on the inner ring and the stiffness at a displacement, [`RollingBearing::equilibrium`]
//! the displacement under a load. All quantities are in SI units. The theory manual has the
//! equations on its page about rolling bearings.

#![warn(missing_docs)]

pub mod ball;
pub mod bearing;
pub mod catalogue;
pub mod equilibrium;
pub mod error;
pub mod hertz;
pub mod material;
pub mod rating;
pub mod roller;

mod element;
mod linear;

pub use ball::{BallGeometry, BallKind, BallRow, CageSpeed, Motion};
pub use bearing::{Arrangement, Displacement, Elements, Evaluation, Load, RollingBearing, Row, Start};
pub use equilibrium::{Conditions, Equilibrium};
pub use error::RollingError;
pub use material::Material;
pub use roller::{Profile, Rib, RollerGeometry, RollerKind, RollerRow};

/// Fingerprint of this crate's source.
pub const SOURCE: &str = env!("CALYX_SOURCE");
