//! Checks the block body of a symbolic function, `:= { var a = e; return e; }`: names for
//! expressions, and the result.

use super::infer::Checker;
use super::symbols::{FunctionInfo, Resolution};
use super::tree::*;
use crate::ast::{self, Bind, StmtKind};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl<'a> Checker<'a> {
    /// Checks a block. Its variables are names for expressions and stay symbolic.
    pub(super) fn symbolic_block(&mut self, block: &'a ast::Stmt) -> Expr {
        let span = block.span;
        let StmtKind::Block(statements) = &block.kind else { return Expr::error(span) };
        let mut bindings = Vec::new();
        let mut result: Option<Expr> = None;
        for statement in statements {
            match &statement.kind {
                StmtKind::Empty | StmtKind::Error => {}
                _ if result.is_some() => {
                    let diagnostic = Diagnostic::warning(
                        "W0202",
                        "this statement is never reached",
                        statement.span,
                        "after the `return`",
                    );
                    self.report(diagnostic.help("remove it"));
                }
                StmtKind::Var(declarations) => {
                    bindings.extend(declarations.iter().filter_map(|decl| self.symbolic_binding(decl)));
                }
                StmtKind::Return(Some(value)) => result = Some(self.stored(value)),
                _ => self.not_in_block(statement.span),
            }
        }
        let Some(result) = result else {
            let end = Span { start: span.end.saturating_sub(1), ..span };
            self.report(
                Diagnostic::error(
                    "E0860",
                    "the block of a symbolic function has no `return`",
                    end,
                    "the expression is missing",
                )
                .help("end the block with `return expression;`"),
            );
            return Expr::error(span);
        };
        let ty = result.ty.clone();
        Expr { kind: Kind::Block(bindings, Box::new(result)), ty, span }
    }

    fn symbolic_binding(&mut self, decl: &'a ast::VarDecl) -> Option<(VarId, Expr)> {
        let Some(Resolution::Var(id)) = self.names.uses.get(&decl.name.span).copied() else { return None };
        let name = &decl.name;
        let value = match &decl.init {
            Some((Bind::Evaluate, value)) => value,
            Some((Bind::Symbolic, value)) => {
                let between = Span { start: name.span.end, end: value.span.start, ..name.span };
                self.report(
                    Diagnostic::error(
                        "E0860",
                        format!("`{}` is bound with `:=` within a symbolic function", name.name),
                        name.span,
                        "everything in this block stays symbolic",
                    )
                    .help(format!("write `var {} = ...`", name.name))
                    .fix("use `=`", between, " = "),
                );
                value
            }
            None => {
                self.report(
                    Diagnostic::error(
                        "E0860",
                        format!("`{}` has no expression", name.name),
                        name.span,
                        "a variable of a symbolic function is never assigned",
                    )
                    .help(format!("write `var {} = ...`", name.name)),
                );
                return None;
            }
        };
        let value = self.stored(value);
        let ty = self.variable_type(id);
        self.expect(&ty, &value, format_args!("`{}`", name.name), None);
        Some((id, value))
    }

    fn not_in_block(&mut self, span: Span) {
        self.report(
            Diagnostic::error(
                "E0860",
                "the block of a symbolic function contains only `var` declarations and a `return`",
                span,
                "not allowed here",
            )
            .help(
                "write a choice as `if (c) a else b`, and call another symbolic function instead of nesting it",
            ),
        );
    }

    /// Returns `true` if a variable belongs to a symbolic function: an argument, or a variable of
    /// its block.
    pub(super) fn is_of_symbolic_function(&self, id: VarId) -> bool {
        let owner = self.variable(id).owner;
        let info = self.names.functions.get(owner.0 as usize);
        info.is_some_and(FunctionInfo::is_symbolic)
    }
}
