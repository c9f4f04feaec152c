//! Renders diagnostics as text with source lines, or as JSON objects, one per line.

use crate::diagnostic::{Diagnostic, Label as Note, Severity};
use crate::ir::SourceFile;
use crate::span::{FileId, Span};
use ariadne::{Cache, Color, Config, IndexType, Label, Report, ReportKind, Source};
use calyx_abi::error::call_lines;
use calyx_abi::visible::visible;
use serde_json::{Value, json};
use std::borrow::Cow;
use std::cell::OnceCell;

/// Determines whether the text contains terminal colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Colour {
    #[default]
    Never,
    Always,
}

/// Renders diagnostics with the source lines they refer to.
pub struct Renderer<'a> {
    files: Files<'a>,
    colour: Colour,
}

impl<'a> Renderer<'a> {
    /// Creates a renderer. `files` are the files of the spans, by index.
    pub fn new(files: &'a [SourceFile], colour: Colour) -> Self {
        let sources = files.iter().map(|_| OnceCell::new()).collect();
        Renderer { files: Files { files, sources }, colour }
    }

    /// Renders one diagnostic, including a final line end.
    pub fn text(&mut self, diagnostic: &Diagnostic) -> String {
        let diagnostic = &shown(diagnostic);
        let text = if self.has_long_line(diagnostic) {
            self.without_source(diagnostic)
        } else {
            self.with_source(diagnostic)
        };
        text + &self.calls(diagnostic)
    }

    fn with_source(&mut self, diagnostic: &Diagnostic) -> String {
        let (kind, colour_of_primary) = match diagnostic.severity {
            Severity::Error => (ReportKind::Error, Color::Red),
            Severity::Warning => (ReportKind::Warning, Color::Yellow),
        };
        let config =
            Config::default().with_index_type(IndexType::Byte).with_color(self.colour == Colour::Always);
        let files = self.files.files;
        let primary = shown_place(diagnostic.primary.span, files);
        let main = Label::new(primary.clone())
            .with_message(&diagnostic.primary.message)
            .with_color(colour_of_primary);
        let mut report = Report::build(kind, primary)
            .with_config(config)
            .with_code(&diagnostic.code)
            .with_message(&diagnostic.message)
            .with_label(main);
        for label in &diagnostic.labels {
            let place = shown_place(label.span, files);
            report =
                report.with_label(Label::new(place).with_message(&label.message).with_color(Color::Blue));
        }
        if let Some(help) = &diagnostic.help {
            report = report.with_help(help);
        }
        let mut out = Vec::new();
        match (report.finish().write(&mut self.files, &mut out), String::from_utf8(out)) {
            (Ok(()), Ok(text)) => text,
            // Writing to memory does not fail, but the message must reach the user in any case.
            _ => format!("{}: {}\n", diagnostic.code, diagnostic.message),
        }
    }
}

/// Limit of the displayed characters of a source line. Without it, every error in a very long line
/// would repeat the line.
const LONGEST_LINE: usize = 1000;

impl Renderer<'_> {
    /// Renders the call stack of a run-time error, one line per call.
    fn calls(&self, diagnostic: &Diagnostic) -> String {
        let lines = call_lines(&diagnostic.calls, |(file, start, end)| {
            let (file, text) = file_of(FileId(file), self.files.files);
            let (line, column) = line_column(text, clipped(Span { file: FileId(0), start, end }, text).0);
            format!("{}:{line}:{column}", visible(file))
        });
        lines.into_iter().map(|line| format!("    {line}\n")).collect()
    }

    fn has_long_line(&self, diagnostic: &Diagnostic) -> bool {
        std::iter::once(&diagnostic.primary).chain(&diagnostic.labels).any(|note| {
            let Some(text) = self.files.files.get(note.span.file.0 as usize).map(|file| &file.text) else {
                return false;
            };
            let (start, end) = clipped(note.span, text);
            let before = text[..start].rfind('\n').map_or(0, |at| at + 1);
            let after = text[end..].find('\n').map_or(text.len(), |at| end + at);
            text[before..after].split('\n').any(|line| line.len() > LONGEST_LINE)
        })
    }

    fn without_source(&self, diagnostic: &Diagnostic) -> String {
        let kind = match diagnostic.severity {
            Severity::Error => "Error",
            Severity::Warning => "Warning",
        };
        let place = place_json(diagnostic.primary.span, self.files.files);
        let [file, line, column] = ["file", "line", "column"].map(|key| match &place[key] {
            Value::String(text) => visible(text).into_owned(),
            other => other.to_string(),
        });
        let help = diagnostic.help.as_ref().map(|help| format!("    Help: {help}\n")).unwrap_or_default();
        format!(
            "[{}] {kind}: {}\n    at {file}:{line}:{column}: {}\n{help}",
            diagnostic.code, diagnostic.message, diagnostic.primary.message
        )
    }
}

