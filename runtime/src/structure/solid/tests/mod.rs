//! Three-dimensional bodies against plane models, direct solutions, and general properties.

mod answers;
pub(crate) mod bodies;
mod halves;
mod plane;
mod split;
