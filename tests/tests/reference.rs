//! Checks that `docs/reference.md` matches the language: every snippet is checked and run, and its
//! tables are compared with the compiler's lists.
//!
//! Its blocks are those of [`calyx_tests::document`].

use calyx_lang::dimension::Dimension;
use calyx_lang::units::{Unit, UnitSystem};
use calyx_lang::{codes, lexer};
use calyx_tests::document::Document;
use calyx_tests::judge::{judge, write_files};
use calyx_tests::root;
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

fn reference() -> String {
    fs::read_to_string(root().join("docs/reference.md")).expect("the reference")
}

/// Returns the section under a heading, without the heading.
fn section<'t>(text: &'t str, heading: &str) -> &'t str {
    let start = text.find(&format!("\n{heading}\n")).unwrap_or_else(|| panic!("no section {heading}"));
    let rest = &text[start + heading.len() + 2..];
    rest.find("\n#").map_or(rest, |end| &rest[..end])
}

/// Returns the rows of the tables in a section, without header and delimiter rows.
fn rows(section: &str) -> Vec<&str> {
    let lines: Vec<&str> = section.lines().collect();
    let is_row = |line: &str| line.starts_with('|');
    let below_rule = |index: usize| {
        let mut above = lines[..index].iter().rev().take_while(|line| is_row(line));
        is_row(lines[index]) && above.any(|line| line.starts_with("|---"))
    };
    (0..lines.len()).filter(|&index| below_rule(index)).map(|index| lines[index]).collect()
}

/// Returns the first cell of each row, without backquotes.
fn first_cells<'t>(rows: &[&'t str]) -> Vec<&'t str> {
    rows.iter().filter_map(|row| row.split('|').nth(1)).map(|cell| cell.trim().trim_matches('`')).collect()
}

#[test]
fn every_snippet_is_judged_and_prints_as_it_says() {
    let document = Document::read(&root().join("docs/reference.md"), "docs/reference.md");
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_files(&document, folder.path());
    let mut problems = Vec::new();
    for case in &document.cases {
        for (line, problem) in judge(case, folder.path()).problems {
            problems.push(format!("line {line}: {problem}"));
        }
    }
    assert!(problems.is_empty(), "docs/reference.md\n{}", problems.join("\n"));
}

/// Compares tables line by line; shows the expected form of lines that differ.
fn same_rows(what: &str, found: &[&str], wanted: &[String]) {
    let wrong: Vec<&str> = wanted.iter().map(String::as_str).filter(|row| !found.contains(row)).collect();
    assert!(wrong.is_empty(), "{what}: these rows should be there\n{}", wrong.join("\n"));
    assert_eq!(found, wanted, "{what}: rows too many or out of order");
}

/// Formats a number without the rounding of the sixteenth digit in products of exact factors.
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

/// Returns the words in backquotes in a section.
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

/// Collects codes in string literals of a crate's sources.
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
    for folder in [
        "compiler/src",
        "runtime/abi/src",
        "runtime/numerics/src",
        "runtime/fe/src",
        "runtime/structure/src",
        "runtime/contact/src",
        "runtime/model/src",
        "runtime/solve/src",
        "runtime/analysis/src",
        "runtime/report/src",
        "runtime/rt/src",
        "stdlib-gears/src",
    ] {
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
