//! From syntax trees to a typed program: names, types, dimensions, then control flow.
//!
//! What is checked at once is a unit ([`mod@unit`]), in an excerpt of the program ([`excerpt`]): names are resolved
//! ([`names`]), types and dimensions inferred ([`infer`] and its neighbours) into a typed tree ([`tree`]), and what only
//! the flow of control shows is checked ([`flow`]). Callers know a function by its interface ([`interface`]). The units of
//! a program are then lowered to the typed program ([`mod@lower`]). Which units there are and when they are checked again is
//! the database's affair ([`crate::db`]).

mod annotate;
mod argument_help;
mod axes;
mod blind;
mod builtin_calls;
pub(crate) mod builtins;
mod calls;
mod constant;
mod constraints;
mod consts;
mod dependence;
mod dim;
mod domains;
mod elsewhere;
mod errors;
pub(crate) mod excerpt;
mod expr;
pub(crate) mod expressions;
mod extent;
mod flow;
mod generalise;
mod graphs;
mod hosts;
mod infer;
pub(crate) mod interface;
pub(crate) mod item;
mod lower;
pub(crate) mod meanings;
mod mismatch;
mod names;
mod offers;
mod order;
mod params;
mod places;
mod records;
pub mod rules;
mod schemes;
mod sound;
mod statements;
mod symbolic;
mod symbolic_functions;
mod symbols;
mod tree;
mod turns;
mod typed;
mod types;
pub(crate) mod unit;
mod unit_names;
mod vocabulary;

pub(crate) use annotate::handles_of;
pub use builtins::names as builtin_names;
pub(crate) use lower::{Linked, Model, lower, model_doc};
pub(crate) use schemes::Shown;
pub(crate) use symbols::similar;
pub(crate) use unit::sees;

use crate::ast::Module;
use crate::db::Database;
use crate::diagnostic::{Diagnostic, Severity};
use crate::dimension::Dimension;
use crate::ir::{Program, SourceFile};
use crate::span::FileId;
use crate::units::UnitSystem;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Finds modules. `import gears.helical;` asks for `["gears", "helical"]`.
pub trait Loader {
    /// Name shown to people and text of a module.
    fn module(&self, path: &[String]) -> Option<(String, String)>;
    /// Reason for not reading a module whose file exists, such as a symbolic link that leads out of the
    /// model's folder.
    fn refusal(&self, _path: &[String]) -> Option<String> {
        None
    }
    /// Name and text of the module every program sees.
    fn prelude(&self) -> (String, String);
    /// Modules there are, for suggestions.
    fn names(&self) -> Vec<String> {
        Vec::new()
    }
}

/// What checking a model gives.
#[derive(Clone, Debug, Default)]
pub struct Checked {
    /// `None` if there are errors.
    pub program: Option<Program>,
    /// In order of file and place.
    pub diagnostics: Vec<Diagnostic>,
    /// By [`FileId`]; there even if checking failed.
    pub files: Vec<SourceFile>,
    /// Types of the model's top-level variables, params, outputs and functions as shown to people.
    pub types: BTreeMap<String, String>,
}

/// A parsed file.
pub struct ModuleData {
    /// As imported: `gears.helical`; empty for the model, `prelude` for the prelude.
    pub name: String,
    pub file: FileId,
    pub text: String,
    pub tree: Module,
    /// `units ...;` if the file has it.
    pub system: Option<UnitSystem>,
}

/// Checks a model and everything it imports. `name` is the model's file as shown to people.
pub fn check_program(name: &str, text: &str, loader: &dyn Loader) -> Checked {
    let mut database = Database::new(loader);
    database.set_model(name, text);
    database.load_imports(name, loader);
    let checked = database.check(name);
    drop(database);
    checked.and_then(Arc::into_inner).unwrap_or_default()
}

pub(crate) fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|d| d.severity == Severity::Error)
}

fn length() -> dim::Dim {
    dim::Dim::known(Dimension::whole([1, 0, 0, 0, 0]))
}
