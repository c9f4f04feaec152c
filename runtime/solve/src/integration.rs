//! Time integration: inertia, damping and component modes of the bodies, with contact in every time
//! step.
//!
//! The unknowns are the DOFs of static analysis and, if modes are requested, the modal coordinates
//! of gears (in plane models) and of elastic connections (in three dimensions). Contact includes
//! the residual flexibility of the omitted modes, so contact points have no mass of their own and
//! dynamic contact is well posed. A step of Newmark's family in acceleration form ([`newmark`]) is
//! the static contact problem with the step's effective matrix in place of the springs. Its contact
//! grid is created at the predicted positions of the bodies. No step requires a finite element
//! mesh. See `docs/theory/dynamics.md`.
//!
//! | Module | Contents |
//! |---|---|
//! | `newmark` | integration schemes, independent of the model |
//! | `time_ranges` | time ranges, their steps and load factors |
//! | `requirements` | what time integration requires of a model |
//! | `body_inertia` | inertia forces of a rigid body about its prescribed motion |
//! | `matrices` | mass, damping, inertia loads of all coordinates |
//! | `effective_matrix` | effective matrix of a step, and unsymmetric terms |

mod body_inertia;
mod effective_matrix;
mod matrices;
mod newmark;
mod requirements;
mod time_ranges;

pub use effective_matrix::EffectiveMatrix;
pub use matrices::{Forces, Matrices, coupling};
pub use newmark::{Scheme, State};
pub use requirements::{check_axis, check_elastic, check_inertia};
pub use time_ranges::{Step, check_resolved, doubled_steps, steps};
pub use time_ranges::{TimeRange, kept_positions};
