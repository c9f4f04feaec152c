//! Expressions as values: a frame that depends on `Time` is stored in an array or a record, and is
//! a part of the expressions that read it. The type of such a value is `Symbolic(T)`.
//!
//! The value is a site of its own, with two derivatives with respect to `Time`. A use within a `:=`
//! captures the value, so indices of arrays may be known at run time only.

use super::expr::Position;
use super::infer::{Checker, Reaching};
use super::symbols::{Resolution, VarKind};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, ExprKind};

impl<'a> Checker<'a> {
    /// Checks an element of brackets. The name of a frame that depends on `Time` is stored as an
    /// expression.
    pub(super) fn element(&mut self, e: &'a ast::Expr, given: Position) -> Expr {
        match self.stored_expression(e) {
            Some(stored) => stored,
            None => self.expr_at(e, given),
        }
    }

    /// Checks a value for a place of the type `Symbolic(T)`, or the name of a frame that depends on
    /// `Time`. Returns `None` for any other value.
    pub(super) fn expression_for(&mut self, ty: &Type, e: &'a ast::Expr) -> Option<Expr> {
        if self.symbolic {
            return None;
        }
        let Type::Symbolic(inner) = self.store.shallow(ty) else { return self.stored_expression(e) };
        // A stored expression, such as an element of an array.
        if let Some(known) = self.written_type(e)
            && matches!(self.store.shallow(&known), Type::Symbolic(_))
        {
            return None;
        }
        let value = self.as_symbolic(|c| c.whole(e));
        self.expect(&inner, &value, "the expression", None);
        Some(self.as_expression("expression", value))
    }

    fn stored_expression(&mut self, e: &'a ast::Expr) -> Option<Expr> {
        if self.symbolic {
            return None;
        }
        let mut written = e;
        while let ExprKind::Paren(inner) = &written.kind {
            written = inner;
        }
        let ExprKind::Name(name) = &written.kind else { return None };
        let Some(Resolution::Var(id)) = self.names.uses.get(&name.span).copied() else { return None };
        if self.variable(id).kind != VarKind::Symbolic || self.is_of_symbolic_function(id) {
            return None;
        }
        let depends = match self.reaching.get(&id) {
            Some(Reaching::One(def)) => {
                let def = &self.defs[def.0 as usize];
                def.on_time && !def.observes && matches!(self.store.known(&def.expr.ty), Type::Transform)
            }
            _ => false,
        };
        if !depends {
            return None;
        }
        let value = self.as_symbolic(|c| c.expr(e));
        Some(self.as_expression(&name.name, value))
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
