//! Actions that convert a quantity to another unit: `25.4 mm` becomes `1 inch`.

use super::{Action, ActionRequest, rewrite};
use crate::ide::numbers::{LiteralWithUnit, needs_parentheses};
use calyx_lang::analysis::NameKind;
use calyx_lang::ast::ExprKind;
use calyx_lang::walk::Node;

/// Largest number of units offered for one quantity.
const MOST_UNITS: usize = 5;

/// Largest number of digits of a preferred result.
const MOST_DIGITS: usize = 12;

pub(super) fn converting(asked: &ActionRequest, found: &mut Vec<Action>) {
    let database = &asked.snapshot.database;
    let is_unit = |start| database.name_at(&asked.file, start).is_none_or(|name| name.kind == NameKind::Unit);
    let around = super::EnclosingNodes::new(&asked.tree.module, asked.range.clone());
    // The outermost product of a literal and units only; a cursor in one of several units refers to
    // all.
    let measured = around.expressions().find_map(|e| Some((e, LiteralWithUnit::new(e, &is_unit)?)));
    let Some((e, measured)) = measured.filter(|(e, _)| !matches!(e.kind, ExprKind::Number(_))) else {
        return;
    };
    let (system, _) = asked.system();
    let in_unit =
        matches!(around.parent(e), Some(Node::Statement(statement)) if is_unit_declaration(statement));
    if in_unit {
        return;
    }
    let mut offered = measured.elsewhere(system);
    // Short results come first; otherwise the order of units is kept.
    offered.sort_by_key(|(_, text, _)| text.bytes().filter(u8::is_ascii_digit).count() > MOST_DIGITS);
    for (_, text, exact) in offered.into_iter().take(MOST_UNITS) {
        let compound = text.contains(['*', '/']);
        let replacement = match compound && needs_parentheses(e, around.parent(e)) {
            true => format!("({text})"),
            false => text.clone(),
        };
        let nearly = if exact { "" } else { " (rounded)" };
        let edits = vec![asked.edit(measured.start, measured.end, replacement)];
        found.push(rewrite(format!("Convert to `{text}`{nearly}"), edits));
    }
}

/// Returns true for the definition of a unit, whose size is not converted.
fn is_unit_declaration(statement: &calyx_lang::ast::Stmt) -> bool {
    matches!(statement.kind, calyx_lang::ast::StmtKind::Unit(_))
}
