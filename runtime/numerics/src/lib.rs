//! Numerical foundations of the engine: dense matrices, vectors in two and three dimensions,
//! interpolation, quadrature, Fourier transform, and the errors, interrupts and parallel parts of
//! all other crates.

#![warn(missing_docs)]

pub mod complex;
pub mod dense;
pub mod error;
pub mod fourier;
pub mod interpolation;
pub mod interrupt;
pub mod parallel;
pub mod quadrature;
pub mod stress;
pub mod vec2;
pub mod vec3;

/// Fingerprint of this crate's source.
pub const SOURCE: &str = env!("CALYX_SOURCE");
