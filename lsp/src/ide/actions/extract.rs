//! Actions that extract an expression into a variable, and that inline a variable.
//!
//! They are offered only if they certainly preserve the meaning: the moved expression has no side
//! effects, the values of its names do not change in between, and a literal without a unit keeps
//! the unit of its context.

use super::unused::{computes, is_written, without_declaration};
use super::{Action, ActionKind, ActionRequest, rewrite};
use crate::ide::enclosing::{EnclosingNodes, Receiver};
use calyx_lang::analysis::{Name, NameKind};
use calyx_lang::ast::{BinaryOp, Bind, Expr, ExprKind, Mode, Stmt, StmtKind};
use calyx_lang::span::Span;
use calyx_lang::walk::Node;

pub(super) fn extracting(asked: &ActionRequest, found: &mut Vec<Action>) {
    if asked.range.is_empty() {
        return;
    }
    let selected = trimmed(asked);
    let around = asked.around(selected);
    let Some(e) = around.expressions().find(|e| e.span == selected) else { return };
    let plain = matches!(e.kind, ExprKind::Name(_) | ExprKind::Bool(_) | ExprKind::Error);
    let may_have_unit = asked.system().1 && may_be_bare(e);
    let Some(statement) = around.whole_statement().filter(|statement| evaluates_first(statement, e)) else {
        return;
    };
    let (line, indent) = asked.line(statement.span.start);
    let begins_line = line + indent.len() as u32 == statement.span.start;
    if plain || may_have_unit || !begins_line || !is_movable(asked, &around, e) {
        return;
    }
    let names = asked.snapshot.database.names_in(&asked.file, e.span.start..e.span.end);
    let within = |name: &&Name| e.span.start <= name.start && name.end <= e.span.end;
    let symbol = |name: &Name| {
        name.kind == NameKind::Symbolic || &*name.text == "Time" || name.kind == NameKind::Output
    };
    let typed = asked.snapshot.database.expressions(&asked.file, e.span.start..e.span.end);
    let ty = typed.iter().find(|typed| (typed.start, typed.end) == (e.span.start, e.span.end));
    let observes = ty.is_some_and(|ty| ty.ty.starts_with("Observable"));
    let stays = observes
        || names.iter().filter(within).any(symbol)
        || (keeps_symbols(asked, &around, statement)
            && names.iter().filter(within).any(|name| name.kind == NameKind::Param));
    if names
        .iter()
        .filter(within)
        .any(|name| name.declared.as_ref().is_some_and(|place| declared_in(statement, place.start)))
    {
        return;
    }
    let name = fresh_name(asked, &around, e);
    let sign = if stays { ":=" } else { "=" };
    let value = match &e.kind {
        ExprKind::Paren(inner) => inner.span,
        _ => e.span,
    };
    let edits = vec![
        asked.edit(line, line, format!("{indent}var {name} {sign} {};\n", asked.slice(value))),
        asked.edit(e.span.start, e.span.end, &*name),
    ];
    let action = rewrite(format!("Extract into variable `{name}`"), edits);
    found.push(Action { kind: ActionKind::Extract, ..action });
}

fn trimmed(asked: &ActionRequest) -> Span {
    let text = asked.slice(Span { start: asked.range.start, end: asked.range.end, ..Span::default() });
    let start = asked.range.start + (text.len() - text.trim_start().len()) as u32;
    Span { start, end: start + text.trim().len() as u32, ..Span::default() }
}

/// Returns true if an expression is evaluated once, at the start of its statement.
fn evaluates_first(statement: &Stmt, e: &Expr) -> bool {
    let inside = |outer: &Expr| outer.span.start <= e.span.start && e.span.end <= outer.span.end;
    match &statement.kind {
        StmtKind::Var(all) => all.len() == 1,
        StmtKind::Assign { value, .. } => inside(value),
        StmtKind::Expr(_) | StmtKind::Output { .. } | StmtKind::Return(_) | StmtKind::Throw(_) => true,
        StmtKind::If { condition, .. } => inside(condition),
        StmtKind::Switch { value, .. } => inside(value),
        _ => false,
    }
}

