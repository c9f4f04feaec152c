//! `lang/REFERENCE.md` describes the language as it is: every snippet in it is checked and run, and its tables are
//! compared with what the compiler knows.
//!
//! Fenced blocks of the reference:
//! - `cx` is a model without any diagnostic, except those that its comments `//~ CODE part of the message` expect on their
//!   line (`//~^` on the line above);
//! - `cx fragment` is the same, and unused variables pass;
//! - `cx module NAME` is a file `NAME.cx` that the models may import;
//! - `text` after a `cx` block is what the model prints, run by the interpreter and as machine code;
//! - `diagnostic` after a `cx` block is how its diagnostics are shown.

use calyx::rt::{Program, apply};
use calyx::{Checked, Interpreted, Module, check_file};
use calyx_abi::{Context, Purity};
use calyx_gears::host::ModelHost;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::dimension::Dimension;
use calyx_lang::render::{Colour, Renderer};
use calyx_lang::units::{Unit, UnitSystem};
use calyx_lang::{codes, lexer};
use calyx_tests::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::sync::{Arc, Mutex};

struct Block {
    /// Line of the reference it begins on.
    line: usize,
    /// What stands after the fence.
    kind: String,
    text: String,
}

fn reference() -> String {
    fs::read_to_string(root().join("lang/REFERENCE.md")).expect("the reference")
}

fn blocks(text: &str) -> Vec<Block> {
    let mut blocks = Vec::new();
    let mut open: Option<Block> = None;
    for (index, line) in text.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(kind)) => {
                open = Some(Block { line: index + 2, kind: kind.trim().into(), text: String::new() });
            }
            (None, None) => {}
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (Some(block), None) => {
                block.text.push_str(line);
                block.text.push('\n');
            }
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

/// The section under a heading, without it.
fn section<'t>(text: &'t str, heading: &str) -> &'t str {
    let start = text.find(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("no section {heading}"));
    let rest = &text[start + heading.len() + 2..];
    rest.find("\n#").map_or(rest, |end| &rest[..end])
}

/// The rows of the tables in a section, without heads and rules.
fn rows(section: &str) -> Vec<&str> {
    let lines: Vec<&str> = section.lines().collect();
    let is_row = |line: &str| line.starts_with('|');
    let below_rule = |index: usize| {
        let mut above = lines[..index].iter().rev().take_while(|line| is_row(line));
        is_row(lines[index]) && above.any(|line| line.starts_with("|---"))
    };
    (0..lines.len()).filter(|&index| below_rule(index)).map(|index| lines[index]).collect()
}

/// The first cell of each row, without backquotes.
fn first_cells<'t>(rows: &[&'t str]) -> Vec<&'t str> {
    rows.iter().filter_map(|row| row.split('|').nth(1)).map(|cell| cell.trim().trim_matches('`')).collect()
}

/// What a program prints at default params; an error of it is its last line.
fn output(program: &dyn Program) -> String {
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
    let mut text = printed.lock().expect("one thread").clone();
    if let Err(error) = result {
        text.push_str(&format!("error {}: {}\n", error.code, error.message));
    }
    text
}

fn line_of(text: &str, offset: u32) -> usize {
    text.bytes().take(offset as usize).filter(|b| *b == b'\n').count()
}

/// Expectations of a block that were not met, and diagnostics that it does not expect.
fn unexpected(block: &Block, diagnostics: &[Diagnostic]) -> Vec<String> {
    let mut left: Vec<&Diagnostic> = diagnostics.iter().collect();
    let mut problems = Vec::new();
    for (index, line) in block.text.lines().enumerate() {
        for expectation in line.split("//~").skip(1) {
            let above = expectation.chars().take_while(|c| *c == '^').count();
            let text = expectation[above..].trim();
            let (code, message) = text.split_once(' ').unwrap_or((text, ""));
            let found = left.iter().position(|d| {
                d.code == code
                    && d.primary.span.file.0 == 0
                    && line_of(&block.text, d.primary.span.start) + above == index
                    && d.message.contains(message.trim())
            });
            match found {
                Some(at) => drop(left.remove(at)),
                None => problems.push(format!("line {}: not found: {text}", block.line + index)),
            }
        }
    }
    left.retain(|d| !(block.kind == "cx fragment" && d.code == "W0201"));
    let line = |d: &Diagnostic| block.line + line_of(&block.text, d.primary.span.start);
    problems.extend(left.iter().map(|d| format!("line {}: unexpected: {} {}", line(d), d.code, d.message)));
    problems
}

