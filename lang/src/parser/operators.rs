//! Parses operators and the suffixes of operands.

use super::brackets::element;
use super::expressions::arguments;
use super::recovery::{Reader, assigns_on_new_line, in_value, index_of, name, position, when};
use super::source::Source;
use super::{Extra, Input, Problem, Rule};
use crate::ast::{Argument, BinaryOp, Expr, ExprKind, Ident, UnaryOp};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use crate::span::Span;
use chumsky::input::MapExtra;
use chumsky::pratt::{infix, left, postfix, prefix, right};
use chumsky::prelude::*;

// From lowest to highest precedence; `at` has a lower precedence than all of these and is not an
// operator here.
const OR: u16 = 1;
const AND: u16 = 2;
const RELATION: u16 = 3;
const SUM: u16 = 4;
const PRODUCT: u16 = 5;
const SIGN: u16 = 6;
const POWER: u16 = 7;
const SUFFIX: u16 = 8;

pub(super) fn binary(left: Expr, (op, op_span): (BinaryOp, Span), right: Expr) -> Expr {
    let span = left.span.to(right.span);
    Expr { kind: ExprKind::Binary { op, op_span, left: Box::new(left), right: Box::new(right) }, span }
}

/// Returns a warning for `1/2 inch`, which may be intended as half an inch.
fn divided_quantity(left: &Expr, op: BinaryOp, right: &Expr) -> Option<Diagnostic> {
    let (BinaryOp::Divide, ExprKind::Number(above), ExprKind::Quantity { value, unit, .. }) =
        (op, &left.kind, &right.kind)
    else {
        return None;
    };
    let message = format!("this is {above}/({value} {})", unit.name);
    let help = format!(
        "write `{above}/({value} {0})`, or `{above} {0} / {value}` to divide the quantity",
        unit.name
    );
    let place = left.span.to(right.span);
    let unit = &unit.name;
    Some(
        Diagnostic::warning("W0125", message, place, "the unit belongs to the divisor")
            .help(help)
            .suggest(format!("divide by `{value} {unit}`"), place, format!("{above}/({value} {unit})"))
            .suggest(format!("divide `{above} {unit}`"), place, format!("{above} {unit} / {value}")),
    )
}

/// A suffix of an operand.
pub(super) enum Suffix {
    Call(Vec<Argument>),
    Index(Expr),
    Slice(Option<Expr>, Option<Expr>),
    Field(Option<Ident>),
}

