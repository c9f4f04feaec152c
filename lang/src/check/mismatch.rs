//! Dimension errors: the factors of both sides, their declarations, and the missing factor.

use super::dim::Dim;
use super::infer::Checker;
use super::symbols::with_article;
use super::tree::{Expr, FuncId, Kind, VarId};
use super::types::{Mismatch, Type};
use crate::ast::BinaryOp;
use crate::diagnostic::Diagnostic;
use crate::dimension::{Dimension, Rational};
use crate::span::Span;

impl Checker<'_> {
    /// Unifies the types of the two sides of an operator. Returns `false` and reports an error at
    /// the second side if they differ.
    pub(super) fn same(&mut self, a: &Expr, b: &Expr, op_span: Span, verb: &str) -> bool {
        self.check_turns(&a.ty, &b.ty, b.span, Some(a.span));
        self.check_bare_angle(a, b);
        self.check_compared(a, b);
        if self.accepts_choice(&a.ty, b) || self.accepts_choice(&b.ty, a) {
            return true;
        }
        let Err(mismatch) = self.store.unify(&a.ty, &b.ty) else { return true };
        let shown = |ty| with_article(&self.store.show(ty));
        let (left, right) = (shown(&a.ty), shown(&b.ty));
        let diagnostic = match mismatch {
            Mismatch::Dimension(dims) => {
                let (x, y) = *dims;
                let shown = |dim| with_article(&self.store.show_dim(dim));
                let (x, y) = (shown(&x), shown(&y));
                let message = match verb {
                    "compare" => format!("cannot compare {x} with {y}"),
                    "add" => format!("cannot add {y} to {x}"),
                    _ => format!("cannot {verb} {y} from {x}"),
                };
                let diagnostic =
                    Diagnostic::error("E0401", message, b.span, format!("this is {y}: {}", self.factors(b)))
                        .label(a.span, format!("this is {x}: {}", self.factors(a)));
                let diagnostic = self.origins(diagnostic, &[a, b]);
                // A side without a unit more likely lacks a factor.
                let pure = |ty: &Type| match self.store.resolve(ty) {
                    Type::Number(dim) => dim.as_known().is_some_and(Dimension::is_none),
                    _ => false,
                };
                let (first, second) = if pure(&a.ty) { ((b, a), (a, b)) } else { ((a, b), (b, a)) };
                let mut diagnostic = self.with_units(diagnostic, &first.0.ty, first.1);
                if diagnostic.suggestions.is_empty() {
                    diagnostic = self.with_units(diagnostic, &second.0.ty, second.1);
                }
                match self.missing_factor(&a.ty, &b.ty) {
                    Some(help) => diagnostic.help(help),
                    None => diagnostic,
                }
            }
            _ if [&a.ty, &b.ty].iter().any(|ty| matches!(self.store.known(ty), Type::Observable(_))) => {
                self.observable_as_value(op_span)
            }
            _ => {
                let message = match verb {
                    "compare" => format!("cannot compare {left} with {right}"),
                    "add" => format!("cannot add {right} to {left}"),
                    _ => format!("cannot {verb} {right} from {left}"),
                };
                if let Some(diagnostic) = self.vector_and_zero(a, b, &message) {
                    self.report(diagnostic);
                    return false;
                }
                let text = [&a.ty, &b.ty].iter().any(|ty| matches!(self.store.known(ty), Type::String));
                let help = match self.array_and_element(a, b, verb) {
                    _ if text && verb == "add" => {
                        "convert values to text by interpolation: `\"{a}{b}\"`".to_owned()
                    }
                    Some(help) => help,
                    None => "both sides must have the same type".to_owned(),
                };
                let diagnostic = Diagnostic::error("E0301", message, b.span, format!("this is {right}"))
                    .label(a.span, format!("this is {left}"))
                    .help(help);
                match text && verb == "add" {
                    true => self.as_text(diagnostic, a, b),
                    false => diagnostic,
                }
            }
        };
        self.report(diagnostic);
        false
    }

    /// Returns the help for the sum or difference of an array and one value of the type of its
    /// elements.
    fn array_and_element(&self, a: &Expr, b: &Expr, verb: &str) -> Option<String> {
        let Type::Array(element) = self.store.shallow(&a.ty) else { return None };
        let kind = |ty: &Type| std::mem::discriminant(&self.store.shallow(ty));
        let sign = match verb {
            "add" => '+',
            "subtract" => '-',
            _ => return None,
        };
        if kind(&element) != kind(&b.ty) {
            return None;
        }
        let (array, value) = (self.text(a.span).trim(), self.text(b.span).trim());
        let each = format!("for each element write `[x {sign} {value} for x in {array}]`");
        Some(match (verb, &a.kind) {
            ("add", Kind::Var(_) | Kind::Updated(_)) => {
                format!("append it with `push({array}, {value})`; {each}")
            }
            _ => each,
        })
    }

    /// Returns the error for the sum of a vector and a variable that starts with `0`, if the
    /// operands are these.
    fn vector_and_zero(&self, a: &Expr, b: &Expr, message: &str) -> Option<Diagnostic> {
        let started = |e: &Expr| match e.kind {
            Kind::Var(id) | Kind::Updated(id) => Some((id, *self.zero_starts.get(&id)?)),
            _ => None,
        };
        let (id, zero) = started(a).or_else(|| started(b))?;
        let vector = |e: &Expr| matches!(self.store.known(&e.ty), Type::Vector(_));
        if !vector(a) && !vector(b) {
            return None;
        }
        let name = &self.variable(id).name;
        Some(
            Diagnostic::error("E0301", message, b.span, format!("`{name}` is a number"))
                .label(zero, "the number 0")
                .help(format!("start `{name}` with the null vector: `0 * e1`"))
                .suggest("write `0 * e1`", zero, "0 * e1"),
        )
    }

    /// Returns the name of the only variable of a function that starts with the number 0.
    pub(super) fn sum_of_numbers(&self, function: FuncId) -> Option<String> {
        if let Some(name) = self.sums.get(&function) {
            return Some(name.clone());
        }
        let is_number = |id: &VarId| {
            let ty = self.variable_types.get(id);
            ty.is_some_and(|ty| matches!(self.store.known(ty), Type::Number(_)))
        };
        let mut own = self.zero_starts.keys().filter(|id| self.variable(**id).owner == function);
        let only = own.next().filter(|id| own.next().is_none() && is_number(id))?;
        Some(self.variable(*only).name.to_string())
    }

    /// Explains the errors since `reported`, of an argument with vectors where the function adds
    /// numbers to a variable that starts with `0`.
    pub(super) fn explain_sum(&mut self, reported: usize, function: FuncId, (wanted, found): (&Type, &Type)) {
        let element = |ty: &Type| {
            let mut ty = self.store.shallow(ty);
            while let Type::Array(inner) = ty {
                ty = self.store.shallow(&inner);
            }
            ty
        };
        if !matches!((element(wanted), element(found)), (Type::Number(_), Type::Vector(_))) {
            return;
        }
        let Some(sum) = self.sum_of_numbers(function) else { return };
        let name = self.names.functions[function.0 as usize].name.clone();
        for problem in self.diagnostics.iter_mut().skip(reported).filter(|problem| problem.code == "E0301") {
            let help = format!(
                "`{sum}` in `{name}` starts with the number 0, to which no vector can be added: start it with \
                 `0 * values[0]`, which fits numbers and vectors, or add with `sum(values)`"
            );
            *problem = Diagnostic { help: Some(help), ..problem.clone() };
        }
    }

    pub(super) fn dimension_mismatch(
        &mut self,
        wanted: &Dim,
        got: &Dim,
        found: &Expr,
        what: &str,
        cause: Option<(Span, String)>,
    ) {
        let shown = |dim| with_article(&self.store.show_dim(dim));
        let (shown_wanted, shown_got) = (shown(wanted), shown(got));
        let mut diagnostic = Diagnostic::error(
            "E0401",
            format!("{what} must be {shown_wanted}, not {shown_got}"),
            found.span,
            format!("this is {shown_got}: {}", self.factors(found)),
        );
        if let Some((span, message)) = cause {
            diagnostic = diagnostic.label(span, message);
        }
        diagnostic = self.origins(diagnostic, &[found]);
        let types = (Type::Number(wanted.clone()), Type::Number(got.clone()));
        diagnostic = self.with_units(diagnostic, &types.0, found);
        if let Some(help) = self.missing_factor(&types.0, &types.1) {
            diagnostic = diagnostic.help(help);
        }
        self.note_conflict([wanted.as_known(), got.as_known()], found, &diagnostic);
        self.report(diagnostic);
    }

    /// Returns the factors of a product with their dimensions: `torque [Moment] / radius [Length] =
    /// Force`.
    fn factors(&self, e: &Expr) -> String {
        let mut parts = Vec::new();
        self.collect_factors(e, true, &mut parts);
        let in_bases = |e: &Expr| match self.store.resolve(&e.ty) {
            Type::Number(dim) | Type::Vector(dim) => {
                dim.as_known().map(|known| self.store.vocabulary.in_bases(known))
            }
            _ => None,
        };
        let total = in_bases(e).unwrap_or_else(|| self.store.show(&e.ty));
        if parts.len() < 2 || parts.len() > 8 {
            let text: String = self.text(e.span).chars().take(40).collect();
            return if total == "1" { format!("{text} has no unit") } else { format!("{text} = {total}") };
        }
        let mut text = String::new();
        for (index, (factor, above)) in parts.iter().enumerate() {
            match (index, above) {
                (0, true) => {}
                (0, false) => text.push_str("1 / "),
                (_, true) => text.push_str(" * "),
                (_, false) => text.push_str(" / "),
            }
            let source = self.text(factor.span);
            let short = if source.chars().count() <= 24 { source } else { "(...)" };
            text.push_str(&format!("{short} [{}]", self.store.show(&factor.ty)));
        }
        format!("{text} = {total}")
    }

    pub(super) fn collect_factors<'e>(&self, e: &'e Expr, above: bool, parts: &mut Vec<(&'e Expr, bool)>) {
        match &e.kind {
            Kind::Binary(op @ (BinaryOp::Multiply | BinaryOp::Divide), a, b) => {
                self.collect_factors(a, above, parts);
                self.collect_factors(b, above == (*op == BinaryOp::Multiply), parts);
            }
            Kind::Unary(_, a) => self.collect_factors(a, above, parts),
            _ => parts.push((e, above)),
        }
    }

    /// Labels the declarations of the variables and params in the given expressions.
    fn origins(&self, mut diagnostic: Diagnostic, sides: &[&Expr]) -> Diagnostic {
        let mut seen = Vec::new();
        for side in sides {
            let mut parts = Vec::new();
            self.collect_factors(side, true, &mut parts);
            for (factor, _) in parts {
                let (name, span) = match factor.kind {
                    Kind::Var(id) => (self.variable(id).name.as_str(), self.variable(id).span),
                    Kind::Param(id) => match self.params.get(id as usize) {
                        Some(param) => (param.name.as_str(), param.span),
                        None => continue,
                    },
                    _ => continue,
                };
                if !seen.contains(&span) && seen.len() < 4 {
                    seen.push(span);
                    diagnostic = diagnostic
                        .label(span, format!("`{name}` is {}", with_article(&self.store.show(&factor.ty))));
                }
            }
        }
        diagnostic
    }

    /// Describes the factor between two dimensions: multiply or divide by a common quantity if
    /// possible, otherwise the product of base dimensions.
    fn missing_factor(&self, wanted: &Type, got: &Type) -> Option<String> {
        let known = |ty: &Type| {
            let mut ty = self.store.resolve(ty);
            while let Type::Array(element) = ty {
                ty = *element;
            }
            match ty {
                Type::Number(dim) | Type::Vector(dim) | Type::Observable(dim) => dim.as_known(),
                _ => None,
            }
        };
        let missing = known(wanted)?.over(known(got)?).without_angle();
        let inverse = missing.power(Rational::integer(-1))?;
        let vocabulary = &self.store.vocabulary;
        let unit = |d: Dimension| vocabulary.unit_of(self.shown_system(), d).name;
        if known(got)?.without_angle().is_none() {
            let name = vocabulary.show(missing);
            return Some(format!("give it a unit of {name}, such as `{}`", unit(missing)));
        }
        let factor =
            |d: Dimension| vocabulary.name_of(d).filter(|name| FACTORS.contains(name) || !d.is_physics());
        match (factor(missing), factor(inverse)) {
            (_, Some(name)) => Some(format!("divide by {} (`{}`)", with_article(name), unit(inverse))),
            (Some(name), _) => Some(format!("multiply by {} (`{}`)", with_article(name), unit(missing))),
            _ => Some(format!("the dimensions differ by a factor of {}", vocabulary.in_bases(missing))),
        }
    }
}

