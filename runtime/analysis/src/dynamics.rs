//! Dynamic analysis: motion in time, contact solved in every step.
//!
//! [`calyx_solve::integration`] has the equations of a step; `history` is the analysis: start in equilibrium, steps, rows.

mod history;

pub use crate::dynamic_options::{DynamicOptions, Start};
pub use calyx_solve::integration::{Scheme, State, TimeRange, kept_positions};
pub use history::{History, dynamic};
