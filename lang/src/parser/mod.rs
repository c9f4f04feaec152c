//! Tokens to syntax tree: the grammar of tables 3.1 and 3.2 of the Calyx report, and what the language adds to it.
//!
//! Rules are chumsky parsers over token kinds. A rule decides by at most two tokens whether it applies; once it
//! does, it reports what is missing and goes on, so that one error hides no other and a tree always results.
//! Rules are boxed: unboxed ones make types that take minutes to compile.

mod declarations;
mod definitions;
mod expressions;
mod nesting;
mod recovery;
mod source;
mod statements;

use crate::ast::Module;
use crate::deep::deep;
use crate::diagnostic::Diagnostic;
use crate::lexer::{self, Kind, Tokens};
use crate::span::FileId;
use chumsky::error::{Error, LabelError};
use chumsky::prelude::*;
use chumsky::util::MaybeRef;
use source::Source;

/// The tree of a file and everything wrong with its text, in order of place.
pub fn parse(file: FileId, text: &str) -> (Module, Vec<Diagnostic>) {
    parse_tokens(file, text, &lexer::lex(file, text))
}

/// The same, for who needs the tokens too.
pub fn parse_tokens(file: FileId, text: &str, tokens: &Tokens) -> (Module, Vec<Diagnostic>) {
    let Tokens { tokens, docs, file_doc, diagnostics, .. } = tokens;
    let mut diagnostics = diagnostics.clone();
    let doc = file_doc.clone();
    let source = Source::new(file, text, tokens, docs);
    if let Some(too_deep) = nesting::too_deep(&source) {
        diagnostics.push(too_deep);
        return (Module { statements: Vec::new(), doc }, in_order(diagnostics));
    }
    let kinds: Vec<Kind> = tokens.iter().map(|t| t.kind).collect();
    let (statements, problems) =
        deep(|| statements::file(&source).parse(kinds.as_slice()).into_output_errors());
    let problems: Vec<Diagnostic> = problems.into_iter().filter_map(|p| p.0).map(|d| *d).collect();
    let problems = without_consequences(&source, &diagnostics, problems);
    diagnostics.extend(problems);
    (Module { statements: statements.unwrap_or_default(), doc }, in_order(diagnostics))
}

fn in_order(mut diagnostics: Vec<Diagnostic>) -> Vec<Diagnostic> {
    diagnostics.sort_by_key(|d| (d.primary.span.start, d.primary.span.end));
    diagnostics
}

/// Leaves out second errors at one place, and errors right after text that was no token.
fn without_consequences(
    source: &Source<'_>,
    lexical: &[Diagnostic],
    mut problems: Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    // A stable sort: of errors at one place the one found first explains it.
    problems.sort_by_key(|d| d.primary.span.start);
    problems.dedup_by_key(|d| d.primary.span.start);
    // `x = ` and another statement on the next line: the value is missing, and with it the `;`.
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
        // The last lexical error that begins at or before this place.
        let before = bad_text.partition_point(|span| span.start <= start);
        let Some(bad) = before.checked_sub(1).map(|i| bad_text[i]) else { return true };
        bad.end < start && !source.is_blank(bad.end, start)
    });
    problems
}

type Input<'a> = &'a [Kind];
type Extra = extra::Err<Problem>;
type Rule<'a, O> = Boxed<'a, 'a, Input<'a>, O, Extra>;

/// What a rule reports; empty where a rule does not apply, which another one will answer.
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
