//! The checker: converts syntax trees to a typed program. It resolves names, infers types and
//! dimensions, and checks control flow.
//!
//! The checker works on one unit at a time ([`mod@unit`]), in an excerpt of the program
//! ([`excerpt`]). It resolves names ([`names`]), infers types and dimensions ([`infer`] and related
//! modules), and builds a typed tree ([`tree`]); control-flow checks follow ([`flow`]). Callers
//! depend only on the interface of a function ([`interface`]). Finally, the units of a program are
//! lowered to the typed program ([`mod@lower`]).
//!
//! The checker does not depend on the database ([`crate::db`]), which determines the units and when
//! they are checked again. [`crate::check_program`] checks a whole model.

mod angles;
mod annotate;
mod argument_help;
mod arguments;
mod assignments;
mod axes;
mod branches;
mod builtin_calls;
pub(crate) mod builtins;
mod calls;
mod collections;
mod constant;
mod constraints;
mod consts;
mod dependence;
mod dim;
mod domains;
mod enums;
mod errors;
mod evidence;
pub(crate) mod excerpt;
mod expected_type;
mod expr;
pub(crate) mod expressions;
mod flow;
mod former_names;
mod function_values;
mod functions;
mod generalise;
mod hosts;
mod infer;
mod instance_arrays;
mod instances;
pub(crate) mod interface;
pub(crate) mod item;
mod lower;
mod mismatch;
mod missed_dependence;
pub(crate) mod name_resolution;
mod name_uses;
mod named_handles;
mod names;
mod observables;
mod optional;
mod order;
mod other_modules;
mod output_units;
mod params;
mod places;
mod reaching;
mod records;
pub mod rules;
mod runtime_definitions;
mod schemes;
mod solutions;
mod sound;
mod splines;
mod statements;
mod stored_expressions;
mod suggested_changes;
mod symbolic;
mod symbolic_blocks;
mod symbolic_functions;
mod symbols;
mod tree;
mod type_extent;
mod typed;
mod types;
pub(crate) mod unit;
mod unit_names;
mod vocabulary;

pub(crate) use annotate::handles_of;
pub use builtins::names as builtin_names;
pub(crate) use instances::declared_names;
pub(crate) use lower::{Linked, Model, lower, model_doc};
pub(crate) use named_handles::named_type;
pub use records::HANDLE_FIELDS;
pub(crate) use schemes::ShownScheme;
pub(crate) use symbols::similar;
pub(crate) use unit::sees;

use crate::ast::Module;
use crate::diagnostic::{Diagnostic, Severity};
use crate::dimension::Dimension;
use crate::ir::{Program, SourceFile};
use crate::span::FileId;
use crate::units::UnitSystem;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

/// Loads modules. `import gears.helical;` requests `["gears", "helical"]`.
pub trait Loader {
    /// Returns the display name and the text of a module.
    fn module(&self, path: &[String]) -> Option<(String, String)>;
    /// Returns the reason why an existing module file cannot be read, such as a symbolic link that
    /// leads out of the model's folder.
    fn refusal(&self, _path: &[String]) -> Option<String> {
        None
    }
    /// Returns the name and the text of the module that every program imports.
    fn prelude(&self) -> (String, String);
    /// Returns `true` if a module, or the prelude for an empty path, has no errors and warnings,
    /// such as a module of the library. Only the functions that a program uses are then checked
    /// with it.
    fn is_sound(&self, _path: &[String]) -> bool {
        false
    }
    /// Returns the available modules, for suggestions.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
    /// Files and directories outside of the model's directory that the program may read too, as
    /// absolute paths without links.
    fn allowed(&self) -> Arc<[PathBuf]> {
        Arc::default()
    }
}

/// The result of checking a model.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// The typed program; `None` if there are errors.
    pub program: Option<Program>,
    /// Diagnostics in order of file and position.
    pub diagnostics: Vec<Diagnostic>,
    /// Files by [`FileId`], also if checking failed.
    pub files: Vec<SourceFile>,
    /// Types of the model's top-level variables, params, outputs and functions, as displayed.
    pub types: BTreeMap<String, String>,
}

/// A parsed file.
pub struct ModuleData {
    /// Name as imported: `gears.helical`; empty for the model, `prelude` for the prelude.
    pub name: String,
    pub file: FileId,
    pub text: String,
    pub tree: Module,
    /// The system of `units ...;`, if the file has it.
    pub system: Option<UnitSystem>,
}

pub(crate) fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|d| d.severity == Severity::Error)
}

fn length() -> dim::Dim {
    dim::Dim::known(Dimension::whole([1, 0, 0, 0, 0]))
}
