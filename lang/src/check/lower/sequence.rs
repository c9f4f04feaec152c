//! Left-to-right evaluation of expressions that need separate statements: calls that return `out`
//! values or have checked arguments. Operands before such a part are stored in temporaries, and
//! `&`, `|` and `if` become branches.

use super::body::Body;
use super::values::own_value;
use crate::ast::{BinaryOp, Mode};
use crate::check::tree::{ArgumentRange, Expr, FuncId, Function, Kind};
use crate::ir::{self, ExprKind, Place, Statement};
use crate::span::Span;
use calyx_abi::Repr;

impl Body<'_, '_> {
    /// Records whether any expression in a function needs separate statements, so that most
    /// functions are searched only once.
    pub(super) fn look_for_statements(&mut self, function: &Function) {
        self.sequenced = true;
        let mut found = false;
        for statement in &function.body {
            statement
                .walk(&mut |s| found = found || s.expressions().iter().any(|e| self.needs_statements(e)));
        }
        self.sequenced = found;
    }

    /// Returns `true` if a function has `out` or `inout` values, so that a call needs a separate
    /// statement.
    pub(super) fn has_out_arguments(&self, function: FuncId) -> bool {
        self.lowering.modes(function).iter().any(|(_, mode)| *mode != Mode::In)
    }

    /// Returns `true` if a part of an expression needs separate statements.
    pub(super) fn needs_statements(&self, e: &Expr) -> bool {
        self.sequenced && self.searched(e)
    }

    fn searched(&self, e: &Expr) -> bool {
        let own = match &e.kind {
            Kind::Call(call) => {
                self.has_out_arguments(call.function)
                    || self.demands(&call.arguments, &call.demands).next().is_some()
                    || order_as_written(&call.arguments, e.span).is_some()
            }
            Kind::CallExtern(_, all, demands) => {
                self.demands(all, demands).next().is_some() || order_as_written(all, e.span).is_some()
            }
            Kind::Op(_, all) | Kind::Tuple(all) => order_as_written(all, e.span).is_some(),
            Kind::Sequence(..) => true,
            Kind::Binary(..) => self.exchanged(e) || self.is_array(&e.ty),
            Kind::Unary(..) => self.is_array(&e.ty),
            Kind::MakeSymbolic(def) | Kind::Eval(def, _) => {
                let def = &self.lowering.checker.defs[def.0 as usize];
                !def.checks.is_empty()
                    || !def.stored && def.captures.iter().any(|(_, value)| self.searched(value))
            }
            _ => false,
        };
        own || e.children().into_iter().any(|child| self.searched(child))
    }

    /// Returns `true` if the operation exchanges its operands and both contain calls.
    pub(super) fn exchanged(&self, e: &Expr) -> bool {
        match &e.kind {
            Kind::Binary(BinaryOp::Multiply | BinaryOp::Divide, a, b) => {
                calls(a) && calls(b) && self.repr(&a.ty) == Repr::Vector
            }
            _ => false,
        }
    }

    /// Evaluates expressions in the order in which they are written.
    pub(super) fn values(&mut self, all: &[Expr], whole: Span) -> Vec<ir::Expr> {
        self.in_order(all, whole, |f, e| f.value(e))
    }

    /// Evaluates as `values` does, and copies arrays that a place still refers to.
    pub(super) fn owned_values(&mut self, all: &[Expr], whole: Span) -> Vec<ir::Expr> {
        self.in_order(all, whole, |f, e| f.owned(e))
    }

    pub(super) fn pair(&mut self, a: &Expr, b: &Expr) -> (ir::Expr, ir::Expr) {
        let first = self.value(a);
        let first = if self.needs_statements(b) { self.kept(first) } else { first };
        (first, self.value(b))
    }

    fn in_order(
        &mut self,
        all: &[Expr],
        whole: Span,
        value: impl Fn(&mut Self, &Expr) -> ir::Expr,
    ) -> Vec<ir::Expr> {
        if let Some(order) = order_as_written(all, whole) {
            let mut values: Vec<Option<ir::Expr>> = vec![None; all.len()];
            for at in order {
                let evaluated = value(self, &all[at]);
                values[at] = Some(self.kept(evaluated));
            }
            return values.into_iter().flatten().collect();
        }
        let last = all.iter().rposition(|e| self.needs_statements(e));
        let lower = |(index, e)| {
            let value = value(self, e);
            if last.is_some_and(|last| index < last) { self.kept(value) } else { value }
        };
        all.iter().enumerate().map(lower).collect()
    }

