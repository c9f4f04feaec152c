//! Actions that replace the unit of a format by a suitable one.

use super::{Action, ActionRequest, fix};
use calyx_lang::ast::{Expr, ExprKind, Format, StringPart};
use calyx_lang::common_units::usual;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::walk::Node;

/// Largest number of units offered for one format.
const MOST_UNITS: usize = 4;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    if problem.code != "E0401" && problem.code != "E0408" {
        return;
    }
    let place = problem.primary.span;
    let around = asked.around(place);
    let parts = around.nodes.iter().rev().find_map(|node| match node {
        Node::Expression(Expr { kind: ExprKind::String(parts), .. }) => Some(parts),
        _ => None,
    });
    let shown = parts.into_iter().flatten().find_map(|part| match part {
        StringPart::Value(value, Some(format)) if value.span == place => Some((value, format)),
        _ => None,
    });
    let Some((value, Format { unit: Some(unit), .. })) = shown else { return };
    let typed = asked.snapshot.database.expressions(&asked.file, place.start..place.end);
    let whole = typed.iter().find(|typed| (typed.start, typed.end) == (value.span.start, value.span.end));
    if let Some(dimension) = whole.and_then(|typed| typed.dimension) {
        for fitting in usual(dimension, asked.system().0).into_iter().take(MOST_UNITS) {
            let edit = asked.edit(unit.span.start, unit.span.end, &*fitting.name);
            found.push(fix(format!("Show it in `{}`", fitting.name), vec![edit]));
        }
    }
    let before = asked.text.get(..unit.span.start as usize).unwrap_or_default();
    let kept = before.trim_end_matches([' ', '\t']);
    // Without digits the format is empty.
    let kept = kept.strip_suffix(':').unwrap_or(kept).trim_end_matches([' ', '\t']).len() as u32;
    found.push(fix("Leave the unit out", vec![asked.edit(kept, unit.span.end, "")]));
}
