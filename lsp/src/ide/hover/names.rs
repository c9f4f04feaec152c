//! Hover text of a name: declaration, type, value and documentation.

use super::words::card;
use super::{code, expressions, gears, numbers, paragraphs};
use crate::ide::{Position, Snapshot, constant, symbol_dependencies};
use calyx_lang::analysis::{CallParameter, Declaration, Name, NameKind, SourceRange};
use calyx_lang::db::Database;
use calyx_lang::declared::{Declared, find};
use calyx_lang::dimension::Dimension;
use calyx_lang::help;
use calyx_lang::units::UnitSystem;

/// Largest number of lines of a declaration.
const MOST_LINES: usize = 16;

/// Returns the hover text of a name at a cursor.
pub(super) fn of(snapshot: &Snapshot, at: &Position, name: &Name) -> Option<String> {
    let database = &snapshot.database;
    let Some(place) = &name.declared else { return of_language(name) };
    if name.kind == NameKind::Module {
        let path = database.module_of(&place.file)?;
        return Some(paragraphs([Some(code(&format!("import {path};"))), database.module_doc(&place.file)]));
    }
    let declaration = database.declaration(place)?;
    let system = database.system(&at.file).unwrap_or_default();
    if let Some(choice) = choice(database, place) {
        return Some(choice);
    }
    if let Some(parameter) = parameter(database, place) {
        return Some(of_parameter(&parameter, &declaration, system));
    }
    let dimension = dimension(snapshot, at, name, place);
    let mut facts = type_line(name, &declaration, dimension, system);
    if matches!(name.kind, NameKind::Const | NameKind::Param)
        && let Some(known) = constant::of_declaration(database, place)
    {
        let value =
            numbers::value(known.si, known.dimension.or(dimension).unwrap_or(Dimension::NONE), system);
        // Omits a value that is in the declaration.
        if !declaration.header.contains(&format!("= {value}")) {
            facts.truncate(1);
            let ty = facts.pop().unwrap_or_default();
            facts.push(match name.kind {
                NameKind::Param => format!("{ty}, by default `{value}`"),
                _ => format!("{ty} = `{value}`"),
            });
        }
    }
    let symbols = matches!(name.kind, NameKind::Symbolic | NameKind::Output | NameKind::SymbolicFunction);
    let simplified = if symbols { expressions::of(snapshot, place) } else { None };
    let (expression, free) = match simplified {
        Some((expression, free)) => (expression, Some(free)),
        None => (None, symbols.then(|| symbol_dependencies::line(database, place)).flatten()),
    };
    let module =
        database.module_of(&place.file).filter(|_| place.file != at.file && name.kind != NameKind::Field);
    let from = module.filter(|module| module != "prelude").map(|module| format!("of the module `{module}`"));
    facts.extend(from);
    facts.extend(declaration.former.as_ref().map(|former| format!("formerly `{former}`")));
    if name.kind == NameKind::Variable
        && let Some(value) = expressions::value(snapshot, place, &name.text, dimension, system)
        && !declaration.header.ends_with(&format!("= {value}"))
    {
        let changes = database.references(place).iter().any(|(_, other)| other.writes && !other.declares);
        let ty = facts.first().cloned().unwrap_or_default();
        facts =
            vec![if changes { format!("{ty}, `{value}` in the end") } else { format!("{ty} = `{value}`") }];
    }
    let facts = (!facts.is_empty()).then(|| facts.join(" · "));
    let made = gears::of(snapshot, &at.file, name, system);
    let called = matches!(name.kind, NameKind::Function | NameKind::SymbolicFunction | NameKind::Extern);
    let head = match called {
        // Comments of parameters are shown for the parameters.
        true => code(&shortened(&without_comments(&declaration.header))),
        false => code(&shortened(&declaration.header)),
    };
    Some(paragraphs([Some(head), expression, facts, free, made, declaration.doc]))
}

/// Returns the hover text of a builtin name.
fn of_language(name: &Name) -> Option<String> {
    let head = match (name.kind, &name.ty) {
        (NameKind::Builtin, Some(scheme)) => format!("{}{scheme}", name.text),
        (_, Some(ty)) => format!("{}: {ty}", name.text),
        (_, None) => name.text.to_string(),
    };
    let help = help::builtin(&name.text).or_else(|| help::keyword(&name.text))?;
    Some(paragraphs([Some(code(&head)), Some(card(help))]))
}

/// Describes the choice of an enumeration that is declared at a position: its comment, then the
/// enumeration and its comment.
fn choice(database: &Database, place: &SourceRange) -> Option<String> {
    let tree = database.around(&place.file, place.start)?;
    let (statement, Declared::Choice(of, choice)) = find(&tree.module, place.start)? else { return None };
    let head = code(&format!("{}.{}", of.name.name, choice.name.name));
    let all: Vec<String> = of.choices.iter().map(|choice| format!("`{}`", choice.name.name)).collect();
    let of = format!("a choice of `{}`: {}", of.name.name, all.join(", "));
    Some(paragraphs([Some(head), Some(of), choice.doc.clone(), statement.doc.clone()]))
}

