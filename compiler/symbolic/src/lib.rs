//! Symbolic expressions: a hash-consed graph, derivatives, frames, and the kernels built from them.
//!
//! A [`Graph`] stores scalar expressions, each distinct one once. Building an expression simplifies
//! it by the rules in [`simplify`]. [`Graph::derivative`] differentiates an expression. A [`Frame`]
//! stores a chain of translations and rotations, so that velocities and accelerations follow from
//! rigid-body kinematics instead of differentiating matrices entry by entry. [`Graph::solve`]
//! defines implicit functions. [`Graph::schedule`]
//! turns the requested expressions into a [`Tape`], which can be interpreted here or compiled by
//! another crate.
//!
//! ```
//! use calyx_symbolic::{Frame, Graph};
//!
//! const TIME: u32 = 0;
//! let mut graph = Graph::new();
//! let (time, zero, one) = (graph.symbol(TIME), graph.constant(0.0), graph.constant(1.0));
//! let angle = { let rate = graph.constant(3.0); graph.multiply(rate, time) };
//! // A frame rotated about e3 and then translated by e1: read from right to left, from ground.
//! let turned = Frame::rotate(angle, [zero, zero, one]);
//! let arm = Frame::translate([one, zero, zero]).after(&turned);
//! let velocity = arm.velocity(&mut graph, TIME);
//! let tape = graph.schedule(1, &velocity);
//! let mut outputs = [0.0; 3];
//! tape.eval(&[0.0], &mut Vec::new(), &mut outputs);
//! assert_eq!(outputs, [0.0, 3.0, 0.0]);
//! ```

pub mod batch;
mod derivative;
mod evaluation;
mod frame;
mod graph;
mod implicit;
mod piecewise;
mod schedule;
pub mod simplify;
pub mod tape;
mod trace;
mod vector;

pub use frame::{Factor, Frame, Pose};
pub use graph::{Binary, Graph, Node, NodeId, Unary};
pub use tape::{Instruction, Solve, System, Tape, TapeKernel};
pub use trace::{FailedSearch, FirstNan};
pub use vector::{Matrix3, Vector3};
