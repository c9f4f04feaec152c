//! Simulated mechanism and its plan: bodies with their motions and loads, bearings, surface pairs,
//! and the selection and models of the parts that an analysis needs.

#![warn(missing_docs)]

pub mod bearing;
pub mod body;
pub mod connection;
pub mod connection_building;
pub mod disc;
pub mod dof;
pub mod elastic_body;
pub mod fidelity;
pub mod flanks;
pub mod frames;
pub mod ids;
mod in_order;
mod interior_modes;
pub mod load;
pub mod lubrication;
pub mod mechanism;
pub mod mesh_carrier;
pub mod motion;
pub mod observed;
pub mod pairs;
pub mod plan;
pub mod position;
pub mod prototype;
pub mod resources;
pub mod rigid;
pub mod seats;
pub mod shaft;
pub mod spline_contact;
pub mod structure_building;
pub mod target;
mod unused_settings;
pub mod whirl;

/// Fingerprint of this crate's source: stored structures of its own bodies depend on it.
const SOURCE: &str = env!("CALYX_SOURCE");
