//! Diagnostics for derivatives, and for values at another param value, that would miss a
//! dependence.

use super::dependence::{MissedDependence, Question};
use super::infer::Checker;
use super::symbols::{Resolution, VarKind, Variable};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

impl Checker<'_> {
    /// Returns the name of the function whose call a hidden variable contains.
    fn called_function(&self, captured: &Variable) -> Option<&str> {
        let (name, _) = self.text(captured.span).split_once('(')?;
        let name = name.trim_end().rsplit('.').next()?;
        let at = captured.span.start + self.text(captured.span).find(name)? as u32;
        let span = Span { start: at, end: at + name.len() as u32, ..captured.span };
        match self.names.uses.get(&span)? {
            Resolution::Function(id) => Some(&self.names.functions[id.0 as usize].name),
            _ => None,
        }
    }

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
                let help = match (captured.kind, self.called_function(captured)) {
                    (VarKind::Hidden, Some(function)) => format!(
                        "`{function}` is an ordinary function, whose value the expression captures: write it as a \
                         symbolic function, `function {function}(...) := ...;`, so that the value depends on \
                         `{name}` symbolically"
                    ),
                    (VarKind::Hidden, None) => format!(
                        "write an expression of names that are bound with `:=`, so that it depends on `{name}` \
                         symbolically"
                    ),
                    _ => format!(
                        "bind `{}` with `:=`, so that it depends on `{name}` symbolically",
                        captured.name
                    ),
                };
                error(format!("`{}` was computed from `{name}` before", captured.name))
                    .label(captured.span, "captured as a value here")
                    .help(help)
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
