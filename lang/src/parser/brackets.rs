//! Parses what is in square brackets: arrays, comprehensions, elements and slices.

use super::expressions::{may_begin, unit_after};
use super::operators::Suffix;
use super::recovery::{Reader, advance_to, close, identifier, position, when};
use super::source::Source;
use super::{Problem, Rule};
use crate::ast::{Comprehension, Expr, ExprKind, Values};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use chumsky::prelude::*;

/// Parses items up to a closing bracket; a trailing comma is allowed.
pub(super) fn items<'a, T: 'a>(source: &'a Source<'a>, item: Rule<'a, T>) -> Rule<'a, Vec<T>> {
    when(move |at| may_begin(source.kind(at)))
        .ignore_then(item)
        .separated_by(just(Kind::Comma))
        .allow_trailing()
        .collect()
        .boxed()
}

pub(super) fn list<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Vec<Expr>> {
    just(Kind::OpenBracket)
        .ignore_then(items(source, any))
        .then_ignore(close(source, Kind::CloseBracket, "`,` or `]`"))
        .boxed()
}

/// Parses `[a, b]`, `[a, b] mm` or `[e for x in values if c]`.
pub(super) fn brackets<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let whole = when(move |at| {
        source.kind(at) == Some(Kind::For)
            && source.kind(at + 1) == Some(Kind::Identifier)
            && source.kind(at + 2) == Some(Kind::In)
    })
    .ignore_then(just(Kind::For))
    .ignore_then(identifier(source))
    .then_ignore(just(Kind::In))
    .then(values(any.clone()))
    .then(just(Kind::If).ignore_then(any.clone()).or_not())
    .map(Some);
    let malformed = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        // `for (` begins a statement after brackets that are not closed.
        if source.kind(at) != Some(Kind::For) || source.kind(at + 1) == Some(Kind::OpenParen) {
            return Err(Problem(None));
        }
        let message = format!("`x in values` is expected after `for`, not {}", source.describe(at + 1));
        input.emit(
            Diagnostic::error("E0850", message, source.place(at + 1), "not expected here")
                .help("write the name of the element and the values: `[2 * x for x in xs]`")
                .into(),
        );
        let closes =
            |at| source.kind(at).is_none_or(|kind| matches!(kind, Kind::CloseBracket | Kind::Semicolon));
        let mut end = at;
        while !closes(end) {
            end = source.next(end);
        }
        advance_to(input, end);
        Ok(None)
    });
    let clause = whole.or(malformed);
    let inside = just(Kind::OpenBracket)
        .ignore_then(items(source, any))
        .then(clause.or_not())
        .then_ignore(close(source, Kind::CloseBracket, "`,` or `]`"));
    let unit = custom(move |input: &mut Reader<'a, '_>| Ok(unit_after(source, input)));
    let node = inside.then(unit).map_with(move |((elements, clause), unit), extra| {
        let span = source.range(extra.span());
        let kind = match (clause, unit) {
            (None, None) => ExprKind::List(elements),
            (None, Some((unit, exponent, exponent_span))) => {
                ExprKind::Measured { elements, unit, exponent, exponent_span }
            }
            // Already reported.
            (Some(None), _) => ExprKind::Error,
            (Some(Some(((variable, values), condition))), unit) => {
                let mut elements = elements.into_iter();
                let (message, place, help) = match (elements.next(), elements.next(), unit) {
                    (Some(element), None, None) => {
                        let parts = Comprehension { element, variable, values, condition };
                        return Expr { kind: ExprKind::Comprehension(Box::new(parts)), span };
                    }
                    (_, _, Some((unit, ..))) => (
                        "a unit cannot follow a comprehension",
                        unit.span,
                        "write the unit at the element: `[x * 1 mm for x in xs]`",
                    ),
                    (None, ..) => (
                        "a comprehension needs an element before `for`",
                        span,
                        "write the value of each element: `[2 * x for x in xs]`",
                    ),
                    (_, Some(second), None) => (
                        "a comprehension has one element",
                        second.span,
                        "write brackets around the values of one element: `[[x, 2 * x] for x in xs]`",
                    ),
                };
                let problem = Diagnostic::error("E0850", message, place, "not expected here");
                extra.emit(problem.help(help).into());
                ExprKind::Error
            }
        };
        Expr { kind, span }
    });
    node.boxed()
}

/// Parses `array` or `low .. high`.
pub(super) fn values<'a>(any: Rule<'a, Expr>) -> Rule<'a, Values> {
    let high = just(Kind::DotDot).ignore_then(any.clone()).or_not();
    any.then(high)
        .map(|(first, high)| match high {
            Some(high) => Values::Range(first, high),
            None => Values::Elements(first),
        })
        .boxed()
}

/// Parses `[index]` or `[low .. high]` after an operand.
pub(super) fn element<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Suffix> {
    let limit = when(move |at| may_begin(source.kind(at))).ignore_then(any.clone()).or_not();
    // `[low:high]`, as in other languages.
    let colon = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Colon) {
            return Err(Problem(None));
        }
        input.next();
        let place = source.place(at);
        input.emit(
            Diagnostic::error(
                "E0115",
                "the limits of a slice are separated by `..`",
                place,
                "not expected here",
            )
            .help("write `array[low .. high]`, which excludes the element at `high`")
            .fix("write `..`", place, " .. ")
            .into(),
        );
        Ok(())
    });
    let high = just(Kind::DotDot).ignored().or(colon).ignore_then(limit).boxed();
    let from_start = high.clone().map(|high| Suffix::Slice(None, high));
    let other = any.then(high.or_not()).map(|(first, high)| match high {
        Some(high) => Suffix::Slice(Some(first), high),
        None => Suffix::Index(first),
    });
    just(Kind::OpenBracket)
        .ignore_then(from_start.or(other))
        .then_ignore(close(source, Kind::CloseBracket, "`]`"))
        .boxed()
}
