//! Bodies in space against the plane, direct solutions, and themselves.

mod answers;
mod bodies;
mod plane;
mod split;
