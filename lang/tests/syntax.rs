//! Tests the parser with fixtures: `syntax/*.md` contain programs with the expected tree or errors.
//!
//! A fixture is a fenced `cx` block. Expected errors are comments in the program, on the line below
//! their location (`//  ^ E0110 words of the message`) or above it (`//  v E0102`). A program
//! without such marks must have no errors, and a following `tree` block contains its tree.
//! `CALYX_BLESS=1` rewrites the trees.

use calyx_lang::tree_text as tree;

use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

fn folder(relative: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(relative)
}

fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|e| e == extension))
        .collect();
    paths.sort();
    paths
}

/// Returns line and column of a byte, both counted from 1.
fn line_column(text: &str, byte: usize) -> (usize, usize) {
    let before = &text[..byte];
    let line_start = before.rfind('\n').map_or(0, |i| i + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

struct Mark {
    line: usize,
    column: usize,
    code: String,
    words: String,
}

fn marks(program: &str) -> Vec<Mark> {
    let mut found = Vec::new();
    for (index, line) in program.lines().enumerate() {
        let Some(comment) = line.trim_start().strip_prefix("//") else { continue };
        let Some((arrow, rest)) = comment.trim_start().split_once(' ') else { continue };
        let mut words = rest.splitn(2, ' ');
        let code = words.next().unwrap_or_default().to_string();
        let is_code = code.len() == 5 && code.starts_with(['E', 'W']) && code[1..].parse::<u32>().is_ok();
        let down = match arrow.trim_matches('^') {
            "" => false,
            "v" => true,
            _ => continue,
        };
        if is_code {
            let column = line.find(['^', 'v']).unwrap_or(0) + 1;
            let line = if down { index + 2 } else { target_line(program, index) };
            found.push(Mark { line, column, code, words: words.next().unwrap_or_default().to_string() });
        }
    }
    found
}

/// Returns the nearest line above a mark that is not a mark itself, counted from 1.
fn target_line(program: &str, mark: usize) -> usize {
    let lines: Vec<&str> = program.lines().collect();
    let is_mark =
        |line: &str| line.trim_start().strip_prefix("//").is_some_and(|c| c.trim_start().starts_with('^'));
    (0..mark).rev().find(|i| !is_mark(lines[*i])).map_or(0, |i| i + 1)
}

fn check_errors(name: &str, program: &str, diagnostics: &[Diagnostic], failures: &mut Vec<String>) {
    let expected = marks(program);
    let place = |d: &Diagnostic| line_column(program, d.primary.span.start as usize);
    for mark in &expected {
        let hit = diagnostics.iter().any(|d| {
            d.code == mark.code && place(d) == (mark.line, mark.column) && d.message.contains(&mark.words)
        });
        if !hit {
            failures
                .push(format!("{name}: no {} `{}` at {}:{}", mark.code, mark.words, mark.line, mark.column));
        }
    }
    let at: BTreeSet<_> = expected.iter().map(|m| (m.code.as_str(), m.line, m.column)).collect();
    for d in diagnostics {
        let (line, column) = place(d);
        if !at.contains(&(d.code.as_str(), line, column)) {
            failures.push(format!("{name}: unexpected {} `{}` at {line}:{column}", d.code, d.message));
        }
    }
}

#[test]
fn fixtures_parse_as_they_say() {
    let bless = std::env::var_os("CALYX_BLESS").is_some();
    let mut failures = Vec::new();
    let mut programs = 0;
    for path in files(&folder("tests/syntax"), "md") {
        let document = fs::read_to_string(&path).unwrap();
        let mut blessed = String::new();
        let mut rest = document.as_str();
        while let Some(begin) = rest.find("```cx\n") {
            let body = &rest[begin + 6..];
            let end = body.find("```").expect("a fence closes");
            let program = &body[..end];
            let heading = rest[..begin].lines().rev().find(|l| l.starts_with('#')).unwrap_or("");
            let name = format!("{} {heading}", path.file_name().unwrap().to_string_lossy());
            programs += 1;

            let (module, diagnostics) = parse(FileId(0), program);
            check_errors(&name, program, &diagnostics, &mut failures);
            let printed = tree::print(&module);
            blessed.push_str(&rest[..begin + 6 + end + 4]);
            rest = &body[end + 4..];
            if let Some(tree_body) = rest.trim_start().strip_prefix("```tree\n") {
                let tree_end = tree_body.find("```").expect("a fence closes");
                if tree_body[..tree_end] != printed && !bless {
                    failures
                        .push(format!("{name}: the tree is\n{printed}and not\n{}", &tree_body[..tree_end]));
                }
                blessed.push_str(&format!("\n```tree\n{printed}```\n"));
                rest = tree_body[tree_end + 3..].strip_prefix('\n').unwrap_or("");
            }
        }
        blessed.push_str(rest);
        if bless {
            fs::write(&path, blessed).unwrap();
        }
    }
    assert!(programs > 30, "only {programs} programs found");
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[test]
fn examples_and_library_parse_without_errors() {
    let mut paths = files(&folder("../examples"), "cx");
    paths.extend(files(&folder("../stdlib-gears/calyx"), "cx"));
    assert!(paths.len() >= 3);
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        let (module, diagnostics) = parse(FileId(0), &text);
        let shown: Vec<_> = diagnostics
            .iter()
            .map(|d| (&d.code, &d.message, line_column(&text, d.primary.span.start as usize)))
            .collect();
        assert!(shown.is_empty(), "{}: {shown:?}", path.display());
        assert!(!module.statements.is_empty());
    }
}

/// A suggested fix must remove its error.
#[test]
fn offered_fixes_fix_their_errors() {
    let mut applied = 0;
    for path in files(&folder("tests/syntax"), "md") {
        let document = fs::read_to_string(&path).unwrap();
        for program in document.split("```cx\n").skip(1).filter_map(|body| body.split("```").next()) {
            let (_, before) = parse(FileId(0), program);
            for problem in &before {
                let Some(fix) = &problem.fix else { continue };
                let mut fixed = program.to_string();
                fixed.replace_range(fix.span.start as usize..fix.span.end as usize, &fix.replacement);
                let (_, after) = parse(FileId(0), &fixed);
                assert!(after.len() < before.len(), "{}: {}\n{fixed}{after:#?}", path.display(), fix.title);
                applied += 1;
            }
        }
    }
    assert!(applied >= 8, "only {applied} fixes");
}

/// Every code must have a fixture. Nesting has separate tests.
#[test]
fn every_syntax_code_has_a_fixture() {
    let mut sources = files(&folder("src/parser"), "rs");
    sources.push(folder("src/lexer.rs"));
    let mut used = BTreeSet::new();
    for path in sources {
        let text = fs::read_to_string(&path).unwrap();
        used.extend(text.split('"').filter(|s| s.len() == 5 && s[1..].starts_with("01")).map(str::to_string));
    }
    assert!(used.len() > 15, "{used:?}");
    let fixtures: String =
        files(&folder("tests/syntax"), "md").iter().map(|p| fs::read_to_string(p).unwrap()).collect();
    let missing: Vec<_> = used.iter().filter(|c| *c != "E0106" && !fixtures.contains(c.as_str())).collect();
    assert!(missing.is_empty(), "{missing:?}");
}
