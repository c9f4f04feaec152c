//! Functions as arguments: a function is lowered once for each list of functions that calls pass to
//! it.

use super::Lowering;
use super::body::Body;
use super::instances::Around;
use super::sites::Captures;
use crate::check::tree::{Applied, Expr, FuncId, Kind, PassedFunction, VarId};
use crate::check::types::{Substitution, Type};
use crate::diagnostic::Diagnostic;
use crate::ir::{self, Capture, ExprKind, Site, SiteId, SymExpr, SymKind};
use crate::span::Span;
use calyx_abi::Repr;
use std::hash::{Hash, Hasher};

/// A function of the program as an argument.
#[derive(Clone)]
pub(super) struct FunctionValue {
    pub(super) unit: usize,
    pub(super) function: FuncId,
    pub(super) around: Around,
    pub(super) types: Substitution,
    /// The values that an anonymous function captures, and the functions among them, by position of
    /// the parameter.
    captured: Vec<Repr>,
    passed: Passed,
    /// The types in order, as text: equal for equal types.
    key: String,
}

/// The functions that a call passes, by position of the parameter.
pub(super) type Passed = Vec<(usize, FunctionValue)>;

impl PartialEq for FunctionValue {
    fn eq(&self, other: &Self) -> bool {
        (self.unit, self.function, self.around, &self.captured, &self.passed, &self.key)
            == (other.unit, other.function, other.around, &other.captured, &other.passed, &other.key)
    }
}

impl Eq for FunctionValue {}

impl Hash for FunctionValue {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.unit, self.function, self.around, &self.captured, &self.passed, &self.key).hash(state);
    }
}

impl Body<'_, '_> {
    /// Returns the functions among the arguments of a call.
    pub(super) fn passed_functions(&self, arguments: &[Expr]) -> Passed {
        let value = |(at, e)| Some((at, self.function_value(e)?));
        arguments.iter().enumerate().filter_map(value).collect()
    }

    fn function_value(&self, e: &Expr) -> Option<FunctionValue> {
        match &e.kind {
            Kind::Function(PassedFunction::Parameter(id), _) => self.functions.get(id).cloned(),
            &Kind::Function(PassedFunction::Declared(id, instance), ref values) => {
                let (unit, function, types) = self.lowering.callee(id, instance, &self.types)?;
                let linked = self.lowering.linked;
                let typed = linked.typed.get(unit)?;
                // Functions outside of components do not depend on the instance.
                let in_component = typed.functions.get(&function)?.component.is_some();
                let around = self.lowering.around.filter(|_| in_component);
                let mut all: Vec<String> = types
                    .types
                    .iter()
                    .map(|(id, ty)| format!("{id:?} {:?}", typed.store.resolve(ty)))
                    .collect();
                all.extend(types.dims.iter().map(|(id, dim)| format!("{id:?} {:?}", typed.store.dim(dim))));
                all.sort();
                let of_value = |value: &Expr| match self.function_value(value) {
                    Some(function) => Repr::Tuple(function.captured),
                    None => self.repr(&value.ty),
                };
                let captured = values.iter().map(of_value).collect();
                let own = typed.functions.get(&function)?.parameters.len().saturating_sub(values.len());
                let passed = self.passed_functions(values);
                let passed = passed.into_iter().map(|(at, value)| (own + at, value)).collect();
                Some(FunctionValue { unit, function, around, types, captured, passed, key: all.join("; ") })
            }
            _ => None,
        }
    }

    /// Returns the representation of what a passed function captures, for its parameter and the
    /// variables that copy it.
    pub(super) fn environment(&self, variable: VarId) -> Option<Repr> {
        let mut at = variable;
        while let Some(copied) = self.lowering.checker.environments.get(&at) {
            at = *copied;
        }
        Some(Repr::Tuple(self.functions.get(&at)?.captured.clone()))
    }

