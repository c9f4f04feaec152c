//! The Calyx compiler as a library: compile a model, set its params, run it, read its outputs.
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
//! pair.set("fidelity", "plane")?; // in section, which takes a moment; in three dimensions it takes longer
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
//! # What there is, what it costs, and who may share it
//!
//! | type | what it is | cost | threads |
//! |---|---|---|---|
//! | [`Engine`] | threads, and structures of gears kept for later analyses | one for a program; its threads start with the first analysis | any; a clone is the same engine |
//! | [`Module`] | a compiled model, immutable | as long as checking and compiling takes | any; a clone is the same module |
//! | [`Instance`] | a module with params of its own, limits, and who is told of what | next to nothing: no code is copied, nothing is computed | one at a time; each run takes what is set by then |
//! | [`Run`] | a run under way, an iterator of its positions | one thread for the program, which waits while nobody takes a position | one at a time; its [`Cancel`] from any |
//! | [`Step`], [`Results`] | what was solved | views that share their numbers | any |
//!
//! Nothing of it is global: two engines know nothing of each other, and everything is freed when the last value that came
//! from it is dropped. Nothing panics at wrong input. What is wrong with a model comes as [`Diagnostics`]
//! ([`CompileError`]), what is wrong with a run as an [`Error`] of some [`ErrorKind`]; [`Module::render`] shows it with the
//! lines of the source it is about.
//!
//! # Many instances at once
//!
//! The first analysis of a gear builds its structure, which takes far longer than a position; instances of one engine share
//! it where geometry and material are the same, as here, where torques differ:
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
//!     let started: Vec<_> = [250.0, 500.0, 1000.0].map(|torque| scope.spawn(move || peak_to_peak(torque))).into();
//!     started.into_iter().map(|thread| thread.join().expect("no panic")).collect::<Result<_, _>>()
//! })?;
//! assert_eq!(errors.len(), 3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # More
//!
//! - The program around a model provides functions, loads and flank deviations to it by name: [`Host`], [`Instance::set_host`].
//! - Modules are kept as bytes and loaded without compiling: [`Module::serialize`], [`Module::deserialize`].
//! - Symbolic functions of a model are evaluated by themselves, one point or many at a time: [`Module::kernel`].
//! - Runs are ended from outside ([`Instance::cancel_handle`]) or by limits ([`Instance::limit_time`],
//!   [`Instance::limit_memory`]), and tell how far they are ([`Instance::on_progress`]).
//!
//! The feature `cli`, which is on by default, holds the `calyx` command and what only it needs; programs that embed models
//! take this crate with `default-features = false`.

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
pub use error::{CompileError, Diagnostics};
pub use kernel::{Kernel, KernelError, Quantity};
pub use module::Module;

/// The Rust programs on this page of the book run as tests.
#[cfg(doctest)]
#[doc = include_str!("../../docs/howto/embedding.md")]
pub struct EmbeddingPage;
