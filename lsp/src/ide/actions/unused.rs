//! Actions that remove unused declarations.

use super::{Action, ActionRequest, fix};
use crate::ide::Edit;
use crate::ide::enclosing::only_computes;
use calyx_lang::analysis::{NameKind, SourceRange};
use calyx_lang::ast::{Bind, Expr, ExprKind, Stmt, StmtKind};
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::lexer::{CommentKind, Kind};
use calyx_lang::span::Span;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    match problem.code.as_str() {
        "W0201" => variable(asked, problem.primary.span, found),
        "W0203" => {
            let around = asked.around(problem.primary.span);
            if let Some(statement) = around.whole_statement().filter(|s| matches!(s.kind, StmtKind::Expr(_)))
            {
                let start = statement.span.start;
                let numbered = (2..100).map(|number| format!("value_{number}"));
                let mut names = ["value".to_string()].into_iter().chain(numbered);
                if let Some(name) = names.find(|name| !is_written(asked, name)) {
                    let head = asked.edit(start, start, format!("var {name} = "));
                    found.push(fix("Assign it to a variable", vec![head]));
                }
                found.push(fix("Remove this statement", vec![removal(asked, statement)]));
            }
        }
        "E0224" => {
            let around = asked.around(problem.primary.span);
            if let Some(statement) = around.whole_statement() {
                found.push(fix("Remove this `units`", vec![removal(asked, statement)]));
            }
        }
        _ => {}
    }
}

fn variable(asked: &ActionRequest, place: Span, found: &mut Vec<Action>) {
    let name = asked.slice(place);
    let declared = SourceRange { file: asked.file.clone(), start: place.start, end: place.end };
    let references = asked.snapshot.database.references(&declared);
    if let Some(edits) = removed(asked, place, references.iter().map(|(_, name)| name.start)) {
        found.push(fix(format!("Remove `{name}`"), edits));
    } else if let Some(edit) = without_name(asked, place).filter(|_| references.len() == 1) {
        found.push(fix(format!("Remove `{name}` and keep the call"), vec![edit]));
    }
    let hidden = format!("_{name}");
    if !is_written(asked, &hidden) {
        let edits = references.iter().map(|(_, name)| asked.edit(name.start, name.end, &*hidden)).collect();
        found.push(fix(format!("Keep it as `{hidden}`"), edits));
    }
}

/// Returns true if an identifier occurs anywhere in the file.
pub(super) fn is_written(asked: &ActionRequest, name: &str) -> bool {
    asked.snapshot.database.tokens(&asked.file).is_some_and(|tokens| {
        tokens.tokens.iter().any(|token| token.kind == Kind::Identifier && asked.slice(token.span) == name)
    })
}

/// Removes a variable's declaration and all assignments to it, if their values have no side
/// effects.
fn removed(asked: &ActionRequest, place: Span, references: impl Iterator<Item = u32>) -> Option<Vec<Edit>> {
    let mut edits = Vec::new();
    for start in references {
        if start == place.start {
            edits.push(without_declaration(asked, place, true)?);
            continue;
        }
        let around = super::EnclosingNodes::new(&asked.tree.module, start..start);
        let statement = around.whole_statement()?;
        let StmtKind::Assign { place: Expr { kind: ExprKind::Name(name), .. }, value, .. } = &statement.kind
        else {
            return None;
        };
        if name.span.start != start || !computes(asked, value) {
            return None;
        }
        edits.push(removal(asked, statement));
    }
    edits.sort_by_key(|edit| edit.start);
    let apart = edits.windows(2).all(|pair| pair[0].end <= pair[1].start);
    apart.then_some(edits)
}

/// Returns true if an expression has no side effects.
pub(super) fn computes(asked: &ActionRequest, e: &Expr) -> bool {
    only_computes(e, &|callee| match &callee.kind {
        ExprKind::Name(name) => {
            let known = asked.snapshot.database.name_at(&asked.file, name.span.start);
            known.is_some_and(|known| {
                known.kind == NameKind::Builtin && !matches!(&*known.text, "print" | "assert" | "push")
            })
        }
        _ => false,
    })
}

/// Returns the edit that removes a variable from its `var`; with `pure`, only if its initial value
/// has no side effects.
pub(super) fn without_declaration(asked: &ActionRequest, place: Span, pure: bool) -> Option<Edit> {
    let around = asked.around(place);
    let statement = around.whole_statement()?;
    let StmtKind::Var(all) = &statement.kind else { return None };
    let at = all.iter().position(|decl| decl.name.span == place)?;
    let end = |at: usize| {
        let decl = all.get(at)?;
        Some(decl.init.as_ref().map_or(decl.name.span.end, |(_, value)| value.span.end))
    };
    if pure && !all.get(at)?.init.as_ref().is_none_or(|(_, value)| computes(asked, value)) {
        return None;
    }
    match (all.len(), at.checked_sub(1)) {
        (1, _) => Some(removal(asked, statement)),
        (_, Some(before)) => Some(asked.edit(end(before)?, end(at)?, "")),
        (_, None) => Some(asked.edit(place.start, all.get(1)?.name.span.start, "")),
    }
}

/// Changes `var x = f();` to `f();`.
fn without_name(asked: &ActionRequest, place: Span) -> Option<Edit> {
    let around = asked.around(place);
    let statement = around.whole_statement()?;
    let StmtKind::Var(all) = &statement.kind else { return None };
    let [decl] = all.as_slice() else { return None };
    let Some((Bind::Evaluate, value)) = &decl.init else { return None };
    let call = matches!(value.kind, ExprKind::Call { .. }) && decl.name.span == place;
    call.then(|| asked.edit(statement.span.start, value.span.start, ""))
}

/// Returns the edit that removes a statement with its documentation, and its lines if they are
/// otherwise empty.
pub(super) fn removal(asked: &ActionRequest, statement: &Stmt) -> Edit {
    let mut start = statement.span.start;
    if let Some(tokens) = asked.snapshot.database.tokens(&asked.file) {
        for comment in tokens.comments.iter().rev().filter(|comment| comment.span.end <= statement.span.start)
        {
            let between = asked.text.get(comment.span.end as usize..start as usize).unwrap_or_default();
            if comment.kind != CommentKind::Doc || !between.trim().is_empty() {
                break;
            }
            start = comment.span.start;
        }
    }
    let end = statement.span.end;
    let (line, _) = asked.line(start);
    let rest = asked.text.get(end as usize..).unwrap_or_default();
    let blank = rest.len() - rest.trim_start_matches([' ', '\t']).len();
    let alone = asked.text.get(line as usize..start as usize).is_some_and(|before| before.trim().is_empty());
    let after = rest.get(blank..).unwrap_or_default();
    match alone {
        true if after.starts_with('\n') => asked.edit(line, end + blank as u32 + 1, ""),
        true if after.starts_with("\r\n") => asked.edit(line, end + blank as u32 + 2, ""),
        true if after.is_empty() => asked.edit(line, end + blank as u32, ""),
        _ => asked.edit(start, end + blank as u32, ""),
    }
}