/// Returns the parameter or field declared at a position.
fn parameter(database: &Database, place: &SourceRange) -> Option<CallParameter> {
    let tree = database.around(&place.file, place.start)?;
    let owner = match find(&tree.module, place.start)?.1 {
        Declared::Parameter(decl, _) => decl.name.span,
        Declared::Field(decl, _) => decl.name.span,
        _ => return None,
    };
    let callable =
        database.callable(&SourceRange { file: place.file.clone(), start: owner.start, end: owner.end })?;
    callable.parameters.into_iter().find(|parameter| parameter.declared.as_ref() == Some(place))
}

/// Describes an argument: type, default and range.
fn of_parameter(parameter: &CallParameter, declaration: &Declaration, system: UnitSystem) -> String {
    let mut facts = Vec::new();
    let written = declaration.header.contains(&format!(": {}", parameter.ty));
    match parameter.ty.as_str() {
        "" | "_" => {}
        _ if written => {}
        // Lowercase letters are type variables, determined by the call.
        ty if ty.len() == 1 && ty.starts_with(char::is_lowercase) => {
            facts.push("a number of any dimension".into())
        }
        ty if ty.len() == 1 => facts.push("of any type that its use allows".into()),
        ty => facts.push(format!("`{ty}`")),
    }
    facts.extend(parameter.dimension.and_then(|dimension| numbers::shown_in(dimension, system)));
    if parameter.symbolic {
        facts.push(format!("an expression: `{} := ...`", parameter.name));
    }
    if let Some(default) = &parameter.default {
        facts.push(format!("`{default}` if it is left out"));
    }
    if let Some(range) = &parameter.range {
        facts.push(format!("from `{}`", range.replace(" .. ", "` to `")));
    }
    if !parameter.choices.is_empty() {
        let choices: Vec<String> = parameter.choices.iter().map(|choice| format!("`\"{choice}\"`")).collect();
        facts.push(format!("one of {}", choices.join(", ")));
    }
    facts.extend(parameter.former.as_ref().map(|former| format!("formerly `{former}`")));
    let facts = (!facts.is_empty()).then(|| facts.join(" · "));
    paragraphs([Some(code(&declaration.header)), facts, parameter.doc.clone()])
}

/// Returns the dimension of a numeric name.
fn dimension(snapshot: &Snapshot, at: &Position, name: &Name, place: &SourceRange) -> Option<Dimension> {
    let database = &snapshot.database;
    let here = database.expressions(&at.file, name.start..name.end);
    let used = here.iter().find(|typed| (typed.start, typed.end) == (name.start, name.end));
    let known = used.and_then(|typed| typed.dimension);
    let first = || {
        let tree = database.around(&place.file, place.start)?;
        let value = symbol_dependencies::value_at(&tree.module, place.start)?;
        let typed = database.expressions(&place.file, value.span.start..value.span.end);
        typed.iter().find(|typed| (typed.start, typed.end) == (value.span.start, value.span.end))?.dimension
    };
    let named = || name.ty.as_deref().and_then(Dimension::from_name);
    known.or_else(first).or_else(named)
}

/// Formats the type, and the unit in which the file shows it.
fn type_line(
    name: &Name,
    declaration: &Declaration,
    dimension: Option<Dimension>,
    system: UnitSystem,
) -> Vec<String> {
    let mut facts = Vec::new();
    let Some(ty) = name.ty.as_deref().or(declaration.ty.as_deref()) else { return facts };
    let shown = match name.kind {
        // Their types are in the declaration.
        NameKind::Extern
        | NameKind::Record
        | NameKind::Enum
        | NameKind::Component
        | NameKind::Dimension
        | NameKind::Unit
        | NameKind::Module => None,
        NameKind::Function | NameKind::SymbolicFunction => (!declaration.header.contains("->")).then_some(ty),
        _ => Some(ty),
    };
    facts.extend(shown.map(|ty| format!("`{ty}`")));
    if shown == Some(ty) && Dimension::from_name(ty).is_some() {
        facts.extend(dimension.and_then(|dimension| numbers::shown_in(dimension, system)));
    }
    facts
}

fn without_comments(header: &str) -> String {
    header.lines().filter(|line| !line.trim_start().starts_with("//")).collect::<Vec<_>>().join("\n")
}

/// Shortens a declaration.
fn shortened(header: &str) -> String {
    let lines: Vec<&str> = header.lines().collect();
    // Lines after the first one keep their relative indentation.
    let indent = lines.iter().skip(1).filter(|line| !line.trim().is_empty());
    let indent = indent.map(|line| line.len() - line.trim_start().len()).min().unwrap_or(0).saturating_sub(4);
    let shown = lines.iter().enumerate().take(MOST_LINES);
    let mut shown: Vec<&str> = shown
        .map(|(index, line)| if index == 0 { line } else { line.get(indent..).unwrap_or(line) })
        .collect();
    if lines.len() > MOST_LINES {
        shown.push("    ...");
    }
    shown.join("\n")
}
