//! Elastic bodies of any shape as finite elements: shafts, carriers, housings and shells, generated
//! or imported.
//!
//! An [`ElasticModel`] has nodes with six degrees of freedom (three translations, three rotations),
//! elements of several kinds, and constraints between nodes.

#![warn(missing_docs)]

pub mod assembly;
pub mod attachment;
pub mod beam;
pub mod carrier;
pub mod check;
pub mod condensation;
pub mod connectivity;
pub mod constraint;
pub mod element;
pub mod error;
pub mod factor;
pub mod import;
pub mod model;
pub mod modes;
pub mod resources;
pub mod shell;
pub mod solid;
pub mod statics;
pub mod stress;
pub mod surface;

pub use error::{ElasticError, ElementError};
pub use model::{
    Component, Constraint, ElasticModel, Element, ElementKind, FixedComponents, Material, NodalLoad, Node,
};
pub use resources::Resources;

/// Fingerprint of this crate's source: stored bodies depend on it.
pub const SOURCE: &str = env!("CALYX_SOURCE");
