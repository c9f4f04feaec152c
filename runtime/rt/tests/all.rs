//! Tests of runs of compiled models, one module per subject. They are one program: it is linked
//! once, and its tests run in parallel.
#![cfg(feature = "command")]

mod budget;
mod former_options;
mod interrupt;
mod messages;
mod params_file;
mod progress;
mod resume;
mod run_directory;
mod schema;
mod study;
