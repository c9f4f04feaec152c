//! Structures against exact solutions, whole meshes and brute force.

pub(crate) mod annulus;
pub(crate) mod bodies;
mod bore;
mod deformed;
mod disc;
mod far_stress;
mod loose_lugs;
mod lugs;
mod revolved_web;
mod ring;
mod solid_ring;
mod split;
mod webs;
