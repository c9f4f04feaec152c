//! Document symbols, and search for workspace symbols.

use super::fuzzy;
use super::source::Source;
use calyx_lang::analysis::Name;
use calyx_lang::ast::*;
use calyx_lang::span::Span;
use std::collections::HashMap;
use std::sync::Arc;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SymbolKind {
    Param,
    Output,
    Constant,
    Variable,
    /// A `:=` name.
    Symbolic,
    Function,
    Test,
    Record,
    Field,
    Dimension,
    Unit,
}

/// A declaration. Its children are sorted by position and inside its range.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    pub name: String,
    pub kind: SymbolKind,
    /// Type; the signature for a function.
    pub detail: Option<String>,
    /// Start of its documentation.
    pub start: u32,
    /// End of the declaration, after its `;`.
    pub end: u32,
    pub name_start: u32,
    pub name_end: u32,
    pub children: Vec<Symbol>,
}

/// Displayed types, by the offset of the declaration.
pub type Types = HashMap<u32, Arc<str>>;

/// Returns the types of the declarations in a file, from its names.
pub fn types(names: &[Name]) -> Types {
    let declared = names.iter().filter(|name| name.declares);
    let known = declared.filter_map(|name| Some((name.start, name.ty.clone()?)));
    known.filter(|(_, ty)| **ty != *"_").collect()
}

/// Returns the declarations of a file: its top level, fields of records, and variables and
/// functions inside functions.
pub fn symbols(source: &Source<'_>, types: &Types) -> Vec<Symbol> {
    Outline { source, types }.block(&source.tree.module.statements, true)
}

struct Outline<'a> {
    source: &'a Source<'a>,
    types: &'a Types,
}