impl Checker<'_> {
    /// Warns of result types that give a parameter a fractional dimension, such as `-> Length` for
    /// an area: otherwise the error would be at the callers, which are right.
    pub(super) fn check_result_types(&mut self) {
        let mut found = Vec::new();
        for (id, info) in self.names.functions.iter().enumerate() {
            let Some((decl, result)) = info.decl.and_then(|decl| Some((decl, decl.result.as_ref()?))) else {
                continue;
            };
            if !self.functions.contains_key(&FuncId(id as u32)) || !self.layout.is_own(decl.name.span) {
                continue;
            }
            for (parameter, variable) in decl.parameters.iter().zip(&info.parameters) {
                let known = self.variable_types.get(variable).and_then(|ty| match self.store.resolve(ty) {
                    Type::Number(dim) => dim.as_known(),
                    _ => None,
                });
                if parameter.annotation.is_none() && known.is_some_and(Dimension::is_fractional) {
                    let name = &parameter.name.name;
                    let (written, shown) = (
                        self.text(result.span),
                        self.store.vocabulary.show(known.unwrap_or(Dimension::NONE)),
                    );
                    found.push(
                        Diagnostic::warning(
                            "W0850",
                            format!("the result type `{written}` makes `{name}` a {shown}"),
                            result.span,
                            "this result needs such an argument",
                        )
                        .label(parameter.name.span, format!("`{name}` is a {shown}"))
                        .help(format!(
                            "correct the result type, or state the type of the parameter: `in {name}: Length`"
                        )),
                    );
                }
            }
        }
        found.into_iter().for_each(|diagnostic| self.report(diagnostic));
    }
}

/// Dimensions that are often forgotten as factors.
const FACTORS: &[&str] =
    &["Length", "Area", "Volume", "Time", "Mass", "Force", "Velocity", "AngularVelocity", "Temperature"];
