//! Code actions at a cursor: quick fixes and rewrites, one file per kind.
//!
//! A quick fix resolves a diagnostic; it is preferred if the compiler is certain of it. A rewrite
//! preserves the meaning of the program.

mod arguments;
mod convert;
mod declare;
mod extract;
mod fixes;
mod formats;
mod import;
mod outputs;
mod symbolic;
mod units;
mod unused;
mod vectors;

use super::enclosing::EnclosingNodes;
use super::problems;
use super::{Edit, Snapshot};
use calyx_lang::db::Parsed;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::span::Span;
use calyx_lang::units::UnitSystem;
use std::ops::Range;
use std::sync::Arc;

pub use fixes::fix_all;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ActionKind {
    /// Resolves a diagnostic.
    QuickFix,
    /// Changes the program without changing its meaning.
    Rewrite,
    Extract,
    Inline,
    /// All certain fixes of a file.
    FixAll,
}

/// A code action.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// Title in menus.
    pub title: String,
    pub kind: ActionKind,
    /// True for the default among several actions.
    pub preferred: bool,
    pub edits: Vec<Edit>,
    /// Code and range of the diagnostic that it resolves.
    pub resolves: Option<(String, Range<u32>)>,
}

/// A range of a file with the results of its analysis.
struct ActionRequest<'a> {
    snapshot: &'a Snapshot,
    file: Arc<str>,
    range: Range<u32>,
    text: &'a str,
    tree: Arc<Parsed>,
    /// Diagnostics of the whole file.
    problems: Vec<Diagnostic>,
}

/// Returns the actions for a range of a file, the most likely first.
pub fn actions(snapshot: &Snapshot, file: &str, range: Range<u32>) -> Vec<Action> {
    let database = &snapshot.database;
    let (Some(text), Some(tree)) = (database.text(file), database.tree(file)) else { return Vec::new() };
    if file.starts_with('<') {
        // The library is read-only.
        return Vec::new();
    }
    let problems = problems::of_file(snapshot, file);
    let asked = ActionRequest { snapshot, file: file.into(), range, text, tree, problems };
    let mut found = Vec::new();
    for problem in asked.problems.iter().filter(|problem| asked.touches(problem.primary.span)) {
        let from = found.len();
        fixes::of(&asked, problem, &mut found);
        import::of(&asked, problem, &mut found);
        symbolic::of(&asked, problem, &mut found);
        declare::of(&asked, problem, &mut found);
        unused::of(&asked, problem, &mut found);
        outputs::of(&asked, problem, &mut found);
        arguments::of(&asked, problem, &mut found);
        vectors::of(&asked, problem, &mut found);
        formats::of(&asked, problem, &mut found);
        let fixed = (problem.code.clone(), problem.primary.span.start..problem.primary.span.end);
        for action in &mut found[from..] {
            action.resolves = Some(fixed.clone());
        }
    }
    found.sort_by_key(|action| !action.preferred);
    outputs::missing(&asked, &mut found);
    arguments::naming(&asked, &mut found);
    units::writing(&asked, &mut found);
    convert::converting(&asked, &mut found);
    extract::extracting(&asked, &mut found);
    extract::inlining(&asked, &mut found);
    let mut seen: Vec<(String, Vec<Edit>)> = Vec::new();
    found.retain(|action| {
        let new = !seen.iter().any(|(title, edits)| *title == action.title && *edits == action.edits);
        if new {
            seen.push((action.title.clone(), action.edits.clone()));
        }
        new
    });
    found
}

impl<'a> ActionRequest<'a> {
    fn touches(&self, span: Span) -> bool {
        span.start <= self.range.end && self.range.start <= span.end
    }

    fn slice(&self, span: Span) -> &'a str {
        self.text.get(span.start as usize..span.end as usize).unwrap_or_default()
    }

    fn around(&self, span: Span) -> EnclosingNodes<'_> {
        EnclosingNodes::new(&self.tree.module, span.start..span.end)
    }

    fn edit(&self, start: u32, end: u32, replacement: impl Into<String>) -> Edit {
        Edit { file: self.file.clone(), start, end, replacement: replacement.into() }
    }

    /// Returns the unit system in which the file shows numbers, and whether the file selects one.
    fn system(&self) -> (UnitSystem, bool) {
        let named = super::numbers::system(&self.tree.module);
        (named.unwrap_or_default(), named.is_some())
    }

    /// Returns the start of the line of an offset, and its indentation.
    fn line(&self, offset: u32) -> (u32, &'a str) {
        let before = self.text.get(..offset as usize).unwrap_or_default();
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        let rest = self.text.get(start..).unwrap_or_default();
        let blanks = rest.len() - rest.trim_start_matches([' ', '\t']).len();
        (start as u32, rest.get(..blanks).unwrap_or_default())
    }
}

/// Creates a quick fix.
fn fix(title: impl Into<String>, edits: Vec<Edit>) -> Action {
    Action { title: title.into(), kind: ActionKind::QuickFix, preferred: false, edits, resolves: None }
}

/// Creates a rewrite.
fn rewrite(title: impl Into<String>, edits: Vec<Edit>) -> Action {
    Action { kind: ActionKind::Rewrite, ..fix(title, edits) }
}

impl Action {
    fn preferred(self) -> Action {
        Action { preferred: true, ..self }
    }
}
