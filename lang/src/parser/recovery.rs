//! Error recovery: expected tokens, their error messages, and the tokens at which parsing
//! continues.

use super::source::Source;
use super::{Extra, Input, Problem, Rule};
use crate::ast::Ident;
use crate::diagnostic::Diagnostic;
use crate::lexer::{self, Kind};
use crate::span::Span;
use crate::units::Unit;
use chumsky::input::InputRef;
use chumsky::prelude::*;

pub(super) type Reader<'a, 'p> = InputRef<'a, 'p, Input<'a>, Extra>;

/// Returns the index of the next token.
pub(super) fn position(input: &Reader<'_, '_>) -> usize {
    *input.cursor().inner()
}

pub(super) fn advance_to(input: &mut Reader<'_, '_>, index: usize) {
    while position(input) < index && input.next().is_some() {}
}

/// Succeeds without consuming tokens if `test` accepts the index of the next token.
pub(super) fn when<'a>(test: impl Fn(usize) -> bool + 'a) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| if test(position(input)) { Ok(()) } else { Err(Problem(None)) })
        .boxed()
}

/// Parses a token of a kind and returns its index.
pub(super) fn index_of<'a>(kind: Kind) -> Rule<'a, usize> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if input.next() == Some(kind) { Ok(at) } else { Err(Problem(None)) }
    })
    .boxed()
}

/// Parses a name.
pub(super) fn identifier<'a>(source: &'a Source<'a>) -> Rule<'a, Ident> {
    index_of(Kind::Identifier).map(|at| source.ident(at)).boxed()
}

/// Parses a required token; returns `true` if it is present. `context` is its purpose, such as
/// "after the condition".
pub(super) fn expect<'a>(source: &'a Source<'a>, kind: Kind, context: &'static str) -> Rule<'a, bool> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) == Some(kind) {
            input.next();
            return Ok(true);
        }
        let message = format!("{} is expected {context}, not {}", kind.describe(), source.describe(at));
        let problem = Diagnostic::error("E0115", message, source.place(at), "found here");
        let replacement = match (kind, source.kind(at)) {
            (Kind::Bind, Some(Kind::Assign)) => ":=",
            (Kind::Assign, Some(Kind::Bind)) => "=",
            _ => {
                input.emit(problem.into());
                return Ok(false);
            }
        };
        // The other assignment sign: the value that follows is meant.
        input.next();
        let problem = problem.help(format!("write `{replacement}`"));
        input.emit(problem.fix(format!("change to `{replacement}`"), source.place(at), replacement).into());
        Ok(true)
    })
    .boxed()
}

/// Parses a required name; returns `None` if it is missing. `what` is the named item, such as "the
/// variable".
pub(super) fn name<'a>(source: &'a Source<'a>, what: &'static str) -> Rule<'a, Option<Ident>> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) == Some(Kind::Identifier) {
            input.next();
            return Ok(Some(source.ident(at)));
        }
        let reserved = lexer::keywords().any(|word| source.kind(at).is_some() && word == source.text(at));
        let same_line = !source.begins_line(at);
        if let Some(problem) = at.checked_sub(1).and_then(|comma| decimal_comma(source, comma)) {
            // The unit is part of the number.
            let end = (at + 1..).find(|next| source.kind(*next) != Some(Kind::Identifier)).unwrap_or(at + 1);
            advance_to(input, end);
            input.emit(problem.into());
            return Ok(None);
        }
        let problem = if reserved && same_line {
            input.next();
            let message = format!("the keyword `{}` cannot name {what}", source.text(at));
            Diagnostic::error("E0114", message, source.place(at), "reserved").help("choose another name")
        } else {
            let message = format!("the name of {what} is expected, not {}", source.describe(at));
            Diagnostic::error("E0114", message, source.place(at), "a name is expected here")
        };
        input.emit(problem.into());
        Ok(None)
    })
    .boxed()
}