/// The source files in the interface of the report writer: by index, with display names.
struct Files<'a> {
    files: &'a [SourceFile],
    /// The lines of each file that a diagnostic refers to.
    sources: Vec<OnceCell<Source<Cow<'a, str>>>>,
}

impl<'f> Cache<usize> for Files<'f> {
    type Storage = Cow<'f, str>;

    fn fetch(&mut self, id: &usize) -> Result<&Source<Self::Storage>, impl std::fmt::Debug> {
        let (file, source) = self.files.get(*id).zip(self.sources.get(*id)).ok_or("no such file")?;
        Ok::<_, &str>(source.get_or_init(|| Source::from(visible(&file.text))))
    }

    fn display<'a>(&self, id: &'a usize) -> Option<impl std::fmt::Display + 'a> {
        self.files.get(*id).map(|f| visible(&f.name).into_owned())
    }
}

/// Returns the diagnostic without control characters in its messages.
fn shown(diagnostic: &Diagnostic) -> Diagnostic {
    let mut shown = diagnostic.clone();
    let notes = std::iter::once(&mut shown.primary).chain(&mut shown.labels);
    let messages = notes.map(|note| &mut note.message).chain(shown.help.as_mut());
    for message in messages.chain([&mut shown.message]) {
        *message = visible(message).into_owned();
    }
    for call in &mut shown.calls {
        call.function = visible(&call.function).into_owned();
    }
    shown
}

/// Returns the byte range of a span in the text as displayed, and the index of the file.
fn shown_place(span: Span, files: &[SourceFile]) -> (usize, std::ops::Range<usize>) {
    let (file, range) = place(span, files);
    let text = files.get(file).map_or("", |f| f.text.as_str());
    // A `\r` directly before `\n` is preserved.
    let shown = |byte: usize| match text[..byte].strip_suffix('\r') {
        Some(before) if text[byte..].starts_with('\n') => visible(before).len() + 1,
        _ => visible(&text[..byte]).len(),
    };
    match visible(text) {
        Cow::Borrowed(_) => (file, range),
        Cow::Owned(_) => (file, shown(range.start)..shown(range.end)),
    }
}

/// Returns the byte range of a span and the index of its file. The range is clipped to the text, so
/// that an outdated span cannot cause a panic.
fn place(span: Span, files: &[SourceFile]) -> (usize, std::ops::Range<usize>) {
    let file = span.file.0 as usize;
    let text = files.get(file).map_or("", |f| f.text.as_str());
    let (start, end) = clipped(span, text);
    (file, start..end)
}

fn clipped(span: Span, text: &str) -> (usize, usize) {
    let boundary = |byte: u32| {
        let mut byte = (byte as usize).min(text.len());
        while !text.is_char_boundary(byte) {
            byte -= 1;
        }
        byte
    };
    let start = boundary(span.start);
    (start, boundary(span.end).max(start))
}

/// Returns a diagnostic as a JSON object on one line, without the line end.
///
/// `{severity, code, message, primary: {file, line, column, byte_start, byte_end, message}, labels:
/// [...], help, fix}`. Lines and columns count from 1, columns in characters. `help` and `fix` may
/// be null. A run-time error has the call stack, innermost call first, as `calls: [{function, file,
/// line, ...}]`.
pub fn to_json(diagnostic: &Diagnostic, files: &[SourceFile]) -> String {
    let mut value = json!({
        "severity": match diagnostic.severity { Severity::Error => "error", Severity::Warning => "warning" },
        "code": diagnostic.code,
        "message": diagnostic.message,
        "primary": note_json(&diagnostic.primary, files),
        "labels": diagnostic.labels.iter().map(|label| note_json(label, files)).collect::<Vec<_>>(),
        "help": diagnostic.help,
        "fix": diagnostic.fix.as_ref().map(|fix| {
            let mut value = place_json(fix.span, files);
            value["title"] = json!(fix.title);
            value["replacement"] = json!(fix.replacement);
            value
        }),
    });
    if !diagnostic.calls.is_empty() {
        let calls = diagnostic.calls.iter().map(|call| {
            let (file, start, end) = call.place;
            let mut value = place_json(Span { file: FileId(file), start, end }, files);
            value["function"] = json!(call.function);
            value
        });
        value["calls"] = calls.collect();
    }
    value.to_string()
}

