//! Elaboration: runs a model without solving it, to find its gears, its problems and the plan of
//! its analysis.
//!
//! Elaboration interprets a typed program for particular params. It calls the functions that build
//! a scene, but none that solves one. `calyx check` elaborates once. An editor elaborates in the
//! background after every edit, and cancels elaborations that an edit supersedes.
//!
//! - Problems of the gears and the scene: [`Elaboration::found`].
//! - Geometry of the gear or mesh at a call: [`Elaboration::geometry`], with [`Geometry::gear_at`]
//!   and [`Geometry::mesh_at`]; as text by [`shown::value`].
//! - Value of a variable or param: [`Elaboration::values`], [`values::default_of`],
//!   [`values::range_of`].
//! - Plan of the analysis: [`Elaboration::plan`], as text by [`Planned::text`].
//! - Expression of a `:=` definition: [`binding::definition_in`] and [`binding::binding`], which
//!   need only the program.
//! - Results of the last run: [`results::RunSummary`], from its directory.
//!
//! ```
//! use calyx_elaborate::{Cancel, ModelLoader, Params, elaborate};
//! let text = "var a = 1; assert(a > 2);";
//! let checked = calyx_lang::check_program("model.cx", text, &ModelLoader::default());
//! let program = checked.program.expect("the language has nothing against it");
//! let elaboration = elaborate(&program, Params::Defaults, &Cancel::default())?;
//! assert_eq!(elaboration.found[0].code, "E0705");
//! # Ok::<(), calyx_elaborate::Cancelled>(())
//! ```

pub mod binding;
pub mod check;
mod cost;
pub mod diagnostics;
mod disk;
mod elaboration;
pub mod geometry;
mod infix;
mod interpreted;
mod known_kernels;
mod known_results;
mod loader;
pub mod nan;
pub mod plan;
mod planned_bearing;
mod planned_elastic_body;
mod planned_sound;
mod printed;
mod ranges;
pub mod results;
pub mod shown;
pub mod values;

pub use calyx_abi::Cancel;
pub use calyx_gears::derived_quantities::{Kind, Quantity};
pub use calyx_lower::kernels::SymbolKind;
pub use calyx_rt::{InvalidParam, Override, ParamAssignment};
pub use check::{
    Checked, check_file, check_file_allowing, check_language, check_run, check_run_within, check_sources,
    check_text, render,
};
pub use cost::PlannedCost;
pub use disk::PlannedDisk;
pub use elaboration::{Cancelled, Elaboration, FUEL, MEMORY, Params, elaborate, elaborate_printing};
pub use geometry::{CreatedAt, GearGeometry, Geometry, Membership, MeshGeometry};
pub use infix::Infix;
pub use interpreted::{Interpreted, param_function};
pub use loader::{ModelLoader, allowed_path, read_module};
pub use plan::{Planned, PlannedWork};
pub use planned_elastic_body::PlannedElasticBody;
pub use ranges::{Extent, Ranges, check_ranges};
pub use values::Value;
