//! Checks the ranges and choices of params and parameters. Constant values are checked at compile
//! time, others at run time: params when they are set, arguments of library functions by the
//! library, other arguments by the caller ([`ArgumentRange`]).

use super::constant;
use super::infer::Checker;
use super::symbols::similar;
use super::tree::{ArgumentRange, Expr, Kind};
use super::types::{Store, Type};
use crate::ast::{Domain, Parameter};
use crate::diagnostic::Diagnostic;
use crate::dimension::{Base, Dimension};
use crate::span::Span;
use crate::units::Unit;

/// A value and its domain.
pub struct Check {
    name: String,
    ty: Type,
    /// The value; `None` to check only the range itself.
    value: Option<Expr>,
    low: Option<Expr>,
    high: Option<Expr>,
    choices: Vec<String>,
    /// Other names of choices, each with its choice.
    other_names: Vec<(String, String)>,
    span: Span,
    /// The range as written.
    text: String,
}

impl Check {
    /// Returns the choice that the documentation lists for another name, and `true` if it has the
    /// same meaning. A name that ends with `...` in the documentation stands for all that begin
    /// alike. Case, blanks and hyphens do not matter.
    fn other_name(&self, text: &str) -> Option<(&str, bool)> {
        let plain = |text: &str| {
            let letters = text.chars().filter(|c| !matches!(c, ' ' | '-' | '_'));
            letters.flat_map(char::to_lowercase).collect::<String>()
        };
        let own = plain(text);
        let known = |name: &str| match name.strip_suffix("...") {
            Some(start) if own.starts_with(&plain(start)) => Some(false),
            _ => (plain(name) == own).then_some(true),
        };
        let found =
            self.other_names.iter().filter_map(|(name, choice)| Some((choice.as_str(), known(name)?)));
        let found = found.filter(|(choice, _)| self.choices.iter().any(|known| known == choice));
        found.max_by_key(|(_, is_same)| *is_same)
    }
}

impl ArgumentRange {
    /// Returns `true` if the value and the domain are constant, so that the check happens at
    /// compile time.
    pub fn is_decided(&self, value: &Expr, store: &Store) -> bool {
        let number = |e: &Expr| constant::number(e, store).is_some_and(|number| !number.is_nan());
        let ends = || self.low.iter().chain(&self.high).all(number);
        let is_text = match elements(value).as_slice() {
            [] => false,
            all => all.iter().all(|e| constant::text(e).is_some()),
        };
        is_text || (elements(value).into_iter().all(number) && ends())
    }
}

/// Returns the elements of an array literal, recursively; nothing for `none`; for any other
/// expression, the expression itself.
fn elements(e: &Expr) -> Vec<&Expr> {
    match &e.kind {
        Kind::Array(all) => all.iter().flat_map(elements).collect(),
        // The value of an optional parameter, if there is one.
        Kind::Some(value) => elements(value),
        Kind::None => Vec::new(),
        _ => vec![e],
    }
}

impl<'a> Checker<'a> {
    /// Registers a domain to be checked when all types are known. Its limits must have the type
    /// `ty`, or the type of its elements or components. Returns the run-time check of the value.
    pub(super) fn domain(
        &mut self,
        ty: &Type,
        domain: Option<&'a Domain>,
        value: Option<&Expr>,
        name: &str,
    ) -> Option<ArgumentRange> {
        let domain = domain?;
        let ty = &self.scalar(ty);
        let check = match domain {
            Domain::Range { low, high, span } => {
                let around = self.constant_place.replace("a range");
                let mut ends = [None, None];
                for (end, e) in ends.iter_mut().zip([low, high]) {
                    if let Some(e) = e {
                        let e = self.as_value(|c| c.whole(e));
                        self.expect(ty, &e, format_args!("a limit of the range of `{name}`"), None);
                        *end = Some(e);
                    }
                }
                self.constant_place = around;
                let [low, high] = ends;
                Check {
                    name: name.into(),
                    ty: ty.clone(),
                    value: value.cloned(),
                    low,
                    high,
                    choices: Vec::new(),
                    other_names: Vec::new(),
                    span: *span,
                    text: self.text(*span).to_string(),
                }
            }
            Domain::Choices { values, span, other_names } => {
                let around = self.constant_place.replace("a list of choices");
                let mut choices = Vec::new();
                for e in values {
                    let e = self.as_value(|c| c.expr(e));
                    self.expect(&Type::String, &e, "a choice", None);
                    choices.extend(constant::text(&e).map(str::to_string));
                }
                self.constant_place = around;
                let text = self.text(*span).to_string();
                Check {
                    name: name.into(),
                    ty: ty.clone(),
                    value: value.cloned(),
                    low: None,
                    high: None,
                    choices,
                    other_names: other_names.clone(),
                    span: *span,
                    text,
                }
            }
        };
        let demand = ArgumentRange {
            name: check.name.clone(),
            low: check.low.clone(),
            high: check.high.clone(),
            choices: check.choices.clone(),
            text: check.text.trim_start_matches("in").trim().into(),
            nan_passes: false,
        };
        self.domains.push(check);
        Some(demand)
    }

