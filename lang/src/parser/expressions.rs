//! Parses expressions, literals and argument lists.

use super::anonymous::anonymous;
use super::brackets::{brackets, items, list, values};
use super::operators::{binary, operator_grammar};
use super::recovery::{
    Reader, advance_to, assigns_on_new_line, close, conversion, expect, identifier, index_of, name, position,
    when,
};
use super::source::Source;
use super::{Extra, Input, Problem, Rule};
use crate::ast::{Argument, BinaryOp, Bind, Expr, ExprKind, Format, Ident, StringPart, Values};
use crate::diagnostic::Diagnostic;
use crate::lexer::{Kind, unescape};
use crate::span::Span;
use crate::units::Unit;
use chumsky::prelude::*;

/// Rules for expressions. All of them succeed: if there is no expression, they report it and return
/// an `Error` node.
#[derive(Clone)]
pub(super) struct Expressions<'a> {
    /// All expressions, including `at`.
    pub full: Rule<'a, Expr>,
    /// Expressions without `at`, for a condition, a range limit or an `else` branch before it.
    pub operators: Rule<'a, Expr>,
    /// A condition in parentheses.
    pub condition: Rule<'a, Expr>,
    /// The elements of `[a, b, c]`, without the node around them.
    pub list: Rule<'a, Vec<Expr>>,
    /// `array` or `low .. high`, after the `in` of a loop.
    pub values: Rule<'a, Values>,
}

pub(super) fn expressions<'a>(source: &'a Source<'a>) -> Expressions<'a> {
    // The rule refers to itself weakly: a strong cycle would never be freed, and an editor builds
    // the rules at every keystroke.
    let full = recursive(|any| {
        let any = any.boxed();
        at_clause(source, operators(source, any.clone()), any)
    });
    let any = full.boxed();
    let condition = condition(source, any.clone());
    let list = list(source, any.clone());
    let values = values(any.clone());
    Expressions { operators: operators(source, any.clone()), full: any, condition, list, values }
}

/// Parses operators and their operands, without `at`.
fn operators<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let rule = recursive(|operators| {
        let condition = condition(source, any.clone());
        let atom = choice((
            number(source),
            string(source, any.clone()),
            boolean(source),
            // Only arguments can be functions, which the checker reports.
            anonymous(source, any.clone()),
            variable(source),
            parenthesised(source, any.clone()),
            brackets(source, any.clone()),
            conditional(source, condition, any.clone(), operators.boxed()),
            missing(source),
        ))
        .boxed();
        operator_grammar(source, atom, any.clone())
    });
    rule.boxed()
}

/// Wraps a node with the source range of its tokens.
fn spanned<'a>(
    source: &'a Source<'a>,
    kind: impl Parser<'a, Input<'a>, ExprKind, Extra> + 'a,
) -> Rule<'a, Expr> {
    kind.map_with(|kind, extra| Expr { kind, span: source.range(extra.span()) }).boxed()
}

/// Returns `true` if an expression, rather than the end of one, may start at a token.
pub(super) fn may_begin(kind: Option<Kind>) -> bool {
    kind.is_some_and(|k| {
        !k.begins_statement()
            && !matches!(
                k,
                Kind::CloseParen
                    | Kind::CloseBracket
                    | Kind::CloseBrace
                    | Kind::OpenBrace
                    | Kind::InterpolationClose
                    | Kind::Semicolon
                    | Kind::Else
                    | Kind::Catch
                    | Kind::In
                    | Kind::Out
                    | Kind::InOut
            )
    })
}

/// Parses a number, or a quantity if a unit follows.
fn number<'a>(source: &'a Source<'a>) -> Rule<'a, Expr> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Number) {
            return Err(Problem(None));
        }
        input.next();
        // The lexer has already reported malformed numbers.
        let value = source.text(at).parse().unwrap_or(f64::NAN);
        let Some((unit, exponent, exponent_span)) = unit_after(source, input) else {
            return Ok(Expr { kind: ExprKind::Number(value), span: source.place(at) });
        };
        let span = source.place(at).to(exponent_span.unwrap_or(unit.span));
        Ok(Expr { kind: ExprKind::Quantity { value, unit, exponent, exponent_span }, span })
    })
    .boxed()
}

