//! Canonical layout, as minimal changes: of a file, of a selection, and of a statement on typing.
//!
//! A file with errors remains unchanged, as with `calyx fmt`; in a selection only the statements
//! with errors do.

use super::lines::Lines;
use super::source::Source;
use calyx_lang::ast::{Stmt, StmtKind};
use calyx_lang::format::{self, FormatContext};
use calyx_lang::walk::Node;
use std::ops::Range;

/// Replaces bytes `start..end` of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Change {
    pub start: u32,
    pub end: u32,
    pub replacement: String,
}

/// Returns the changes that `calyx fmt` makes; none if the file has errors.
pub fn format_file(source: &Source<'_>) -> Vec<Change> {
    let edits = format::format_range(source.text, 0..source.text.len() as u32).unwrap_or_default();
    edits.into_iter().filter_map(|edit| smallest(source, 0, edit)).collect()
}

/// Returns the changes to the top-level statements and comments in a selection.
pub fn format_selection(source: &Source<'_>, selection: Range<u32>) -> Vec<Change> {
    let lines = Lines::new(source.text);
    let place = FormatContext { units: format::declared_units(&source.tree.module), indent: 0 };
    let parts = parts(source, &lines, &selection);
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return Vec::new() };
    let whole = (first.0, last.1);
    format_piece(source, &lines, whole, &place).unwrap_or_else(|| {
        // The selection has errors: its correct parts are formatted separately.
        parts
            .iter()
            .flat_map(|part| format_piece(source, &lines, *part, &place).unwrap_or_default())
            .collect()
    })
}

/// Returns the groups of statements and comments on common lines that a selection touches.
fn parts(source: &Source<'_>, lines: &Lines<'_>, selection: &Range<u32>) -> Vec<(u32, u32)> {
    let statements = &source.tree.module.statements;
    let first = statements.partition_point(|statement| statement.span.end < selection.start);
    let touched = statements.get(first..).unwrap_or_default().iter();
    let touched = touched.take_while(|statement| statement.span.start <= selection.end);
    let comments = &source.tokens.comments;
    let first = comments.partition_point(|comment| comment.span.end < selection.start);
    let commented = comments.get(first..).unwrap_or_default().iter();
    let commented = commented.take_while(|comment| comment.span.start <= selection.end);
    let mut parts: Vec<(u32, u32)> =
        touched.map(|statement| (statement.span.start, statement.span.end)).collect();
    parts.extend(commented.map(|comment| (comment.span.start, comment.span.end)));
    parts.sort_unstable();
    // Comments may be inside statements, and several parts may share a line.
    parts.dedup_by(|next, before| {
        let together = next.0 < before.1 || lines.line(next.0) == lines.line(before.1);
        if together {
            before.1 = before.1.max(next.1);
        }
        together
    });
    // The first part may not be the first on its line.
    if let Some(part) = parts.first_mut() {
        let mut end = statements.partition_point(|statement| statement.span.start < part.0);
        while let Some(before) = end.checked_sub(1).and_then(|at| statements.get(at)) {
            if lines.line(before.span.end) != lines.line(part.0) {
                break;
            }
            part.0 = before.span.start;
            end -= 1;
        }
    }
    parts
}

/// Returns the changes in a part that starts and ends with a statement or a comment; `None` if it
/// has errors.
fn format_piece(
    source: &Source<'_>,
    lines: &Lines<'_>,
    (start, end): (u32, u32),
    place: &FormatContext,
) -> Option<Vec<Change>> {
    let edits = format::format_part(source.slice(start, end), place).ok()?;
    let mut changes = Vec::new();
    let line_start = lines.start(lines.line(start));
    if lines.begins(start) && source.slice(line_start, start) != " ".repeat(place.indent) {
        changes.push(Change { start: line_start, end: start, replacement: " ".repeat(place.indent) });
    }
    changes.extend(edits.into_iter().filter_map(|edit| smallest(source, start, edit)));
    Some(changes)
}

/// Trims a change by its common prefix and suffix, so that a cursor there does not move.
fn smallest(source: &Source<'_>, from: u32, edit: format::Edit) -> Option<Change> {
    let (start, end) = (from + edit.span.start, from + edit.span.end);
    let (old, new) = (source.slice(start, end), edit.replacement.as_str());
    let same = |(a, b): &(char, char)| a == b;
    let prefix: usize = old.chars().zip(new.chars()).take_while(same).map(|(c, _)| c.len_utf8()).sum();
    let (old, new) = (old.get(prefix..)?, new.get(prefix..)?);
    let suffix = old.chars().rev().zip(new.chars().rev()).take_while(same).map(|(c, _)| c.len_utf8());
    let suffix: usize = suffix.sum();
    let replacement = new.get(..new.len() - suffix)?.to_string();
    let change = Change { start: start + prefix as u32, end: end - suffix as u32, replacement };
    (change.start < change.end || !change.replacement.is_empty()).then_some(change)
}

/// Returns the changes to the statement that ends at a byte, if it has its own lines and no errors.
/// The indentation of its first line does not change, because the author sees it.
pub(super) fn format_ended(source: &Source<'_>, lines: &Lines<'_>, offset: u32) -> Option<Vec<Change>> {
    let statement = statement_with_lines(&source.tree.module.statements, lines, offset)?;
    let (start, end) = (statement.span.start, statement.span.end);
    if end != offset && lines.line(start) != lines.line(end) {
        return None;
    }
    let line_start = lines.start(lines.line(start));
    let before = source.slice(line_start, start);
    if !before.bytes().all(|byte| byte == b' ') {
        return None;
    }
    let units = format::declared_units(&source.tree.module);
    format_piece(source, lines, (start, end), &FormatContext { units, indent: before.len() })
}

/// Returns the innermost statement around a byte that starts its line and is directly in the file
/// or in a block, not after a header such as `if (c)`.
fn statement_with_lines<'t>(statements: &'t [Stmt], lines: &Lines<'_>, offset: u32) -> Option<&'t Stmt> {
    let at = statements.partition_point(|statement| statement.span.end < offset);
    let statement = statements.get(at).filter(|statement| statement.span.start <= offset)?;
    let inner = inner_block(statement, offset);
    let inner = inner.and_then(|statements| statement_with_lines(statements, lines, offset));
    inner.or_else(|| lines.begins(statement.span.start).then_some(statement))
}

/// Returns the statements of the outermost block around a byte in a statement.
fn inner_block(statement: &Stmt, offset: u32) -> Option<&[Stmt]> {
    match &statement.kind {
        StmtKind::Block(statements) => return Some(statements),
        // The statements of a case have their own lines.
        StmtKind::Case { statement, .. } | StmtKind::Default(statement) => {
            return Some(std::slice::from_ref(statement));
        }
        _ => {}
    }
    let mut found = None;
    Node::Statement(statement).children(&mut |child| {
        if let Node::Statement(inner) = child
            && inner.span.start <= offset
            && offset <= inner.span.end
        {
            found = Some(inner);
        }
    });
    found.and_then(|inner| inner_block(inner, offset))
}
