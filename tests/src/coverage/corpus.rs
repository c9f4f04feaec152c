//! Coverage tables of the cases of the corpus.

use super::{Place, Table, program, report, symbolic, syntax};
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
            productions: Table::new(
                "Productions",
                "Every kind of node of the syntax tree, and every form of it that is read in a way of its own.",
                syntax::all(),
            ),
            codes: Table::new(
                "Diagnostics",
                "Every code of the language, the library and the engine. What only a test written in Rust or a page of \
                 the command line can bring about is covered there.",
                all_codes(),
            ),
            rules: Table::new(
                "Type rules",
                "Rules that inference applied or, where they refuse something, reported; as the checker recorded them.",
                Rule::ALL.iter().map(|rule| rule.text()),
            ),
            constructs: Table::new(
                "Constructs of the typed program",
                "Run by the interpreter and as machine code, with the same output.",
                program::constructs(),
            ),
            evaluated: Table::new("Operations, evaluated", "Run both ways, as above.", program::evaluated()),
            symbolic: Table::new(
                "Operations in symbolic expressions",
                "Kernels, run both ways.",
                program::symbolic_operations(),
            ),
            differentiated: Table::new(
                "Operations, differentiated",
                "Kernels with a derivative of the operation by `Time` or a param, run both ways.",
                program::differentiable(),
            ),
        }
    }

    /// Adds an evaluated case of the corpus.
    pub fn add(&mut self, document: &Document, case: &Case, judgement: &Judgement) {
        let stem = document.name.trim_end_matches(".md");
        let place = Place {
            title: format!("{stem}: {}", case.heading),
            link: format!("{}#{}", document.name, case.anchor),
        };
        self.productions.cover(productions(&case.model.text), &place);
        for (_, text) in document.files.iter().filter(|(name, _)| is_used(name, &case.model.text)) {
            self.productions.cover(productions(text), &place);
        }
        self.rules.cover(judgement.rules.iter().map(|rule| rule.text()), &place);
        self.add_codes(judgement.codes.iter().map(String::as_str), &place);
        if let Some(error) = case.expects("error") {
            self.add_codes(error.text.split(':').take(1), &place);
        }
        if let Some(program) = judgement.program.as_ref().filter(|_| judgement.ran) {
            let used = program::used(program);
            self.constructs.cover(used.constructs, &place);
            self.evaluated.cover(used.evaluated, &place);
            self.symbolic.cover(used.symbolic, &place);
            self.differentiated.cover(used.differentiated, &place);
        }
    }

    fn add_codes<'c>(&mut self, codes: impl Iterator<Item = &'c str>, place: &Place) {
        for code in codes {
            // A library finding that is not necessarily an error is a warning with the same number.
            let as_error = code.replacen('W', "E", 1);
            let row = self.codes.rows().iter().find(|row| row.starts_with(code));
            let row = row.or_else(|| self.codes.rows().iter().find(|row| row.starts_with(&as_error)));
            if let Some(row) = row.cloned() {
                self.codes.cover([row.as_str()], place);
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
            let name = file.display().to_string();
            let place = Place { title: name.clone(), link: format!("../../{name}") };
            self.add_codes(shown.iter().copied(), &place);
            left.retain(|code| !shown.contains(code));
        }
        self.add_guards();
    }

    /// Adds the codes of internal checks: no known input produces them.
    fn add_guards(&mut self) {
        for code in GUARDS {
            let place = Place {
                title: "a guard, which no model is known to reach".into(),
                link: "#diagnostics".into(),
            };
            self.add_codes([code].into_iter(), &place);
        }
    }

    fn tables(&self) -> Vec<Table> {
        let mut grammar = Table::new(
            "Grammar of the report",
            "The productions of tables 3.1 and 3.2.",
            report::PRODUCTIONS.iter().map(|(left, right, _)| format!("{left} → {right}")),
        );
        for (left, right, rows) in report::PRODUCTIONS {
            for place in rows.iter().flat_map(|row| self.productions.covering(row)) {
                grammar.cover([format!("{left} → {right}").as_str()], place);
            }
        }
        vec![grammar, symbolic::derivatives(), symbolic::simplifications()]
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

    pub fn to_markdown(&self) -> String {
        let mut text = String::from(HEADER);
        let made = self.tables();
        for table in made.iter().take(1).chain(self.collected()).chain(&made[1..]) {
            text.push_str(&table.to_markdown());
        }
        text
    }
}

/// Codes of internal checks, which indicate a defect: meshing and condensing a gear that passed the
/// library's checks, an invalid contact problem of the engine. E0712 ends a run that reports the
/// error of the file system instead. E0724 is prevented by an earlier comparison of the run's
/// inputs.
const GUARDS: [&str; 16] = [
    "E0662", "E0666", "E0674", "E0676", "E0677", "E0678", "E0679", "E0683", "E0712", "E0716", "E0717",
    "E0718", "E0719", "E0724", "E0760", "E0790",
];

const HEADER: &str = "\
# What the language corpus covers

Written by `CALYX_BLESS=1 cargo test -p calyx-tests --test language`, compared by the same test, which fails where a row
has no case. The rows come from the compiler: a new kind of expression, operation, rule or diagnostic is a new row.
";

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
        "runtime/analysis/src",
        "runtime/solve/src",
        "runtime/model/src",
        "runtime/contact/src",
        "runtime/structure/src",
        "runtime/fe/src",
        "runtime/numerics/src",
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