    /// Stores a value in a temporary, so that later code cannot change it.
    pub(super) fn kept(&mut self, value: ir::Expr) -> ir::Expr {
        let value = own_value(value);
        if matches!(
            value.kind,
            ExprKind::Number(_) | ExprKind::Bool(_) | ExprKind::String(_) | ExprKind::Param(_)
        ) {
            return value;
        }
        let (repr, span) = (value.repr.clone(), value.span);
        let local = self.temporary(value);
        ir::Expr { kind: ExprKind::Local(local), repr, span }
    }

    /// Evaluates one of two expressions, depending on a condition.
    pub(super) fn choose(
        &mut self,
        condition: ir::Expr,
        repr: Repr,
        span: Span,
        then: impl FnOnce(&mut Self) -> ir::Expr,
        otherwise: impl FnOnce(&mut Self) -> ir::Expr,
    ) -> ir::Expr {
        let local = self.temporary_of(repr.clone());
        let (yes, no, after) = (self.new_block(), self.new_block(), self.new_block());
        self.branch_on(condition, yes, no);
        self.start(yes);
        let value = then(self);
        self.set(local, value);
        self.jump(after);
        self.start(no);
        let value = otherwise(self);
        self.set(local, value);
        self.jump(after);
        self.start(after);
        ir::Expr { kind: ExprKind::Local(local), repr, span }
    }

    fn set(&mut self, local: ir::LocalId, value: ir::Expr) {
        let (place, span) = (Place::whole(local, value.repr.clone()), value.span);
        self.push(Statement::Assign { place, value, span });
    }

    /// Returns the argument checks that could not be decided at compile time.
    pub(super) fn demands<'t>(
        &self,
        arguments: &'t [Expr],
        demands: &'t [(usize, ArgumentRange)],
    ) -> impl Iterator<Item = &'t (usize, ArgumentRange)> {
        let store = &self.lowering.checker.store;
        demands.iter().filter(move |(argument, demand)| {
            let value = arguments.get(*argument);
            !value.is_some_and(|value| demand.is_decided(value, store))
        })
    }
}

/// Returns the evaluation order of arguments or fields, by index: those that are written from left
/// to right, then the defaults. Returns `None` if the order of the parameters has the same effect.
pub(super) fn order_as_written(parts: &[Expr], whole: Span) -> Option<Vec<usize>> {
    let is_written =
        |e: &Expr| e.span.file == whole.file && e.span.start >= whole.start && e.span.end <= whole.end;
    let mut order: Vec<usize> = (0..parts.len()).collect();
    order.sort_by_key(|at| match is_written(&parts[*at]) {
        true => (false, parts[*at].span.start),
        false => (true, 0),
    });
    if order.is_sorted() {
        return None;
    }
    let effects: Vec<Effect> = order.iter().map(|at| effect(&parts[*at])).collect();
    let exchanged = |first: usize, second: usize| {
        let both = [effects[first], effects[second]];
        let noticed = match both.iter().max() {
            Some(Effect::Assigns) => both.iter().min() >= Some(&Effect::Reads),
            _ => both.iter().min() >= Some(&Effect::Acts),
        };
        order[first] > order[second] && noticed
    };
    let noticed =
        (0..order.len()).any(|first| (first + 1..order.len()).any(|second| exchanged(first, second)));
    noticed.then_some(order)
}

/// Side effects of evaluating an expression, the weakest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Effect {
    Nothing,
    /// Reads variables.
    Reads,
    /// Calls or prints, or may fail.
    Acts,
    /// Calls a function of the program, which may assign outer variables.
    Assigns,
}

fn effect(e: &Expr) -> Effect {
    let own = match &e.kind {
        Kind::Number(_) | Kind::Bare(..) | Kind::Bool(_) | Kind::Text(_) => Effect::Nothing,
        Kind::Call(_) | Kind::Applied(_) => Effect::Assigns,
        Kind::CallExtern(..)
        | Kind::Print(..)
        | Kind::Index(..)
        | Kind::Eval(..)
        | Kind::Sequence(..)
        | Kind::Standard(..)
        | Kind::UnitAxis(_) => Effect::Acts,
        _ => Effect::Reads,
    };
    e.children().into_iter().map(effect).fold(own, Effect::max)
}

/// Returns `true` if an expression contains a call.
pub(super) fn calls(e: &Expr) -> bool {
    matches!(e.kind, Kind::Call(_) | Kind::Applied(_) | Kind::CallExtern(..) | Kind::Print(..))
        || e.children().into_iter().any(calls)
}
