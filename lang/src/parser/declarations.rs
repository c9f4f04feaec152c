//! Parses functions, their parameters and types, and the declarations of a model's interface.

use super::Problem;
use super::Rule;
use super::expressions::{Expressions, unit_product};
use super::recovery::{
    Reader, close, expect, identifier, name, never_renamed, position, renamed, semicolon, when,
};
use super::source::Source;
use crate::ast::{
    Bind, Domain, Expr, ExprKind, FunctionBody, FunctionDecl, Ident, Import, Mode, ParamDecl, Parameter,
    Stmt, StmtKind, TypeExpr, TypeKind,
};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use chumsky::pratt::{infix, left, postfix};
use chumsky::prelude::*;

/// Parses `import`, `units`, `param` and `output`, which are allowed only at the top level.
pub(super) fn interface<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, StmtKind> {
    let end = semicolon(source);
    let path = name(source, "the module")
        .then(just(Kind::Dot).ignore_then(name(source, "the module")).repeated().collect::<Vec<_>>())
        .map(|(first, rest)| (std::iter::once(first).chain(rest).collect::<Option<Vec<Ident>>>(), false));
    let path = quoted_path(source).map(|path| (Some(path), true)).or(path);
    let alias = when(move |at| source.text(at) == "as" && source.kind(at + 1) == Some(Kind::Identifier));
    let alias = alias.ignore_then(identifier(source)).ignore_then(identifier(source)).or_not();
    let import = just(Kind::Import).ignore_then(path).then(alias).then_ignore(end.clone()).map_with(
        |((path, is_quoted), alias), extra| {
            if let (Some(path), true, None) = (&path, is_quoted, &alias) {
                let span = path.first().map_or_else(Default::default, |name| name.span);
                extra.emit(
                    Diagnostic::error(
                        "E0115",
                        "`as` and a name are expected after the file",
                        span,
                        "without a name",
                    )
                    .help("write `import \"folder/file\" as name;`")
                    .into(),
                );
            }
            path.map_or(StmtKind::Error, |path| StmtKind::Import(Import { path, alias, is_quoted }))
        },
    );
    let units = just(Kind::Units)
        .ignore_then(name(source, "the unit system"))
        .then_ignore(end.clone())
        .map(|system| system.map_or(StmtKind::Error, StmtKind::Units));
    let param = just(Kind::Param)
        .ignore_then(name(source, "the param"))
        .then_ignore(expect(source, Kind::Assign, "before the default of a param"))
        .then(e.full.clone())
        .then(domain(source, e).or_not())
        .then_ignore(end.clone())
        .map(|((name, default), domain)| match name {
            Some(name) => StmtKind::Param(ParamDecl { name, default, domain }),
            None => StmtKind::Error,
        });
    let output = just(Kind::Output)
        .ignore_then(name(source, "the output"))
        .then_ignore(expect(source, Kind::Bind, "before the value of an output"))
        .then(e.full.clone())
        .then(just(Kind::In).ignore_then(unit_product(source, e.operators.clone())).or_not())
        .then_ignore(end)
        .map(|((name, value), unit)| match name {
            Some(name) => StmtKind::Output { name, value, unit },
            None => StmtKind::Error,
        });
    top_level_only(source).ignore_then(choice((import, units, param, output))).boxed()
}

/// Parses the path of a module in quotation marks: `"folder/file"`.
fn quoted_path<'a>(source: &'a Source<'a>) -> Rule<'a, Vec<Ident>> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::StringOpen) {
            return Err(Problem(None));
        }
        let end = source.next(at);
        super::recovery::advance_to(input, end);
        let span = source.place(at).to(source.place(end - 1));
        let plain = end == at + 3 && source.kind(at + 1) == Some(Kind::StringText);
        let text = if plain { source.text(at + 1) } else { "" };
        let names: Vec<Ident> =
            text.split(['/', '.']).map(|name| Ident { name: name.into(), span }).collect();
        if names.iter().any(|name| name.name.trim().is_empty()) {
            input.emit(
                Diagnostic::error("E0114", "this is not the path of a module", span, "no path")
                    .help("write a file of this folder or below it, without `.cx`: `\"folder/file\"`")
                    .into(),
            );
        }
        Ok(names)
    })
    .boxed()
}

/// Reports the next token if it starts a top-level declaration inside a block, a function or
/// another statement.
fn top_level_only<'a>(source: &'a Source<'a>) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if !matches!(source.kind(at), Some(Kind::Import | Kind::Units | Kind::Param | Kind::Output)) {
            return Err(Problem(None));
        }
        if let Some(problem) = inside_another(source, at) {
            input.emit(problem.into());
        }
        Ok(())
    })
    .boxed()
}

