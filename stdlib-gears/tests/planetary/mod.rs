//! Plane planetary systems: sun, planets and ring in one contact problem. Results are the same seen
//! from ground, carrier, ring and sun. Equal planets share the load equally, errors of single
//! planets follow linear theory, mesh phases decide which harmonics rotate or shift the sun, and
//! modes agree with rigid bodies on springs.

mod ladder;
mod loads;
mod modes;
mod motion;
mod phases;
mod set;
mod splined;
