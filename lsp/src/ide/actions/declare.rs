//! Actions that declare an unknown name, or make a private declaration public.

use super::{Action, ActionRequest, fix};
use crate::ide::Edit;
use crate::ide::enclosing::{GivenValue, Receiver};
use calyx_lang::ast::{Bind, Expr, ExprKind, StmtKind};
use calyx_lang::common_units::written;
use calyx_lang::declared::name_of;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::dimension::Dimension;

pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    match problem.code.as_str() {
        "E0220" => return variable_for_constant(asked, problem, found),
        "E0204" => return found.extend(public(asked, problem)),
        _ => {}
    }
    let place = problem.primary.span;
    let name = asked.slice(place);
    if problem.code != "E0201" || name.is_empty() {
        return;
    }
    let around = asked.around(place);
    // The compiler suggests `var` for an assignment itself.
    let is_assigned = around.statements().next_back().is_some_and(|statement| match &statement.kind {
        StmtKind::Assign { place: Expr { kind: ExprKind::Name(target), .. }, .. } => target.span == place,
        _ => false,
    });
    if is_assigned {
        return;
    }
    // A called name is a function, a name with members may be a module.
    let called = around.expressions().rev().nth(1).is_some_and(|outer| match &outer.kind {
        ExprKind::Call { callee, .. } => callee.span == place,
        ExprKind::Field { base, .. } => base.span == place,
        _ => false,
    });
    let is_expression = around.expression().is_some_and(|e| e.span == place);
    let Some(statement) = around.whole_statement().filter(|_| is_expression && !called) else { return };
    let value = match around.given().and_then(|given| demanded(asked, &given, place.start)) {
        Some(dimension) => {
            let unit = asked.system().0.unit_of(dimension).name;
            written(if unit.is_empty() { "1" } else { "0" }, &unit)
        }
        None => "0".into(),
    };
    let (line, indent) = asked.line(statement.span.start);
    let declare = |keyword: &str, line: u32, indent: &str| {
        asked.edit(line, line, format!("{indent}{keyword} {name} = {value};\n"))
    };
    if asked
        .tree
        .module
        .statements
        .iter()
        .all(|top| top.span.start != line && line_has_code(asked, line, statement.span.start))
    {
        return;
    }
    found.push(fix(format!("Declare `{name}` as a variable"), vec![declare("var", line, indent)]));
    let in_model = asked.snapshot.database.module_of(&asked.file).is_none();
    let top = asked
        .tree
        .module
        .statements
        .iter()
        .find(|top| top.span.start <= place.start && place.end <= top.span.end);
    if let Some(top) = top.filter(|_| in_model) {
        let (line, indent) = asked.line(top.span.start);
        found.push(fix(format!("Declare `{name}` as a param"), vec![declare("param", line, indent)]));
    }
}

/// Returns true if there is code before the statement on its line.
fn line_has_code(asked: &ActionRequest, line: u32, start: u32) -> bool {
    asked.text.get(line as usize..start as usize).is_none_or(|before| !before.trim().is_empty())
}

/// Returns the dimension of the parameter whose argument is the name.
fn demanded(asked: &ActionRequest, given: &GivenValue, start: u32) -> Option<Dimension> {
    let (Receiver::Argument(argument) | Receiver::Positional(argument)) = given.to else { return None };
    let whole = given.value.span.start == start && matches!(given.value.kind, ExprKind::Name(_));
    if !whole || given.bind != Bind::Evaluate {
        return None;
    }
    let around =
        super::EnclosingNodes::new(&asked.tree.module, argument.value.span.start..argument.value.span.end);
    let (_, callee, arguments) = around.call()?;
    let callable = super::arguments::callable(asked, callee)?;
    let parameter = match &argument.name {
        Some((name, _)) => callable.parameters.iter().find(|parameter| parameter.is_called(&name.name)),
        None => {
            let in_order = arguments.iter().take_while(|other| other.name.is_none() && !other.spread);
            let index = in_order.into_iter().position(|other| other.value.span == argument.value.span)?;
            callable.parameters.get(index)
        }
    };
    parameter?.dimension
}

/// Changes `const` to `var` if a constant is assigned to.
fn variable_for_constant(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    for label in &problem.labels {
        let around = asked.around(label.span);
        let declared = around.statements().next_back().filter(|statement| match &statement.kind {
            StmtKind::Const { name, .. } => name.span == label.span && !statement.private,
            _ => false,
        });
        if let Some(statement) = declared {
            let start = statement.span.start;
            let edit = asked.edit(start, start + "const".len() as u32, "var");
            found.push(fix(format!("Make `{}` a variable", asked.slice(label.span)), vec![edit]));
        }
    }
}

/// Removes the `private` of a declaration in another module.
fn public(asked: &ActionRequest, problem: &Diagnostic) -> Option<Action> {
    let place = problem.primary.span;
    let around = asked.around(place);
    let member = around.expression().and_then(|e| match &e.kind {
        ExprKind::Field { base, field } if field.span == place => Some((base.span.end, &field.name)),
        _ => None,
    });
    let (module_end, name) = member?;
    let database = &asked.snapshot.database;
    let module = database.name_at(&asked.file, module_end)?.declared?.file;
    let (tree, text) = (database.tree(&module)?, database.text(&module)?);
    let hidden = tree.module.statements.iter().find(|statement| {
        statement.private && name_of(statement).is_some_and(|declared| declared.name == *name)
    })?;
    let start = hidden.span.start;
    let rest = text.get(start as usize..)?.strip_prefix("private")?;
    let length = "private".len() + (rest.len() - rest.trim_start().len());
    let own = !module.starts_with('<');
    own.then(|| {
        let edit =
            Edit { file: module.clone(), start, end: start + length as u32, replacement: String::new() };
        fix(format!("Make `{name}` visible outside its module"), vec![edit])
    })
}
