//! Rolling bearings, at the fidelity `analytic`: Hertz contacts of balls and
//! laminae of rollers.
//!
//! A [`RollingBearing`] is a set of rows of balls or rollers. [`RollingBearing::evaluate`] computes
//! the load on the inner ring and the stiffness at a displacement, [`RollingBearing::equilibrium`]
//! the displacement under a load. All quantities are in SI units. The theory manual has the
//! equations on its page about rolling bearings.
//!
//! # Example: a pair of tapered roller bearings
//!
//! ```
//! use calyx_rolling::rating::{LifeConditions, rating_life, static_safety};
//! use calyx_rolling::{
//!     Arrangement, Material, Motion, Profile, Rib, RollerGeometry, RollerKind, RollerRow,
//!     RollingBearing,
//! };
//!
//! let row = RollerRow::new(RollerGeometry {
//!     kind: RollerKind::Tapered {
//!         outer_angle: 14f64.to_radians(),
//!         rib: Rib { end_radius: 0.12, height: 3.2e-3 },
//!     },
//!     count: 17,
//!     roller_diameter: 10e-3,
//!     length: 13e-3,
//!     raceway_widths: [None; 2],
//!     pitch_diameter: 60e-3,
//!     profile: Profile::Logarithmic,
//!     laminae: 41,
//!     rings: Material::STEEL,
//!     rollers: Material::STEEL,
//! })?;
//! // 80 mm apart, with an axial preload of 5 µm at each row.
//! let pair = RollingBearing::pair(row, Arrangement::BackToBack, 80e-3, 5e-6)?;
//!
//! // Radial force, axial force, and a moment about y, on the inner rings.
//! let motion = Motion { inner_speed: 150.0, ..Motion::REST };
//! let solution = pair.displacement(&[6e3, 0.0, 2e3, 0.0, 40.0], &motion)?;
//! assert!(solution.displacement[0] > 0.0 && solution.evaluation.stiffness[0][0] > 1e8);
//!
//! let elements = pair.elements(&solution.displacement, &motion)?;
//! let largest = elements.iter().map(|element| element.load()).fold(0.0, f64::max);
//! assert!(largest > 6e3 / 17.0);
//! let life = rating_life(&pair, &elements, &LifeConditions::default())?;
//! assert!(life.basic > 1e6 && static_safety(&elements) > 1.0);
//! # Ok::<(), calyx_rolling::RollingError>(())
//! ```

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
mod raceway;

pub use ball::{BallGeometry, BallKind, BallRow, CageSpeed, Motion};
pub use bearing::{
    Arrangement, Displacement, ElementState, Elements, Evaluation, Load, RollingBearing, Row, Start,
};
pub use equilibrium::{Conditions, Equilibrium};
pub use error::RollingError;
pub use material::Material;
pub use raceway::{RacewayContact, RacewayDisplacement, RacewayLoad, Ring};
pub use roller::{ContactModel, ElasticContact, Profile, Rib, RollerGeometry, RollerKind, RollerRow};

/// Fingerprint of this crate's source.
pub const SOURCE: &str = env!("CALYX_SOURCE");
