//! Parses statements and whole files.

use super::expressions::{Expressions, expressions, may_begin};
use super::recovery::{
    Reader, advance_to, assigns_on_new_line, close, expect, identifier, name, position, semicolon,
    skip_statement, unexpected, when,
};
use super::source::Source;
use super::{Extra, Input, Problem, Rule, declarations, definitions, foreign_loops};
use crate::ast::{BinaryOp, Bind, Expr, ExprKind, Stmt, StmtKind};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use chumsky::prelude::*;

/// Parses a file.
pub(super) fn file<'a>(source: &'a Source<'a>) -> Rule<'a, Vec<Stmt>> {
    // Statements end before a `}`; one that closes no block is reported and skipped.
    let stray = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::CloseBrace) {
            return Err(Problem(None));
        }
        input.next();
        input.emit(unexpected(source, at).into());
        Ok(StmtKind::Error)
    });
    statement(source).or(spanned(source, stray)).repeated().collect().then_ignore(end()).boxed()
}

fn spanned<'a>(
    source: &'a Source<'a>,
    kind: impl Parser<'a, Input<'a>, StmtKind, Extra> + 'a,
) -> Rule<'a, Stmt> {
    kind.map_with(|kind, extra| {
        let tokens = extra.span();
        Stmt { kind, span: source.range(tokens), doc: source.doc(tokens.start), private: false }
    })
    .boxed()
}

/// Parses any statement. Fails only at a `}` and at the end of the file.
fn statement<'a>(source: &'a Source<'a>) -> Rule<'a, Stmt> {
    let e = expressions(source);
    let any = recursive(|any| {
        let any = any.boxed();
        // The statement of a head such as `while (c)`, or an error if it is missing.
        let body = any.clone().or(spanned(source, missing(source))).boxed();
        let kind = choice((
            declarations::interface(source, &e),
            declarations::function(source, &e, body.clone()),
            declarations::component(source, &e, body.clone()),
            definitions::definition(source, &e),
            simple(source, &e).then_ignore(semicolon(source)).boxed(),
            jump(source, &e).then_ignore(semicolon(source)).boxed(),
            block(source, any),
            conditional(source, &e, body.clone()),
            loops(source, &e, body.clone()),
            labelled(source, &e, body.clone()),
            try_catch(source, body),
            expression_or_assignment(source, &e).then_ignore(semicolon(source)).boxed(),
            unusable(source),
        ));
        let hidden = declarations::private(source).ignore_then(kind.clone().or(missing(source)));
        let hidden = spanned(source, hidden).map(|statement| Stmt { private: true, ..statement });
        hidden.or(spanned(source, kind))
    });
    any.boxed()
}

/// Parses `;` and `var`.
fn simple<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, StmtKind> {
    let empty = when(move |at| source.kind(at) == Some(Kind::Semicolon)).to(StmtKind::Empty);
    empty.or(declarations::variables(source, e.full.clone())).boxed()
}

/// An operator of an assignment.
#[derive(Clone, Copy)]
enum Assignment {
    Bind(Bind),
    Update(BinaryOp),
}

/// Parses `place = value`, `place := value`, `place += value` or an expression, without the `;`.
fn expression_or_assignment<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, StmtKind> {
    let operator = select! {
        Kind::Assign => Assignment::Bind(Bind::Evaluate),
        Kind::Bind => Assignment::Bind(Bind::Symbolic),
        Kind::AddAssign => Assignment::Update(BinaryOp::Add),
        Kind::SubtractAssign => Assignment::Update(BinaryOp::Subtract),
        Kind::MultiplyAssign => Assignment::Update(BinaryOp::Multiply),
        Kind::DivideAssign => Assignment::Update(BinaryOp::Divide),
    }
    .map_with(|operator, extra| (operator, source.range(extra.span())));
    // Labels, `name :`, were tried before.
    when(move |at| {
        source.begin_statement(at);
        may_begin(source.kind(at)) && begins_expression(source.kind(at))
    })
    .ignore_then(e.full.clone())
    .then(operator.then(e.full.clone()).or_not())
    .map_with(|(place, assigned), extra| match assigned {
        None => StmtKind::Expr(place),
        Some(((operator, op_span), value)) => {
            if !is_place(&place) {
                extra.emit(
                    Diagnostic::error(
                        "E0122",
                        "this cannot be assigned to",
                        place.span,
                        "a value, not a variable",
                    )
                    .help("assign to a variable or an element of one; compare with `==`")
                    .into(),
                );
            }
            match operator {
                Assignment::Bind(bind) => StmtKind::Assign { place, bind, value },
                Assignment::Update(op) => StmtKind::Update { place, op, op_span, value },
            }
        }
    })
    .boxed()
}

