//! Numerical foundations of the engine: dense matrices, vectors in three dimensions, quadrature,
//! and what every layer above reports and obeys, errors and interrupts.

#![warn(missing_docs)]

pub mod dense;
pub mod error;
pub mod interrupt;
pub mod quadrature;
pub mod vec3;

/// Fingerprint of this crate's source.
pub const SOURCE: &str = env!("CALYX_SOURCE");
