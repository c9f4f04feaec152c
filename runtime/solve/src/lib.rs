//! Positions of a planned mechanism: equilibrium, a step in time, vibrations about it.

#![warn(missing_docs)]

pub mod integration;
pub mod modal;
pub mod restraint_check;
pub mod step;
pub mod system;
pub mod vibration;
pub mod vibrations;
