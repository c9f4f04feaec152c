//! Checks the axes of rotations. The axis must be a unit vector, because another vector would scale
//! the frame.
//!
//! The compiler checks constant axes. A computed axis is checked when the rotation, or the `:=`
//! that captures the axis, is executed. An axis with symbols has no value at that time: if it is
//! not a unit vector, the frame is NaN, and the engine reports an error.

use super::constant;
use super::infer::Checker;
use super::tree::{Expr, Kind};
use super::types::Store;
use crate::ast::{BinaryOp, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::ir::Op;

impl Checker<'_> {
    /// Checks an axis, or inserts a check at run time.
    pub(super) fn check_axis(&mut self, axis: &mut Expr) {
        let Some([x, y, z]) = vector(axis, &self.store) else {
            let (ty, span) = (axis.ty.clone(), axis.span);
            let inner = std::mem::replace(axis, Expr::error(span));
            *axis = Expr { kind: Kind::UnitAxis(Box::new(inner)), ty, span };
            return;
        };
        let length = (x * x + y * y + z * z).sqrt();
        if !calyx_abi::math::is_unit(length) {
            let help = match length > 0.0 {
                true => "divide it by its length",
                false => "give it a direction, such as `e3`",
            };
            let diagnostic = Diagnostic::error(
                "E0515",
                format!("the axis of a rotation must be a unit vector, and this one has the length {length}"),
                axis.span,
                "not of length 1",
            )
            .help(help);
            let text = self.text(axis.span);
            let unit = format!("({text}) / norm({text})");
            self.report(match length > 0.0 {
                true => diagnostic.suggest("divide it by its length", axis.span, unit),
                false => diagnostic.suggest("rotate about `e3`", axis.span, "e3"),
            });
        }
    }
}

/// Returns `true` if an expression has symbols and therefore no value when it is bound.
pub(super) fn has_symbols(e: &Expr) -> bool {
    let itself = matches!(
        e.kind,
        Kind::Time
            | Kind::Param(_)
            | Kind::Def(_)
            | Kind::Chosen(_)
            | Kind::SymbolicCall(_)
            | Kind::Applied(_)
            | Kind::At(..)
            | Kind::Derivative(..)
            | Kind::Gradient(..)
            | Kind::Observe(_)
            | Kind::Part(_)
            | Kind::Spline(_)
            | Kind::Error
    );
    itself || e.children().into_iter().any(has_symbols)
}

/// Returns the components of a vector of literals.
fn vector(e: &Expr, store: &Store) -> Option<[f64; 3]> {
    let both = |a: [f64; 3], b: [f64; 3], f: fn(f64, f64) -> f64| [0, 1, 2].map(|i| f(a[i], b[i]));
    match &e.kind {
        Kind::Op(Op::Vector, parts) => {
            let [x, y, z] = parts.as_slice() else { return None };
            Some([constant::number(x, store)?, constant::number(y, store)?, constant::number(z, store)?])
        }
        Kind::Unary(UnaryOp::Minus, a) => Some(vector(a, store)?.map(|x| -x)),
        Kind::Binary(BinaryOp::Add, a, b) => Some(both(vector(a, store)?, vector(b, store)?, |a, b| a + b)),
        Kind::Binary(BinaryOp::Subtract, a, b) => {
            Some(both(vector(a, store)?, vector(b, store)?, |a, b| a - b))
        }
        Kind::Binary(BinaryOp::Multiply, a, b) => match (vector(a, store), vector(b, store)) {
            (Some(v), None) => {
                let factor = constant::number(b, store)?;
                Some(v.map(|x| x * factor))
            }
            (None, Some(v)) => {
                let factor = constant::number(a, store)?;
                Some(v.map(|x| x * factor))
            }
            _ => None,
        },
        Kind::Binary(BinaryOp::Divide, a, b) => {
            let divisor = constant::number(b, store)?;
            Some(vector(a, store)?.map(|x| x / divisor))
        }
        _ => None,
    }
}
