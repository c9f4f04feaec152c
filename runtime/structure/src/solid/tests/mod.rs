//! Three-dimensional bodies against plane models, direct solutions, and general properties.

#[cfg(test)]
mod answers;
pub mod bodies;
#[cfg(test)]
mod halves;
#[cfg(test)]
mod plane;
#[cfg(test)]
mod split;
