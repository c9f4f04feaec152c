//! Planetary gear sets in two dimensions: sun, planets and ring in one contact problem.
//!
//! Results are the same in the frames of ground, carrier, ring and sun. Equal planets share the
//! load equally, and errors of single planets follow linear theory. Mesh phases determine which
//! harmonics rotate or shift the sun, and modes agree with the lumped-parameter model.

mod ladder;
mod loads;
mod modes;
mod motion;
mod phases;
pub mod set;
mod splined;
