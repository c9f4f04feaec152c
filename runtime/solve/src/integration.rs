//! Time integration of a plane model: inertia, damping and modes of the bodies beside contact.
//!
//! The unknowns are the freedoms of statics and, where modes are asked for, the modal coordinates of every body. Contact sees the residual
//! flexibility of what the modes leave out, so its points have no mass of their own and contact is well posed in time. A step of Newmark's family
//! in acceleration form ([`newmark`]) is the contact problem of statics with the step's matrix in place of the springs, laid out where the state
//! predicts bodies to be; nothing of a mesh is touched by it.
//!
//! | Module | What |
//! |---|---|
//! | `newmark` | the integrators, on numbers alone |
//! | `time_ranges` | over which times, in which steps, under which part of the loads |
//! | `matrices` | mass, damping, loads by inertia |
//! | `effective_matrix` | the matrix of a step, and terms that would make it unsymmetric |

mod effective_matrix;
mod matrices;
mod newmark;
mod time_ranges;

pub use effective_matrix::EffectiveMatrix;
pub use matrices::{Forces, Matrices, check_in_section, check_inertia, check_section, coupling};
pub use newmark::{Scheme, State};
pub use time_ranges::{Step, check_resolved, doubled_steps, steps};
pub use time_ranges::{TimeRange, kept_positions};
