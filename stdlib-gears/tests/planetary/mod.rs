//! Planetary systems in the plane: sun, planets and ring in one contact problem, seen from the ground, from the carrier and from anywhere.

mod ladder;
mod loads;
mod modes;
mod motion;
mod phases;
mod set;
mod splined;
