//! Checks `spline(xs, ys, x)`: the natural cubic spline through points.
//!
//! The coefficients of constant points are data of the kernel. Those of other points are computed
//! when the expression is bound; the kernel receives the number of their table.

use super::constant;
use super::infer::Checker;
use super::tree::*;
use super::types::{Store, Type};
use crate::ast;
use crate::ir::Op;
use crate::span::Span;
use calyx_abi::piecewise::{natural_spline, refusal};

impl<'a> Checker<'a> {
    pub(super) fn spline(&mut self, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let Some([xs, ys, x]) = self.plain("spline", arguments, span, ["xs", "ys", "x"]) else {
            return Expr::error(span);
        };
        let (across, along) = (self.fresh_number(), self.fresh_number());
        let [xs, ys] = [(xs, &across, "xs"), (ys, &along, "ys")].map(|(written, ty, name)| {
            let points = self.as_value(|c| c.whole(written));
            self.expect(&Type::array(ty.clone()), &points, &format!("`{name}`"), None);
            points
        });
        let x = self.as_symbolic(|c| c.expr(x));
        let cause = Some((xs.span, "the spline has these abscissas".to_string()));
        self.expect(&across, &x, "the argument of the spline", cause);
        let is_constant = has_constant_points(&xs) && has_constant_points(&ys);
        let kind = match is_constant {
            true => Kind::Spline(Box::new([xs, ys, x])),
            false => {
                let place = Span { end: ys.span.end, ..xs.span };
                let table = Kind::Standard(Standard::SplineTable, vec![xs, ys]);
                let table = Expr { kind: table, ty: Type::number(), span: place };
                Kind::Op(Op::Spline, vec![table, x])
            }
        };
        let spline = Expr { kind, ty: along, span };
        if self.symbolic { spline } else { self.evaluate_now(spline, "spline") }
    }
}

/// Returns `true` for brackets of constant numbers, and for invalid points, which are reported.
fn has_constant_points(points: &Expr) -> bool {
    match &points.kind {
        Kind::Error => true,
        Kind::Array(all) => all.iter().all(is_constant),
        _ => false,
    }
}

/// Returns `true` for literals and operations on them. The dimension of a literal, and therefore
/// its value, may not be known yet.
fn is_constant(e: &Expr) -> bool {
    let operation = matches!(
        e.kind,
        Kind::Error
            | Kind::Number(_)
            | Kind::Bare(..)
            | Kind::Bool(_)
            | Kind::Unary(..)
            | Kind::Binary(..)
            | Kind::Op(..)
            | Kind::If(..)
    );
    operation && e.children().into_iter().all(is_constant)
}

/// Returns the table of a spline, or the reason why there is none. `None` stands for points that
/// are not constant, which is reported.
pub fn table(xs: &Expr, ys: &Expr, store: &Store) -> Option<Result<Vec<f64>, String>> {
    let numbers = |e: &Expr| match &e.kind {
        Kind::Array(all) => {
            all.iter().map(|e| constant::number_in_call(e, store)).collect::<Option<Vec<f64>>>()
        }
        _ => None,
    };
    let (xs, ys) = (numbers(xs)?, numbers(ys)?);
    Some(natural_spline(&xs, &ys).ok_or_else(|| refusal(&xs, &ys)))
}
