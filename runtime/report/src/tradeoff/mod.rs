//! Measured trade-off of speed and accuracy: one model analysed at many settings, each in its own
//! run directory, and compared with a reference.
//!
//! The caller selects the settings ([`settings()`]) and runs them. This module reads their
//! directories ([`measurement`]), computes the errors relative to the reference
//! ([`comparison`]), and presents them as a table, [`files`] and a [`plot`].

pub mod comparison;
pub mod files;
pub mod measurement;
pub mod plot;
mod settings;
pub mod text;

pub use comparison::{Comparison, Errors, OutputErrors};
pub use measurement::Measurement;
pub use settings::{Setting, current_setting_name, references, settings};
