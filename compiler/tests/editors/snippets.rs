//! Checks that snippets with their default texts are valid Calyx in the layout of `calyx fmt`.

use super::read;
use calyx_lang::format::format;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use serde_json::{Map, Value};
use std::collections::BTreeMap;

/// Snippet with the texts of its placeholders.
struct Expansion<'a> {
    rest: &'a str,
    /// Texts by number of the placeholder; one without a text repeats an earlier one.
    places: BTreeMap<&'a str, String>,
}

impl<'a> Expansion<'a> {
    fn of(body: &str) -> String {
        // A placeholder may be repeated before its definition.
        let mut first = Expansion { rest: body, places: BTreeMap::new() };
        let _ = first.text(false);
        Expansion { rest: body, places: first.places }.text(false)
    }

    /// Expands up to the brace that closes a placeholder, or to the end.
    fn text(&mut self, inside: bool) -> String {
        let mut out = String::new();
        while let Some(character) = self.rest.chars().next() {
            if inside && character == '}' {
                break;
            }
            self.rest = &self.rest[character.len_utf8()..];
            match character {
                '$' => out += &self.place(),
                '\\' => {
                    out.extend(self.rest.chars().next());
                    self.rest = self.rest.get(1..).unwrap_or_default();
                }
                _ => out.push(character),
            }
        }
        out
    }

    fn number(&mut self) -> &'a str {
        let end = self.rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(self.rest.len());
        let (number, rest) = self.rest.split_at(end);
        self.rest = rest;
        number
    }

    /// Expands a placeholder after its dollar sign: `1`, `{1:text}` or `{1|one,other|}`.
    fn place(&mut self) -> String {
        let Some(rest) = self.rest.strip_prefix('{') else {
            let number = self.number();
            return self.places.get(number).cloned().unwrap_or_default();
        };
        self.rest = rest;
        let number = self.number();
        let text = if let Some(choices) = self.rest.strip_prefix('|') {
            let (list, rest) = choices.split_once("|}").expect("choices end");
            self.rest = rest;
            list.split(',').next().unwrap_or_default().to_owned()
        } else {
            self.rest = self.rest.strip_prefix(':').expect("a place has a text");
            let text = self.text(true);
            self.rest = self.rest.strip_prefix('}').expect("a place ends");
            text
        };
        self.places.insert(number, text.clone());
        text
    }
}

/// Adds an empty statement where the snippet leaves a line to the user.
fn filled(text: &str) -> String {
    let fill = |line: &str| {
        let blank = !line.is_empty() && line.trim().is_empty();
        format!("{line}{}\n", if blank { ";" } else { "" })
    };
    text.trim_end().split('\n').map(fill).collect()
}

/// Returns prefixes and text of each snippet.
fn snippets() -> BTreeMap<String, (Vec<String>, String)> {
    let all: Map<String, Value> = serde_json::from_str(&read("vscode/snippets/calyx.json")).expect("JSON");
    let words = |value: &Value| match value {
        Value::Array(items) => items.iter().map(|item| item.as_str().expect("text").to_owned()).collect(),
        other => vec![other.as_str().expect("text").to_owned()],
    };
    all.into_iter()
        .map(|(name, snippet)| {
            (name, (words(&snippet["prefix"]), Expansion::of(&words(&snippet["body"]).join("\n"))))
        })
        .collect()
}

#[test]
fn every_snippet_is_calyx_in_the_layout_of_all_models() {
    for (name, (_, text)) in snippets() {
        let text = filled(&text);
        let (_, diagnostics) = parse(FileId(0), &text);
        assert!(diagnostics.is_empty(), "{name}:\n{text}\n{diagnostics:?}");
        assert_eq!(format(&text).ok().as_deref(), Some(text.as_str()), "{name}");
    }
}

#[test]
fn every_snippet_is_reached_by_a_word_of_its_own() {
    let mut seen = BTreeMap::new();
    for (name, (prefixes, _)) in snippets() {
        for prefix in prefixes {
            if let Some(other) = seen.insert(prefix.clone(), name.clone()) {
                panic!("`{prefix}` is both {name} and {other}");
            }
        }
    }
}

#[test]
fn the_gear_pair_is_a_model_without_errors() {
    let (_, text) = &snippets()["Gear pair"];
    let checked = calyx::check_text("gear_pair.cx", text);
    assert!(checked.diagnostics.is_empty(), "{}", checked.render());
}