/// Parses operands with operators and suffixes; `any` is the rule of all expressions.
pub(super) fn operator_grammar<'a>(
    source: &'a Source<'a>,
    atom: Rule<'a, Expr>,
    any: Rule<'a, Expr>,
) -> Rule<'a, Expr> {
    let or = operator(source, &[(Kind::Or, BinaryOp::Or)]);
    let or = or.or(doubled(source, Kind::OrOr, BinaryOp::Or, "|")).boxed();
    let and = operator(source, &[(Kind::And, BinaryOp::And)]);
    let and = and.or(doubled(source, Kind::AndAnd, BinaryOp::And, "&")).boxed();
    let relation = operator(
        source,
        &[
            (Kind::Less, BinaryOp::Less),
            (Kind::LessEqual, BinaryOp::LessEqual),
            (Kind::Greater, BinaryOp::Greater),
            (Kind::GreaterEqual, BinaryOp::GreaterEqual),
            (Kind::Equal, BinaryOp::Equal),
            (Kind::NotEqual, BinaryOp::NotEqual),
        ],
    );
    let sum = operator(source, &[(Kind::Plus, BinaryOp::Add), (Kind::Minus, BinaryOp::Subtract)]);
    let product = operator(source, &[(Kind::Star, BinaryOp::Multiply), (Kind::Slash, BinaryOp::Divide)]);
    let power = operator(source, &[(Kind::Caret, BinaryOp::Power)]);
    let signs = &[(Kind::Plus, UnaryOp::Plus), (Kind::Minus, UnaryOp::Minus), (Kind::Not, UnaryOp::Not)];
    let sign = operator(source, signs);
    // `x = gears.` followed by `y = 2;` on the next line.
    let no_field = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if !(assigns_on_new_line(source, at) && in_value(source, at)) {
            return Err(Problem(None));
        }
        let place = source.after(at);
        let message = "the name of the field is expected, not the end of the line";
        input.emit(Diagnostic::error("E0114", message, place, "a name is expected here").into());
        Ok(None)
    });
    let begins = |kind| matches!(kind, Kind::OpenParen | Kind::OpenBracket | Kind::Dot);
    let suffix = when(move |at| source.kind(at).is_some_and(begins)).ignore_then(choice((
        arguments(source, any.clone()).map(Suffix::Call),
        element(source, any),
        just(Kind::Dot).ignore_then(no_field.or(name(source, "the field"))).map(Suffix::Field),
    )));
    let suffix = suffix.map_with(|suffix, extra| (suffix, source.range(extra.span()))).boxed();

    // `none` or `not none` follows `is`, or the lexer would not have marked it.
    let is_none = just(Kind::Is)
        .ignore_then(
            when(move |at| source.text(at) == "not").ignore_then(index_of(Kind::Identifier)).or_not(),
        )
        .then_ignore(index_of(Kind::Identifier))
        .map_with(|not, extra| (not.is_some(), source.range(extra.span())))
        .boxed();

    atom.pratt((
        postfix(SUFFIX, suffix, |base: Expr, (suffix, suffix_span): (Suffix, Span), _: &mut _| {
            let span = base.span.to(suffix_span);
            let base = Box::new(base);
            let kind = match suffix {
                Suffix::Call(arguments) => ExprKind::Call { callee: base, arguments },
                Suffix::Index(index) => ExprKind::Index { base, index: Box::new(index) },
                Suffix::Slice(low, high) => {
                    ExprKind::Slice { base, low: low.map(Box::new), high: high.map(Box::new) }
                }
                Suffix::Field(Some(field)) => ExprKind::Field { base, field },
                Suffix::Field(None) => ExprKind::Error,
            };
            Expr { kind, span }
        }),
        infix(right(POWER), power, |l, op, r, _: &mut _| binary(l, op, r)),
        prefix(SIGN, sign, |(op, op_span): (UnaryOp, Span), operand: Expr, _: &mut _| {
            let span = op_span.to(operand.span);
            Expr { kind: ExprKind::Unary { op, operand: Box::new(operand) }, span }
        }),
        infix(
            left(PRODUCT),
            product,
            |l, op: (BinaryOp, Span), r, extra: &mut MapExtra<'a, '_, Input<'a>, Extra>| {
                if let Some(hint) = divided_quantity(&l, op.0, &r) {
                    extra.emit(hint.into());
                }
                binary(l, op, r)
            },
        ),
        infix(left(SUM), sum, |l, op, r, _: &mut _| binary(l, op, r)),
        infix(left(RELATION), relation, |l, op, r, _: &mut _| binary(l, op, r)),
        postfix(RELATION, is_none, |value: Expr, (negated, words): (bool, Span), _: &mut _| {
            let span = value.span.to(words);
            Expr { kind: ExprKind::IsNone { value: Box::new(value), negated }, span }
        }),
        infix(left(AND), and, |l, op, r, _: &mut _| binary(l, op, r)),
        infix(left(OR), or, |l, op, r, _: &mut _| binary(l, op, r)),
    ))
    .boxed()
}

/// Parses one of the operators, and returns it with its location. All operators are tried after
/// every operand, so this rule fails fast.
fn operator<'a, O: Copy>(source: &'a Source<'a>, operators: &'static [(Kind, O)]) -> Rule<'a, (O, Span)> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let found = operators.iter().find(|(kind, _)| source.kind(at) == Some(*kind));
        let Some((_, op)) = found else { return Err(Problem(None)) };
        input.next();
        Ok((*op, source.place(at)))
    })
    .boxed()
}

/// Parses `&&` and `||`, the spelling of C.
fn doubled<'a>(
    source: &'a Source<'a>,
    kind: Kind,
    op: BinaryOp,
    single: &'static str,
) -> Rule<'a, (BinaryOp, Span)> {
    just(kind)
        .map_with(move |_, extra| {
            let place = source.range(extra.span());
            let message = format!("{} is written `{single}`", kind.describe());
            extra.emit(
                Diagnostic::error("E0118", message, place, "unknown operator")
                    .help(format!("write `{single}`, which evaluates its right side only if needed"))
                    .fix(format!("write `{single}`"), place, single)
                    .into(),
            );
            (op, place)
        })
        .boxed()
}
