//! Results of NASTRAN: motions of grid points in OP2 files ([`read_op2`]) and in punch files
//! ([`read_punch`]).
//!
//! [`recognize`] distinguishes these files from others that the solver writes. Frequency responses
//! and real normal modes are read. Random, transient, static and complex modal results are skipped
//! and counted. Rotations are left out, and so are points without three translations, such as
//! scalar points.
//!
//! Quantities stay in the units of the deck. Complex amplitudes have the time factor exp(iωt).

mod blocks;
mod format;
mod op2;
mod punch;
mod vectors;

pub use format::{FileKind, recognize};
pub use op2::read_op2;
pub use punch::read_punch;
pub use vectors::{Analysis, GridVectors, Motion, NastranResults, NastranResultsError, VectorAxes};
