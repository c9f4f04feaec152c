//! Coverage tables of the cases of the corpus.

use super::{Table, program, report, symbolic, syntax};
use crate::document::{Case, Document};
use crate::judge::Judgement;
use crate::root;
use calyx_lang::check::rules::Rule;
use calyx_lang::codes;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// All tables that require cases.
#[derive(Debug)]
pub struct Coverage {
    productions: Table,
    codes: Table,
    rules: Table,
    constructs: Table,
    evaluated: Table,
    symbolic: Table,
    differentiated: Table,
}

impl Default for Coverage {
    fn default() -> Self {
        Coverage::new()
    }
}

impl Coverage {
    /// Creates the tables without covered rows.
    pub fn new() -> Coverage {
        Coverage {
            // Kinds of nodes of the syntax tree, and forms of them with a parser rule of their own.
            productions: Table::new("Productions", syntax::all()),
            codes: Table::new("Diagnostics", all_codes()),
            // Rules that inference applied or, if they reject something, reported.
            rules: Table::new("Type rules", Rule::ALL.iter().map(|rule| rule.text())),
            // Cases run by the interpreter and as machine code, with the same output.
            constructs: Table::new("Constructs of the typed program", program::constructs()),
            evaluated: Table::new("Operations, evaluated", program::evaluated()),
            symbolic: Table::new("Operations in symbolic expressions", program::symbolic_operations()),
            // Kernels with a derivative of the operation by `Time` or a param.
            differentiated: Table::new("Operations, differentiated", program::differentiable()),
        }
    }

    /// Adds an evaluated case of the corpus.
    pub fn add(&mut self, document: &Document, case: &Case, judgement: &Judgement) {
        self.productions.cover(productions(&case.model.text));
        for (_, text) in document.files.iter().filter(|(name, _)| is_used(name, &case.model.text)) {
            self.productions.cover(productions(text));
        }
        self.rules.cover(judgement.rules.iter().map(|rule| rule.text()));
        self.add_codes(judgement.codes.iter().map(String::as_str));
        if let Some(error) = case.expects("error") {
            self.add_codes(error.text.split(':').take(1));
        }
        if let Some(program) = judgement.program.as_ref().filter(|_| judgement.ran) {
            let used = program::used(program);
            self.constructs.cover(used.constructs);
            self.evaluated.cover(used.evaluated);
            self.symbolic.cover(used.symbolic);
            self.differentiated.cover(used.differentiated);
        }
    }

    fn add_codes<'c>(&mut self, codes: impl Iterator<Item = &'c str>) {
        for code in codes {
            // A library finding that is not necessarily an error is a warning with the same number.
            let as_error = code.replacen('W', "E", 1);
            let row = self.codes.rows().iter().find(|row| row.starts_with(code));
            let row = row.or_else(|| self.codes.rows().iter().find(|row| row.starts_with(&as_error)));
            if let Some(row) = row.cloned() {
                self.codes.cover([row.as_str()]);
            }
        }
    }

    /// Searches the other tests for the codes that no case of the corpus shows.
    pub fn add_other_tests(&mut self) {
        let open: Vec<String> =
            self.codes.rows().iter().filter(|row| !self.codes.is_covered(row)).cloned().collect();
        let mut left: BTreeSet<&str> = open.iter().filter_map(|row| row.get(..5)).collect();
        for file in other_tests() {
            let text = fs::read_to_string(root().join(&file)).unwrap_or_default();
            let shown: Vec<&str> = left.iter().copied().filter(|code| expects(&text, code)).collect();
            self.add_codes(shown.iter().copied());
            left.retain(|code| !shown.contains(code));
        }
        self.add_codes(GUARDS.into_iter());
    }

    fn tables(&self) -> [Table; 3] {
        let production = |left: &str, right: &str| format!("{left} → {right}");
        let mut grammar = Table::new(
            "Grammar of the report",
            report::PRODUCTIONS.iter().map(|(left, right, _)| production(left, right)),
        );
        for (left, right, rows) in report::PRODUCTIONS {
            if rows.iter().any(|row| self.productions.is_covered(row)) {
                grammar.cover([production(left, right).as_str()]);
            }
        }
        [grammar, symbolic::derivatives(), symbolic::simplifications()]
    }

    /// Returns the rows without a case.
    pub fn holes(&self) -> Vec<String> {
        let made = self.tables();
        made.iter().chain(self.collected()).flat_map(Table::holes).collect()
    }

    fn collected(&self) -> [&Table; 7] {
        [
            &self.productions,
            &self.codes,
            &self.rules,
            &self.constructs,
            &self.evaluated,
            &self.symbolic,
            &self.differentiated,
        ]
    }
}

