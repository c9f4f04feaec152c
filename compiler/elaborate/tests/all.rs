//! Tests of elaboration, one module per subject. They are one program: it is linked once, and its
//! tests run in parallel.

mod bevel_settings;
mod bindings;
mod elaboration;
mod geometry;
mod library;
mod library_calls;
mod loader;
mod plan;
mod random_params;
mod ranges;
mod results;
mod shown;
