//! Signature help: the call around a cursor, and its active parameter.

use super::callee::{self, matched, position};
use super::completion::parameter_text;
use super::cursor::{Call, CursorContext, CursorRegion};
use super::{Position, Snapshot};
use calyx_lang::analysis::{CallParameter, Callable, Visible};
use calyx_lang::ast::Mode;
use calyx_lang::db::Database;
use std::ops::Range;

/// Characters that trigger signature help.
pub const TRIGGERS: &[&str] = &["(", ","];
/// Characters that update signature help while it is shown.
pub const RETRIGGERS: &[&str] = &[")", "="];

/// Signature of a called function.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// `gears.lead_crown(depth: Length) -> Modification`
    pub label: String,
    pub doc: Option<String>,
    pub parameters: Vec<ShownParameter>,
    /// Index of the active parameter; `None` if the cursor is at none of them.
    pub active: Option<usize>,
}

/// Parameter of a signature.
#[derive(Clone, Debug, PartialEq)]
pub struct ShownParameter {
    /// Byte range in the label.
    pub label: Range<usize>,
    /// Documentation, default and range.
    pub doc: String,
}

/// Returns the signature of the innermost call around a cursor with a known callee.
pub fn signature(snapshot: &Snapshot, at: &Position) -> Option<Signature> {
    let database = &snapshot.database;
    let (text, tokens) = (database.text(&at.file)?, database.tokens(&at.file)?);
    let around = CursorContext::new(text, &tokens, at.offset as usize);
    let end = match around.standing(&tokens) {
        CursorRegion::Comment => return None,
        CursorRegion::Text(_) => around.string_open()?,
        CursorRegion::Code | CursorRegion::Number => around.before,
    };
    let calls = around.calls(&around.statement(end));
    if calls.is_empty() {
        return None;
    }
    let visible = database.seen(&at.file, at.offset);
    let known = calls.iter().find_map(|call| {
        let callable = callee::callable(database, &visible, &call.path)?;
        Some((call, callable))
    });
    let (call, callable) = known?;
    let active = active(database, &visible, call, &callable, around.prefix());
    Some(show(call, callable, active))
}

/// Returns the index of the active parameter.
fn active(
    database: &Database,
    visible: &[Visible],
    call: &Call,
    callable: &Callable,
    typed: &str,
) -> Option<usize> {
    let given = call.arguments.get(call.active);
    if given.is_some_and(|given| given.spread.is_some()) {
        return None;
    }
    if let Some(name) = given.and_then(|given| given.name.as_deref()) {
        return callable.parameters.iter().position(|parameter| parameter.is_called(name));
    }
    let fields = |record: &str| callee::fields_of(database, visible, record).unwrap_or_default();
    let matched = matched(callable, call, &fields);
    let begun = |at: &&usize| {
        let parameter = callable.parameters.get(**at);
        !typed.is_empty() && parameter.is_some_and(|parameter| parameter.name.starts_with(typed))
    };
    match matched.in_order {
        true => position(callable, call.active),
        // After named arguments: the parameter whose name is partly written, or the next one.
        false => matched.left.iter().find(begun).or(matched.left.first()).copied(),
    }
}

fn show(call: &Call, callable: Callable, active: Option<usize>) -> Signature {
    let mut label = format!("{}(", call.path.join("."));
    let mut parameters = Vec::new();
    for (at, parameter) in callable.parameters.iter().enumerate() {
        if at > 0 {
            label.push_str(", ");
        }
        let start = label.len();
        label.push_str(&written(parameter));
        parameters.push(ShownParameter { label: start..label.len(), doc: parameter_text(parameter) });
    }
    if callable.open {
        label.push_str(", ...");
    }
    label.push(')');
    if let Some(result) = &callable.result {
        label.push_str(" -> ");
        label.push_str(result);
    }
    Signature { label, doc: callable.doc, parameters, active }
}

/// Formats a parameter: `out least: Length`, `depth: Length = 1 mm`, `frame := Transform`.
fn written(parameter: &CallParameter) -> String {
    let mode = match parameter.mode {
        Mode::In => "",
        Mode::Out => "out ",
        Mode::InOut => "inout ",
    };
    let ty =
        parameter.ty.strip_prefix("Symbolic(").and_then(|ty| ty.strip_suffix(')')).unwrap_or(&parameter.ty);
    let mut written = format!("{mode}{}", parameter.name);
    if parameter.symbolic {
        written.push_str(" := ");
        written.push_str(ty);
    } else if ty.len() > 1 {
        written.push_str(": ");
        written.push_str(ty);
    }
    if let Some(default) = &parameter.default {
        written.push_str(" = ");
        written.push_str(default);
    }
    written
}