/// Codes of internal checks, which no known input produces: meshing and condensing a gear that
/// passed the library's checks, an invalid contact problem of the engine. E0712 ends a run that
/// reports the error of the file system instead. E0724 is prevented by an earlier comparison of the
/// run's inputs.
const GUARDS: [&str; 17] = [
    "E0662", "E0666", "E0674", "E0676", "E0677", "E0678", "E0679", "E0683", "E0712", "E0716", "E0717",
    "E0718", "E0719", "E0724", "E0760", "E0790", "E0977",
];

/// Returns the productions in a text.
fn productions(text: &str) -> BTreeSet<&'static str> {
    syntax::used(&parse(FileId(0), text).0)
}

/// Returns true if a model imports a module of its document.
fn is_used(file: &str, model: &str) -> bool {
    let module = file.trim_end_matches(".cx").replace('/', ".");
    model.contains(&format!("import {module};"))
}

/// Returns codes with their titles: those of the language, then those that the reference lists for
/// library and engine.
fn all_codes() -> Vec<String> {
    let reference = fs::read_to_string(root().join("docs/reference.md")).expect("the reference");
    let engine = reference.split("### Codes of library and engine").nth(1).expect("its section");
    let engine = engine.lines().skip(1).take_while(|line| !line.starts_with('#'));
    let engine = engine.filter_map(|line| line.strip_prefix("| E")).map(|row| {
        let row = row.trim_end_matches('|').trim();
        format!("E{}", row.replacen(" | ", " ", 1))
    });
    let own = codes::all().iter().map(|code| format!("{} {}", code.code, code.title));
    own.chain(engine).collect()
}

/// Returns true if a test expects a code: `"E0401"` in Rust, `[E0401]` in output, `// ... E0401` in
/// a program.
fn expects(text: &str, code: &str) -> bool {
    let (quoted, printed) = (format!("\"{code}\""), format!("[{code}]"));
    text.lines().any(|line| {
        let marked = line.find(code).is_some_and(|at| line[..at].contains("//"));
        marked || line.contains(&quoted) || line.contains(&printed)
    })
}

/// Returns the tests outside of the corpus that show diagnostics, in order of preference: fixtures,
/// pages of the command line, then Rust.
fn other_tests() -> Vec<PathBuf> {
    let folders = [
        "lang/tests",
        "compiler/tests",
        "stdlib-gears/tests",
        "compiler/codegen/tests",
        "runtime/tests",
        "runtime/model/tests",
        "runtime/analysis/src",
        "runtime/solve/src",
        "runtime/model/src",
        "runtime/contact/src",
        "runtime/structure/src",
        "runtime/fe/src",
        "runtime/numerics/src",
        "runtime/report/src",
        "runtime/rt/src",
        "tests/tests",
    ];
    let mut files = Vec::new();
    for folder in folders {
        let mut found = Vec::new();
        files_below(&root().join(folder), &mut found);
        found.sort_by_key(|path| (path.extension().is_some_and(|e| e == "rs"), path.clone()));
        let relative = found.iter().filter_map(|path| path.strip_prefix(root()).ok());
        files.extend(relative.filter(|path| is_test(path)).map(Path::to_path_buf));
    }
    files
}

/// Returns true for a file in a directory of tests, or a file of unit tests next to the code.
fn is_test(path: &Path) -> bool {
    let folder = path.components().any(|part| part.as_os_str() == "tests");
    folder || path.file_stem().is_some_and(|stem| stem.to_string_lossy().ends_with("_tests"))
}

fn files_below(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            files_below(&path, files);
        } else {
            files.push(path);
        }
    }
}
