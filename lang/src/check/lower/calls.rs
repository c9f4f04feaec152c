//! Lowers calls of program functions: passes arguments, checks their domains, and stores returned
//! values.

use super::body::Body;
use super::errors::text;
use super::sequence::{calls, order_as_written};
use super::values::own_value;
use crate::ast::Mode;
use crate::check::tree::{ArgumentRange, Call, Expr, Place, Step};
use crate::check::types::Type;
use crate::diagnostic::Diagnostic;
use crate::ir::{self, ExprKind, FunctionId, Op};
use crate::span::Span;
use calyx_abi::Repr;

/// The arguments and returned values of a call.
struct PassedArguments {
    function: FunctionId,
    /// Values of `in` and `inout` parameters, followed by the outer variables that the function
    /// uses.
    arguments: Vec<ir::Expr>,
    copy_back: Vec<ir::Place>,
}

impl Body<'_, '_> {
    /// Lowers a call as a value. A call with `out` values becomes a statement, and its result a
    /// local.
    pub(super) fn call_value(&mut self, call: &Call, ty: &Type, span: Span) -> ir::Expr {
        if !self.has_out_arguments(call.function) {
            let repr = self.call_repr(call);
            let PassedArguments { function, arguments, .. } = self.pass(call, span);
            return ir::Expr { kind: ExprKind::Call(function, arguments), repr, span };
        }
        let repr = self.repr(ty);
        let local = self.temporary_of(repr.clone());
        self.call_statement(call, Some(ir::Place::whole(local, repr.clone())), span);
        ir::Expr { kind: ExprKind::Local(local), repr, span }
    }

    /// Lowers a call whose `out` values are stored. Returns `false` if there are no such values and
    /// the call is an ordinary expression.
    pub(super) fn call_statement(&mut self, call: &Call, result: Option<ir::Place>, span: Span) -> bool {
        if !self.has_out_arguments(call.function) {
            return false;
        }
        let PassedArguments { function, arguments, copy_back } = self.pass(call, span);
        self.push(ir::Statement::Call { result, function, arguments, copy_back, span });
        true
    }

    fn call_repr(&self, call: &Call) -> Repr {
        let checker = self.lowering.checker;
        let Some(function) = checker.functions.get(&call.function) else { return Repr::Unit };
        let at_use = checker.instances.get(call.instance.0 as usize).cloned().unwrap_or_default();
        let result = at_use.ty(&checker.store, &function.result);
        self.repr(&result)
    }

    /// Evaluates arguments and the indices of places from left to right, each once.
    fn pass(&mut self, call: &Call, span: Span) -> PassedArguments {
        let types = self.types.clone();
        let passed = self.passed_functions(&call.arguments);
        let function = self.lowering.used(call.function, call.instance, &types, passed);
        let modes = self.lowering.modes(call.function);
        let demands: Vec<(usize, ArgumentRange)> =
            self.demands(&call.arguments, &call.demands).cloned().collect();
        let perhaps_same = |place| call.perhaps_same.iter().any(|(a, b)| *a == place || *b == place);
        let reordered = order_as_written(&call.arguments, span);
        let in_order = reordered.is_none();
        let order = reordered.unwrap_or_else(|| (0..call.arguments.len()).collect());
        // If an argument needs separate statements, all arguments before it are also evaluated by
        // statements.
        let last = (0..order.len()).rev().find(|position| {
            let at = order[*position];
            let argument = &call.arguments[at];
            let place = modes.get(at).is_some_and(|(_, mode)| *mode != Mode::In);
            !in_order
                || demands.iter().any(|(argument, _)| *argument == at)
                || self.needs_statements(argument)
                || (place && calls(argument))
        });
        let around = std::mem::replace(&mut self.span, span);
        let mut places: Vec<Option<ir::Place>> = vec![None; call.copy_back.len()];
        let mut evaluated: Vec<Option<ir::Expr>> = vec![None; call.arguments.len()];
        for (position, at) in order.into_iter().enumerate() {
            let (Some((_, mode)), argument) = (modes.get(at), &call.arguments[at]) else { continue };
            let before_last = last.is_some_and(|last| position < last);
            let demanded = demands.iter().any(|(argument, _)| *argument == at);
            let value = if *mode == Mode::In {
                self.owned(argument)
            } else {
                let number = modes[..at].iter().filter(|(_, mode)| *mode != Mode::In).count();
                let Some(place) = call.copy_back.get(number) else { continue };
                let again = *mode == Mode::InOut && place.indices().any(calls);
                let kept = before_last || again || perhaps_same(number);
                let place = self.place(place, kept);
                places[number] = Some(place.clone());
                own_value(self.read(place, argument.span))
            };
            // The callee does not read the value of an `out` argument.
            let kept = (before_last || demanded) && *mode != Mode::Out;
            evaluated[at] = Some(if kept { self.kept(value) } else { value });
        }
        let mut copy_back: Vec<ir::Place> = places.into_iter().flatten().collect();
        let values: Vec<ir::Expr> = evaluated.into_iter().flatten().collect();
        let passed = modes.iter().zip(&values).filter(|((_, mode), _)| *mode != Mode::Out);
        let mut arguments: Vec<ir::Expr> = passed.map(|(_, value)| value.clone()).collect();
        for (argument, demand) in &demands {
            if let (Some(value), Some(written)) = (values.get(*argument), call.arguments.get(*argument)) {
                self.demand_of_any(demand, value.clone(), written);
            }
        }
        for (a, b) in &call.perhaps_same {
            if let (Some(first), Some(second), Some(written)) =
                (copy_back.get(*a), copy_back.get(*b), call.copy_back.get(*b))
            {
                let (first, second) = (first.clone(), second.clone());
                self.demand_distinct(&first, &second, written);
            }
        }
        for (variable, mode) in modes.into_iter().skip(call.arguments.len()) {
            let local = self.local(variable);
            let place = ir::Place::whole(local, self.local_repr(local));
            let value = self.read(place.clone(), span);
            if mode == Mode::In {
                // An outer variable passed by `in` is not assigned during the call, so it needs no
                // copy.
                arguments.push(value);
                continue;
            }
            arguments.push(own_value(value));
            if let Some(given) = call.copy_back.iter().find(|given| given.variable == variable) {
                let checker = self.lowering.checker;
                let (name, callee) = (&checker.variable(variable).name, checker.function_name(call.function));
                let diagnostic = Diagnostic::error(
                    "E0310",
                    format!("`{name}` is an `out` argument of `{callee}`, which also assigns it directly"),
                    given.span,
                    "two values for one variable",
                )
                .help("use two variables");
                self.lowering.report(diagnostic);
            }
            copy_back.push(place);
        }
        self.span = around;
        PassedArguments { function, arguments, copy_back }
    }

