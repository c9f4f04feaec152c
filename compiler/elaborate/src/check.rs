//! Checks a model from a file or a text: its language, then its gears.

use crate::diagnostics::has_errors;
use crate::elaboration::{Lowered, Params, elaborate_and_keep};
use crate::loader::{ModelLoader, TextLoader};
use crate::plan::Planned;
use calyx_abi::Cancel;
use calyx_abi::description::ModelDescription;
use calyx_gears::data_block::DataBlock;
use calyx_lang::check::Loader;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::{Program, SourceFile};
use calyx_lang::render::{Colour, Renderer};
use calyx_lang::span::{FileId, Span};
use calyx_rt::{InvalidParam, Override, ParamAssignment};
use calyx_symbolic::Tape;
use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The result of checking a model.
pub struct Checked {
    /// The program; `None` if the language rejects it. A program may exist although its gears are
    /// impossible at these params, because other params may be valid.
    pub program: Option<Program>,
    /// The model's own description, with the defaults and ranges of its params.
    pub description: ModelDescription,
    pub diagnostics: Vec<Diagnostic>,
    pub files: Vec<SourceFile>,
    /// Types of the model's top-level names, as displayed.
    pub types: BTreeMap<String, String>,
    /// The plan of the analysis; `None` if the model has no valid analysis.
    pub plan: Option<Planned>,
    /// The reason why the given params were rejected.
    pub refused: Option<InvalidParam>,
    /// The last lines that the model printed before its first failure.
    pub printed: Vec<String>,
    /// Number of basic blocks that the program entered.
    pub blocks: u64,
    /// Number of gears that the model makes.
    pub gears: usize,
    /// Number of its meshes on axes that are not parallel, or of gears that are not involute gears.
    pub general_meshes: usize,
    /// Data of the gears and meshes, as in the data block of a drawing.
    pub gear_data: DataBlock,
    /// Parts of the program that further elaborations need; `None` without a program.
    pub(crate) lowered: Option<Lowered>,
}

impl Checked {
    /// Returns the tapes of all symbolic expressions of the program, in the order of its sites;
    /// `None` if it cannot be elaborated.
    pub fn tapes(&self) -> Option<Vec<&Tape>> {
        let lowered = self.lowered.as_ref()?;
        Some(lowered.kernels.iter().map(|kernel| &kernel.0).collect())
    }

    pub fn has_errors(&self) -> bool {
        has_errors(&self.diagnostics)
    }

    /// Returns the diagnostics as text, in colour if standard error is a terminal.
    pub fn render(&self) -> String {
        render(&self.diagnostics, &self.files)
    }
}

/// Checks the model in a file with the defaults of its params.
///
/// # Errors
/// The file cannot be read. A file that is not UTF-8 is read and rejected with a diagnostic.
pub fn check_file(path: &Path) -> io::Result<Checked> {
    check_file_allowing(path, &Arc::default())
}

/// As [`check_file`], for a model that may read files outside of its folder: those given, and what
/// is below directories among them (see [`allowed_path`](crate::allowed_path)).
///
/// # Errors
/// As for [`check_file`].
pub fn check_file_allowing(path: &Path, allowed: &Arc<[PathBuf]>) -> io::Result<Checked> {
    check_at(path, allowed, Params::Defaults)
}

/// Checks the model in a file for a run with the given params and with settings that override those
/// of its analysis.
///
/// # Errors
/// As for [`check_file`].
pub fn check_run(path: &Path, given: &[ParamAssignment], overrides: Override) -> io::Result<Checked> {
    check_run_within(path, &Arc::default(), given, overrides, None)
}

/// As [`check_run`], for a model that may read files outside of its folder (see
/// [`check_file_allowing`]), and a run whose memory is limited to so many bytes.
///
/// # Errors
/// As for [`check_file`].
pub fn check_run_within(
    path: &Path,
    allowed: &Arc<[PathBuf]>,
    given: &[ParamAssignment],
    overrides: Override,
    memory: Option<u64>,
) -> io::Result<Checked> {
    check_at(path, allowed, Params::Given(given, overrides, memory))
}