fn note_json(note: &Note, files: &[SourceFile]) -> Value {
    let mut value = place_json(note.span, files);
    value["message"] = json!(note.message);
    value
}

fn place_json(span: Span, files: &[SourceFile]) -> Value {
    let (name, text) = file_of(span.file, files);
    let (start, end) = clipped(span, text);
    let (line, column) = line_column(text, start);
    json!({ "file": name, "line": line, "column": column, "byte_start": start, "byte_end": end })
}

fn file_of(file: FileId, files: &[SourceFile]) -> (&str, &str) {
    files.get(file.0 as usize).map_or(("", ""), |f| (f.name.as_str(), f.text.as_str()))
}

/// Returns the line and the column of a byte position. Both count from 1, columns in characters.
pub fn line_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    (before.bytes().filter(|b| *b == b'\n').count() + 1, before[line_start..].chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn files() -> Vec<SourceFile> {
        vec![
            SourceFile { name: "model.cx".into(), text: "// Größe µ\nvar é = 1\nvar b = 2;\n".into() },
            SourceFile {
                name: "<library>/gears.cx".into(),
                text: "extern function f(in a: Length);\n".into(),
            },
        ]
    }

    fn sample() -> Diagnostic {
        let end = files()[0].text.find("= 1").unwrap() + 3;
        let library = Span::new(FileId(1), 18, 30);
        let place = Span::new(FileId(0), end, end);
        Diagnostic::error("E0110", "a `;` is missing", place, "the statement ends here")
            .label(library, "declared here")
            .help("end the statement with `;`")
            .fix("insert `;`", place, ";")
    }

    #[test]
    fn text_shows_both_files_and_the_place_in_characters() {
        let files = files();
        let text = Renderer::new(&files, Colour::Never).text(&sample());
        for part in [
            "[E0110]",
            "a `;` is missing",
            "model.cx:2:10",
            "var é = 1",
            "<library>/gears.cx",
            "declared here",
        ] {
            assert!(text.contains(part), "{part} is not in\n{text}");
        }
        assert!(!text.contains('\u{1b}'), "{text}");
        assert!(Renderer::new(&files, Colour::Always).text(&sample()).contains('\u{1b}'));
    }

    #[test]
    fn no_control_character_of_a_source_reaches_the_terminal() {
        let text = "print(\"\u{1b}]0;title\u{7}\", wrong);\r\nnext;\n";
        let files = [SourceFile { name: "a\u{1b}[2J.cx".into(), text: text.into() }];
        let at = text.find("wrong").unwrap();
        let place = Span::new(FileId(0), at, at + 5);
        let mut diagnostic =
            Diagnostic::error("E0201", "`\u{1b}[1m` is unknown", place, "\u{9b}here").help("\rgone");
        let long = SourceFile { name: "a\u{1b}[2J.cx".into(), text: text.to_string() + &"x".repeat(2000) };
        let mut shown = Renderer::new(&files, Colour::Never).text(&diagnostic);
        diagnostic.primary.span = Span::new(FileId(0), text.len(), text.len() + 5);
        shown += &Renderer::new(&[long], Colour::Never).text(&diagnostic);
        assert!(!shown.chars().any(|c| c.is_control() && c != '\n'), "{shown:?}");
        for part in ["a␛[2J.cx:1:21", "␛]0;title␇", "`␛[1m` is unknown", "␍gone"] {
            assert!(shown.contains(part), "{part} is not in\n{shown}");
        }
    }

    #[test]
    fn json_has_lines_and_columns_from_one() {
        let value: Value = serde_json::from_str(&to_json(&sample(), &files())).unwrap();
        assert_eq!(value["severity"], "error");
        let primary = &value["primary"];
        assert_eq!((&primary["line"], &primary["column"]), (&json!(2), &json!(10)));
        assert_eq!(primary["byte_start"], json!(files()[0].text.find("\nvar b").unwrap()));
        assert_eq!(value["labels"][0]["file"], "<library>/gears.cx");
        assert_eq!(value["fix"]["replacement"], ";");
        assert!(value["help"].is_string());
    }

    #[test]
    fn spans_outside_the_text_are_clipped() {
        let mut broken = sample();
        broken.primary.span = Span { file: FileId(0), start: 6, end: 90_000 };
        broken.labels[0].span = Span { file: FileId(9), start: 5, end: 3 };
        let files = files();
        assert!(Renderer::new(&files, Colour::Never).text(&broken).contains("E0110"));
        assert!(to_json(&broken, &files).contains("E0110"));
    }
}
