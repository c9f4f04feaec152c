//! The required type of a value, and the errors for a value of another type.

use super::infer::Checker;
use super::other_modules;
use super::symbols::with_article;
use super::tree::Expr;
use super::types::{Mismatch, Type};
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use std::fmt::Display;

impl Checker<'_> {
    /// Requires that a checked expression has a type. `what` describes the context (`argument
    /// `teeth``), `cause` is the origin of the required type.
    pub fn expect(
        &mut self,
        expected: &Type,
        found: &Expr,
        what: impl Display,
        cause: Option<(Span, String)>,
    ) {
        let origin = cause.as_ref().map(|(span, _)| *span);
        if let Err(mismatch) = self.unify_with(expected, found, origin) {
            self.mismatch(mismatch, expected, found, &what.to_string(), cause);
        }
    }

    /// As [`Self::expect`]; `origin` describes the origin of the required type, which only an error
    /// needs.
    pub(super) fn expect_from(
        &mut self,
        expected: &Type,
        found: &Expr,
        what: impl Display,
        (span, origin): (Span, impl FnOnce(&Self) -> String),
    ) {
        if let Err(mismatch) = self.unify_with(expected, found, Some(span)) {
            let cause = Some((span, origin(self)));
            self.mismatch(mismatch, expected, found, &what.to_string(), cause);
        }
    }

    /// Unifies the type of an expression with the required type, whose origin is given.
    fn unify_with(&mut self, expected: &Type, found: &Expr, origin: Option<Span>) -> Result<(), Mismatch> {
        self.check_turns(expected, &found.ty, found.span, origin);
        self.note_literal(expected, found);
        match self.accepts_choice(expected, found) {
            true => Ok(()),
            false => self.store.unify(expected, &found.ty),
        }
    }

    fn mismatch(
        &mut self,
        mismatch: Mismatch,
        expected: &Type,
        found: &Expr,
        what: &str,
        cause: Option<(Span, String)>,
    ) {
        let (mut wanted, mut got) = (self.store.show(expected), self.store.show(&found.ty));
        if wanted == got {
            (wanted, got) = (self.shown_kind(expected), self.shown_kind(&found.ty));
        }
        if let Mismatch::Dimension(dims) = &mismatch {
            let (wanted, got) = &**dims;
            return self.dimension_mismatch(wanted, got, found, what, cause);
        }
        let resolved = (self.store.shallow(expected), self.store.shallow(&found.ty));
        let mut diagnostic = match (&mismatch, &resolved) {
            (Mismatch::Infinite, _) => too_large(found.span),
            (_, (_, Type::Observable(_))) => self.observable_as_value(found.span),
            (_, (_, Type::Unit)) => Diagnostic::error(
                "E0303",
                format!("{what} needs a value, but this call returns nothing"),
                found.span,
                "no value here",
            )
            .help("call it as a statement, or give the function a `return` with a value"),
            _ => Diagnostic::error(
                "E0301",
                format!("{what} must be {}, not {}", with_article(&wanted), with_article(&got)),
                found.span,
                format!("this is {}", with_article(&got)),
            )
            .help(self.kind_help(&resolved.0, &resolved.1)),
        };
        if diagnostic.code == "E0301" {
            diagnostic = self.converted(diagnostic, &resolved.0, found, &resolved.1);
        }
        if let Some((span, message)) = cause {
            diagnostic = diagnostic.label(span, message);
        }
        self.report(diagnostic);
    }

    /// Returns a type as displayed next to another type of the same name.
    fn shown_kind(&self, ty: &Type) -> String {
        let shown = self.store.show(ty);
        match self.store.shallow(ty) {
            Type::Handle(_) => format!("{shown} of the library"),
            Type::Record(id) => {
                let component = self.component_of(id).map(|id| self.names.functions[id.0 as usize].file);
                let file = component.or_else(|| self.names.records.get(id.0 as usize).map(|r| r.file));
                let module = file.and_then(|file| self.modules.get(file.0 as usize));
                match module.map(|module| module.name.as_str()) {
                    None | Some("") => format!("{shown} of the model"),
                    Some(module) => format!("{shown} of `{module}`"),
                }
            }
            _ => shown,
        }
    }

    fn kind_help(&self, expected: &Type, found: &Type) -> String {
        match (expected, found) {
            (Type::String, _) => "put it into a string: `\"{...}\"`".into(),
            (Type::Array(_), Type::Array(_)) => format!("give {}", with_article(&self.store.show(expected))),
            (Type::Array(_), _) => "put it into brackets: `[...]`".into(),
            (Type::Vector(_), Type::Number(_)) => "multiply it by a basis vector: `... * e3`".into(),
            (Type::Number(_), Type::Vector(_)) => "take a component (`.x`, `.y`, `.z`) or `norm(...)`".into(),
            (Type::Bool, Type::Number(_)) => "compare it: `... != 0`".into(),
            (Type::Transform, Type::Vector(_)) => "convert it to a frame: `Translate(...)`".into(),
            (Type::Handle(name), _) => {
                let makers =
                    |handle: &str| self.names.around.map(|around| around.makers(handle)).unwrap_or_default();
                let found = self.store.show(found);
                other_modules::handle([&makers(name), &makers(&found)], name, &found)
            }
            _ => format!("give {}", with_article(&self.store.show(expected))),
        }
    }

    pub(super) fn observable_as_value(&self, span: Span) -> Diagnostic {
        Diagnostic::error(
            "E0505",
            "an observable has a value only at each step of an analysis",
            span,
            "this is an observable",
        )
        .help("bind the expression with `:=`, or declare it as an `output`")
    }
}

/// Returns the error for a value whose type would be infinite or too large.
pub(super) fn too_large(span: Span) -> Diagnostic {
    Diagnostic::error(
        "E0302",
        "a value cannot contain itself, more than 100 nested arrays or more than 1000 parts",
        span,
        "its type would be infinite or too large",
    )
    .help("use another variable, or an array of parts of one type")
}
