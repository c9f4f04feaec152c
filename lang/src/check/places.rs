//! Places: expressions that can be assigned to, and the detection of aliases among them.

use super::constant;
use super::expected_type::too_large;
use super::infer::Checker;
use super::symbols::{Resolution, VarKind, with_article};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, ExprKind};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

/// The possible overlap of two places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Overlap {
    Never,
    Always,
    /// The places overlap if their indices are equal at run time.
    Perhaps,
}

impl<'a> Checker<'a> {
    /// Rejects the same place in several out parameters, because its final value would be
    /// undefined. Returns the pairs of places that must be compared at run time.
    pub(super) fn distinct_places(&mut self, places: &[Place]) -> Vec<(usize, usize)> {
        let mut perhaps = Vec::new();
        for (index, later) in places.iter().enumerate() {
            for (before, earlier) in places[..index].iter().enumerate() {
                let overlap = self.overlap(earlier, later);
                if overlap == Overlap::Perhaps {
                    perhaps.push((before, index));
                }
                if overlap == Overlap::Always {
                    let name = &self.variable(later.variable).name;
                    let what = match (earlier.steps.is_empty(), later.steps.is_empty()) {
                        (true, true) => format!("`{name}` is passed to two `out` parameters"),
                        (false, false) if earlier.steps.len() == later.steps.len() => {
                            format!("a part of `{name}` is passed to two `out` parameters")
                        }
                        _ => format!("`{name}` and a part of it are passed to two `out` parameters"),
                    };
                    self.report(
                        Diagnostic::error("E0310", what, later.span, "second occurrence")
                            .label(earlier.span, "first occurrence")
                            .help("use two variables"),
                    );
                }
            }
        }
        perhaps
    }

    /// Determines whether storing a value in one place changes the value of the other.
    pub(super) fn overlap(&self, a: &Place, b: &Place) -> Overlap {
        if a.variable != b.variable {
            return Overlap::Never;
        }
        let mut found = Overlap::Always;
        for pair in a.steps.iter().zip(&b.steps) {
            match pair {
                (Step::Element(i), Step::Element(j)) if i == j => {}
                (Step::Field(_, a), Step::Field(_, b)) if a == b => {}
                // One field is resolved, the other is not yet.
                (Step::Field(..), Step::Element(_)) | (Step::Element(_), Step::Field(..)) => {
                    found = Overlap::Perhaps;
                }
                (Step::Index(i), Step::Index(j)) => {
                    let constants = constant::number(i, &self.store).zip(constant::number(j, &self.store));
                    match constants {
                        Some((i, j)) if i != j => return Overlap::Never,
                        Some(_) => {}
                        // Equal expressions without calls have equal values.
                        None if self.text(i.span).trim() == self.text(j.span).trim() && !calls(i) => {}
                        None => found = Overlap::Perhaps,
                    }
                }
                _ => return Overlap::Never,
            }
        }
        found
    }

    /// Checks an assignment target.
    pub(super) fn place(&mut self, e: &'a ast::Expr) -> Option<Place> {
        match &e.kind {
            ExprKind::Name(name) => match self.names.uses.get(&name.span).copied() {
                Some(Resolution::Var(id)) if self.variable(id).kind != VarKind::Symbolic => {
                    // Its length may change.
                    self.array_lengths.remove(&id);
                    Some(Place { variable: id, steps: Vec::new(), ty: self.variable_type(id), span: e.span })
                }
                Some(Resolution::Var(id)) => {
                    self.report(self.keeps_expression(id, e.span));
                    None
                }
                Some(Resolution::Param(id)) => {
                    let declared = self.params.get(id as usize).map(|p| p.span);
                    let diagnostic = Diagnostic::error(
                        "E0207",
                        format!("the param `{}` cannot be assigned", name.name),
                        e.span,
                        "a param is set before the run",
                    )
                    .help("copy it into a variable: `var x = ...;`");
                    let diagnostic = match declared {
                        Some(span) => diagnostic.label(span, "declared here"),
                        None => diagnostic,
                    };
                    self.report(diagnostic);
                    None
                }
                Some(Resolution::Const(id)) => {
                    let declared = self.names.consts[id as usize].decl.name.span;
                    self.report(
                        Diagnostic::error(
                            "E0220",
                            format!("the constant `{}` cannot be assigned", name.name),
                            e.span,
                            "declared with `const`",
                        )
                        .label(declared, "declared here")
                        .help("declare it with `var` if it is to change"),
                    );
                    None
                }
                Some(Resolution::Unknown) | None => None,
                Some(_) => {
                    self.no_place(e.span);
                    None
                }
            },
            ExprKind::Index { base, index } => {
                let place = self.place(base)?;
                let index = self.as_value(|c| c.expr(index));
                let at = super::expr::constant_index(&index, &self.store);
                self.expect(&Type::number(), &index, "an index", None);
                self.element_place(place, index, at, e.span)
            }
            ExprKind::Field { base, field } => {
                let module = matches!(&base.kind, ExprKind::Name(name)
                    if matches!(self.names.uses.get(&name.span), Some(Resolution::Module(_))));
                if module {
                    self.expr(e);
                    self.no_place(e.span);
                    return None;
                }
                let place = self.place(base)?;
                self.field_place(place, field, e.span)
            }
            ExprKind::Paren(inner) => self.place(inner),
            ExprKind::Error => None,
            _ => {
                self.as_value(|c| c.expr(e));
                self.no_place(e.span);
                None
            }
        }
    }

