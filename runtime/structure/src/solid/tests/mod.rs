//! Three-dimensional bodies against plane models, direct solutions, and general properties.

pub mod bodies;
#[cfg(test)]
mod far_coupling;
#[cfg(test)]
mod influence;
#[cfg(test)]
mod lofted;
#[cfg(test)]
mod mirror_symmetry;
#[cfg(test)]
mod plane;
#[cfg(test)]
mod split;
