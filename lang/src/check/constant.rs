//! Values known at compile time: exponents, ranges, duplicate cases.

use super::tree::{Expr, Kind};
use super::types::{Store, Type};
use crate::ast::{BinaryOp, UnaryOp};
use calyx_abi::math;

/// The number an expression stands for, in SI, if it is made of literals alone.
pub fn number(e: &Expr, store: &Store) -> Option<f64> {
    Some(match &e.kind {
        Kind::Number(value) => *value,
        Kind::Bare(value, dim, system) => {
            let dimension = store.dim(dim).as_known()?;
            value * system.unit_of(dimension).factor
        }
        Kind::Unary(UnaryOp::Minus, a) => -number(a, store)?,
        Kind::Unary(UnaryOp::Plus, a) => number(a, store)?,
        Kind::Binary(op, a, b) => {
            let (a, b) = (number(a, store)?, number(b, store)?);
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

/// The text an expression stands for, if it is a plain literal.
pub fn text(e: &Expr) -> Option<&str> {
    match &e.kind {
        Kind::Text(text) => Some(text),
        _ => None,
    }
}

/// Whether two constant expressions are known to be equal.
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
