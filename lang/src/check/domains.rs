//! Ranges and choices: what a param or a function's parameter may be. Constant values are checked here, others when the
//! program runs: params by whoever sets them, arguments of library functions by the library, other arguments by the
//! caller ([`Demand`]).

use super::constant;
use super::infer::Checker;
use super::symbols::similar;
use super::tree::{Demand, Expr};
use super::types::{Store, Type};
use crate::ast::{Domain, Parameter};
use crate::diagnostic::Diagnostic;
use crate::span::Span;

/// A value and what it may be.
pub struct Check {
    name: String,
    ty: Type,
    /// `None` to check the range alone.
    value: Option<Expr>,
    low: Option<Expr>,
    high: Option<Expr>,
    choices: Vec<String>,
    span: Span,
    /// The range as it is written.
    text: String,
}

impl Demand {
    /// Whether all of it is constant, so that it was checked with the program.
    pub fn is_decided(&self, value: &Expr, store: &Store) -> bool {
        let number = |e: &Expr| constant::number(e, store).is_some();
        let ends = || self.low.iter().chain(&self.high).all(number);
        constant::text(value).is_some() || (number(value) && ends())
    }
}

impl<'a> Checker<'a> {
    /// Notes a domain to be checked when all types are known. Its ends must have the type `ty`.
    /// What is demanded of the value is handed back.
    pub(super) fn domain(
        &mut self,
        ty: &Type,
        domain: Option<&'a Domain>,
        value: Option<&Expr>,
        name: &str,
    ) -> Option<Demand> {
        let check = match domain {
            None => return None,
            Some(Domain::Range { low, high, span }) => {
                let around = self.constant_place.replace("a range");
                let mut ends = [None, None];
                for (end, e) in ends.iter_mut().zip([low, high]) {
                    if let Some(e) = e {
                        let e = self.as_value(|c| c.whole(e));
                        self.expect(ty, &e, &format!("an end of the range of `{name}`"), None);
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
                    span: *span,
                    text: self.text(*span).to_string(),
                }
            }
            Some(Domain::Choices { values, span }) => {
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
                    span: *span,
                    text,
                }
            }
        };
        let demand = Demand {
            name: check.name.clone(),
            low: check.low.clone(),
            high: check.high.clone(),
            choices: check.choices.clone(),
            text: check.text.trim_start_matches("in").trim().into(),
        };
        self.domains.push(check);
        Some(demand)
    }

    /// The range or choices of a function's own parameter, checked where they are declared.
    pub(super) fn parameter_domain(&mut self, ty: &Type, parameter: &'a Parameter) {
        let Some(domain) = &parameter.domain else { return };
        let open = matches!(self.store.shallow(ty), Type::Unknown(_));
        let bare = match domain {
            Domain::Range { low, high, .. } => low.iter().chain(high).any(super::expr::is_bare),
            Domain::Choices { .. } => false,
        };
        // Under a unit system a bare literal has the dimension of each call.
        if open && bare && self.system().is_some() {
            return;
        }
        self.domain(ty, Some(domain), None, &parameter.name.name);
    }

    /// Whether two types, all else decided, are of one kind and dimension.
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
            let mut types = ends.into_iter().chain([&check.value]).flatten().map(|e| &e.ty);
            if !types.all(|ty| self.fits(ty, &check.ty)) {
                continue;
            }
            if let (Some(low), Some(high)) = (low, high)
                && low > high
            {
                let mut diagnostic = Diagnostic::error(
                    "E0313",
                    format!("the range of `{}` is empty", check.name),
                    check.span,
                    "low end above high end",
                )
                .help("write the smaller end first");
                if let (Some(low), Some(high)) = (&check.low, &check.high) {
                    let swapped = format!("{} .. {}", self.text(high.span), self.text(low.span));
                    let title = format!("write `{swapped}`");
                    diagnostic = diagnostic.suggest(title, low.span.to(high.span), swapped);
                }
                self.report(diagnostic);
            }
            let Some(value) = &check.value else { continue };
            if let Some(number) = constant::number(value, &self.store)
                && (low.is_some_and(|low| number < low) || high.is_some_and(|high| number > high))
            {
                let range = check.text.trim_start_matches("in").trim();
                self.report(
                    Diagnostic::error(
                        "E0314",
                        format!("`{}` must lie in {range}", check.name),
                        value.span,
                        "outside the allowed range",
                    )
                    .label(check.span, "allowed here")
                    .help(format!("choose a value in {range}, ends included")),
                );
            }
            if let Some(text) = constant::text(value)
                && !check.choices.is_empty()
                && !check.choices.iter().any(|choice| choice == text)
            {
                let allowed = check.choices.iter().map(|c| format!("\"{c}\"")).collect::<Vec<_>>().join(", ");
                let diagnostic = Diagnostic::error(
                    "E0314",
                    format!("`{}` cannot be \"{text}\"", check.name),
                    value.span,
                    "not among the allowed values",
                )
                .label(check.span, "allowed here");
                let diagnostic = match similar(text, check.choices.iter().map(String::as_str)) {
                    Some(near) => diagnostic
                        .help(format!("did you mean \"{near}\"? Allowed: {allowed}"))
                        .fix(format!("change to \"{near}\""), value.span, format!("\"{near}\"")),
                    None => {
                        let choices = check.choices.iter().take(MOST_CHOICES);
                        choices.fold(diagnostic.help(format!("allowed: {allowed}")), |diagnostic, choice| {
                            let choice = format!("\"{choice}\"");
                            diagnostic.suggest(format!("change to {choice}"), value.span, choice)
                        })
                    }
                };
                self.report(diagnostic);
            }
        }
    }
}

/// Choices offered in place of a wrong one.
const MOST_CHOICES: usize = 8;
