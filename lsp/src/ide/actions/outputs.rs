//! Actions that add missing outputs: a model without outputs shows no results, and an unused
//! symbolic name was probably meant as one.

use super::{Action, ActionRequest, fix, rewrite};
use calyx_lang::analysis::NameKind;
use calyx_lang::ast::{Bind, ExprKind, Stmt, StmtKind};
use calyx_lang::diagnostic::Diagnostic;

/// Observables that a body with teeth does not have.
const OF_ELASTIC_BODIES: [&str; 3] = ["radiated_power", "sound_power_level", "radiation_efficiency"];
/// Largest number of outputs offered for one model.
const MOST_OUTPUTS: usize = 6;

/// Changes an unused symbolic name to an output.
pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    if problem.code != "W0201" {
        return;
    }
    let place = problem.primary.span;
    let statement = asked.tree.module.statements.iter().find(|top| match &top.kind {
        StmtKind::Var(all) => all.len() == 1 && all.iter().any(|decl| decl.name.span == place),
        _ => false,
    });
    let Some((statement, StmtKind::Var(all))) = statement.map(|statement| (statement, &statement.kind))
    else {
        return;
    };
    let Some((Bind::Symbolic, value)) = all.first().and_then(|decl| decl.init.as_ref()) else { return };
    let name = asked.slice(place);
    let known = asked.snapshot.database.name_at(&asked.file, place.start);
    // Frames and vectors cannot be outputs.
    let other = known.and_then(|known| known.ty).is_some_and(|ty| {
        ["Vector", "Transform", "Array", "[", "Bool", "String"].iter().any(|other| ty.starts_with(other))
    });
    if other {
        return;
    }
    let edit = asked.edit(statement.span.start, value.span.start, format!("output {name} := "));
    found.push(fix(format!("Make `{name}` an output"), vec![edit]).preferred());
}

/// Offers the available observables as outputs of a model that has an analysis but no outputs.
pub(super) fn missing(asked: &ActionRequest, found: &mut Vec<Action>) {
    let statements = &asked.tree.module.statements;
    let has_output = statements.iter().any(|statement| matches!(statement.kind, StmtKind::Output { .. }));
    let here = |statement: &&Stmt| {
        statement.span.start <= asked.range.end && asked.range.start <= statement.span.end
    };
    let Some(analysis) = statements.iter().filter(here).find(|statement| is_analysis(statement)) else {
        return;
    };
    if has_output {
        return;
    }
    let database = &asked.snapshot.database;
    let visible = database.visible(&asked.file, analysis.span.start);
    let (line, _) = asked.line(analysis.span.start);
    let mut offered = 0;
    let modules = visible.iter().filter(|known| known.kind == NameKind::Module);
    for module in modules {
        let Some(path) = module.declared.as_ref().and_then(|place| database.module_of(&place.file)) else {
            continue;
        };
        for member in database.members(&path) {
            let callable = member.declared.as_ref().and_then(|place| database.callable(place));
            let Some(callable) = callable else { continue };
            let observes = callable.result.as_deref().is_some_and(|result| result.starts_with("Observable"));
            let needed: Vec<_> = callable.parameters.iter().filter(|p| p.default.is_none()).collect();
            let [only] = needed.as_slice() else { continue };
            let is_special = OF_ELASTIC_BODIES.contains(&&*member.name);
            if !observes || is_special || offered == MOST_OUTPUTS {
                continue;
            }
            let holder = visible.iter().find(|known| {
                known.kind == NameKind::Variable && known.ty.as_deref() == Some(only.ty.as_str())
            });
            let Some(holder) = holder else { continue };
            let taken = visible.iter().any(|known| known.name == member.name && known.level.is_some());
            let name =
                if taken { format!("{}_of_{}", member.name, holder.name) } else { member.name.to_string() };
            let call = format!("{}.{}({})", module.name, member.name, holder.name);
            let text = format!("output {name} := {call};\n");
            found.push(rewrite(format!("Add an output: `{call}`"), vec![asked.edit(line, line, text)]));
            offered += 1;
        }
    }
}

fn is_analysis(statement: &Stmt) -> bool {
    let StmtKind::Expr(e) = &statement.kind else { return false };
    let ExprKind::Call { callee, .. } = &e.kind else { return false };
    matches!(&callee.kind, ExprKind::Name(name) if name.name == "analyze")
}
