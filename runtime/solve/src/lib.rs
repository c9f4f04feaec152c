//! Solution of the positions of a planned mechanism: equilibrium, time steps, and vibrations about
//! an equilibrium.

#![warn(missing_docs)]

pub mod derived;
pub mod forced_response;
pub mod gyroscopic;
pub mod integration;
pub mod modal;
mod moving_axes;
pub(crate) mod raceways;
pub mod restraint_check;
pub mod step;
pub mod system;
pub mod vibration;
pub mod vibrations;
