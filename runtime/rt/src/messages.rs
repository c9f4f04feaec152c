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

#[cfg(test)]
mod tests {
    use super::*;
    use calyx_abi::description::CallDescription;

    #[test]
    fn control_characters_of_the_source_do_not_reach_the_terminal() {
        let text = "var a = \"\u{1b}]0;title\u{7}\"; a[3];\n";
        let file = FileDescription { name: "\u{1b}[2Jm.cx".into(), text: text.into() };
        let description = ModelDescription { files: [file].into(), ..ModelDescription::default() };
        let place = Some((0, 22, 26));
        let error =
            RuntimeError { place, ..RuntimeError::new("E0701", "\u{1b}[31mindex 3", "\u{9b}2J less") };
        let shown = problem(Severity::Error, &error, &description);
        let expected = "error[E0701]: ␛[31mindex 3\n  --> ␛[2Jm.cx:1:23\n   |\n 1 | var a = \"␛]0;title␇\"; a[3];\n   |                       ^^^^\n  help: \u{fffd}2J less\n";
        assert_eq!(shown, expected);
        let why = InvalidParam::new("no param `\u{1b}[31m`", "\u{202e}");
        assert_eq!(refused(&why), "error: no param `␛[31m`\n  help: \u{fffd}\n");
    }

    #[test]
    fn the_line_is_shown_and_marked() {
        let description = ModelDescription {
            files: [FileDescription { name: "m.cx".into(), text: "var é = 1;\n\tprint(é[3]);\n".into() }]
                .into(),
            ..ModelDescription::default()
        };
        let error =
            RuntimeError { place: Some((0, 22, 23)), ..RuntimeError::new("E0701", "index 3", "less") };
        let expected = "error[E0701]: index 3\n  --> m.cx:2:10\n   |\n 2 | \tprint(é[3]);\n   | \t        ^\n  help: less\n";
        assert_eq!(problem(Severity::Error, &error, &description), expected);
        let mut called = error.clone();
        called.passed("f", (0, 13, 18));
        assert_eq!(
            problem(Severity::Error, &called, &description),
            format!("{expected}  in `f`, called at m.cx:2:2\n")
        );
        // An error about an argument is located at the argument, and a warning has the code of a
        // warning.
        let calls = vec![CallDescription {
            place: (0, 13, 24),
            arguments: vec![("x".into(), (0, 22, 23))],
            carried: Vec::new(),
            function: String::new(),
        }];
        let blamed = RuntimeError { place: Some((0, 13, 24)), ..error.clone().of_argument("x") };
        let description = ModelDescription { calls, ..description };
        let warning = expected.replacen("error[E", "warning[W", 1);
        assert_eq!(problem(Severity::Warning, &blamed, &description), warning);
        // A location outside of the file is omitted.
        let nowhere = RuntimeError { place: Some((0, 400, 401)), ..error };
        assert_eq!(problem(Severity::Error, &nowhere, &description), "error[E0701]: index 3\n  help: less\n");
    }
}
