//! Runs a compiled model: takes its params, runs its program, shows progress and writes the run directory.
//!
//! The same code serves `calyx run`, which compiles in memory, and executables linked from object files.

pub mod budget;
pub mod directory;
pub mod given;
pub mod interrupt;
pub mod linked;
pub mod params;
pub mod program;
pub mod progress;
pub mod report;
pub mod run;
pub mod table;

pub use given::{Given, GivenValue};
pub use params::{ParamError, Refused, apply};
pub use program::Program;
pub use run::{RunError, RunOptions, RunReport, run};
