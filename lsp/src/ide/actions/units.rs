//! Action that writes the unit which a bare literal has from its context.

use super::{Action, ActionRequest, rewrite};
use crate::ide::numbers::needs_parentheses;
use calyx_lang::analysis::Typed;
use calyx_lang::ast::ExprKind;
use calyx_lang::common_units::written;

pub(super) fn writing(asked: &ActionRequest, found: &mut Vec<Action>) {
    let database = &asked.snapshot.database;
    let around = super::EnclosingNodes::new(&asked.tree.module, asked.range.clone());
    let Some(e) = around.expression().filter(|e| matches!(e.kind, ExprKind::Number(_))) else { return };
    let here = database.expressions(&asked.file, e.span.start..e.span.end);
    let bare = |typed: &&Typed| typed.bare && (typed.start, typed.end) == (e.span.start, e.span.end);
    let Some(dimension) = here.iter().find(bare).and_then(|typed| typed.dimension) else { return };
    let (system, _) = asked.system();
    let unit = system.unit_of(dimension).name;
    if unit.is_empty() {
        return;
    }
    let text = written(asked.slice(e.span), &unit);
    let compound = text.contains(['*', '/']) && needs_parentheses(e, around.parent(e));
    let replacement = if compound { format!("({text})") } else { text.clone() };
    let edits = vec![asked.edit(e.span.start, e.span.end, replacement)];
    found.push(rewrite(format!("Write the unit: `{text}`"), edits));
}
