//! Tests of elastic bodies of any shape, one module per subject.

mod attachments;
mod beams;
mod carriers;
mod condensation;
mod constraints;
mod decks;
mod import;
mod meshes;
mod modes;
mod resources;
mod shell;
mod solids;
mod stresses;
mod surface;
