//! Actions that name positional arguments, and that add missing arguments.

use super::{Action, ActionRequest, fix, rewrite};
use crate::ide::Edit;
use calyx_lang::analysis::{CallParameter, Callable, NameKind};
use calyx_lang::ast::{Argument, Expr, ExprKind};
use calyx_lang::common_units::written;
use calyx_lang::diagnostic::Diagnostic;

/// Returns the signature of the callee expression.
pub(super) fn callable(asked: &ActionRequest, callee: &Expr) -> Option<Callable> {
    let name = match &callee.kind {
        ExprKind::Name(name) => name,
        ExprKind::Field { field, .. } => field,
        _ => return None,
    };
    let known = asked.snapshot.database.name_at(&asked.file, name.span.start)?;
    match &known.declared {
        Some(place) => asked.snapshot.database.callable(place),
        None => None,
    }
}

/// Names the arguments of the call at the cursor: all, or those from the cursor on, because
/// positional arguments cannot follow named ones.
pub(super) fn naming(asked: &ActionRequest, found: &mut Vec<Action>) {
    let around = super::EnclosingNodes::new(&asked.tree.module, asked.range.clone());
    let Some((_, callee, arguments)) = around.call() else { return };
    let Some(callable) = callable(asked, callee).filter(|callable| !callable.open) else { return };
    let positional = |argument: &&Argument| argument.name.is_none() && !argument.spread;
    let count = arguments.iter().take_while(positional).count();
    if count == 0 || count > callable.parameters.len() {
        return;
    }
    let named = |from: usize| -> Vec<Edit> {
        let pairs = arguments.iter().zip(&callable.parameters).take(count).skip(from);
        pairs
            .map(|(argument, parameter)| {
                let start = argument.value.span.start;
                let sign = if parameter.symbolic { ":=" } else { "=" };
                asked.edit(start, start, format!("{} {sign} ", parameter.name))
            })
            .collect()
    };
    let touched = |argument: &Argument| {
        argument.value.span.start <= asked.range.start && asked.range.end <= argument.value.span.end
    };
    let last = count - 1;
    if let Some(at) = arguments.iter().take(count).position(touched)
        && at > 0
        && let Some(CallParameter { name, .. }) = callable.parameters.get(at)
    {
        let title = match at == last {
            true => format!("Name this argument: `{name}`"),
            false => format!("Name this argument and those after it: `{name}`, ..."),
        };
        found.push(rewrite(title, named(at)));
    }
    let title = if count == 1 { "Name the argument" } else { "Name the arguments" };
    found.push(rewrite(format!("{title}: `{}`", listed(callable.parameters.iter().take(count))), named(0)));
}

fn listed<'p>(parameters: impl ExactSizeIterator<Item = &'p CallParameter>) -> String {
    let more = if parameters.len() > 3 { ", ..." } else { "" };
    parameters.take(3).map(|parameter| &*parameter.name).collect::<Vec<_>>().join(", ") + more
}

/// Adds the missing required arguments of a call, each with an obvious placeholder value of its
/// type.
pub(super) fn of(asked: &ActionRequest, problem: &Diagnostic, found: &mut Vec<Action>) {
    if problem.code != "E0206" || !problem.message.contains(" lacks ") {
        return;
    }
    let around = asked.around(problem.primary.span);
    let call = around.expressions().rev().find(|e| e.span == problem.primary.span);
    let Some(ExprKind::Call { callee, arguments }) = call.map(|e| &e.kind) else { return };
    let Some(callable) = callable(asked, callee) else { return };
    let positional =
        arguments.iter().take_while(|argument| argument.name.is_none() && !argument.spread).count();
    let given = |parameter: &CallParameter| {
        arguments
            .iter()
            .any(|argument| matches!(&argument.name, Some((name, _)) if parameter.is_called(&name.name)))
    };
    let missing: Vec<&CallParameter> = callable
        .parameters
        .iter()
        .skip(positional)
        .filter(|parameter| parameter.default.is_none() && !given(parameter))
        .filter(|parameter| problem.message.contains(&format!("`{}`", parameter.name)))
        .collect();
    if missing.is_empty() {
        return;
    }
    let written: Vec<String> = missing
        .iter()
        .map(|parameter| {
            let sign = if parameter.symbolic { ":=" } else { "=" };
            format!("{} {sign} {}", parameter.name, sample(asked, parameter, problem.primary.span.start))
        })
        .collect();
    let end = problem.primary.span.end.saturating_sub(1);
    let start = arguments.last().map_or(end, |last| last.value.span.end);
    let before = if arguments.is_empty() { "" } else { ", " };
    let title = match missing.as_slice() {
        [one] => format!("Add the argument `{}`", one.name),
        all => format!("Add the {} missing arguments", all.len()),
    };
    found.push(
        fix(title, vec![asked.edit(start, start, format!("{before}{}", written.join(", ")))]).preferred(),
    );
}

/// Returns a placeholder of a parameter's type: for a handle the nearest variable of its type, for
/// a number 0 in the file's unit.
fn sample(asked: &ActionRequest, parameter: &CallParameter, offset: u32) -> String {
    if let Some(choice) = parameter.choices.first() {
        return format!("\"{choice}\"");
    }
    if let Some(dimension) = parameter.dimension {
        let zero = if parameter.ty.starts_with("Vector") { "0 * e1" } else { "0" };
        let unit = asked.system().0.unit_of(dimension).name;
        return match zero {
            "0" => written("0", &unit),
            vector => vector.into(),
        };
    }
    match parameter.ty.as_str() {
        "Bool" => "TRUE".into(),
        "String" => format!("\"{}\"", parameter.name),
        "Vector" => "e3".into(),
        ty if ty.contains("Transform") => "Translate(0 * e1)".into(),
        ty if ty.starts_with("Array") => "[]".into(),
        ty => {
            let visible = asked.snapshot.database.visible(&asked.file, offset);
            let mut fitting = visible.iter().filter(|known| {
                matches!(known.kind, NameKind::Variable | NameKind::Parameter)
                    && known.ty.as_deref() == Some(ty)
            });
            fitting.next().map_or_else(|| parameter.name.to_string(), |known| known.name.to_string())
        }
    }
}