/// Returns `true` if a statement that starts with this token is probably an expression.
fn begins_expression(kind: Option<Kind>) -> bool {
    matches!(
        kind,
        Some(
            Kind::Number
                | Kind::Identifier
                | Kind::StringOpen
                | Kind::True
                | Kind::False
                | Kind::OpenParen
                | Kind::OpenBracket
                | Kind::Plus
                | Kind::Minus
                | Kind::Not
        )
    )
}

fn is_place(expr: &Expr) -> bool {
    match &expr.kind {
        ExprKind::Name(_) | ExprKind::Error => true,
        ExprKind::Index { base, .. } | ExprKind::Field { base, .. } => is_place(base),
        // `a + = 1`: reported at the missing operand.
        ExprKind::Binary { right, .. } => matches!(right.kind, ExprKind::Error),
        _ => false,
    }
}

/// Parses `break`, `continue`, `return`, `goto`, `throw`, without the `;`.
fn jump<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, StmtKind> {
    // A value on the next line belongs to the next statement: a `;` is missing.
    let value =
        when(move |at| may_begin(source.kind(at)) && !(source.begins_line(at) && ends_here(source, at)))
            .ignore_then(e.full.clone())
            .or_not();
    // `goto` followed by `y = 2;` on the next line.
    let no_label = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if !assigns_on_new_line(source, at) {
            return Err(Problem(None));
        }
        let message = "the name of the label is expected, not the end of the line";
        input.emit(Diagnostic::error("E0114", message, source.after(at), "a name is expected here").into());
        Ok(None)
    });
    let begins =
        |kind| matches!(kind, Kind::Break | Kind::Continue | Kind::Return | Kind::Throw | Kind::Goto);
    let jump = choice((
        just(Kind::Break).to(StmtKind::Break),
        just(Kind::Continue).to(StmtKind::Continue),
        just(Kind::Return).ignore_then(value.clone()).map(StmtKind::Return),
        just(Kind::Throw).ignore_then(value).map(StmtKind::Throw),
        just(Kind::Goto)
            .ignore_then(no_label.or(name(source, "the label")))
            .map(|label| label.map_or(StmtKind::Error, StmtKind::Goto)),
    ));
    when(move |at| source.kind(at).is_some_and(begins)).ignore_then(jump).boxed()
}

/// Returns `true` if `return` or `throw` before `at` has no value: an assignment or a call on the
/// next line is a separate statement.
fn ends_here(source: &Source<'_>, at: usize) -> bool {
    matches!(source.kind(at + 1), Some(Kind::Assign | Kind::Bind | Kind::Colon))
        || source.kind(at) == Some(Kind::If)
}

/// Parses a block. If its `}` is missing, the block ends where the indentation of the lines says,
/// or else with the file.
fn block<'a>(source: &'a Source<'a>, statement: Rule<'a, Stmt>) -> Rule<'a, StmtKind> {
    custom(move |input: &mut Reader<'a, '_>| {
        let open = position(input);
        if source.kind(open) != Some(Kind::OpenBrace) {
            return Err(Problem(None));
        }
        input.next();
        let mut statements = Vec::new();
        let mut at = position(input);
        while source.kind(at).is_some_and(|kind| kind != Kind::CloseBrace) && !source.ends_block(open, at) {
            statements.push(input.parse(&statement)?);
            at = position(input);
        }
        let ends_early = source.ends_block(open, at);
        if source.kind(at) == Some(Kind::CloseBrace) && !ends_early {
            input.next();
            return Ok(StmtKind::Block(statements));
        }
        let after = source.after(at);
        let label = if ends_early { "`}` is expected here" } else { "the file ends inside it" };
        // At the end of the file, the innermost of the open blocks is reported.
        let opening = if ends_early { Some(open) } else { source.opening(at, Kind::CloseBrace) };
        let place = source.place(opening.unwrap_or(open));
        let problem = Diagnostic::error("E0111", "this block is not closed", place, "opened here")
            .label(after, label)
            .help("close it with `}`");
        let indent = " ".repeat(source.indent(open));
        input.emit(match ends_early {
            true => problem.suggest("insert `}`", after, format!("\n{indent}}}")).into(),
            false => problem.into(),
        });
        Ok(StmtKind::Block(statements))
    })
    .boxed()
}

