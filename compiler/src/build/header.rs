//! C header of a model: the functions of the runtime, and the model's table, params and outputs
//! with their doc comments.

use calyx_abi::Repr;
use calyx_abi::description::{ModelDescription, ParamDescription, ParamValue};
use calyx_codegen::model_symbol;
use calyx_rt::c_api::HEADER;
use calyx_rt::params::{domain, shown, shown_list};
use std::fmt::Write;

/// Returns the whole header of a model called `name` in C.
pub(super) fn header(name: &str, description: &ModelDescription) -> String {
    let symbol = model_symbol(name);
    let mut text = String::from(HEADER);
    let doc = match description.doc.as_str() {
        "" => format!("The model {name}."),
        doc => doc.to_owned(),
    };
    text += &format!("\n#ifndef CALYX_MODEL_{name}\n#define CALYX_MODEL_{name}\n\n");
    text += "#ifdef __cplusplus\nextern \"C\" {\n#endif\n\n";
    text += &comment(&doc, "");
    text += &format!("extern const calyx_model {symbol};\n\n");

    let params = description.params.iter().map(|param| (&*param.name, about_param(param)));
    text += &comment("The model's params, as calyx_param_at counts them.", "");
    text += &enumeration(name, "param", params);
    text.push('\n');
    let outputs = description.outputs.iter().map(|output| {
        let choices = output.choices.iter().enumerate().map(|(index, choice)| format!("{index} {choice}"));
        let unit = match output.unit.name.as_str() {
            _ if !output.choices.is_empty() => {
                format!("The number of a choice: {}.", choices.collect::<Vec<_>>().join(", "))
            }
            "" => "A pure number.".into(),
            unit => format!("In {unit}."),
        };
        (&*output.name, joined(&output.doc, &unit))
    });
    text += &comment("The model's outputs, as calyx_output and calyx_summarize take them.", "");
    text += &enumeration(name, "output", outputs);
    text += "\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n";
    text
}

/// Returns an enumeration of all params, for example: `NAME_param`, and their number,
/// `NAME_params`.
fn enumeration<'d>(name: &str, kind: &str, members: impl Iterator<Item = (&'d str, String)>) -> String {
    let mut text = format!("enum {name}_{kind} {{\n");
    let mut words: Vec<String> = Vec::new();
    for (index, (member, about)) in members.enumerate() {
        let mut word = super::c_letters(member);
        // The original names may differ only in characters that C identifiers do not have.
        if words.contains(&word) {
            let _ = write!(word, "_{index}");
        }
        text += &comment(&about, "    ");
        let _ = writeln!(text, "    {name}_{kind}_{word} = {index},");
        words.push(word);
    }
    let _ = writeln!(text, "    {name}_{kind}s = {}\n}};", words.len());
    text
}

fn about_param(param: &ParamDescription) -> String {
    let kind = match &param.repr {
        Repr::Bool => "TRUE or FALSE".to_owned(),
        Repr::String => match domain(param, None, None) {
            choices if choices.is_empty() => "A text".into(),
            choices => choices,
        },
        Repr::Array(_) => match domain(param, param.low, param.high) {
            range if range.is_empty() => format!("An array of numbers {}", param.unit.name).trim_end().into(),
            range => format!("An array of numbers, each {range}"),
        },
        _ => match domain(param, param.low, param.high) {
            range if range.is_empty() && param.unit.name.is_empty() => "Any number".into(),
            range if range.is_empty() => format!("Any number of {}", param.unit.name),
            range => range,
        },
    };
    let default = match &param.default {
        Some(ParamValue::Number(si)) => format!("; default {}", shown(param, *si)),
        Some(ParamValue::Bool(value)) => format!("; default {}", if *value { "TRUE" } else { "FALSE" }),
        Some(ParamValue::String(value)) => format!("; default \"{value}\""),
        Some(ParamValue::Numbers(values)) => format!("; default {}", shown_list(param, values)),
        None => String::new(),
    };
    joined(&param.doc, &format!("{kind}{default}."))
}

fn joined(doc: &str, more: &str) -> String {
    if doc.is_empty() { more.into() } else { format!("{doc}\n{more}") }
}

/// Formats a C comment. Separates comment delimiters in the text.
fn comment(text: &str, indent: &str) -> String {
    // Twice, because `*/*/` and the like leave one delimiter.
    let apart = |text: String| text.replace("*/", "* /").replace("/*", "/ *");
    let text = apart(apart(text.trim().to_owned()));
    let lines: Vec<&str> = text.lines().map(str::trim_end).collect();
    format!("{indent}/* {} */\n", lines.join(&format!("\n{indent}   ")))
}

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_abi::description::{OutputDescription, UnitDescription};

    #[test]
    fn comments_stay_comments() {
        assert_eq!(comment("one\ntwo", "  "), "  /* one\n     two */\n");
        assert_eq!(comment("a */ b /* c /*/ d", ""), "/* a * / b / * c / * / d */\n");
    }

    #[test]
    fn a_model_without_anything_has_enumerations() {
        let text = header("m", &ModelDescription::default());
        assert!(text.contains("extern const calyx_model m_model;"), "{text}");
        assert!(text.contains("enum m_param {\n    m_params = 0\n};"), "{text}");
    }

    #[test]
    fn names_that_c_cannot_tell_apart_get_numbers() {
        let output = |name: &str| OutputDescription {
            name: name.into(),
            doc: "What it is.".into(),
            site: 0,
            unit: UnitDescription { name: "N".into(), factor: 1.0, ..UnitDescription::default() },
            si: "N".into(),
            is_array: false,
            choices: Vec::new(),
        };
        let outputs = vec![output("é"), output("è")];
        let text = header("m", &ModelDescription { outputs, ..ModelDescription::default() });
        let expected = "enum m_output {\n    /* What it is.\n       In N. */\n    m_output__ = 0,\n    /* What it is.\n       \
                        In N. */\n    m_output___1 = 1,\n    m_outputs = 2\n};";
        assert!(text.contains(expected), "{text}");
    }
}
