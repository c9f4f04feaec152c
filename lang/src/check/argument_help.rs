//! Help for dimension errors of arguments: the quantity that the parameter accepts, and the
//! parameter that accepts the given quantity.

use super::infer::Checker;
use super::symbols::with_article;
use super::tree::{Expr, Kind};
use super::types::Type;
use crate::ast::{self, ExprKind};
use crate::common_units::{usual, written};
use crate::diagnostic::Diagnostic;
use crate::dimension::Dimension;
use crate::units::UnitSystem;

/// A parameter that the call omits.
pub(super) struct Free<'a> {
    pub name: &'a str,
    pub ty: Type,
    /// Start of its declaration.
    pub start: u32,
}

/// The help for a number without a unit below this one, in place of a length, names metres too.
const LEAST_LENGTH: f64 = 0.1;

/// Number of parameters of the given quantity above which the help names one of them only: the
/// last one before the parameter, since alternatives are declared next to each other.
const MOST_ALTERNATIVES: usize = 2;

impl Checker<'_> {
    /// Returns the omitted parameters that have a default and a declared type.
    pub(super) fn free_parameters<'d>(
        &mut self,
        decl: &'d ast::FunctionDecl,
        given: &[bool],
    ) -> Vec<Free<'d>> {
        let left_out = decl.parameters.iter().zip(given).filter(|(parameter, given)| {
            !**given && matches!(parameter.default, Some((ast::Bind::Evaluate, Some(_))))
        });
        let typed = left_out.filter_map(|(parameter, _)| {
            let ty = self.annotation(parameter.annotation.as_ref()?, false);
            Some(Free { name: &parameter.name.name, ty, start: parameter.name.span.start })
        });
        typed.collect()
    }

    /// Adds help to the dimension error of an argument, which is among the diagnostics from
    /// `reported` on.
    pub(super) fn explain_argument(
        &mut self,
        reported: usize,
        (parameter, ty): (&ast::Ident, &Type),
        argument: &ast::Argument,
        value: &Expr,
        free: &[Free<'_>],
    ) {
        // A value for an optional parameter has been converted to the parameter's type.
        let given = match &value.kind {
            Kind::Some(inner) => inner,
            _ => value,
        };
        let found = self.dimension_of(&given.ty);
        let Some((wanted, found)) = self.dimension_of(ty).zip(found) else { return };
        let literal = number_of(&argument.value);
        // A ratio such as a coefficient and a quantity are different concepts: no other parameter
        // of the quantity is a likely alternative.
        let is_ratio = wanted.is_none();
        let fits = |other: &&Free<'_>| {
            let dimension = self.dimension_of(&other.ty).filter(|d| !d.is_none());
            !is_ratio && !found.is_none() && dimension.is_some_and(|d| d.fits(found))
        };
        let mut known: Vec<&str> = free.iter().filter(fits).map(|other| other.name).collect();
        if known.len() > MOST_ALTERNATIVES {
            let before = |other: &&Free<'_>| other.start < parameter.span.start;
            known = free
                .iter()
                .filter(fits)
                .filter(before)
                .map(|other| other.name)
                .next_back()
                .into_iter()
                .collect();
        }
        let of = |d: Dimension| with_article(&self.store.vocabulary.show(d));
        let inverse = !wanted.without_angle().is_none() && wanted.times(found).without_angle().is_none();
        let units = usual(wanted, self.shown_system());
        // A file without `units` has metres and pascals, in which machine parts are rarely stated.
        let rank = usize::from(self.shown_system() == UnitSystem::Si && units.len() > 1);
        let unit = match wanted.known_name() {
            Some("Angle") => "deg",
            // Curvatures are mostly diametral pitches.
            Some("Curvature") => "1/inch",
            _ => units.get(rank).map_or("", |unit| unit.name.as_str()),
        };
        let text = self.text(value.span).to_string();
        let name = &parameter.name;
        let mut help = match (inverse, literal) {
            (true, Some(_)) => format!(
                "`{name}` takes {}, such as `{}`: the reciprocal of {}",
                self.store.vocabulary.in_bases(wanted),
                written("10", unit),
                of(found)
            ),
            (true, None) => format!("`{name}` takes the reciprocal of {}: divide 1 by it", of(found)),
            (false, Some(_)) if is_ratio => {
                format!("`{name}` takes {}: the ratio of {} to another one", of(wanted), of(found))
            }
            (false, Some(_)) if wanted.is_fractional() => format!(
                "`{name}` takes {}, because of the exponents in the function and its result type: check them",
                of(wanted)
            ),
            (false, Some(number)) => {
                let metres = wanted.known_name() == Some("Length") && unit == "mm";
                let or = if metres && number.abs() < LEAST_LENGTH {
                    format!(" or `{}`", written(&number.to_string(), "m"))
                } else {
                    String::new()
                };
                format!("`{name}` takes {}, such as `{}`{or}", of(wanted), written(&number.to_string(), unit))
            }
            (false, None) => String::new(),
        };
        if !known.is_empty() {
            let names: Vec<String> = known.iter().map(|name| format!("`{name}`")).collect();
            let verb = if known.len() == 1 { "takes" } else { "take" };
            let before = if help.is_empty() { "" } else { "; " };
            help = format!("{help}{before}{} {verb} {}", names.join(" and "), of(found));
        }
        let Some(diagnostic) = self
            .diagnostics
            .get_mut(reported..)
            .and_then(|new| new.iter_mut().find(|d| d.code == "E0401" && d.primary.span == value.span))
        else {
            return;
        };
        if inverse {
            diagnostic.suggestions.clear();
        }
        if let (Some((written, _)), false) = (&argument.name, text.contains('\n')) {
            for other in &known {
                let title = format!("give it as `{other}`");
                *diagnostic = diagnostic.clone().suggest(title, written.span, *other);
            }
        }
        if inverse && !text.contains('\n') {
            let reciprocal = format!("1 / ({text})");
            *diagnostic = diagnostic.clone().suggest("take the reciprocal", value.span, reciprocal);
        }
        if !help.is_empty() {
            diagnostic.help = match (diagnostic.help.take(), literal) {
                (Some(factor), None) => Some(format!("{factor}; {help}")),
                _ => Some(help),
            };
        }
    }

    /// Offers quotes for a number in place of a text, such as `material = 16MnCr5`, in the
    /// diagnostics from `reported` on.
    pub(super) fn explain_text(&mut self, reported: usize, parameter: &ast::Ident, argument: &ast::Argument) {
        let (place, text) = (argument.value.span, self.text(argument.value.span).trim().to_owned());
        let begins_as_number = text.starts_with(|c: char| c.is_ascii_digit());
        let is_own = |problem: &&mut Diagnostic| {
            let at = problem.primary.span;
            at.file == place.file && place.start <= at.start && at.end <= place.end
        };
        let new = self.diagnostics.get_mut(reported..).unwrap_or_default();
        if let (true, Some(problem)) =
            (begins_as_number && !text.contains(['"', '\n']), new.iter_mut().find(is_own))
        {
            let quoted = format!("\"{text}\"");
            let help = format!("text is in quotes: write `{} = {quoted}`", parameter.name);
            *problem = Diagnostic { fix: None, suggestions: Vec::new(), ..problem.clone() }
                .help(help)
                .suggest(format!("write `{quoted}`"), place, quoted);
        }
    }

    fn dimension_of(&self, ty: &Type) -> Option<Dimension> {
        match self.store.resolve(ty) {
            Type::Number(dim) | Type::Vector(dim) => dim.as_known(),
            Type::Optional(inner) => self.dimension_of(&inner),
            _ => None,
        }
    }
}

/// Returns `true` for a parameter that takes text: one of the type String, or one with a text as
/// its default, from which a function makes the value.
pub(super) fn takes_text(ty: &Type, parameter: &ast::Parameter) -> bool {
    let default = parameter.default.as_ref().and_then(|(_, default)| default.as_ref());
    *ty == Type::String || default.is_some_and(|default| matches!(default.kind, ExprKind::String(_)))
}

/// Returns the number of a literal quantity.
fn number_of(e: &ast::Expr) -> Option<f64> {
    match &e.kind {
        ExprKind::Quantity { value, .. } | ExprKind::Number(value) => Some(*value),
        ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => number_of(inner),
        ExprKind::Binary { left, right, .. } => {
            number_of(left).filter(|_| matches!(right.kind, ExprKind::Name(_)))
        }
        _ => None,
    }
}
