//! Compile-time evaluation of constant expressions: exponents, ranges, duplicate cases.

use super::tree::{Expr, Kind};
use super::types::{Store, Type};
use crate::ast::{BinaryOp, UnaryOp};
use crate::ir::Op;
use calyx_abi::math;
use calyx_abi::units::to_si;

/// Returns the value, in SI units, of an expression that consists of literals.
pub fn number(e: &Expr, store: &Store) -> Option<f64> {
    evaluated(e, store, false)
}

/// Returns the same value for an expression in a function whose call is lowered. A literal whose
/// dimension the call does not determine has none.
pub fn number_in_call(e: &Expr, store: &Store) -> Option<f64> {
    evaluated(e, store, true)
}

fn evaluated(e: &Expr, store: &Store, in_call: bool) -> Option<f64> {
    let number = |e: &Expr| evaluated(e, store, in_call);
    Some(match &e.kind {
        Kind::Number(value) => *value,
        Kind::Bare(value, dim, system) => {
            let dim = store.dim(dim);
            let dimension = dim.as_known().or(in_call.then_some(dim.fixed))?;
            to_si(*value, system.unit_of(dimension.without_own()).factor)
        }
        Kind::Unary(UnaryOp::Minus, a) => -number(a)?,
        Kind::Unary(UnaryOp::Plus, a) => number(a)?,
        Kind::Op(op, all) => {
            let all: Option<Vec<f64>> = all.iter().map(number).collect();
            operation(*op, &all?)?
        }
        Kind::If(condition, a, b) => number(if truth(condition, store, in_call)? { a } else { b })?,
        Kind::Binary(op, a, b) => {
            let (a, b) = (number(a)?, number(b)?);
            match op {
                BinaryOp::Add => a + b,
                BinaryOp::Subtract => a - b,
                BinaryOp::Multiply => a * b,
                BinaryOp::Divide => a / b,
                BinaryOp::Power => math::pow(a, b),
                _ => return None,
            }
        }
        _ => return None,
    })
}

/// Returns the constant number or truth value of an expression, as a literal.
pub fn scalar(e: &Expr, store: &Store) -> Option<Kind> {
    truth(e, store, false).map(Kind::Bool).or_else(|| number(e, store).map(Kind::Number))
}

/// Returns the truth value of an expression that consists of literals.
fn truth(e: &Expr, store: &Store, in_call: bool) -> Option<bool> {
    let numbers = |a, b| evaluated(a, store, in_call).zip(evaluated(b, store, in_call));
    Some(match &e.kind {
        Kind::Bool(value) => *value,
        Kind::Unary(UnaryOp::Not, a) => !truth(a, store, in_call)?,
        Kind::Binary(BinaryOp::And, a, b) => truth(a, store, in_call)? && truth(b, store, in_call)?,
        Kind::Binary(BinaryOp::Or, a, b) => truth(a, store, in_call)? || truth(b, store, in_call)?,
        Kind::Binary(op, a, b) => {
            let (a, b) = numbers(a, b)?;
            match op {
                BinaryOp::Less => a < b,
                BinaryOp::LessEqual => a <= b,
                BinaryOp::Greater => a > b,
                BinaryOp::GreaterEqual => a >= b,
                BinaryOp::Equal => a == b,
                BinaryOp::NotEqual => a != b,
                _ => return None,
            }
        }
        _ => return None,
    })
}

/// Evaluates an operation on constants.
fn operation(op: Op, all: &[f64]) -> Option<f64> {
    let &first = all.first()?;
    let second = all.get(1).copied().unwrap_or(first);
    Some(match op {
        Op::Sqrt => math::sqrt(first),
        Op::Abs => math::abs(first),
        Op::Sin => math::sin(first),
        Op::Cos => math::cos(first),
        Op::Tan => math::tan(first),
        Op::Asin => math::asin(first),
        Op::Acos => math::acos(first),
        Op::Atan => math::atan(first),
        Op::Exp => math::exp(first),
        Op::Log => math::log(first),
        Op::Floor => math::floor(first),
        Op::Ceil => math::ceil(first),
        Op::Round => math::round(first),
        Op::Atan2 => math::atan2(first, second),
        Op::Min => math::min(first, second),
        Op::Max => math::max(first, second),
        _ => return None,
    })
}

/// Returns the text of a string literal.
pub fn text(e: &Expr) -> Option<&str> {
    match &e.kind {
        Kind::Text(text) => Some(text),
        _ => None,
    }
}

/// Returns `true` if two constant expressions are equal.
pub fn equal(a: &Expr, b: &Expr, store: &Store) -> bool {
    match (&a.kind, &b.kind) {
        (Kind::Bool(a), Kind::Bool(b)) => a == b,
        (Kind::Text(a), Kind::Text(b)) => a == b,
        _ => match (store.shallow(&a.ty), number(a, store), number(b, store)) {
            (Type::Number(_), Some(a), Some(b)) => a == b,
            _ => false,
        },
    }
}
