//! Constant evaluation: values of constants, and of params at their defaults.

use calyx_abi::math;
use calyx_abi::units::to_si;
use calyx_lang::analysis::{NameKind, SourceRange};
use calyx_lang::ast::{BinaryOp, Expr, ExprKind, StmtKind, UnaryOp};
use calyx_lang::db::Database;
use calyx_lang::declared::{Declared, find};
use calyx_lang::dimension::Dimension;
use calyx_lang::units::{Unit, powered};
use std::sync::Arc;

/// Largest depth of references between constants.
const DEEPEST: usize = 20;

/// A number known from the text, in SI.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantValue {
    pub si: f64,
    pub dimension: Option<Dimension>,
}

/// Returns the value of the constant or param declared at a position; `None` if it is not numeric,
/// or its expression has more than literals, units, constants and builtin functions.
pub fn of_declaration(database: &Database, place: &SourceRange) -> Option<ConstantValue> {
    let file = Evaluation::new(database, &place.file, DEEPEST);
    let tree = database.around(&place.file, place.start)?;
    let (_, Declared::Statement(statement)) = find(&tree.module, place.start)? else { return None };
    let value = match &statement.kind {
        StmtKind::Const { value, .. } => value,
        StmtKind::Param(decl) => &decl.default,
        _ => return None,
    };
    let si = file.value(value)?;
    let typed = database.expressions(&place.file, value.span.start..value.span.end);
    let whole = typed.iter().find(|typed| (typed.start, typed.end) == (value.span.start, value.span.end));
    Some(ConstantValue { si, dimension: whole.and_then(|typed| typed.dimension) })
}

/// Scope of an evaluation.
struct Evaluation<'d> {
    database: &'d Database,
    file: Arc<str>,
    left: usize,
}

impl<'d> Evaluation<'d> {
    fn new(database: &'d Database, file: &str, left: usize) -> Evaluation<'d> {
        Evaluation { database, file: file.into(), left }
    }

    fn value(&self, e: &Expr) -> Option<f64> {
        match &e.kind {
            ExprKind::Number(value) => Some(self.bare(e, *value)),
            ExprKind::Quantity { value, unit, exponent, .. } => {
                let known = Unit::find(&unit.name)?;
                let unit = calyx_lang::ir::DisplayUnit {
                    name: String::new(),
                    factor: known.factor,
                    dimension: known.dimension.exponents(),
                };
                Some(to_si(*value, powered(&unit, *exponent)?.factor))
            }
            ExprKind::Paren(inner) => self.value(inner),
            ExprKind::Unary { op: UnaryOp::Plus, operand } => self.value(operand),
            ExprKind::Unary { op: UnaryOp::Minus, operand } => Some(-self.value(operand)?),
            ExprKind::Binary { op, left, right, .. } => {
                let (left, right) = (self.value(left)?, self.value(right)?);
                match op {
                    BinaryOp::Add => Some(left + right),
                    BinaryOp::Subtract => Some(left - right),
                    BinaryOp::Multiply => Some(left * right),
                    BinaryOp::Divide => Some(left / right),
                    BinaryOp::Power => Some(math::pow(left, right)),
                    _ => None,
                }
            }
            ExprKind::Name(name) => self.named(name.span.start, &name.name),
            ExprKind::Field { field, .. } => self.named(field.span.start, &field.name),
            ExprKind::Call { callee, arguments } => {
                let ExprKind::Name(name) = &callee.kind else { return None };
                let known = self.database.name_at(&self.file, name.span.start)?;
                let plain = arguments.iter().all(|argument| !argument.spread);
                let values: Option<Vec<f64>> =
                    arguments.iter().map(|argument| self.value(&argument.value)).collect();
                (known.kind == NameKind::Builtin && plain).then(|| called(&name.name, &values?)).flatten()
            }
            _ => None,
        }
    }

    /// Converts a literal without a unit: it is in the unit of the file's unit system for its
    /// dimension.
    fn bare(&self, e: &Expr, value: f64) -> f64 {
        let typed = self.database.expressions(&self.file, e.span.start..e.span.end);
        let here =
            typed.iter().find(|typed| (typed.start, typed.end) == (e.span.start, e.span.end) && typed.bare);
        match here.and_then(|typed| typed.dimension) {
            Some(dimension) => {
                let unit = self.database.system(&self.file).unwrap_or_default().unit_of(dimension);
                to_si(value, unit.factor)
            }
            None => value,
        }
    }

    fn named(&self, start: u32, text: &str) -> Option<f64> {
        let known = self.database.name_at(&self.file, start)?;
        match (known.kind, &known.declared) {
            (NameKind::Unit, None) => Some(Unit::find(text)?.factor),
            (NameKind::Constant, None) => match text {
                "pi" => Some(std::f64::consts::PI),
                "inf" => Some(f64::INFINITY),
                _ => None,
            },
            (NameKind::Const | NameKind::Param, Some(place)) => {
                let there = Evaluation::new(self.database, &place.file, self.left.checked_sub(1)?);
                let tree = self.database.around(&place.file, place.start)?;
                let (_, Declared::Statement(statement)) = find(&tree.module, place.start)? else {
                    return None;
                };
                match &statement.kind {
                    StmtKind::Const { value, .. } => there.value(value),
                    StmtKind::Param(decl) => there.value(&decl.default),
                    _ => None,
                }
            }
            _ => None,
        }
    }
}

/// Evaluates a builtin function.
fn called(name: &str, values: &[f64]) -> Option<f64> {
    match (name, values) {
        ("min", [first, rest @ ..]) => {
            Some(rest.iter().fold(*first, |least, value| math::min(least, *value)))
        }
        ("max", [first, rest @ ..]) => Some(rest.iter().fold(*first, |most, value| math::max(most, *value))),
        ("atan2", [y, x]) => Some(math::atan2(*y, *x)),
        (_, [x]) => {
            let function: fn(f64) -> f64 = match name {
                "sin" => math::sin,
                "cos" => math::cos,
                "tan" => math::tan,
                "asin" => math::asin,
                "acos" => math::acos,
                "atan" => math::atan,
                "exp" => math::exp,
                "log" => math::log,
                "sqrt" => math::sqrt,
                "abs" => math::abs,
                "floor" => math::floor,
                "ceil" => math::ceil,
                "round" => math::round,
                _ => return None,
            };
            Some(function(*x))
        }
        _ => None,
    }
}
