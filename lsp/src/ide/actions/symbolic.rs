//! Actions that replace `=` by `:=`, if a symbolic dependence is lost, or the reverse, if a value
//! is required.

use super::{Action, ActionRequest, fix};
use crate::ide::enclosing::{GivenValue, Receiver};
use calyx_lang::ast::{Bind, StmtKind};
use calyx_lang::diagnostic::Diagnostic;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    let around = asked.around(problem.primary.span);
    let Some(given) = around.given() else { return };
    match problem.code.as_str() {
        "E0501" | "E0502" => {
            found.extend(keep(asked, &given, "Bind").map(Action::preferred));
            let end = given.value.span.end;
            found.push(fix("Take its value `at Time = 0 s`", vec![asked.edit(end, end, " at Time = 0 s")]));
        }
        "E0505" => {
            found.extend(keep(asked, &given, "Bind").map(Action::preferred));
            found.extend(as_output(asked, &given));
        }
        "E0507" if given.bind == Bind::Symbolic => {
            let between = asked.edit(given.name.end, given.value.span.start, " = ");
            found.push(fix("Use `=`: evaluate this immediately", vec![between]).preferred());
        }
        // The value was captured earlier: the earlier declaration must keep the expression.
        "E0509" if problem.primary.message.contains("was computed from") => {
            let captured = problem
                .labels
                .iter()
                .find_map(|label| asked.snapshot.database.name_at(&asked.file, label.span.start)?.declared);
            let Some(place) = captured.filter(|place| place.file == asked.file) else { return };
            let around = super::EnclosingNodes::new(&asked.tree.module, place.start..place.end);
            found.extend(around.given().and_then(|given| keep(asked, &given, "Bind")).map(Action::preferred));
        }
        _ => {}
    }
}

/// Replaces `=` by `:=`.
fn keep(asked: &ActionRequest, given: &GivenValue, verb: &str) -> Option<Action> {
    let Receiver::Variable(_, decl) = given.to else { return None };
    if given.bind != Bind::Evaluate {
        return None;
    }
    let between = asked.edit(given.name.end, given.value.span.start, " := ");
    Some(fix(format!("{verb} `{}` with `:=`, which keeps the expression", decl.name.name), vec![between]))
}

/// Changes `var x = observable;` to an output.
fn as_output(asked: &ActionRequest, given: &GivenValue) -> Option<Action> {
    let Receiver::Variable(statement, decl) = given.to else { return None };
    let StmtKind::Var(all) = &statement.kind else { return None };
    let top = asked.tree.module.statements.iter().any(|top| top.span == statement.span);
    if !top || all.len() != 1 {
        return None;
    }
    let head = format!("output {} := ", decl.name.name);
    let edit = asked.edit(statement.span.start, given.value.span.start, head);
    Some(fix(format!("Make `{}` an output", decl.name.name), vec![edit]))
}
