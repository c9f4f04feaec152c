//! Parses declarations of constants, records, enumerations, dimensions and units.

use super::declarations::{inside_another, type_expression};
use super::expressions::Expressions;
use super::recovery::{
    Reader, advance_to, close, expect, name, never_renamed, position, renamed, semicolon, when,
};
use super::source::Source;
use super::{Problem, Rule};
use crate::ast::{EnumChoice, EnumDecl, RecordDecl, RecordField, StmtKind, UnitDecl, UnitMeaning};
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;
use chumsky::prelude::*;

/// Parses `const`, `record`, `enum`, `dimension` and `unit`.
pub(super) fn definition<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, StmtKind> {
    let end = semicolon(source);
    let constant = just(Kind::Const)
        .ignore_then(name(source, "the constant"))
        .then_ignore(expect(source, Kind::Assign, "before the value of a constant"))
        .then(e.full.clone())
        .then_ignore(end.clone())
        .map(|(name, value)| name.map_or(StmtKind::Error, |name| StmtKind::Const { name, value }));
    let dimension = just(Kind::Dimension)
        .ignore_then(name(source, "the dimension"))
        .then(just(Kind::Assign).ignore_then(type_expression(source)).or_not())
        .then_ignore(end.clone())
        .map(|(name, value)| name.map_or(StmtKind::Error, |name| StmtKind::Dimension { name, value }));
    let meaning = choice((
        just(Kind::Colon).ignore_then(type_expression(source)).map(UnitMeaning::Coherent),
        expect(source, Kind::Assign, "or `:` and a dimension after the name of a unit")
            .ignore_then(e.full.clone())
            .map(UnitMeaning::Equal),
    ));
    let unit = just(Kind::Unit).ignore_then(name(source, "the unit")).then(meaning).then_ignore(end).map(
        |(name, meaning)| name.map_or(StmtKind::Error, |name| StmtKind::Unit(UnitDecl { name, meaning })),
    );
    let outside =
        outside_blocks(source).ignore_then(choice((record(source, e), enumeration(source), dimension, unit)));
    constant.or(outside).boxed()
}

/// Reports the next token if it starts a record, enumeration, dimension or unit inside a block,
/// function or other statement.
fn outside_blocks<'a>(source: &'a Source<'a>) -> Rule<'a, ()> {
    custom(move |input: &mut Reader<'a, '_>| {
        let at = position(input);
        if !matches!(source.kind(at), Some(Kind::Record | Kind::Enum | Kind::Dimension | Kind::Unit)) {
            return Err(Problem(None));
        }
        if source.previous(at) != Some(Kind::Private)
            && let Some(problem) = inside_another(source, at)
        {
            input.emit(problem.into());
        }
        Ok(())
    })
    .boxed()
}

/// Parses `record Name { width = 1 inch; teeth: Number; }`.
fn record<'a>(source: &'a Source<'a>, e: &Expressions<'a>) -> Rule<'a, StmtKind> {
    let typed = just(Kind::Colon).ignore_then(type_expression(source));
    let default = just(Kind::Assign).ignore_then(e.full.clone());
    let field = when(move |at| source.kind(at) == Some(Kind::Identifier))
        .ignore_then(renamed(source, "the field"))
        .then(typed.or_not())
        .then(default.or_not())
        .then_ignore(semicolon(source))
        .map_with(|(((name, former), annotation), default), extra| {
            let name = name?;
            if annotation.is_none() && default.is_none() {
                let problem = Diagnostic::error(
                    "E0115",
                    format!("the field `{}` has neither a type nor a default", name.name),
                    name.span,
                    "missing type or default",
                )
                .help(format!("write `{0}: Length;` or `{0} = 1 mm;`", name.name));
                extra.emit(problem.into());
            }
            let doc = source.doc(extra.span().start);
            Some(RecordField { name, former, annotation, default, doc })
        });
    just(Kind::Record)
        .ignore_then(renamed(source, "the record"))
        .then_ignore(expect(source, Kind::OpenBrace, "before the fields of a record"))
        .then(field.repeated().collect::<Vec<_>>())
        .then_ignore(close(source, Kind::CloseBrace, "a field or `}`"))
        .map(|((name, former), fields)| match name {
            Some(name) => {
                let fields = fields.into_iter().flatten().collect();
                StmtKind::Record(RecordDecl { name, former, fields })
            }
            None => StmtKind::Error,
        })
        .boxed()
}

