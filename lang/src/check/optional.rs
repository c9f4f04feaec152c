//! Optional values: parameters and fields whose default is `none`, the tests `e is none` and `e is
//! not none`, and the
//! analysis that finds where a value is present.
//!
//! The analysis determines the presence of a value per path, a variable with fields. It follows the
//! statements in order and joins alternatives. At targets of jumps it keeps only the paths that no
//! statement can change: variables that nothing assigns.

use super::constant;
use super::expr::Position;
use super::infer::Checker;
use super::symbols::{Resolution, VarKind, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::span::{FileId, Span};
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
        self.may_be_absent = matches!(self.store.known(ty), Type::Optional(_));
        self.whole(e)
    }

    /// Converts a value for a place of a type: a value that is present becomes an optional one.
    pub(super) fn as_optional(&mut self, ty: &Type, value: Expr) -> Expr {
        match (self.store.known(ty), self.store.known(&value.ty)) {
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
        match (self.store.known(ty), self.store.known(&value.ty)) {
            (Type::Optional(inner), found) if !matches!(found, Type::Optional(_)) => (**inner).clone(),
            _ => ty.clone(),
        }
    }

    /// Returns `true` if the default of a parameter is `none`.
    pub(super) fn is_optional(&self, parameter: &ast::Parameter) -> bool {
        matches!(&parameter.default, Some((ast::Bind::Evaluate, Some(default))) if self.is_none_word(default))
    }

    /// Returns `true` for the variable of a parameter with the default `none`.
    pub(super) fn is_optional_parameter(&self, id: VarId) -> bool {
        let variable = self.variable(id);
        let VarKind::Parameter(_) = variable.kind else { return false };
        let Some(decl) = self.names.functions[variable.owner.0 as usize].decl else { return false };
        decl.parameters.iter().any(|p| p.name.span == variable.span && self.is_optional(p))
    }

    /// Returns the type of a parameter of an engine function.
    pub(super) fn extern_parameter(&mut self, parameter: &ast::Parameter) -> Type {
        let ty = parameter.annotation.as_ref().map_or(Type::Error, |ty| self.annotation(ty, true));
        if self.is_optional(parameter) { Type::optional(ty) } else { ty }
    }

    /// Checks the choice `if (condition) a else b` where an optional value is accepted: a branch
    /// may be `none`.
    pub(super) fn optional_choice(
        &mut self,
        [condition, then, otherwise]: [&'a ast::Expr; 3],
        given: Position,
        span: Span,
    ) -> Expr {
        let (yes, no) = self.facts(condition);
        let condition = self.expr(condition);
        self.expect(&Type::Bool, &condition, "the condition", None);
        let branch = |c: &mut Self, e: &'a ast::Expr| {
            c.may_be_absent = true;
            c.expr_at(e, given)
        };
        let a = self.supposing(yes, |c| branch(c, then));
        let b = self.supposing(no, |c| branch(c, otherwise));
        let (a, b) = self.alike(a, b);
        let cause = Some((a.span, format!("the other branch is a {}", self.store.show(&a.ty))));
        let optional = |c: &Self, e: &Expr| match c.store.shallow(&e.ty) {
            Type::Optional(inner) => Some(*inner),
            _ => None,
        };
        let ty = match (optional(self, &a), optional(self, &b)) {
            (None, Some(inner)) => {
                self.expect(&inner, &a, "this branch", None);
                b.ty.clone()
            }
            (Some(inner), None) => {
                self.expect(&inner, &b, "this branch", cause);
                a.ty.clone()
            }
            _ => {
                let ty = a.ty.clone();
                self.expect(&ty, &b, "this branch", cause);
                ty
            }
        };
        let [a, b] = [a, b].map(|branch| Box::new(self.as_optional(&ty, branch)));
        Expr { kind: Kind::If(Box::new(condition), a, b), ty, span }
    }

    /// Checks the value that meant `none` before, in the declaration of a parameter.
    pub(super) fn check_former_none(&mut self, ty: &Type, parameter: &'a ast::Parameter) {
        let Some(former) = &parameter.former_none else { return };
        let Type::Optional(inner) = self.store.shallow(ty) else {
            let message = format!("`{}` is not optional, so no value meant `none`", parameter.name.name);
            let problem = Diagnostic::error("E0878", message, former.span, "only after `= none`");
            let help = "remove `was` and the value, or write `none` as the default";
            return self.report(problem.help(help));
        };
        let value = self.former_value(former, &inner);
        if constant::number(&value, &self.store).is_none() && constant::text(&value).is_none() {
            let message = "a value that meant `none` is a constant number or text";
            let problem = Diagnostic::error("E0878", message, former.span, "not constant");
            self.report(problem.help("write a literal, such as `0 mm`"));
        }
    }

    fn former_value(&mut self, former: &'a ast::Expr, ty: &Type) -> Expr {
        let around = self.constant_place.replace("a default");
        let value = self.as_value(|c| c.whole(former));
        self.constant_place = around;
        self.expect(ty, &value, "the value that meant `none`", None);
        value
    }

    /// Converts an argument that meant `none` in earlier versions to `none`. Reports it where it is
    /// constant, or a param whose default means `none`.
    pub(super) fn former_none(
        &mut self,
        ty: &Type,
        parameter: &'a ast::Parameter,
        value: Expr,
        argument: &'a ast::Argument,
        file: FileId,
    ) -> Expr {
        let Some(former) = &parameter.former_none else { return value };
        let (Type::Optional(inner), Kind::Some(given)) = (self.store.shallow(ty), &value.kind) else {
            return value;
        };
        let meant = self.in_file(file, |c| c.former_value(former, &inner));
        let span = value.span;
        match self.is_same_constant(given, &meant) {
            Some(false) => value,
            Some(true) => {
                let written = argument.value.span;
                let what = format!("`{}`", self.text(written));
                let problem = former_none_warning(&what, parameter, written);
                self.report(problem.fix("write `none`", written, "none"));
                Expr { kind: Kind::None, ty: ty.clone(), span }
            }
            None => {
                if let Kind::Param(id) = given.kind
                    && self.is_default_of(id, &meant)
                {
                    let (name, written) = (self.text(argument.value.span).to_string(), argument.value.span);
                    let zero = self.in_file(file, |c| c.text(former.span).to_string());
                    let choice = format!("if ({name} == {zero}) none else {name}");
                    let what = format!("the default of `{name}`");
                    let problem = former_none_warning(&what, parameter, written);
                    self.report(problem.fix(format!("write `{choice}`"), written, choice));
                }
                let (kept, statement) = self.keep(&parameter.name.name, (**given).clone());
                let same = Kind::Binary(BinaryOp::Equal, Box::new(kept.clone()), Box::new(meant));
                let same = Expr { kind: same, ty: Type::Bool, span };
                let absent = Expr { kind: Kind::None, ty: ty.clone(), span };
                let present = Expr { kind: Kind::Some(Box::new(kept)), ty: ty.clone(), span };
                let kind = Kind::If(Box::new(same), Box::new(absent), Box::new(present));
                let chosen = Expr { kind, ty: ty.clone(), span };
                Expr { kind: Kind::Sequence(vec![statement], Box::new(chosen)), ty: ty.clone(), span }
            }
        }
    }

    /// Returns whether two values are the same constant; `None` if the first one is not constant.
    fn is_same_constant(&self, given: &Expr, meant: &Expr) -> Option<bool> {
        let number = |e: &Expr| constant::number(e, &self.store);
        match (number(given), number(meant)) {
            (Some(given), Some(meant)) => Some(given == meant),
            _ => Some(constant::text(given)? == constant::text(meant)?),
        }
    }

    /// Returns `true` if a value is the constant default of a param.
    fn is_default_of(&self, id: u32, meant: &Expr) -> bool {
        let default = self.params.get(id as usize).map(|param| &param.default);
        default.and_then(|default| self.is_same_constant(default, meant)) == Some(true)
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
        self.make_optional(&value);
        match self.store.shallow(&value.ty) {
            Type::Error => return Expr { kind: Kind::Error, ty: Type::Bool, span },
            Type::Optional(_) => {}

            other => {
                let what = self.text(value.span).to_string();
                let message = match &other {
                    Type::Unknown(_) => format!("`{what}` is never `none`"),
                    other => format!(
                        "`{what}` is {}, which is never `none`",
                        with_article(&self.store.show(other))
                    ),
                };
                self.report(
                    Diagnostic::error("E0856", message, value.span, "always has a value")
                        .help("only parameters and fields with the default `none` can be `none`"),
                );
                return Expr { kind: Kind::Error, ty: Type::Bool, span };
            }
        }
        Expr { kind: Kind::IsNone(Box::new(value)), ty: Type::Bool, span }
    }

    /// Makes the type of a field optional if the record is an argument whose type the calls
    /// determine.
    pub(super) fn make_optional(&mut self, field: &Expr) {
        let is_unknown = |c: &Self| matches!(c.store.known(&field.ty), Type::Unknown(_));
        if !matches!(field.kind, Kind::Field(..)) || !is_unknown(self) {
            return;
        }
        self.solve_constraints();
        if is_unknown(self) {
            let optional = Type::optional(self.store.fresh());
            // A new type is not part of the field's type, so it cannot contain itself.
            let _ = self.store.unify(&field.ty, &optional);
        }
    }

    /// Returns the other operand of a comparison with the word `none`, and whether the comparison
    /// is true if that has no value.
    pub(super) fn compared_with_none<'e>(
        &self,
        op: BinaryOp,
        left: &'e ast::Expr,
        right: &'e ast::Expr,
    ) -> Option<(&'e ast::Expr, bool)> {
        let absent = match op {
            BinaryOp::Equal => true,
            BinaryOp::NotEqual => false,
            _ => return None,
        };
        match (self.is_none_word(left), self.is_none_word(right)) {
            (false, true) => Some((left, absent)),
            (true, false) => Some((right, absent)),
            _ => None,
        }
    }

    /// Reports the comparison of an operand with `none`, instead of the test `is none`.
    pub(super) fn wrong_test(&mut self, operand: &'a ast::Expr, absent: bool, span: Span) -> Expr {
        let tested = self.is_none(operand, operand.span);
        if matches!(tested.kind, Kind::Error) {
            return tested;
        }
        let what = self.text(operand.span).to_string();
        let test = if absent { format!("{what} is none") } else { format!("{what} is not none") };
        self.report(
            Diagnostic::error("E0855", "`none` is not a value to compare with", span, "not a test")
                .help(format!("write `{test}`"))
                .fix(format!("change to `{test}`"), span, test),
        );
        Expr { kind: Kind::Error, ty: Type::Bool, span }
    }

    /// Returns an optional expression as its value where the value is known to be present. Reports
    /// any other use, unless the expression stands where an optional value is accepted.
    pub(super) fn presence(&mut self, written: &'a ast::Expr, e: Expr, accepted: bool, tested: bool) -> Expr {
        let Type::Optional(inner) = self.store.shallow(&e.ty) else { return e };
        let present = self.is_present(written);
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
                let shown = match self.store.shallow(&inner) {
                    Type::Unknown(_) => "a value".to_owned(),
                    _ => with_article(&self.store.show(&inner)),
                };
                Diagnostic::error("E0855", message, span, format!("{shown} or `none`")).help(help)
            }
        };
        self.report(diagnostic);
        Expr { kind: Kind::Error, ty: *inner, span }
    }

    /// Returns `true` if an expression denotes a path whose value is present.
    pub(super) fn is_present(&self, e: &ast::Expr) -> bool {
        !self.present.is_empty() && self.path(e).is_some_and(|path| self.present.contains(&path))
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
                fields.push(field.name.to_string());
                Some((id, fields))
            }
            ExprKind::Paren(inner) => self.path(inner),
            _ => None,
        }
    }

    /// Returns the paths that are present if a condition is true, and those if it is false.
    pub(super) fn facts(&self, condition: &ast::Expr) -> (Present, Present) {
        // This comparison is an error; that it was meant as a test avoids further ones.
        if let ExprKind::Binary { op, left, right, .. } = &condition.kind
            && let Some((operand, absent)) = self.compared_with_none(*op, left, right)
        {
            let path: Present = self.path(operand).into_iter().collect();
            return if absent { (Present::new(), path) } else { (path, Present::new()) };
        }
        match &condition.kind {
            ExprKind::IsNone { value, negated } => {
                let path = self.path(value).into_iter().collect();
                if *negated { (path, Present::new()) } else { (Present::new(), path) }
            }
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
        let optional = matches!(self.store.known(&place.ty), Type::Optional(_));
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

/// Returns the warning for an argument that meant `none` in earlier versions.
fn former_none_warning(what: &str, parameter: &ast::Parameter, written: Span) -> Diagnostic {
    let message = format!("{what} no longer stands for \"not given\"");
    Diagnostic::warning("W0845", message, written, "deprecated")
        .label(parameter.name.span, format!("`{}` is optional", parameter.name.name))
        .help("write `none`, or leave the argument out; the next version takes the value as it is")
}
