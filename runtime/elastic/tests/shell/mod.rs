//! Tests of shell elements.

mod benchmarks;
mod convergence;
mod director;

mod elements;
mod frequencies;
mod hemisphere;
mod joints;

mod patch;
mod plates;
mod support;
