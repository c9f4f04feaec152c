//! Transient analysis: contact in every time step.
//!
//! [`calyx_solve::integration`] contains the equations of a step; `history` is the analysis:
//! initial equilibrium, steps, rows.
//!
//! See `docs/theory/dynamics.md`.

mod history;

pub use crate::dynamic_options::{DynamicOptions, Start};
pub use calyx_solve::integration::{Scheme, State, TimeRange, kept_positions};
pub use history::{History, dynamic};
