//! Literals with units, and their conversion to other units.

use calyx_abi::text::number;
use calyx_abi::units::{from_si, to_si};
use calyx_lang::ast::{BinaryOp, Expr, ExprKind, Module, StmtKind, UnaryOp};
use calyx_lang::common_units::{usual, written};
use calyx_lang::dimension::Dimension;
use calyx_lang::ir::DisplayUnit;
use calyx_lang::units::{Unit, UnitSystem, combined, powered, pure};
use calyx_lang::walk::Node;

/// Returns the unit system selected by a file's `units` statement.
pub fn system(module: &Module) -> Option<UnitSystem> {
    module.statements.iter().find_map(|statement| match &statement.kind {
        StmtKind::Units(name) => UnitSystem::from_name(&name.name),
        _ => None,
    })
}

/// A literal with the units it is multiplied and divided by: `25.4 mm`, `1000 lbf*inch`, `10 /
/// inch`.
#[derive(Clone, Debug, PartialEq)]
pub struct LiteralWithUnit {
    pub start: u32,
    pub end: u32,
    pub value: f64,
    pub unit: DisplayUnit,
}

impl LiteralWithUnit {
    /// Returns `None` for other expressions and for units that are not builtin. `is_unit` returns
    /// whether the name at an offset is a unit and not a variable of that name.
    pub fn new(e: &Expr, is_unit: &dyn Fn(u32) -> bool) -> Option<LiteralWithUnit> {
        let (value, unit) = match &e.kind {
            ExprKind::Number(value) => (*value, pure()),
            ExprKind::Quantity { value, unit, exponent, .. } => {
                (*value, powered(&known(&unit.name)?, *exponent)?)
            }
            ExprKind::Binary { op: op @ (BinaryOp::Multiply | BinaryOp::Divide), left, right, .. } => {
                let left = LiteralWithUnit::new(left, is_unit)?;
                let right = factor(right, is_unit)?;
                (left.value, combined(&left.unit, &right, *op == BinaryOp::Multiply)?)
            }
            _ => return None,
        };
        Some(LiteralWithUnit { start: e.span.start, end: e.span.end, value, unit })
    }

    pub fn si(&self) -> f64 {
        to_si(self.value, self.unit.factor)
    }

    pub fn dimension(&self) -> Option<Dimension> {
        Dimension::from_exponents(self.unit.dimension)
    }

    /// Returns the same quantity in the other common units of its dimension as source text, and
    /// whether the conversion is exact.
    pub fn elsewhere(&self, system: UnitSystem) -> Vec<(DisplayUnit, String, bool)> {
        let Some(dimension) = self.dimension().filter(|_| self.value.is_finite()) else { return Vec::new() };
        let other = usual(dimension, system).into_iter().filter(|unit| unit.name != self.unit.name);
        let each = other.map(|unit| {
            let (text, exact) = in_unit(self.si(), unit.factor);
            let text = written(&text, &unit.name);
            (unit, text, exact)
        });
        each.collect()
    }
}

/// Returns a unit or a power of one, as a factor of a product.
fn factor(e: &Expr, is_unit: &dyn Fn(u32) -> bool) -> Option<DisplayUnit> {
    match &e.kind {
        ExprKind::Name(name) if is_unit(name.span.start) => known(&name.name),
        ExprKind::Binary { op: BinaryOp::Power, left, right, .. } => {
            let (negative, exponent) = match &right.kind {
                ExprKind::Unary { op: UnaryOp::Minus, operand } => (true, &**operand),
                _ => (false, &**right),
            };
            let ExprKind::Number(exponent) = exponent.kind else { return None };
            let whole = (exponent.fract() == 0.0 && exponent.abs() <= 12.0).then_some(exponent as i32)?;
            powered(&factor(left, is_unit)?, if negative { -whole } else { whole })
        }
        _ => None,
    }
}

fn known(name: &str) -> Option<DisplayUnit> {
    let unit = Unit::find(name)?;
    Some(DisplayUnit { name: name.into(), factor: unit.factor, dimension: unit.dimension.exponents() })
}

/// Largest number of digits after the first one in a short decimal.
const SHORT: usize = 11;

fn rounded(value: f64, digits: usize) -> String {
    number(format!("{value:.digits$e}").parse().unwrap_or(value))
}

/// Formats a number in SI as the shortest decimal in a unit that parses to the same number, and
/// returns whether there is one.
pub fn in_unit(si: f64, factor: f64) -> (String, bool) {
    let near = from_si(si, factor);
    let back = |text: &str| text.parse().map_or(f64::NAN, |value: f64| to_si(value, factor));
    // A short decimal is preferred, even if it differs in the last bit: 3 inch are 76.2 mm.
    for digits in 0..SHORT {
        let text = rounded(near, digits);
        if (back(&text) - si).abs() <= si.abs() * 2.0 * f64::EPSILON {
            return (text, true);
        }
    }
    let reads_back = |text: &str| back(text).to_bits() == si.to_bits();
    for digits in SHORT..17 {
        let text = rounded(near, digits);
        if reads_back(&text) {
            return (text, true);
        }
    }
    // The conversion has rounding errors too, so the neighbours are tried.
    for neighbour in [near.next_up(), near.next_down()] {
        let text = number(neighbour);
        if reads_back(&text) {
            return (text, true);
        }
    }
    (number(near), false)
}

/// Returns true if a product requires parentheses in place of an expression.
pub fn needs_parentheses(e: &Expr, parent: Option<Node<'_>>) -> bool {
    match parent {
        Some(Node::Expression(parent)) => match &parent.kind {
            ExprKind::Binary { op: BinaryOp::Multiply | BinaryOp::Divide, right, .. } => right.span == e.span,
            ExprKind::Binary { op: BinaryOp::Power, .. }
            | ExprKind::Field { .. }
            | ExprKind::Index { .. } => true,
            _ => false,
        },
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn conversions_are_short_where_they_can_be() {
        let inch = known("inch").map_or(0.0, |unit| unit.factor);
        let mm = known("mm").map_or(0.0, |unit| unit.factor);
        let deg = known("deg").map_or(0.0, |unit| unit.factor);
        assert_eq!(in_unit(to_si(25.4, mm), inch), ("1".into(), true));
        assert_eq!(in_unit(to_si(1.0, inch), mm), ("25.4".into(), true));
        assert_eq!(in_unit(to_si(0.15708, inch), mm), ("3.989832".into(), true));
        assert_eq!(in_unit(to_si(20.0, deg), 1.0).0, "0.3490658503988659");
        assert_eq!(in_unit(0.0, mm), ("0".into(), true));
        assert_eq!(in_unit(to_si(3.0, inch), mm), ("76.2".into(), true));
    }
}
