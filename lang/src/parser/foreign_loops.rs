//! Parses loops over values in the form of other languages, so that one error states the form of
//! this language and the body is checked: `for x in values { }` and `for (x, y in values) { }`.

use super::expressions::Expressions;
use super::recovery::{Reader, advance_to, close, identifier, position, when};
use super::source::Source;
use super::{Problem, Rule};
use crate::ast::{Bind, Expr, ExprKind, Ident, Stmt, StmtKind, VarDecl};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use chumsky::prelude::*;

/// Parses `for x in values body`.
pub(super) fn without_parentheses<'a>(
    source: &'a Source<'a>,
    e: &Expressions<'a>,
    body: Rule<'a, Stmt>,
) -> Rule<'a, StmtKind> {
    let head = identifier(source).then_ignore(just(Kind::In)).then(e.values.clone());
    let head = head.map_with(move |(variable, values), extra| {
        let tokens: SimpleSpan = extra.span();
        let place = source.range(tokens);
        let fixed = format!("({})", source.text_of(place));
        extra.emit(
            Diagnostic::error("E0850", "the head of a loop is in parentheses", place, "without parentheses")
                .help(format!("write `for {fixed}`"))
                .fix("add parentheses", place, fixed)
                .into(),
        );
        (variable, values)
    });
    when(move |at| {
        source.kind(at) == Some(Kind::For)
            && source.kind(at + 1) == Some(Kind::Identifier)
            && source.kind(at + 2) == Some(Kind::In)
    })
    .ignore_then(just(Kind::For))
    .ignore_then(head)
    .then(body)
    .map(|((variable, values), body)| StmtKind::ForEach { variable, values, body: Box::new(body) })
    .boxed()
}

/// Parses `for (x, y in values) body`. The names are declared in the body without a value that is
/// known.
pub(super) fn several_names<'a>(
    source: &'a Source<'a>,
    e: &Expressions<'a>,
    body: Rule<'a, Stmt>,
) -> Rule<'a, StmtKind> {
    let names = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let Some(end) = end_of_names(source, at) else { return Err(Problem(None)) };
        advance_to(input, end);
        let is_name = |at: &usize| source.kind(*at) == Some(Kind::Identifier);
        Ok((at + 2..end).filter(is_name).map(|at| source.ident(at)).collect::<Vec<Ident>>())
    });
    names
        .then_ignore(just(Kind::In))
        .then(e.values.clone())
        .then_ignore(close(source, Kind::CloseParen, "`)`"))
        .then(body)
        .map_with(move |((names, values), body), extra| {
            let (Some(first), Some(last)) = (names.first(), names.last()) else { return StmtKind::Error };
            let place = first.span.to(last.span);
            let values_text = source.text_of(values.span());
            let parts: Vec<String> =
                names.iter().enumerate().map(|(at, name)| format!("{} = item[{at}]", name.name)).collect();
            let declared = format!("var {};", parts.join(", "));
            let mut problem = Diagnostic::error("E0850", "a loop declares one name", place, "several names")
                .help(format!("write `for (item in {values_text})`, and in its body `{declared}`"));
            // The head up to the first statement of the body.
            if let StmtKind::Block(_) = &body.kind {
                let open = crate::span::Span { end: body.span.start + 1, ..body.span };
                let fixed = format!("item in {values_text}) {{ {declared}");
                problem = problem.suggest("take the parts of each element", first.span.to(open), fixed);
            }
            extra.emit(problem.into());
            let unknown = |name: Ident| {
                let value = Expr { kind: ExprKind::Error, span: name.span };
                VarDecl { name, init: Some((Bind::Evaluate, value)) }
            };
            let variable =
                Ident { name: "item".into(), span: crate::span::Span { end: place.start, ..place } };
            let declares = StmtKind::Var(names.into_iter().map(unknown).collect());
            let declares = Stmt { kind: declares, span: place, doc: None, private: false };
            let span = body.span;
            let body = Stmt { kind: StmtKind::Block(vec![declares, body]), span, doc: None, private: false };
            StmtKind::ForEach { variable, values, body: Box::new(body) }
        })
        .boxed()
}

/// Returns the index after the names of `for (x, y in`.
fn end_of_names(source: &Source<'_>, at: usize) -> Option<usize> {
    if source.kind(at) != Some(Kind::For) || source.kind(at + 1) != Some(Kind::OpenParen) {
        return None;
    }
    let mut end = at + 3;
    while source.kind(end) == Some(Kind::Comma) && source.kind(end + 1) == Some(Kind::Identifier) {
        end += 2;
    }
    let is_list = source.kind(at + 2) == Some(Kind::Identifier) && end > at + 3;
    (is_list && source.kind(end) == Some(Kind::In)).then_some(end)
}
