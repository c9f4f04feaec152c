//! One way to write a program: its tokens and comments as they are, blanks and line ends as they should be.
//!
//! The tree says where lines may break and how deep they stand, the tokens say what is written: the printer
//! ([`printer`] and its neighbours) walks both in step, so nothing can be lost or invented. What results is a document
//! that [`document`] lays out. Before a text is handed out its tokens and comments are compared with the original.

mod declarations;
mod document;
mod expressions;
mod printer;
mod statements;

use crate::ast::{Module, StmtKind};
use crate::deep_recursion::with_deep_stack;
use crate::diagnostic::{Diagnostic, Severity};
use crate::lexer::{self, Kind, Tokens};
use crate::parser;
use crate::span::{FileId, Span};
use printer::Printer;
use std::collections::BTreeSet;
use std::ops::Range;

/// Columns of a line, as far as it can be broken.
pub const WIDTH: usize = 100;

/// Why a text is left as it is.
#[derive(Clone, Debug, PartialEq)]
pub enum FormatError {
    /// It has these errors.
    Errors(Vec<Diagnostic>),
    /// The result would not have been the same program: a defect of the formatter.
    WouldChange,
}

/// A replacement of blanks and line ends (and of a `,` before a closing bracket) by others.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    pub span: Span,
    pub replacement: String,
}

/// The text of a file in its canonical layout.
pub fn format(text: &str) -> Result<String, FormatError> {
    format_in(text, &FormatContext::default())
}

/// Where a part of a file stands: what its layout depends on beside its own text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FormatContext {
    /// Units that the file declares in another part.
    pub units: BTreeSet<String>,
    /// Columns before its lines.
    pub indent: usize,
}

fn format_in(text: &str, place: &FormatContext) -> Result<String, FormatError> {
    let tokens = lexer::lex(FileId(0), text);
    let formatted = lay_out(text, &tokens, place)?;
    let again = lexer::lex(FileId(0), &formatted);
    if meaning(text, &tokens) == meaning(&formatted, &again) {
        Ok(formatted)
    } else {
        Err(FormatError::WouldChange)
    }
}

/// The changes that [`format()`] makes between two bytes of a text.
pub fn format_range(text: &str, range: Range<u32>) -> Result<Vec<Edit>, FormatError> {
    let formatted = format(text)?;
    let mut edits = edits(text, &formatted)?;
    edits.retain(|edit| edit.span.start <= range.end && range.start <= edit.span.end);
    Ok(edits)
}

/// The changes that lay out a part of a file, whatever the rest of it is like. The part begins and ends with statements
/// or comments; changes are counted from its beginning, and none is before its first or behind its last word.
pub fn format_part(part: &str, place: &FormatContext) -> Result<Vec<Edit>, FormatError> {
    let formatted = format_in(part, place)?;
    let mut edits = edits(part, &formatted)?;
    edits.retain(|edit| edit.span.start > 0 && (edit.span.end as usize) < part.len());
    Ok(edits)
}

/// The units that a file declares, which are laid out like those of the language.
pub fn declared_units(module: &Module) -> BTreeSet<String> {
    let units = module.statements.iter().filter_map(|statement| match &statement.kind {
        StmtKind::Unit(unit) => Some(unit.name.name.clone()),
        _ => None,
    });
    units.collect()
}

/// What has to change between the words of a text to make another with the same words.
fn edits(text: &str, formatted: &str) -> Result<Vec<Edit>, FormatError> {
    let (before, after) = (pieces(text), pieces(formatted));
    if before.len() != after.len() {
        return Err(FormatError::WouldChange);
    }
    let mut edits = Vec::new();
    let mut change = |old: Range<u32>, new: Range<u32>| {
        let replacement = slice(formatted, new.start, new.end);
        if slice(text, old.start, old.end) != replacement {
            let span = Span::new(FileId(0), old.start as usize, old.end as usize);
            edits.push(Edit { span, replacement: replacement.into() });
        }
    };
    let (mut from, mut to) = (0, 0);
    let mut index = 0;
    while index < before.len() {
        // One piece, or several where a separator went before a comment.
        let length = (1..=before.len() - index).find(|length| {
            let run = index..index + length;
            same_words(text, &before[run.clone()], formatted, &after[run])
        });
        let Some(length) = length else { return Err(FormatError::WouldChange) };
        let last = index + length - 1;
        change(from..before[index].start, to..after[index].start);
        if length > 1 {
            change(before[index].start..before[last].end, after[index].start..after[last].end);
        }
        (from, to) = (before[last].end, after[last].end);
        index += length;
    }
    change(from..text.len() as u32, to..formatted.len() as u32);
    Ok(edits)
}

