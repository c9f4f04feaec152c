//! Lowers ranges and choices of parameters, which the caller checks at run time.

use super::body::Body;
use super::errors::{error_of, text};
use super::sequence::order_as_written;
use crate::check::tree::{ArgumentRange, Expr};
use crate::check::types::Type;
use crate::ir::{self, ExprKind, FormatPart, Op, Terminator};
use crate::span::Span;
use calyx_abi::display::Display;
use calyx_abi::{Purity, Repr};

impl Body<'_, '_> {
    /// Evaluates the arguments of a library function in the order in which they are written, and
    /// checks them. The library only reads them, so arrays are not copied.
    pub(super) fn extern_arguments(
        &mut self,
        all: &[Expr],
        demands: &[(usize, ArgumentRange)],
        call: Span,
    ) -> Vec<ir::Expr> {
        let demands: Vec<(usize, ArgumentRange)> = self.demands(all, demands).cloned().collect();
        let is_demanded = |at: usize| demands.iter().any(|(argument, _)| *argument == at);
        let reordered = order_as_written(all, call);
        let is_reordered = reordered.is_some();
        let order = reordered.unwrap_or_else(|| (0..all.len()).collect());
        // An argument that needs separate statements is evaluated after all arguments before it.
        let last = order.iter().rposition(|&at| is_demanded(at) || self.needs_statements(&all[at]));
        let mut values: Vec<Option<ir::Expr>> = vec![None; all.len()];
        for (position, at) in order.into_iter().enumerate() {
            let value = self.value(&all[at]);
            let is_before = last.is_some_and(|last| position < last);
            let is_kept = is_reordered || is_before || is_demanded(at);
            values[at] = Some(if is_kept { self.kept(value) } else { value });
        }
        let values: Vec<ir::Expr> = values.into_iter().flatten().collect();
        for (at, demand) in &demands {
            if let (Some(value), Some(argument)) = (values.get(*at), all.get(*at)) {
                self.demand_of_any(demand, value.clone(), argument);
            }
        }
        values
    }

    /// Fails at run time if an argument is outside its domain. Each component of a vector and each
    /// element of an array is checked.
    pub(super) fn demand(&mut self, demand: &ArgumentRange, value: ir::Expr, span: Span, ty: &Type) {
        let tested = match value.repr.clone() {
            Repr::Array(element) => self.first_refused(demand, &value, &element, span),
            _ => self.is_allowed(demand, &value, span).map(|allowed| (allowed, None)),
        };
        let Some((allowed, element)) = tested else { return };
        let display = self.display(ty, None, self.lowering.system);
        let (before, after) = match demand.choices.is_empty() {
            true => (format!("`{}` must lie in {}", demand.name, demand.text), ""),
            false => (format!("`{}` cannot be \"", demand.name), "\""),
        };
        let mut parts = vec![FormatPart::Text(before)];
        let index = element.map(|index| (self.display(&Type::number(), None, self.lowering.system), index));
        match (index, demand.choices.is_empty()) {
            (None, true) => parts.push(FormatPart::Text(", not ".into())),
            (Some((display, index)), true) => {
                parts.push(FormatPart::Text(", but element ".into()));
                parts.push(FormatPart::Value(index.clone(), display));
                parts.push(FormatPart::Text(" is ".into()));
                parts.push(FormatPart::Value(element_of(value.clone(), index), self.element_display(ty)));
            }
            (Some((_, index)), false) => {
                parts.push(FormatPart::Value(element_of(value.clone(), index), self.element_display(ty)));
            }
            (None, false) => {}
        }
        if !matches!(value.repr, Repr::Array(_)) {
            parts.push(FormatPart::Value(value, display));
        }
        parts.push(FormatPart::Text(after.into()));
        let message = ir::Expr { kind: ExprKind::Format(parts), repr: Repr::String, span };
        let help = match demand.choices.is_empty() {
            true => format!("choose a value in {}, limits included", demand.text),
            false => format!("choose one of {}", demand.text),
        };
        let (go_on, refuse) = (self.new_block(), self.new_block());
        self.branch_on(allowed, go_on, refuse);
        self.refuse(refuse, "E0314", message, help, span);
        self.start(go_on);
    }