/// Parses a required name and the former name after `was`, if any: `teeth was lugs`.
pub(super) fn renamed<'a>(
    source: &'a Source<'a>,
    what: &'static str,
) -> Rule<'a, (Option<Ident>, Option<Ident>)> {
    let was = when(move |at| {
        source.text(at) == "was"
            && source.kind(at) == Some(Kind::Identifier)
            && source.kind(at + 1) == Some(Kind::Identifier)
    });
    let former = was.ignore_then(just(Kind::Identifier)).ignore_then(identifier(source));
    name(source, what).then(former.or_not()).boxed()
}

/// Parses a required name; reports and skips a former name after it. `what` is the named item and
/// `kinds` its kind in the plural.
pub(super) fn never_renamed<'a>(
    source: &'a Source<'a>,
    what: &'static str,
    kinds: &'static str,
) -> Rule<'a, Option<Ident>> {
    let former = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let is_name = |at| source.kind(at) == Some(Kind::Identifier);
        if source.text(at) == "was" && is_name(at) && is_name(at + 1) {
            advance_to(input, at + 2);
            let place = source.place(at).to(source.place(at + 1));
            let removed = Span { start: source.after(at).start, ..place };
            let help = "functions, parameters, records and fields keep former names; remove this one";
            input.emit(
                Diagnostic::error(
                    "E0881",
                    format!("{kinds} have no former names"),
                    place,
                    "not allowed here",
                )
                .help(help)
                .fix("remove the former name", removed, "")
                .into(),
            );
        }
        Ok(())
    });
    name(source, what).then_ignore(former).boxed()
}

/// Returns `true` if a token starts a line with an assignment, such as `name = ...`. If a value is
/// missing before it, this line is a separate statement and the one above is incomplete.
pub(super) fn assigns_on_new_line(source: &Source<'_>, at: usize) -> bool {
    source.kind(at) == Some(Kind::Identifier)
        && source.kind(at + 1).is_some_and(Kind::assigns)
        && source.begins_line(at)
}

/// Returns `true` if a `=`, `:=`, `+=`, `return` or `throw` precedes a token in its statement,
/// outside of brackets that are closed before the token.
pub(super) fn in_value(source: &Source<'_>, at: usize) -> bool {
    let before = (0..at).rev().map_while(|i| source.kind(i));
    let mut closed = 0_usize;
    // A label or a `case` ends with `:`.
    let around = |k: &Kind| matches!(k, Kind::Semicolon | Kind::Colon | Kind::OpenBrace | Kind::CloseBrace);
    before.take_while(|k| !around(k)).any(|k| {
        match k {
            Kind::CloseParen | Kind::CloseBracket => closed += 1,
            Kind::OpenParen | Kind::OpenBracket => closed = closed.saturating_sub(1),
            _ => {}
        }
        closed == 0 && (k.assigns() || matches!(k, Kind::Return | Kind::Throw))
    })
}

/// Parses the `;` at the end of a statement. If it is missing, it is reported and the next
/// statement is parsed; if there are other tokens, they are skipped up to the end of the statement.
pub(super) fn semicolon<'a>(source: &'a Source<'a>) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let found = source.kind(at);
        if found == Some(Kind::Semicolon) {
            input.next();
            return Ok(());
        }
        let ended = found.is_none_or(|k| k.begins_statement() || matches!(k, Kind::CloseBrace | Kind::If));
        if let Some(problem) = unknown_word(source, at) {
            input.emit(problem.into());
            skip_statement(source, input);
        } else if ended || source.begins_line(at) {
            let place = source.after(at);
            let problem = Diagnostic::error("E0110", "a `;` is missing", place, "the statement ends here")
                .help("end the statement with `;`")
                .fix("insert `;`", place, ";");
            input.emit(problem.into());
        } else {
            input.emit(unexpected(source, at).into());
            // A block is parsed as a separate statement, so that its errors are also reported.
            if found != Some(Kind::OpenBrace) {
                skip_statement(source, input);
            }
        }
        Ok(())
    })
    .boxed()
}

