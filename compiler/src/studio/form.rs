//! The form of a model: its params and outputs as JSON.
//!
//! A heading in a doc comment, `/// # Loads`, starts a group: the param below it and all later ones
//! up to the next heading. Params of instances of components are groups of their own.

use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, OutputDescription, ParamDescription, ParamValue};
use calyx_abi::units::{from_si, shortest};
use serde_json::{Value, json};

/// Returns the params in the order of the model.
pub(crate) fn params(description: &ModelDescription) -> Vec<Value> {
    let mut group = String::new();
    let params = description.params.iter().map(|param| {
        let (heading, doc) = heading_and_text(&param.doc);
        let instance = param.name.rsplit_once('.').map(|(instance, _)| instance);
        if let (Some(heading), None) = (&heading, instance) {
            group.clone_from(heading);
        }
        let group = instance.map_or(group.as_str(), |instance| instance);
        of_param(param, group, &doc)
    });
    params.collect()
}

/// Splits a doc comment into its first heading and the other lines.
fn heading_and_text(doc: &str) -> (Option<String>, String) {
    let is_heading = |line: &&str| {
        let marks = line.trim_start().bytes().take_while(|byte| *byte == b'#').count();
        (1..=6).contains(&marks) && line.trim_start()[marks..].starts_with(' ')
    };
    let heading = doc.lines().find(is_heading).map(|line| line.trim().trim_matches('#').trim().to_owned());
    let text: Vec<&str> = doc.lines().filter(|line| !is_heading(line)).collect();
    (heading, text.join("\n").trim().to_owned())
}

fn of_param(param: &ParamDescription, group: &str, doc: &str) -> Value {
    let kind = match &param.repr {
        Repr::Bool => "boolean",
        Repr::String if param.choices.is_empty() => "text",
        Repr::String => "choice",
        Repr::Array(_) => "array",
        _ if param.integral => "integer",
        _ => "number",
    };
    let end = |si: Option<f64>| si.map(|si| displayed(si, param)).filter(|value| value.is_finite());
    json!({
        "name": param.name,
        "group": group,
        "doc": doc,
        "kind": kind,
        "unit": param.unit.name,
        "default": param.default.as_ref().map(|value| text_of(value, param)),
        "low": end(param.low),
        "high": end(param.high),
        "domain": calyx_rt::params::domain(param, param.low, param.high),
        "independent": param.independent,
        "choices": param.choices,
    })
}

/// Returns a value of a param as it is typed, in the unit of the default.
pub(crate) fn text_of(value: &ParamValue, param: &ParamDescription) -> String {
    let number = |si: &f64| shortest(from_si(*si, param.unit.factor));
    match value {
        ParamValue::Bool(truth) => (if *truth { "TRUE" } else { "FALSE" }).to_owned(),
        ParamValue::String(text) => text.clone(),
        ParamValue::Number(si) => number(si),
        ParamValue::Numbers(all) => format!("[{}]", all.iter().map(number).collect::<Vec<_>>().join(", ")),
    }
}

/// Converts to the unit of the default, rounded to the digits that are displayed.
fn displayed(si: f64, param: &ParamDescription) -> f64 {
    let exact = from_si(si, param.unit.factor);
    shortest(exact).parse().unwrap_or(exact)
}

/// Returns the outputs in the order of the model.
pub(crate) fn outputs(description: &ModelDescription) -> Vec<Value> {
    let of_output = |output: &OutputDescription| {
        json!({
            "name": output.name,
            "doc": heading_and_text(&output.doc).1,
            "unit": output.unit.name,
            "factor": output.unit.factor,
            "choices": output.choices,
        })
    };
    description.outputs.iter().map(of_output).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_heading_in_a_doc_comment_starts_a_group() {
        let text = "
            /// Without a group.
            param a = 1;
            /// # Load and speed
            ///
            /// Torque.
            ///
            /// # is no heading of its own
            param torque = 100 N*m in 0 N*m .. 500 N*m;
            param offset = 2 mm;
            /// #no heading
            param n = 3 in 1 .. 5;
            /// # Analysis
            param mesh = \"fine\" in [\"fine\", \"coarse\"];
            param lengths = [1 mm, 2 mm];
            param on = TRUE;
        ";
        let checked = crate::check_text("model.cx", text);
        assert!(checked.program.is_some(), "{}", checked.render());
        let params = params(&checked.description);
        let shown: Vec<String> = params
            .iter()
            .map(|param| {
                let texts =
                    ["name", "group", "kind", "default", "doc"].map(|key| param[key].as_str().unwrap_or("?"));
                texts.join("|")
            })
            .collect();
        assert_eq!(
            shown,
            [
                "a||integer|1|Without a group.",
                "torque|Load and speed|number|100|Torque.",
                "offset|Load and speed|number|2|",
                "n|Load and speed|integer|3|#no heading",
                "mesh|Analysis|choice|fine|",
                "lengths|Analysis|array|[1, 2]|",
                "on|Analysis|boolean|TRUE|",
            ]
        );
        assert_eq!(params[1]["high"], 500.0);
        assert_eq!(params[4]["choices"], json!(["fine", "coarse"]));
    }
}