fn conditional<'a>(source: &'a Source<'a>, e: &Expressions<'a>, body: Rule<'a, Stmt>) -> Rule<'a, StmtKind> {
    let branch = just(Kind::If)
        .ignore_then(e.condition.clone())
        .then(body.clone())
        .then(just(Kind::Else).ignore_then(body.clone()).or_not())
        .map(|((condition, then), otherwise)| StmtKind::If {
            condition,
            then: Box::new(then),
            otherwise: otherwise.map(Box::new),
        });
    let switch = just(Kind::Switch)
        .ignore_then(e.condition.clone())
        .then_ignore(when(move |at| source.kind(at) == Some(Kind::OpenBrace)).or(not_a_block(source)))
        .then(body)
        .map(|(value, body)| StmtKind::Switch { value, body: Box::new(body) });
    branch.or(switch).boxed()
}

/// Reports a missing block, and uses the next statement instead.
fn not_a_block<'a>(source: &'a Source<'a>) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let message = format!("`{{` is expected after `switch (...)`, not {}", source.describe(at));
        input.emit(Diagnostic::error("E0115", message, source.place(at), "found here").into());
        Ok(())
    })
    .boxed()
}

fn loops<'a>(source: &'a Source<'a>, e: &Expressions<'a>, body: Rule<'a, Stmt>) -> Rule<'a, StmtKind> {
    let repeat = just(Kind::While)
        .ignore_then(e.condition.clone())
        .then(body.clone())
        .map(|(condition, body)| StmtKind::While { condition, body: Box::new(body) });
    let repeat_after = just(Kind::Do)
        .ignore_then(body.clone())
        .then_ignore(expect(source, Kind::While, "after the body of `do`"))
        .then(e.condition.clone())
        .then_ignore(semicolon(source))
        .map(|(body, condition)| StmtKind::DoWhile { body: Box::new(body), condition });

    // An empty statement, if the header continues.
    let nothing = spanned(source, empty().to(StmtKind::Empty));
    let step = spanned(source, expression_or_assignment(source, e)).or(nothing.clone()).boxed();
    let init = spanned(source, declarations::variables(source, e.full.clone())).or(step.clone()).boxed();
    let condition = when(move |at| may_begin(source.kind(at)) && !assigns_on_new_line(source, at))
        .ignore_then(e.full.clone())
        .or_not();
    let header = expect(source, Kind::OpenParen, "after `for`")
        .ignore_then(init)
        .then_ignore(expect(source, Kind::Semicolon, "after the initialization of a `for`"))
        .then(condition)
        .then_ignore(expect(source, Kind::Semicolon, "after the condition of a `for`"))
        .then(step)
        .then_ignore(close(source, Kind::CloseParen, "`)`"));
    let count =
        just(Kind::For).ignore_then(header).then(body.clone()).map(|(((init, condition), step), body)| {
            StmtKind::For { init: Box::new(init), condition, step: Box::new(step), body: Box::new(body) }
        });
    let begins = |kind| matches!(kind, Kind::While | Kind::Do | Kind::For);
    let any = choice((repeat, repeat_after, each(source, e, body), count));
    when(move |at| source.kind(at).is_some_and(begins)).ignore_then(any).boxed()
}

