//! Fixes and suggestions of compiler diagnostics.

use super::{Action, ActionKind, ActionRequest, fix};
use crate::ide::{Edit, Snapshot, problems};
use calyx_lang::diagnostic::{Diagnostic, Fix};
use std::sync::Arc;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    let edit = |fix: &Fix| asked.edit(fix.span.start, fix.span.end, &*fix.replacement);
    if let Some(certain) = &problem.fix {
        found.push(fix(capitalised(&certain.title), vec![edit(certain)]).preferred());
        let alike: Vec<&Fix> = asked
            .problems
            .iter()
            .filter(|other| other.code == problem.code)
            .filter_map(|other| other.fix.as_ref())
            .collect();
        if alike.len() > 1 {
            let title = format!("Fix all {} of this kind ({})", alike.len(), problem.code);
            found.push(fix(title, compatible(&asked.file, asked.text, alike)));
        }
    }
    // A single suggestion needs no separate name in the menu.
    let only = problem.fix.is_none() && problem.suggestions.len() == 1;
    for offer in &problem.suggestions {
        let action = fix(capitalised(&offer.title), vec![edit(offer)]);
        found.push(if only { action.preferred() } else { action });
    }
}

/// Returns all certain fixes of a file as one action; `None` if there are none.
pub fn fix_all(snapshot: &Snapshot, file: &str) -> Option<Action> {
    let text = snapshot.database.text(file)?;
    if file.starts_with('<') {
        return None;
    }
    let problems = problems::of_file(snapshot, file);
    let fixes = problems.iter().filter_map(|problem| problem.fix.as_ref()).collect();
    let edits = compatible(&file.into(), text, fixes);
    let action = Action { kind: ActionKind::FixAll, ..fix("Fix everything that is certain", edits) };
    (!action.edits.is_empty()).then_some(action)
}

/// Returns the edits that can be applied together, in order. Of two overlapping ones, the first is
/// applied.
fn compatible(file: &Arc<str>, text: &str, mut fixes: Vec<&Fix>) -> Vec<Edit> {
    fixes.sort_by_key(|fix| (fix.span.start, fix.span.end));
    let mut edits: Vec<Edit> = Vec::new();
    for fix in fixes {
        let (start, end) = (fix.span.start, fix.span.end);
        let free = edits.last().is_none_or(|last| start > last.end || (start == last.end && start < end));
        let changes =
            text.get(start as usize..end as usize).is_some_and(|written| written != fix.replacement);
        if free && changes {
            edits.push(Edit { file: file.clone(), start, end, replacement: fix.replacement.clone() });
        }
    }
    edits
}

/// Capitalizes a title for menus.
fn capitalised(title: &str) -> String {
    let mut characters = title.chars();
    let first = characters.next().map(|c| c.to_uppercase().collect::<String>()).unwrap_or_default();
    first + characters.as_str()
}
