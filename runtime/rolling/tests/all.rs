//! Tests of rolling bearings, one module per subject.

mod balls;
mod cylinder;
mod elastic_rollers;
mod equilibrium;
mod finite_races;
mod half_space;
mod half_space_reference;
mod hertz;
mod inputs;
mod raceways;
mod ratings;
mod reference;
mod roller_body;
mod rollers;
mod sample;
mod strips;
