//! Lowers the parts of symbolic expressions that name other expressions: calls, equations to be
//! solved, splines, blocks and fields.

use super::body::Body;
use super::sites::Captures;
use crate::check::expr::component;
use crate::check::solutions::builtin_name;
use crate::check::splines;
use crate::check::tree::{Call, Expr, VarId};
use crate::diagnostic::Diagnostic;
use crate::ir::{SymExpr, SymKind, SymbolicFunctionId};
use crate::span::Span;
use calyx_abi::Repr;
use calyx_abi::newton::{MOST_UNKNOWNS, Search};

impl Body<'_, '_> {
    pub(super) fn symbolic_call(&mut self, call: &Call, span: Span, captures: &mut Captures) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        let arguments: Vec<SymExpr> = call.arguments.iter().map(|a| self.symbolic(a, captures)).collect();
        let reprs: Vec<Repr> = arguments.iter().map(|argument| argument.repr.clone()).collect();
        let Some(function) = self.symbolic_callee(call, &reprs, span) else {
            return make(SymKind::Number(f64::NAN), Repr::Number);
        };
        let repr = self.lowering.program.symbolic_functions[function.0 as usize].result.clone();
        self.call_or_search((function, repr), arguments, call.search, span)
    }

    /// Returns the call of a lowered function with its result, or the point that `solve` or
    /// `minimize` finds.
    pub(super) fn call_or_search(
        &mut self,
        (function, result): (SymbolicFunctionId, Repr),
        arguments: Vec<SymExpr>,
        search: Option<Search>,
        span: Span,
    ) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        match (search, arguments.first().map(|unknown| unknown.repr.clone())) {
            (Some(search), Some(unknown)) => {
                self.check_equations(search, &unknown, &result, span);
                make(SymKind::Solve(search, function, arguments), unknown)
            }
            _ => make(SymKind::Call(function, arguments), result),
        }
    }

    /// Reports unknowns that are not numbers, too many unknowns, and a number of residuals that
    /// differs from that of the unknowns.
    fn check_equations(&mut self, search: Search, unknown: &Repr, residual: &Repr, span: Span) {
        let called = builtin_name(search);
        let (Some(unknowns), Some(residuals)) = (numbers(unknown), numbers(residual)) else {
            self.lowering.report(
                Diagnostic::error(
                    "E0862",
                    format!("the unknowns of `{called}` and the result of its function must be numbers"),
                    span,
                    "a guess or a result of another kind",
                )
                .help("make the unknown a number, a vector or an array of numbers"),
            );
            return;
        };
        let most = MOST_UNKNOWNS;
        let diagnostic = if !(1..=most).contains(&unknowns) {
            Diagnostic::error(
                "E0862",
                format!("`{called}` takes at most {most} unknowns, not {unknowns}"),
                span,
                "too many unknowns",
            )
            .help("search some of them within the function of the others")
        } else if search == Search::Root && unknowns != residuals {
            Diagnostic::error(
                "E0862",
                format!(
                    "`solve` has {unknowns} {} and {residuals} {}",
                    if unknowns == 1 { "unknown" } else { "unknowns" },
                    if residuals == 1 { "equation" } else { "equations" }
                ),
                span,
                "the numbers differ",
            )
            .help("return one residual for each unknown, in brackets")
        } else {
            return;
        };
        self.lowering.report(diagnostic);
    }

    pub(super) fn symbolic_spline(
        &mut self,
        [xs, ys, x]: &[Expr; 3],
        span: Span,
        captures: &mut Captures,
    ) -> SymExpr {
        let make = |kind, repr| SymExpr { kind, repr, span };
        let x = self.symbolic(x, captures);
        match splines::table(xs, ys, &self.lowering.checker.store) {
            Some(Ok(table)) => make(SymKind::Table(table.into(), Box::new(x)), Repr::Number),
            Some(Err(message)) => {
                let diagnostic = Diagnostic::error("E0864", message, span, "invalid points");
                let help = "give as many ordinates as abscissas, in the order of ascending abscissas";
                self.lowering.report(diagnostic.help(help));
                make(SymKind::Number(f64::NAN), Repr::Number)
            }
            None => make(SymKind::Number(f64::NAN), Repr::Number),
        }
    }

    /// Lowers each variable of a block once; its uses share the expression.
    pub(super) fn symbolic_block(
        &mut self,
        bindings: &[(VarId, Expr)],
        result: &Expr,
        captures: &mut Captures,
    ) -> SymExpr {
        for (variable, value) in bindings {
            let value = self.symbolic(value, captures);
            captures.shared.push(value);
            captures.locals.insert(*variable, captures.shared.len() as u32 - 1);
        }
        self.symbolic(result, captures)
    }

    pub(super) fn symbolic_field(
        &mut self,
        base: &Expr,
        name: &str,
        span: Span,
        captures: &mut Captures,
    ) -> SymExpr {
        let field = self.field_of(&base.ty, name);
        let base = self.symbolic(base, captures);
        let make = |kind| SymExpr { kind, repr: Repr::Number, span };
        match (field, component(name)) {
            (Some((at, _)), _) => self.element(base, at, span),
            (None, Some(op)) => make(SymKind::Op(op, vec![base])),
            // Unreachable: the checker guarantees that the field exists.
            (None, None) => make(SymKind::Number(f64::NAN)),
        }
    }
}

/// Returns how many numbers a value contains; `None` if it contains something else.
fn numbers(repr: &Repr) -> Option<usize> {
    match repr {
        Repr::Number | Repr::Vector => Some(repr.slots()),
        Repr::Tuple(parts) => parts.iter().map(numbers).sum(),
        _ => None,
    }
}
