//! Readers of finite-element models that other programs wrote.
//!
//! | Format | Function |
//! |---|---|
//! | NASTRAN bulk data | [`read_nastran`]; [`read_nastran_mesh`] for its mesh only |
//! | Abaqus and CalculiX input files | [`read_abaqus`] |
//! | Gmsh meshes, version 4.1 | [`read_gmsh`] |
//! | condensed matrices: DMIG, CSV, NPZ | [`read_condensed`] |
//!
//! A reader opens files only through the closure that the caller passes, so the caller decides
//! which files may be read. All quantities are converted to SI. A reader rejects everything that
//! changes the body and that it does not support; it lists in its [`ImportReport`] the input that
//! it skipped because it does not change the body.

mod abaqus;
mod builder;
mod condensed;
mod constraints;
mod error;
mod geometry;
mod gmsh;
mod mass;
mod mesh;
mod nastran;
mod origin;
mod section;
mod source;
mod units;

pub use abaqus::{AbaqusOptions, read_abaqus};
pub use condensed::{CondensedMatrices, CondensedNode, CondensedOptions, read_condensed};
pub use error::{ImportError, Unreadable};
pub use gmsh::{GmshOptions, GmshPart, read_gmsh};
pub use mass::{MassProperties, element_mass_properties, mass_properties};
pub use mesh::{NastranMesh, NastranMeshElement, NastranMeshShape};
pub use nastran::{NastranOptions, read_nastran, read_nastran_mesh};
pub use source::OpenFile;
pub use units::Units;

use crate::model::ElasticModel;

/// Imported body.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// Body in SI units.
    pub model: ElasticModel,
    /// Account of the import.
    pub report: ImportReport,
}

/// Account of an import: its size, and the input that was skipped.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ImportReport {
    /// Title of the model; empty if it has none.
    pub title: String,
    /// Names of all files that were read, in the order of reading.
    pub files: Vec<String>,
    /// Cards or keywords that were skipped because they do not change the body.
    pub skipped: Vec<SkippedInput>,
    /// Remarks on interpretation, one sentence each.
    pub notes: Vec<String>,
    /// Mass, centre of mass and inertia of the body.
    pub mass: MassProperties,
}

/// Card or keyword that a reader skipped.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SkippedInput {
    /// Name of the card or keyword.
    pub name: String,
    /// Number of occurrences.
    pub count: usize,
    /// File of the first occurrence.
    pub file: String,
    /// Line of the first occurrence, from 1.
    pub line: usize,
}