/// Parses `for (x in values) body`.
fn each<'a>(source: &'a Source<'a>, e: &Expressions<'a>, body: Rule<'a, Stmt>) -> Rule<'a, StmtKind> {
    let declares = move |at| source.kind(at) == Some(Kind::Var);
    // `for (var x in values)`, as in other languages.
    let declaration = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if declares(at) {
            input.next();
            let message = "the element of a `for` loop is declared without `var`";
            let place = source.place(at);
            let between = crate::span::Span { end: source.place(at + 1).start, ..place };
            input.emit(
                Diagnostic::error("E0850", message, place, "not expected here")
                    .help("write `for (x in values)`, which declares `x` for the loop")
                    .fix("remove `var`", between, "")
                    .into(),
            );
        }
        Ok(())
    });
    let looped = when(move |at| {
        let name = at + 2 + usize::from(declares(at + 2));
        source.kind(at) == Some(Kind::For)
            && source.kind(at + 1) == Some(Kind::OpenParen)
            && source.kind(name) == Some(Kind::Identifier)
            && source.kind(name + 1) == Some(Kind::In)
    })
    .ignore_then(just(Kind::For))
    .ignore_then(just(Kind::OpenParen))
    .ignore_then(declaration)
    .ignore_then(identifier(source))
    .then_ignore(just(Kind::In))
    .then(e.values.clone())
    .then_ignore(close(source, Kind::CloseParen, "`)`"))
    .then(body.clone())
    .map(|((variable, values), body)| StmtKind::ForEach { variable, values, body: Box::new(body) });
    choice((
        looped.boxed(),
        foreign_loops::without_parentheses(source, e, body.clone()),
        foreign_loops::several_names(source, e, body),
    ))
    .boxed()
}

/// Parses `case e:`, `default:` and `label:`, with their statements.
fn labelled<'a>(source: &'a Source<'a>, e: &Expressions<'a>, body: Rule<'a, Stmt>) -> Rule<'a, StmtKind> {
    let case = just(Kind::Case)
        .ignore_then(e.full.clone())
        .then_ignore(expect(source, Kind::Colon, "after the value of a `case`"))
        .then(body.clone())
        .map(|(value, statement)| StmtKind::Case { value, statement: Box::new(statement) });
    let default = just(Kind::Default)
        .ignore_then(expect(source, Kind::Colon, "after `default`"))
        .ignore_then(body.clone())
        .map(|statement| StmtKind::Default(Box::new(statement)));
    let label = identifier(source)
        .then_ignore(just(Kind::Colon))
        .then(body)
        .map(|(label, statement)| StmtKind::Label { label, statement: Box::new(statement) });
    choice((case, default, label)).boxed()
}

fn try_catch<'a>(source: &'a Source<'a>, body: Rule<'a, Stmt>) -> Rule<'a, StmtKind> {
    let name = just(Kind::OpenParen).ignore_then(identifier(source).or_not()).then_ignore(close(
        source,
        Kind::CloseParen,
        "a name or `)`",
    ));
    let no_name = expect(source, Kind::OpenParen, "after `catch`; write `catch ()` to ignore the error");
    let header = just(Kind::Catch).ignore_then(name.or(no_name.to(None)));
    let handler = header.then(body.clone()).map(Some);
    let no_handler = expect(source, Kind::Catch, "after the body of `try`").map(|_| None);
    just(Kind::Try)
        .ignore_then(body)
        .then(handler.or(no_handler))
        .map(|(body, handler)| match handler {
            Some((error, handler)) => {
                StmtKind::Try { body: Box::new(body), error, handler: Box::new(handler) }
            }
            None => body.kind,
        })
        .boxed()
}

/// Reports a missing statement, without consuming tokens.
fn missing<'a>(source: &'a Source<'a>) -> Rule<'a, StmtKind> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let message = format!("a statement is expected, not {}", source.describe(at));
        input.emit(
            Diagnostic::error("E0115", message, source.place(at), "a statement is expected here")
                .help("write `;` for an empty statement")
                .into(),
        );
        Ok(StmtKind::Error)
    })
    .boxed()
}

/// Reports tokens that start no statement, and skips them up to the next statement.
fn unusable<'a>(source: &'a Source<'a>) -> Rule<'a, StmtKind> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if matches!(source.kind(at), None | Some(Kind::CloseBrace)) {
            return Err(Problem(None));
        }
        input.emit(unexpected(source, at).into());
        let closes = |at| matches!(source.kind(at), Some(Kind::CloseParen | Kind::CloseBracket));
        if closes(at) {
            // A statement may follow brackets that close nothing.
            let end = (at..).find(|i| !closes(*i)).unwrap_or(at);
            advance_to(input, end + usize::from(source.kind(end) == Some(Kind::Semicolon)));
        } else {
            skip_statement(source, input);
        }
        Ok(StmtKind::Error)
    })
    .boxed()
}