/// Returns true if an earlier evaluation of an expression yields the same result.
fn is_movable(asked: &ActionRequest, around: &EnclosingNodes, e: &Expr) -> bool {
    let perhaps = around.expressions().filter(|outer| outer.span != e.span).any(|outer| {
        matches!(&outer.kind, ExprKind::If { .. } | ExprKind::Binary { op: BinaryOp::And | BinaryOp::Or, .. })
    });
    let mut indexes = false;
    Node::Expression(e).walk(&mut |node| {
        indexes |= matches!(node, Node::Expression(Expr { kind: ExprKind::Index { .. }, .. }));
    });
    // An `out` argument is a place, not a value.
    let handed_back = around.expressions().rev().filter(|outer| outer.span != e.span).any(|outer| {
        let ExprKind::Call { callee, arguments } = &outer.kind else { return false };
        let Some(callable) = super::arguments::callable(asked, callee) else { return false };
        let pairs = arguments.iter().enumerate().filter(|(_, argument)| argument.value.span == e.span);
        pairs.into_iter().any(|(index, argument)| {
            let parameter = match &argument.name {
                Some((name, _)) => {
                    callable.parameters.iter().find(|parameter| parameter.is_called(&name.name))
                }
                None => callable.parameters.get(index),
            };
            argument.spread || parameter.is_some_and(|parameter| parameter.mode != Mode::In)
        })
    });
    computes(asked, e) && !(perhaps && indexes) && !handed_back
}

/// Returns true if the expression has a literal whose unit may depend on its context.
fn may_be_bare(e: &Expr) -> bool {
    match &e.kind {
        ExprKind::Number(value) => *value != 0.0,
        ExprKind::Paren(inner) | ExprKind::Unary { operand: inner, .. } => may_be_bare(inner),
        ExprKind::Binary {
            op: BinaryOp::Add | BinaryOp::Subtract | BinaryOp::Multiply, left, right, ..
        } => may_be_bare(left) || may_be_bare(right),
        ExprKind::List(all) => all.iter().any(may_be_bare),
        ExprKind::If { then, otherwise, .. } => may_be_bare(then) || may_be_bare(otherwise),
        _ => false,
    }
}

/// Returns true if params in an expression remain symbolic at its position.
fn keeps_symbols(asked: &ActionRequest, around: &EnclosingNodes, statement: &Stmt) -> bool {
    matches!(statement.kind, StmtKind::Output { .. })
        || around.given().is_some_and(|given| given.bind == Bind::Symbolic)
        || matches!(&statement.kind, StmtKind::Var(all) if all.iter().any(|decl| matches!(decl.init, Some((Bind::Symbolic, _)))))
        || matches!(&statement.kind, StmtKind::Assign { bind: Bind::Symbolic, .. })
        || around.expressions().any(|outer| match &outer.kind {
            ExprKind::At { .. } => true,
            ExprKind::Call { callee, .. } => takes_symbols(asked, callee),
            _ => false,
        })
}

/// Returns true if a callee takes expressions instead of values.
fn takes_symbols(asked: &ActionRequest, callee: &Expr) -> bool {
    let built_in =
        ["derivative", "gradient", "velocity", "acceleration", "angular_velocity", "angular_acceleration"];
    built_in.contains(&asked.slice(callee.span))
        || super::arguments::callable(asked, callee).is_some_and(|callable| {
            callable.kind == NameKind::SymbolicFunction
                || callable.parameters.iter().any(|parameter| parameter.symbolic)
        })
}

fn declared_in(statement: &Stmt, start: u32) -> bool {
    statement.span.start <= start && start < statement.span.end
}

/// Returns the name of the receiver of the value, or a generic name.
fn fresh_name(asked: &ActionRequest, around: &EnclosingNodes, e: &Expr) -> String {
    let given = around.given().filter(|given| given.value.span == e.span);
    let base = match given.map(|given| given.to) {
        Some(Receiver::Argument(argument)) => argument.name.as_ref().map(|(name, _)| name.name.to_string()),
        Some(Receiver::Positional(argument)) => around.call().and_then(|(_, callee, arguments)| {
            let at = arguments.iter().position(|other| other.value.span == argument.value.span)?;
            let callable = super::arguments::callable(asked, callee)?;
            callable.parameters.get(at).map(|parameter| parameter.name.to_string())
        }),
        _ => None,
    };
    let base = base.unwrap_or_else(|| "value".into());
    let visible = asked.snapshot.database.visible(&asked.file, e.span.start);
    let taken = |name: &str| {
        // The name of an argument is no variable.
        let declared = visible.iter().any(|known| *known.name == *name);
        declared || (name == "value" && is_written(asked, name))
    };
    let numbered = (2..100).map(|number| format!("{base}_{number}"));
    [base.clone()].into_iter().chain(numbered).find(|name| !taken(name)).unwrap_or(base)
}

