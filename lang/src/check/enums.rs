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
        let choices = decl.choices.iter().map(|choice| choice.name.name.to_string()).collect();
        Type::Enum(Arc::new(EnumType { name: decl.name.name.to_string(), choices }))
    }

    /// Returns the enumeration that an expression denotes: `Hand` or `module.Hand`.
    pub(super) fn enum_of(&self, e: &ast::Expr) -> Option<u32> {
        let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &e.kind else { return None };
        match self.names.uses.get(&name.span) {
            Some(Resolution::Enum(id)) => Some(*id),
            _ => None,
        }
    }

    /// Returns the choices of an enumeration in order, if an expression after the `in` of a loop
    /// denotes one.
    pub(super) fn choices_in_order(&self, e: &ast::Expr) -> Option<Expr> {
        let ty = self.enum_type(self.enum_of(e)?);
        let Type::Enum(of) = &ty else { return None };
        let choice = |name: &String| Expr { kind: Kind::Text(name.clone()), ty: ty.clone(), span: e.span };
        let choices = of.choices.iter().map(choice).collect();
        Some(Expr { kind: Kind::Array(choices), ty: Type::array(ty.clone()), span: e.span })
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
        Expr { kind: Kind::Text(choice.name.to_string()), ty, span }
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
            (Type::Array(expected), Type::Array(_)) => match &found.kind {
                Kind::Array(elements) if !elements.is_empty() => {
                    let expected = (**expected).clone();
                    self.accept_choices(&expected, elements)
                }
                _ => false,
            },
            _ => false,
        }
    }

    /// As [`Self::accepts_choice`], for all elements of brackets as written.
    fn accept_choices(&mut self, expected: &Type, elements: &[Expr]) -> bool {
        elements.iter().all(|element| self.accepts_choice(expected, element))
    }

    /// Reports a comparison that is never true: of a param or parameter that has choices with
    /// another text, or of two values without a common choice.
    pub(super) fn check_compared(&mut self, a: &Expr, b: &Expr) {
        self.check_common_choice(a, b);
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

    fn check_common_choice(&mut self, a: &Expr, b: &Expr) {
        let is_enum = |ty: &Type| matches!(self.store.known(ty), Type::Enum(_));
        // Values of two enumerations have different types, which is reported.
        if is_enum(&a.ty) && is_enum(&b.ty) {
            return;
        }
        let (Some((first, of_first)), Some((second, of_second))) =
            (self.known_choices(a), self.known_choices(b))
        else {
            return;
        };
        if of_first.iter().any(|choice| of_second.contains(choice)) {
            return;
        }
        let message = format!("`{first}` and `{second}` have no choice in common, so they are never equal");
        let label = |choices: &[String]| format!("one of {}", listed(choices, "\""));
        let problem =
            Diagnostic::error("E0879", message, b.span, label(&of_second)).label(a.span, label(&of_first));
        let near =
            |choice: &String| Some((choice.clone(), similar(choice, of_first.iter().map(String::as_str))?));
        let help = match of_second.iter().find_map(near) {
            Some((choice, near)) => format!("does `{choice}` stand for `{near}`? Use one spelling for both"),
            None => "compare values that have a choice in common".into(),
        };
        self.report(problem.help(help));
    }

    /// Returns the choices of a value that is not constant, if they are known, and what has them.
    fn known_choices(&self, e: &Expr) -> Option<(String, Vec<String>)> {
        match self.store.known(&e.ty) {
            _ if constant::text(e).is_some() => None,
            Type::Enum(of) => Some((of.name.clone(), of.choices.clone())),
            _ => self.choices_of(e).filter(|(_, choices)| !choices.is_empty()),
        }
    }

    /// Reports a `switch` over an enumeration that has neither all choices nor a `default`.
    pub(super) fn check_all_choices(&mut self, value: &Expr, cases: &[Expr], body: &ast::Stmt) {
        let Type::Enum(of) = self.store.known(&value.ty) else { return };
        let texts: Vec<&str> = cases.iter().filter_map(constant::text).collect();
        let known = |text: &&str| of.choices.iter().any(|choice| choice == text);
        // Cases that are not constant may be any choice; misspelt ones are reported.
        if has_default(body) || texts.len() < cases.len() || !texts.iter().all(known) {
            return;
        }
        let missing: Vec<String> =
            of.choices.iter().filter(|choice| !texts.contains(&choice.as_str())).cloned().collect();
        if missing.is_empty() {
            return;
        }
        let shown = listed(&missing, "");
        let verb = if missing.len() == 1 { "is" } else { "are" };
        let message = format!("`switch` has no case for {shown} of `{}`", of.name);
        let problem = Diagnostic::error("E0880", message, value.span, format!("{shown} {verb} not handled"))
            .help("add the missing cases, or a `default`");
        let (place, added) = self.added_cases(cases, &missing, body);
        let everything_else = self.added(body, &["default".into()]);
        let (last, default) = everything_else;
        self.report(problem.fix("add the missing cases", place, added).suggest(
            "add a `default`",
            last,
            default,
        ));
    }

    fn added_cases(&self, cases: &[Expr], missing: &[String], body: &ast::Stmt) -> (Span, String) {
        // Written as the first case: `Hand.left` or `"left"`.
        let first = cases.first().map_or("", |case| self.text(case.span));
        let path = first.rfind('.').map(|dot| &first[..dot]);
        let case = |choice: &String| match path {
            Some(path) => format!("case {path}.{choice}"),
            None => format!("case \"{choice}\""),
        };
        self.added(body, &missing.iter().map(case).collect::<Vec<_>>())
    }

    /// Returns the insertion of labels that do nothing at the end of the body of a `switch`.
    fn added(&self, body: &ast::Stmt, labels: &[String]) -> (Span, String) {
        let end = body.span.end.saturating_sub(1);
        let text = self.text(Span { end, ..body.span });
        let place = Span { start: end, end, ..body.span };
        let indent = text.rsplit_once('\n').map(|(_, line)| line).filter(|line| line.trim().is_empty());
        let added = match indent {
            Some(indent) => {
                let lines =
                    labels.iter().map(|label| format!("    {label}:\n{indent}        break;\n{indent}"));
                lines.collect()
            }
            None => labels.iter().map(|label| format!("{label}: break; ")).collect(),
        };
        (place, added)
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
                Some((variable.name.to_string(), declared::choices(parameter.domain.as_ref())))
            }
            _ => None,
        }
    }
}

