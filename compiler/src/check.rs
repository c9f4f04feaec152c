//! Everything that is wrong with a model: of the language, and of the gears it describes.

use crate::interpreted::Interpreted;
use crate::loader::ModelLoader;
use crate::nan::{Seen, explain, label, of_default};
use calyx_abi::context::codes;
use calyx_abi::description::ModelDescription;
use calyx_abi::{Context, Purity, RuntimeError};
use calyx_gears::error::Severity as FindingSeverity;
use calyx_gears::externs::{check_plan, check_unheld};
use calyx_gears::host::{Finding, ModelHost};
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::{Program, SourceFile};
use calyx_lang::render::{Colour, Renderer};
use calyx_lang::span::{FileId, Span};
use calyx_lower::interpret::CallSites;
use calyx_rt::{ParamError, Program as _, apply};
use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::path::Path;
use std::sync::{Arc, Mutex};

/// Basic blocks a program may enter while it is checked: models build and end; one that does not is stopped.
pub(crate) const FUEL: u64 = 20_000_000;

/// Bytes that its values may take meanwhile.
pub(crate) const MEMORY: u64 = 1_000_000_000;

/// What checking a model found.
pub struct Checked {
    /// `None` if there are errors of the language. A program may be there although its gears are impossible at these
    /// params: others may mend that.
    pub program: Option<Program>,
    /// What the model says of itself, with the defaults and ranges of its params.
    pub description: ModelDescription,
    pub diagnostics: Vec<Diagnostic>,
    pub files: Vec<SourceFile>,
    /// Types of the model's top-level names as shown to people.
    pub types: BTreeMap<String, String>,
    /// Why the params given from outside cannot be used.
    pub refused: Option<Refused>,
}

/// Why a value given for a param from outside cannot be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    pub message: String,
    /// What to do about it; empty if nothing can be said.
    pub help: String,
}

impl Checked {
    pub fn has_errors(&self) -> bool {
        has_errors(&self.diagnostics)
    }

    /// The diagnostics for people, in colour if standard error is a terminal.
    pub fn render(&self) -> String {
        render(&self.diagnostics, &self.files)
    }
}

pub(crate) fn has_errors(diagnostics: &[Diagnostic]) -> bool {
    diagnostics.iter().any(|diagnostic| diagnostic.severity == Severity::Error)
}

/// Checks the model in a file at its params' defaults.
///
/// # Errors
/// The file cannot be read. (A file that is not UTF-8 is readable, and wrong.)
pub fn check_file(path: &Path) -> io::Result<Checked> {
    check_at(path, Params::Defaults)
}

/// Checks the model in a file for a run with params given by name, as text.
///
/// # Errors
/// As for [`check_file`].
pub fn check_run(path: &Path, given: &[(String, String)]) -> io::Result<Checked> {
    check_at(path, Params::Given(given))
}

/// The params at which a model is elaborated.
#[derive(Clone, Copy)]
enum Params<'a> {
    Defaults,
    /// For a run, which may take as long as it likes.
    Given(&'a [(String, String)]),
}

fn check_at(path: &Path, params: Params) -> io::Result<Checked> {
    let folder = path.parent().map(Path::to_path_buf);
    Ok(match read(path)? {
        Ok(text) => check_with(&path.display().to_string(), &text, &ModelLoader { folder }, params),
        Err(not_text) => *not_text,
    })
}

/// The text of a file, or what is wrong with one that is none.
pub(crate) fn read(path: &Path) -> io::Result<Result<String, Box<Checked>>> {
    let bytes = std::fs::read(path)?;
    let name = path.display().to_string();
    Ok(String::from_utf8(bytes).map_err(|error| Box::new(not_utf8(&name, &error))))
}

/// Checks a model given as text; it can import the library only.
pub fn check_text(name: &str, text: &str) -> Checked {
    check_with(name, text, &ModelLoader { folder: None }, Params::Defaults)
}

fn check_with(name: &str, text: &str, loader: &ModelLoader, params: Params) -> Checked {
    let checked = calyx_lang::check::check_program(name, text, loader);
    let mut result = Checked {
        program: checked.program,
        description: ModelDescription::default(),
        diagnostics: checked.diagnostics,
        files: checked.files,
        types: checked.types,
        refused: None,
    };
    if let Some(program) = &result.program {
        match elaborate(program, params) {
            Ok(elaborated) => {
                result.description = elaborated.description;
                result.diagnostics.extend(elaborated.found);
                result.refused = elaborated.refused;
            }
            Err(found) => {
                result.diagnostics.push(*found);
                result.program = None;
            }
        }
    }
    result
}

/// Runs a program at its params' defaults without solving anything: the lines it prints, and what was found.
pub(crate) fn elaborate_printing(program: &Program) -> (Vec<String>, Vec<Diagnostic>) {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let printed = lines.clone();
    let print = move |line: &str| {
        if let Ok(mut lines) = printed.lock() {
            lines.push(line.to_owned());
        }
    };
    let found = match elaborate_with(program, Params::Defaults, Box::new(print)) {
        Ok(elaborated) => elaborated.found,
        Err(found) => vec![*found],
    };
    let lines = lines.lock().map(|lines| lines.clone()).unwrap_or_default();
    (lines, found)
}

/// What running a program without solving anything has shown.
struct Elaborated {
    description: ModelDescription,
    found: Vec<Diagnostic>,
    refused: Option<Refused>,
}

/// Runs the program, building a scene but solving nothing.
fn elaborate(program: &Program, params: Params) -> Result<Elaborated, Box<Diagnostic>> {
    elaborate_with(program, params, Box::new(|_| {}))
}