/// Parses a unit and its exponent after a number or after brackets, if there is one.
pub(super) fn unit_after<'a>(
    source: &'a Source<'a>,
    input: &mut Reader<'a, '_>,
) -> Option<(Ident, i32, Option<Span>)> {
    let at = position(input);
    let is_unit = match source.kind(at) {
        Some(Kind::Percent) => true,
        // A name on the next line more likely starts a statement after a missing `;`.
        Some(Kind::Identifier) => !source.begins_line(at) || Unit::find(source.text(at)).is_some(),
        _ => false,
    };
    if !is_unit {
        return None;
    }
    input.next();
    let (exponent, exponent_span) = unit_exponent(source, input);
    Some((source.ident(at), exponent, exponent_span))
}

/// Parses `^2` or `^-1` after a unit.
fn unit_exponent<'a>(source: &'a Source<'a>, input: &mut Reader<'a, '_>) -> (i32, Option<Span>) {
    let caret = position(input);
    if source.kind(caret) != Some(Kind::Caret) {
        return (1, None);
    }
    let negative = source.kind(caret + 1) == Some(Kind::Minus);
    let digits = caret + 1 + usize::from(negative);
    let magnitude = match source.kind(digits) {
        Some(Kind::Number) => source.text(digits).parse::<i32>().ok(),
        _ => None,
    };
    if let Some(magnitude) = magnitude {
        advance_to(input, digits + 1);
        let span = source.place(caret + 1).to(source.place(digits));
        return (if negative { -magnitude } else { magnitude }, Some(span));
    }
    let span = source.place(caret).to(source.place(digits));
    let mut problem =
        Diagnostic::error("E0121", "the exponent of a unit must be an integer", span, "not an integer")
            .help("put the quantity in parentheses to raise all of it to a power: `(2 inch)^x`");
    if let (Some(unit), Some(number)) = (caret.checked_sub(1), caret.checked_sub(2))
        && source.kind(number) == Some(Kind::Number)
    {
        let raised = format!("({} {})", source.text(number), source.text(unit));
        let place = source.place(number).to(source.place(unit));
        problem = problem.suggest(format!("raise `{raised}`"), place, raised);
    }
    input.emit(problem.into());
    let end = match source.kind(digits) {
        Some(Kind::Number | Kind::Identifier) => digits + 1,
        _ => digits,
    };
    advance_to(input, end);
    (1, None)
}

fn string<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let text = index_of(Kind::StringText).map(|at| StringPart::Text(unescape(source.text(at))));
    let end = custom(move |input: &mut Reader<'a, '_>| {
        let start = position(input);
        let mut at = start;
        while source.kind(at).is_some_and(|k| k != Kind::InterpolationClose) {
            at = source.next(at);
        }
        if at > start {
            let problem = conversion(source, start).unwrap_or_else(|| {
                let message = format!("{} is unexpected", source.describe(start));
                Diagnostic::error("E0113", message, source.place(start), "not expected here")
                    .help("put one expression between the braces; write `{{` for the character itself")
            });
            input.emit(problem.into());
        }
        advance_to(input, at + 1);
        Ok(())
    });
    let value = just(Kind::InterpolationOpen)
        .ignore_then(any.clone())
        .then(format(source, any).or_not())
        .then_ignore(end)
        .map(|(value, format)| StringPart::Value(value, format));
    let parts =
        text.or(value).repeated().collect().delimited_by(just(Kind::StringOpen), just(Kind::StringClose));
    spanned(source, parts.map(ExprKind::String))
}

/// Parses a unit of its own, not after a number: `%`, or a product of units, which is an expression
/// until its names are known.
pub(super) fn unit_product<'a>(source: &'a Source<'a>, product: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let percent = index_of(Kind::Percent)
        .map(|at| Expr { kind: ExprKind::Name(source.ident(at)), span: source.place(at) });
    percent.or(product).boxed()
}

