//! Units and choices of outputs, also those that a library function declares for its result, such
//! as `-> Observable(Angle) in urad` and `-> Observable(Number) in ModeType`.

use super::dim::Dim;
use super::infer::Checker;
use super::params::listed;
use super::symbols::{Resolution, with_article};
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind, FunctionBody};
use crate::common_units::{in_system, named};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::ir::DisplayUnit;
use crate::span::Span;

impl<'a> Checker<'a> {
    /// Returns the unit in which a library function shows the value of an output of a type; `None`
    /// if it declares none or the value has another dimension. An angle in microradians times a
    /// length, such as a transmission error times a base radius, is shown in micrometres.
    pub(super) fn usual_unit(&mut self, ty: &Type, value: &'a ast::Expr) -> Option<DisplayUnit> {
        let declared = self.declared_unit(value)?;
        let dim = match self.store.shallow(ty) {
            Type::Number(dim) | Type::Observable(dim) => dim,
            _ => return None,
        };
        let dimension = self.store.dim(&dim).as_known()?.tidy();
        let arc = (declared.name == "urad").then(|| named("um")).flatten();
        let fits = |unit: &DisplayUnit| Dimension::from_exponents(unit.dimension) == Some(dimension);
        let unit = [Some(declared), arc].into_iter().flatten().find(fits)?;
        Some(in_system(unit, self.system().unwrap_or_default()))
    }

    /// Returns the unit that the function of a call declares. A sum, a product and the elements of
    /// an array have that of their first such call.
    fn declared_unit(&mut self, value: &'a ast::Expr) -> Option<DisplayUnit> {
        if let Some(elements) = listed(value) {
            return elements.iter().find_map(|element| self.declared_unit(element));
        }
        match &value.kind {
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => self.declared_unit(inner),
            ExprKind::Binary {
                op: BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply,
                left,
                right,
                ..
            } => self.declared_unit(left).or_else(|| self.declared_unit(right)),
            ExprKind::Call { callee, .. } => {
                let unit = self.after_result(callee)?;
                self.written_unit(unit)
            }
            _ => None,
        }
    }

    /// Returns what a library function states after `in` for its result.
    fn after_result(&self, callee: &ast::Expr) -> Option<&'a ast::Expr> {
        let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
            return None;
        };
        let Some(Resolution::Extern(id)) = self.names.uses.get(&name.span).copied() else {
            return None;
        };
        let decl = self.names.externs[id as usize].decl;
        match &decl.body {
            FunctionBody::Extern { unit, .. } => unit.as_ref(),
            _ => None,
        }
    }

    /// Returns the choices of the enumeration after `in`, which the values of an output number from
    /// 0; `None` if it is a unit. Reports an output that is no pure number.
    pub(super) fn stated_choices(&mut self, ty: &Type, value: Span, e: &ast::Expr) -> Option<Vec<String>> {
        let Type::Enum(of) = self.enum_type(self.enum_of(e)?) else { return None };
        let dim = match self.store.shallow(ty) {
            Type::Number(dim) | Type::Observable(dim) => dim,
            _ => return Some(of.choices.clone()),
        };
        if self.store.unify_dims(&dim, &Dim::known(Dimension::NONE)).is_err() {
            let found = with_article(&self.store.show_dim(&dim));
            let message = format!("this output is {found} and does not number the choices of `{}`", of.name);
            let problem = Diagnostic::error("E0926", message, e.span, "the choices are numbered from 0")
                .label(value, format!("this is {found}"))
                .help("give a pure number, or state a unit of its dimension");
            self.report(problem);
        }
        Some(of.choices.clone())
    }

    /// Returns the choices that the function of a call declares for its result; those of an array
    /// are those of all its elements.
    pub(super) fn usual_choices(&self, value: &'a ast::Expr) -> Option<Vec<String>> {
        if let Some(elements) = listed(value) {
            let mut all = elements.iter().map(|element| self.usual_choices(element));
            let first = all.next()??;
            return all.all(|other| other.as_ref() == Some(&first)).then_some(first);
        }
        match &value.kind {
            ExprKind::Paren(inner) => self.usual_choices(inner),
            ExprKind::Call { callee, .. } => {
                let unit = self.after_result(callee)?;
                let Type::Enum(of) = self.enum_type(self.enum_of(unit)?) else { return None };
                Some(of.choices.clone())
            }
            _ => None,
        }
    }
}
