//! JSON Schema of a model's params, for editors of `--params` files and for programs that write
//! them.

use crate::params_file::SCHEMA_KEY;
use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue};
use calyx_abi::units::{from_si, shortest, to_si};
use serde_json::{Map, Value, json};

/// Pattern of a number and a unit; the pattern does not check the unit.
const QUANTITY: &str = r"^\s*[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(\s*[^\d\s.].*)?$";

/// Returns the schema (2020-12) to which every file that `--params` accepts conforms. Numbers are
/// in the unit of the param's default, its `x-unit`.
pub fn schema(description: &ModelDescription) -> Value {
    let mut properties = Map::new();
    for param in &description.params {
        let steps: Vec<Step> = steps(&param.name).collect();
        insert(&mut properties, &steps, of_param(param));
    }
    properties.insert(SCHEMA_KEY.into(), json!({ "type": "string" }));
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": format!("Params of {}", description.name),
        "description": description.doc,
        "type": "object",
        "properties": properties,
        "additionalProperties": false,
    })
}

/// A step of a param's name: `stages[0].torque` has the steps `stages`, `0` and `torque`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Step<'n> {
    Name(&'n str),
    Index(usize),
}

fn steps(name: &str) -> impl Iterator<Item = Step<'_>> {
    name.split('.').flat_map(|part| {
        let (name, indices) = part.split_once('[').unwrap_or((part, ""));
        let indices = indices.split('[').filter_map(|index| index.trim_end_matches(']').parse().ok());
        std::iter::once(Step::Name(name)).chain(indices.map(Step::Index))
    })
}

/// Adds a param to the properties of an object; instances of components are objects in it, and
/// arrays of instances are arrays of objects.
fn insert(properties: &mut Map<String, Value>, steps: &[Step], param: Value) {
    let Some((Step::Name(name), rest)) = steps.split_first() else { return };
    let indices = rest.iter().take_while(|step| matches!(step, Step::Index(_))).count();
    let (indices, rest) = rest.split_at(indices);
    if rest.is_empty() {
        properties.insert((*name).into(), param);
        return;
    }
    let mut at = properties.entry(*name).or_insert_with(|| json!({}));
    for index in indices {
        let Step::Index(index) = index else { continue };
        if at.get("prefixItems").is_none() {
            *at = json!({ "type": "array", "prefixItems": [], "items": false });
        }
        let Some(items) = at["prefixItems"].as_array_mut() else { return };
        // Instances without params have no schema of their own.
        while items.len() <= *index {
            items.push(json!({ "type": "object", "properties": {}, "additionalProperties": false }));
        }
        at = &mut items[*index];
    }
    if at.get("properties").is_none() {
        *at = json!({ "type": "object", "properties": {}, "additionalProperties": false });
    }
    if let Some(inner) = at["properties"].as_object_mut() {
        insert(inner, rest, param);
    }
}

fn of_param(param: &ParamDescription) -> Value {
    let mut schema = Map::new();
    let mut add = |key: &str, value: Value| schema.insert(key.into(), value);
    match param.repr {
        Repr::Bool => {
            add("type", json!("boolean"));
        }
        Repr::String => {
            add("type", json!("string"));
            if !param.choices.is_empty() {
                add("enum", json!(param.choices));
            }
        }
        Repr::Array(_) => {
            // A string is the array as in the model, such as `[1, 2] mm`.
            add("type", json!(["array", "string"]));
            add("items", Value::Object(of_number(param)));
        }
        _ => of_number(param).into_iter().for_each(|(key, value)| {
            add(&key, value);
        }),
    }
    if let Some(default) = &param.default {
        let default = match default {
            ParamValue::Bool(truth) => json!(truth),
            ParamValue::String(text) => json!(text),
            ParamValue::Number(si) => number(bound(*si, param)),
            ParamValue::Numbers(all) => all.iter().map(|si| number(bound(*si, param))).collect(),
        };
        add("default", default);
    }
    if matches!(param.repr, Repr::Number | Repr::Array(_)) {
        add("x-unit", json!(param.unit.name));
    }
    let unit = match (&param.repr, param.unit.name.as_str()) {
        (Repr::Number | Repr::Array(_), unit) if !unit.is_empty() => {
            format!("In {unit}, or a string with another unit.")
        }
        _ => String::new(),
    };
    add("description", json!([param.doc.as_str(), &unit].join("\n").trim()));
    Value::Object(schema)
}

/// Returns the properties of a number, or of an element of an array.
fn of_number(param: &ParamDescription) -> Map<String, Value> {
    let mut schema = Map::new();
    let mut add = |key: &str, value: Value| schema.insert(key.into(), value);
    // A string is a quantity with its own unit; bounds apply to numbers only.
    add("type", json!([if param.integral { "integer" } else { "number" }, "string"]));
    add("pattern", json!(QUANTITY));
    // Bounds that depend on other params may differ in a run.
    if let Some(low) = param.low.filter(|_| param.independent) {
        add("minimum", number(bound(low, param)));
    }
    if let Some(high) = param.high.filter(|_| param.independent) {
        add("maximum", number(bound(high, param)));
    }
    schema
}

/// Converts a bound to the unit of the param's default, shortened if that yields the same SI value.
fn bound(si: f64, param: &ParamDescription) -> f64 {
    let factor = param.unit.factor;
    let exact = from_si(si, factor);
    let short = shortest(exact).parse().unwrap_or(exact);
    if to_si(short, factor) == si { short } else { exact }
}

/// Formats whole numbers without `.0`.
fn number(value: f64) -> Value {
    if value.fract() == 0.0 && value.abs() < 1e15 { json!(value as i64) } else { json!(value) }
}
