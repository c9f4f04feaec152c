//! Optional values: parameters and fields whose default is `none`, the test `e is none`, and the
//! analysis that finds where a value is present.
//!
//! The analysis determines the presence of a value per path, a variable with fields. It follows the
//! statements in order and joins alternatives. At targets of jumps it keeps only the paths that no
//! statement can change: variables that nothing assigns.

use super::infer::Checker;
use super::symbols::Resolution;
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use std::collections::BTreeSet;

/// A variable and the names of fields.
pub(super) type Path = (VarId, Vec<String>);

/// The paths whose values are present.
pub(super) type Present = BTreeSet<Path>;

impl<'a> Checker<'a> {
    /// Returns `true` for the word `none`.
    pub(super) fn is_none_word(&self, e: &ast::Expr) -> bool {
        match &e.kind {
            ExprKind::Name(name) => matches!(self.names.uses.get(&name.span), Some(Resolution::None)),
            ExprKind::Paren(inner) => self.is_none_word(inner),
            _ => false,
        }
    }

    /// Checks an expression for a place of a type, which may be an optional type.
    pub(super) fn whole_for(&mut self, ty: &Type, e: &'a ast::Expr) -> Expr {
        if matches!(self.store.known(ty), Type::Symbolic(_))
            && let Some(expression) = self.expression_for(ty, e)
        {
            return expression;
        }
        self.may_be_absent = matches!(self.store.shallow(ty), Type::Optional(_));
        self.whole(e)
    }

    /// Converts a value for a place of a type: a value that is present becomes an optional one.
    pub(super) fn as_optional(&mut self, ty: &Type, value: Expr) -> Expr {
        match (self.store.shallow(ty), self.store.shallow(&value.ty)) {
            (Type::Optional(_), Type::Optional(_) | Type::Error) => value,
            (Type::Optional(_), _) => {
                let span = value.span;
                Expr { kind: Kind::Some(Box::new(value)), ty: ty.clone(), span }
            }
            _ => value,
        }
    }

    /// Returns the type that a value for a place of a type must have.
    pub(super) fn without_optional(&self, ty: &Type, value: &Expr) -> Type {
        match (self.store.shallow(ty), self.store.shallow(&value.ty)) {
            (Type::Optional(inner), found) if !matches!(found, Type::Optional(_)) => *inner,
            _ => ty.clone(),
        }
    }

    /// Checks `e is none`.
    pub(super) fn is_none(&mut self, e: &'a ast::Expr, span: Span) -> Expr {
        let value = self.as_value(|c| {
            c.may_be_absent = true;
            c.tests_presence = true;
            let value = c.expr(e);
            c.tests_presence = false;
            value
        });
        match self.store.shallow(&value.ty) {
            Type::Error => return Expr { kind: Kind::Error, ty: Type::Bool, span },
            Type::Optional(_) => {}
            other => {
                let shown = self.store.show(&other);
                let what = self.text(value.span).to_string();
                self.report(
                    Diagnostic::error(
                        "E0856",
                        format!("`{what}` is a {shown}, which is never `none`"),
                        value.span,
                        "always has a value",
                    )
                    .help("only parameters and fields with the default `none` can be `none`"),
                );
                return Expr { kind: Kind::Error, ty: Type::Bool, span };
            }
        }
        Expr { kind: Kind::IsNone(Box::new(value)), ty: Type::Bool, span }
    }

