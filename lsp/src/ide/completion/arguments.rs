//! Completion of named arguments of the call at the cursor.

use super::context::{CompletionSite, Operator, Slot, Value};
use super::item::{AfterInsert, Insert, Item, ItemKind, Rank, Subject, escaped};
use super::request::{Called, Request};
use crate::ide::shape::{self, Shape};
use calyx_lang::analysis::{CallParameter, NameKind};
use calyx_lang::lexer::Kind;

/// Largest number of required parameters for which positional arguments are clear.
const FEW: usize = 2;

/// Offers names of parameters, and records whose fields are parameters.
pub fn arguments(request: &Request<'_>, items: &mut Vec<Item>) {
    let CompletionSite::Value(Value { slot: Slot::Argument { name: None, .. }, operator: Operator::None }) =
        &request.context.spot
    else {
        return;
    };
    let around = &request.context.around;
    let begins = matches!(around.previous(around.before), Some(Kind::OpenParen | Kind::Comma));
    let Some(called) = request.call.as_ref().filter(|_| begins) else { return };
    if called.callable.kind == NameKind::Builtin {
        return;
    }
    let required = called.callable.parameters.iter().filter(|parameter| is_required(parameter)).count();
    // A handle of the library shows its meaning, so it is passed by position.
    let plain = matches!(&request.expected.shape, Shape::Named(name) if name != "String" && name != "Bool");
    let origin = if called.in_order && plain && required <= FEW { 3 } else { 0 };
    // After all required arguments, optional ones are passed by name.
    let optional =
        called.active.and_then(|at| called.callable.parameters.get(at)).is_some_and(|p| !is_required(p));
    for &at in &called.left {
        let Some(parameter) = called.callable.parameters.get(at) else { continue };
        let fit = if is_required(parameter) || optional { 0 } else { 1 };
        items.push(argument(request, called, parameter, Rank { fit, origin, order: at as u32 }));
    }
    spreads(request, called, items);
}

fn is_required(parameter: &CallParameter) -> bool {
    parameter.default.is_none()
}

fn argument(request: &Request<'_>, called: &Called, parameter: &CallParameter, rank: Rank) -> Item {
    let around = &request.context.around;
    let sign = if parameter.symbolic { ":=" } else { "=" };
    let name = &parameter.name;
    let mut item = Item::new(format!("{name} {sign}"), ItemKind::Argument, rank);
    item.filter = Some(name.to_string());
    item.detail = detail(request, parameter);
    item.subject = called.callable.declared.clone().map(|place| Subject::Parameter(place, name.to_string()));
    // `name| = 3`
    if matches!(around.kind(around.next()), Some(Kind::Assign | Kind::Bind)) {
        item.insert = Insert::plain(name.to_string());
        return item;
    }
    let plain = format!("{name} {sign} ");
    let (value, then) = placeholder(parameter);
    item.insert = Insert::snippet(plain.clone(), plain + &value);
    item.then = then;
    item
}

/// Returns the placeholder of the value, and the command to run after insertion.
fn placeholder(parameter: &CallParameter) -> (String, AfterInsert) {
    if !parameter.choices.is_empty() {
        let mut choices: Vec<&str> = parameter.choices.iter().map(String::as_str).collect();
        // The default comes first.
        let default = parameter.default.as_deref().unwrap_or_default().trim_matches('"');
        choices.sort_by_key(|choice| *choice != default);
        let choices: Vec<String> = choices.into_iter().map(choice).collect();
        return (format!("\"${{1|{}|}}\"", choices.join(",")), AfterInsert::Nothing);
    }
    let shape = Shape::read(&parameter.ty);
    match (&parameter.default, shape) {
        (Some(default), shape) if shape.is("Bool") => {
            let other = if default == "TRUE" { "FALSE" } else { "TRUE" };
            (format!("${{1|{other},{default}|}}"), AfterInsert::Nothing)
        }
        (_, shape) if shape.is("String") => ("\"$1\"".into(), AfterInsert::Nothing),
        (_, Shape::Array(_)) => ("[$1]".into(), AfterInsert::Completion),
        (Some(default), _) => (format!("${{1:{}}}", escaped(default)), AfterInsert::Nothing),
        (None, Shape::Named(_)) => ("$1".into(), AfterInsert::Completion),
        (None, _) => ("$1".into(), AfterInsert::Nothing),
    }
}

/// Escapes a text for a choice of a snippet.
fn choice(text: &str) -> String {
    escaped(text).replace(',', "\\,").replace('|', "\\|")
}

/// Formats type, unit, default and range: `Length [inch] = 0.02 inch in 0 inch .. 1 inch`.
pub fn detail(request: &Request<'_>, parameter: &CallParameter) -> String {
    // A single letter is a type variable.
    let mut detail = if parameter.ty.len() > 1 { parameter.ty.clone() } else { String::new() };
    let dimension = parameter.dimension.or_else(|| shape::dimension(&parameter.ty));
    if let Some(dimension) = dimension.filter(|dimension| !dimension.is_none()) {
        let unit = request.system.unit_of(dimension).name;
        detail.push_str(&format!(" [{unit}]"));
    }
    if let Some(default) = &parameter.default {
        detail.push_str(&format!(" = {default}"));
    }
    if let Some(range) = &parameter.range {
        detail.push_str(&format!(" in {range}"));
    } else if !parameter.choices.is_empty() {
        detail.push_str(&format!(" in [\"{}\"]", parameter.choices.join("\", \"")));
    }
    detail.trim_start().to_string()
}

/// Offers `..size`, if the fields of the record are parameters.
fn spreads(request: &Request<'_>, called: &Called, items: &mut Vec<Item>) {
    for (order, known) in request.visible.iter().enumerate() {
        let value = matches!(known.kind, NameKind::Variable | NameKind::Parameter | NameKind::Const);
        let Some(fields) = value.then(|| request.fields_of(&known.name)).flatten() else { continue };
        let is_left = |field: &CallParameter| {
            let mut left = called.left.iter().filter_map(|&at| called.callable.parameters.get(at));
            left.any(|parameter| parameter.name == field.name)
        };
        if fields.is_empty() || !fields.iter().all(is_left) {
            continue;
        }
        let rank = Rank { fit: 1, origin: 0, order: order as u32 };
        let names: Vec<&str> = fields.iter().map(|field| &*field.name).collect();
        let mut item = Item::new(format!("..{}", known.name), ItemKind::Value, rank);
        item.filter = Some(known.name.to_string());
        item.detail = format!("{} of {}", names.join(", "), known.ty.as_deref().unwrap_or_default());
        item.subject = known.declared.clone().map(Subject::Declaration);
        items.push(item);
    }
}
