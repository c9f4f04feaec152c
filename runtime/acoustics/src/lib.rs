//! Sound that vibrating surfaces radiate into a fluid.
//!
//! A [`RadiationModel`] is a closed [`SurfaceMesh`] in a [`Fluid`], in free space or in front of a
//! [`RigidPlane`]. Its [`Equations`] at a frequency give the surface pressure for normal
//! velocities, the radiated power, pressures at points, and acoustic transfer vectors. The modules
//! [`rayleigh`] and [`radiation`] have estimates that need no equations. [`surface_sound`] computes
//! the sound of vibrations that other programs write. The theory manual derives the method on its
//! page about radiated sound.

#![warn(missing_docs)]

pub mod coarse_surface;
pub mod coarsening;
pub mod error;
pub mod field;
pub mod fluid;
pub mod levels;
pub mod mesh;
pub mod method;
pub mod model;
pub mod nastran_results;
pub mod openings;
pub mod patterns;
pub mod plane;
pub mod projection;
pub mod radiation;
pub mod rayleigh;
pub mod shares;
pub mod shells;
pub mod skin;
pub mod surface_sound;
pub mod sweep;
pub mod transfer;
pub mod unv;

mod check;
mod cluster;
mod compressed;
mod dense;
mod gmres;
mod hierarchical;
mod nearest;
mod operators;
mod pair;
mod panel;
mod point;
mod quadrature;

pub use error::AcousticError;
pub use fluid::Fluid;
pub use mesh::{Face, SurfaceMesh};
pub use method::SoundMethod;
pub use model::{Equations, Method, RadiationModel, Settings};
pub use patterns::SolvedPatterns;
pub use plane::RigidPlane;
pub use radiation::{Radiation, equivalent_radiated_power};
pub use transfer::{RadiationImpedance, TransferVectors};

/// Fingerprint of this crate's source.
pub const SOURCE: &str = env!("CALYX_SOURCE");