pub(super) fn inlining(asked: &ActionRequest, found: &mut Vec<Action>) {
    if let Some(action) = inlined(asked) {
        found.push(action);
    }
}

fn inlined(asked: &ActionRequest) -> Option<Action> {
    let database = &asked.snapshot.database;
    let name = database.name_at(&asked.file, asked.range.start)?;
    let place = name.declared.filter(|place| {
        matches!(name.kind, NameKind::Variable | NameKind::Symbolic)
            && place.file == asked.file
            && asked.range.end <= name.end
    })?;
    let span = Span { start: place.start, end: place.end, ..Span::default() };
    let around = asked.around(span);
    let given = around.given()?;
    let Receiver::Variable(_, decl) = given.to else { return None };
    let e = given.value;
    let text = asked.slice(e.span);
    let fixed = computes(asked, e) && decl.name.span == span && !text.contains('\n');
    if !fixed
        || (asked.system().1 && may_be_bare(e))
        || !asked.problems.iter().all(|problem| problem.code.starts_with('W'))
    {
        return None;
    }
    // Names in the expression must have the same meaning at all uses.
    let inside = database.names_in(&asked.file, e.span.start..e.span.end);
    let inside: Vec<Name> =
        inside.into_iter().filter(|name| e.span.start <= name.start && name.end <= e.span.end).collect();
    let mut of_param = false;
    for name in &inside {
        of_param |= name.kind == NameKind::Param;
        if let (NameKind::Variable | NameKind::Symbolic | NameKind::Parameter, Some(place)) =
            (name.kind, &name.declared)
        {
            let changed = database.references(place).iter().any(|(_, other)| other.writes && !other.declares);
            let argument = name.kind == NameKind::Parameter && place.start < e.span.start;
            if changed || (name.kind == NameKind::Parameter && !argument) {
                return None;
            }
        }
    }
    let mut edits = vec![without_declaration(asked, span, false)?];
    for (file, used) in database.references(&place) {
        if used.declares {
            continue;
        }
        let at = Span { start: used.start, end: used.end, ..Span::default() };
        let around = asked.around(at);
        let user = around.expression().filter(|user| user.span == at)?;
        if used.writes || file != asked.file || is_special(asked, &around, user) {
            return None;
        }
        let symbolic = around.given().is_some_and(|given| given.bind == Bind::Symbolic)
            || around.statements().any(|statement| matches!(statement.kind, StmtKind::Output { .. }));
        if given.bind == Bind::Evaluate && of_param && symbolic {
            return None;
        }
        let visible = database.visible(&asked.file, used.start);
        let same = inside.iter().all(|name| {
            let known = visible.iter().find(|known| known.name == name.text);
            name.declared.is_none() || known.is_none_or(|known| known.declared == name.declared)
        });
        if !same {
            return None;
        }
        let part = matches!(around.parent(user), Some(Node::Expression(_)));
        let atom = matches!(
            e.kind,
            ExprKind::Name(_)
                | ExprKind::Call { .. }
                | ExprKind::String(_)
                | ExprKind::List(_)
                | ExprKind::Paren(_)
                | ExprKind::Bool(_)
        );
        let replacement = if part && !atom { format!("({text})") } else { text.to_string() };
        edits.push(asked.edit(used.start, used.end, replacement));
    }
    if edits.len() < 2 {
        return None;
    }
    let title = format!("Inline `{}`", decl.name.name);
    Some(Action { kind: ActionKind::Inline, ..rewrite(title, edits) })
}

/// Returns true for uses that require a name: `..record`, `x[i]` as a possible `out` argument, and
/// strings.
fn is_special(asked: &ActionRequest, around: &EnclosingNodes, user: &Expr) -> bool {
    let spread = around.nodes.iter().any(|node| matches!(node, Node::Argument(argument) if argument.spread));
    let in_text = around.expressions().any(|outer| matches!(outer.kind, ExprKind::String(_)));
    let symbol = around
        .expressions()
        .any(|outer| matches!(&outer.kind, ExprKind::At { symbol, .. } if symbol.span == user.span));
    let derived = around
        .call()
        .is_some_and(|(_, callee, _)| matches!(asked.slice(callee.span), "derivative" | "gradient"));
    spread || in_text || symbol || derived
}
