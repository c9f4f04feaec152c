//! Speed against accuracy, measured: one model analysed at many settings, each in a run directory of its own, compared with a reference.
//!
//! Who compiles models decides which settings run ([`settings()`]) and runs them; here is what their directories say ([`measurement`]), how far each
//! output is off the reference and what is worth its time ([`comparison`]), and how that is told: a table, [`files`] and a [`plot`].

pub mod campaign;
pub mod comparison;
pub mod files;
pub mod measurement;
pub mod plot;
mod settings;
pub mod text;

pub use campaign::{Campaign, Outcome};
pub use comparison::{Comparison, Errors, OutputErrors};
pub use measurement::Measurement;
pub use settings::{Setting, references, settings};