    /// Returns an optional expression as its value where the value is known to be present. Reports
    /// any other use, unless the expression stands where an optional value is accepted.
    pub(super) fn presence(&mut self, written: &'a ast::Expr, e: Expr, accepted: bool, tested: bool) -> Expr {
        let Type::Optional(inner) = self.store.shallow(&e.ty) else { return e };
        let present = self.path(written).is_some_and(|path| self.present.contains(&path));
        let span = e.span;
        if present && !tested {
            return Expr { kind: Kind::TupleElement(Box::new(e), 1), ty: *inner, span };
        }
        if accepted {
            return e;
        }
        let what = self.text(written.span).to_string();
        let diagnostic = match self.is_none_word(written) {
            true => Diagnostic::error("E0855", "`none` is not a value", span, "a value is needed here")
                .help("`none` is the default of parameters and fields, and an argument for them"),
            false => {
                let help = match self.path(written) {
                    Some(_) => format!("test it before: `if ({what} is none) ... else ...`"),
                    None => "assign it to a parameter or field, and test that with `is none`".into(),
                };
                let message = format!("`{what}` may be `none` here");
                Diagnostic::error("E0855", message, span, format!("a {} or `none`", self.store.show(&inner)))
                    .help(help)
            }
        };
        self.report(diagnostic);
        Expr { kind: Kind::Error, ty: *inner, span }
    }

    /// Returns the path that an expression denotes.
    fn path(&self, e: &ast::Expr) -> Option<Path> {
        match &e.kind {
            ExprKind::Name(name) => match self.names.uses.get(&name.span) {
                Some(Resolution::Var(id)) => Some((*id, Vec::new())),
                _ => None,
            },
            ExprKind::Field { base, field } => {
                let (id, mut fields) = self.path(base)?;
                fields.push(field.name.clone());
                Some((id, fields))
            }
            ExprKind::Paren(inner) => self.path(inner),
            _ => None,
        }
    }

    /// Returns the paths that are present if a condition is true, and those if it is false.
    pub(super) fn facts(&self, condition: &ast::Expr) -> (Present, Present) {
        match &condition.kind {
            ExprKind::IsNone(e) => (Present::new(), self.path(e).into_iter().collect()),
            ExprKind::Paren(inner) => self.facts(inner),
            ExprKind::Unary { op: UnaryOp::Not, operand } => {
                let (yes, no) = self.facts(operand);
                (no, yes)
            }
            ExprKind::Binary { op: BinaryOp::And, left, right, .. } => {
                let (mut yes, _) = self.facts(left);
                yes.extend(self.facts(right).0);
                (yes, Present::new())
            }
            ExprKind::Binary { op: BinaryOp::Or, left, right, .. } => {
                let (_, mut no) = self.facts(left);
                no.extend(self.facts(right).1);
                (Present::new(), no)
            }
            _ => Default::default(),
        }
    }

    /// Checks code that runs only if the paths are present.
    pub(super) fn supposing<T>(&mut self, paths: Present, work: impl FnOnce(&mut Self) -> T) -> T {
        if paths.is_empty() {
            return work(self);
        }
        let around = self.present.clone();
        self.present.extend(paths);
        let result = work(self);
        self.present = around;
        result
    }

    /// Removes the paths that statements elsewhere may change, at a target of jumps.
    pub(super) fn forget_present(&mut self) {
        let assigned = &self.names.assigned;
        self.present.retain(|(id, fields)| fields.is_empty() && !assigned.contains(id));
    }

    /// Records the assignment of a place.
    pub(super) fn assigned_presence(&mut self, place: &Place, written: &ast::Expr, value: &Expr) {
        self.present.retain(|(id, _)| *id != place.variable);
        let optional = matches!(self.store.shallow(&place.ty), Type::Optional(_));
        if optional
            && matches!(value.kind, Kind::Some(_))
            && let Some(path) = self.path(written)
        {
            self.present.insert(path);
        }
    }

    /// Records that a call assigns a variable.
    pub(super) fn forget_variable(&mut self, variable: VarId) {
        self.present.retain(|(id, _)| *id != variable);
    }
}

/// Returns `true` if execution may continue after a statement.
pub(super) fn continues(statement: &Stmt) -> bool {
    match &statement.kind {
        StmtKind::Return(_)
        | StmtKind::Throw(_)
        | StmtKind::Break
        | StmtKind::Continue
        | StmtKind::Goto(_) => false,
        StmtKind::Block(all) => {
            all.iter().any(|s| matches!(s.kind, StmtKind::Label(..))) || all.iter().all(continues)
        }
        StmtKind::If(_, then, Some(otherwise)) => continues(then) || continues(otherwise),
        _ => true,
    }
}
