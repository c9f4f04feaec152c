//! Lowers `try`, `catch` and `throw`: errors are edges of the control-flow graph.

use super::body::Body;
use crate::check::tree::{Expr, Stmt, VarId};
use crate::ir::{self, ExprKind, Place, Statement, Terminator, error_repr};
use crate::span::Span;
use calyx_abi::Repr;

impl Body<'_, '_> {
    /// Lowers a `try` statement. Every block of the body has the handler as its error target; the
    /// handler's first statement takes the error.
    pub(super) fn try_catch(&mut self, body: &Stmt, error: Option<VarId>, handler: &Stmt) {
        let (on_error, after) = (self.new_block(), self.new_block());
        let span = handler.span;
        self.reach(on_error);
        let around = self.handler.replace(on_error);
        let inside = self.new_block();
        self.jump(inside);
        self.start(inside);
        self.nested(body);
        self.handler = around;
        self.jump(after);

        self.start(on_error);
        let caught = self.temporary(ir::Expr { kind: ExprKind::Catch, repr: Repr::Handle, span });
        if let Some(error) = error {
            let local = self.local(error);
            let value = ir::Expr { kind: ExprKind::Local(caught), repr: Repr::Handle, span };
            let kind = ExprKind::CaughtFields(Box::new(value));
            let value = ir::Expr { kind, repr: error_repr(), span };
            self.push(Statement::Assign { place: Place::whole(local, error_repr()), value, span });
        }
        self.caught.push(caught);
        self.nested(handler);
        self.caught.pop();
        self.jump(after);
        self.start(after);
    }

    pub(super) fn throw(&mut self, value: Option<&Expr>, span: Span) {
        let terminator = match value {
            Some(value) => {
                let value = self.value(value);
                let error = match value.repr {
                    Repr::String => error_of(text("", span), value, span),
                    _ => value,
                };
                Terminator::Throw { error, help: String::new(), span }
            }
            None => match self.caught.last() {
                Some(caught) => {
                    let kind = ExprKind::Local(*caught);
                    Terminator::Rethrow(ir::Expr { kind, repr: Repr::Handle, span })
                }
                // Already reported by the checker.
                None => return,
            },
        };
        self.end(terminator);
    }
}

/// The fields of an `Error` without place, value and help.
pub(super) fn error_of(code: ir::Expr, message: ir::Expr, span: Span) -> ir::Expr {
    let value = ir::Expr { kind: ExprKind::Number(f64::NAN), repr: Repr::Number, span };
    let fields = vec![code, message, text("", span), value, text("", span)];
    ir::Expr { kind: ExprKind::Tuple(fields), repr: error_repr(), span }
}

pub(super) fn text(text: &str, span: Span) -> ir::Expr {
    ir::Expr { kind: ExprKind::String(text.into()), repr: Repr::String, span }
}
