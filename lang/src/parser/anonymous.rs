//! Parses anonymous functions.

use super::recovery::{Reader, advance_to, position};
use super::source::Source;
use super::{Problem, Rule};
use crate::ast::{ANONYMOUS, Expr, ExprKind, FunctionBody, FunctionDecl, Ident, Mode, Parameter};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use chumsky::prelude::*;
use smol_str::format_smolstr;

/// Parses `(x, y) => e`.
pub(super) fn anonymous<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let header = custom(move |input: &mut Reader<'a, '_>| {
        let open = position(input);
        let Some(arrow) = arrow_after_names(source, open) else { return Err(Problem(None)) };
        if source.kind(open) != Some(Kind::OpenParen) {
            input.emit(without_parentheses(source, open).into());
        }
        advance_to(input, arrow + 1);
        let is_name = |at: &usize| source.kind(*at) == Some(Kind::Identifier);
        let names: Vec<usize> = (open..arrow).filter(is_name).collect();
        let shown: Vec<&str> = names.iter().map(|at| source.text(*at)).collect();
        let name =
            Ident { name: format_smolstr!("({}) {ANONYMOUS}", shown.join(", ")), span: source.place(arrow) };
        let parameter = |at| Parameter {
            mode: Mode::In,
            name: source.ident(at),
            former: None,
            annotation: None,
            default: None,
            former_none: None,
            domain: None,
            doc: None,
        };
        Ok((name, names.into_iter().map(parameter).collect::<Vec<_>>()))
    });
    let function = header.then(any).map(|((name, parameters), body)| {
        ExprKind::Anonymous(Box::new(FunctionDecl {
            name,
            former: None,
            parameters,
            result: None,
            body: FunctionBody::Symbolic(body),
            is_test: false,
            is_host: false,
            is_component: false,
        }))
    });
    function.map_with(|kind, extra| Expr { kind, span: source.range(extra.span()) }).boxed()
}

/// Returns the error for `x => e`.
fn without_parentheses(source: &Source<'_>, name: usize) -> Diagnostic {
    let (place, name) = (source.place(name), source.text(name));
    Diagnostic::error(
        "E0922",
        "the parameters of an anonymous function are written in parentheses",
        place,
        "without parentheses",
    )
    .help(format!("write `({name}) => ...`"))
    .fix(format!("write `({name})`"), place, format!("({name})"))
}

/// Returns the index of the `=>` after names in parentheses, or after one name without them.
fn arrow_after_names(source: &Source<'_>, open: usize) -> Option<usize> {
    if source.kind(open) == Some(Kind::Identifier) {
        return (source.kind(open + 1) == Some(Kind::FatArrow)).then_some(open + 1);
    }
    if source.kind(open) != Some(Kind::OpenParen) {
        return None;
    }
    let mut at = open + 1;
    while source.kind(at) == Some(Kind::Identifier) {
        at += 1;
        match source.kind(at) {
            Some(Kind::Comma) => at += 1,
            _ => break,
        }
    }
    let closes = source.kind(at) == Some(Kind::CloseParen) && source.kind(at + 1) == Some(Kind::FatArrow);
    closes.then_some(at + 1)
}
