//! The Calyx compiler as a library: check a model, compile it, run it.
//!
//! ```no_run
//! let checked = calyx::check_file("examples/spur_pair.cx".as_ref())?;
//! assert!(!checked.has_errors(), "{}", checked.render());
//! let module = calyx::Module::compile(checked)?;
//! let options = calyx::rt::RunOptions { directory: "results".into(), ..Default::default() };
//! let report = calyx::rt::run(std::sync::Arc::new(module), &options).map_err(|error| format!("{error:?}"))?;
//! println!("{}", report.summary);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod artifact;
pub mod build;
pub mod doc;
pub mod dump;
pub mod explain;
pub mod fix;
mod kernel;
mod module;
pub mod session;
pub mod testing;
mod typed;

pub use artifact::{ArtifactError, is_artifact};
pub use calyx_codegen::TargetCpu;
pub use calyx_elaborate as elaborate;
pub use calyx_elaborate::{
    Checked, Interpreted, ModelLoader, Refused, check_file, check_run, check_text, render,
};
pub use calyx_rt as rt;
pub use kernel::{Kernel, KernelError, Quantity};
pub use module::{CompileError, Module};
