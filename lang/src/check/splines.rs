//! Checks `spline(xs, ys, x)`: the natural cubic spline through points.
//!
//! The coefficients of constant points are data of the kernel. Those of other points are computed
//! when the expression is bound; the kernel receives the number of their table.

use super::constant;
use super::infer::Checker;
use super::names::points_span;
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
        let abscissas = xs.span;
        let points = match self.captured_points(points_span(xs, ys), &across, &along) {
            Some(table) => Err(table),
            None => Ok(self.points([xs, ys], &across, &along)),
        };
        let x = self.as_symbolic(|c| c.expr(x));
        let cause = Some((abscissas, "the spline has these abscissas".to_string()));
        self.expect(&across, &x, "the argument of the spline", cause);
        let kind = match points {
            Ok([xs, ys]) if has_constant_points(&xs) && has_constant_points(&ys) => {
                Kind::Spline(Box::new([xs, ys, x]))
            }
            Ok(points) => Kind::Op(Op::Spline, vec![table_of(points), x]),
            Err(table) => Kind::Op(Op::Spline, vec![table, x]),
        };
        let spline = Expr { kind, ty: along, span };
        if self.symbolic { spline } else { self.evaluate_now(spline, "spline") }
    }

    /// Checks the points of a spline, whose abscissas and ordinates have these types.
    fn points(&mut self, [xs, ys]: [&'a ast::Expr; 2], across: &Type, along: &Type) -> [Expr; 2] {
        [(xs, across, "xs"), (ys, along, "ys")].map(|(written, ty, name)| {
            let points = self.as_value(|c| c.whole(written));
            self.expect(&Type::array(ty.clone()), &points, format_args!("`{name}`"), None);
            points
        })
    }

    /// Returns the table of a spline whose points the current anonymous function captures.
    fn captured_points(&mut self, points: Span, across: &Type, along: &Type) -> Option<Expr> {
        let id = *self.names.captured.get(&(self.function, points))?;
        let ty = Type::Tuple(vec![across.clone(), along.clone()]);
        let captured = Expr { kind: Kind::Var(id), ty: self.variable_type(id), span: points };
        self.expect(&ty, &captured, "the points of the spline", None);
        Some(Expr { kind: Kind::TupleElement(Box::new(captured), 0), ty: Type::number(), span: points })
    }

    /// Checks the points of a spline that an anonymous function captures. Their value is the number
    /// of their table; its type has the dimensions of the abscissas and of the ordinates.
    pub(super) fn captured_spline(&mut self, spline: &'a ast::Expr) -> Expr {
        let ast::ExprKind::Call { arguments, .. } = &spline.kind else { return Expr::error(spline.span) };
        let Some([xs, ys, _]) = self.plain("spline", arguments, spline.span, ["xs", "ys", "x"]) else {
            return Expr::error(spline.span);
        };
        let span = points_span(xs, ys);
        let (across, along) = (self.fresh_number(), self.fresh_number());
        let ty = Type::Tuple(vec![across.clone(), along.clone()]);
        // The anonymous function may be inside another one, which captures the points first.
        if let Some(&id) = self.names.captured.get(&(self.function, span)) {
            let captured = Expr { kind: Kind::Var(id), ty: self.variable_type(id), span };
            self.expect(&ty, &captured, "the points of the spline", None);
            return captured;
        }
        let table = Expr { ty: across.clone(), ..table_of(self.points([xs, ys], &across, &along)) };
        let zero = Expr { kind: Kind::Number(0.0), ty: along, span };
        Expr { kind: Kind::Tuple(vec![table, zero]), ty, span }
    }
}

/// Returns the number of the table of computed points.
fn table_of([xs, ys]: [Expr; 2]) -> Expr {
    let span = Span { end: ys.span.end, ..xs.span };
    let kind = Kind::Standard(Standard::SplineTable, vec![xs, ys]);
    Expr { kind, ty: Type::number(), span }
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
