//! Diagnostics for derivatives, and for values at another param value, that would miss a
//! dependence.

use super::dependence::{MissedDependence, Question};
use super::infer::Checker;
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl Checker<'_> {
    /// Returns the diagnostic for a derivative or value that would miss a dependence on a param.
    pub(super) fn blind(
        &self,
        question: Question,
        param: u32,
        blind: MissedDependence,
        span: Span,
    ) -> Diagnostic {
        let name_of = |id: u32| self.params.get(id as usize).map(|p| p.name.as_str()).unwrap_or_default();
        let name = name_of(param);
        let message = match question {
            Question::Derivative => {
                format!("this derivative with respect to `{name}` would miss a dependence on it")
            }
            Question::Value => format!("this value for another `{name}` would miss a dependence on it"),
        };
        let error = |label: String| Diagnostic::error("E0509", message.clone(), span, label);
        match blind {
            MissedDependence::Computed(id) => {
                let captured = self.variable(id);
                error(format!("`{}` was computed from `{name}` before", captured.name))
                    .label(captured.span, "captured as a value here")
                    .help(format!(
                        "bind `{}` with `:=`, so that it depends on `{name}` symbolically",
                        captured.name
                    ))
            }
            MissedDependence::Conditional(id) => {
                let captured = self.variable(id);
                error(format!("`{}` was assigned under a condition on `{name}`", captured.name))
                    .label(captured.span, "captured as a value here, not as an expression")
                    .help(format!(
                        "bind `{0}` with `{0} := if (...) a else b`, or to a formula; a loop that `{name}` ends \
                         has no derivative by it",
                        captured.name
                    ))
            }
            MissedDependence::Chosen(id) => {
                let bound = self.variable(id);
                error(format!("a condition on `{name}` selects the expression of `{}`", bound.name))
                    .label(bound.span, "bound in several places")
                    .help(format!(
                        "bind `{0}` once, to a conditional expression: `{0} := if (...) a else b`",
                        bound.name
                    ))
            }
            MissedDependence::Follows(other) => {
                let follower = name_of(other);
                let declared = self.params.get(other as usize).map_or(span, |p| p.span);
                error(format!("the default of `{follower}` depends on `{name}`"))
                    .label(declared, format!("depends on `{name}` unless it is set"))
                    .help(format!(
                        "bind what follows `{name}` with `var {follower} := ...`; for the change with `{name}` \
                         alone, use a symbolic function of both"
                    ))
            }
        }
    }
}