    /// Returns the type of the numbers in an array or vector; for any other type, the type itself.
    pub(super) fn scalar(&self, ty: &Type) -> Type {
        match self.store.known(ty) {
            Type::Array(element) => self.scalar(element),
            Type::Optional(inner) => self.scalar(inner),
            Type::Vector(dim) => Type::Number(dim.clone()),
            other => other.clone(),
        }
    }

    /// Checks the range or choices of a function's parameter at the declaration.
    pub(super) fn parameter_domain(&mut self, ty: &Type, parameter: &'a Parameter) {
        let Some(domain) = &parameter.domain else { return };
        let open = matches!(self.store.known(ty), Type::Unknown(_));
        let bare = match domain {
            Domain::Range { low, high, .. } => low.iter().chain(high).any(super::expr::is_bare),
            Domain::Choices { .. } => false,
        };
        // Under a unit system, a literal without a unit has the dimension of each call.
        if open && bare && self.system().is_some() {
            return;
        }
        self.domain(ty, Some(domain), None, &parameter.name.name);
    }

    /// Returns `true` if two resolved types have the same kind and dimension.
    fn fits(&self, a: &Type, b: &Type) -> bool {
        match (self.store.resolve(a), self.store.resolve(b)) {
            (Type::Number(a), Type::Number(b)) => match (a.as_known(), b.as_known()) {
                (Some(a), Some(b)) => a.fits(b),
                _ => true,
            },
            (a, b) => a == b,
        }
    }

    pub(super) fn check_domains(&mut self) {
        for check in std::mem::take(&mut self.domains) {
            let low = check.low.as_ref().and_then(|e| constant::number(e, &self.store));
            let high = check.high.as_ref().and_then(|e| constant::number(e, &self.store));
            let ends = [&check.low, &check.high];
            let mut types = ends.into_iter().chain([&check.value]).flatten().map(|e| self.scalar(&e.ty));
            let expected = self.scalar(&check.ty);
            if !types.all(|ty| self.fits(&ty, &expected)) {
                continue;
            }
            if let (Some(low), Some(high)) = (low, high)
                && low > high
            {
                let mut diagnostic = Diagnostic::error(
                    "E0313",
                    format!("the range of `{}` is empty", check.name),
                    check.span,
                    "the lower limit is above the upper limit",
                )
                .help("write the lower limit first");
                if let (Some(low), Some(high)) = (&check.low, &check.high) {
                    let swapped = format!("{} .. {}", self.text(high.span), self.text(low.span));
                    let title = format!("write `{swapped}`");
                    diagnostic = diagnostic.suggest(title, low.span.to(high.span), swapped);
                }
                self.report(diagnostic);
            }
            for value in check.value.iter().flat_map(elements) {
                // An optional value of another type was already reported.
                if !self.fits(&self.scalar(&value.ty), &expected) {
                    continue;
                }
                if let Some(number) = constant::number(value, &self.store) {
                    self.check_range(&check, [low, high], number, value.span);
                }
                if let Some(text) = constant::text(value) {
                    self.check_choice(&check, text, value.span);
                }
            }
        }
    }

    /// Checks a constant number against a range.
    fn check_range(&mut self, check: &Check, [low, high]: [Option<f64>; 2], number: f64, span: Span) {
        if !low.is_some_and(|low| number < low) && !high.is_some_and(|high| number > high) {
            return;
        }
        let range = check.text.trim_start_matches("in").trim();
        let message = format!("`{}` must lie in {range}", check.name);
        let diagnostic = Diagnostic::error("E0314", message, span, "outside the allowed range")
            .label(check.span, "allowed here")
            .help(format!("choose a value in {range}, limits included"));
        // An angle without a unit that would be within the range in degrees.
        let angle = Dimension::of(Base::Angle);
        let written = self.text(span).trim().to_owned();
        let in_degrees = number.to_radians();
        let fits = !low.is_some_and(|low| in_degrees < low) && !high.is_some_and(|high| in_degrees > high);
        let is_angle = match self.store.resolve(&check.ty) {
            Type::Number(dim) => dim.as_known() == Some(angle),
            _ => false,
        };
        if written.parse() == Ok(number) && is_angle && fits {
            self.report(
                diagnostic
                    .help(format!("a number without a unit is in radians: write `{written} deg`"))
                    .suggest(format!("write `{written} deg`"), span, format!("{written} deg")),
            );
            return;
        }
        let opposite = format!("{}", -number);
        let is_opposite = low.is_some_and(|low| low >= 0.0)
            && written.trim_start_matches('-').trim().parse() == Ok(-number)
            && low.is_none_or(|low| -number >= low)
            && high.is_none_or(|high| -number <= high);
        if is_opposite {
            let help = format!("is `{opposite}` meant? `{}` is not negative", check.name);
            self.report(diagnostic.help(help).suggest(format!("write `{opposite}`"), span, opposite));
            return;
        }
        let slip = self.unit_slip(check, [low, high], span);
        self.report(match slip {
            Some((help, text)) => diagnostic.help(help).suggest(format!("write `{text}`"), span, text),
            None => diagnostic,
        });
    }

