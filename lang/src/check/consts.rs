//! `const` declarations: values computed before the program runs and substituted where they are
//! used.

use super::constant;
use super::infer::Checker;
use super::order::MOST_OPEN;
use super::symbols::Resolution;
use super::tree::*;
use super::types::Type;
use crate::diagnostic::Diagnostic;
use crate::span::Span;

/// Limit of the subexpressions of a constant, including the constants that it uses. Without it, a
/// chain of constants that each use the previous one twice would grow exponentially.
const MOST_PARTS: usize = 10_000;

impl<'a> Checker<'a> {
    /// Computes all constants, including unused ones.
    pub(super) fn declare_consts(&mut self) {
        let texts: Vec<Span> = self.names.consts.iter().map(|declared| declared.decl.value.span).collect();
        let of = |res| match res {
            Resolution::Const(id) => Some(id),
            _ => None,
        };
        for id in self.by_dependence(&texts, of) {
            self.const_value(id);
        }
        self.solve_constraints();
    }

    /// Returns the value for a use of a constant.
    pub(super) fn const_use(&mut self, id: u32, span: Span) -> Expr {
        let value = self.const_value(id);
        let ty = match (&value.kind, self.store.shallow(&value.ty)) {
            // `0`, `inf` and `nan` have any dimension, which each use determines separately.
            (Kind::Number(number), Type::Number(dim)) if *number == 0.0 || !number.is_finite() => {
                let unknown = self.store.dim(&dim).variables().all(|v| !self.store.is_literal(v));
                let open = self.store.dim(&dim).as_known().is_none();
                if open && unknown { self.fresh_number() } else { value.ty }
            }
            _ => value.ty,
        };
        Expr { kind: value.kind, ty, span }
    }

    fn const_value(&mut self, id: u32) -> Expr {
        let (decl, file) = {
            let declared = &self.names.consts[id as usize];
            (declared.decl, declared.file)
        };
        match self.consts.get(&id) {
            Some(Some(value)) => return value.clone(),
            None if self.open_consts < MOST_OPEN => {}
            Some(None) | None => {
                self.report(
                    Diagnostic::error(
                        "E0212",
                        format!("the constant `{}` depends on itself", decl.name.name),
                        decl.name.span,
                        "circular definition",
                    )
                    .help("compute constants from literals and other constants"),
                );
                return Expr::error(decl.value.span);
            }
        }
        self.open_consts += 1;
        self.consts.insert(id, None);
        let place = self.constant_place.replace("a constant");
        let value = self.in_file(file, |c| c.as_value(|c| c.whole(decl.value)));
        self.constant_place = place;
        self.open_consts -= 1;
        let value = self.settled(value, &decl.name.name);
        self.consts.insert(id, Some(value.clone()));
        value
    }

    /// Reduces the value of a constant to literals where possible, and reports an error if it is
    /// not constant.
    fn settled(&mut self, value: Expr, name: &str) -> Expr {
        let mut parts = 0;
        if let Some((span, what)) = variable_part(&value, &mut parts) {
            self.report(
                Diagnostic::error("E0212", format!("a constant cannot use {what}"), span, "not constant")
                    .help("use literals, units, other constants and the functions of the language"),
            );
            return Expr { kind: Kind::Error, ..value };
        }
        if parts > MOST_PARTS {
            self.report(
                Diagnostic::error(
                    "E0221",
                    format!("the constant `{name}` has more than {MOST_PARTS} parts"),
                    value.span,
                    "including the constants that it uses",
                )
                .help("use a variable"),
            );
            return Expr { kind: Kind::Error, ..value };
        }
        match constant::scalar(&value, &self.store) {
            Some(kind) => Expr { kind, ..value },
            None => value,
        }
    }
}

/// Returns the location and the description of a subexpression that is not constant, and counts the
/// subexpressions.
fn variable_part(e: &Expr, parts: &mut usize) -> Option<(Span, &'static str)> {
    *parts += 1;
    let what = match &e.kind {
        Kind::Var(_) => Some("a variable"),
        Kind::Param(_) => Some("a param, which is set before the run"),
        Kind::Time => Some("`Time`"),
        Kind::Call(_) | Kind::CallExtern(..) => Some("a call of a function that is not built in"),
        Kind::Print(..) | Kind::Assert(..) => Some("a statement"),
        Kind::Sequence(..) => Some("a comprehension, a slice or a sum over an array"),
        Kind::Def(_)
        | Kind::MakeSymbolic(_)
        | Kind::Eval(..)
        | Kind::Observe(_)
        | Kind::Derivative(..)
        | Kind::At(..) => Some("a symbolic expression"),
        _ => None,
    };
    match what {
        Some(what) => Some((e.span, what)),
        None if *parts > MOST_PARTS => None,
        None => e.children().into_iter().find_map(|child| variable_part(child, parts)),
    }
}
