//! Tests of the JSON Schema of params.

use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue, UnitDescription};
use calyx_abi::units::to_si;
use calyx_rt::schema::schema;
use serde_json::{Value, json};

use calyx_abi::quantity::PURE;

fn param(name: &str, repr: Repr, unit: &str, factor: f64) -> ParamDescription {
    ParamDescription {
        name: name.into(),
        doc: "What it is.".into(),
        repr,
        unit: UnitDescription { name: unit.into(), factor, dimension: PURE },
        integral: false,
        choices: Vec::new(),
        default: None,
        low: None,
        high: None,
        independent: true,
    }
}

fn model() -> ModelDescription {
    let tip = ParamDescription {
        default: Some(ParamValue::Number(to_si(0.02, 0.0254))),
        low: Some(to_si(0.005, 0.0254)),
        high: Some(to_si(0.045, 0.0254)),
        ..param("tip", Repr::Number, "inch", 0.0254)
    };
    let steps = ParamDescription {
        integral: true,
        default: Some(ParamValue::Number(32.0)),
        low: Some(2.0),
        ..param("steps", Repr::Number, "", 1.0)
    };
    let kind = ParamDescription {
        choices: vec!["plane".into(), "solid".into()],
        default: Some(ParamValue::String("plane".into())),
        ..param("kind", Repr::String, "", 1.0)
    };
    let edges =
        ParamDescription { default: Some(ParamValue::Bool(true)), ..param("edges", Repr::Bool, "", 1.0) };
    ModelDescription { params: vec![tip, steps, kind, edges], ..ModelDescription::default() }
}

/// Validates a value against the keywords of the standard that the schema uses.
fn conforms(value: &Value, schema: &Value) -> bool {
    let is = |kind: &str| match kind {
        "integer" => value.as_f64().is_some_and(|number| number.fract() == 0.0),
        "number" => value.is_number(),
        "string" => value.is_string(),
        "boolean" => value.is_boolean(),
        "object" => value.is_object(),
        "array" => value.is_array(),
        other => panic!("{other} is not used here"),
    };
    schema.as_object().unwrap().iter().all(|(keyword, rule)| match keyword.as_str() {
        "type" => {
            rule.as_array().unwrap_or(&vec![rule.clone()]).iter().any(|kind| is(kind.as_str().unwrap()))
        }
        "enum" => rule.as_array().unwrap().contains(value),
        "minimum" => value.as_f64().is_none_or(|number| number >= rule.as_f64().unwrap()),
        "maximum" => value.as_f64().is_none_or(|number| number <= rule.as_f64().unwrap()),
        "pattern" => value
            .as_str()
            .is_none_or(|text| regex_lite::Regex::new(rule.as_str().unwrap()).unwrap().is_match(text)),
        "properties" => value
            .as_object()
            .into_iter()
            .flatten()
            .all(|(name, value)| rule.get(name).is_none_or(|rule| conforms(value, rule))),
        "additionalProperties" => value
            .as_object()
            .is_none_or(|all| all.keys().all(|name| schema["properties"].get(name).is_some())),
        "prefixItems" => value
            .as_array()
            .into_iter()
            .flatten()
            .zip(rule.as_array().unwrap())
            .all(|(value, rule)| conforms(value, rule)),
        "items" => {
            assert_eq!(rule, &json!(false));
            let most = schema["prefixItems"].as_array().unwrap().len();
            value.as_array().is_none_or(|all| all.len() <= most)
        }
        "$schema" | "title" | "description" | "default" | "x-unit" => true,
        other => panic!("{other} is not used here"),
    })
}

#[test]
fn the_schema_is_one_and_takes_what_params_take() {
    let schema = schema(&model());
    for (file, valid) in [
        (json!({}), true),
        (json!({ "tip": 0.005, "steps": 32, "kind": "solid", "edges": false }), true),
        (json!({ "$schema": "params.schema.json", "tip": "0.5 mm" }), true),
        (json!({ "tip": " 5e-1mm " }), true),
        (json!({ "tip": "10 / inch" }), true),
        (json!({ "tip": ".5" }), true),
        (json!({ "steps": "3" }), true),
        (json!({ "tip": 0.0049 }), false),
        (json!({ "tip": 0.046 }), false),
        (json!({ "tip": "wide" }), false),
        (json!({ "tip": true }), false),
        (json!({ "steps": 2.5 }), false),
        (json!({ "steps": 1 }), false),
        (json!({ "kind": "round" }), false),
        (json!({ "kind": 3 }), false),
        (json!({ "edges": "TRUE" }), false),
        (json!({ "tips": 0.02 }), false),
        (json!([]), false),
    ] {
        assert_eq!(conforms(&file, &schema), valid, "{file}");
    }
}

#[test]
fn instances_are_nested() {
    let params = ["low.torque", "stages[0].torque", "stages[1].pinion.speed"];
    let params = params.map(|name| param(name, Repr::Number, "N*m", 1.0)).to_vec();
    let schema = schema(&ModelDescription { params, ..ModelDescription::default() });
    for (file, valid) in [
        (json!({ "low": { "torque": 5 }, "stages": [{ "torque": "3 N*m" }] }), true),
        (json!({ "stages": [{}, { "pinion": { "speed": 2 } }] }), true),
        (json!({ "stages": [{}, { "pinion": { "speed": true } }] }), false),
        (json!({ "stages": [{}, {}, {}] }), false),
        (json!({ "low": { "torques": 5 } }), false),
        (json!({ "low": 5 }), false),
    ] {
        assert_eq!(conforms(&file, &schema), valid, "{file}");
    }
}

#[test]
fn numbers_are_those_people_wrote() {
    let schema = schema(&model());
    let tip = &schema["properties"]["tip"];
    assert_eq!(
        [&tip["minimum"], &tip["maximum"], &tip["default"]],
        [&json!(0.005), &json!(0.045), &json!(0.02)]
    );
    assert_eq!((&tip["x-unit"], &schema["properties"]["steps"]["default"]), (&json!("inch"), &json!(32)));
    assert_eq!(tip["description"], "What it is.\nIn inch, or a string with another unit.");
}
