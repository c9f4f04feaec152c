//! What is known of what is at a cursor, as Markdown: of names, arguments, numbers, units and words of the language.

mod expressions;
mod gears;
mod names;
mod numbers;
mod words;

use super::{Position, Snapshot};
use calyx_lang::lexer::Kind;
use std::ops::Range;

/// A card about a range of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Hover {
    pub range: Range<u32>,
    pub markdown: String,
}

/// What is known of what is at a cursor.
pub fn hover(snapshot: &Snapshot, at: &Position) -> Option<Hover> {
    let database = &snapshot.database;
    if let Some(name) = database.name_at(&at.file, at.offset) {
        let range = name.start..name.end;
        // A unit says more together with its number.
        let markdown = numbers::of_unit(snapshot, at, &name).or_else(|| names::of(snapshot, at, &name))?;
        return Some(Hover { range, markdown });
    }
    numbers::at(snapshot, at).or_else(|| words::at(snapshot, at)).or_else(|| operator(snapshot, at))
}

/// The type of what an operator makes: a chain of products shows where a dimension goes wrong.
fn operator(snapshot: &Snapshot, at: &Position) -> Option<Hover> {
    let database = &snapshot.database;
    let tokens = database.tokens(&at.file)?;
    let token =
        tokens.tokens.iter().find(|token| token.span.start <= at.offset && at.offset < token.span.end)?;
    let operator = matches!(token.kind, Kind::Plus | Kind::Minus | Kind::Star | Kind::Slash | Kind::Caret);
    let typed = database.expression_at(&at.file, token.span.start).filter(|_| operator)?;
    Some(Hover { range: typed.start..typed.end, markdown: format!("`{}`", typed.ty) })
}

/// A block of source.
fn code(text: &str) -> String {
    format!("```calyx\n{text}\n```")
}

/// Paragraphs without the empty ones.
fn paragraphs(parts: impl IntoIterator<Item = Option<String>>) -> String {
    let parts: Vec<String> = parts.into_iter().flatten().filter(|part| !part.trim().is_empty()).collect();
    parts.join("\n\n")
}
