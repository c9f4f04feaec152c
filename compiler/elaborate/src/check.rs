//! A model checked in one go, from a file or a text: what is wrong with its language, and with the gears it describes.

use crate::diagnostics::has_errors;
use crate::elaboration::{Params, elaborate};
use crate::loader::{ModelLoader, TextLoader};
use crate::plan::Planned;
use calyx_abi::Cancel;
use calyx_abi::description::ModelDescription;
use calyx_lang::check::Loader;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::{Program, SourceFile};
use calyx_lang::render::{Colour, Renderer};
use calyx_lang::span::{FileId, Span};
use calyx_rt::{Given, Override, Refused};
use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::path::Path;

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
    /// How the model would be analysed; `None` if it analyses nothing, or cannot.
    pub plan: Option<Planned>,
    /// Why the params given from outside cannot be used.
    pub refused: Option<Refused>,
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

/// Checks the model in a file at its params' defaults.
///
/// # Errors
/// The file cannot be read. (A file that is not UTF-8 is readable, and wrong.)
pub fn check_file(path: &Path) -> io::Result<Checked> {
    check_at(path, Params::Defaults)
}

/// Checks the model in a file for a run with these params, its analysis changed like this.
///
/// # Errors
/// As for [`check_file`].
pub fn check_run(path: &Path, given: &[Given], overrides: Override) -> io::Result<Checked> {
    check_run_within(path, given, overrides, None)
}

/// As [`check_run`], for a run whose memory is limited to so many bytes.
///
/// # Errors
/// As for [`check_file`].
pub fn check_run_within(
    path: &Path,
    given: &[Given],
    overrides: Override,
    memory: Option<u64>,
) -> io::Result<Checked> {
    check_at(path, Params::Given(given, overrides, memory))
}

fn check_at(path: &Path, params: Params) -> io::Result<Checked> {
    let folder = path.parent().map(Path::to_path_buf);
    Ok(match read(path)? {
        Ok(text) => check_with(&path.display().to_string(), &text, &ModelLoader { folder }, params),
        Err(not_text) => *not_text,
    })
}

/// The text of a file, or what is wrong with one that is none.
///
/// # Errors
/// The file cannot be read.
pub fn read(path: &Path) -> io::Result<Result<String, Box<Checked>>> {
    let bytes = std::fs::read(path)?;
    let name = path.display().to_string();
    Ok(String::from_utf8(bytes).map_err(|error| Box::new(not_utf8(&name, &error))))
}

/// Checks a model given as text; it can import the library only.
pub fn check_text(name: &str, text: &str) -> Checked {
    check_with(name, text, &ModelLoader { folder: None }, Params::Defaults)
}

/// Checks a model again of which the texts of all its files are at hand: its own first, then those it uses. Nothing else is
/// read.
pub fn check_sources(files: &[SourceFile]) -> Checked {
    let (name, text) = files.first().map_or(("", ""), |model| (&model.name, &model.text));
    check_with(name, text, &TextLoader(files), Params::Defaults)
}

fn check_with(name: &str, text: &str, loader: &dyn Loader, params: Params) -> Checked {
    let checked = calyx_lang::check::check_program(name, text, loader);
    let mut result = Checked {
        program: checked.program,
        description: ModelDescription::default(),
        diagnostics: checked.diagnostics,
        files: checked.files,
        types: checked.types,
        plan: None,
        refused: None,
    };
    // Nobody holds this switch, so nobody cancels.
    if let Some(program) = &result.program
        && let Ok(elaboration) = elaborate(program, params, &Cancel::default())
    {
        result.description = elaboration.description;
        result.diagnostics.extend(elaboration.found);
        result.plan = elaboration.plan;
        result.refused = elaboration.refused;
        if !elaboration.runnable {
            result.program = None;
        }
    }
    result
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
        plan: None,
        refused: None,
    }
}
