//! Command lines that repeat a run, as it was or with one setting changed.

use super::read::{Run, objects};
use calyx_abi::shell::word;
use serde_json::Value;

/// Returns the command that reproduces the results.
pub fn command(run: &Run) -> String {
    with_setting(run, None)
}

/// Returns the same command with one analysis setting changed.
pub fn with_setting(run: &Run, changed: Option<(&str, &str)>) -> String {
    let others = objects(&run.head["overrides"])
        .filter(|(name, _)| changed.is_none_or(|(changed, _)| changed != *name));
    let overrides = others.map(|(name, value)| option(name, &shown(value)));
    let changed = changed.map(|(name, value)| option(name, value));
    [subcommand("run", run)].into_iter().chain(overrides).chain(changed).collect::<Vec<_>>().join(" ")
}

/// Formats an analysis setting as a command-line option.
fn option(name: &str, value: &str) -> String {
    format!("--{} {}", name.replace('_', "-"), word(value))
}

/// Formats the overridden analysis settings.
pub fn options(run: &Run) -> String {
    let options = objects(&run.head["overrides"]).map(|(name, value)| option(name, &shown(value)));
    options.collect::<Vec<_>>().join(" ")
}

/// Formats a `calyx` subcommand with the model and the params that are not at their defaults.
pub fn subcommand(name: &str, run: &Run) -> String {
    let mut words = vec![format!("calyx {name}"), word(run.text("model"))];
    for (name, param) in objects(&run.head["params"]).filter(|(_, param)| changed(param)) {
        let unit = param["display"]["unit"].as_str().unwrap_or_default();
        words.push(format!("--set {}", word(format!("{name}={} {unit}", param_value(param)).trim_end())));
    }
    words.join(" ")
}

/// Returns `true` if a param of `run.json` differs from its default.
pub fn changed(param: &Value) -> bool {
    param["at_default"].as_bool() == Some(false)
}

/// Formats a param as on a command line, without its unit.
pub fn param_value(param: &Value) -> String {
    let value = if param["display"].is_null() { &param["value"] } else { &param["display"]["value"] };
    match value {
        Value::Bool(truth) => (if *truth { "TRUE" } else { "FALSE" }).into(),
        Value::String(text) => text.clone(),
        Value::Number(number) => number.as_f64().map_or_else(|| number.to_string(), |n| n.to_string()),
        _ => String::new(),
    }
}

/// Formats a value of `run.json` without quotation marks.
pub fn shown(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}
