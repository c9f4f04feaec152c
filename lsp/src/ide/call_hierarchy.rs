//! Call hierarchy: callers and callees of a function.

use super::source::Source;
use super::{Position, Snapshot};
use calyx_lang::analysis::{Name, NameKind, SourceRange};
use calyx_lang::ast::{FunctionDecl, Stmt, StmtKind};
use calyx_lang::walk::Node;
use std::sync::Arc;

/// A function, or a file whose top level has calls.
#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    pub name: String,
    /// `None` for the top level of a file.
    pub kind: Option<NameKind>,
    /// Signature.
    pub detail: Option<Arc<str>>,
    /// Range of its name; the start of the file for the top level.
    pub place: SourceRange,
    /// Start of the whole declaration.
    pub start: u32,
    /// End of the whole declaration.
    pub end: u32,
}

/// A caller or a callee, and the ranges of the calls in the caller's file.
#[derive(Clone, Debug, PartialEq)]
pub struct Calls {
    pub item: Item,
    pub ranges: Vec<(u32, u32)>,
}

/// Returns the function named at a cursor.
pub fn prepare(snapshot: &Snapshot, position: &Position) -> Option<Item> {
    let name = snapshot.database.name_at(&position.file, position.offset)?;
    if !is_function(name.kind) {
        return None;
    }
    item(snapshot, &name.declared?)
}

fn is_function(kind: NameKind) -> bool {
    matches!(kind, NameKind::Function | NameKind::SymbolicFunction | NameKind::Extern | NameKind::Component)
}

/// Returns the function declared at a position, or the top level of a file at its start.
fn item(snapshot: &Snapshot, place: &SourceRange) -> Option<Item> {
    if place.end == 0 {
        let end = snapshot.database.text(&place.file)?.len() as u32;
        let name = place.file.rsplit('/').next().unwrap_or(&place.file).to_string();
        return Some(Item { name, kind: None, detail: None, place: place.clone(), start: 0, end });
    }
    let declaration = snapshot.database.declaration(place)?;
    Some(Item {
        name: declaration.name.to_string(),
        kind: Some(declaration.kind),
        detail: declaration.ty,
        place: place.clone(),
        start: declaration.item.start,
        end: declaration.item.end,
    })
}

/// Returns the callers of the function declared at a position, sorted by file and position.
pub fn incoming(snapshot: &Snapshot, place: &SourceRange) -> Vec<Calls> {
    let mut by_caller: Vec<(SourceRange, Vec<(u32, u32)>)> = Vec::new();
    let mut source: Option<(Arc<str>, Source<'_>)> = None;
    for (file, name) in snapshot.database.references(place) {
        if name.declares {
            continue;
        }
        if source.as_ref().is_none_or(|(known, _)| *known != file) {
            source = Source::of(snapshot, &file).map(|source| (file.clone(), source));
        }
        let Some((_, source)) = &source else { continue };
        let caller = match function_around(&source.tree.module.statements, name.start) {
            Some(function) => {
                let span = function.name.span;
                SourceRange { file: file.clone(), start: span.start, end: span.end }
            }
            None => SourceRange { file: file.clone(), start: 0, end: 0 },
        };
        let range = (name.start, name.end);
        match by_caller.iter_mut().find(|(known, _)| *known == caller) {
            Some((_, ranges)) => ranges.push(range),
            None => by_caller.push((caller, vec![range])),
        }
    }
    let calls = by_caller.into_iter();
    calls.filter_map(|(caller, ranges)| Some(Calls { item: item(snapshot, &caller)?, ranges })).collect()
}

/// Returns the callees of the function declared at a position, or of the top level of a file at its
/// start, in order of their first calls.
pub fn outgoing(snapshot: &Snapshot, place: &SourceRange) -> Vec<Calls> {
    let Some(source) = Source::of(snapshot, &place.file) else { return Vec::new() };
    let statements = &source.tree.module.statements;
    let whole = (0, source.text.len() as u32);
    let (start, end) = match place.end {
        0 => whole,
        _ => item(snapshot, place).map_or(whole, |item| (item.start, item.end)),
    };
    let mut by_callee: Vec<(SourceRange, Vec<(u32, u32)>)> = Vec::new();
    for name in snapshot.database.names_in(&place.file, start..end) {
        let Name { declared: Some(callee), .. } = &name else { continue };
        let inside = start <= name.start && name.end <= end && !name.declares && is_function(name.kind);
        // Calls inside a nested function belong to that function.
        let own = match function_around(statements, name.start) {
            Some(function) => function.name.span.start == place.start && place.end > 0,
            None => place.end == 0,
        };
        if !inside || !own {
            continue;
        }
        match by_callee.iter_mut().find(|(known, _)| known == callee) {
            Some((_, ranges)) => ranges.push((name.start, name.end)),
            None => by_callee.push((callee.clone(), vec![(name.start, name.end)])),
        }
    }
    let calls = by_callee.into_iter();
    calls.filter_map(|(callee, ranges)| Some(Calls { item: item(snapshot, &callee)?, ranges })).collect()
}

/// Returns the innermost function around a byte.
fn function_around(statements: &[Stmt], offset: u32) -> Option<&FunctionDecl> {
    let at = statements.partition_point(|statement| statement.span.end <= offset);
    let statement = statements.get(at).filter(|statement| statement.span.start <= offset)?;
    let mut found = None;
    function_within(statement, offset, &mut found);
    found
}

fn function_within<'t>(statement: &'t Stmt, offset: u32, found: &mut Option<&'t FunctionDecl>) {
    if let StmtKind::Function(function) = &statement.kind {
        *found = Some(function);
    }
    Node::Statement(statement).children(&mut |child| {
        if let Node::Statement(inner) = child
            && inner.span.start <= offset
            && offset < inner.span.end
        {
            function_within(inner, offset, found);
        }
    });
}
