//! Elastic bodies of any shape as finite elements: shafts, carriers, housings and shells, generated
//! or imported.
//!
//! An [`ElasticModel`] has nodes with six degrees of freedom (three translations, three rotations),
//! elements of several kinds, and constraints between nodes.

#![warn(missing_docs)]

pub mod model;

pub use model::{
    Component, Constraint, ElasticModel, Element, ElementKind, FixedComponents, Material, NodalLoad, Node,
};

/// Fingerprint of this crate's source: stored bodies depend on it.
pub const SOURCE: &str = env!("CALYX_SOURCE");
