//! Suggestions for unknown units.
//!
//! A fix is automatic only if every interpretation has the same dimension and size: `Nm` is `N*m`
//! and not `N`, but `mPa` may be 0.001 Pa or `MPa`.

use super::infer::Checker;
use super::symbols::similar;
use crate::ast;
use crate::diagnostic::Diagnostic;
use crate::span::Span;
use crate::units::Unit;

/// Limit of the units written without an operator between them.
const MOST_FACTORS: usize = 3;

/// SI prefixes and their factors.
const PREFIXES: &[(&str, &str)] = &[
    ("p", "1e-12"),
    ("n", "1e-9"),
    ("u", "1e-6"),
    ("µ", "1e-6"),
    ("μ", "1e-6"),
    ("m", "0.001"),
    ("c", "0.01"),
    ("d", "0.1"),
    ("h", "100"),
    ("k", "1000"),
    ("M", "1e6"),
    ("G", "1e9"),
    ("T", "1e12"),
];

impl Checker<'_> {
    pub(super) fn unknown_unit(&mut self, unit: &ast::Ident, label: &str) {
        let name = unit.name.as_str();
        let diagnostic = Diagnostic::error("E0403", format!("`{name}` is not a unit"), unit.span, label);
        let near = near_units(name);
        let (mut products, prefixed) = (self.products(name), prefixed(name));
        // `inchs` is a plural, `Pas` is a product, `lbfs` may be either.
        let plural = name.strip_suffix('s').filter(|one| Unit::find(one).is_some()).map_or(0, str::len);
        match plural {
            0..=2 => {}
            3 => products.extend(name.strip_suffix('s').map(str::to_string)),
            _ => products.clear(),
        }
        let diagnostic = match (&near[..], &products[..], prefixed) {
            ([only], _, None) if only.to_lowercase() == name.to_lowercase() => diagnostic
                .help(format!("did you mean `{only}`?"))
                .fix(format!("change to `{only}`"), unit.span, *only),
            (_, _, Some((factor, of))) => {
                let help = format!(
                    "write `{factor} {of}` for each `{name}`, or declare the unit: `unit {name} = {factor} {of};`"
                );
                suggested(diagnostic.help(help), &near, unit.span)
            }
            (_, [only], None) => {
                let diagnostic = diagnostic.help(format!("join units with `*`: `{only}`"));
                match self.product_in_place(unit, only) {
                    Some((place, text)) => diagnostic.fix(format!("write `{only}`"), place, text),
                    None => diagnostic,
                }
            }
            (_, [first, .., last], None) => {
                let help = format!("write `{first}` or `{last}`");
                let places = products.iter().filter_map(|product| self.product_in_place(unit, product));
                places.zip(&products).fold(diagnostic.help(help), |diagnostic, ((place, text), product)| {
                    diagnostic.suggest(format!("write `{product}`"), place, text)
                })
            }
            ([only], [], None) if name.chars().count() > 2 => diagnostic
                .help(format!("did you mean `{only}`?"))
                .fix(format!("change to `{only}`"), unit.span, *only),
            ([], [], None) => self.own_unit_or_variable(diagnostic, unit),
            (near, [], None) => {
                let names: Vec<String> = near.iter().map(|name| format!("`{name}`")).collect();
                let help = format!("did you mean {}?", names.join(" or "));
                suggested(diagnostic.help(help), near, unit.span)
            }
        };
        self.report(diagnostic);
    }

    fn own_unit_or_variable(&self, diagnostic: Diagnostic, unit: &ast::Ident) -> Diagnostic {
        let own = self.names.units.iter().map(|unit| unit.decl.name.name.as_str());
        match similar(&unit.name, own) {
            Some(near) => diagnostic.help(format!("did you mean `{near}`?")).fix(
                format!("change to `{near}`"),
                unit.span,
                near,
            ),
            None => diagnostic.help(format!(
                "write `*` between a number and a variable, or declare the unit: `unit {} = ...;`",
                unit.name
            )),
        }
    }

    /// Returns the products of different units that a name may denote, the shortest first: `N*m`
    /// for `Nm`.
    fn products(&self, name: &str) -> Vec<String> {
        let is_unit = |part: &str| {
            Unit::find(part).is_some() || self.names.units.iter().any(|unit| unit.decl.name.name == part)
        };
        let mut found: Vec<Vec<&str>> = Vec::new();
        let mut left: Vec<(Vec<&str>, &str)> = vec![(Vec::new(), name)];
        while let Some((factors, rest)) = left.pop() {
            if rest.is_empty() {
                found.push(factors);
                continue;
            }
            if factors.len() == MOST_FACTORS {
                continue;
            }
            let ends = rest.char_indices().map(|(at, c)| at + c.len_utf8());
            for end in ends.take(LONGEST_FACTOR) {
                let (factor, rest) = rest.split_at(end);
                if is_unit(factor) && !factors.contains(&factor) {
                    left.push(([&factors[..], &[factor]].concat(), rest));
                }
            }
        }
        found.sort_by_key(|factors| factors.len());
        found.iter().map(|factors| factors.join("*")).collect()
    }

    /// Returns the range and the text that replace a name by a product of units, in parentheses
    /// after `/` or `^`. Returns `None` before an exponent, which would apply only to the last
    /// unit.
    fn product_in_place(&self, unit: &ast::Ident, product: &str) -> Option<(Span, String)> {
        let text = &self.modules.get(unit.span.file.0 as usize)?.text;
        let (start, end) = (unit.span.start as usize, unit.span.end as usize);
        if text.get(end..)?.trim_start().starts_with('^') {
            return None;
        }
        let number = number_start(text.get(..start)?);
        match text[..number].trim_end().ends_with(['/', '^']) {
            false => Some((unit.span, product.to_string())),
            true => {
                let place = Span { start: number as u32, ..unit.span };
                Some((place, format!("({}{product})", &text[number..start])))
            }
        }
    }
}