    /// Returns help, and the quantity in a unit of the range, for a number that lies in the range
    /// in this unit.
    fn unit_slip(
        &self,
        check: &Check,
        [low, high]: [Option<f64>; 2],
        span: Span,
    ) -> Option<(String, String)> {
        let text = self.text(span).trim();
        let Type::Number(dim) = self.store.resolve(&check.ty) else { return None };
        let dimension = dim.as_known().filter(|dimension| !dimension.is_none())?;
        let (digits, unit) = match text.split_once(char::is_whitespace) {
            Some((digits, unit)) => (digits, unit.trim()),
            None => (text, ""),
        };
        let number: f64 = digits.parse().ok()?;
        let range = check.text.split_whitespace().filter_map(Unit::find);
        let mut units = range.filter(|other| other.name != unit && other.dimension.fits(dimension));
        let fits = |value: f64| low.is_none_or(|low| value >= low) && high.is_none_or(|high| value <= high);
        let meant = units.find(|unit| fits(unit.factor * number))?;
        let text = format!("{digits} {}", meant.name);
        let system = self.modules.get(span.file.0 as usize).and_then(|module| module.system);
        let own = self.store.vocabulary.unit_of(system.unwrap_or_default(), dimension).name;
        Some(match unit {
            "" => (format!("a number without a unit is in {own}: write `{text}`"), text),
            _ => (format!("is `{text}` meant?"), text),
        })
    }

    /// Checks a constant text against choices.
    fn check_choice(&mut self, check: &Check, text: &str, span: Span) {
        if check.choices.is_empty() || check.choices.iter().any(|choice| choice == text) {
            return;
        }
        let allowed = check.choices.iter().map(|c| format!("\"{c}\"")).collect::<Vec<_>>().join(", ");
        let message = format!("`{}` cannot be \"{text}\"", check.name);
        let diagnostic = Diagnostic::error("E0314", message, span, "not an allowed value")
            .label(check.span, "allowed here");
        if let Some((choice, is_same)) = check.other_name(text) {
            let written = format!("\"{choice}\"");
            let diagnostic = diagnostic.help(format!("did you mean {written}? Allowed: {allowed}"));
            let title = format!("change to {written}");
            self.report(match is_same {
                true => diagnostic.fix(title, span, written),
                false => diagnostic.suggest(title, span, written),
            });
            return;
        }
        let begun: Vec<&String> =
            check.choices.iter().filter(|choice| !text.is_empty() && choice.starts_with(text)).collect();
        let diagnostic = match similar(text, check.choices.iter().map(String::as_str)) {
            // The spelling does not determine the intended choice.
            _ if begun.len() > 1 => {
                let names =
                    begun.iter().map(|choice| format!("\"{choice}\"")).collect::<Vec<_>>().join(" or ");
                let help = format!("did you mean {names}? Allowed: {allowed}");
                begun.iter().fold(diagnostic.help(help), |diagnostic, choice| {
                    let choice = format!("\"{choice}\"");
                    diagnostic.suggest(format!("change to {choice}"), span, choice)
                })
            }
            Some(near) => diagnostic.help(format!("did you mean \"{near}\"? Allowed: {allowed}")).fix(
                format!("change to \"{near}\""),
                span,
                format!("\"{near}\""),
            ),
            None => {
                let choices = check.choices.iter().take(MOST_CHOICES);
                choices.fold(diagnostic.help(format!("allowed: {allowed}")), |diagnostic, choice| {
                    let choice = format!("\"{choice}\"");
                    diagnostic.suggest(format!("change to {choice}"), span, choice)
                })
            }
        };
        self.report(diagnostic);
    }
}

/// Limit of the choices offered as replacements.
const MOST_CHOICES: usize = 8;
