//! Tests written in Calyx: `test function` items, each run separately (`calyx test`).
//!
//! A test uses the declarations of a file, but not its statements: all other text is replaced by
//! blanks of the same length, so that source locations are unchanged. A param appended to the text
//! selects the test to call.

use calyx_abi::{Context, Purity, RuntimeError};
use calyx_elaborate::check::read;
use calyx_elaborate::diagnostics::{diagnostic, has_errors};
use calyx_elaborate::{FUEL, Interpreted, MEMORY, ModelLoader};
use calyx_gears::host::ModelHost;
use calyx_lang::ast::{Stmt, StmtKind};
use calyx_lang::check_program;
use calyx_lang::diagnostic::{Diagnostic, Severity};
use calyx_lang::ir::SourceFile;
use calyx_lang::parser::parse;
use calyx_lang::span::{FileId, Span};
use calyx_lower::interpret::CallSites;
use calyx_rt::{Error, InvalidParam, ParamAssignment, Program as _, apply};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

/// Param that selects the test. The two underscores avoid collisions with user names.
const SELECTOR: &str = "__test";

/// Codes of errors in the declaration of tests.
const OF_TESTS: [&str; 2] = ["E0222", "E0223"];

/// Result of a test.
pub struct Outcome {
    pub name: String,
    /// Failure; `None` if the test passed.
    pub failure: Option<Diagnostic>,
    /// Lines that the test printed.
    pub lines: Vec<String>,
}

/// Results of the tests of one file.
pub struct Tested {
    pub outcomes: Vec<Outcome>,
    /// Errors of the file that prevented its tests from running.
    pub errors: Vec<Diagnostic>,
    pub files: Vec<SourceFile>,
}

impl Tested {
    pub fn passed(&self) -> usize {
        self.outcomes.iter().filter(|outcome| outcome.failure.is_none()).count()
    }

    pub fn failed(&self) -> usize {
        self.outcomes.len() - self.passed()
    }
}

/// Runs the tests of a file whose names contain `filter`.
///
/// # Errors
/// If the file cannot be read.
pub fn test_file(path: &Path, allowed: &Arc<[PathBuf]>, filter: &str) -> io::Result<Tested> {
    let name = path.display().to_string();
    let text = match read(path)? {
        Ok(text) => text,
        Err(checked) => {
            return Ok(Tested { outcomes: Vec::new(), errors: checked.diagnostics, files: checked.files });
        }
    };
    let loader = ModelLoader { folder: path.parent().map(Path::to_path_buf), allowed: allowed.clone() };
    Ok(test_text(&name, &text, &loader, filter))
}

/// Returns the file, or the files with tests in a directory and its subdirectories, sorted by name.
///
/// # Errors
/// If a file or directory cannot be read.
pub fn files_with_tests(path: &Path) -> io::Result<Vec<PathBuf>> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let (mut found, mut pending) = (Vec::new(), vec![path.to_owned()]);
    while let Some(directory) = pending.pop() {
        for entry in std::fs::read_dir(&directory)? {
            let path = entry?.path();
            let hidden = path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
            if path.is_dir() && !hidden && !path.is_symlink() {
                pending.push(path);
            } else if path.extension().is_some_and(|extension| extension == "cx") {
                // A file that is not UTF-8 contains no tests; `check` reports it.
                let text = std::fs::read(&path)?;
                if String::from_utf8(text).is_ok_and(|text| !tests(&text).is_empty()) {
                    found.push(path);
                }
            }
        }
    }
    found.sort();
    Ok(found)
}

/// Returns the names of the tests in a text, in order.
pub fn tests(text: &str) -> Vec<String> {
    let (module, _) = parse(FileId(0), text);
    let name = |statement: &Stmt| match &statement.kind {
        StmtKind::Function(function) if function.is_test => Some(function.name.name.to_string()),
        _ => None,
    };
    module.statements.iter().filter_map(name).collect()
}

