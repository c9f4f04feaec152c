//! Checks `spline(xs, ys, x)`: the natural cubic spline through constant points.

use super::constant;
use super::infer::Checker;
use super::tree::*;
use super::types::{Store, Type};
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use calyx_abi::piecewise::natural_spline;

impl<'a> Checker<'a> {
    pub(super) fn spline(&mut self, arguments: &'a [ast::Argument], span: Span) -> Expr {
        let Some([xs, ys, x]) = self.plain("spline", arguments, span, ["xs", "ys", "x"]) else {
            return Expr::error(span);
        };
        let (across, along) = (self.fresh_number(), self.fresh_number());
        let [xs, ys] = [(xs, &across, "xs"), (ys, &along, "ys")].map(|(written, ty, name)| {
            let points = self.as_symbolic(|c| c.whole(written));
            self.expect(&Type::array(ty.clone()), &points, &format!("`{name}`"), None);
            self.check_constant_points(&points);
            points
        });
        let x = self.as_symbolic(|c| c.expr(x));
        let cause = Some((xs.span, "the spline has these abscissas".to_string()));
        self.expect(&across, &x, "the argument of the spline", cause);
        let spline = Expr { kind: Kind::Spline(Box::new([xs, ys, x])), ty: along, span };
        if self.symbolic { spline } else { self.evaluate_now(spline, "spline") }
    }

    fn check_constant_points(&mut self, points: &Expr) {
        let variable = match &points.kind {
            Kind::Error => None,
            Kind::Array(all) => all.iter().find(|point| !is_constant(point)),
            _ => Some(points),
        };
        if let Some(variable) = variable {
            self.report(
                Diagnostic::error(
                    "E0864",
                    "the points of a spline must be constant",
                    variable.span,
                    "known only when the program runs",
                )
                .help("write the numbers in brackets, or declare them with `const`"),
            );
        }
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
    Some(natural_spline(&xs, &ys).ok_or_else(|| {
        if xs.len() != ys.len() {
            return format!("the spline has {} abscissas and {} ordinates", xs.len(), ys.len());
        }
        if xs.len() < 2 {
            return "a spline needs at least two points".to_string();
        }
        match xs.windows(2).position(|pair| pair[0] >= pair[1]) {
            Some(at) => format!("the abscissas of a spline must ascend, and number {} does not", at + 2),
            None => "the points of a spline must be finite".to_string(),
        }
    }))
}
