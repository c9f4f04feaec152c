//! Suggested changes that a diagnostic offers in addition to its help.

use super::infer::Checker;
use super::tree::{Expr, Kind};
use super::types::Type;
use crate::common_units::{usual, written};
use crate::diagnostic::Diagnostic;

/// Limit of the units offered for a literal.
const MOST_UNITS: usize = 4;

impl Checker<'_> {
    /// Offers units of the required dimension if a literal has no unit or the wrong one.
    pub(super) fn with_units(&self, mut diagnostic: Diagnostic, wanted: &Type, found: &Expr) -> Diagnostic {
        let known = |ty: &Type| match self.store.resolve(ty) {
            Type::Number(dim) | Type::Vector(dim) => dim.as_known(),
            _ => None,
        };
        let (Some(wanted), Some(got)) = (known(wanted), known(&found.ty)) else { return diagnostic };
        let mut factors = Vec::new();
        self.collect_factors(found, true, &mut factors);
        let literals = factors.iter().filter_map(|(factor, above)| {
            let literal = above.then(|| split_literal(self.text(factor.span)))??;
            Some((factor.span, literal))
        });
        let literals: Vec<_> = literals.collect();
        let [(span, (number, unit))] = literals.as_slice() else { return diagnostic };
        // The wrong unit of a single literal can be replaced; next to other factors it may be
        // intended.
        if !unit.is_empty() && factors.len() > 1 {
            return diagnostic;
        }
        if wanted.is_none() && !unit.is_empty() {
            return diagnostic.suggest(format!("write `{number}`"), *span, *number);
        }
        if !got.is_none() && factors.len() > 1 {
            return diagnostic;
        }
        let system = self.shown_system();
        let units = match wanted.is_physics() {
            true => usual(wanted, system),
            false => vec![self.store.vocabulary.unit_of(system, wanted)],
        };
        for unit in units.iter().take(MOST_UNITS) {
            let quantity = written(number, &unit.name);
            // A product of units next to other factors needs parentheses.
            let quantity = match factors.len() > 1 && quantity.contains(['*', '/']) {
                true => format!("({quantity})"),
                false => quantity,
            };
            diagnostic = diagnostic.suggest(format!("write `{quantity}`"), *span, quantity);
        }
        diagnostic
    }

    /// Offers to combine two sides of a sum into one string.
    pub(super) fn as_text(&self, diagnostic: Diagnostic, a: &Expr, b: &Expr) -> Diagnostic {
        let part = |e: &Expr| {
            let text = self.text(e.span);
            let literal = matches!(e.kind, Kind::Text(_)) && text.len() >= 2;
            match literal {
                true => text[1..text.len() - 1].to_string(),
                false => format!("{{{text}}}"),
            }
        };
        let text = format!("\"{}{}\"", part(a), part(b));
        let one_line = !text.contains('\n') && text.len() <= 100;
        match one_line {
            true => diagnostic.suggest(format!("write `{text}`"), a.span.to(b.span), text),
            false => diagnostic,
        }
    }

    /// Offers conversions of a value to the required type.
    pub(super) fn converted(
        &self,
        diagnostic: Diagnostic,
        wanted: &Type,
        found: &Expr,
        got: &Type,
    ) -> Diagnostic {
        let text = self.text(found.span);
        if text.is_empty() || text.len() > 60 || text.contains('\n') {
            return diagnostic;
        }
        let compound = matches!(found.kind, Kind::Binary(..) | Kind::Unary(..) | Kind::If(..));
        let operand = match compound && !text.starts_with('(') {
            true => format!("({text})"),
            false => text.to_string(),
        };
        let offers: Vec<String> = match (wanted, got) {
            (Type::String, Type::Number(_) | Type::Bool | Type::Vector(_)) => vec![format!("\"{{{text}}}\"")],
            (Type::Array(element), _) if self.store.differ(element, got) => Vec::new(),
            (Type::Array(_), _) => vec![format!("[{text}]")],
            (Type::Vector(_), Type::Number(_)) => {
                ["e1", "e2", "e3"].map(|basis| format!("{operand} * {basis}")).into()
            }
            (Type::Number(_), Type::Vector(_)) => {
                let parts = ["x", "y", "z"].map(|part| format!("{operand}.{part}"));
                [format!("norm({text})")].into_iter().chain(parts).collect()
            }
            (Type::Bool, Type::Number(_)) => vec![format!("{text} != 0")],
            (Type::Transform, Type::Vector(_)) => vec![format!("Translate({text})")],
            _ => Vec::new(),
        };
        let suggest = |diagnostic: Diagnostic, offer: String| {
            diagnostic.suggest(format!("write `{offer}`"), found.span, offer)
        };
        offers.into_iter().fold(diagnostic, suggest)
    }
}

/// Splits a literal into number and unit; the unit may be empty.
fn split_literal(text: &str) -> Option<(&str, &str)> {
    let number = |c: char| c.is_ascii_digit() || c == '.';
    let mut end = text.find(|c| !number(c)).unwrap_or(text.len());
    if let Some(exponent) = text[end..].strip_prefix(['e', 'E']) {
        let digits = exponent.strip_prefix(['+', '-']).unwrap_or(exponent);
        let length = digits.find(|c: char| !c.is_ascii_digit()).unwrap_or(digits.len());
        if length > 0 {
            end = text.len() - digits.len() + length;
        }
    }
    let unit = text[end..].trim();
    text[..end].parse::<f64>().ok()?;
    let plain = unit.chars().all(|c| c.is_alphanumeric() || matches!(c, '_' | '^' | '-' | '%'));
    plain.then_some((&text[..end], unit))
}
