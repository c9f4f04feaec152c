//! Analyses from plan to results: observables, positions, statistics and error estimates.

#![warn(missing_docs)]

pub mod analyses;
pub mod analysis;
pub mod component_loads;
mod component_recorder;
pub mod cost;
pub mod deck_mesh;
pub mod dynamic_options;
pub mod dynamics;
pub mod estimate;
pub mod forced_response;
pub mod method;
pub mod observables;
pub mod options;
pub mod radiated_sound;
pub mod results;
pub mod rows;
pub mod scene;
pub mod sensitivity;
pub mod settings_override;
pub mod signal;
pub mod summary;
pub mod tolerance;
pub mod validate;
