//! Tests of rolling bearings, one module per subject.

mod balls;
mod equilibrium;
mod hertz;
mod inputs;
mod reference;
mod rollers;
mod sample;