/// Returns the error for a token that starts a top-level declaration below the top level.
pub(super) fn inside_another(source: &Source<'_>, at: usize) -> Option<Diagnostic> {
    let after_statement = matches!(source.previous(at), None | Some(Kind::Semicolon | Kind::CloseBrace));
    let inside = source.opening(at, Kind::CloseBrace);
    let begins = after_statement || source.begins_line(at);
    if inside.is_none() && begins {
        return None;
    }
    // Params and outputs are members of a component.
    if let Some(open) = inside.filter(|_| matches!(source.kind(at), Some(Kind::Param | Kind::Output)))
        && (begins || open + 1 == at)
        && is_component_body(source, open)
    {
        return None;
    }
    let member = matches!(source.kind(at), Some(Kind::Param | Kind::Output));
    let or_component = if member { " or component" } else { "" };
    let message = format!("{} is allowed only at the top level of a file{or_component}", source.describe(at));
    let problem =
        Diagnostic::error("E0123", message, source.place(at), "inside another statement").help("move it out");
    Some(match inside {
        Some(open) => problem.label(source.place(open), "inside this block"),
        None => problem,
    })
}

/// Returns `true` if a brace opens the body of a component.
fn is_component_body(source: &Source<'_>, open: usize) -> bool {
    let header = open
        .checked_sub(1)
        .filter(|close| source.kind(*close) == Some(Kind::CloseParen))
        .and_then(|close| source.opening(close, Kind::CloseParen));
    let is_component = |word: usize| source.kind(word) == Some(Kind::Component);
    // `component Name(`, or with a former name, which is reported.
    [2, 4].into_iter().filter_map(|before| header?.checked_sub(before)).any(is_component)
}

/// Parses `in low .. high` or `in ["a", "b"]`.
fn domain<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, Domain> {
    let choices = e.list.clone().map_with(|values, extra| Domain::Choices {
        values,
        span: source.range(extra.span()),
        other_names: Vec::new(),
    });
    let bound = when(move |at| {
        super::expressions::may_begin(source.kind(at)) && source.kind(at) != Some(Kind::DotDot)
    })
    .ignore_then(e.operators.clone());
    // After `..`, the end of the parameter or of the statement means that there is no upper limit.
    let upper = when(move |at| source.kind(at) != Some(Kind::Comma)).ignore_then(bound.clone()).or_not();
    let range = bound
        .or_not()
        .then_ignore(expect(source, Kind::DotDot, "between the limits of the range"))
        .then(upper)
        .map_with(|(low, high), extra| Domain::Range { low, high, span: source.range(extra.span()) });
    just(Kind::In).ignore_then(choice((choices, range))).boxed()
}

/// Parses `component Name(a: Type, b = 2) { ... }`.
pub(super) fn component<'a>(
    source: &'a Source<'a>,
    e: &Expressions<'a>,
    body: Rule<'a, Stmt>,
) -> Rule<'a, StmtKind> {
    let word = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Component) {
            return Err(Problem(None));
        }
        input.next();
        if source.previous(at) != Some(Kind::Private)
            && let Some(problem) = inside_another(source, at)
        {
            input.emit(problem.into());
        }
        Ok(())
    });
    let block = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::OpenBrace) {
            let message =
                format!("`{{` is expected before the body of a component, not {}", source.describe(at));
            input.emit(Diagnostic::error("E0115", message, source.place(at), "found here").into());
        }
        Ok(())
    });
    word.ignore_then(never_renamed(source, "the component", "components"))
        .then(parameters(source, parameter(source, e, type_expression(source), false)))
        .then_ignore(block)
        .then(body)
        .map(|((name, parameters), body)| {
            name.map_or(StmtKind::Error, |name| {
                StmtKind::Function(FunctionDecl {
                    name,
                    former: None,
                    parameters,
                    result: None,
                    body: FunctionBody::Statement(Box::new(body)),
                    is_test: false,
                    is_host: false,
                    is_component: true,
                })
            })
        })
        .boxed()
}

/// Parses the parameters of a function or component in parentheses.
fn parameters<'a>(source: &'a Source<'a>, one: Rule<'a, Option<Parameter>>) -> Rule<'a, Vec<Parameter>> {
    let listed = one.separated_by(just(Kind::Comma)).allow_trailing().collect::<Vec<Option<Parameter>>>();
    just(Kind::OpenParen)
        .ignore_then(listed.clone())
        .then_ignore(close(source, Kind::CloseParen, "`,` or `)`"))
        .or(expect(source, Kind::OpenParen, "before the parameters").ignore_then(listed))
        .map(|parameters| parameters.into_iter().flatten().collect::<Vec<_>>())
        .boxed()
}

