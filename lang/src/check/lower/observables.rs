//! Lowers operations on observables: each is a symbolic value, which the engine evaluates at every
//! step. Nested operations share one kernel.

use super::body::Body;
use super::sites::symbolic_binary;
use super::values::unary_op;
use crate::ast::{BinaryOp, UnaryOp};
use crate::check::tree::{Expr, Kind};
use crate::check::types::Type;
use crate::ir::{self, Capture, ExprKind, Site, SiteId, SymExpr, SymKind};
use crate::span::Span;
use calyx_abi::Repr;
use calyx_abi::units::to_si;

impl Body<'_, '_> {
    /// Returns `true` for an operation whose result is an observable.
    pub(super) fn is_observable_operation(&self, e: &Expr) -> bool {
        let operation = match &e.kind {
            Kind::Unary(UnaryOp::Minus, _) | Kind::Op(..) => true,
            Kind::Binary(op, ..) => !op.compares() && !matches!(op, BinaryOp::And | BinaryOp::Or),
            _ => false,
        };
        let store = &self.lowering.checker.store;
        operation && matches!(store.known(&self.types.ty(store, &e.ty)), Type::Observable(_))
    }

    /// Lowers an operation on observables.
    pub(super) fn observable_operation(&mut self, e: &Expr) -> ir::Expr {
        let mut operands = Vec::new();
        let expr = self.observable_tree(e, &mut operands);
        let last = operands.iter().rposition(|operand| self.needs_statements(operand));
        let (mut captures, mut values) = (Vec::new(), Vec::new());
        for (index, operand) in operands.into_iter().enumerate() {
            let value = self.value(operand);
            let value = if last.is_some_and(|last| index < last) { self.kept(value) } else { value };
            captures.push(Capture {
                name: match operand.kind {
                    Kind::Var(id) => self.lowering.checker.variable(id).name.to_string(),
                    _ => "observable".into(),
                },
                observable: matches!(value.repr, Repr::Symbolic(_)),
                repr: value.repr.clone(),
            });
            values.push(value);
        }
        self.make_site("observable", expr, captures, values, e.span)
    }

    /// Applies `+`, `-`, `*` or `/` to two values of which one is an observable.
    pub(super) fn observable_binary(
        &mut self,
        op: BinaryOp,
        a: ir::Expr,
        b: ir::Expr,
        span: Span,
    ) -> ir::Expr {
        let expr = symbolic_binary(op, capture(0, span), capture(1, span), span);
        self.applied(expr, vec![a, b], span)
    }

    /// Applies a sign to an observable.
    pub(super) fn observable_unary(&mut self, op: UnaryOp, a: ir::Expr, span: Span) -> ir::Expr {
        let Some(op) = unary_op(op, &Repr::Number) else { return a };
        let kind = SymKind::Op(op, vec![capture(0, span)]);
        self.applied(SymExpr { kind, repr: Repr::Number, span }, vec![a], span)
    }

    fn applied(&mut self, expr: SymExpr, values: Vec<ir::Expr>, span: Span) -> ir::Expr {
        let captures = values.iter().map(|value| Capture {
            name: "observable".into(),
            observable: matches!(value.repr, Repr::Symbolic(_)),
            repr: value.repr.clone(),
        });
        self.make_site("observable", expr, captures.collect(), values, span)
    }

    /// Adds a site that is evaluated at every step, and executes it.
    fn make_site(
        &mut self,
        name: &str,
        expr: SymExpr,
        captures: Vec<Capture>,
        values: Vec<ir::Expr>,
        span: Span,
    ) -> ir::Expr {
        let site = SiteId(self.lowering.program.sites.len() as u32);
        self.lowering.program.sites.push(Site {
            name: name.into(),
            shared: Vec::new(),
            expr,
            captures,
            repr: Repr::Number,
            order: 0,
            part: false,
            span,
        });
        let kind = ExprKind::MakeSymbolic { site, captures: values };
        ir::Expr { kind, repr: Repr::Symbolic(Box::new(Repr::Number)), span }
    }

    /// Returns the symbolic form of an operation, and collects its operands in order.
    fn observable_tree<'e>(&mut self, e: &'e Expr, operands: &mut Vec<&'e Expr>) -> SymExpr {
        let span = e.span;
        let make = |kind| SymExpr { kind, repr: Repr::Number, span };
        match &e.kind {
            Kind::Number(value) => make(SymKind::Number(*value)),
            Kind::Bare(value, dim, system) => {
                make(SymKind::Number(to_si(*value, self.bare_factor(dim, *system))))
            }
            Kind::Unary(op, a) if self.is_observable_operation(e) => {
                let a = self.observable_tree(a, operands);
                match unary_op(*op, &a.repr) {
                    None => a,
                    Some(op) => make(SymKind::Op(op, vec![a])),
                }
            }
            Kind::Binary(op, a, b) if self.is_observable_operation(e) => {
                let a = self.observable_tree(a, operands);
                let b = self.observable_tree(b, operands);
                symbolic_binary(*op, a, b, span)
            }
            Kind::Op(op, all) if self.is_observable_operation(e) => {
                let all = all.iter().map(|a| self.observable_tree(a, operands)).collect();
                make(SymKind::Op(*op, all))
            }
            _ => {
                operands.push(e);
                make(SymKind::Capture(operands.len() as u32 - 1))
            }
        }
    }
}

fn capture(index: u32, span: Span) -> SymExpr {
    SymExpr { kind: SymKind::Capture(index), repr: Repr::Number, span }
}
