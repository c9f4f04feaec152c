//! Tests of elastic bodies of any shape, one module per subject.

mod attachments;
mod beams;
mod condensation;
mod constraints;
mod meshes;
mod modes;
mod resources;
mod solids;
//! Tests of elastic bodies of any shape.

mod import;
mod shell;
