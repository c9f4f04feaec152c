//! The same quantity in another unit: `25.4 mm` becomes `1 inch`.

use super::{Action, ActionRequest, rewrite};
use crate::ide::numbers::{LiteralWithUnit, needs_parentheses};
use crate::ide::walk::Node;
use calyx_lang::analysis::NameKind;
use calyx_lang::ast::ExprKind;

/// Units offered for one quantity.
const MOST_UNITS: usize = 5;

/// Digits of a number that comes out even.
const MOST_DIGITS: usize = 12;

pub(super) fn converting(asked: &ActionRequest, found: &mut Vec<Action>) {
    let database = &asked.snapshot.database;
    let is_unit = |start| database.name_at(&asked.file, start).is_none_or(|name| name.kind == NameKind::Unit);
    let around = super::EnclosingNodes::new(&asked.tree.module, asked.range.clone());
    // The outermost product that is nothing but a literal and its units; a cursor in one unit of several means all.
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
    // What comes out even is likelier to be wanted; the order of units stays otherwise.
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

/// The size of a unit is its definition; it says what it says.
fn is_unit_declaration(statement: &calyx_lang::ast::Stmt) -> bool {
    matches!(statement.kind, calyx_lang::ast::StmtKind::Unit(_))
}
