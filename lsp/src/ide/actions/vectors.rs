//! Actions that replace `*` of two vectors by one of their products.

use super::{Action, ActionRequest, fix};
use calyx_lang::ast::{BinaryOp, Expr, ExprKind};
use calyx_lang::diagnostic::Diagnostic;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    let vectors =
        problem.code == "E0304" && problem.help.as_deref().is_some_and(|help| help.contains("`dot(a, b)`"));
    if !vectors {
        return;
    }
    let place = problem.primary.span;
    let around = asked.around(place);
    let product = around.expressions().rev().find_map(|e| match &e.kind {
        ExprKind::Binary { op: BinaryOp::Multiply, op_span, left, right } if *op_span == place => {
            Some((e, left, right))
        }
        _ => None,
    });
    let Some((e, left, right)) = product else { return };
    let side = |e: &Expr| match &e.kind {
        ExprKind::Paren(inner) => asked.slice(inner.span),
        _ => asked.slice(e.span),
    };
    for function in ["dot", "cross"] {
        let call = format!("{function}({}, {})", side(left), side(right));
        found.push(fix(format!("Write `{call}`"), vec![asked.edit(e.span.start, e.span.end, call)]));
    }
}
