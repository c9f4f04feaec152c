//! The parser: converts tokens to a syntax tree, by the grammar of tables 3.1 and 3.2 of the Calyx
//! report and the extensions of the language.
//!
//! Rules are chumsky parsers over token kinds. A rule needs at most two tokens to decide whether it
//! applies. Once it applies, it reports missing tokens and continues, so that one error does not
//! hide others and there is always a tree. Rules are boxed, because the types of unboxed rules take
//! minutes to compile.

mod anonymous;
mod brackets;
pub(crate) mod chunks;
mod declarations;
mod definitions;
mod expressions;
mod foreign_loops;
mod layout;
mod nesting;
mod operators;
mod recovery;
mod source;
mod statements;

use crate::ast::{Module, Stmt};
use crate::deep_recursion::with_deep_stack;
use crate::diagnostic::Diagnostic;
use crate::lexer::{self, Kind, Tokens};
use crate::relocate;
use crate::span::FileId;
use chumsky::error::{Error, LabelError};
use chumsky::prelude::*;
use chumsky::util::MaybeRef;
use chunks::PlacedChunk;
use source::Source;

/// Parses a file. Returns its tree and all errors in its text, in order of position.
pub fn parse(file: FileId, text: &str) -> (Module, Vec<Diagnostic>) {
    parse_tokens(file, text, &lexer::lex(file, text))
}

/// Parses a file whose tokens are already available.
pub fn parse_tokens(file: FileId, text: &str, tokens: &Tokens) -> (Module, Vec<Diagnostic>) {
    assemble(file, tokens, &chunks::pieces(text, tokens, |_| None))
}

/// Assembles a file from its pieces.
pub(crate) fn assemble(file: FileId, tokens: &Tokens, pieces: &[PlacedChunk]) -> (Module, Vec<Diagnostic>) {
    let mut module = Module { statements: Vec::new(), doc: tokens.file_doc.clone() };
    let mut diagnostics = tokens.diagnostics.clone();
    for PlacedChunk { range, piece } in pieces {
        let start = range.start as u32;
        module.statements.extend(piece.statements.iter().map(|statement| {
            let mut statement = statement.clone();
            let to = statement.span.start + start;
            relocate::to(&mut statement, file, to);
            statement
        }));
        diagnostics.extend(piece.problems.iter().map(|problem| problem.moved(file, start)));
    }
    (module, in_order(diagnostics))
}

/// Parses consecutive statements, and returns the errors in their syntax.
fn parse_run(text: &str, tokens: &Tokens, ends_file: bool) -> (Vec<Stmt>, Vec<Diagnostic>) {
    let Tokens { tokens, docs, diagnostics, .. } = tokens;
    let source = Source::new(FileId(0), text, tokens, docs, ends_file);
    if let Some(too_deep) = nesting::exceeds_nesting(&source) {
        return (Vec::new(), vec![too_deep]);
    }
    let kinds: Vec<Kind> = tokens.iter().map(|t| t.kind).collect();
    let (statements, problems) =
        with_deep_stack(|| statements::file(&source).parse(kinds.as_slice()).into_output_errors());
    let problems: Vec<Diagnostic> = problems.into_iter().filter_map(|p| p.0).map(|d| *d).collect();
    (statements.unwrap_or_default(), in_order(without_consequences(&source, diagnostics, problems)))
}

fn in_order(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.sort_by_key(|d| (d.primary.span.start, d.primary.span.end));
    diagnostics
}

/// Removes repeated errors at one location, and errors directly after invalid text.
fn without_consequences(
    source: &Source<'_>,
    lexical: &[Diagnostic],
    mut problems: Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    // The sort is stable: of errors at one location, the one found first is the cause.
    problems.sort_by_key(|d| d.primary.span.start);
    problems.dedup_by_key(|d| d.primary.span.start);
    // In `x = ` followed by another statement on the next line, the value and the `;` are missing.
    let value_is_missing: Vec<bool> = problems
        .windows(2)
        .map(|pair| {
            let (end, next) = (pair[0].primary.span.end, pair[1].primary.span.start);
            pair[0].code == "E0110"
                && matches!(pair[1].code.as_str(), "E0112" | "E0114" | "E0124")
                && source.next_start(end) == Some(next)
        })
        .collect();
    let mut index = 0;
    problems.retain(|_| {
        index += 1;
        value_is_missing.get(index - 1) != Some(&true)
    });
    let mut bad_text: Vec<_> = lexical.iter().map(|d| d.primary.span).collect();
    bad_text.sort_by_key(|span| span.start);
    problems.retain(|problem| {
        let start = problem.primary.span.start;
        // The last lexical error that starts at or before this location.
        let before = bad_text.partition_point(|span| span.start <= start);
        let Some(bad) = before.checked_sub(1).map(|i| bad_text[i]) else { return true };
        bad.end < start && !source.is_blank(bad.end, start)
    });
    problems
}

type Input<'a> = &'a [Kind];
type Extra = extra::Err<Problem>;
type Rule<'a, O> = Boxed<'a, 'a, Input<'a>, O, Extra>;

/// The error of a rule; `None` if the rule does not apply, so that another rule is tried.
#[derive(Debug)]
struct Problem(Option<Box<Diagnostic>>);

impl From<Diagnostic> for Problem {
    fn from(diagnostic: Diagnostic) -> Self {
        Problem(Some(Box::new(diagnostic)))
    }
}

impl<'a> Error<'a, Input<'a>> for Problem {}

impl<'a, L> LabelError<'a, Input<'a>, L> for Problem {
    fn expected_found<E: IntoIterator<Item = L>>(
        _expected: E,
        _found: Option<MaybeRef<'a, Kind>>,
        _span: SimpleSpan,
    ) -> Self {
        Problem(None)
    }
}
