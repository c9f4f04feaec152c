//! Lints for cycles and angles. A radian is 1, and a cycle is also 1, but a cycle has 2 pi radians.
//! A factor of 2 pi is therefore missing if quantities that count cycles (in Hz) are combined with
//! quantities that count angles (in rad, deg, rev, rpm).
//!
//! Quantities that count neither are compatible with both: the root of stiffness by mass, a
//! velocity by a radius, and products and quotients with pi.

use super::infer::Checker;
use super::tree::{DefId, Expr, Kind, VarId};
use super::types::Type;
use crate::ast::{BinaryOp, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::dimension::{Base, Dimension, Rational};
use crate::hashed::HashSet;
use crate::span::Span;
use std::f64::consts::PI;

/// Data for lints that need all types.
#[derive(Debug, Default)]
pub struct AngleChecks {
    /// Variables, definitions and params computed with pi.
    circular: HashSet<VarId>,
    circular_definitions: HashSet<DefId>,
    circular_params: HashSet<u32>,
    /// Quotients with literal dividends: location, dividend as written, divisor and its type.
    reciprocals: Vec<(Span, Span, Span, Type)>,
    /// Numbers without units above 2 pi, and their expected types.
    literals: Vec<(f64, Span, Type)>,
}

impl Checker<'_> {
    /// Returns the dimension of a number or vector if it is completely known.
    fn known_dimension(&self, ty: &Type) -> Option<Dimension> {
        match self.store.known(ty) {
            Type::Number(dim) | Type::Vector(dim) | Type::Observable(dim) => self.store.known_dim(dim),
            _ => None,
        }
    }

    /// Warns if one side counts cycles and the other angles. Must precede their unification.
    pub(super) fn check_turns(&mut self, a: &Type, b: &Type, span: Span, other: Option<Span>) {
        let (Some(x), Some(y)) = (self.known_dimension(a), self.known_dimension(b)) else { return };
        if !x.lacks_turn(y) {
            return;
        }
        let diagnostic = Diagnostic::warning(
            "W0518",
            "cycles and angles are mixed: one cycle is 2 pi radians, so a factor of 2 pi is missing",
            span,
            format!("this counts {}", counted(y)),
        )
        .help("multiply cycles by `1 rev` to get angles, or divide angles by `1 rev` to get cycles");
        self.report(match other {
            Some(other) => diagnostic.label(other, format!("this counts {}", counted(x))),
            None => diagnostic,
        });
    }

    /// Returns the type of a product or quotient. If it contains pi, it is compatible with cycles
    /// and angles.
    pub(super) fn turned(&mut self, result: Type, a: &Expr, b: &Expr) -> Type {
        match self.store.resolve(&result) {
            Type::Number(dim) => match dim.as_known() {
                Some(known) if known.is_turning() && (self.has_pi(a) || self.has_pi(b)) => {
                    Type::quantity(known.without_angle())
                }
                _ => result,
            },
            _ => result,
        }
    }

    fn has_pi(&self, e: &Expr) -> bool {
        match &e.kind {
            // Units of angles also contain pi.
            Kind::Number(value) => {
                let part = || Rational::from_f64(value / PI).filter(|part| part.numerator().abs() <= 1000);
                *value != 0.0
                    && self.known_dimension(&e.ty).is_some_and(|d| d == Dimension::NONE)
                    && part().is_some()
            }
            Kind::Var(id) => self.turns.circular.contains(id),
            Kind::Param(id) => self.turns.circular_params.contains(id),
            Kind::Def(def) => self.turns.circular_definitions.contains(def),
            _ => e.children().into_iter().any(|child| self.has_pi(child)),
        }
    }

    /// Records a variable that is computed with pi.
    pub(super) fn note_circular(&mut self, id: VarId, value: &Expr) {
        if self.has_pi(value) {
            self.turns.circular.insert(id);
        }
    }

    pub(super) fn note_circular_param(&mut self, id: u32, value: &Expr) {
        if self.has_pi(value) {
            self.turns.circular_params.insert(id);
        }
    }

    pub(super) fn note_circular_definition(&mut self, id: DefId, value: &Expr) {
        if self.has_pi(value) {
            self.turns.circular_definitions.insert(id);
        }
    }

    /// Records a number divided by a value that may be an angular velocity.
    pub(super) fn note_reciprocal(&mut self, op: BinaryOp, a: &Expr, b: &Expr, span: Span) {
        if op == BinaryOp::Divide
            && literal(a).is_some()
            && !self.has_pi(a)
            && self.known_dimension(&a.ty).is_some_and(|d| d == Dimension::NONE)
        {
            self.turns.reciprocals.push((span, a.span, b.span, b.ty.clone()));
        }
    }

    /// Records a number without a unit whose expected type may be an angle, or is an angular
    /// velocity. A variable whose dimension is inferred from its uses is in the units of the
    /// program.
    pub(super) fn note_literal(&mut self, expected: &Type, found: &Expr) {
        let Some(value) = literal(found).filter(|value| value.abs() > 2.0 * PI) else { return };
        let known = self.known_dimension(expected);
        let is_pure = self.known_dimension(&found.ty).is_some_and(|d| d == Dimension::NONE);
        if known.is_some_and(|d| d.exponent(Base::Angle).is_zero()) || !(is_pure || is_bare(found)) {
            return;
        }
        if known == Some(angular_velocity()) {
            self.bare_angular_velocity(value, found.span);
        } else {
            self.turns.literals.push((value, found.span, expected.clone()));
        }
    }

    /// Runs the lints that need all types.
    pub(super) fn finish_turns(&mut self) {
        let speed = angular_velocity();
        for (span, dividend, divisor, ty) in std::mem::take(&mut self.turns.reciprocals) {
            if !matches!(self.store.resolve(&ty), Type::Number(dim) if dim.as_known() == Some(speed)) {
                continue;
            }
            let (number, text) = (self.text(dividend).to_string(), self.text(divisor).to_string());
            self.report(
                Diagnostic::warning(
                    "W0519",
                    "the reciprocal of an angular velocity is the time for one radian, not for a revolution",
                    span,
                    format!("`{text}` is in radians per time"),
                )
                .help(format!(
                    "write `{number} rev / {text}` for revolutions, `{number} rad / {text}` for radians"
                ))
                .suggest("divide revolutions", dividend, format!("{number} rev"))
                .suggest("divide radians", dividend, format!("{number} rad")),
            );
        }
        for (value, span, ty) in std::mem::take(&mut self.turns.literals) {
            let angle = Some(Dimension::of(Base::Angle));
            let is_angle = matches!(self.store.resolve(&ty), Type::Number(dim) if dim.as_known() == angle);
            if is_angle {
                self.bare_angle(value, span);
            }
        }
    }

    /// Warns about a number without a unit that is added to or compared with an angle.
    pub(super) fn check_bare_angle(&mut self, a: &Expr, b: &Expr) {
        for (angle, number) in [(a, b), (b, a)] {
            let is_angle = self
                .known_dimension(&angle.ty)
                .is_some_and(|d| d.without_cycles() == Dimension::of(Base::Angle));
            let is_pure = self.known_dimension(&number.ty).is_some_and(|d| d == Dimension::NONE);
            if is_angle && is_pure && literal(number).is_some_and(f64::is_finite) && !self.has_pi(number) {
                let value = literal(number).unwrap_or(f64::NAN);
                // A literal angle in radians may be a tolerance or a term of a series.
                let other_unit = literal(angle).is_some() && !self.text(angle.span).trim().ends_with("rad");
                if other_unit || value.abs() > 2.0 * PI {
                    self.bare_angle(value, number.span);
                }
            }
        }
    }

    fn bare_angle(&mut self, value: f64, span: Span) {
        let degrees = (value.to_degrees() * 10.0).round() / 10.0;
        let statement = format!("an angle in radians: {degrees} deg");
        self.bare_number(span, (&statement, "radians"), [("degrees", "deg"), ("radians", "rad")]);
    }

    fn bare_angular_velocity(&mut self, value: f64, span: Span) {
        let speed = (value * 60.0 / (2.0 * PI)).round();
        let statement = format!("an angular velocity in rad/s: {speed} rpm");
        let units = [("revolutions per minute", "rpm"), ("radians per second", "rad/s")];
        self.bare_number(span, (&statement, "rad/s"), units);
    }

    /// Warns of a number without a unit. `units` are titles and units of the fixes.
    fn bare_number(&mut self, span: Span, (statement, label): (&str, &str), units: [(&str, &str); 2]) {
        let text = self.text(span).trim().to_string();
        let [one, other] = units.map(|(_, unit)| format!("{text} {unit}"));
        let message = format!("this number without a unit is {statement}");
        self.report(
            Diagnostic::warning("W0520", message, span, label)
                .help(format!("write `{one}` or `{other}`"))
                .suggest(units[0].0, span, one)
                .suggest(units[1].0, span, other),
        );
    }
}

