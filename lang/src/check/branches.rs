//! Choices in outputs: values of the branch that is not taken need not exist.
//!
//! An output captures its values when its binding executes. In `if (n > 3) loads[3] else 0 N`, the
//! element exists only if the condition is true, so the capture is a choice by the same condition.
//! Other expressions capture the values of both branches, because `at` may select either one.

use super::tree::{Expr, Kind};
use super::types::{Store, Type};
use crate::ir::Op;

/// How the definition under construction, which is an output, captures values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum OutputCaptures {
    /// Before the output, in order.
    Stored,
    /// As operands of the output.
    Immediate,
}

/// A branch of a choice whose condition is known when the binding executes.
pub(super) struct Branch {
    pub condition: Expr,
    pub is_first: bool,
}

/// Returns `true` if the value of an expression exists for some values of its parts only.
pub(super) fn may_fail(e: &Expr) -> bool {
    let own = matches!(
        e.kind,
        Kind::Index(..) | Kind::Call(_) | Kind::CallExtern(..) | Kind::Sequence(..) | Kind::Standard(..)
    );
    own || e.children().into_iter().any(may_fail)
}

/// Returns `true` if an expression calls functions of the program or of the library.
pub(super) fn calls_functions(e: &Expr) -> bool {
    let own = matches!(e.kind, Kind::Call(_) | Kind::CallExtern(..) | Kind::Sequence(..));
    own || e.children().into_iter().any(calls_functions)
}

/// Returns a captured value as a choice by the conditions of the branches around it. Its value in
/// the other branches is not used.
pub(super) fn in_branches(value: Expr, store: &Store, branches: &[Branch]) -> Expr {
    if branches.is_empty() || !may_fail(&value) {
        return value;
    }
    let Some(unused) = unused_value(&value, store) else { return value };
    branches.iter().rev().fold(value, |value, branch| {
        let (ty, span) = (value.ty.clone(), value.span);
        let (first, second) = if branch.is_first { (value, unused.clone()) } else { (unused.clone(), value) };
        let kind = Kind::If(Box::new(branch.condition.clone()), Box::new(first), Box::new(second));
        Expr { kind, ty, span }
    })
}

/// Returns a value of the same type.
fn unused_value(value: &Expr, store: &Store) -> Option<Expr> {
    let number = |ty: Type| Expr { kind: Kind::Number(f64::NAN), ty, span: value.span };
    let kind = match store.shallow(&value.ty) {
        ty @ Type::Number(_) => return Some(number(ty)),
        Type::Vector(dim) => {
            let part = number(Type::Number(dim));
            Kind::Op(Op::Vector, vec![part.clone(), part.clone(), part])
        }
        Type::Bool => Kind::Bool(false),
        _ => return None,
    };
    Some(Expr { kind, ty: value.ty.clone(), span: value.span })
}
