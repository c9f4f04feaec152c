//! Checks declarations of variables, assignments, and `push`.

use super::infer::Checker;
use super::symbols::{Resolution, VarKind, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, Bind, ExprKind};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl<'a> Checker<'a> {
    /// Records the dependences of a value assigned to a place.
    pub(super) fn assigned(&mut self, place: &Place, value: &Expr) {
        self.note_circular(place.variable, value);
        let owner = self.variable(place.variable).owner;
        self.dependence.assigned(place, owner, value);
    }

    /// Checks a complete value that is stored or returned.
    pub(super) fn stored(&mut self, e: &'a ast::Expr) -> Expr {
        let value = self.whole(e);
        if matches!(self.store.known(&value.ty), Type::Unit) {
            self.report(
                Diagnostic::error(
                    "E0303",
                    "a value is needed here, but this call returns nothing",
                    value.span,
                    "no value here",
                )
                .help("call it as a statement, or give the function a `return` with a value"),
            );
            return Expr::error(value.span);
        }
        value
    }

    pub(super) fn variable_decl(&mut self, decl: &'a ast::VarDecl) -> StmtKind {
        let Some(Resolution::Var(id)) = self.names.uses.get(&decl.name.span).copied() else {
            return StmtKind::Nothing;
        };
        self.dependence.declare(id);
        match &decl.init {
            None => {
                self.variable_type(id);
                StmtKind::Nothing
            }
            Some((Bind::Symbolic, value)) => self.bind(id, value),
            Some((Bind::Evaluate, value)) => {
                if matches!(value.kind, ExprKind::Number(0.0)) {
                    self.zero_starts.insert(id, value.span);
                }
                self.evidence.initialize(id, value);
                let value = self.stored(value);
                let requested = self.requested_type(decl.name.span, &value.ty);
                let value = match &requested {
                    Some(ty) => self.fitted(ty, value),
                    None => value,
                };
                let ty = self.variable_type(id);
                self.forget_variable(id);
                self.expect(&ty, &value, format_args!("`{}`", decl.name.name), None);
                let place = Place { variable: id, steps: Vec::new(), ty, span: decl.name.span };
                self.assigned(&place, &value);
                self.note_length(id, &value);
                StmtKind::Assign(place, value)
            }
        }
    }

    pub(super) fn assign(&mut self, place: &'a ast::Expr, bind: Bind, value: &'a ast::Expr) -> StmtKind {
        if bind == Bind::Symbolic {
            return self.rebind(place, value);
        }
        let between = Span { start: place.span.end, end: value.span.start, ..place.span };
        if let Some(id) = self.symbolic_target(place) {
            let problem = self.keeps_expression(id, place.span);
            self.report(problem.suggest("use `:=`", between, " := "));
            self.stored(value);
            return StmtKind::Nothing;
        }
        let target = match &place.kind {
            ExprKind::Name(_) | ExprKind::Index { .. } | ExprKind::Field { .. } | ExprKind::Paren(_) => {
                self.place(place)
            }
            // Already reported by the parser.
            _ => None,
        };
        let ty = target.as_ref().map_or(Type::Error, |target| target.ty.clone());
        self.may_be_absent = matches!(self.store.known(&ty), Type::Optional(_));
        let expression = match self.store.shallow(&ty) {
            Type::Symbolic(_) => self.expression_for(&ty, value),
            _ => None,
        };
        let value = match expression {
            Some(expression) => expression,
            None => self.stored(value),
        };
        let Some(target) = target else { return StmtKind::Nothing };
        let Some(value) = self.expect_stored(&target, value) else { return StmtKind::Nothing };
        self.assigned_presence(&target, place, &value);
        self.assigned(&target, &value);
        StmtKind::Assign(target, value)
    }

    /// Requires that a value has the type of the place that it is assigned to, and returns it as
    /// one of this type. Returns `None` if the variable has observables and was first taken for a
    /// number: then the program is checked again.
    pub(super) fn expect_stored(&mut self, target: &Place, value: Expr) -> Option<Expr> {
        let variable = self.variable(target.variable).clone();
        let part = if target.steps.is_empty() { "" } else { "an element of " };
        let declared = self.variable_type(target.variable);
        self.solve_open_constraints(std::iter::once(&value.ty));
        let value = self.fitted(&target.ty, value);
        if variable.kind == VarKind::Value && self.observable_requested(variable.span, &target.ty, &value) {
            return None;
        }
        let wanted = self.without_optional(&target.ty, &value);
        let is_a = |c: &Self| format!("`{}` is a {}", variable.name, c.store.show(&declared));
        let what = format_args!("{part}`{}`", variable.name);
        self.expect_from(&wanted, &value, what, (variable.span, is_a));
        Some(self.as_optional(&target.ty, value))
    }

    /// Checks `place += value` and the like.
    pub(super) fn update(
        &mut self,
        place: &'a ast::Expr,
        (op, op_span): (BinaryOp, Span),
        value: &'a ast::Expr,
        span: Span,
    ) -> StmtKind {
        if let Some(id) = self.symbolic_target(place) {
            self.report(self.keeps_expression(id, place.span));
            self.expr(value);
            return StmtKind::Nothing;
        }
        let target = self.place(place);
        let value = self.expr(value);
        let Some(target) = target else { return StmtKind::Nothing };
        let present = Expr { kind: Kind::Updated(target.variable), ty: target.ty.clone(), span: place.span };
        let present = self.presence(place, present, false, false);
        let value = self.combined(op, op_span, present, value, span);
        let Some(value) = self.expect_stored(&target, value) else { return StmtKind::Nothing };
        self.assigned_presence(&target, place, &value);
        self.assigned(&target, &value);
        StmtKind::Update(target, value)
    }

    pub(super) fn rebind(&mut self, place: &'a ast::Expr, value: &'a ast::Expr) -> StmtKind {
        if let ExprKind::Name(name) = &place.kind
            && let Some(Resolution::Var(id)) = self.names.uses.get(&name.span).copied()
        {
            let variable = self.variable(id).clone();
            if variable.kind == VarKind::Symbolic {
                return self.bind(id, value);
            }
            let between = Span { start: place.span.end, end: value.span.start, ..place.span };
            self.report(
                Diagnostic::error(
                    "E0503",
                    format!("`{}` is a variable with a value and cannot be bound with `:=`", variable.name),
                    place.span,
                    "the declaration determines the kind of a name",
                )
                .label(variable.span, "declared here")
                .help(format!("write `{0} = ...`, or declare it with `var {0} := ...`", variable.name))
                .suggest("use `=`", between, " = "),
            );
        } else if self.place(place).is_some() {
            self.report(
                Diagnostic::error("E0503", "only a name can be bound with `:=`", place.span, "not a name")
                    .help("declare a name with `var name := ...`"),
            );
        }
        self.as_symbolic(|c| c.whole(value));
        StmtKind::Nothing
    }

    pub(super) fn push(&mut self, arguments: &'a [ast::Argument], span: Span) -> StmtKind {
        let Some([array, value]) = self.plain("push", arguments, span, ["array", "value"]) else {
            return StmtKind::Nothing;
        };
        let place = self.place(array);
        let element = match place.as_ref().map(|place| self.store.shallow(&place.ty)) {
            Some(Type::Array(element)) => *element,
            _ => Type::Error,
        };
        let value = match self.expression_for(&element, value) {
            Some(expression) => expression,
            None => self.stored(value),
        };
        let Some(place) = place else { return StmtKind::Nothing };
        let cause = (place.span, format!("this is {}", with_article(&self.store.show(&place.ty))));
        let element = match self.store.shallow(&place.ty) {
            Type::Array(element) => *element,
            _ => {
                let element = self.store.fresh();
                let present = Expr { kind: Kind::Error, ty: place.ty.clone(), span: place.span };
                self.expect(&Type::array(element.clone()), &present, "the first argument of `push`", None);
                element
            }
        };
        let value = self.fitted(&element, value);
        if let Some(variable) = place.steps.is_empty().then(|| self.variable(place.variable).clone())
            && self.observable_requested(
                variable.span,
                &place.ty,
                &Expr { ty: Type::array(value.ty.clone()), ..value.clone() },
            )
        {
            return StmtKind::Nothing;
        }
        let what = format!("an element of `{}`", self.text(place.span));
        self.expect(&element, &value, what, Some(cause));
        self.assigned(&place, &value);
        StmtKind::Push(place, value)
    }
}
