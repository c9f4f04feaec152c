//! Elaboration: what a model describes, known without solving anything.
//!
//! A typed program is interpreted at some params with the functions that build a scene and none that solve one. That shows
//! what is wrong with its gears and meshes and how it would be analysed. `calyx check` does it once; an editor does it in the
//! background, again after every edit, and cancels what an edit supersedes.
//!
//! | question | answer |
//! |---|---|
//! | what is wrong with the gears? | [`Elaboration::found`] |
//! | what follows from the gear or mesh at this call? | [`Elaboration::geometry`]: [`Geometry::gear_at`], [`Geometry::mesh_at`]; as text by [`shown::value`] |
//! | what does this variable or param hold? | [`Elaboration::values`], [`values::default_of`], [`values::range_of`] |
//! | how would it be analysed? | [`Elaboration::plan`]: [`Planned::text`] |
//! | what does this `:=` stand for? | [`binding::definition_in`], [`binding::binding`]: from the program alone |
//! | what did the last run give? | [`results::RunSummary`]: from its directory |
//!
//! ```
//! use calyx_elaborate::{Cancel, ModelLoader, Params, elaborate};
//! let text = "var a = 1; assert(a > 2);";
//! let checked = calyx_lang::check::check_program("model.cx", text, &ModelLoader { folder: None });
//! let program = checked.program.expect("the language has nothing against it");
//! let elaboration = elaborate(&program, Params::Defaults, &Cancel::default())?;
//! assert_eq!(elaboration.found[0].code, "E0705");
//! # Ok::<(), calyx_elaborate::Cancelled>(())
//! ```

pub mod binding;
pub mod check;
mod cost;
pub mod diagnostics;
mod elaboration;
pub mod geometry;
mod infix;
mod interpreted;
mod loader;
pub mod nan;
pub mod plan;
pub mod results;
pub mod shown;
pub mod values;

pub use calyx_abi::Cancel;
pub use calyx_gears::derived::{Kind, Quantity};
pub use calyx_lower::kernels::SymbolKind;
pub use calyx_rt::{Given, Override, Refused};
pub use check::{Checked, check_file, check_run, check_run_within, check_sources, check_text, render};
pub use cost::PlannedCost;
pub use elaboration::{Cancelled, Elaboration, FUEL, MEMORY, Params, elaborate, elaborate_printing};
pub use geometry::{GearGeometry, Geometry, Made, Membership, MeshGeometry};
pub use infix::Infix;
pub use interpreted::{Interpreted, param_function};
pub use loader::{ModelLoader, read_module};
pub use plan::{Planned, PlannedWork};
pub use values::Value;