fn check_at(path: &Path, allowed: &Arc<[PathBuf]>, params: Params) -> io::Result<Checked> {
    let folder = path.parent().map(Path::to_path_buf);
    let loader = ModelLoader { folder, allowed: allowed.clone() };
    Ok(match read(path)? {
        Ok(text) => check_with(&path.display().to_string(), &text, &loader, params),
        Err(not_text) => *not_text,
    })
}

/// Reads a text file. Returns a rejection if the file is not text.
///
/// # Errors
/// The file cannot be read.
pub fn read(path: &Path) -> io::Result<Result<String, Box<Checked>>> {
    let bytes = std::fs::read(path)?;
    let name = path.display().to_string();
    Ok(String::from_utf8(bytes).map_err(|error| Box::new(not_utf8(&name, &error))))
}

/// Checks a model given as text. It can import only the library.
pub fn check_text(name: &str, text: &str) -> Checked {
    check_with(name, text, &ModelLoader::default(), Params::Defaults)
}

/// Checks a model whose files are all in memory: first the model's own file, then the imported
/// ones. Reads no other file.
pub fn check_sources(files: &[SourceFile]) -> Checked {
    let (name, text) = files.first().map_or(("", ""), |model| (&model.name, &model.text));
    check_with(name, text, &TextLoader(files), Params::Defaults)
}

/// Checks the language of a model whose files are all in memory, as [`check_sources`] does, without
/// elaborating it. Returns the program, unless it has errors, and the diagnostics.
pub fn check_language(files: &[SourceFile]) -> (Option<Program>, Vec<Diagnostic>) {
    let (name, text) = files.first().map_or(("", ""), |model| (&model.name, &model.text));
    let checked = calyx_lang::check_program(name, text, &TextLoader(files));
    (checked.program, checked.diagnostics)
}

fn check_with(name: &str, text: &str, loader: &dyn Loader, params: Params) -> Checked {
    let checked = calyx_lang::check_program(name, text, loader);
    let mut result = Checked {
        program: checked.program,
        description: ModelDescription::default(),
        diagnostics: checked.diagnostics,
        files: checked.files,
        types: checked.types,
        plan: None,
        refused: None,
        printed: Vec::new(),
        blocks: 0,
        gear_data: DataBlock::default(),
        gears: 0,
        general_meshes: 0,
        lowered: None,
    };
    // No other code has access to this switch, so the elaboration cannot be cancelled.
    if let Some(program) = &result.program
        && let Ok((elaboration, lowered)) = elaborate_and_keep(program, params, &Cancel::default())
    {
        result.lowered = lowered;
        result.description = elaboration.description;
        result.diagnostics.extend(elaboration.found);
        result.plan = elaboration.plan;
        result.refused = elaboration.refused;
        result.printed = elaboration.printed;
        result.blocks = elaboration.blocks;
        result.gear_data = elaboration.gear_data;
        result.gears = elaboration.geometry.gears.len();
        result.general_meshes = elaboration.geometry.general_meshes;
        if !elaboration.runnable {
            result.program = None;
        }
    }
    result
}

/// Limit of the diagnostics shown; a text with more is probably not a model.
const MOST_SHOWN: usize = 200;

/// Returns the diagnostics as text for standard error: errors first, since warnings are often
/// consequences of an error, such as a variable whose use has not been written yet.
pub fn render(diagnostics: &[Diagnostic], files: &[SourceFile]) -> String {
    let colour = if io::stderr().is_terminal() { Colour::Always } else { Colour::Never };
    let mut renderer = Renderer::new(files, colour);
    let (errors, others): (Vec<&Diagnostic>, Vec<_>) =
        diagnostics.iter().partition(|diagnostic| diagnostic.severity == Severity::Error);
    let shown = errors.into_iter().chain(others).take(MOST_SHOWN).map(|diagnostic| renderer.text(diagnostic));
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
        printed: Vec::new(),
        blocks: 0,
        gear_data: DataBlock::default(),
        gears: 0,
        general_meshes: 0,
        lowered: None,
    }
}
