//! Speed against accuracy, measured: one model analysed at many settings, each in a run directory of its own, compared with a reference.
//!
//! Who compiles models decides which settings run ([`settings()`]) and runs them; here is what their directories say ([`measured`]), how far each
//! output is off the reference and what is worth its time ([`compared`]), and how that is told: a table, [`files`] and a [`picture`].

pub mod campaign;
pub mod compared;
pub mod files;
pub mod measured;
pub mod picture;
mod settings;
pub mod text;

pub use campaign::{Campaign, Outcome};
pub use compared::{Comparison, Errors, OutputErrors};
pub use measured::Measured;
pub use settings::{Setting, references, settings};
