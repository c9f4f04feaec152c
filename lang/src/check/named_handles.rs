//! Texts that are the names of handles, as in `material = "steel"`.
//!
//! A module declares the names of a handle type with an engine function that has one parameter, a
//! text with a list of choices, and returns the handle:
//!
//! ```text
//! extern pure function named_material(in name: String in ["steel", "C45"]) -> Material;
//! ```
//!
//! Where a `Material` is expected, a text is the argument of this function. A name that is not in
//! the list is reported at compile time if it is constant, otherwise at run time.

use super::infer::Checker;
use super::tree::{ArgumentRange, Expr, Kind};
use super::types::Type;
use crate::ast::{Domain, FunctionBody, FunctionDecl, TypeKind};

/// Returns the handle type whose names a function declares.
pub fn named_type(decl: &FunctionDecl) -> Option<&str> {
    let FunctionBody::Extern { purity: Some(purity), .. } = &decl.body else { return None };
    let ([parameter], Some(result)) = (decl.parameters.as_slice(), &decl.result) else { return None };
    let (Some(annotation), TypeKind::Name(handle)) = (&parameter.annotation, &result.kind) else {
        return None;
    };
    let is_text = matches!(&annotation.kind, TypeKind::Name(name) if name.name == "String");
    let has_choices = matches!(parameter.domain, Some(Domain::Choices { .. }));
    let names = purity.name == "pure" && parameter.name.name == "name" && is_text && has_choices;
    names.then_some(handle.name.as_str())
}

impl Checker<'_> {
    /// Converts a text where a handle is expected to the handle of this name. Returns any other
    /// value unchanged. `parameter` is the name of the parameter or field in messages.
    pub(super) fn named_handle(&mut self, ty: &Type, value: Expr, parameter: &str) -> Expr {
        let wanted = self.without_optional(ty, &value);
        let (Type::Handle(handle), Type::String) = (self.store.known(&wanted), self.store.known(&value.ty))
        else {
            return value;
        };
        let handle = handle.clone();
        let names = |info: &super::symbols::ExternInfo<'_>| named_type(info.decl) == Some(handle.as_str());
        let Some(id) = self.names.externs.iter().position(names) else { return value };
        let (decl, file) = (self.names.externs[id].decl, self.names.externs[id].file);
        let domain = decl.parameters[0].domain.as_ref();
        let demand = self.in_file(file, |c| c.domain(&Type::String, domain, Some(&value), parameter));
        let demands = demand.map(|demand| (0, ArgumentRange { nan_passes: true, ..demand }));
        let span = value.span;
        let kind = Kind::CallExtern(id as u32, vec![value], demands.into_iter().collect());
        Expr { kind, ty: Type::Handle(handle), span }
    }
}