/// Returns `true` if the body of a `switch` has a `default`.
fn has_default(statement: &ast::Stmt) -> bool {
    match &statement.kind {
        ast::StmtKind::Default(_) => true,
        ast::StmtKind::Block(all) => all.iter().any(has_default),
        ast::StmtKind::Case { statement, .. } | ast::StmtKind::Label { statement, .. } => {
            has_default(statement)
        }
        _ => false,
    }
}

fn listed(choices: &[String], quote: &str) -> String {
    let all: Vec<String> = choices.iter().map(|choice| format!("`{quote}{choice}{quote}`")).collect();
    all.join(", ")
}

/// Returns the error for a text or name that is none of the choices.
fn unknown_choice(of: &str, choices: &[String], found: &str, span: Span, quote: &str) -> Diagnostic {
    let shown = |choice: &str| format!("{quote}{choice}{quote}");
    let message = format!("`{}` is not a choice of `{of}`", shown(found));
    let diagnostic = Diagnostic::error("E0857", message, span, "no such choice");
    match similar(found, choices.iter().map(String::as_str)) {
        Some(near) => diagnostic.help(format!("did you mean `{}`?", shown(&near))).fix(
            format!("change to `{}`", shown(&near)),
            span,
            shown(&near),
        ),
        None => diagnostic.help(format!("the choices are {}", listed(choices, quote))),
    }
}