    /// Checks an argument; an optional one only if it is present.
    pub(super) fn demand_of_any(&mut self, demand: &ArgumentRange, value: ir::Expr, written: &Expr) {
        let store = &self.lowering.checker.store;
        let Type::Optional(inner) = store.shallow(&self.types.ty(store, &written.ty)) else {
            return self.demand(demand, value, written.span, &written.ty);
        };
        let part = |at, repr| ir::Expr {
            kind: ExprKind::TupleElement(Box::new(value.clone()), at),
            repr,
            span: written.span,
        };
        let (present, content) = (part(0, Repr::Bool), part(1, self.repr(&inner)));
        let (check, after) = (self.new_block(), self.new_block());
        self.branch_on(present, check, after);
        self.start(check);
        self.demand(demand, content, written.span, &inner);
        self.jump(after);
        self.start(after);
    }

    /// Lowers a place with its indices, which are evaluated immediately if `kept` is set.
    pub(super) fn place(&mut self, place: &Place, kept: bool) -> ir::Place {
        let local = self.local(place.variable);
        let mut repr = self.local_repr(local);
        let mut steps = Vec::new();
        let last = place.steps.iter().rposition(|step| match step {
            Step::Index(index) => self.needs_statements(index),
            Step::Element(_) | Step::Field(..) => false,
        });
        for (at, step) in place.steps.iter().enumerate() {
            repr = match step {
                Step::Index(index) => {
                    let index = self.value(index);
                    let kept = kept || last.is_some_and(|last| at < last);
                    steps.push(ir::Step::Index(if kept { self.kept(index) } else { index }));
                    match repr {
                        Repr::Array(element) => *element,
                        other => other,
                    }
                }
                Step::Element(_) | Step::Field(..) => {
                    let at = match step {
                        Step::Element(at) => *at,
                        // The checker guarantees that the field exists.
                        Step::Field(record, name) => self.field_of(record, name).map_or(0, |(at, _)| at),
                        Step::Index(_) => 0,
                    };
                    steps.push(ir::Step::Element(at));
                    match repr {
                        Repr::Tuple(parts) => parts.get(at).cloned().unwrap_or(Repr::Number),
                        other => other,
                    }
                }
            };
        }
        ir::Place { local, steps, repr }
    }

    /// Returns the value stored in a place.
    pub(super) fn read(&self, place: ir::Place, span: Span) -> ir::Expr {
        let local = ExprKind::Local(place.local);
        let whole = ir::Expr { kind: local, repr: self.local_repr(place.local), span };
        place.steps.into_iter().fold(whole, |base, step| {
            let repr = match (&base.repr, &step) {
                (Repr::Array(element), ir::Step::Index(_)) => (**element).clone(),
                (Repr::Tuple(parts), ir::Step::Element(at)) => {
                    parts.get(*at).cloned().unwrap_or(Repr::Number)
                }
                _ => Repr::Number,
            };
            let kind = match step {
                ir::Step::Index(index) => ExprKind::Index(Box::new(base), Box::new(index)),
                ir::Step::Element(at) => ExprKind::TupleElement(Box::new(base), at),
            };
            ir::Expr { kind, repr, span }
        })
    }

    /// Fails at run time if two places are the same.
    fn demand_distinct(&mut self, a: &ir::Place, b: &ir::Place, written: &Place) {
        let span = written.span;
        let truth = |kind| ir::Expr { kind, repr: Repr::Bool, span };
        let mut equal = Vec::new();
        for pair in a.steps.iter().zip(&b.steps) {
            match pair {
                (ir::Step::Index(a), ir::Step::Index(b)) => {
                    equal.push(truth(ExprKind::Op(Op::Equal, vec![a.clone(), b.clone()])));
                }
                // Fields whose record is known only in this instance.
                (ir::Step::Element(a), ir::Step::Element(b)) if a != b => return,
                _ => {}
            }
        }
        let same = equal.into_iter().reduce(|a, b| truth(ExprKind::And(Box::new(a), Box::new(b))));
        let same = same.unwrap_or_else(|| truth(ExprKind::Bool(true)));
        let name = &self.lowering.checker.variable(written.variable).name;
        let message = text(&format!("a part of `{name}` is passed to two `out` parameters"), span);
        let (refuse, go_on) = (self.new_block(), self.new_block());
        self.branch_on(same, refuse, go_on);
        self.refuse(
            refuse,
            "E0310",
            message,
            "use two variables, or elements whose indices differ".into(),
            span,
        );
        self.start(go_on);
    }
}