/// Tokens and comments in order of place, but for a `,` before a closing bracket.
fn pieces(text: &str) -> Vec<Range<u32>> {
    let tokens = lexer::lex(FileId(0), text);
    let written = (0..tokens.tokens.len()).filter(|i| !is_trailing_comma(&tokens, *i));
    let mut pieces: Vec<Span> = written.map(|i| tokens.tokens[i].span).collect();
    pieces.extend(tokens.comments.iter().map(|c| c.span));
    pieces.sort_by_key(|span| (span.start, span.end));
    pieces.into_iter().map(|span| span.start..span.end).collect()
}

/// Whether two texts hold the same words, in any order, at these places.
fn same_words(a: &str, in_a: &[Range<u32>], b: &str, in_b: &[Range<u32>]) -> bool {
    let words = |text, places: &[Range<u32>]| {
        let mut words: Vec<_> = places.iter().map(|p| slice(text, p.start, p.end)).collect();
        words.sort_unstable();
        words
    };
    words(a, in_a) == words(b, in_b)
}

fn slice(text: &str, from: u32, to: u32) -> &str {
    text.get(from as usize..to as usize).unwrap_or_default()
}

fn lay_out(text: &str, tokens: &Tokens, place: &FormatContext) -> Result<String, FormatError> {
    let (module, diagnostics) = parser::parse_tokens(FileId(0), text, tokens);
    let errors: Vec<_> = diagnostics.into_iter().filter(|d| d.severity == Severity::Error).collect();
    if !errors.is_empty() {
        return Err(FormatError::Errors(errors));
    }
    let units = &declared_units(&module) | &place.units;
    let mut printer = Printer::new(text, tokens, units);
    with_deep_stack(|| printer.file(&module));
    let items = printer.finish().ok_or(FormatError::WouldChange)?;
    Ok(document::lay_out(&items, WIDTH, place.indent))
}

/// A token or a comment as far as it counts.
type Piece<'t> = (Option<Kind>, &'t str);

/// Everything that layout must not touch: tokens but for a `,` before a closing bracket, comments in their order, and
/// what documentation belongs to; before a separator or the end of a bracket it belongs to nothing.
fn meaning<'t>(text: &'t str, tokens: &'t Tokens) -> (Vec<Piece<'t>>, Vec<Piece<'t>>, Vec<Piece<'t>>) {
    let kept = |index: usize| !is_trailing_comma(tokens, index);
    let written = (0..tokens.tokens.len()).filter(|i| kept(*i)).map(|i| {
        let token = tokens.tokens[i];
        (Some(token.kind), slice(text, token.span.start, token.span.end))
    });
    let comments = tokens.comments.iter().map(|c| (None, slice(text, c.span.start, c.span.end)));
    let docs = (0..tokens.tokens.len()).filter_map(|i| {
        let (doc, kind) = (tokens.docs.get(&i)?, tokens.tokens[i].kind);
        let documents =
            !matches!(kind, Kind::Comma | Kind::Semicolon | Kind::CloseParen | Kind::CloseBracket);
        documents.then_some((Some(kind), doc.as_str()))
    });
    let file_doc = tokens.file_doc.iter().map(|doc| (None, doc.as_str()));
    (written.collect(), comments.collect(), docs.chain(file_doc).collect())
}

fn is_trailing_comma(tokens: &Tokens, index: usize) -> bool {
    let kind = |i: usize| tokens.tokens.get(i).map(|t| t.kind);
    kind(index) == Some(Kind::Comma) && matches!(kind(index + 1), Some(Kind::CloseParen | Kind::CloseBracket))
}
