//! Hover text of keywords.

use super::{Hover, code, paragraphs};
use crate::ide::{Position, Snapshot};
use calyx_lang::help::{self, Help};

/// Returns the description of the keyword at a cursor.
pub(super) fn at(snapshot: &Snapshot, at: &Position) -> Option<Hover> {
    let database = &snapshot.database;
    let (tokens, text) = (database.tokens(&at.file)?, database.text(&at.file)?);
    let here = |start: u32, end: u32| start <= at.offset && at.offset <= end;
    let mut touching = tokens.tokens.iter().filter(|token| here(token.span.start, token.span.end));
    touching.find_map(|token| {
        let word = text.get(token.span.start as usize..token.span.end as usize)?;
        let help = help::keyword(word).or_else(|| help::builtin(word))?;
        // In a string it is no keyword.
        let is_word = token.kind.describe() != "a string";
        is_word.then(|| Hover { range: token.span.start..token.span.end, markdown: card(help) })
    })
}

/// Formats help as Markdown.
pub(super) fn card(help: &Help) -> String {
    let example = (!help.example.is_empty()).then(|| code(help.example));
    paragraphs([Some(help.text.to_string()), example])
}