fn test_text(name: &str, text: &str, loader: &ModelLoader, filter: &str) -> Tested {
    // Names in the blanked text would be reported as unknown.
    let whole = check_program(name, text, loader);
    let misused: Vec<Diagnostic> =
        whole.diagnostics.into_iter().filter(|found| OF_TESTS.contains(&found.code.as_str())).collect();
    if !misused.is_empty() {
        return Tested { outcomes: Vec::new(), errors: misused, files: whole.files };
    }
    let names: Vec<String> = tests(text).into_iter().filter(|test| test.contains(filter)).collect();
    let checked = check_program(name, &harness(text, &names), loader);
    let mut files = checked.files;
    if let Some(own) = files.first_mut() {
        text.clone_into(&mut own.text);
    }
    let errors: Vec<Diagnostic> =
        checked.diagnostics.into_iter().filter(|found| found.severity == Severity::Error).collect();
    let (Some(program), false) = (&checked.program, has_errors(&errors)) else {
        return Tested { outcomes: Vec::new(), errors, files };
    };
    let interpreted = match Interpreted::new(program, Purity::Scene) {
        Ok(interpreted) => interpreted,
        Err(found) => return Tested { outcomes: Vec::new(), errors: vec![*found], files },
    };
    let sites = CallSites::new(program);
    let outcomes = names.into_iter().enumerate().map(|(index, name)| {
        let (lines, ended) = run(&interpreted, index);
        let failure = ended.err().map(|error| failure(error, &sites, text.len() as u32));
        Outcome { name, failure, lines }
    });
    Tested { outcomes: outcomes.collect(), errors, files }
}

/// Returns the text's declarations with a call of the test that the selector names.
fn harness(text: &str, names: &[String]) -> String {
    let (module, _) = parse(FileId(0), text);
    let mut harness = text.to_owned();
    for statement in module.statements.iter().filter(|statement| runs(&statement.kind)) {
        let Span { start, end, .. } = statement.span;
        let range = start as usize..end as usize;
        let Some(old) = text.get(range.clone()) else { continue };
        // Keeps the number of bytes and the lines.
        let blank = |byte: u8| if byte == b'\n' { '\n' } else { ' ' };
        harness.replace_range(range, &old.bytes().map(blank).collect::<String>());
    }
    harness += &format!("\nparam {SELECTOR} = 0;\nswitch ({SELECTOR}) {{\n");
    for (index, name) in names.iter().enumerate() {
        harness += &format!("case {index}: {name}(); break;\n");
    }
    harness + "}\n"
}

/// Returns true if a top-level statement is executed, as opposed to a declaration.
fn runs(kind: &StmtKind) -> bool {
    !matches!(
        kind,
        StmtKind::Empty
            | StmtKind::Error
            | StmtKind::Import(_)
            | StmtKind::Units(_)
            | StmtKind::Param(_)
            | StmtKind::Const { .. }
            | StmtKind::Record(_)
            | StmtKind::Enum(_)
            | StmtKind::Dimension { .. }
            | StmtKind::Unit(_)
            | StmtKind::Function(_)
    )
}

/// Runs one test in its own context; returns the printed lines and the result.
fn run(interpreted: &Interpreted, test: usize) -> (Vec<String>, Result<(), RuntimeError>) {
    let lines = Arc::new(Mutex::new(Vec::new()));
    let printed = lines.clone();
    let host = ModelHost { checking: true, ..ModelHost::new(interpreted.description()) };
    let mut context = Context::new(Box::new(host));
    context.fuel = FUEL;
    context.limits.memory = Some(MEMORY);
    context.kernels = interpreted.kernels();
    context.keeps_output = true;
    context.print = Box::new(move |line| {
        if let Ok(mut lines) = printed.lock() {
            lines.push(line.to_owned());
        }
    });
    let given = [ParamAssignment::text(SELECTOR, test.to_string())];
    let ended = apply(interpreted, &given, &mut context).map_err(|error| match error {
        Error::Model(error) => error,
        Error::Given(InvalidParam { message, help, .. }) => RuntimeError::new("E0314", message, help),
    });
    let ended = ended.and_then(|()| interpreted.main(&mut context));
    let lines = lines.lock().map(|mut lines| std::mem::take(&mut *lines)).unwrap_or_default();
    (lines, ended)
}

/// Returns the diagnostic of a failure, without the call that was appended to the text.
fn failure(mut error: RuntimeError, sites: &CallSites, end: u32) -> Diagnostic {
    sites.blame(&mut error);
    error.details.calls.retain(|call| call.place.0 != 0 || call.place.1 < end);
    diagnostic(&error)
}
