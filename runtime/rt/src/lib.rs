//! Runtime of compiled models: sets the params, runs the program, returns the solved positions,
//! reports progress, locks the run directory and resumes interrupted runs. The files in the
//! directory are those of `calyx-report`.
//!
//! The same code serves programs that embed models ([`Instance`]), `calyx run`, which compiles in
//! memory, and executables linked from object files.

// The macros of the standard library panic if a pipe is closed; those of `console` do not.
#![deny(clippy::print_stdout, clippy::print_stderr)]

pub mod adapted;
pub mod budget;
pub mod c_api;
#[cfg(feature = "command")]
pub mod campaign;
#[cfg(feature = "command")]
pub mod command;
pub mod console;
pub mod engine;
pub mod error;
#[cfg(feature = "command")]
pub mod executable;
#[cfg(feature = "command")]
mod flank_tables;
mod former_names;
#[cfg(feature = "command")]
pub mod former_options;
#[cfg(feature = "command")]
mod gear_data;
#[cfg(feature = "command")]
pub mod help;
pub mod host;
pub mod instance;
#[cfg(feature = "command")]
pub mod interrupt;
pub mod linked;
pub mod messages;
mod names;
pub mod nan_log;
#[cfg(feature = "command")]
pub mod optimization;
#[cfg(feature = "command")]
pub mod options;
pub mod param_assignment;
pub mod params;
#[cfg(feature = "command")]
pub mod params_file;
#[cfg(feature = "command")]
mod power_flow;
pub mod program;
#[cfg(feature = "command")]
pub mod progress;
pub mod results;
#[cfg(feature = "command")]
pub mod resume;
#[cfg(feature = "command")]
pub mod run;
#[cfg(feature = "command")]
pub mod run_directory;
#[cfg(feature = "command")]
pub mod schema;
#[cfg(feature = "command")]
pub mod sensitivity_journal;
#[cfg(feature = "command")]
mod sensitivity_table;
#[cfg(feature = "command")]
pub mod settings_override;
pub mod stepping;
#[cfg(feature = "command")]
pub mod sweep;
mod watcher;

pub use calyx_abi::Cancel;
pub use calyx_abi::description::{ModelDescription, ParamValue};
pub use calyx_abi::shell;
#[cfg(feature = "command")]
pub use calyx_report::parquet_table;
#[cfg(feature = "command")]
pub use calyx_report::sensitivity;
#[cfg(feature = "command")]
pub use calyx_report::study;
#[cfg(feature = "command")]
pub use calyx_report::sweep as sweep_table;
#[cfg(feature = "command")]
pub use calyx_report::{component_table, directory, duty_cycle, page, surface_sound, tradeoff, view};
pub use calyx_runtime::settings_override::Override;
pub use engine::{Engine, EngineConfig};
pub use error::{Error, ErrorKind};
#[cfg(feature = "command")]
#[expect(deprecated, reason = "former names work for one version")]
pub use former_names::overriding;
#[expect(deprecated, reason = "former names work for one version")]
pub use former_names::{Given, GivenValue, Refused, Seen, given, seen};
pub use host::Host;
pub use instance::{Instance, Progress};
pub use names::{Output, OutputName, Param, ParamName};
pub use nan_log::NanLog;
pub use param_assignment::{AssignedValue, ParamAssignment};
pub use params::{AcceptedValues, InvalidParam, apply};
pub use program::Program;
pub use results::Results;
#[cfg(feature = "command")]
pub use run::{FinishedRun, RunError, RunOptions, RunReport, run};
pub use stepping::{Run, Step};
