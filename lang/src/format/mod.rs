//! The formatter: preserves tokens and comments, and changes only blanks and line ends.
//!
//! The printer ([`printer`] and related modules) traverses the tree and the tokens in parallel: the
//! tree determines the possible line breaks and the indentation, the tokens are the text. Nothing
//! can be lost or added. The result is a document that [`document`] lays out. Before the text is
//! returned, its tokens and comments are compared with the original.

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

/// Line width, columns, where breaks are possible.
pub const WIDTH: usize = 100;

/// The reason why a text was not formatted.
#[derive(Clone, Debug, PartialEq)]
pub enum FormatError {
    /// The text has these errors.
    Errors(Vec<Diagnostic>),
    /// The result would be a different program: a defect of the formatter.
    WouldChange,
}

/// A replacement of blanks and line ends (and of a `,` before a closing bracket).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    pub span: Span,
    pub replacement: String,
}

/// Returns the text of a file in canonical format.
///
/// # Errors
/// The text has syntax errors.
pub fn format(text: &str) -> Result<String, FormatError> {
    format_in(text, &FormatContext::default())
}

/// The context of a part of a file that affects its layout.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FormatContext {
    /// Units declared in other parts of the file.
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

/// Returns the changes that [`format()`] makes in a byte range of a text.
///
/// # Errors
/// As for [`format()`].
pub fn format_range(text: &str, range: Range<u32>) -> Result<Vec<Edit>, FormatError> {
    let formatted = format(text)?;
    let mut edits = edits(text, &formatted)?;
    edits.retain(|edit| edit.span.start <= range.end && range.start <= edit.span.end);
    Ok(edits)
}

/// Returns the changes that format a part of a file, independent of the rest. The part starts and
/// ends with statements or comments. Positions are relative to its start, and no change precedes
/// its first or follows its last token.
///
/// # Errors
/// The part has syntax errors.
pub fn format_part(part: &str, place: &FormatContext) -> Result<Vec<Edit>, FormatError> {
    let formatted = format_in(part, place)?;
    let mut edits = edits(part, &formatted)?;
    edits.retain(|edit| edit.span.start > 0 && (edit.span.end as usize) < part.len());
    Ok(edits)
}

/// Returns the units that a file declares, which are formatted like built-in ones.
pub fn declared_units(module: &Module) -> BTreeSet<String> {
    let units = module.statements.iter().filter_map(|statement| match &statement.kind {
        StmtKind::Unit(unit) => Some(unit.name.name.to_string()),
        _ => None,
    });
    units.collect()
}

/// Returns the changes between two texts with the same tokens and comments.
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
        // One token, or several if a separator moved before a comment.
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

/// Returns tokens and comments in order, without a `,` before a closing bracket.
fn pieces(text: &str) -> Vec<Range<u32>> {
    let tokens = lexer::lex(FileId(0), text);
    let written = (0..tokens.tokens.len()).filter(|i| !is_trailing_comma(&tokens, *i));
    let mut pieces: Vec<Span> = written.map(|i| tokens.tokens[i].span).collect();
    pieces.extend(tokens.comments.iter().map(|c| c.span));
    pieces.sort_by_key(|span| (span.start, span.end));
    pieces.into_iter().map(|span| span.start..span.end).collect()
}

/// Returns `true` if two texts have the same tokens and comments, in any order, at these ranges.
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

/// The significant content of a token or comment.
type Piece<'t> = (Option<Kind>, &'t str);

/// Returns everything that formatting must preserve: tokens without a `,` before a closing bracket,
/// comments in order, and the items to which documentation belongs. Documentation before a
/// separator or a closing bracket belongs to nothing.
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
