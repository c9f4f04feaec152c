//! Bodies of requests.

use super::check::{Form, Values};
use super::error::RequestError;
use axum::body::Bytes;
use axum::http::{HeaderMap, StatusCode, header};
use calyx_abi::description::FileDescription;
use calyx_rt::AssignedValue;
use calyx_rt::params_file::parse_json;
use serde_json::Value;
use std::sync::Arc;

/// Largest number of values of a form.
const MOST_VALUES: usize = 10_000;

/// Parses the JSON body of a request. Forms of other sites cannot send this content type.
///
/// # Errors
/// The content type is not JSON, or the body is malformed.
pub(crate) fn json(headers: &HeaderMap, body: &Bytes) -> Result<Value, RequestError> {
    let kind = headers.get(header::CONTENT_TYPE).and_then(|kind| kind.to_str().ok()).unwrap_or_default();
    if kind.split(';').next().map(str::trim) != Some("application/json") {
        let message = "the content type of the request is not application/json";
        return Err(RequestError::new(StatusCode::UNSUPPORTED_MEDIA_TYPE, message, ""));
    }
    serde_json::from_slice(body)
        .map_err(|error| RequestError::invalid(format!("the body of the request is not JSON: {error}"), ""))
}

/// Parses a form: `{"params": {"torque": "500", "tip_radius": "0.5 mm"}, "settings": {"fidelity":
/// "plane"}}`.
///
/// # Errors
/// The body is another one.
pub(crate) fn form(headers: &HeaderMap, body: &Bytes) -> Result<Form, RequestError> {
    let body = json(headers, body)?;
    let params = texts(&body["params"]).ok_or_else(|| {
        let help = "send {\"params\": {\"NAME\": \"VALUE\"}}, with values as after `--set`";
        RequestError::invalid("the request has no object `params` of texts", help)
    })?;
    let settings = match &body["settings"] {
        Value::Null => Values::new(),
        settings => texts(settings).ok_or_else(|| {
            let help = "send {\"params\": {}, \"settings\": {\"fidelity\": \"plane\"}}";
            RequestError::invalid("`settings` of the request is not an object of texts", help)
        })?,
    };
    Ok(Form { params, settings })
}

/// Returns the entries of an object of texts; `None` for another value.
pub(crate) fn texts(object: &Value) -> Option<Values> {
    let entries = object.as_object().filter(|entries| entries.len() <= MOST_VALUES)?;
    let texts = entries.iter().map(|(name, value)| {
        // The operating system ends an argument of a command at a zero byte.
        let text = value.as_str().filter(|text| !text.contains('\0') && !name.contains('\0'))?;
        Some((name.clone(), text.to_owned()))
    });
    texts.collect()
}

/// Parses a params file, JSON or TOML, as `--params` does. Returns its values as texts of a form.
///
/// # Errors
/// It is not a params file.
pub(crate) fn params_file(name: &str, text: String) -> Result<Values, RequestError> {
    let file = Arc::new(FileDescription { name: name.to_owned(), text });
    let parsed = match name.ends_with(".toml") {
        true => calyx_rt::params_file::parse_toml(&file),
        false => parse_json(&file),
    };
    let given = parsed.map_err(|invalid| RequestError::invalid(invalid.message, invalid.help))?;
    Ok(given.into_iter().map(|given| (given.name, typed(&given.value))).collect())
}

/// Returns a value as it is typed in a form.
fn typed(value: &AssignedValue) -> String {
    match value {
        AssignedValue::Bool(truth) => (if *truth { "TRUE" } else { "FALSE" }).to_owned(),
        AssignedValue::List(all) => format!("[{}]", all.iter().map(typed).collect::<Vec<_>>().join(", ")),
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn params_files_are_values_of_the_form() {
        let json = "{\"torque\": 500, \"tip_radius\": \"0.5 mm\", \"on\": true, \"all\": [1, \"2 mm\"], \"low\": {\"n\": 3}}";
        let toml = "torque = 500\ntip_radius = \"0.5 mm\"\non = true\nall = [1, \"2 mm\"]\nlow.n = 3\n";
        for (name, text) in [("case.json", json), ("case.toml", toml)] {
            let values = params_file(name, text.to_owned()).expect(name);
            let shown: Vec<String> = values.iter().map(|(name, text)| format!("{name}={text}")).collect();
            assert_eq!(
                shown,
                ["all=[1, 2 mm]", "low.n=3", "on=TRUE", "tip_radius=0.5 mm", "torque=500"],
                "{name}"
            );
        }
        assert!(params_file("case.json", "[1".to_owned()).is_err());
    }
}
