//! Unused variables (W0201).
//!
//! A variable that only names a part of the model is not reported: `var mesh = gears.mesh(a, b);`
//! adds a mesh, whether an expression uses it or not. In a model without outputs, such as one that
//! shows the data of a gear, the objects of libraries are the result.

use super::Resolver;
use crate::ast::{Expr, ExprKind, FunctionBody, FunctionDecl, TypeKind};
use crate::check::annotate::handles_of;
use crate::check::symbols::{Names, Resolution, VarKind};
use crate::check::tree::VarId;
use crate::diagnostic::Diagnostic;
use crate::span::FileId;

/// Effect of an expression on the model, for a variable that nothing uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Effect {
    /// It adds something: an instance of a component, a body.
    Adds,
    /// It creates an object of a library, such as a gear.
    Creates,
    None,
}

impl Resolver<'_> {
    /// Returns the effect of the expression that a variable names.
    pub(super) fn effect(&self, value: &Expr) -> Effect {
        match &value.kind {
            ExprKind::Call { callee, .. } => self.effect_of_call(callee),
            ExprKind::Paren(inner) => self.effect(inner),
            ExprKind::List(elements) => self.strongest(elements.iter()),
            ExprKind::Comprehension(parts) => self.strongest(std::iter::once(&parts.element)),
            _ => Effect::None,
        }
    }

    fn strongest<'e>(&self, values: impl Iterator<Item = &'e Expr>) -> Effect {
        let found: Vec<Effect> = values.map(|value| self.effect(value)).collect();
        let has = |effect| found.contains(&effect);
        if has(Effect::Adds) {
            Effect::Adds
        } else if has(Effect::Creates) {
            Effect::Creates
        } else {
            Effect::None
        }
    }

    fn effect_of_call(&self, callee: &Expr) -> Effect {
        let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
            return Effect::None;
        };
        match self.names.uses.get(&name.span) {
            Some(Resolution::Extern(id)) => {
                self.names.externs.get(*id as usize).map_or(Effect::None, |found| of_extern(found.decl))
            }
            Some(Resolution::Function(id)) => {
                let Some(function) = self.names.functions.get(id.0 as usize) else { return Effect::None };
                match function.decl {
                    _ if function.is_component() => Effect::Adds,
                    Some(decl) if function.file != FileId(0) && self.returns_part(decl) => Effect::Adds,
                    Some(decl) if function.file != FileId(0) && self.returns_record(decl) => Effect::Creates,
                    _ => Effect::None,
                }
            }
            _ => Effect::None,
        }
    }

    /// Returns true if a function returns a part of the model, such as a body, as engine functions
    /// that build the scene do.
    fn returns_part(&self, decl: &FunctionDecl) -> bool {
        let Some(TypeKind::Name(name)) = decl.result.as_ref().map(|result| &result.kind) else {
            return false;
        };
        self.names.externs.iter().any(|found| {
            let result = found.decl.result.as_ref().map(|result| &result.kind);
            matches!(result, Some(TypeKind::Name(other)) if other.name == name.name)
                && of_extern(found.decl) == Effect::Adds
        })
    }

    fn returns_record(&self, decl: &FunctionDecl) -> bool {
        let Some(result) = &decl.result else { return false };
        let (TypeKind::Name(name) | TypeKind::Member(_, name)) = &result.kind else { return false };
        matches!(self.names.uses.get(&name.span), Some(Resolution::Record(_)))
    }
}

/// Engine functions that build the scene add what they return, except for observables, which
/// without an output have no effect.
fn of_extern(decl: &FunctionDecl) -> Effect {
    let (FunctionBody::Extern { purity, .. }, Some(result)) = (&decl.body, &decl.result) else {
        return Effect::None;
    };
    let is_object = matches!(&result.kind, TypeKind::Name(name) if handles_of(decl).iter().any(|handle| *handle == name.name));
    match purity.as_ref().map(|word| word.name.as_str()) {
        _ if !is_object => Effect::None,
        Some("pure") => Effect::Creates,
        _ => Effect::Adds,
    }
}

/// Reports the variables of the model that nothing reads; `created` name objects of libraries.
pub(super) fn report(names: &mut Names<'_>, created: &[VarId]) {
    let shown = if names.outputs.is_empty() { created } else { &[] };
    for (index, variable) in names.variables.iter().enumerate() {
        let unused = variable.reads == 0
            && variable.span.file == FileId(0)
            && matches!(variable.kind, VarKind::Value | VarKind::Symbolic)
            && !variable.name.starts_with('_')
            && !shown.contains(&VarId(index as u32));
        if unused {
            names.diagnostics.push(
                Diagnostic::warning(
                    "W0201",
                    format!("`{}` is never used", variable.name),
                    variable.span,
                    "declared here",
                )
                .help("remove it, or start its name with `_` to keep it"),
            );
        }
    }
}
