//! Evaluation of a case of a document: compiles the model, compares its diagnostics and types, and
//! its output in both evaluators.

use crate::document::{Block, Case, Document};
use calyx::rt::apply;
use calyx::{Checked, Engine, Interpreted, Module, check_file};
use calyx_abi::{Context, Purity, RuntimeError};
use calyx_gears::host::ModelHost;
use calyx_lang::check::rules::{self, Rule};
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{Program, SourceFile};
use calyx_lang::render::{Colour, Renderer};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex};

/// Result of a case.
#[derive(Debug, Default)]
pub struct Judgement {
    /// Problems with their lines in the document.
    pub problems: Vec<(usize, String)>,
    /// Blocks of expectations that differ, with the actual text.
    pub differing: Vec<(Block, String)>,
    /// Codes of the diagnostics of the case.
    pub codes: Vec<String>,
    /// Rules of type inference that the case applied.
    pub rules: BTreeSet<Rule>,
    /// Program, if it has no errors of the language.
    pub program: Option<Program>,
    /// True if both evaluators ran the case with the expected results.
    pub ran: bool,
}

/// Writes the files of a document into the directory of its models.
///
/// # Panics
/// If a file cannot be written.
pub fn write_files(document: &Document, folder: &Path) {
    for (name, text) in &document.files {
        let path = folder.join(name);
        let parent = path.parent().unwrap_or(folder);
        fs::create_dir_all(parent).and_then(|()| fs::write(&path, text)).expect("a temporary file");
    }
}

/// Evaluates a case, in a directory with the document's files.
///
/// # Panics
/// If the model cannot be written there.
pub fn judge(case: &Case, folder: &Path) -> Judgement {
    let file = folder.join("model.cx");
    fs::write(&file, &case.model.text).expect("a temporary file");
    rules::take();
    let mut checked = check_file(&file).expect("a readable file");
    let rules = rules::take();
    checked.files[0].name = "model.cx".into();
    let mut judgement = Judgement {
        problems: unexpected(case, &checked.diagnostics),
        codes: checked.diagnostics.iter().map(|diagnostic| diagnostic.code.clone()).collect(),
        rules,
        program: checked.program.clone(),
        ..Judgement::default()
    };
    let as_expected = judgement.problems.is_empty();
    if let Some(block) = case.expects("diagnostic") {
        judgement.compare(block, "it is shown as", shown(&checked));
    }
    if let Some(block) = case.expects("types") {
        let types: String = checked.types.iter().map(|(name, ty)| format!("{name}: {ty}\n")).collect();
        judgement.compare(block, "its types are", types);
    }
    let (printed, failed) = (case.expects("text"), case.expects("error"));
    if (printed.is_none() && failed.is_none()) || !as_expected {
        return judgement;
    }
    let Some(program) = checked.program.clone() else {
        judgement.problems.push((case.model.line, "it is not run, it has errors".into()));
        return judgement;
    };
    // Errors at the defaults are known and expected; the run must produce them now.
    checked.diagnostics.clear();
    let files = checked.files.clone();
    let interpreted = Interpreted::new(&program, Purity::Effect).expect("the interpreter");
    let compiled = Module::from_checked(&Engine::default(), checked).expect("machine code");
    let runs = [("interpreted", run(&interpreted)), ("compiled", run(compiled.as_program().as_ref()))];
    for (way, (output, error)) in &runs {
        let nothing = Block { line: case.model.line, kind: String::new(), text: String::new() };
        let error = error.as_ref().map(|error| described(error, &files)).unwrap_or_default();
        judgement.compare(printed.unwrap_or(&nothing), &format!("{way}, it prints"), output.clone());
        judgement.compare(failed.unwrap_or(&nothing), &format!("{way}, it ends with"), error);
    }
    judgement.ran = judgement.problems.is_empty();
    judgement
}

impl Judgement {
    fn compare(&mut self, block: &Block, what: &str, found: String) {
        if found == block.text {
            return;
        }
        self.problems.push((block.line, format!("{what}\n{}", difference(&block.text, &found))));
        if !block.kind.is_empty() && self.differing.iter().all(|(other, _)| other.line != block.line) {
            self.differing.push((block.clone(), found));
        }
    }
}

/// Returns the output of a program at its default params, and the error that it ends with.
fn run(program: &dyn calyx::rt::Program) -> (String, Option<RuntimeError>) {
    let printed = Arc::new(Mutex::new(String::new()));
    let mut context = Context::new(Box::new(ModelHost::default()));
    context.kernels = program.kernels();
    let lines = printed.clone();
    context.print = Box::new(move |line| {
        let mut lines = lines.lock().expect("one thread");
        lines.push_str(line);
        lines.push('\n');
    });
    apply(program, &[], &mut context).expect("defaults");
    let result = program.main(&mut context);
    let text = printed.lock().expect("one thread").clone();
    (text, result.err())
}

/// Number of calls of a run-time error that are compared.
const MOST_CALLS: usize = 5;