/// Parses `function f(...) statement`, `host function f(...) statement`, `function p(...) := e;`,
/// `function p(...) := { ... }`, `extern pure function f(...) -> T;`.
pub(super) fn function<'a>(
    source: &'a Source<'a>,
    e: &Expressions<'a>,
    body: Rule<'a, Stmt>,
) -> Rule<'a, StmtKind> {
    let types = type_expression(source);
    let parameters = parameters(source, parameter(source, e, types.clone(), true));
    let signature = just(Kind::Function)
        .ignore_then(renamed(source, "the function"))
        .then(parameters)
        .then(just(Kind::Arrow).ignore_then(types).or_not())
        .boxed();
    let purity = identifier(source).or_not();
    let external = just(Kind::Extern)
        .ignore_then(purity)
        .then(signature.clone())
        .then(just(Kind::In).ignore_then(unit_product(source, e.operators.clone())).or_not())
        .then_ignore(semicolon(source))
        .map(|((purity, signature), unit)| (signature, FunctionBody::Extern { purity, unit }));
    let symbolic = just(Kind::Bind).ignore_then(e.full.clone()).then_ignore(semicolon(source));
    let block = just(Kind::Bind)
        .ignore_then(when(move |at| source.kind(at) == Some(Kind::OpenBrace)))
        .ignore_then(body.clone())
        .map(|block: Stmt| Expr { span: block.span, kind: ExprKind::Block(Box::new(block)) });
    let defined = signature.then(choice((
        block.map(FunctionBody::Symbolic),
        symbolic.map(FunctionBody::Symbolic),
        body.map(|body| FunctionBody::Statement(Box::new(body))),
    )));
    let marked = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let Some(mark @ (Kind::Test | Kind::Host)) = source.kind(at) else {
            return Err(Problem(None));
        };
        input.next();
        if source.previous(at) != Some(Kind::Private)
            && let Some(problem) = inside_another(source, at)
        {
            input.emit(problem.into());
        }
        Ok(mark)
    });
    // `function` followed by something else on the next line.
    let begun = just(Kind::Function)
        .ignore_then(when(move |at| {
            source.begins_line(at) && !matches!(source.kind(at), Some(Kind::Identifier | Kind::OpenParen))
        }))
        .ignore_then(name(source, "the function"))
        .to(StmtKind::Error);
    let whole = marked.or_not().then(external.or(defined)).map(
        |(mark, ((((name, former), parameters), result), body))| {
            let (is_test, is_host) = (mark == Some(Kind::Test), mark == Some(Kind::Host));
            name.map_or(StmtKind::Error, |name| {
                let is_component = false;
                StmtKind::Function(FunctionDecl {
                    name,
                    former,
                    parameters,
                    result,
                    body,
                    is_test,
                    is_host,
                    is_component,
                })
            })
        },
    );
    let begins = |kind| matches!(kind, Kind::Function | Kind::Extern | Kind::Test | Kind::Host);
    when(move |at| source.kind(at).is_some_and(begins)).ignore_then(begun.or(whole)).boxed()
}

/// Parses `private` before a declaration of a module; before anything else, it is reported and
/// skipped.
pub(super) fn private<'a>(source: &'a Source<'a>) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Private) {
            return Err(Problem(None));
        }
        input.next();
        if let Some(problem) = inside_another(source, at) {
            input.emit(problem.into());
        }
        let declares = matches!(
            source.kind(at + 1),
            Some(
                Kind::Function
                    | Kind::Extern
                    | Kind::Host
                    | Kind::Test
                    | Kind::Const
                    | Kind::Record
                    | Kind::Enum
                    | Kind::Component
                    | Kind::Dimension
                    | Kind::Unit
            )
        );
        if !declares {
            let message =
                format!("a declaration is expected after `private`, not {}", source.describe(at + 1));
            let problem = Diagnostic::error("E0115", message, source.place(at + 1), "found here")
                .help("write `private` before a declaration of a module, to hide it from importers");
            input.emit(problem.into());
        }
        Ok(())
    })
    .boxed()
}

