//! Diagnostics as data. The stage that finds a problem creates them; [`crate::render`] formats
//! them.

use crate::span::{FileId, Span};
use calyx_abi::error::Call;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    Error,
    Warning,
}

/// A diagnostic. `code` is stable: 01 text and syntax, 02 names, 03 types, 04 dimensions and units,
/// 05 symbolic, 06 gears, 07 run time.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Diagnostic {
    pub severity: Severity,
    /// The code, such as `E0201`. Warnings have separate codes, such as `W0203`.
    pub code: String,
    /// A sentence without a full stop.
    pub message: String,
    /// The location of the problem and its label.
    pub primary: Label,
    pub labels: Vec<Label>,
    /// How to fix the problem.
    pub help: Option<String>,
    /// A change that fixes the problem with certainty.
    pub fix: Option<Fix>,
    /// Changes that may be intended. Editors offer them; they are never applied automatically.
    pub suggestions: Vec<Fix>,
    /// The call stack of a run-time error, innermost call first.
    pub calls: Vec<Call>,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    pub span: Span,
    pub message: String,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// The title of the change in a menu.
    pub title: String,
    pub span: Span,
    pub replacement: String,
}

impl Diagnostic {
    pub fn error(code: &str, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Diagnostic {
            severity: Severity::Error,
            code: code.into(),
            message: message.into(),
            primary: Label { span, message: label.into() },
            labels: Vec::new(),
            help: None,
            fix: None,
            suggestions: Vec::new(),
            calls: Vec::new(),
        }
    }

    pub fn warning(code: &str, message: impl Into<String>, span: Span, label: impl Into<String>) -> Self {
        Diagnostic { severity: Severity::Warning, ..Diagnostic::error(code, message, span, label) }
    }

    /// Converts locations relative to the start of a part of `file` to locations in the file.
    pub(crate) fn moved(&self, file: FileId, by: u32) -> Self {
        let mut moved = self.clone();
        let to = |span: &mut Span| *span = Span { file, start: span.start + by, end: span.end + by };
        to(&mut moved.primary.span);
        moved.labels.iter_mut().for_each(|label| to(&mut label.span));
        moved.fix.iter_mut().chain(&mut moved.suggestions).for_each(|fix| to(&mut fix.span));
        moved
    }

    /// Returns the error for a decimal comma, as in `2,5`; `None` if the two parts do not form a
    /// number.
    pub(crate) fn decimal_comma(span: Span, whole: &str, fraction: &str) -> Option<Self> {
        let is_number = whole.bytes().all(|b| b.is_ascii_digit())
            && fraction.starts_with(|c: char| c.is_ascii_digit())
            && !fraction.contains('.');
        let written = format!("{whole}.{fraction}");
        let message = format!("`{whole},{fraction}` is not one number");
        let problem = Diagnostic::error("E0130", message, span, "a comma separates values");
        is_number
            .then(|| problem.help("use a decimal point").fix(format!("write `{written}`"), span, written))
    }

    pub fn label(mut self, span: Span, message: impl Into<String>) -> Self {
        self.labels.push(Label { span, message: message.into() });
        self
    }

    pub fn help(mut self, help: impl Into<String>) -> Self {
        self.help = Some(help.into());
        self
    }

    pub fn fix(mut self, title: impl Into<String>, span: Span, replacement: impl Into<String>) -> Self {
        self.fix = Some(Fix { title: title.into(), span, replacement: replacement.into() });
        self
    }

    /// Adds a change that may be intended.
    pub fn suggest(mut self, title: impl Into<String>, span: Span, replacement: impl Into<String>) -> Self {
        self.suggestions.push(Fix { title: title.into(), span, replacement: replacement.into() });
        self
    }
}
