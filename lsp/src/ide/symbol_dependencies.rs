//! Dependences of an expression bound with `:=`: `Time`, params and observables, also through other
//! such names.

use calyx_lang::analysis::{NameKind, SourceRange};
use calyx_lang::ast::{Bind, Expr, FunctionBody, Module, StmtKind};
use calyx_lang::db::Database;
use calyx_lang::declared::{Declared, find};
use std::collections::BTreeSet;

/// Largest number of names that are followed.
const MOST_NAMES: usize = 200;

/// Formats the symbols that remain free in the declaration at a position: `Time` and params.
/// Returns nothing for a function without any: its arguments are its variables.
pub fn line(database: &Database, place: &SourceRange) -> Option<String> {
    let mut walk = Walk { database, seen: BTreeSet::new(), symbols: BTreeSet::new() };
    walk.declaration(place)?;
    let shown: Vec<String> = walk.symbols.iter().map(|symbol| format!("`{symbol}`")).collect();
    let function = || {
        database.name_at(&place.file, place.start).is_some_and(|name| name.kind == NameKind::SymbolicFunction)
    };
    Some(match shown.as_slice() {
        [] if function() => return None,
        [] => "depends on no symbol".into(),
        [one] => format!("depends on {one}"),
        [all @ .., last] => format!("depends on {} and {last}", all.join(", ")),
    })
}

/// Returns the expression of the declaration at an offset.
pub fn value_at(module: &Module, start: u32) -> Option<&Expr> {
    match find(module, start)?.1 {
        Declared::Variable(_, decl) => decl.init.as_ref().map(|(_, value)| value),
        Declared::Statement(statement) => match &statement.kind {
            StmtKind::Output { value, .. } | StmtKind::Const { value, .. } => Some(value),
            StmtKind::Param(decl) => Some(&decl.default),
            StmtKind::Function(decl) => match &decl.body {
                FunctionBody::Symbolic(value) => Some(value),
                _ => None,
            },
            _ => None,
        },
        Declared::Parameter(_, parameter) => match &parameter.default {
            Some((Bind::Symbolic, Some(value))) => Some(value),
            _ => None,
        },
        _ => None,
    }
}

struct Walk<'d> {
    database: &'d Database,
    seen: BTreeSet<SourceRange>,
    symbols: BTreeSet<String>,
}

impl Walk<'_> {
    fn declaration(&mut self, place: &SourceRange) -> Option<()> {
        if self.seen.len() >= MOST_NAMES || !self.seen.insert(place.clone()) {
            return Some(());
        }
        let tree = self.database.around(&place.file, place.start)?;
        let value = value_at(&tree.module, place.start)?;
        let range = value.span.start..value.span.end;
        let names = self.database.names_in(&place.file, range.clone());
        for name in names.iter().filter(|name| range.start <= name.start && name.end <= range.end) {
            match (name.kind, &name.declared) {
                (NameKind::Constant, None) if &*name.text == "Time" => {
                    self.symbols.insert("Time".into());
                }
                (NameKind::Param, Some(_)) => {
                    self.symbols.insert(name.text.to_string());
                }
                (NameKind::Symbolic | NameKind::Output | NameKind::SymbolicFunction, Some(place)) => {
                    self.declaration(place);
                }
                _ => {}
            }
        }
        Some(())
    }
}