/// Diagnostics as people see them, but for blanks at the ends of lines.
fn shown(checked: &Checked) -> String {
    let mut renderer = Renderer::new(&checked.files, Colour::Never);
    let text: String = checked.diagnostics.iter().map(|diagnostic| renderer.text(diagnostic)).collect();
    text.lines().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// What is wrong with a model of the reference, given the block after it.
fn judge(block: &Block, next: Option<&Block>, folder: &Path) -> Vec<String> {
    let file = folder.join("model.cx");
    fs::write(&file, &block.text).expect("a temporary file");
    let mut checked = check_file(&file).expect("a readable file");
    let mut problems = unexpected(block, &checked.diagnostics);
    if let Some(next) = next.filter(|next| next.kind == "diagnostic") {
        checked.files[0].name = "model.cx".into();
        let found = shown(&checked);
        if found != next.text {
            problems.push(format!("line {}: it is shown as\n{found}", next.line));
        }
    }
    let printed = next.filter(|next| next.kind == "text" && problems.is_empty());
    let Some(printed) = printed.map(|next| next.text.as_str()) else { return problems };
    let Some(program) = checked.program.clone() else {
        return vec![format!("line {}: prints nothing, it has errors", block.line)];
    };
    let interpreted = Interpreted::new(&program, Purity::Effect).expect("the interpreter");
    let compiled = Module::compile(checked).expect("machine code");
    for (way, found) in [("interpreted", output(&interpreted)), ("compiled", output(&compiled))] {
        if found != printed {
            problems.push(format!("line {}: {way}, it prints\n{found}", block.line));
        }
    }
    problems
}

#[test]
fn every_snippet_is_judged_and_prints_as_it_says() {
    let blocks = blocks(&reference());
    let folder = tempfile::tempdir().expect("a temporary folder");
    for block in &blocks {
        if let Some(name) = block.kind.strip_prefix("cx module ") {
            fs::write(folder.path().join(format!("{name}.cx")), &block.text).expect("a temporary file");
        }
    }
    let mut problems = Vec::new();
    for (index, block) in blocks.iter().enumerate() {
        if block.kind == "cx" || block.kind == "cx fragment" {
            problems.extend(judge(block, blocks.get(index + 1), folder.path()));
        }
    }
    assert!(problems.is_empty(), "lang/REFERENCE.md\n{}", problems.join("\n"));
}

/// Compares tables line by line; what differs is shown as it should be.
fn same_rows(what: &str, found: &[&str], wanted: &[String]) {
    let wrong: Vec<&str> = wanted.iter().map(String::as_str).filter(|row| !found.contains(row)).collect();
    assert!(wrong.is_empty(), "{what}: these rows should be there\n{}", wrong.join("\n"));
    assert_eq!(found, wanted, "{what}: rows too many or out of order");
}

/// Without the rounding of the sixteenth digit that products of exact factors have.
fn in_fifteen_digits(value: f64) -> String {
    let rounded: f64 = format!("{value:.14e}").parse().expect("a number");
    if (1e-4..1e7).contains(&rounded) { format!("{rounded}") } else { format!("{rounded:e}") }
}

#[test]
fn the_table_of_units_is_the_compilers() {
    let wanted: Vec<String> = Unit::all()
        .iter()
        .map(|unit| {
            let aliases: Vec<String> = unit.aliases.iter().map(|alias| format!("`{alias}`")).collect();
            let si = UnitSystem::Si.unit_of(unit.dimension).name;
            let row = format!(
                "| `{}` | {} | {} | {} {si} |",
                unit.name,
                aliases.join(" "),
                unit.dimension,
                in_fifteen_digits(unit.factor)
            );
            row.replace("  ", " ")
        })
        .collect();
    same_rows("units", &rows(section(&reference(), "### Table of units")), &wanted);
}

#[test]
fn the_table_of_unit_systems_is_the_compilers() {
    let text = reference();
    let rows = rows(section(&text, "### Unit systems"));
    let names = first_cells(&rows);
    let wanted: Vec<String> = names
        .iter()
        .map(|name| {
            let dimension = Dimension::from_name(name).unwrap_or_else(|| panic!("no dimension {name}"));
            let units: Vec<String> = UnitSystem::ALL
                .iter()
                .map(|system| format!("`{}`", system.unit_of(dimension).name))
                .collect();
            format!("| {name} | {} |", units.join(" | "))
        })
        .collect();
    assert!(names.len() > 5);
    same_rows("unit systems", &rows, &wanted);
}

/// The words in backquotes in a section.
fn quoted(section: &str) -> BTreeSet<&str> {
    section.split('`').skip(1).step_by(2).collect()
}

#[test]
fn words_and_dimensions_are_all_there() {
    let text = reference();
    let words = quoted(section(&text, "### Words of the language"));
    for word in lexer::keywords() {
        assert!(words.contains(word), "the word `{word}` is missing");
    }
    let dimensions = quoted(section(&text, "### Names of dimensions"));
    for name in Dimension::names() {
        assert!(dimensions.contains(name), "the dimension `{name}` is missing");
    }
}

#[test]
fn every_builtin_name_is_there() {
    let text = reference();
    let rows = rows(section(&text, "### Table of builtin names"));
    let documented: BTreeSet<&str> =
        first_cells(&rows).into_iter().map(|cell| cell.split('(').next().unwrap_or_default()).collect();
    assert_eq!(documented, calyx_lang::check::builtin_names().collect());
}

#[test]
fn every_code_of_the_language_is_there() {
    let wanted: Vec<String> =
        codes::all().iter().map(|code| format!("| {} | {} |", code.code, code.title)).collect();
    same_rows("codes", &rows(section(&reference(), "### Codes of the language")), &wanted);
}

/// Codes in string literals of a crate's sources.
fn codes_in(folder: &Path, codes: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).expect("sources") {
        let path = entry.expect("a file").path();
        if path.is_dir() {
            codes_in(&path, codes);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            let text = fs::read_to_string(&path).expect("readable");
            let is_code = |piece: &&str| {
                piece.len() == 5 && piece.starts_with('E') && piece[1..].bytes().all(|b| b.is_ascii_digit())
            };
            codes.extend(text.split('"').filter(is_code).map(str::to_string));
        }
    }
}

#[test]
fn every_code_of_library_and_engine_is_there() {
    let mut used = BTreeSet::new();
    for folder in ["compiler/src", "runtime/abi/src", "runtime/src", "runtime/rt/src", "stdlib-gears/src"] {
        codes_in(&root().join(folder), &mut used);
    }
    for code in codes::all() {
        used.remove(code.code);
    }
    let text = reference();
    let listed = rows(section(&text, "### Codes of library and engine"));
    let listed: BTreeSet<String> = first_cells(&listed).into_iter().map(str::to_string).collect();
    assert_eq!(listed, used);
}
