//! Params files, `--params FILE.json` or `FILE.toml`: names and values with their locations, so
//! that errors point into the file.

use crate::param_assignment::{AssignedValue, Origin, ParamAssignment};
use crate::params::InvalidParam;
use calyx_abi::description::FileDescription;
use serde::Deserializer;
use serde::de::{MapAccess, Visitor};
use serde_json::value::RawValue;
use std::fmt;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Key of JSON files by which editors find the schema; it is not a param.
pub const SCHEMA_KEY: &str = "$schema";

/// Reads the assignments of a file, in its order.
///
/// # Errors
/// The file cannot be read, or is not a table of numbers, texts and Booleans.
pub fn read(path: &Path) -> Result<Vec<ParamAssignment>, InvalidParam> {
    let parse = match path.extension().and_then(|extension| extension.to_str()) {
        Some("json") => json,
        Some("toml") => toml,
        _ => {
            let message = format!("{} is neither a .json nor a .toml file", path.display());
            return Err(InvalidParam::new(
                message,
                "write params as `{\"torque\": 500}` or as `torque = 500`",
            ));
        }
    };
    let bytes = std::fs::read(path).map_err(|error| unreadable(path, &error.to_string()))?;
    let text = String::from_utf8(bytes).map_err(|_| unreadable(path, "it is not UTF-8 text"))?;
    // Windows editors write a byte order mark; neither format allows it.
    let text = text.strip_prefix('\u{feff}').map(str::to_owned).unwrap_or(text);
    parse(&Arc::new(FileDescription { name: path.display().to_string(), text }))
}

/// Parses the text of a JSON file, see [`read`].
///
/// # Errors
/// The text is not an object of params.
pub fn parse_json(file: &Arc<FileDescription>) -> Result<Vec<ParamAssignment>, InvalidParam> {
    json(file)
}

/// Parses the text of a TOML file, see [`read`].
///
/// # Errors
/// The text is not a table of params.
pub fn parse_toml(file: &Arc<FileDescription>) -> Result<Vec<ParamAssignment>, InvalidParam> {
    toml(file)
}

fn unreadable(path: &Path, why: &str) -> InvalidParam {
    InvalidParam::new(format!("cannot read {}: {why}", path.display()), "give the path of a file of params")
}

/// Returns an error at a location of the file.
fn wrong(file: &Arc<FileDescription>, at: Range<usize>, message: String, help: &str) -> InvalidParam {
    let origin = Origin { file: file.clone(), start: at.start, end: at.end };
    InvalidParam { origin: Some(origin), ..InvalidParam::new(message, help) }
}

fn given(
    file: &Arc<FileDescription>,
    name: &str,
    value: AssignedValue,
    at: [Range<usize>; 2],
) -> ParamAssignment {
    let [of_name, of_value] = at.map(|Range { start, end }| Some(Origin { file: file.clone(), start, end }));
    ParamAssignment { name: name.to_owned(), value, name_origin: of_name, origin: of_value }
}

const KINDS: &str = "a param is a number, a text like \"0.5 mm\", true or false, or an array of numbers";

/// Parses names and values of a JSON file, `{"torque": 500}`.
fn json(file: &Arc<FileDescription>) -> Result<Vec<ParamAssignment>, InvalidParam> {
    let text = file.text.as_str();
    let mut reader = serde_json::Deserializer::from_str(text);
    let entries = reader.deserialize_map(Entries).and_then(|entries| reader.end().map(|()| entries));
    let entries = entries.map_err(|error| {
        let at = offset(text, error.line(), error.column());
        // The message without its location, which is reported separately.
        let message = error.to_string();
        let message = message.rsplit_once(" at line ").map_or(message.as_str(), |(message, _)| message);
        let help = "params are one object: `{\"torque\": 500, \"tip_radius\": \"0.5 mm\"}`";
        wrong(file, at..at, format!("the file is not as it should be: {message}"), help)
    })?;
    let mut all: Vec<ParamAssignment> = Vec::new();
    for (name, raw) in entries.into_iter().filter(|(name, _)| name != SCHEMA_KEY) {
        json_entry(file, &name, &name, raw.get(), &mut all)?;
    }
    Ok(all)
}

