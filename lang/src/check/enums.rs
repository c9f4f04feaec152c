//! Checks enumerations: their values, and texts that stand for a choice.
//!
//! A value of an enumeration is the text of its choice. A literal text is accepted where the
//! enumeration is known, and a value of the enumeration where a text is.

use super::constant;
use super::infer::Checker;
use super::symbols::{Resolution, similar};
use super::tree::*;
use super::types::{EnumType, Type};
use crate::ast::{self, ExprKind};
use crate::declared;
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use std::sync::Arc;

impl<'a> Checker<'a> {
    /// Returns the type of an enumeration.
    pub(super) fn enum_type(&self, id: u32) -> Type {
        let decl = self.names.enums[id as usize].decl;
        let choices = decl.choices.iter().map(|choice| choice.name.name.clone()).collect();
        Type::Enum(Arc::new(EnumType { name: decl.name.name.clone(), choices }))
    }

    /// Returns the enumeration that an expression denotes: `Hand` or `module.Hand`.
    pub(super) fn enum_of(&self, e: &ast::Expr) -> Option<u32> {
        let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &e.kind else { return None };
        match self.names.uses.get(&name.span) {
            Some(Resolution::Enum(id)) => Some(*id),
            _ => None,
        }
    }

    /// Checks `Hand.left`.
    pub(super) fn choice(&mut self, id: u32, choice: &ast::Ident, span: Span) -> Expr {
        let ty = self.enum_type(id);
        let declared = self.names.enums[id as usize].decl.choices.iter().find(|c| c.name.name == choice.name);
        self.named_parts.extend(declared.map(|declared| (choice.span, declared.name.span)));
        if let Type::Enum(of) = &ty
            && declared.is_none()
        {
            self.report(unknown_choice(&of.name, &of.choices, &choice.name, choice.span, ""));
        }
        Expr { kind: Kind::Text(choice.name.clone()), ty, span }
    }

    /// Returns `true` if a text stands for a choice of the expected enumeration, or a choice for
    /// the expected text. Reports a text that is no choice.
    pub(super) fn accepts_choice(&mut self, expected: &Type, found: &Expr) -> bool {
        match (self.store.known(expected), self.store.known(&found.ty)) {
            (Type::String, Type::Enum(_)) => true,
            (Type::Enum(of), Type::String) => {
                let Some(text) = constant::text(found) else { return false };
                if !of.choices.iter().any(|choice| choice == text) {
                    let diagnostic = unknown_choice(&of.name, &of.choices, text, found.span, "\"");
                    self.report(diagnostic);
                }
                true
            }
            _ => false,
        }
    }

    /// Reports the comparison of a param or parameter that has choices with another text.
    pub(super) fn check_compared(&mut self, a: &Expr, b: &Expr) {
        let sides = [(a, b), (b, a)];
        for (value, text) in sides {
            let (Some(known), Some((name, choices))) = (constant::text(text), self.choices_of(value)) else {
                continue;
            };
            if !choices.is_empty() && !choices.iter().any(|choice| choice == known) {
                let diagnostic = unknown_choice(&name, &choices, known, text.span, "\"");
                self.report(diagnostic);
            }
        }
    }

    /// Returns the name and the choices of a param or parameter of texts.
    fn choices_of(&self, e: &Expr) -> Option<(String, Vec<String>)> {
        match e.kind {
            Kind::Param(id) if matches!(self.store.known(&e.ty), Type::String) => {
                let param = self.params.get(id as usize)?;
                Some((param.name.clone(), param.choices.clone()))
            }
            Kind::Var(id) => {
                let variable = self.variable(id);
                let decl = self.names.functions[variable.owner.0 as usize].decl?;
                let parameter = decl.parameters.iter().find(|p| p.name.span == variable.span)?;
                Some((variable.name.clone(), declared::choices(parameter.domain.as_ref())))
            }
            _ => None,
        }
    }
}

/// Returns the error for a text or name that is none of the choices.
fn unknown_choice(of: &str, choices: &[String], found: &str, span: Span, quote: &str) -> Diagnostic {
    let shown = |choice: &str| format!("{quote}{choice}{quote}");
    let all: Vec<String> = choices.iter().map(|choice| format!("`{}`", shown(choice))).collect();
    let message = format!("`{}` is not a choice of `{of}`", shown(found));
    let diagnostic = Diagnostic::error("E0857", message, span, "no such choice");
    match similar(found, choices.iter().map(String::as_str)) {
        Some(near) => diagnostic.help(format!("did you mean `{}`?", shown(&near))).fix(
            format!("change to `{}`", shown(&near)),
            span,
            shown(&near),
        ),
        None => diagnostic.help(format!("the choices are {}", all.join(", "))),
    }
}
