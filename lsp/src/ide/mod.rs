//! Queries about a snapshot of the texts, one file per feature.

pub mod actions;
pub mod call_hierarchy;
mod callee;
pub mod code_lenses;
pub mod completion;
mod constant;
pub mod cursor;
pub mod definition;
pub mod document_links;
pub mod elaborated;
mod enclosing;
pub mod folding;
pub mod formatting;
pub mod fuzzy;
pub mod hover;
pub mod inlay_hints;
mod labels;
mod lines;
mod numbers;
pub mod on_type_formatting;
mod problems;
pub mod references;
pub mod rename;
pub mod selection;
pub mod semantic_tokens;
mod shape;
pub mod signature;
pub mod source;
mod symbol_dependencies;
pub mod symbols;

use calyx_lang::db::Database;
use elaborated::Elaborated;
use std::collections::BTreeMap;
use std::sync::Arc;

/// State of the texts of a folder, and of the analyses of them.
///
/// Files are identified by their display names: a path, or `<library>/gears.cx`.
#[derive(Clone)]
pub struct Snapshot {
    pub database: Database,
    /// Results of the last elaboration, by model; none before the first one.
    pub elaborated: Arc<BTreeMap<Arc<str>, Arc<Elaborated>>>,
}

impl Snapshot {
    /// Creates a snapshot without elaborated models.
    pub fn new(database: Database) -> Snapshot {
        Snapshot { database, elaborated: Arc::default() }
    }
}

/// A cursor: a byte offset in a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Position {
    pub file: Arc<str>,
    pub offset: u32,
}

/// Replaces bytes `start..end` of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    pub file: Arc<str>,
    pub start: u32,
    pub end: u32,
    pub replacement: String,
}
