//! Tests of rolling bearings, one module per subject.

mod balls;
mod equilibrium;
mod hertz;
mod inputs;
mod ratings;
mod reference;
mod rollers;
mod sample;