/// Reports two adjacent names at the start of a statement: `int x = 3;`, `parm torque = 1 N;`.
fn unknown_word(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    let first = at.checked_sub(1)?;
    let begins = matches!(
        source.previous(first),
        None | Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace | Kind::Colon)
    );
    let names = source.kind(first) == Some(Kind::Identifier) && source.kind(at) == Some(Kind::Identifier);
    if !begins || !names || source.begins_line(at) {
        return None;
    }
    let word = source.text(first);
    let place = source.place(first);
    let message = format!("a statement cannot start with `{word}`");
    let problem = Diagnostic::error("E0113", message, place, "not a keyword");
    let types = ["int", "double", "float", "real", "number", "let", "auto", "bool", "string", "Number"];
    if types.contains(&word) {
        return Some(problem.help("declare variables with `var`; types are inferred").fix(
            "write `var`",
            place,
            "var",
        ));
    }
    let similar = lexer::keywords()
        .map(|keyword| (strsim::jaro_winkler(keyword, word), keyword))
        .filter(|(similarity, _)| *similarity > 0.85)
        .max_by(|a, b| a.0.total_cmp(&b.0));
    Some(match similar {
        Some((_, keyword)) => problem.help(format!("did you mean `{keyword}`?")).fix(
            format!("write `{keyword}`"),
            place,
            keyword,
        ),
        None => problem.help("an operator or `;` may be missing between the two names"),
    })
}

/// Adds a fix for `i++` and `a ** b` to the error for a missing operand, if the change is certain.
pub(super) fn foreign_operator(source: &Source<'_>, at: usize, problem: Diagnostic) -> Diagnostic {
    let ends = |index| {
        matches!(source.kind(index), None | Some(Kind::Semicolon | Kind::CloseParen | Kind::CloseBrace))
    };
    let named = |index| source.begins_statement(index) && source.kind(index) == Some(Kind::Identifier);
    let (Some(first), Some(sign)) = (at.checked_sub(2), at.checked_sub(1)) else { return problem };
    match source.kind(at) {
        Some(Kind::Star) if source.touches_previous(at) => {
            problem.fix("write `^`", source.place(sign).to(source.place(at)), "^")
        }
        _ if ends(at) && first > 0 && named(first - 1) => {
            let name = source.text(first - 1);
            let place = source.place(first).to(source.place(sign));
            let written = format!("{}= 1", source.text(sign));
            let place = Span { start: source.after(first).end, ..place };
            problem.fix(format!("write `{name} {written}`"), place, format!(" {written}"))
        }
        _ => problem,
    }
}

/// Returns the error for a decimal comma: `2,5 mm`.
fn decimal_comma(source: &Source<'_>, comma: usize) -> Option<Diagnostic> {
    let first = comma.checked_sub(1)?;
    let numbers = [first, comma + 1].iter().all(|at| source.kind(*at) == Some(Kind::Number));
    let touching = source.touches_previous(comma) && source.touches_previous(comma + 1);
    if source.kind(comma) != Some(Kind::Comma) || !numbers || !touching {
        return None;
    }
    let place = source.place(first).to(source.place(comma + 1));
    Diagnostic::decimal_comma(place, source.text(first), source.text(comma + 1))
}

/// Returns the error for a number directly after a quantity, as in `14 deg 30`.
fn after_quantity(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    let unit = at.checked_sub(1)?;
    let number = unit.checked_sub(1)?;
    let kinds = [number, unit, at].map(|index| source.kind(index));
    if kinds != [Some(Kind::Number), Some(Kind::Identifier), Some(Kind::Number)] {
        return None;
    }
    let named = Unit::find(source.text(unit))?;
    let (quantity, second) = (format!("{} {}", source.text(number), source.text(unit)), source.text(at));
    let problem = Diagnostic::error(
        "E0131",
        format!("`{second}` follows `{quantity}` without an operator"),
        source.place(at),
        "a second number",
    );
    let degrees: Option<f64> = source.text(number).parse().ok();
    let minutes: Option<f64> = second.parse().ok().filter(|minutes| (0.0..60.0).contains(minutes));
    let (Some(degrees), Some(minutes), "deg") = (degrees, minutes, named.name) else {
        return Some(problem.help("write an operator or a `,` between the two"));
    };
    // The unit of the minutes, if any.
    let own = source.kind(at + 1) == Some(Kind::Identifier) && Unit::find(source.text(at + 1)).is_some();
    let last = if own { at + 1 } else { at };
    let sign = if source.previous(number) == Some(Kind::Minus) { '-' } else { '+' };
    let written = format!("{sign} {second} arcmin");
    let problem = problem.help(format!(
        "{second} minutes of arc are added: write `{quantity} {written}`, or `{} deg`",
        shortest(degrees + minutes / 60.0)
    ));
    Some(problem.suggest(
        format!("write `{quantity} {written}`"),
        source.place(at).to(source.place(last)),
        written,
    ))
}

