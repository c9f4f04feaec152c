//! Structures against exact solutions, whole meshes and brute force.

pub mod annulus;
pub mod bodies;
pub mod bore;
#[cfg(test)]
mod deformed;
#[cfg(test)]
mod disc;
#[cfg(test)]
mod far_stress;
#[cfg(test)]
mod raceway;
#[cfg(test)]
mod revolved_web;
#[cfg(test)]
mod ring;
#[cfg(test)]
mod solid_ring;
pub mod spline_clearance;
mod spline_teeth;
#[cfg(test)]
mod split;
#[cfg(test)]
mod webs;