/// Adds the assignments of an entry. `key` is its name in the file, `name` the name of the param:
/// objects and arrays of objects have the params of the instances of components.
fn json_entry(
    file: &Arc<FileDescription>,
    key: &str,
    name: &str,
    value: &str,
    all: &mut Vec<ParamAssignment>,
) -> Result<(), InvalidParam> {
    let text = file.text.as_str();
    let start = value.as_ptr().addr() - text.as_ptr().addr();
    let of_value = start..start + value.len();
    let before = text[..start].trim_end().trim_end_matches(':').trim_end();
    let of_name = match before.strip_suffix(&format!("\"{key}\"")) {
        Some(rest) => rest.len()..before.len(),
        // An element of an array, or a name with escape sequences.
        None => of_value.clone(),
    };
    // The parts of a valid text are valid.
    let assigned = match value.as_bytes().first() {
        Some(b'{') => {
            let parts =
                serde_json::Deserializer::from_str(value).deserialize_map(Entries).unwrap_or_default();
            return parts.into_iter().try_for_each(|(key, part)| {
                json_entry(file, &key, &format!("{name}.{key}"), part.get(), all)
            });
        }
        Some(b'[') if has_instances(value) => {
            let parts: Vec<&RawValue> = serde_json::from_str(value).unwrap_or_default();
            return parts.into_iter().enumerate().try_for_each(|(index, part)| {
                json_entry(file, "", &format!("{name}[{index}]"), part.get(), all)
            });
        }
        _ => match json_value(value) {
            Ok(value) => value,
            Err(kind) => return Err(wrong(file, of_value, format!("`{name}` is {kind}"), KINDS)),
        },
    };
    if all.iter().any(|known| known.name == name) {
        return Err(wrong(file, of_name, format!("`{name}` is given twice"), "keep one of them"));
    }
    all.push(given(file, name, assigned, [of_name, of_value]));
    Ok(())
}

/// Returns `true` for an object, and for an array of such values.
fn has_instances(value: &str) -> bool {
    match value.as_bytes().first() {
        Some(b'{') => true,
        Some(b'[') => {
            let parts: Vec<&RawValue> = serde_json::from_str(value).unwrap_or_default();
            !parts.is_empty() && parts.iter().all(|part| has_instances(part.get()))
        }
        _ => false,
    }
}

/// Parses the text of a value; returns the kind of one that no param takes.
fn json_value(value: &str) -> Result<AssignedValue, &'static str> {
    Ok(match value.as_bytes().first() {
        Some(b't') => AssignedValue::Bool(true),
        Some(b'f') => AssignedValue::Bool(false),
        Some(b'"') => AssignedValue::String(serde_json::from_str(value).unwrap_or_default()),
        // Parsed as on a command line, to the same bits.
        Some(b'-' | b'0'..=b'9') => AssignedValue::Number(value.parse().unwrap_or(f64::NAN)),
        Some(b'[') => {
            let elements: Vec<&RawValue> = serde_json::from_str(value).map_err(|_| "an array")?;
            let elements = elements.into_iter().map(|element| match json_value(element.get())? {
                AssignedValue::List(_) => Err("an array of arrays"),
                element => Ok(element),
            });
            AssignedValue::List(elements.collect::<Result<_, _>>()?)
        }
        Some(b'{') => return Err("an object"),
        _ => return Err("null"),
    })
}

