//! Studies: samples of toleranced params with their statistics, and objectives.
//!
//! See `docs/theory/tolerance-studies.md`.

mod files;
mod group;
mod sensitivity;
mod statistics;
#[cfg(test)]
mod tests;
mod text;

pub use files::{EXPLAINED_VARIATION, SAMPLE_STATISTICS, write_explained_variation, write_statistics};
pub use group::{Group, Variation, groups};
pub use sensitivity::{Sensitivities, Sensitivity};
pub use statistics::{Estimate, PERCENTILES};
pub use text::text;

pub use crate::sample::{Method, Objective, Sample, Statistic};