    /// Returns the condition on a number, vector or text; `None` if everything is allowed.
    fn is_allowed(&mut self, demand: &ArgumentRange, value: &ir::Expr, span: Span) -> Option<ir::Expr> {
        let truth = |kind| ir::Expr { kind, repr: Repr::Bool, span };
        let compare = |op, a: &ir::Expr, b| truth(ExprKind::Op(op, vec![a.clone(), b]));
        let parts = match value.repr {
            Repr::Vector => [Op::X, Op::Y, Op::Z].map(|op| component(op, value)).to_vec(),
            _ => vec![value.clone()],
        };
        let mut allowed = Vec::new();
        for part in &parts {
            let ends =
                [(&demand.low, Op::GreaterEqual, Op::Less), (&demand.high, Op::LessEqual, Op::Greater)];
            for (end, inside, outside) in ends {
                let Some(end) = end else { continue };
                let end = self.value(end);
                allowed.push(match demand.nan_passes {
                    true => truth(ExprKind::Op(Op::Not, vec![compare(outside, part, end)])),
                    false => compare(inside, part, end),
                });
            }
        }
        let chosen = demand.choices.iter().map(|choice| compare(Op::Equal, value, text(choice, span)));
        allowed.extend(chosen.reduce(|a, b| truth(ExprKind::Or(Box::new(a), Box::new(b)))));
        allowed.into_iter().reduce(|a, b| truth(ExprKind::And(Box::new(a), Box::new(b))))
    }

    /// Returns the condition on the elements of an array, and the index of the first element that
    /// violates it; `None` if everything is allowed.
    fn first_refused(
        &mut self,
        demand: &ArgumentRange,
        array: &ir::Expr,
        element: &Repr,
        span: Span,
    ) -> Option<(ir::Expr, Option<ir::Expr>)> {
        let number = |value| ir::Expr { kind: ExprKind::Number(value), repr: Repr::Number, span };
        let (name, parameters, mut arguments) = match element {
            Repr::String if !demand.choices.is_empty() => {
                let choices = demand.choices.iter().map(|choice| text(choice, span)).collect();
                let repr = Repr::Array(Box::new(Repr::String));
                let choices = ir::Expr { kind: ExprKind::Array(choices), repr: repr.clone(), span };
                ("first_unknown", vec![("values", repr.clone()), ("choices", repr)], vec![choices])
            }
            Repr::Number | Repr::Vector if demand.low.is_some() || demand.high.is_some() => {
                let name = match element {
                    Repr::Vector => "first_vector_outside",
                    _ => "first_outside",
                };
                let repr = Repr::Array(Box::new(element.clone()));
                let parameters = vec![
                    ("values", repr),
                    ("low", Repr::Number),
                    ("high", Repr::Number),
                    ("nan_passes", Repr::Bool),
                ];
                let low = demand.low.as_ref().map_or(number(f64::NEG_INFINITY), |low| self.value(low));
                let high = demand.high.as_ref().map_or(number(f64::INFINITY), |high| self.value(high));
                let nan = ir::Expr { kind: ExprKind::Bool(demand.nan_passes), repr: Repr::Bool, span };
                (name, parameters, vec![low, high, nan])
            }
            _ => return None,
        };
        arguments.insert(0, array.clone());
        let id = self.lowering.standard(name, Purity::Pure, &parameters, Repr::Number);
        let index = ir::Expr { kind: ExprKind::CallExtern(id, arguments), repr: Repr::Number, span };
        let index = self.kept(index);
        // Not `index < 0`: the index is NaN if the elements result from a failed call after which
        // `check` continues.
        let truth = |kind| ir::Expr { kind, repr: Repr::Bool, span };
        let refused = truth(ExprKind::Op(Op::GreaterEqual, vec![index.clone(), number(0.0)]));
        Some((truth(ExprKind::Op(Op::Not, vec![refused])), Some(index)))
    }

    /// Returns the display of the elements of an array type.
    fn element_display(&self, ty: &Type) -> Display {
        let checker = self.lowering.checker;
        let element = match checker.store.shallow(&self.types.ty(&checker.store, ty)) {
            Type::Array(element) => *element,
            other => other,
        };
        self.display(&element, None, self.lowering.system)
    }

    pub(super) fn refuse(&mut self, block: usize, code: &str, message: ir::Expr, help: String, span: Span) {
        self.start(block);
        let error = error_of(text(code, span), message, span);
        self.end(Terminator::Throw { error, help, span });
    }
}

fn component(op: Op, vector: &ir::Expr) -> ir::Expr {
    ir::Expr { kind: ExprKind::Op(op, vec![vector.clone()]), repr: Repr::Number, span: vector.span }
}

fn element_of(array: ir::Expr, index: ir::Expr) -> ir::Expr {
    let (repr, span) = match &array.repr {
        Repr::Array(element) => ((**element).clone(), array.span),
        other => (other.clone(), array.span),
    };
    ir::Expr { kind: ExprKind::Index(Box::new(array), Box::new(index)), repr, span }
}
