//! Errors and warnings of a running model as text with the source line, for executables without a
//! compiler. Control characters of the source are replaced by visible symbols.

use crate::param_assignment::Origin;
use crate::params::InvalidParam;
use calyx_abi::RuntimeError;
use calyx_abi::attribution::attribute;
use calyx_abi::description::{FileDescription, LIBRARY, ModelDescription};
use calyx_abi::error::{Place, call_lines, codes};
use calyx_abi::shell;
use calyx_abi::visible::visible;
use calyx_gears::error::Severity;
use serde_json::json;

/// Formats `error[E0670]: ...` with the location, the underlined source line, and the remedy.
pub fn problem(severity: Severity, error: &RuntimeError, description: &ModelDescription) -> String {
    let mut error = error.clone();
    let is_library =
        |file: u32| description.files.get(file as usize).is_some_and(|file| file.name.starts_with(LIBRARY));
    attribute(&mut error, description.calls.iter(), is_library);
    let mut text = match severity {
        Severity::Error => format!("error[{}]: {}\n", error.code, error.message),
        Severity::Warning => format!("warning[{}]: {}\n", error.code.replacen('E', "W", 1), error.message),
    };
    let place = error.place.and_then(|(file, start, end)| {
        excerpt(description.files.get(file as usize)?, start as usize, end as usize)
    });
    text += place.as_deref().unwrap_or_default();
    if !error.help.is_empty() {
        text += &format!("  help: {}\n", error.help);
    }
    if NOT_A_NUMBER.contains(&error.code.as_str()) && error.details.notes.is_empty() {
        let model = shell::word(&description.name);
        text += &format!("  note: with these params, `calyx run {model}` shows the operation it came from\n");
    }
    let shown_place = |(file, start, _): Place| {
        let Some(file) = description.files.get(file as usize) else { return "?".into() };
        let (line, column) = line_column(file, start as usize);
        format!("{}:{line}:{column}", file.name)
    };
    for (place, note) in &error.details.notes {
        text += &format!("  {}: {note}\n", shown_place(*place));
    }
    for line in call_lines(&error.details.calls, shown_place) {
        text += &format!("  {line}\n");
    }
    let instance = &error.details.instance;
    if !instance.is_empty() && error.details.calls.iter().all(|call| call.instance().is_none()) {
        text += &format!("  in `{instance}`\n");
    }
    visible(&text).into_owned()
}

/// Codes of errors that NaN causes: in a frame, an output, an argument. Its origin is found by
/// interpreting the program.
const NOT_A_NUMBER: [&str; 3] = ["E0710", "E0721", codes::NOT_A_NUMBER];

/// Formats `error: ...` with the location in the params file, if there is one, and the remedy.
pub fn refused(refused: &InvalidParam) -> String {
    let mut text = format!("error: {}\n", refused.message);
    let place = refused.origin.as_ref();
    let place = place.and_then(|origin| excerpt(&origin.file, origin.start, origin.end));
    text += place.as_deref().unwrap_or_default();
    if !refused.help.is_empty() {
        text += &format!("  help: {}\n", refused.help);
    }
    visible(&text).into_owned()
}

/// Returns the location as JSON, in the format of diagnostics.
pub fn place_json(origin: &Origin) -> serde_json::Value {
    let Origin { file, start, end } = origin;
    let (line, column) = line_column(file, *start);
    json!({ "file": file.name, "line": line, "column": column, "byte_start": start, "byte_end": end })
}

/// Returns line and column, counted from 1, of a byte of a file.
pub(crate) fn line_column(file: &FileDescription, start: usize) -> (usize, usize) {
    let before = file.text.get(..start).unwrap_or_default();
    (before.matches('\n').count() + 1, before.chars().rev().take_while(|c| *c != '\n').count() + 1)
}

/// Formats `--> file:line:column` and the line with a mark under the bytes from `start` to `end`;
/// `None` if the file is shorter.
fn excerpt(file: &FileDescription, start: usize, end: usize) -> Option<String> {
    let (before, after) = (file.text.get(..start)?, file.text.get(start..)?);
    let number = before.matches('\n').count() + 1;
    let begin = before.rfind('\n').map_or(0, |at| at + 1);
    let line = &file.text[begin..start + after.find('\n').unwrap_or(after.len())];
    let indent = before[begin..].chars().count();
    // A range of several lines is marked to the end of the first one.
    let marked =
        file.text.get(start..end.min(begin + line.len())).map_or(1, |text| text.chars().count().max(1));
    let margin = " ".repeat(number.to_string().len());
    // Tabs are kept, so that the mark is aligned with the text.
    let fill: String = line.chars().take(indent).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
    Some(format!(
        "  --> {}:{number}:{}\n {margin} |\n {number} | {line}\n {margin} | {fill}{}\n",
        file.name,
        indent + 1,
        "^".repeat(marked)
    ))
}
