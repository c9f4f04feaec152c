//! Hover texts as Markdown: for names, arguments, numbers, units and keywords.

mod expressions;
mod gears;
mod names;
mod numbers;
mod words;

use super::{Position, Snapshot};
use calyx_lang::lexer::Kind;
use std::ops::Range;

/// Hover text for a range of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Hover {
    pub range: Range<u32>,
    pub markdown: String,
}

/// Returns the hover text at a cursor.
pub fn hover(snapshot: &Snapshot, at: &Position) -> Option<Hover> {
    let database = &snapshot.database;
    if let Some(name) = database.name_at(&at.file, at.offset) {
        let range = name.start..name.end;
        // A unit is described with its number.
        let markdown = numbers::of_unit(snapshot, at, &name).or_else(|| names::of(snapshot, at, &name))?;
        return Some(Hover { range, markdown });
    }
    numbers::at(snapshot, at).or_else(|| words::at(snapshot, at)).or_else(|| operator(snapshot, at))
}

/// Returns the type of an operator's result: in a chain of products it shows where a dimension is
/// wrong.
fn operator(snapshot: &Snapshot, at: &Position) -> Option<Hover> {
    let database = &snapshot.database;
    let tokens = database.tokens(&at.file)?;
    let token =
        tokens.tokens.iter().find(|token| token.span.start <= at.offset && at.offset < token.span.end)?;
    let operator = matches!(token.kind, Kind::Plus | Kind::Minus | Kind::Star | Kind::Slash | Kind::Caret);
    let typed = database.expression_at(&at.file, token.span.start).filter(|_| operator)?;
    Some(Hover { range: typed.start..typed.end, markdown: format!("`{}`", typed.ty) })
}

/// Formats a block of source code.
fn code(text: &str) -> String {
    format!("```calyx\n{text}\n```")
}

/// Joins the non-empty paragraphs.
fn paragraphs(parts: impl IntoIterator<Item = Option<String>>) -> String {
    let parts: Vec<String> = parts.into_iter().flatten().filter(|part| !part.trim().is_empty()).collect();
    parts.join("\n\n")
}
