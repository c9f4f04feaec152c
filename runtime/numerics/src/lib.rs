//! Numerical foundations of the engine: dense matrices, three-dimensional vectors, quadrature, and
//! the errors and interrupts of all crates above.

#![warn(missing_docs)]

pub mod dense;
pub mod error;
pub mod interrupt;
pub mod quadrature;
pub mod vec3;

/// Fingerprint of this crate's source.
pub const SOURCE: &str = env!("CALYX_SOURCE");
