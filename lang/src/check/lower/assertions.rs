//! Lowers assertions: the message of a failed comparison contains the values of its two sides.

use super::body::Body;
use super::values::binary;
use crate::check::tree::{Assertion, Expr, Kind};
use crate::ir::{self, ExprKind, FormatPart, Statement};
use crate::span::Span;
use calyx_abi::{Purity, Repr};

impl Body<'_, '_> {
    /// Lowers an `assert`. The message is evaluated only if the condition is false.
    pub(super) fn assertion(&mut self, assertion: &Assertion, span: Span) {
        let (condition, operands) = self.tested(assertion);
        let (holds, fails) = (self.new_block(), self.new_block());
        self.branch_on(condition, holds, fails);
        self.start(fails);
        let mut parts = Vec::new();
        self.format_part(&assertion.message, None, assertion.system, false, &mut parts);
        parts.extend(operands);
        let make = |kind, repr| ir::Expr { kind, repr, span };
        let message = make(ExprKind::Format(parts), Repr::String);
        let parameters = [("condition", Repr::Bool), ("message", Repr::String)];
        let id = self.lowering.standard("assert", Purity::Pure, &parameters, Repr::Unit);
        let arguments = vec![make(ExprKind::Bool(false), Repr::Bool), message];
        self.push(Statement::Eval(make(ExprKind::CallExtern(id, arguments), Repr::Unit)));
        self.jump(holds);
        self.start(holds);
    }

    /// Returns the condition and, if it compares two values, the text for the values of both sides.
    fn tested(&mut self, assertion: &Assertion) -> (ir::Expr, Vec<FormatPart>) {
        let condition = &assertion.condition;
        let (Kind::Binary(op, a, b), Some([left_text, right_text])) = (&condition.kind, &assertion.sides)
        else {
            return (self.value(condition), Vec::new());
        };
        // Stored, so that each side is evaluated once.
        let (left, right) = self.pair(a, b);
        let (left, right) = (self.kept(left), self.kept(right));
        let mut operands = Vec::new();
        for (text, side, value) in [(left_text, a, &left), (right_text, b, &right)] {
            let Some(text) = text.as_ref().filter(|_| !says_itself(side) && has_text(&value.repr)) else {
                continue;
            };
            let before = if operands.is_empty() { " (" } else { ", " };
            operands.push(FormatPart::Text(format!("{before}{text} is ")));
            let system = self.lowering.declared_system.unwrap_or(assertion.system);
            operands.push(FormatPart::Value(value.clone(), self.display(&side.ty, None, system)));
        }
        if !operands.is_empty() {
            operands.push(FormatPart::Text(")".into()));
        }
        (binary(*op, left, right, condition.span), operands)
    }
}

/// Returns `true` for literals, whose value is already in the text of the assertion.
fn says_itself(side: &Expr) -> bool {
    matches!(side.kind, Kind::Number(_) | Kind::Bare(..) | Kind::Bool(_) | Kind::Text(_))
}

fn has_text(repr: &Repr) -> bool {
    match repr {
        Repr::Number | Repr::Bool | Repr::String | Repr::Vector => true,
        Repr::Array(element) => has_text(element),
        _ => false,
    }
}
