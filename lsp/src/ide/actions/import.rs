//! Actions that import the module of an unknown name.

use super::{Action, ActionRequest, fix};
use crate::ide::Edit;
use calyx_lang::analysis::NameKind;
use calyx_lang::ast::StmtKind;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::lexer::CommentKind;

/// Largest number of modules offered for one name.
const MOST_MODULES: usize = 4;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    let name = asked.slice(problem.primary.span);
    if !matches!(problem.code.as_str(), "E0201" | "E0309" | "E0403") || name.is_empty() {
        return;
    }
    let database = &asked.snapshot.database;
    let before = asked.text.get(..problem.primary.span.start as usize).unwrap_or_default();
    let after_dot = before.trim_end().ends_with('.');
    if after_dot {
        return;
    }
    let own = database.module_of(&asked.file);
    let imported = |module: &str| {
        asked
            .tree
            .module
            .statements
            .iter()
            .any(|statement| matches!(&statement.kind, StmtKind::Import(path) if dotted(path) == module))
    };
    // `gears.rack` without `import gears;`, `parts.rims` written as `rims`.
    let modules = database.modules();
    let named = modules.iter().filter(|module| module.rsplit('.').next() == Some(name) && !imported(module));
    for module in named.take(MOST_MODULES) {
        found.push(fix(format!("Import `{module}`"), vec![statement(asked, module)]).preferred());
    }
    let mut exported = database.exported(name);
    exported.retain(|(module, _)| own.as_deref() != Some(module.as_str()) && module != "prelude");
    exported.sort_by(|a, b| a.0.cmp(&b.0));
    for (module, visible) in exported.into_iter().take(MOST_MODULES) {
        let short = module.rsplit('.').next().unwrap_or_default();
        // Units are always unqualified.
        let unit = visible.kind == NameKind::Unit;
        let start = problem.primary.span.start;
        let qualified = (!unit).then(|| asked.edit(start, start, format!("{short}.")));
        let import = (!imported(&module)).then(|| statement(asked, &module));
        let title = match (&qualified, &import) {
            (Some(_), Some(_)) => format!("Import `{module}` and write `{short}.{name}`"),
            // Offered by the diagnostic itself, if no other declaration is meant.
            (Some(_), None) if changes_to(problem, &format!("{short}.{name}")) => continue,
            (Some(_), None) => format!("Write `{short}.{name}`"),
            (None, Some(_)) => format!("Import `{module}`, which has the unit `{name}`"),
            (None, None) => continue,
        };
        found.push(fix(title, import.into_iter().chain(qualified).collect()));
    }
}

/// Returns `true` if the diagnostic has a change to this text.
fn changes_to(problem: &Diagnostic, text: &str) -> bool {
    problem.fix.iter().chain(&problem.suggestions).any(|change| change.replacement == text)
}

/// Returns the edit that imports a module: after the other imports, else before everything except
/// the documentation of the file.
fn statement(asked: &ActionRequest, module: &str) -> Edit {
    let statements = &asked.tree.module.statements;
    let imports = statements.iter().rfind(|statement| matches!(statement.kind, StmtKind::Import(_)));
    if let Some(last) = imports {
        return asked.edit(last.span.end, last.span.end, format!("\nimport {module};"));
    }
    let first = statements.first().map_or(asked.text.len() as u32, |first| first.span.start);
    let start = documented(asked, first);
    let gap = if statements.is_empty() { "" } else { "\n" };
    asked.edit(start, start, format!("import {module};\n{gap}"))
}

/// Returns the start of the comments directly above a statement.
fn documented(asked: &ActionRequest, first: u32) -> u32 {
    let Some(tokens) = asked.snapshot.database.tokens(&asked.file) else { return first };
    let mut from = first;
    for comment in tokens.comments.iter().filter(|comment| comment.span.end <= first).rev() {
        let between = asked.text.get(comment.span.end as usize..from as usize).unwrap_or_default();
        if !matches!(comment.kind, CommentKind::Doc | CommentKind::Line) || between.matches('\n').count() != 1
        {
            break;
        }
        from = comment.span.start;
    }
    from
}

fn dotted(path: &[calyx_lang::ast::Ident]) -> String {
    path.iter().map(|part| part.name.as_str()).collect::<Vec<_>>().join(".")
}