    /// Lowers a call of a parameter that is a function, in a symbolic expression.
    pub(super) fn symbolic_applied(
        &mut self,
        applied: &Applied,
        span: Span,
        captures: &mut Captures,
    ) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        let mut arguments: Vec<SymExpr> =
            applied.arguments.iter().map(|argument| self.symbolic(argument, captures)).collect();
        let environment = self.symbolic(&applied.environment, captures);
        match (&environment.repr, environment.kind) {
            (_, SymKind::Brackets(captured)) => arguments.extend(captured),
            (Repr::Tuple(parts), kind) => {
                let whole = SymExpr { kind, repr: Repr::Tuple(parts.clone()), span };
                for (at, part) in (0..).zip(parts) {
                    arguments.push(make(SymKind::Element(Box::new(whole.clone()), at), part.clone()));
                }
            }
            _ => {}
        }
        let reprs: Vec<Repr> = arguments.iter().map(|argument| argument.repr.clone()).collect();
        let Some(function) = self.applied_function(applied, &reprs, span) else {
            return make(SymKind::Number(f64::NAN), Repr::Number);
        };
        let result = self.lowering.program.symbolic_functions[function.0 as usize].result.clone();
        self.call_or_search((function, result), arguments, applied.search, span)
    }

    fn applied_function(
        &mut self,
        applied: &Applied,
        reprs: &[Repr],
        span: Span,
    ) -> Option<ir::SymbolicFunctionId> {
        let Some(passed) = self.functions.get(&applied.parameter).cloned() else {
            self.report_unknown_function(applied, span);
            return None;
        };
        self.lowering.passed_symbolic(&passed, reprs, span)
    }

    /// Lowers a call of a parameter that is a function, as a value.
    pub(super) fn applied_value(&mut self, applied: &Applied, ty: &Type, span: Span) -> ir::Expr {
        let make = |kind, repr| ir::Expr { kind, repr, span };
        let mut arguments = self.owned_values(&applied.arguments, span);
        let environment = self.value(&applied.environment);
        if let Repr::Tuple(parts) = &environment.repr {
            for (at, part) in parts.iter().enumerate() {
                let element = ExprKind::TupleElement(Box::new(environment.clone()), at);
                arguments.push(make(element, part.clone()));
            }
        }
        let Some(passed) = self.functions.get(&applied.parameter).cloned() else {
            self.report_unknown_function(applied, span);
            return make(ExprKind::Number(f64::NAN), self.repr(ty));
        };
        let linked = self.lowering.linked;
        let called = linked.typed.get(passed.unit).and_then(|typed| typed.functions.get(&passed.function));
        if called.is_none_or(|called| called.definition.is_none()) {
            let FunctionValue { unit, function, around, types, passed, .. } = passed;
            let function = self.lowering.instance(unit, function, types, (around, passed));
            return make(ExprKind::Call(function, arguments), self.repr(ty));
        }
        let reprs: Vec<Repr> = arguments.iter().map(|argument| argument.repr.clone()).collect();
        let Some(function) = self.lowering.passed_symbolic(&passed, &reprs, span) else {
            return make(ExprKind::Number(f64::NAN), self.repr(ty));
        };
        let result = self.lowering.program.symbolic_functions[function.0 as usize].result.clone();
        let name = self.lowering.checker.variable(applied.parameter).name.to_string();
        let captured = |(at, repr): (usize, &Repr)| {
            let kind = SymKind::Capture(at as u32);
            let capture = Capture { name: name.clone(), repr: repr.clone(), observable: false };
            (SymExpr { kind, repr: repr.clone(), span }, capture)
        };
        let (inputs, captures): (Vec<_>, Vec<_>) = reprs.iter().enumerate().map(captured).unzip();
        let site = SiteId(self.lowering.program.sites.len() as u32);
        self.lowering.program.sites.push(Site {
            name,
            shared: Vec::new(),
            expr: SymExpr { kind: SymKind::Call(function, inputs), repr: result.clone(), span },
            captures,
            repr: result.clone(),
            order: if result == Repr::Transform { 2 } else { 0 },
            part: false,
            span,
        });
        let value =
            make(ExprKind::MakeSymbolic { site, captures: arguments }, Repr::Symbolic(Box::new(result)));
        let time = make(ExprKind::Number(0.0), Repr::Number);
        make(ExprKind::EvalSymbolic { value: Box::new(value), time: Box::new(time) }, self.repr(ty))
    }

    /// Reports a function that reaches its call as a value, such as the argument of another
    /// parameter. A unit on its own has no calls that pass functions.
    fn report_unknown_function(&mut self, applied: &Applied, span: Span) {
        if self.lowering.alone() {
            return;
        }
        let name = self.lowering.checker.variable(applied.parameter).name.to_string();
        self.lowering.report(
            Diagnostic::error(
                "E0865",
                format!("`{name}` is not known here: a call passes a function by its name"),
                span,
                "a function that was passed as a value",
            )
            .help("pass functions to named functions only, not to parameters that are functions"),
        );
    }
}

impl Lowering<'_> {
    /// Lowers a function that was passed as an argument for symbolic arguments.
    fn passed_symbolic(
        &mut self,
        passed: &FunctionValue,
        reprs: &[Repr],
        span: Span,
    ) -> Option<ir::SymbolicFunctionId> {
        let around = std::mem::replace(&mut self.around, passed.around);
        let (function, types) = (passed.function, passed.types.clone());
        let found = self.within(passed.unit, |lowering| {
            lowering.symbolic_function(function, types, (reprs, &passed.passed), span)
        });
        self.around = around;
        found
    }
}
