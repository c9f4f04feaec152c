//! Checks comprehensions that declare instances of a component: `var stages = [Stage(g) for g in
//! gears];`.
//!
//! The params of all instances are listed before the program runs, so their number must be known to
//! the compiler. The element is checked once for each pass, and every pass is an instance of its
//! own.

use super::constant;
use super::infer::Checker;
use super::symbols::{Resolution, VarKind};
use super::tree::*;
use super::types::Type;
use crate::ast::{self, Comprehension, ExprKind, Values};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

/// Limit of the instances of one comprehension.
const MOST_INSTANCES: f64 = 10_000.0;

/// The passes of a comprehension whose number is known.
struct Passes {
    /// Statements that evaluate the values.
    statements: Vec<Stmt>,
    /// The value of the variable in each pass.
    values: Vec<Expr>,
}

impl<'a> Checker<'a> {
    /// Records the length of an array that a declaration assigns, if the brackets show it.
    pub(super) fn note_length(&mut self, id: VarId, value: &Expr) {
        if let Kind::Array(elements) = &value.kind {
            self.array_lengths.insert(id, elements.len());
        }
    }

    /// Returns `true` if the element of a comprehension is an instance of a component, or contains
    /// one in brackets.
    pub(super) fn makes_instances(&self, element: &ast::Expr) -> bool {
        match &element.kind {
            ExprKind::Call { callee, .. } => {
                let (ExprKind::Name(name) | ExprKind::Field { field: name, .. }) = &callee.kind else {
                    return false;
                };
                match self.names.uses.get(&name.span) {
                    Some(Resolution::Function(id)) => self.names.functions[id.0 as usize].is_component(),
                    _ => false,
                }
            }
            ExprKind::Paren(inner) => self.makes_instances(inner),
            ExprKind::List(elements) => elements.iter().any(|element| self.makes_instances(element)),
            ExprKind::Comprehension(parts) => self.makes_instances(&parts.element),
            _ => false,
        }
    }

    /// Checks a comprehension that declares instances.
    pub(super) fn instances_for_each(&mut self, parts: &'a Comprehension, span: Span) -> Expr {
        let variable = &parts.variable;
        let Some(Resolution::Var(declared)) = self.names.uses.get(&variable.span).copied() else {
            return Expr::error(span);
        };
        let Some(Passes { statements, values }) = self.passes(parts) else {
            return Expr::error(span);
        };
        let ty = self.variable_type(declared);
        let around = self.unrolled.remove(&declared);
        let mut elements = Vec::with_capacity(values.len());
        let element_type = self.store.fresh();
        for value in values {
            self.expect(&ty, &value, format_args!("`{}`", variable.name), None);
            self.unrolled.insert(declared, value);
            let element = self.whole(&parts.element);
            self.expect(&element_type, &element, "an element of this array", None);
            elements.push(element);
        }
        match around {
            Some(around) => self.unrolled.insert(declared, around),
            None => self.unrolled.remove(&declared),
        };
        let ty = Type::array(element_type);
        let array = Expr { kind: Kind::Array(elements), ty: ty.clone(), span };
        if statements.is_empty() {
            return array;
        }
        Expr { kind: Kind::Sequence(statements, Box::new(array)), ty, span }
    }

    fn passes(&mut self, parts: &'a Comprehension) -> Option<Passes> {
        if let Some(condition) = &parts.condition {
            return self.unknown_number(condition.span, "a condition may leave out elements");
        }
        match &parts.values {
            Values::Range(low, high) => {
                let limits = [low, high].map(|limit| {
                    let limit = self.as_value(|c| c.expr(limit));
                    self.expect(&Type::number(), &limit, "a limit of a range", None);
                    constant::number(&limit, &self.store).filter(|limit| limit.fract() == 0.0)
                });
                let [Some(low), Some(high)] = limits else {
                    return self.unknown_number(parts.values.span(), "the limits are no constant integers");
                };
                if high - low > MOST_INSTANCES {
                    return self.unknown_number(parts.values.span(), "more than 10000 instances");
                }
                let span = parts.values.span();
                let count = (high - low).max(0.0) as usize;
                let value =
                    |at: usize| Expr { kind: Kind::Number(low + at as f64), ty: Type::number(), span };
                Some(Passes { statements: Vec::new(), values: (0..count).map(value).collect() })
            }
            Values::Elements(array) => {
                let array = self.elements_of(array);
                self.passes_through(array, &parts.variable)
            }
        }
    }

    fn passes_through(&mut self, array: Expr, variable: &ast::Ident) -> Option<Passes> {
        let span = array.span;
        let mut statements = Vec::new();
        match array.kind {
            Kind::Error => None,
            Kind::Array(elements) => {
                let mut values = Vec::with_capacity(elements.len());
                for element in elements {
                    // A literal stays known before the model runs.
                    if is_literal(&element) || constant::scalar(&element, &self.store).is_some() {
                        values.push(element);
                        continue;
                    }
                    let (value, keep) = self.keep(&variable.name, element);
                    statements.push(keep);
                    values.push(value);
                }
                Some(Passes { statements, values })
            }
            Kind::Var(id) if !self.names.assigned.contains(&id) && self.array_lengths.contains_key(&id) => {
                let count = self.array_lengths[&id];
                let Type::Array(element) = self.store.shallow(&array.ty) else { return None };
                let values = (0..count).map(|at| {
                    let at = Expr { kind: Kind::Number(at as f64), ty: Type::number(), span };
                    let kind = Kind::Index(Box::new(array.clone()), Box::new(at));
                    Expr { kind, ty: (*element).clone(), span }
                });
                Some(Passes { statements, values: values.collect() })
            }
            Kind::Var(id) if self.variable(id).kind == VarKind::Value => {
                self.unknown_number(span, "an array whose length depends on the run")
            }
            _ => self.unknown_number(span, "its length is known only when the model runs"),
        }
    }

    fn unknown_number<T>(&mut self, span: Span, label: &str) -> Option<T> {
        self.report(
            Diagnostic::error(
                "E0868",
                "the number of instances must be known before the model runs",
                span,
                label,
            )
            .help(
                "go through brackets, a `const`, a variable that is declared with brackets and never assigned, or a \
                 range with constant limits",
            ),
        );
        None
    }
}

/// Returns `true` for a literal. The dimension of one without a unit may not be known yet.
fn is_literal(e: &Expr) -> bool {
    match &e.kind {
        Kind::Number(_) | Kind::Bare(..) | Kind::Bool(_) | Kind::Text(_) => true,
        Kind::Unary(_, operand) => is_literal(operand),
        _ => false,
    }
}
