//! The typed expressions at a source location, for editors.

use super::name_resolution::dimension;
use super::tree::{Expr, Kind, Stmt};
use super::typed::Typed;
use crate::analysis;
use crate::span::Span;

/// Returns the expressions that overlap a range. Locations refer to the unit's excerpt.
pub fn touching(typed: &Typed, range: Span) -> Vec<analysis::Typed> {
    let mut found = Vec::new();
    let mut collect = |e: &Expr| found.push(shown(typed, e));
    for function in typed.functions.values() {
        let around = function.span;
        if around.file == range.file && around.start <= range.end && range.start <= around.end {
            function.body.iter().for_each(|s| statement(s, range, &mut collect));
        }
    }
    for def in typed.defs.iter() {
        expression(&def.expr, range, &mut collect);
        def.captures.iter().for_each(|(_, value)| expression(value, range, &mut collect));
    }
    for param in typed.params.iter() {
        [Some(&param.default), param.low.as_ref(), param.high.as_ref()]
            .into_iter()
            .flatten()
            .for_each(|e| expression(e, range, &mut collect));
    }
    typed.consts.iter().for_each(|e| expression(e, range, &mut collect));
    found
}

fn touches(span: Span, range: Span) -> bool {
    let written = span.start < span.end;
    written && span.file == range.file && span.start <= range.end && range.start <= span.end
}

fn statement(s: &Stmt, range: Span, collect: &mut dyn FnMut(&Expr)) {
    s.walk(&mut |s| {
        if touches(s.span, range) {
            s.expressions().into_iter().for_each(|e| expression(e, range, collect));
        }
    });
}

fn expression(e: &Expr, range: Span, collect: &mut dyn FnMut(&Expr)) {
    // The text of a default argument is elsewhere.
    if !touches(e.span, range) {
        return;
    }
    if !matches!(e.kind, Kind::Error) {
        collect(e);
    }
    e.children().into_iter().for_each(|child| expression(child, range, collect));
}

fn shown(typed: &Typed, e: &Expr) -> analysis::Typed {
    analysis::Typed {
        start: e.span.start,
        end: e.span.end,
        ty: typed.store.show(&e.ty),
        dimension: dimension(&typed.store, &e.ty),
        bare: matches!(e.kind, Kind::Bare(..)),
    }
}
