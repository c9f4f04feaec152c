//! Time integration of a plane model: inertia, damping and component modes of the bodies, with
//! contact in every time step.
//!
//! The unknowns are the DOFs of static analysis and, if modes are requested, the modal coordinates
//! of every body. Contact includes the residual flexibility of the omitted modes, so contact points
//! have no mass of their own and dynamic contact is well posed. A step of Newmark's family in
//! acceleration form ([`newmark`]) is the static contact problem with the step's effective matrix
//! in place of the springs. Its contact grid is created at the predicted positions of the bodies.
//! No step requires a finite element mesh. See `docs/theory/dynamics.md`.
//!
//! | Module | Contents |
//! |---|---|
//! | `newmark` | integration schemes, independent of the model |
//! | `time_ranges` | time ranges, their steps and load factors |
//! | `matrices` | mass, damping, inertia loads |
//! | `effective_matrix` | effective matrix of a step, and unsymmetric terms |

mod effective_matrix;
mod matrices;
mod newmark;
mod time_ranges;

pub use effective_matrix::EffectiveMatrix;
pub use matrices::{Forces, Matrices, check_in_section, check_inertia, check_section, coupling};
pub use newmark::{Scheme, State};
pub use time_ranges::{Step, check_resolved, doubled_steps, steps};
pub use time_ranges::{TimeRange, kept_positions};
