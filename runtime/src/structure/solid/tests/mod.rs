//! Bodies in space against the plane, direct solutions, and themselves.

mod answers;
pub(crate) mod bodies;
mod halves;
mod plane;
mod split;
