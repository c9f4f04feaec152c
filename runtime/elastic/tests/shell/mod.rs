//! Tests of shell elements.

mod benchmarks;
mod convergence;

mod elements;
mod frequencies;

mod patch;
mod plates;
mod support;