/// Parses `: 10.3e lbf*inch` after an interpolated value.
fn format<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Format> {
    let product = when(move |at| source.kind(at) != Some(Kind::InterpolationClose)).ignore_then(any);
    let unit = unit_product(source, product.boxed());
    index_of(Kind::Format)
        .then(unit.or_not())
        .map_with(move |(at, unit), extra| {
            let written = source.text(at).trim_start_matches([':', ' ', '\t']);
            let scientific = written.ends_with('e');
            let (width, digits) = written
                .trim_end_matches('e')
                .split_once('.')
                .map_or((written.trim_end_matches('e'), None), |(width, digits)| (width, Some(digits)));
            if written.is_empty() && unit.is_none() {
                let problem = Diagnostic::error(
                    "E0112",
                    "a format is expected after `:`",
                    source.place(at),
                    "missing format",
                );
                extra.emit(problem.help("write digits after the point and a unit: `{x : .3 mm}`").into());
            }
            let mut number = |text: &str| {
                let value = text.parse::<u8>().ok().filter(|value| *value <= 100);
                if value.is_none() && !text.is_empty() {
                    let problem = Diagnostic::error(
                        "E0105",
                        "a number in a format is at most 100",
                        source.place(at),
                        "too large",
                    );
                    extra.emit(problem.help("reduce the width or the number of digits").into());
                }
                value
            };
            let (width, digits) = (number(width), digits.map(|digits| number(digits).unwrap_or(0)));
            Format { width, digits, scientific, unit, span: source.range(extra.span()) }
        })
        .boxed()
}

fn boolean<'a>(source: &'a Source<'a>) -> Rule<'a, Expr> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let (value, span) = (source.text(at), source.place(at));
        let (value, proper) = match (source.kind(at), value) {
            (Some(Kind::True), _) => (true, None),
            (Some(Kind::False), _) => (false, None),
            // The spelling of most other languages.
            (_, "true") => (true, Some("TRUE")),
            (_, "false") => (false, Some("FALSE")),
            _ => return Err(Problem(None)),
        };
        input.next();
        if let Some(proper) = proper {
            let message = format!("`{value}` is written `{proper}`");
            let problem = Diagnostic::error("E0119", message, span, "unknown spelling");
            let help = format!("write `{proper}`");
            input.emit(problem.help(help.clone()).fix(help, span, proper).into());
        }
        Ok(Expr { kind: ExprKind::Bool(value), span })
    })
    .boxed()
}

fn variable<'a>(source: &'a Source<'a>) -> Rule<'a, Expr> {
    // Excludes `y` in `x = a +` followed by `y = 2;` on the next line.
    let is_next_statement = move |at| {
        let half_written = matches!(
            source.previous(at),
            Some(
                Kind::Assign
                    | Kind::Bind
                    | Kind::AddAssign
                    | Kind::SubtractAssign
                    | Kind::MultiplyAssign
                    | Kind::DivideAssign
                    | Kind::Plus
                    | Kind::Minus
                    | Kind::Star
                    | Kind::Slash
                    | Kind::Caret
                    | Kind::Less
                    | Kind::LessEqual
                    | Kind::Greater
                    | Kind::GreaterEqual
                    | Kind::Equal
                    | Kind::NotEqual
                    | Kind::And
                    | Kind::Or
                    | Kind::Not
            )
        );
        !source.begins_statement(at) && half_written && assigns_on_new_line(source, at)
    };
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Identifier) || is_next_statement(at) {
            return Err(Problem(None));
        }
        input.next();
        Ok(Expr { kind: ExprKind::Name(source.ident(at)), span: source.place(at) })
    })
    .boxed()
}

fn parenthesised<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let inner = just(Kind::OpenParen).ignore_then(any).then_ignore(close(
        source,
        Kind::CloseParen,
        "an operator or `)`",
    ));
    spanned(source, inner.map(|e| ExprKind::Paren(Box::new(e))))
}

pub(super) fn arguments<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Vec<Argument>> {
    let bind = select! { Kind::Assign => Bind::Evaluate, Kind::Bind => Bind::Symbolic };
    let parameter = identifier(source).then(bind);
    let spread = just(Kind::DotDot).ignore_then(any.clone());
    let spread = spread.map(|value| Argument { name: None, value, spread: true });
    let value = anonymous(source, any.clone()).or(any);
    let plain = parameter.or_not().then(value).map(|(name, value)| Argument { name, value, spread: false });
    let argument = spread.or(plain).boxed();
    just(Kind::OpenParen)
        .ignore_then(items(source, argument))
        .then_ignore(close(source, Kind::CloseParen, "`,` or `)`"))
        .boxed()
}