/// Parses a parameter. Those of components have no mode.
fn parameter<'a>(
    source: &'a Source<'a>,
    e: &Expressions<'a>,
    types: Rule<'a, TypeExpr>,
    has_mode: bool,
) -> Rule<'a, Option<Parameter>> {
    let mode = select! { Kind::In => Mode::In, Kind::Out => Mode::Out, Kind::InOut => Mode::InOut };
    let mode = mode.map_with(move |mode, extra| {
        if !has_mode {
            let at: SimpleSpan = extra.span();
            let place = source.place(at.start);
            let next = source.place(at.end);
            let message =
                format!("a parameter of a component has no mode, so `{}` is wrong", source.text(at.start));
            extra.emit(
                Diagnostic::error("E0870", message, place, "not allowed here")
                    .help("a component only receives values; its members are read as `instance.member`")
                    .fix("remove it", crate::span::Span { end: next.start, ..place }, "")
                    .into(),
            );
        }
        if has_mode { mode } else { Mode::In }
    });
    // A name without a mode: `function f(a)`.
    let no_mode = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if source.kind(at) != Some(Kind::Identifier) {
            return Err(Problem(None));
        }
        if !has_mode {
            return Ok(Mode::In);
        }
        let place = source.place(at);
        let before = crate::span::Span { end: place.start, ..place };
        let message = format!("the parameter `{}` has no mode: `in`, `out` or `inout`", source.text(at));
        input.emit(
            Diagnostic::error("E0120", message, place, "missing mode")
                .help("`in` passes a value, `out` and `inout` copy one back")
                .fix("pass it by value", before, "in ")
                .into(),
        );
        Ok(Mode::In)
    });
    let bind = select! { Kind::Assign => Bind::Evaluate, Kind::Bind => Bind::Symbolic };
    let value =
        when(move |at| !matches!(source.kind(at), None | Some(Kind::Comma | Kind::CloseParen | Kind::In)))
            .ignore_then(e.full.clone());
    let default = custom(move |input: &mut Reader<'a, '_>| {
        // `in b =` needs a value; only `:=` may omit it.
        let at = position(input);
        let ends = matches!(source.kind(at + 1), Some(Kind::Comma | Kind::CloseParen));
        if source.kind(at) == Some(Kind::Assign) && ends {
            let message = "the default of the parameter is missing";
            input.emit(
                Diagnostic::error("E0112", message, source.place(at + 1), "a value is expected here").into(),
            );
        }
        Ok(())
    })
    .ignore_then(bind.then(value.or_not()));
    // A value that meant `none` before: `= none was 0 mm`.
    let was = when(move |at| source.text(at) == "was" && source.kind(at) == Some(Kind::Identifier));
    let former_none = was.ignore_then(just(Kind::Identifier)).ignore_then(e.full.clone());
    mode.or(no_mode)
        .then(renamed(source, "the parameter"))
        .then(just(Kind::Colon).ignore_then(types).or_not())
        .then(default.then(former_none.or_not()).or_not())
        .then(domain(source, e).or_not())
        .map_with(|((((mode, (name, former)), annotation), default), domain), extra| {
            let doc = source.doc(extra.span().start);
            let (default, former_none) = default.map_or((None, None), |(default, was)| (Some(default), was));
            name.map(|name| Parameter { mode, name, former, annotation, default, former_none, domain, doc })
        })
        .boxed()
}

/// Parses a type: `Length`, `Array(Number)`, `Force/Length^2`, `1/Length`.
pub(super) fn type_expression<'a>(source: &'a Source<'a>) -> Rule<'a, TypeExpr> {
    recursive(|any| type_grammar(source, any.boxed())).boxed()
}

