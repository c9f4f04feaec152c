//! Bodies in space against the plane, direct solutions, and themselves.

mod answers;
mod bodies;
mod halves;
mod plane;
mod split;
