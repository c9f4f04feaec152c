//! Hover text from the elaboration of a name: the simplified expression of a `:=` name, and the
//! final value of a variable.

use super::code;
use crate::ide::Snapshot;
use crate::ide::symbol_dependencies::value_at;
use calyx_elaborate::SymbolKind;
use calyx_elaborate::binding::{Binding, binding, definition_in};
use calyx_lang::analysis::SourceRange;
use calyx_lang::dimension::Dimension;
use calyx_lang::units::UnitSystem;

/// Longest displayed expression; longer ones are available from `calyx dump`.
const LONGEST: usize = 400;

/// Returns the simplified expression of the declaration at a position, and its free symbols; `None`
/// if the model was not elaborated with it.
pub(super) fn of(snapshot: &Snapshot, place: &SourceRange) -> Option<(Option<String>, String)> {
    let database = &snapshot.database;
    let tree = database.around(&place.file, place.start)?;
    let span = value_at(&tree.module, place.start)?.span;
    let written = database.text(&place.file)?.get(span.start as usize..span.end as usize)?;
    snapshot.elaborated.values().find_map(|elaborated| {
        let (file, start) = elaborated.before(database, &place.file, span.start)?;
        let (_, end) = elaborated.before(database, &place.file, span.end)?;
        let program = elaborated.program()?;
        let found = binding(program, definition_in(program, file.0, start, end)?)?;
        Some((expression(&found, written), symbols(&found)))
    })
}

/// Returns the expression if it differs from the written one.
fn expression(found: &Binding, written: &str) -> Option<String> {
    let infix = found.expression.as_ref()?;
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    if infix.parts.is_empty() && squeezed(&infix.value) == squeezed(written) {
        return None;
    }
    let mut lines = vec![format!("= {}", infix.value)];
    for (index, (name, part)) in infix.parts.iter().enumerate() {
        let word = if index == 0 { "where" } else { "     " };
        lines.push(format!("  {word} {name} = {part}"));
    }
    if infix.bare {
        lines.push("// numbers without unit are in SI".into());
    }
    let text = lines.join("\n");
    (text.len() <= LONGEST).then(|| code(&text))
}

fn symbols(found: &Binding) -> String {
    let named = |kinds: &[SymbolKind]| -> String {
        let names = found.symbols.iter().filter(|symbol| kinds.contains(&symbol.kind));
        names.map(|symbol| format!("`{}`", symbol.name)).collect::<Vec<_>>().join(", ")
    };
    let free = named(&[SymbolKind::Time, SymbolKind::Param, SymbolKind::Argument]);
    let observed = named(&[SymbolKind::Observable]);
    let mut facts = Vec::new();
    match (free.is_empty(), observed.is_empty()) {
        (true, true) => facts.push("depends on no symbol".to_string()),
        // Observables vary with the position, which is stated instead.
        (true, false) => {}
        (false, _) => facts.push(format!("depends on {free}")),
    }
    if !observed.is_empty() {
        facts.push(format!("observes {observed}"));
    }
    let captured = named(&[SymbolKind::Captured]);
    if !captured.is_empty() {
        facts.push(format!("with the value that {captured} had"));
    }
    facts.join(" · ")
}

/// Returns the final value of a variable at a model's top level, with the params' defaults; `None`
/// if the text has changed since.
pub(super) fn value(
    snapshot: &Snapshot,
    place: &SourceRange,
    name: &str,
    dimension: Option<Dimension>,
    system: UnitSystem,
) -> Option<String> {
    let elaborated = snapshot.elaborated.get(&place.file)?;
    let value = elaborated.elaboration.values.get(name)?;
    let tree = snapshot.database.around(&place.file, place.start)?;
    let top = tree.module.statements.iter().any(|statement| match &statement.kind {
        calyx_lang::ast::StmtKind::Var(all) => all.iter().any(|decl| decl.name.span.start == place.start),
        _ => false,
    });
    let shown = || value.shown(dimension.unwrap_or(Dimension::NONE), system.name());
    (top && elaborated.is_current(&snapshot.database)).then(shown).flatten()
}
