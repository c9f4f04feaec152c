//! From syntax trees to a typed program: names, types, dimensions, then control flow.
//!
//! [`check_program`] loads the model's modules, resolves names ([`names`]), infers types and dimensions
//! ([`infer`] and its neighbours) into a typed tree ([`tree`]), lowers that to the typed program ([`lower`]) and checks
//! what only the flow of control shows ([`flow`]).

mod annotate;
mod builtin_calls;
mod builtins;
mod calls;
mod constant;
mod constraints;
mod consts;
mod dependence;
mod dim;
mod domains;
mod errors;
mod expr;
mod flow;
mod infer;
mod lower;
mod mismatch;
mod modules;
mod names;
mod params;
mod places;
mod records;
pub mod rules;
mod statements;
mod symbolic;
mod symbolic_functions;
mod symbols;
mod tree;
mod typed;
mod types;

pub use builtins::names as builtin_names;

use crate::ast::Module;
use crate::deep::deep;
use crate::diagnostic::{Diagnostic, Severity};
use crate::dimension::Dimension;
use crate::ir::{Program, SourceFile};
use crate::span::FileId;
use crate::units::UnitSystem;
use std::collections::BTreeMap;

/// Finds modules. `import gears.helical;` asks for `["gears", "helical"]`.
pub trait Loader {
    /// Name shown to people and text of a module.
    fn module(&self, path: &[String]) -> Option<(String, String)>;
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
    /// Types of the model's top-level variables, params and outputs as shown to people.
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
    deep(|| check_modules(name, text, loader))
}

fn check_modules(name: &str, text: &str, loader: &dyn Loader) -> Checked {
    let (modules, files, mut diagnostics) = modules::load(name, text, loader);
    let mut names = names::resolve(&modules, loader);
    diagnostics.append(&mut names.diagnostics);
    let mut checker = infer::Checker::new(&modules, names);
    checker.program();
    diagnostics.append(&mut checker.diagnostics);
    let types = checker.shown_types();
    let mut program = None;
    if !has_errors(&diagnostics) {
        let model = modules.first().map(lower::Model::of).unwrap_or_default();
        let (lowered, mut found) = lower::lower(&checker.into_typed(), model, files.clone());
        diagnostics.append(&mut found);
        program = Some(lowered);
    } else if diagnostics.iter().all(|d| !d.code.starts_with("E01")) {
        // What is well typed is checked for its flow of control all the same.
        let sound = checker.sound_functions(&diagnostics);
        let found = lower::flow(&checker.into_typed(), &sound.iter().map(|(id, _)| *id).collect::<Vec<_>>());
        let within = |d: &Diagnostic| {
            sound.iter().any(|(_, text)| {
                let at = d.primary.span;
                at.file == text.file && at.start >= text.start && at.end <= text.end
            })
        };
        diagnostics.extend(found.into_iter().filter(within));
    }
    diagnostics.sort_by_key(|d| (d.primary.span.file, d.primary.span.start, d.primary.span.end));
    diagnostics.dedup();
    if has_errors(&diagnostics) {
        program = None;
    }
    Checked { program, diagnostics, files, types }
}

fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|d| d.severity == Severity::Error)
}

fn length() -> dim::Dim {
    dim::Dim::known(Dimension::whole([1, 0, 0, 0, 0]))
}
