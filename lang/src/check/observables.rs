//! Observables as values. An observable is a number at every step of an analysis; the program
//! computes with it as with a number, and the result is an observable.
//!
//! In a sum, an array, a choice or an assignment of numbers and observables, each number becomes a
//! constant observable. A variable that starts as a number and later receives an observable, as in
//! a sum over a loop, has an observable from its start: the first such assignment requests this,
//! and the unit is checked again.

use super::dim::Dim;
use super::infer::Checker;
use super::records::handle_field;
use super::stored_expressions::is_stored;
use super::symbols::Resolution;
use super::tree::*;
use super::types::Type;
use crate::ast::{self, ExprKind};
use crate::span::Span;

impl Checker<'_> {
    fn is_observable(&self, ty: &Type) -> bool {
        matches!(self.store.known(ty), Type::Observable(_))
    }

    /// Returns whether a type is an array of observables.
    pub(super) fn is_array_of_observables(&self, ty: &Type) -> bool {
        matches!(self.store.known(ty), Type::Array(element) if self.is_observable(element))
    }

    /// Converts a number to a constant observable, and an expression with observables to an
    /// observable. Values of other types are unchanged.
    pub(super) fn as_observable(&mut self, e: Expr) -> Expr {
        let Type::Number(dim) = self.store.shallow(&e.ty) else { return e };
        let span = e.span;
        let def = self.make_def("observable", e, span);
        Expr { kind: Kind::MakeSymbolic(def), ty: Type::Observable(dim), span }
    }

    /// Converts a value to the observable, or the array of observables, that is expected.
    pub(super) fn fitted(&mut self, expected: &Type, e: Expr) -> Expr {
        if self.symbolic {
            return e;
        }
        match (self.store.known(expected), self.store.known(&e.ty)) {
            (Type::Observable(_), Type::Number(_)) => self.as_observable(e),
            (Type::Symbolic(_), found) if is_stored(found) => self.as_expression("expression", e),
            (Type::Array(expected), Type::Array(_)) if self.is_observable(expected) => {
                let expected = expected.clone();
                let Kind::Array(elements) = e.kind else { return e };
                let elements = elements.into_iter().map(|element| self.fitted(&expected, element)).collect();
                Expr { kind: Kind::Array(elements), ty: Type::Array(expected), span: e.span }
            }
            _ => e,
        }
    }

    /// Converts the number to an observable if one of two values is a number and the other one is
    /// an observable.
    pub(super) fn alike(&mut self, a: Expr, b: Expr) -> (Expr, Expr) {
        if self.symbolic {
            return (a, b);
        }
        self.solve_open_constraints([&a.ty, &b.ty].into_iter());
        let (first, second) = (a.ty.clone(), b.ty.clone());
        (self.fitted(&second, a), self.fitted(&first, b))
    }

    /// As [`Self::alike`], for the elements of an array.
    pub(super) fn all_alike(&mut self, elements: Vec<Expr>) -> Vec<Expr> {
        let stored = |ty: &Type| matches!(self.store.known(ty), Type::Observable(_) | Type::Symbolic(_));
        let observable = elements.iter().find(|e| stored(&e.ty)).map(|e| e.ty.clone());
        let Some(ty) = observable.filter(|_| !self.symbolic) else { return elements };
        elements.into_iter().map(|element| self.fitted(&ty, element)).collect()
    }

    /// Returns a number or observable as a number for the rules of operations on numbers, and
    /// whether it is an observable.
    pub(super) fn number_of(&self, e: &Expr) -> (Expr, bool) {
        match self.store.shallow(&e.ty) {
            Type::Observable(dim) if !self.symbolic => (Expr { ty: Type::Number(dim), ..e.clone() }, true),
            _ => (e.clone(), false),
        }
    }

    /// Returns the type of an operation with a number as its result, if some operand is an
    /// observable.
    pub(super) fn observable_if(&self, ty: Type, observes: bool) -> Type {
        match (observes, self.store.shallow(&ty)) {
            (true, Type::Number(dim)) => Type::Observable(dim),
            _ => ty,
        }
    }

    /// Requests that the variable or function declared at a location has an observable instead of a
    /// number. Returns `true` if the value of the assignment or return requires this.
    pub(super) fn observable_requested(&mut self, declared: Span, ty: &Type, value: &Expr) -> bool {
        let number = |ty: &Type| match ty {
            Type::Array(element) => matches!(self.store.known(element), Type::Number(_)),
            ty => matches!(ty, Type::Number(_)),
        };
        let observable = |ty: &Type| match ty {
            Type::Array(element) => self.is_observable(element),
            ty => matches!(ty, Type::Observable(_)),
        };
        let wanted = number(&self.store.shallow(ty)) && observable(&self.store.shallow(&value.ty));
        wanted && self.requested.observables.insert(declared)
    }

    /// Returns the type of a variable or function that has an observable although it starts as a
    /// number.
    pub(super) fn requested_type(&mut self, declared: Span, value: &Type) -> Option<Type> {
        if !self.given.observables.contains(&declared) {
            return None;
        }
        let observable = Type::Observable(self.store.fresh_dim());
        Some(match self.store.shallow(value) {
            Type::Array(_) => Type::array(observable),
            _ => observable,
        })
    }

    /// Returns `true` for a choice between observables whose condition does not depend on `Time` or
    /// on observables.
    pub(super) fn chooses_observable(&self, condition: &Expr, a: &Expr, b: &Expr) -> bool {
        let number = matches!(self.store.known(&a.ty), Type::Number(_));
        number && (self.observes(a) || self.observes(b)) && self.is_known_at_binding(condition)
    }

    /// Returns `true` if an expression depends on an observable.
    fn observes(&self, e: &Expr) -> bool {
        match &e.kind {
            Kind::Observe(_) => true,
            Kind::Def(def) => self.defs[def.0 as usize].observes,
            _ => e.children().into_iter().any(|child| self.observes(child)),
        }
    }

    pub(super) fn is_known_at_binding(&self, e: &Expr) -> bool {
        let own = match &e.kind {
            Kind::Time
            | Kind::Observe(_)
            | Kind::Chosen(_)
            | Kind::Derivative(..)
            | Kind::Gradient(..)
            | Kind::At(..)
            | Kind::SymbolicCall(_) => false,
            Kind::Def(def) => {
                let def = &self.defs[def.0 as usize];
                !def.on_time && !def.observes && def.chosen.is_empty()
            }
            _ => true,
        };
        own && e.children().into_iter().all(|child| self.is_known_at_binding(child))
    }

    /// Returns the value of a condition that was checked as part of an expression.
    pub(super) fn condition_value(&mut self, e: Expr) -> Expr {
        let Expr { kind, ty, span } = e;
        let mut value = |e: Box<Expr>| Box::new(self.condition_value(*e));
        let kind = match kind {
            Kind::Def(def) => Kind::Eval(def, None),
            Kind::Unary(op, a) => Kind::Unary(op, value(a)),
            Kind::Binary(op, a, b) => Kind::Binary(op, value(a), value(b)),
            Kind::If(a, b, c) => Kind::If(value(a), value(b), value(c)),
            Kind::Op(op, all) => Kind::Op(op, all.into_iter().map(|a| self.condition_value(a)).collect()),
            other => other,
        };
        Expr { kind, ty, span }
    }

    /// Returns `true` if a function of numbers receives observables. It is then part of their
    /// expression, as with symbols.
    pub(super) fn passes_observables(&mut self, id: FuncId, arguments: &[ast::Argument]) -> bool {
        self.ensure_inferred(id);
        let Some(signature) = self.signatures.get(&id) else { return false };
        let Some(decl) = self.names.functions[id.0 as usize].decl else { return false };
        let plain = matches!(decl.body, ast::FunctionBody::Statement(_)) && !decl.is_component;
        plain
            && arguments.iter().enumerate().any(|(index, argument)| {
                let at = match &argument.name {
                    Some((name, _)) => decl.parameters.iter().position(|p| p.name.name == name.name),
                    None => Some(index),
                };
                let ty = at.and_then(|at| signature.parameters.get(at));
                let number = ty.is_some_and(|ty| matches!(self.store.known(ty), Type::Number(_)));
                number && self.names_observable(&argument.value)
            })
    }

    /// Returns `true` if the value of an expression is an observable, as far as this is known
    /// before the expression is checked.
    fn names_observable(&self, e: &ast::Expr) -> bool {
        match &e.kind {
            ExprKind::Name(_) | ExprKind::Field { .. } | ExprKind::Index { .. } | ExprKind::Call { .. } => {
                self.written_type(e).is_some_and(|ty| self.is_observable(&ty))
            }
            ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => self.names_observable(inner),
            ExprKind::Binary { op, left, right, .. } => {
                !op.compares() && (self.names_observable(left) || self.names_observable(right))
            }
            ExprKind::If { then, otherwise, .. } => {
                self.names_observable(then) || self.names_observable(otherwise)
            }
            _ => false,
        }
    }

    /// Returns the type of a variable, a part of it, or the result of a call, if it is known.
    pub(super) fn written_type(&self, e: &ast::Expr) -> Option<Type> {
        let meaning = |name: &ast::Ident| self.names.uses.get(&name.span).copied();
        match &e.kind {
            ExprKind::Name(name) => match meaning(name)? {
                Resolution::Var(id) => self.variable_types.get(&id).cloned(),
                Resolution::Output(id) => match self.output_arrays.get(&id) {
                    Some(variable) => self.variable_types.get(variable).cloned(),
                    None => Some(Type::Observable(Dim::none())),
                },
                _ => None,
            },
            ExprKind::Paren(inner) => self.written_type(inner),
            ExprKind::Slice { base, .. } => self.written_type(base),
            ExprKind::Index { base, .. } => match self.store.shallow(&self.written_type(base)?) {
                Type::Array(element) => Some(*element),
                _ => None,
            },
            ExprKind::Field { base, field } => match self.store.shallow(&self.written_type(base)?) {
                Type::Record(id) => self.store.field(id, &field.name).map(|(_, ty)| ty),
                Type::Handle(handle) => handle_field(&handle, &field.name).map(|(_, ty)| ty),
                _ => None,
            },
            ExprKind::Call { callee, .. } => {
                let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
                    return None;
                };
                match meaning(name)? {
                    Resolution::Function(id) => self.signatures.get(&id).map(|known| known.result.clone()),
                    Resolution::Extern(id) => {
                        let result = self.names.externs[id as usize].decl.result.as_ref()?;
                        let observes = matches!(&result.kind, ast::TypeKind::Apply(name, _) if name.name == "Observable");
                        observes.then(|| Type::Observable(Dim::none()))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }
}