/// Parses the condition of `if`, `while`, `do` or the value of `switch`, in parentheses.
fn condition<'a>(source: &'a Source<'a>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let assignment = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Assign) {
            return Err(Problem(None));
        }
        input.next();
        let place = source.place(at);
        input.emit(
            Diagnostic::error("E0117", "`=` assigns and is not a condition", place, "an assignment")
                .help("compare with `==`")
                .fix("write `==`", place, "==")
                .into(),
        );
        Ok(place)
    });
    let value = any.clone().then(assignment.then(any.clone()).or_not()).map(|(left, rest)| match rest {
        Some((op_span, right)) => binary(left, (BinaryOp::Equal, op_span), right),
        None => left,
    });
    let inside = just(Kind::OpenParen).ignore_then(value).then_ignore(close(
        source,
        Kind::CloseParen,
        "an operator or `)`",
    ));
    let nothing = when(move |at| source.begins_line(at))
        .map_with(|(), extra| Expr { kind: ExprKind::Error, span: source.range(extra.span()) });
    let bare = expect(source, Kind::OpenParen, "before the condition").ignore_then(nothing.or(any));
    inside.or(bare).boxed()
}

/// Parses `if (c) a else b` as a value. The `else` branch includes all operators that follow.
fn conditional<'a>(
    source: &'a Source<'a>,
    condition: Rule<'a, Expr>,
    any: Rule<'a, Expr>,
    operators: Rule<'a, Expr>,
) -> Rule<'a, Expr> {
    let nothing = when(move |at| source.begins_line(at))
        .map_with(|(), extra| Expr { kind: ExprKind::Error, span: source.range(extra.span()) });
    let no_else = expect(source, Kind::Else, "after the first value of the conditional expression")
        .ignore_then(nothing.or(operators.clone()));
    let parts = just(Kind::If)
        .ignore_then(condition)
        .then(any)
        .then(just(Kind::Else).ignore_then(operators).or(no_else));
    let node = parts.map(|((condition, then), otherwise)| ExprKind::If {
        condition: Box::new(condition),
        then: Box::new(then),
        otherwise: Box::new(otherwise),
    });
    spanned(source, node)
}

/// Reports a missing operand, without consuming tokens.
fn missing<'a>(source: &'a Source<'a>) -> Rule<'a, Expr> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let message = format!("an expression is expected, not {}", source.describe(at));
        let mut problem = Diagnostic::error("E0112", message, source.place(at), "a value is expected here");
        let before = source.previous(at);
        let doubled = at >= 2 && source.touches_previous(at - 1) && source.previous(at - 1) == before;
        problem.help = match (before, source.kind(at)) {
            (Some(Kind::Plus | Kind::Minus), _) if doubled => {
                Some("write `i += 1`; there is no `++` or `--`".into())
            }
            (Some(Kind::Plus | Kind::Minus | Kind::Star | Kind::Slash), Some(Kind::Assign)) => {
                Some("write `+=` without a space".into())
            }
            (Some(Kind::Star), Some(Kind::Star)) => Some("write a power as `a^b`".into()),
            _ => None,
        };
        if problem.help.is_some() {
            problem = super::recovery::foreign_operator(source, at, problem);
        }
        input.emit(problem.into());
        Ok(Expr { kind: ExprKind::Error, span: source.after(at) })
    })
    .boxed()
}

/// Parses `value at Time = 0.1 s`.
fn at_clause<'a>(source: &'a Source<'a>, operators: Rule<'a, Expr>, any: Rule<'a, Expr>) -> Rule<'a, Expr> {
    let clause = just(Kind::At)
        .ignore_then(name(source, "the symbol"))
        .then_ignore(expect(source, Kind::Assign, "after the symbol of `at`"))
        .then(any);
    operators
        .then(clause.or_not())
        .map(|(value, clause)| match clause {
            None => value,
            Some((symbol, at)) => {
                let span = value.span.to(at.span);
                let kind = match symbol {
                    Some(symbol) => ExprKind::At { value: Box::new(value), symbol, at: Box::new(at) },
                    None => ExprKind::Error,
                };
                Expr { kind, span }
            }
        })
        .boxed()
}
