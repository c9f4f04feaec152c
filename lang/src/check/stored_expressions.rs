//! Expressions as values: a frame that depends on `Time` is stored in an array or a record, and is
//! a part of the expressions that read it. The type of such a value is `Symbolic(T)`.
//!
//! The value is a site of its own, with two derivatives with respect to `Time`. A use within a `:=`
//! captures the value, so indices of arrays may be known at run time only.

use super::builtins::{Builtin, Shape};
use super::expr::Position;
use super::infer::{Checker, Reaching};
use super::symbols::{Constant, Resolution, VarKind};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind};
use crate::walk::Node;

impl<'a> Checker<'a> {
    /// Checks an element of brackets. A frame that depends on `Time` is stored as an expression.
    pub(super) fn element(&mut self, e: &'a ast::Expr, given: Position) -> Expr {
        match self.stored_expression(e) {
            Some(stored) => stored,
            None => self.expr_at(e, given),
        }
    }

    /// Checks a value for a place of the type `Symbolic(T)`, or a frame that depends on `Time`.
    /// Returns `None` for any other value.
    pub(super) fn expression_for(&mut self, ty: &Type, e: &'a ast::Expr) -> Option<Expr> {
        if self.symbolic {
            return None;
        }
        let Type::Symbolic(inner) = self.store.shallow(ty) else { return self.stored_expression(e) };
        // A stored expression, such as an element of an array.
        if let Some(known) = self.written_type(e)
            && matches!(self.store.known(&known), Type::Symbolic(_))
        {
            return None;
        }
        let value = self.as_symbolic(|c| c.whole(e));
        self.expect(&inner, &value, "the expression", None);
        Some(self.as_expression("expression", value))
    }

    pub(super) fn stored_expression(&mut self, e: &'a ast::Expr) -> Option<Expr> {
        if self.symbolic {
            return None;
        }
        let mut written = e;
        while let ExprKind::Paren(inner) = &written.kind {
            written = inner;
        }
        let name = match &written.kind {
            ExprKind::Name(name) => name,
            // It is stored already, or a constant frame.
            ExprKind::Field { .. } | ExprKind::Index { .. } => return None,
            _ if self.is_frame(written) && self.moves(written) => {
                let value = self.as_symbolic(|c| c.expr(e));
                return Some(self.as_expression("frame", value));
            }
            _ => return None,
        };
        let Some(Resolution::Var(id)) = self.names.uses.get(&name.span).copied() else { return None };
        if self.variable(id).kind != VarKind::Symbolic || self.is_of_symbolic_function(id) {
            return None;
        }
        if !self.is_moving(id, true) {
            return None;
        }
        let value = self.as_symbolic(|c| c.expr(e));
        Some(self.as_expression(&name.name, value))
    }

    /// Returns `true` if a symbolic name depends on `Time`, and is a frame if one is asked for.
    fn is_moving(&self, id: VarId, frame: bool) -> bool {
        let Some(Reaching::One(def)) = self.reaching.get(&id) else { return false };
        let def = &self.defs[def.0 as usize];
        let is_frame = matches!(self.store.known(&def.expr.ty), Type::Transform);
        def.on_time && !def.observes && (is_frame || !frame)
    }

    /// Returns `true` if an expression is a frame by its form: a product of frames, a stored frame,
    /// `Translate`, `Rotate`, `inverse`, or a call of a symbolic function that returns a frame.
    fn is_frame(&mut self, e: &ast::Expr) -> bool {
        match &e.kind {
            ExprKind::Paren(inner) => self.is_frame(inner),
            ExprKind::Binary { op: BinaryOp::Multiply, left, right, .. } => {
                self.is_frame(left) && self.is_frame(right)
            }
            ExprKind::Name(name) => match self.names.uses.get(&name.span).copied() {
                Some(Resolution::Var(id)) => self.is_moving(id, true) || self.known_frame(e).is_some(),
                _ => false,
            },
            ExprKind::Field { .. } | ExprKind::Index { .. } => self.known_frame(e).is_some(),
            ExprKind::Call { callee, .. } => {
                let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
                    return false;
                };
                match self.names.uses.get(&name.span).copied() {
                    Some(Resolution::Builtin(Builtin::Operation(signature))) => {
                        signature.result == Shape::Transform
                    }
                    Some(Resolution::Function(id)) => {
                        self.ensure_inferred(id);
                        let signature = self.signatures.get(&id);
                        signature
                            .is_some_and(|found| matches!(self.store.known(&found.result), Type::Transform))
                            && self.names.functions[id.0 as usize].is_symbolic()
                    }
                    _ => false,
                }
            }
            _ => false,
        }
    }

    /// Returns whether a variable, element or field is a frame that is stored as an expression;
    /// `None` if it is no frame.
    fn known_frame(&self, e: &ast::Expr) -> Option<bool> {
        match self.store.shallow(&self.written_type(e)?) {
            Type::Transform => Some(false),
            Type::Symbolic(inner) => matches!(self.store.known(&inner), Type::Transform).then_some(true),
            _ => None,
        }
    }

    /// Returns `true` if an expression contains `Time`, or a name, element or field that may depend
    /// on it.
    fn moves(&self, e: &ast::Expr) -> bool {
        if matches!(&e.kind, ExprKind::Name(_) | ExprKind::Field { .. } | ExprKind::Index { .. })
            && self.known_frame(e) == Some(true)
        {
            return true;
        }
        if let ExprKind::At { .. } | ExprKind::Anonymous(_) = &e.kind {
            return false;
        }
        if let ExprKind::Name(name) = &e.kind {
            return match self.names.uses.get(&name.span) {
                Some(Resolution::Constant(Constant::Time)) => true,
                Some(Resolution::Var(id)) => self.is_moving(*id, false),
                Some(Resolution::Function(id)) => self.depends_on_time(*id),
                _ => false,
            };
        }
        let mut found = false;
        Node::Expression(e).children(&mut |child| match child {
            Node::Expression(part) => found |= self.moves(part),
            Node::Argument(argument) => found |= self.moves(&argument.value),
            _ => {}
        });
        found
    }

    /// Converts a checked expression to a value of the type `Symbolic`.
    pub(super) fn as_expression(&mut self, name: &str, e: Expr) -> Expr {
        let (ty, span) = (Type::Symbolic(Box::new(e.ty.clone())), e.span);
        let def = self.make_def(name, e, span);
        self.defs[def.0 as usize].part = true;
        Expr { kind: Kind::MakeSymbolic(def), ty, span }
    }
}

/// Returns `true` for the types of expressions that are stored.
pub(super) fn is_stored(ty: &Type) -> bool {
    matches!(ty, Type::Number(_) | Type::Vector(_) | Type::Transform)
}
