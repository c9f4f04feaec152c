//! The Calyx compiler as a library: compiles models, sets their params, runs them and returns their
//! outputs.
//!
//! ```
//! use calyx::{Engine, Module};
//!
//! let engine = Engine::default();
//! let module = Module::from_file(&engine, "../examples/spur_pair.cx")?;
//! let error = module.output("transmission_error")?;
//!
//! let mut pair = module.instantiate();
//! pair.set("torque", 500.0)?; // in the unit of its default
//! pair.set("center_distance", (76.25, "mm"))?;
//! pair.set("steps", 2)?;
//! pair.set("fidelity", "plane")?; // two-dimensional, solved in a moment; 3-D models take longer
//! let mut run = pair.run()?;
//! for step in &mut run {
//!     let step = step?;
//!     println!("{:.4} s: {:.3} urad", step.position().time, step.in_unit(error, "urad")?);
//! }
//! let results = run.finish()?;
//! assert!(results.summary_in(error, "urad")?.peak_to_peak > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Types, costs and threads
//!
//! | type | meaning | cost | threads |
//! |---|---|---|---|
//! | [`Engine`] | thread pool, and gear structures stored for later analyses | one per program; its threads start with the first analysis | any; a clone is the same engine |
//! | [`Module`] | compiled model, immutable | time of checking and compiling | any; a clone is the same module |
//! | [`Instance`] | module with its own params, limits and callbacks | negligible: no code is copied, nothing is computed | one at a time; each run uses the values set before it starts |
//! | [`Run`] | run in progress, an iterator over its positions | one thread for the program, which waits until a position is requested | one at a time; its [`Cancel`] from any |
//! | [`Step`], [`Results`] | solution | views that share their numbers | any |
//!
//! There is no global state: engines are independent, and all memory is freed when the last value
//! derived from an engine is dropped. Invalid input never panics. Errors of a model are
//! [`Diagnostics`] ([`CompileError`]); errors of a run are an [`Error`] of an [`ErrorKind`].
//! [`Module::render`] shows an error with the source lines concerned.
//!
//! # Concurrent instances
//!
//! The first analysis of a gear builds its structure, which takes far longer than a position.
//! Instances of one engine share structures of equal geometry and material; in this example, only
//! the torques differ:
//!
//! ```
//! # use calyx::{Engine, Error, Module};
//! # let module = Module::from_file(&Engine::default(), "../examples/spur_pair.cx")?;
//! let peak_to_peak = |torque: f64| -> Result<f64, Error> {
//!     let mut pair = module.instantiate();
//!     pair.set("torque", torque)?;
//!     pair.set("steps", 2)?;
//!     pair.set("fidelity", "plane")?;
//!     Ok(pair.solve()?.summary_in("transmission_error", "urad")?.peak_to_peak)
//! };
//! let errors: Vec<f64> = std::thread::scope(|scope| {
//!     let solve = |torque| scope.spawn(move || peak_to_peak(torque));
//!     let started: Vec<_> = [250.0, 500.0, 1000.0].map(solve).into();
//!     started.into_iter().map(|thread| thread.join().expect("no panic")).collect::<Result<_, _>>()
//! })?;
//! assert_eq!(errors.len(), 3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # More
//!
//! - The embedding program provides functions, loads and flank deviations to a model by name:
//!   [`Host`], [`Instance::set_host`].
//! - Modules are serialized and loaded without compiling: [`Module::serialize`],
//!   [`Module::deserialize`].
//! - Symbolic functions of a model are evaluated separately, one point or many at a time:
//!   [`Module::kernel`].
//! - Runs are cancelled from outside ([`Instance::cancel_handle`]) or by limits
//!   ([`Instance::limit_time`], [`Instance::limit_memory`]), and report their progress
//!   ([`Instance::on_progress`]).
//!
//! The default feature `cli` contains the `calyx` command and its dependencies; programs that embed
//! models use this crate with `default-features = false`.

mod artifact;
#[cfg(feature = "cli")]
pub mod build;
mod compiled;
#[cfg(feature = "cli")]
pub mod doc;
#[cfg(feature = "cli")]
pub mod dump;
mod error;
#[cfg(feature = "cli")]
pub mod explain;
#[cfg(feature = "cli")]
pub mod fix;
mod kernel;
mod module;
pub mod replace;
#[cfg(feature = "cli")]
pub mod session;
#[cfg(feature = "studio")]
pub mod studio;
#[cfg(feature = "cli")]
pub mod testing;
mod typed;

pub use artifact::{ArtifactError, is_artifact};
pub use calyx_codegen::TargetCpu;
pub use calyx_elaborate as elaborate;
pub use calyx_elaborate::{
    Checked, Interpreted, InvalidParam, ModelLoader, allowed_path, check_file, check_file_allowing,
    check_run, check_run_within, check_text, render,
};
pub use calyx_lang::diagnostic::{Diagnostic, Severity};
pub use calyx_rt as rt;
pub use calyx_rt::{
    AssignedValue, Cancel, Engine, EngineConfig, Error, ErrorKind, Host, Instance, ModelDescription, Output,
    Override, Param, ParamAssignment, ParamValue, Progress, Results, Run, Step,
};
#[expect(deprecated, reason = "former names work for one version")]
pub use calyx_rt::{Given, GivenValue};
pub use error::{CompileError, Diagnostics};
pub use kernel::{Kernel, KernelError, Quantity};
pub use module::Module;

/// Rust programs on this page of the book, which run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../docs/howto/embedding.md")]
pub struct EmbeddingPage;
