//! Hover text of numbers and units: conversions, and definitions of units.

use super::{Hover, paragraphs};
use crate::ide::enclosing::EnclosingNodes;
use crate::ide::numbers::{LiteralWithUnit, in_unit};
use crate::ide::{Position, Snapshot};
use calyx_abi::text::number;
use calyx_lang::analysis::{Name, NameKind};
use calyx_lang::ast::ExprKind;
use calyx_lang::common_units::{usual, written};
use calyx_lang::dimension::Dimension;
use calyx_lang::ir::DisplayUnit;
use calyx_lang::lexer::Kind;
use calyx_lang::units::{Unit, UnitSystem};

/// Largest number of other units for one quantity.
const MOST_UNITS: usize = 5;

/// Largest number of digits shown.
const MOST_DIGITS: usize = 9;

/// Returns the hover text of the literal at a cursor.
pub(super) fn at(snapshot: &Snapshot, at: &Position) -> Option<Hover> {
    let database = &snapshot.database;
    let tokens = database.tokens(&at.file)?;
    let first = tokens.tokens.partition_point(|token| token.span.end < at.offset);
    let near = tokens.tokens.iter().skip(first).take(2);
    let token = near.into_iter().find(|token| {
        let quantity = matches!(token.kind, Kind::Number | Kind::Percent);
        quantity && token.span.start <= at.offset && at.offset <= token.span.end
    })?;
    let (measured, system) = measured(snapshot, at, token.span.start)?;
    let range = measured.start..measured.end;
    if !measured.unit.name.is_empty() {
        return Some(Hover { range, markdown: in_other_units(&measured, system)? });
    }
    // A literal without a unit may have one from its context.
    let typed = database.expressions(&at.file, range.clone());
    let here = typed.iter().find(|typed| (typed.start, typed.end) == (range.start, range.end))?;
    let dimension = here.dimension.filter(|dimension| here.bare && !dimension.is_none())?;
    let unit = system.unit_of(dimension);
    let bare = LiteralWithUnit { unit: unit.clone(), ..measured };
    let by_use = format!("`{}` by its use, in `{}`", here.ty, unit.name);
    Some(Hover { range, markdown: paragraphs([Some(by_use), equal(&bare, system)]) })
}

/// Describes the unit of a name, with the quantity it belongs to.
pub(super) fn of_unit(snapshot: &Snapshot, at: &Position, name: &Name) -> Option<String> {
    if name.kind != NameKind::Unit || name.declared.is_some() {
        return None;
    }
    let unit = Unit::find(&name.text)?;
    let system = system_of(snapshot, &at.file)?;
    let quantity = measured(snapshot, at, name.start).filter(|(measured, _)| measured.value.is_finite());
    let other = quantity.and_then(|(measured, system)| {
        let whole = written(&number(measured.value), &measured.unit.name);
        Some(format!("`{whole}` {}", equal(&measured, system)?))
    });
    Some(paragraphs([Some(meaning(&name.text, unit, system)), other]))
}

/// Formats the definition of a unit: `lbf`: Force, 4.4482216152605 N.
fn meaning(name: &str, unit: &Unit, system: UnitSystem) -> String {
    let dimension = unit.dimension.known_name().unwrap_or("Number");
    let si = UnitSystem::Si.unit_of(unit.dimension);
    let of_system = system.unit_of(unit.dimension);
    let mut equals = Vec::new();
    for coherent in [si, of_system] {
        let (text, _) = in_unit(unit.factor, coherent.factor);
        let text = written(&text, &coherent.name);
        if coherent.name != name && !equals.contains(&text) {
            equals.push(text);
        }
    }
    let full = unit.aliases.iter().chain([&unit.name]).filter(|alias| **alias != name);
    let also = full.map(|alias| format!("`{alias}`")).collect::<Vec<_>>().join(", ");
    let mut text = format!("Unit of `{dimension}`");
    if !equals.is_empty() {
        text += &format!(": 1 {name} = {}", equals.join(" = "));
    }
    if !also.is_empty() {
        text += &format!(". Also written {also}");
    }
    text
}

fn system_of(snapshot: &Snapshot, file: &str) -> Option<UnitSystem> {
    Some(snapshot.database.system(file).unwrap_or_default())
}

/// Returns the largest product of a literal and units around a position.
fn measured(snapshot: &Snapshot, at: &Position, start: u32) -> Option<(LiteralWithUnit, UnitSystem)> {
    let database = &snapshot.database;
    let tree = database.around(&at.file, start)?;
    let is_unit = |start| database.name_at(&at.file, start).is_none_or(|name| name.kind == NameKind::Unit);
    let around = EnclosingNodes::new(&tree.module, start..start);
    let found = around
        .expressions()
        .filter(|e| !matches!(e.kind, ExprKind::Name(_)))
        .find_map(|e| LiteralWithUnit::new(e, &is_unit));
    // Between two literals, the later one is found in the tree.
    Some((
        found.filter(|found| found.start <= start && start <= found.end)?,
        database.system(&at.file).unwrap_or_default(),
    ))
}

fn in_other_units(measured: &LiteralWithUnit, system: UnitSystem) -> Option<String> {
    let dimension = measured.dimension()?;
    let name = dimension.known_name().map(|name| format!("`{name}`"));
    Some(paragraphs([name, equal(measured, system)]))
}

/// Formats a line with the same quantity in other units.
fn equal(measured: &LiteralWithUnit, system: UnitSystem) -> Option<String> {
    let dimension = measured.dimension().filter(|_| measured.value.is_finite())?;
    let others = usual(dimension, system).into_iter().filter(|unit| unit.name != measured.unit.name);
    let shown: Vec<String> = others
        .take(MOST_UNITS)
        .map(|unit| {
            let (text, exact) = rounded(measured.si(), &unit);
            format!("{} `{text}`", if exact { "=" } else { "≈" })
        })
        .collect();
    (!shown.is_empty()).then(|| shown.join(" "))
}

/// Formats a quantity in a unit, rounded for display, and returns whether it is exact.
fn rounded(si: f64, unit: &DisplayUnit) -> (String, bool) {
    let (exact, _) = in_unit(si, unit.factor);
    let digits = exact.bytes().filter(u8::is_ascii_digit).count();
    let (text, whole) = match exact.parse::<f64>() {
        Ok(value) if digits > MOST_DIGITS => (number(format!("{value:.6e}").parse().unwrap_or(value)), false),
        _ => (exact, true),
    };
    (written(&text, &unit.name), whole)
}

/// Formats the name of a dimension, with its display unit.
pub(super) fn shown_in(dimension: Dimension, system: UnitSystem) -> Option<String> {
    let unit = system.unit_of(dimension).name;
    (!unit.is_empty()).then(|| format!("in `{unit}`"))
}

/// Formats a number known from the text, in the unit of the file.
pub(super) fn value(si: f64, dimension: Dimension, system: UnitSystem) -> String {
    rounded(si, &system.unit_of(dimension)).0
}