/// Length of the longest unit name that is combined with another.
const LONGEST_FACTOR: usize = 8;

fn suggested(diagnostic: Diagnostic, names: &[&str], place: Span) -> Diagnostic {
    names
        .iter()
        .take(3)
        .fold(diagnostic, |diagnostic, name| diagnostic.suggest(format!("change to `{name}`"), place, *name))
}

/// Returns the units with the most similar spelling. Spellings of the same unit count once.
fn near_units(name: &str) -> Vec<&'static str> {
    let mut found: Vec<&'static str> = Vec::new();
    for near in Unit::nearest(name) {
        let unit = Unit::find(near);
        if !found.iter().any(|other| Unit::find(other) == unit) {
            found.push(near);
        }
    }
    found
}

/// Returns the SI prefix and the unit of a name.
fn prefixed(name: &str) -> Option<(&'static str, &str)> {
    let is_unit = |rest: &str| Unit::find(rest).is_some_and(|unit| unit.name == rest && rest != "%");
    // Only units without a prefix can have one.
    let is_bare =
        |rest: &str| !PREFIXES.iter().any(|(prefix, _)| rest.strip_prefix(prefix).is_some_and(is_unit));
    PREFIXES.iter().find_map(|(prefix, factor)| {
        let rest = name.strip_prefix(prefix)?;
        (is_unit(rest) && is_bare(rest)).then_some((*factor, rest))
    })
}

/// Returns the start of the number at the end of a text.
fn number_start(text: &str) -> usize {
    let bytes = text.trim_end().as_bytes();
    let mut at = bytes.len();
    while let Some(last) = at.checked_sub(1) {
        let sign = last > 0 && matches!(bytes[last], b'+' | b'-') && matches!(bytes[last - 1], b'e' | b'E');
        if !(bytes[last].is_ascii_digit() || matches!(bytes[last], b'.' | b'e' | b'E') || sign) {
            break;
        }
        at = last;
    }
    at
}