fn angular_velocity() -> Dimension {
    Dimension::of(Base::Angle).over(Dimension::of(Base::Time))
}

/// Returns the name of the quantity that a dimension counts.
fn counted(dimension: Dimension) -> &'static str {
    match dimension.exponent(Base::Angle).is_zero() {
        true => "cycles",
        false => "angles",
    }
}

/// Returns the value of a literal, possibly signed; `None` for zero, which has any dimension.
fn literal(e: &Expr) -> Option<f64> {
    match &e.kind {
        Kind::Number(value) | Kind::Bare(value, ..) if *value != 0.0 => Some(*value),
        Kind::Unary(UnaryOp::Minus, a) => literal(a).map(|value| -value),
        _ => None,
    }
}

/// Returns `true` for a literal whose dimension depends on its use.
fn is_bare(e: &Expr) -> bool {
    match &e.kind {
        Kind::Unary(_, a) => is_bare(a),
        kind => matches!(kind, Kind::Bare(..)),
    }
}

/// Returns the error for a value in cycles with a format in a unit of angles, or vice versa.
pub(super) fn turn_in_format(span: Span) -> Diagnostic {
    Diagnostic::error(
        "E0519",
        "cycles and angles cannot be shown in each other's units: one cycle is 2 pi radians",
        span,
        "a factor of 2 pi would be missing",
    )
    .help("multiply cycles by `1 rev`, as in `{f * 1 rev : rpm}`, or divide angles by `1 rev`")
}