/// Returns a number with at most six decimals.
fn shortest(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Returns the error for a number directly after another number, as in `100 1/min`.
fn second_number(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    let before = at.checked_sub(1)?;
    if source.kind(at) != Some(Kind::Number) || source.kind(before) != Some(Kind::Number) {
        return None;
    }
    let (first, second) = (source.text(before), source.text(at));
    let place = source.place(at);
    let problem = Diagnostic::error(
        "E0131",
        format!("`{second}` follows the number `{first}` without an operator"),
        place,
        "a second number",
    );
    let unit = source.kind(at + 1) == Some(Kind::Slash) && source.kind(at + 2) == Some(Kind::Identifier);
    if second != "1" || !unit {
        return Some(problem.help("write an operator or a `,` between the two"));
    }
    let written = format!("{first}/{}", source.text(at + 2));
    let problem = problem.help(format!("write a unit of the form 1/x with `/`: `{written}`"));
    // Without parentheses the operator would apply to the number alone.
    if matches!(source.previous(before), Some(Kind::Slash | Kind::Caret)) {
        return Some(problem);
    }
    let between = Span { start: source.after(at).end, ..place };
    Some(problem.fix(format!("write `{written}`"), between, ""))
}

/// Returns the error for a conversion of other languages, such as `x to deg`.
pub(super) fn conversion(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    let word = source.text(at);
    let unit = source.kind(at + 1) == Some(Kind::Identifier) && Unit::find(source.text(at + 1)).is_some();
    if !matches!(word, "to" | "in" | "as") || !unit {
        return None;
    }
    let unit = source.text(at + 1);
    let problem = Diagnostic::error(
        "E0923",
        format!("a value is not converted by `{word}`: it has no unit of its own"),
        source.place(at).to(source.place(at + 1)),
        "not an operator",
    );
    let value = at.checked_sub(1).filter(|before| source.kind(*before) == Some(Kind::Identifier));
    let value = value.map_or("x", |before| source.text(before));
    let mut before = (0..at).rev().filter_map(|before| source.kind(before));
    let bound = before
        .find(|kind| matches!(kind, Kind::InterpolationOpen | Kind::InterpolationClose | Kind::Semicolon));
    Some(match bound == Some(Kind::InterpolationOpen) {
        true => problem.help(format!("write the unit after a colon: `{{{value} : {unit}}}`")).fix(
            format!("write `: {unit}`"),
            source.place(at),
            ":",
        ),
        false => problem.help(format!(
            "a text shows it in another unit: `\"{{{value} : {unit}}}\"`; for the number of units, divide: \
             `{value}/(1 {unit})`"
        )),
    })
}

/// Returns the error for a known mistake at a token that no rule accepts.
fn mistake(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    decimal_comma(source, at)
        .or_else(|| second_number(source, at))
        .or_else(|| after_quantity(source, at))
        .or_else(|| conversion(source, at))
}

/// Returns the error for a token that no rule accepts.
pub(super) fn unexpected(source: &Source<'_>, at: usize) -> Diagnostic {
    if let Some(problem) = mistake(source, at) {
        return problem;
    }
    let place = source.place(at);
    let problem = |what: String| Diagnostic::error("E0113", what, place, "not expected here");
    match source.kind(at) {
        Some(Kind::CloseParen | Kind::CloseBracket | Kind::CloseBrace) => {
            let message = format!("{} has no matching bracket", source.describe(at));
            Diagnostic::error("E0116", message, place, "no bracket is open here").help("remove it").suggest(
                "remove it",
                place,
                "",
            )
        }
        Some(Kind::Percent) => problem("`%` is a unit and follows a number".into())
            .help("the remainder of a division is `a - b*floor(a/b)`"),
        Some(Kind::OpenBrace) => problem("unexpected block".into())
            .help("check the spelling of the previous word: `if`, `while`, `for` and `switch` have blocks"),
        Some(Kind::Else) => problem("this `else` has no `if`".into())
            .help("`else` must follow the single statement or block of its `if`"),
        Some(Kind::Catch) => problem("this `catch` has no `try`".into())
            .help("`catch` must follow the single statement or block of its `try`"),
        Some(Kind::Assign | Kind::Bind) => problem(format!("{} is unexpected", source.describe(at)))
            .help("assign one value per statement, or compare with `==`"),
        _ => problem(format!("{} is unexpected", source.describe(at)))
            .help("an operator, a `,` or a `;` may be missing before it"),
    }
}

/// Skips the rest of a statement: at least one token, then up to and including the next `;`, or up
/// to the next brace or keyword that starts a statement on its own line.
pub(super) fn skip_statement<'a>(source: &'a Source<'a>, input: &mut Reader<'a, '_>) {
    let start = position(input);
    let mut at = source.next(start);
    while let Some(kind) = source.kind(at) {
        // The token skipped before may already be the end.
        if source.previous(at) == Some(Kind::Semicolon) {
            break;
        }
        let begins = source.begins_line(at) && (kind.begins_statement() || kind == Kind::If);
        if begins || matches!(kind, Kind::OpenBrace | Kind::CloseBrace) {
            break;
        }
        at = source.next(at);
    }
    advance_to(input, at);
}

