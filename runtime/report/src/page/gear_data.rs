//! Section "Gear data": the data of gears and meshes as a drawing lists them, one column per gear.

use super::read::{Run, objects};
use crate::directory::GEAR_DATA;
use maud::{Markup, PreEscaped, html};
use serde_json::Value;

/// Largest number of gears side by side.
const MOST_COLUMNS: usize = 6;

pub fn section(run: &Run) -> Markup {
    let data = &run.head[GEAR_DATA];
    let items = |name: &str| data[name].as_array().map(Vec::as_slice).unwrap_or_default();
    let (gears, meshes) = (items("gears"), items("meshes"));
    if gears.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        @for columns in gears.chunks(MOST_COLUMNS) {
            (table(&columns.iter().map(|gear| names(&gear["bodies"])).collect::<Vec<_>>(),
                &columns.iter().map(|gear| &gear["data"]).collect::<Vec<_>>()))
        }
        @if let Some(note) = data["note"].as_str() { p.note { (super::prose(note)) } }
        @for mesh in meshes {
            @let pairs: Vec<&Value> = mesh["bodies"].as_array().into_iter().flatten().collect();
            @let columns: Vec<String> = (0..2).map(|member| first_name(&pairs, member)).collect();
            article {
                h3 { "Mesh of " (columns.join(" and ")) @if pairs.len() > 1 { " (" (pairs.len()) " equal meshes)" } }
                (table(&[String::new()], &[&mesh["data"]]))
                (table(&columns, &mesh["members"].as_array().into_iter().flatten().collect::<Vec<_>>()))
            }
        }
    }
}

pub(super) fn names(bodies: &Value) -> String {
    let names = bodies.as_array().into_iter().flatten().filter_map(Value::as_str);
    names.collect::<Vec<_>>().join(", ")
}

fn first_name(pairs: &[&Value], member: usize) -> String {
    pairs.first().and_then(|pair| pair[member].as_str()).unwrap_or_default().to_owned()
}

/// Shows the entries of one or several columns.
fn table(headings: &[String], columns: &[&Value]) -> Markup {
    html! {
        table.numbers.data {
            thead { tr {
                th { "quantity" } th.word { "symbol" } th.word { "unit" }
                @for heading in headings { th.value { (heading) } }
            } }
            @for group in groups(columns) {
                tbody { @for key in group {
                    @let entry = columns.iter().map(|column| &column[key]).find(|entry| entry.is_object()).unwrap_or(&Value::Null);
                    tr {
                        th scope="row" { (text(&entry["name"])) }
                        td.word { (symbol(text(&entry["symbol"]))) }
                        td.word { (text(&entry["display"]["unit"])) }
                        @for column in columns {
                            td { @match column[key]["display"]["text"].as_str() { Some(value) => (value), None => "–" } }
                        }
                    }
                } }
            }
        }
    }
}

/// Returns the keys of all columns in order, by group. A key that only a later column has follows
/// the key before it.
fn groups<'v>(columns: &[&'v Value]) -> Vec<Vec<&'v str>> {
    let mut keys: Vec<(&str, bool)> = Vec::new();
    for column in columns {
        let mut next = 0;
        for (key, entry) in objects(column) {
            match keys.iter().position(|(known, _)| known == key) {
                Some(index) => next = index + 1,
                None => {
                    keys.insert(next, (key, entry["starts_group"].as_bool().unwrap_or(false)));
                    next += 1;
                }
            }
        }
    }
    let mut groups: Vec<Vec<&str>> = Vec::new();
    for (key, starts) in keys {
        match groups.last_mut().filter(|_| !starts) {
            Some(group) => group.push(key),
            None => groups.push(vec![key]),
        }
    }
    groups
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap_or_default()
}

/// Shows a symbol with Greek letters and subscripts: `epsilon_alpha`.
pub(super) fn symbol(text: &str) -> Markup {
    html! { i {
        @for (index, term) in text.split(' ').enumerate() {
            @if index > 0 { " " }
            @match term.split_once('_') {
                Some((letter, subscript)) => { (greek(letter)) sub { (subscript.split('_').map(subscript_of).collect::<Vec<_>>().join(",")) } },
                None => (if term == "-" { "−" } else { greek(term) }),
            }
        }
    } }
}

/// Replaces the name of a Greek letter within a subscript: `Halpha`.
fn subscript_of(text: &str) -> String {
    let known = ["alpha", "beta", "gamma"].into_iter().find(|name| text.contains(name));
    known.map_or_else(|| greek(text).to_owned(), |name| text.replace(name, greek(name)))
}

fn greek(name: &str) -> &str {
    match name {
        "alpha" => "α",
        "beta" => "β",
        "gamma" => "γ",
        "epsilon" => "ε",
        "zeta" => "ζ",
        "rho" => "ρ",
        "phi" => "φ",
        other => other,
    }
}
