//! Units of outputs that a library function declares for its result, such as
//! `-> Observable(Angle) in urad`.

use super::infer::Checker;
use super::params::listed;
use super::symbols::Resolution;
use super::types::Type;
use crate::ast::{self, BinaryOp, ExprKind, FunctionBody};
use crate::common_units::{in_system, named};
use crate::dimension::Dimension;
use crate::ir::DisplayUnit;

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
                let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
                    return None;
                };
                let Some(Resolution::Extern(id)) = self.names.uses.get(&name.span).copied() else {
                    return None;
                };
                let decl = self.names.externs[id as usize].decl;
                let FunctionBody::Extern { unit: Some(unit), .. } = &decl.body else { return None };
                self.written_unit(unit)
            }
            _ => None,
        }
    }
}