/// Returns the byte offset of a line and column, both counted from 1, the column in bytes.
fn offset(text: &str, line: usize, column: usize) -> usize {
    let begin: usize = text.split_inclusive('\n').take(line.saturating_sub(1)).map(str::len).sum();
    let mut at = (begin + column.saturating_sub(1)).min(text.len());
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// Names of an object and the texts of their values.
struct Entries;

impl<'de> Visitor<'de> for Entries {
    type Value = Vec<(String, &'de RawValue)>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("an object of params")
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Self::Value, A::Error> {
        let mut entries = Vec::new();
        while let Some(entry) = map.next_entry()? {
            entries.push(entry);
        }
        Ok(entries)
    }
}

/// Parses names and values of a TOML file, `torque = 500`.
fn toml(file: &Arc<FileDescription>) -> Result<Vec<ParamAssignment>, InvalidParam> {
    let table = DeTable::parse(&file.text).map_err(|error| {
        let help = "write a param a line: `torque = 500`, `tip_radius = \"0.5 mm\"`";
        wrong(
            file,
            error.span().unwrap_or(0..0),
            format!("the file is not as it should be: {}", error.message()),
            help,
        )
    })?;
    toml_assignments(file, table.into_inner())
}

/// Returns the assignments of a table of a TOML file, in the order of the file.
///
/// # Errors
/// A value is not one of a param, or a param is given twice.
pub(crate) fn toml_assignments(
    file: &Arc<FileDescription>,
    table: DeTable<'_>,
) -> Result<Vec<ParamAssignment>, InvalidParam> {
    let mut all: Vec<ParamAssignment> = Vec::new();
    for (name, value) in table {
        toml_entry(file, name.as_ref(), name.span(), value, &mut all)?;
    }
    // The table is sorted by name; errors are reported in the order of the file.
    all.sort_by_key(|given| given.origin.as_ref().map(|origin| origin.start));
    Ok(all)
}

/// Adds the assignments of an entry. Tables and arrays of tables have the params of the instances
/// of components.
fn toml_entry(
    file: &Arc<FileDescription>,
    name: &str,
    of_name: Range<usize>,
    value: Spanned<DeValue>,
    all: &mut Vec<ParamAssignment>,
) -> Result<(), InvalidParam> {
    let of_value = value.span();
    match value.into_inner() {
        DeValue::Table(table) => table.into_iter().try_for_each(|(key, value)| {
            toml_entry(file, &format!("{name}.{}", key.as_ref()), key.span(), value, all)
        }),
        DeValue::Array(parts) if !parts.is_empty() && parts.iter().all(holds_instances) => {
            parts.into_iter().enumerate().try_for_each(|(index, part)| {
                let at = part.span();
                toml_entry(file, &format!("{name}[{index}]"), at, part, all)
            })
        }
        other => {
            let assigned = toml_value(other)
                .map_err(|kind| wrong(file, of_name.clone(), format!("`{name}` is {kind}"), KINDS))?;
            if all.iter().any(|known| known.name == name) {
                return Err(wrong(file, of_name, format!("`{name}` is given twice"), "keep one of them"));
            }
            all.push(given(file, name, assigned, [of_name, of_value]));
            Ok(())
        }
    }
}

/// Returns `true` for a table, and for an array of such values.
fn holds_instances(value: &Spanned<DeValue>) -> bool {
    match value.as_ref() {
        DeValue::Table(_) => true,
        DeValue::Array(parts) => !parts.is_empty() && parts.iter().all(holds_instances),
        _ => false,
    }
}

/// Converts a value; returns the kind of one that no param takes.
pub(crate) fn toml_value(value: DeValue<'_>) -> Result<AssignedValue, &'static str> {
    Ok(match value {
        DeValue::Boolean(truth) => AssignedValue::Bool(truth),
        DeValue::String(text) => AssignedValue::String(text.into_owned()),
        DeValue::Float(number) => AssignedValue::Number(number.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Integer(number) if number.radix() == 10 => {
            AssignedValue::Number(number.as_str().parse().unwrap_or(f64::NAN))
        }
        DeValue::Integer(number) => {
            let whole = i64::from_str_radix(number.as_str(), number.radix());
            AssignedValue::Number(whole.map_or(f64::NAN, |whole| whole as f64))
        }
        DeValue::Array(elements) => {
            let elements = elements.into_iter().map(|element| match toml_value(element.into_inner())? {
                AssignedValue::List(_) => Err("an array of arrays"),
                element => Ok(element),
            });
            AssignedValue::List(elements.collect::<Result<_, _>>()?)
        }
        DeValue::Datetime(_) => return Err("a date"),
        DeValue::Table(_) => return Err("a table"),
    })
}