/// Describes a run-time error for comparison: code, message, location and call stack.
fn described(error: &RuntimeError, files: &[SourceFile]) -> String {
    let mut text = format!("{}: {}\n", error.code, error.message);
    let at = |(file, start, _): (u32, u32, u32)| {
        let file = files.get(file as usize)?;
        let before = &file.text[..start as usize];
        let column = before.chars().rev().take_while(|c| *c != '\n').count() + 1;
        Some(format!("{}:{}:{column}", file.name, before.matches('\n').count() + 1))
    };
    if let Some(place) = error.place.and_then(at) {
        text.push_str(&format!("at {place}\n"));
    }
    // As many calls as users are shown.
    for call in error.details.calls.iter().take(MOST_CALLS) {
        let place = at(call.place).unwrap_or_default();
        text.push_str(&format!("in `{}`, called at {place}\n", call.function));
    }
    text
}

fn line_of(text: &str, offset: u32) -> usize {
    text.bytes().take(offset as usize).filter(|b| *b == b'\n').count()
}

/// Expectation in a comment of a model.
#[derive(Debug, PartialEq, Eq)]
pub struct Mark<'t> {
    /// Line of the model that the diagnostic refers to, from 0; `None` is another file.
    pub line: Option<usize>,
    pub code: &'t str,
    pub message: &'t str,
}

/// Returns the expectations of a model.
pub fn marks(model: &str) -> Vec<Mark<'_>> {
    let of_line = |(index, line)| {
        let marks: Vec<Mark> = str::split(line, "//~")
            .skip(1)
            .map(|text| {
                let above = text.chars().take_while(|c| *c == '^').count();
                let text = text[above..].trim();
                let elsewhere = text.strip_prefix("elsewhere ");
                let text = elsewhere.unwrap_or(text);
                let (code, message) = text.split_once(' ').unwrap_or((text, ""));
                let line = elsewhere.is_none().then(|| usize::saturating_sub(index, above));
                Mark { line, code, message: message.trim() }
            })
            .collect();
        marks
    };
    model.lines().enumerate().flat_map(of_line).collect()
}

/// Returns unmet expectations of a case, and unexpected diagnostics.
fn unexpected(case: &Case, diagnostics: &[Diagnostic]) -> Vec<(usize, String)> {
    let text = &case.model.text;
    let mut left: Vec<&Diagnostic> = diagnostics.iter().collect();
    let mut problems = Vec::new();
    let place = |d: &Diagnostic| (d.primary.span.file.0 == 0).then(|| line_of(text, d.primary.span.start));
    for mark in marks(text) {
        let found = left
            .iter()
            .position(|d| d.code == mark.code && place(d) == mark.line && d.message.contains(mark.message));
        match found {
            Some(at) => {
                let found = left.remove(at);
                if found.help.is_none() && !is_evident(&found.code) {
                    problems.push((case.model.line, format!("{} says nothing of what to do", found.code)));
                }
            }
            None => {
                let line = case.model.line + mark.line.unwrap_or_default();
                problems.push((line, format!("not found: {} {}", mark.code, mark.message)));
            }
        }
    }
    left.retain(|d| !(case.is_fragment() && d.code == "W0201"));
    problems.extend(left.iter().map(|d| {
        let line = case.model.line + place(d).unwrap_or_default();
        (line, format!("unexpected: {} {}", d.code, d.message))
    }));
    problems
}

/// Renders diagnostics as for users, without trailing blanks.
fn shown(checked: &Checked) -> String {
    let mut renderer = Renderer::new(&checked.files, Colour::Never);
    let text: String = checked.diagnostics.iter().map(|diagnostic| renderer.text(diagnostic)).collect();
    text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// Compares expected and actual text line by line: common lines are indented, others marked.
pub fn difference(expected: &str, found: &str) -> String {
    let (old, new): (Vec<&str>, Vec<&str>) = (expected.lines().collect(), found.lines().collect());
    let start = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let (old_rest, new_rest) = (&old[start..], &new[start..]);
    let end = old_rest.iter().rev().zip(new_rest.iter().rev()).take_while(|(a, b)| a == b).count();
    let lines = |mark: &str, lines: &[&str]| -> String {
        lines.iter().map(|line| format!("    {mark} {line}\n")).collect()
    };
    let removed = lines("-", &old_rest[..old_rest.len() - end]);
    let added = lines("+", &new_rest[..new_rest.len() - end]);
    // Two lines of context before and after.
    let before = lines(" ", &old[start.saturating_sub(2)..start]);
    let after = lines(" ", &old_rest[old_rest.len() - end..][..end.min(2)]);
    format!("{before}{removed}{added}{after}")
}

/// Returns true for errors that need no help: syntax errors, whose message states what is expected,
/// and failed assertions and thrown errors, whose message is the model's.
fn is_evident(code: &str) -> bool {
    code.starts_with("E01") || ["E0705", "E0720"].contains(&code)
}
