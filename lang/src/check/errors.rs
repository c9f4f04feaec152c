//! Checks `throw`, `try` and `catch`.

use super::dependence::Region;
use super::infer::Checker;
use super::symbols::Resolution;
use super::tree::*;
use super::types::Type;
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl<'a> Checker<'a> {
    /// Returns the type of the variable of `catch`: the record `Error` of the prelude, even if the
    /// model declares another `Error`.
    pub(super) fn error_type(&self) -> Type {
        let prelude = self.modules.get(1).map(|module| module.file);
        let mut records = self.names.records.iter();
        let at = records.position(|record| record.decl.name.name == "Error" && Some(record.file) == prelude);
        at.map_or(Type::Error, |at| Type::Record(RecordId(at as u32)))
    }

    pub(super) fn throw(&mut self, value: Option<&'a ast::Expr>, span: Span) -> StmtKind {
        let Some(value) = value else {
            if self.handlers == 0 {
                self.report(
                    Diagnostic::error(
                        "E0216",
                        "there is no error to rethrow here",
                        span,
                        "outside a `catch`",
                    )
                    .help(
                        "write `throw \"...\";`; `throw;` is only for a `catch`, whose error it throws again",
                    ),
                );
                return StmtKind::Nothing;
            }
            self.dependence.may_fail(None);
            self.dependence.leave_function();
            return StmtKind::Throw(None);
        };
        let value = self.as_value(|c| c.expr(value));
        let kind = ConstraintKind::Throwable(value.ty.clone());
        self.constrain(Constraint { kind, span: value.span });
        self.dependence.thrown(&value);
        self.dependence.may_fail(None);
        self.dependence.leave_function();
        StmtKind::Throw(Some(value))
    }

    pub(super) fn try_catch(
        &mut self,
        body: &'a ast::Stmt,
        error: Option<&'a ast::Ident>,
        handler: &'a ast::Stmt,
    ) -> StmtKind {
        let error = error.and_then(|name| match self.names.uses.get(&name.span) {
            Some(Resolution::Var(id)) => Some(*id),
            _ => None,
        });
        self.dependence.open(Region::Try);
        let (tried, handled) = self.either(
            |c| c.boxed(body),
            |c| {
                c.dependence.handle();
                if let Some(id) = error {
                    let (ty, caught) = (c.variable_type(id), c.error_type());
                    // A fresh type variable unifies with any type.
                    let _ = c.store.unify(&ty, &caught);
                    c.dependence.declare(id);
                    c.dependence.caught(id);
                }
                c.handlers += 1;
                let handled = c.after_part_of(body, |c| c.boxed(handler));
                c.handlers -= 1;
                handled
            },
        );
        self.dependence.close();
        StmtKind::Try { body: tried, error, handler: handled }
    }
}