impl Outline<'_> {
    fn block(&self, statements: &[Stmt], top: bool) -> Vec<Symbol> {
        let mut symbols = Vec::new();
        for statement in statements {
            self.statement(statement, top, &mut symbols);
        }
        symbols
    }

    fn statement(&self, statement: &Stmt, top: bool, symbols: &mut Vec<Symbol>) {
        let start = self.source.with_documentation(statement.span.start);
        let whole = (start, statement.span.end);
        let mut declares = |name: &Ident, kind| symbols.push(self.symbol(name, kind, whole));
        match &statement.kind {
            StmtKind::Param(param) => declares(&param.name, SymbolKind::Param),
            StmtKind::Output { name, .. } => declares(name, SymbolKind::Output),
            StmtKind::Const { name, .. } => declares(name, SymbolKind::Constant),
            StmtKind::Dimension { name, .. } => declares(name, SymbolKind::Dimension),
            StmtKind::Unit(unit) => declares(&unit.name, SymbolKind::Unit),
            StmtKind::Enum(decl) => declares(&decl.name, SymbolKind::Dimension),
            StmtKind::Record(record) => {
                let children = record.fields.iter().map(|field| self.field(field)).collect();
                symbols.push(Symbol {
                    detail: None,
                    children,
                    ..self.symbol(&record.name, SymbolKind::Record, whole)
                });
            }
            StmtKind::Function(function) => symbols.push(self.function(function, whole)),
            StmtKind::Var(variables) => {
                let only = variables.len() == 1;
                for variable in variables {
                    let init = variable.init.as_ref();
                    let kind = match init {
                        Some((Bind::Symbolic, _)) => SymbolKind::Symbolic,
                        _ => SymbolKind::Variable,
                    };
                    let end = init.map_or(variable.name.span.end, |(_, value)| value.span.end);
                    let own = (variable.name.span.start, end.max(variable.name.span.end));
                    symbols.push(self.symbol(&variable.name, kind, if only { whole } else { own }));
                }
            }
            // Counters and intermediate values of loops and branches would hide the important
            // symbols.
            _ if !top => {}
            StmtKind::Block(statements) => {
                statements.iter().for_each(|statement| self.statement(statement, false, symbols));
            }
            _ => {}
        }
    }

    fn symbol(&self, name: &Ident, kind: SymbolKind, (start, end): (u32, u32)) -> Symbol {
        let Span { start: name_start, end: name_end, .. } = name.span;
        let detail = self.types.get(&name_start).map(|ty| ty.to_string());
        let (start, end) = (start.min(name_start), end.max(name_end));
        Symbol {
            name: name.name.to_string(),
            kind,
            detail,
            start,
            end,
            name_start,
            name_end,
            children: Vec::new(),
        }
    }

    fn field(&self, field: &RecordField) -> Symbol {
        let ends =
            [field.annotation.as_ref().map(|ty| ty.span.end), field.default.as_ref().map(|e| e.span.end)];
        let end = ends.into_iter().flatten().fold(field.name.span.end, u32::max);
        let start = self.source.with_documentation(field.name.span.start);
        self.symbol(&field.name, SymbolKind::Field, (start, end))
    }

    fn function(&self, function: &FunctionDecl, whole: (u32, u32)) -> Symbol {
        let kind = match (function.is_test, function.is_component) {
            (true, _) => SymbolKind::Test,
            (_, true) => SymbolKind::Record,
            _ => SymbolKind::Function,
        };
        let symbol = self.symbol(&function.name, kind, whole);
        let children = match &function.body {
            FunctionBody::Statement(body) => match &body.kind {
                StmtKind::Block(statements) => self.block(statements, false),
                _ => Vec::new(),
            },
            _ => Vec::new(),
        };
        // The inferred signature, or else the written one.
        let known = symbol.detail.clone().filter(|detail| detail.starts_with('('));
        let detail = (!function.is_test).then(|| known.unwrap_or_else(|| self.signature(function)));
        Symbol { detail, children, ..symbol }
    }

    /// Returns `(in load: Force, out stress) -> Length`, as far as it is written.
    fn signature(&self, function: &FunctionDecl) -> String {
        let text = |span: Span| self.source.slice(span.start, span.end);
        let parameters = function.parameters.iter().map(|parameter| {
            let mode = match parameter.mode {
                Mode::In => "in",
                Mode::Out => "out",
                Mode::InOut => "inout",
            };
            let ty = parameter.annotation.as_ref().map(|ty| format!(": {}", text(ty.span)));
            format!("{mode} {}{}", parameter.name.name, ty.unwrap_or_default())
        });
        let parameters: Vec<String> = parameters.collect();
        let result = function.result.as_ref().map(|ty| format!(" -> {}", text(ty.span)));
        format!("({}){}", parameters.join(", "), result.unwrap_or_default())
    }
}

/// Result of a workspace symbol search.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    pub symbol: Symbol,
    pub file: Arc<str>,
    /// Record of a field; otherwise `None`.
    pub container: Option<String>,
    /// True for declarations of the library.
    pub library: bool,
}

/// Largest number of results of a search.
pub const MOST_FOUND: usize = 256;

/// Returns the declarations in all files whose names match `query`, the best first. Declarations of
/// the workspace precede those of the library with the same score.
pub fn find<'a>(query: &str, files: impl Iterator<Item = (Arc<str>, &'a Source<'a>)>) -> Vec<Found> {
    let mut found = Vec::new();
    for (file, source) in files {
        let library = is_library(&file);
        let mut add = |symbol: Symbol, container: Option<String>| {
            if let Some(score) = fuzzy::score(query, &symbol.name) {
                found.push((score, Found { symbol, file: file.clone(), container, library }));
            }
        };
        for mut symbol in symbols(source, &Types::new()) {
            let children = std::mem::take(&mut symbol.children);
            if symbol.kind == SymbolKind::Record {
                children.into_iter().for_each(|field| add(field, Some(symbol.name.clone())));
            }
            add(symbol, None);
        }
    }
    let order = |(score, one): &(u32, Found)| {
        (std::cmp::Reverse(*score), one.library, one.symbol.name.len(), one.file.clone(), one.symbol.start)
    };
    found.sort_by_cached_key(order);
    found.truncate(MOST_FOUND);
    found.into_iter().map(|(_, found)| found).collect()
}

/// Returns true if a display name is that of a library file.
pub fn is_library(file: &str) -> bool {
    file.starts_with("<library>/")
}
