//! Documentation of a completion item, computed on request for one item.

use super::item::Subject;
use super::keywords;
use calyx_lang::analysis::{CallParameter, NameKind};
use calyx_lang::db::Database;
use calyx_lang::units::Unit;

/// Returns the documentation of an item's subject as Markdown.
pub fn documentation(database: &Database, subject: &Subject) -> Option<String> {
    match subject {
        Subject::Declaration(place) if place.end == 0 => database.module_doc(&place.file),
        Subject::Declaration(place) => {
            let declaration = database.declaration(place)?;
            let doc = declaration.doc.unwrap_or_default();
            if declaration.kind == NameKind::Field && doc.is_empty() {
                return None;
            }
            Some(format!("```cx\n{}\n```\n\n{doc}", declaration.header).trim_end().to_string())
        }
        Subject::Parameter(place, name) => {
            let callable = database.callable(place)?;
            let parameter = callable.parameters.iter().find(|parameter| *parameter.name == **name)?;
            let text = parameter_text(parameter);
            (!text.is_empty()).then_some(text)
        }
        Subject::Builtin(name) => {
            let callable = database.builtin(name)?;
            callable.doc
        }
        Subject::Keyword(word) => keywords::documentation(word).map(str::to_string),
        Subject::Unit(name) => {
            let unit = Unit::find(name).filter(|unit| !unit.aliases.is_empty())?;
            Some(format!(
                "Also written {}.",
                unit.aliases.iter().map(|alias| format!("`{alias}`")).collect::<Vec<_>>().join(", ")
            ))
        }
    }
}

/// Describes a parameter with its default and range.
pub fn parameter_text(parameter: &CallParameter) -> String {
    let mut parts = Vec::new();
    if let Some(doc) = parameter.doc.as_deref().filter(|doc| !doc.is_empty()) {
        parts.push(doc.to_string());
    }
    let mut facts = Vec::new();
    if let Some(default) = &parameter.default {
        facts.push(format!("default `{default}`"));
    }
    if let Some(range) = &parameter.range {
        facts.push(format!("in `{range}`"));
    }
    if !parameter.choices.is_empty() {
        let choices: Vec<String> = parameter.choices.iter().map(|choice| format!("`\"{choice}\"`")).collect();
        facts.push(format!("one of {}", choices.join(", ")));
    }
    if !facts.is_empty() {
        parts.push(facts.join("; "));
    }
    parts.join("\n\n")
}