    /// Returns an element of the array or tuple in a place; `at` is the index if it is constant.
    fn element_place(
        &mut self,
        mut place: Place,
        index: Expr,
        at: Option<usize>,
        span: Span,
    ) -> Option<Place> {
        let base_ty = self.store.shallow(&place.ty);
        let (step, ty) = match (&base_ty, at) {
            (Type::Array(_) | Type::Unknown(_) | Type::Error, _) => {
                let element = self.store.fresh();
                if self.store.unify(&base_ty, &Type::array(element.clone())).is_err() {
                    self.report(too_large(span));
                    return None;
                }
                (Step::Index(index), element)
            }
            (Type::Tuple(parts), Some(at)) => match parts.get(at) {
                Some(part) => (Step::Element(at), part.clone()),
                None => {
                    self.report(
                        Diagnostic::error(
                            "E0305",
                            format!("this tuple has {} elements, so there is no element {at}", parts.len()),
                            span,
                            "index out of range",
                        )
                        .help("indices start at 0"),
                    );
                    return None;
                }
            },
            (Type::Tuple(_), None) => {
                self.report(
                    Diagnostic::error(
                        "E0305",
                        "the index of a tuple must be a constant whole number",
                        span,
                        "its elements have different types",
                    )
                    .help("make the elements the same type to get an array"),
                );
                return None;
            }
            (other, _) => {
                let shown = with_article(&self.store.show(other));
                self.report(
                    Diagnostic::error(
                        "E0305",
                        format!("{shown} cannot be indexed"),
                        span,
                        format!("this is {shown}"),
                    )
                    .help("only arrays and tuples can be indexed"),
                );
                return None;
            }
        };
        place.steps.push(step);
        Some(Place { ty, span, ..place })
    }

    /// Returns a field of the record in a place.
    fn field_place(&mut self, mut place: Place, field: &ast::Ident, span: Span) -> Option<Place> {
        self.named_fields.push((field.clone(), place.ty.clone()));
        let (step, ty) = match self.store.shallow(&place.ty) {
            Type::Error => return None,
            Type::Record(id) => match self.store.field(id, &field.name) {
                Some((at, ty)) => {
                    if let Some(kind) = self.fixed_member(id, &field.name) {
                        let what = self.text(span).to_string();
                        self.report(member_assigned(kind, &what, span));
                        return None;
                    }
                    (Step::Element(at), ty)
                }
                None => {
                    self.report(self.no_field(&Type::Record(id), &field.name, field.span));
                    return None;
                }
            },
            Type::Vector(_) => {
                self.report(component_assigned(&field.name, span));
                return None;
            }
            Type::Unknown(_) => {
                let ty = self.store.fresh();
                let (base, name) = (place.ty.clone(), field.name.to_string());
                let kind = ConstraintKind::Field(base, name, ty.clone(), FieldUse::Assigned);
                self.constrain(Constraint { kind, span: field.span });
                (Step::Field(place.ty.clone(), field.name.to_string()), ty)
            }
            other => {
                self.report(self.no_field(&other, &field.name, field.span));
                return None;
            }
        };
        place.steps.push(step);
        Some(Place { ty, span, ..place })
    }

    /// Returns the `:=` name of a target; such a name cannot be assigned a value.
    pub(super) fn symbolic_target(&self, e: &ast::Expr) -> Option<VarId> {
        let ExprKind::Name(name) = &e.kind else { return None };
        match self.names.uses.get(&name.span) {
            Some(Resolution::Var(id)) if self.variable(*id).kind == VarKind::Symbolic => Some(*id),
            _ => None,
        }
    }

    pub(super) fn keeps_expression(&self, id: VarId, span: Span) -> Diagnostic {
        let variable = self.variable(id);
        let message = format!("`{}` is symbolic and cannot be assigned a value", variable.name);
        Diagnostic::error("E0503", message, span, "assigned with `=`")
            .label(variable.span, "declared with `:=` here")
            .help(format!("write `{} := ...`, or use another variable", variable.name))
    }

    fn no_place(&mut self, span: Span) {
        self.report(
            Diagnostic::error("E0208", "this cannot be assigned to", span, "not a variable")
                .help("assign to a variable, to an element of an array or tuple, or to a field of a record"),
        );
    }
}

/// Returns the error for an assignment to a param or output of an instance; `kind` states which.
pub(super) fn member_assigned(kind: &str, name: &str, span: Span) -> Diagnostic {
    let message = format!("the {kind} `{name}` cannot be assigned");
    Diagnostic::error("E0207", message, span, format!("the component has already used its {kind}s"))
        .help("copy it into a variable: `var x = ...;`")
}

/// Returns the error for an assignment to a component of a vector.
pub(super) fn component_assigned(name: &str, span: Span) -> Diagnostic {
    Diagnostic::error(
        "E0208",
        format!("the component `.{name}` of a vector cannot be assigned"),
        span,
        "the components of a vector cannot change separately",
    )
    .help("assign a new vector: `v = a*e1 + b*e2 + c*e3;`")
}

/// Returns the expression that reads a place.
pub(super) fn place_value(place: &Place) -> Kind {
    let variable = Kind::Var(place.variable);
    place.steps.iter().fold(variable, |base, step| {
        let ty = match step {
            Step::Field(ty, _) => ty.clone(),
            _ => Type::Error,
        };
        let base = Box::new(Expr { kind: base, ty, span: place.span });
        match step {
            Step::Index(index) => Kind::Index(base, Box::new(index.clone())),
            Step::Element(at) => Kind::TupleElement(base, *at),
            Step::Field(_, name) => Kind::Field(base, name.clone()),
        }
    })
}

/// Returns `true` if an expression contains a call.
pub(super) fn calls(e: &Expr) -> bool {
    matches!(e.kind, Kind::Call(_) | Kind::CallExtern(..)) || e.children().into_iter().any(calls)
}