fn type_grammar<'a>(source: &'a Source<'a>, any: Rule<'a, TypeExpr>) -> Rule<'a, TypeExpr> {
    let spanned = |kind: Rule<'a, TypeKind>| {
        kind.map_with(|kind, extra| TypeExpr { kind, span: source.range(extra.span()) }).boxed()
    };
    let arguments = just(Kind::OpenParen)
        .ignore_then(any.clone().separated_by(just(Kind::Comma)).allow_trailing().collect())
        .then_ignore(close(source, Kind::CloseParen, "`,` or `)`"));
    let none = just(Kind::OpenParen).ignore_then(just(Kind::CloseParen)).map(|_| Vec::new());
    let function =
        when(move |at| source.text(at) == "Function" && source.kind(at + 1) == Some(Kind::OpenParen))
            .ignore_then(identifier(source))
            .ignore_then(none.or(arguments.clone()))
            .then(just(Kind::Arrow).ignore_then(any.clone()).or_not())
            .map_with(|(parameters, result), extra| {
                let span = source.range(extra.span());
                let result = result.unwrap_or_else(|| {
                    let message = "the type of a function ends with the type of its result";
                    let problem = Diagnostic::error("E0124", message, span, "without a result");
                    extra.emit(problem.help("write `Function(Length) -> Force`").into());
                    TypeExpr { kind: TypeKind::Error, span }
                });
                TypeKind::Function(parameters, Box::new(result))
            });
    let member = just(Kind::Dot).ignore_then(identifier(source));
    let named = identifier(source).then(member.map(Ok).or(arguments.map(Err)).or_not()).map(
        |(name, rest)| match rest {
            Some(Ok(member)) => TypeKind::Member(name, member),
            Some(Err(arguments)) => TypeKind::Apply(name, arguments),
            None => TypeKind::Name(name),
        },
    );
    // The `1` of `1/Length`.
    let one = when(move |at| source.kind(at) == Some(Kind::Number) && source.text(at) == "1")
        .ignore_then(just(Kind::Number))
        .map_with(|_, extra| {
            TypeKind::Name(Ident { name: "Number".into(), span: source.range(extra.span()) })
        });
    let missing = custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        let message = format!("a type is expected, not {}", source.describe(at));
        input.emit(
            Diagnostic::error("E0124", message, source.place(at), "a type is expected here")
                .help("types are dimensions such as `Length`, or `Number`, `Bool`, `String`, `Array(Length)`")
                .into(),
        );
        Ok(TypeKind::Error)
    });
    let inner =
        just(Kind::OpenParen).ignore_then(any.clone()).then_ignore(close(source, Kind::CloseParen, "`)`"));
    let atom = choice((
        spanned(function.boxed()),
        spanned(named.boxed()),
        spanned(one.boxed()),
        inner.boxed(),
        spanned(missing.boxed()),
    ))
    .boxed();
    let exponent = just(Kind::Caret)
        .ignore_then(rational(source))
        .map_with(|power, extra| (power, source.range(extra.span())))
        .boxed();
    let join = |left: TypeExpr, right: TypeExpr, node: fn(Box<TypeExpr>, Box<TypeExpr>) -> TypeKind| {
        let span = left.span.to(right.span);
        TypeExpr { kind: node(Box::new(left), Box::new(right)), span }
    };
    let grammar = atom.pratt((
        postfix(
            2,
            exponent,
            |base: TypeExpr, ((numerator, denominator), place): ((i32, i32), _), _: &mut _| {
                let span = base.span.to(place);
                TypeExpr { kind: TypeKind::Power(Box::new(base), numerator, denominator), span }
            },
        ),
        infix(left(1), just(Kind::Star), move |l, _, r, _: &mut _| join(l, r, TypeKind::Product)),
        infix(left(1), just(Kind::Slash), move |l, _, r, _: &mut _| join(l, r, TypeKind::Quotient)),
    ));
    grammar.boxed()
}

/// Parses the exponent of a dimension: `2`, `-1`, `(1/2)`.
fn rational<'a>(source: &'a Source<'a>) -> Rule<'a, (i32, i32)> {
    let integer = custom(move |input: &mut Reader<'a, '_>| {
        let negative = source.kind(position(input)) == Some(Kind::Minus);
        if negative {
            input.next();
        }
        let at = position(input);
        let value = match source.kind(at) {
            Some(Kind::Number) => source.text(at).parse::<i32>().ok(),
            _ => None,
        };
        let Some(value) = value else {
            input.emit(
                Diagnostic::error(
                    "E0124",
                    "the exponent of a dimension must be an integer or a fraction",
                    source.place(at),
                    "an integer is expected here",
                )
                .help("write `Length^2` or `Length^(1/2)`")
                .into(),
            );
            if source.kind(at) == Some(Kind::Number) {
                input.next();
            }
            return Ok(1);
        };
        input.next();
        Ok(if negative { -value } else { value })
    })
    .boxed();
    let fraction = just(Kind::OpenParen)
        .ignore_then(integer.clone())
        .then(just(Kind::Slash).ignore_then(integer.clone()).or_not())
        .then_ignore(close(source, Kind::CloseParen, "`)`"))
        .map(|(numerator, denominator)| (numerator, denominator.unwrap_or(1)));
    fraction.or(integer.map(|whole| (whole, 1))).boxed()
}

/// Parses `var a = 1, b := 2, c`.
pub(super) fn variables<'a>(source: &'a Source<'a>, value: Rule<'a, Expr>) -> Rule<'a, StmtKind> {
    let bind = select! { Kind::Assign => Bind::Evaluate, Kind::Bind => Bind::Symbolic };
    let variable = name(source, "the variable")
        .then(bind.then(value).or_not())
        .map(|(name, init)| name.map(|name| crate::ast::VarDecl { name, init }));
    just(Kind::Var)
        .ignore_then(variable.separated_by(just(Kind::Comma)).at_least(1).collect::<Vec<_>>())
        .map(|declared| StmtKind::Var(declared.into_iter().flatten().collect()))
        .boxed()
}
