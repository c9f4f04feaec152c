//! Structures against exact solutions, whole meshes and brute force.

mod bodies;
mod disc;
mod ring;
mod split;