/// Parses `enum Hand { left, right }`.
fn enumeration<'a>(source: &'a Source<'a>) -> Rule<'a, StmtKind> {
    let choice = when(move |at| source.kind(at) == Some(Kind::Identifier))
        .ignore_then(name(source, "the choice"))
        .map_with(|name, extra| {
            let doc = source.doc(extra.span().start);
            name.map(|name| EnumChoice { name, doc })
        });
    let choices = expect(source, Kind::OpenBrace, "before the choices of an enumeration")
        .ignore_then(choice.separated_by(just(Kind::Comma)).allow_trailing().collect::<Vec<_>>())
        .then_ignore(close(source, Kind::CloseBrace, "`,` or `}`"));
    just(Kind::Enum)
        .ignore_then(never_renamed(source, "the enumeration", "enumerations"))
        .then(foreign_choices(source).or(choices.boxed()))
        .map(|(name, choices)| match name {
            Some(name) => {
                let choices = choices.into_iter().flatten().collect();
                StmtKind::Enum(EnumDecl { name, choices })
            }
            None => StmtKind::Error,
        })
        .boxed()
}

/// Parses choices written as in other languages, `{ "left", "right" }` or `= [left, right];`, and
/// reports them.
fn foreign_choices<'a>(source: &'a Source<'a>) -> Rule<'a, Vec<Option<EnumChoice>>> {
    custom(move |input: &mut Reader<'a, '_>| {
        let start = position(input);
        let mut at = start;
        let opens = |kind| {
            matches!(kind, Kind::Assign | Kind::Colon | Kind::OpenBrace | Kind::OpenBracket | Kind::OpenParen)
        };
        while source.kind(at).is_some_and(opens) {
            at += 1;
        }
        let mut is_foreign = source.kind(start) != Some(Kind::OpenBrace);
        let mut words = Vec::new();
        while let Some(kind) = source.kind(at) {
            match kind {
                Kind::Identifier => words.push(at),
                Kind::StringText => {
                    is_foreign = true;
                    words.push(at);
                }
                Kind::StringOpen | Kind::StringClose | Kind::Comma | Kind::Or => {}
                _ => break,
            }
            at += 1;
        }
        let closes =
            |at| matches!(source.kind(at), Some(Kind::CloseBrace | Kind::CloseBracket | Kind::CloseParen));
        if !is_foreign
            || at == start
            || words.is_empty()
            || !(closes(at) || source.kind(at) == Some(Kind::Semicolon))
        {
            return Err(Problem(None));
        }
        while closes(at) {
            at += 1;
        }
        if source.kind(start) != Some(Kind::OpenBrace) && source.kind(at) == Some(Kind::Semicolon) {
            at += 1;
        }
        let names: Vec<&str> = words.iter().map(|word| source.text(*word)).collect();
        let place = source.place(start).to(source.place(at - 1));
        let problem = Diagnostic::error(
            "E0924",
            "the choices of an enumeration are names in braces",
            place,
            "written in another form",
        );
        let is_name = |name: &&str| name.chars().all(|c| c.is_alphanumeric() || c == '_');
        let braces = format!("{{ {} }}", names.join(", "));
        let problem = match names.iter().all(is_name) {
            true => problem.help(format!("write `{braces}`")).fix(format!("write `{braces}`"), place, braces),
            false => problem.help("write each choice as one word: `{ left_hand, right_hand }`"),
        };
        input.emit(problem.into());
        advance_to(input, at);
        let choice = |word: usize| Some(EnumChoice { name: source.ident(word), doc: None });
        Ok(words.into_iter().map(choice).collect())
    })
    .boxed()
}