fn elaborate_with(
    program: &Program,
    params: Params,
    print: Box<dyn FnMut(&str) + Send>,
) -> Result<Elaborated, Box<Diagnostic>> {
    let mut interpreted = Interpreted::new(program, Purity::Scene)?.going_on();
    let mut context = Context::new(Box::new(ModelHost::new(&interpreted.description().units)));
    context.fuel = FUEL;
    context.limits.memory = Some(MEMORY);
    let seen = Seen::default();
    context.kernels = seen.watched(interpreted.kernels());
    context.print = print;
    let defaults =
        apply(&interpreted, &[], &mut context).and_then(|()| interpreted.describe_params(&mut context));
    let (applied, given) = match params {
        Params::Defaults => (defaults, &[][..]),
        Params::Given(given) => (apply(&interpreted, given, &mut context), given),
    };
    let ran = applied.and_then(|()| interpreted.main(&mut context).map_err(ParamError::Model));
    let survived = interpreted.failures();
    let sites = CallSites::new(program);
    let at_place = |error: &RuntimeError| {
        let mut error = error.clone();
        sites.blame(&mut error);
        explain(program, given, &seen, &error, diagnostic(&error))
    };
    let mut found: Vec<Diagnostic> = survived.iter().map(at_place).collect();
    let mut refused = None;
    if let Some(host) = context.host::<ModelHost>() {
        // Of a scene that is not complete nobody can say what it would do.
        if ran.is_ok() && survived.is_empty() {
            check_unheld(host);
            if !host.scene.pairs.is_empty()
                && let Err(error) = check_plan(host)
            {
                found.push(at_place(&error));
            }
        }
        found.extend(host.findings.iter().map(|finding| finding_diagnostic(finding, &sites)));
    }
    match ran {
        // A run may take longer than checking.
        Err(ParamError::Model(error))
            if matches!(error.code.as_str(), codes::LIMIT | codes::EXHAUSTED)
                && matches!(params, Params::Given(_)) => {}
        // What comes after a call that failed may follow from it.
        Err(ParamError::Model(error)) if survived.is_empty() => found.push(at_place(&error)),
        Err(ParamError::Model(_)) => {}
        Err(ParamError::Given { message, help }) => match params {
            Params::Given(_) => refused = Some(Refused { message, help }),
            Params::Defaults => found.push(wrong_default(program, message, help)),
        },
        Ok(()) => {}
    }
    found.sort_by_key(|diagnostic| (diagnostic.primary.span.file, diagnostic.primary.span.start));
    // A loop says the same at every turn.
    found.dedup();
    Ok(Elaborated { description: interpreted.into_description(), found, refused })
}

/// A default that its param does not allow.
fn wrong_default(program: &Program, message: String, help: String) -> Diagnostic {
    // Messages about params begin with the name.
    let name = message.split('`').nth(1).unwrap_or_default();
    let param = program.params.iter().find(|param| param.name == name);
    let span = param.map_or(Span::default(), |param| param.span);
    let found = Diagnostic::error("E0314", message.clone(), span, "the default is this").help(help);
    match of_default(program) {
        Some((place, source)) if place == span => label(program, found, &source, None),
        _ => found,
    }
}

/// Diagnostics that are shown at most; a text with more of them is not a model.
const MOST_SHOWN: usize = 200;

/// Diagnostics as text for standard error.
pub fn render(diagnostics: &[Diagnostic], files: &[SourceFile]) -> String {
    let colour = if io::stderr().is_terminal() { Colour::Always } else { Colour::Never };
    let mut renderer = Renderer::new(files, colour);
    let shown = diagnostics.iter().take(MOST_SHOWN).map(|diagnostic| renderer.text(diagnostic));
    let mut text: String = shown.collect();
    if diagnostics.len() > MOST_SHOWN {
        text += &format!("... and {} more\n", diagnostics.len() - MOST_SHOWN);
    }
    text
}

/// A run-time error as a diagnostic at its place.
pub(crate) fn diagnostic(error: &RuntimeError) -> Diagnostic {
    let label = if error.argument.is_some() { "because of this" } else { "it happened here" };
    let mut diagnostic = Diagnostic::error(&error.code, &error.message, place(error.place), label);
    diagnostic.calls = error.details.calls.clone();
    match (error.help.as_str(), error.details.origin.as_str()) {
        ("", "") => diagnostic,
        ("", origin) => diagnostic.help(format!("by its own words it arose at {origin}")),
        (help, _) => diagnostic.help(help),
    }
}

/// What the library found beside the error that stopped the model, placed on the argument to blame.
pub(crate) fn finding_diagnostic(finding: &Finding, sites: &CallSites) -> Diagnostic {
    let mut error = finding.error.clone();
    sites.blame(&mut error);
    let found = diagnostic(&error);
    match finding.severity {
        FindingSeverity::Error => found,
        FindingSeverity::Warning => {
            Diagnostic { severity: Severity::Warning, code: found.code.replacen('E', "W", 1), ..found }
        }
    }
}

fn place(place: Option<(u32, u32, u32)>) -> Span {
    let (file, start, end) = place.unwrap_or_default();
    Span { file: FileId(file), start, end }
}

fn not_utf8(name: &str, error: &std::string::FromUtf8Error) -> Checked {
    let start = error.utf8_error().valid_up_to();
    let text = String::from_utf8_lossy(error.as_bytes()).into_owned();
    let diagnostic = Diagnostic::error(
        "E0100",
        "the file is not UTF-8 text",
        Span::new(FileId(0), start, start + 1),
        "not a character",
    )
    .help("save it as UTF-8");
    Checked {
        program: None,
        description: ModelDescription::default(),
        diagnostics: vec![diagnostic],
        files: vec![SourceFile { name: name.to_owned(), text }],
        types: BTreeMap::new(),
        refused: None,
    }
}