/// Parses the bracket that closes a list. Other tokens before a matching bracket are reported and
/// skipped. `expected` describes the allowed tokens, such as "`,` or `)`".
pub(super) fn close<'a>(source: &'a Source<'a>, kind: Kind, expected: &'static str) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) == Some(kind) {
            input.next();
            return Ok(());
        }
        let closing = closing_ahead(source, at, kind);
        let place = source.after(at);
        let mut problem = match closing {
            Some(_) => mistake(source, at).unwrap_or_else(|| {
                let message = format!("{expected} is expected, not {}", source.describe(at));
                Diagnostic::error("E0115", message, source.place(at), "found here")
            }),
            None => {
                let message = format!("a {} is missing", kind.describe());
                Diagnostic::error("E0111", message, place, "expected here")
                    .help(format!("close the bracket with {}", kind.describe()))
            }
        };
        if let Some(open) = source.opening(at, kind) {
            problem = problem.label(source.place(open), "opened here");
        }
        if closing.is_none() && source.kind(at) == Some(Kind::Semicolon) {
            problem =
                problem.fix(format!("insert {}", kind.describe()), place, kind.describe().trim_matches('`'));
        }
        input.emit(problem.into());
        if let Some(closing) = closing {
            advance_to(input, closing + 1);
        }
        Ok(())
    })
    .boxed()
}

/// Returns the next bracket of `kind` that matches the bracket open at `at`, if the statement does
/// not end before it.
fn closing_ahead(source: &Source<'_>, at: usize, kind: Kind) -> Option<usize> {
    let mut open = 0_usize;
    let mut index = at;
    while let Some(found) = source.kind(index) {
        match found {
            _ if found == kind && open == 0 => return Some(index),
            Kind::OpenParen | Kind::OpenBracket => open += 1,
            Kind::CloseParen | Kind::CloseBracket if open == 0 => return None,
            Kind::CloseParen | Kind::CloseBracket => open -= 1,
            Kind::Semicolon
            | Kind::OpenBrace
            | Kind::CloseBrace
            | Kind::InterpolationClose
            | Kind::StringClose => return None,
            _ if found.begins_statement() => return None,
            _ => {}
        }
        index = source.next(index);
    }
    None
}
