//! Tests the formatter with pairs of texts (`format/*.md`) and with every program of the
//! repository.
//!
//! In a page, a `cx` block is the input and the following `formatted` block the expected output; a
//! `cx` block without one has errors and is not formatted. `CALYX_BLESS=1` rewrites the expected
//! outputs.

use crate::formatting::judge;
use calyx_lang::format::{FormatContext, FormatError, WIDTH, format, format_part, format_range};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Collects all files below a folder with an ending.
fn files(folder: &Path, ending: &str, found: &mut Vec<PathBuf>) {
    let mut entries: Vec<PathBuf> = fs::read_dir(folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .map(|entry| entry.unwrap().path())
        .collect();
    entries.sort();
    for path in entries {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() && name != "target" && !name.starts_with('.') {
            files(&path, ending, found);
        } else if name.ends_with(ending) {
            found.push(path);
        }
    }
}

fn found(folder: &str, ending: &str) -> Vec<PathBuf> {
    let mut paths = Vec::new();
    files(&root().join(folder), ending, &mut paths);
    paths
}

/// Returns the blocks of a page with one of these fences, with their lines.
fn blocks<'t>(page: &'t str, kinds: &[&str]) -> Vec<(usize, &'t str, &'t str)> {
    let mut blocks = Vec::new();
    let mut open: Option<(usize, &str, usize)> = None;
    let mut offset = 0;
    for (index, line) in page.split_inclusive('\n').enumerate() {
        if let Some(kind) = line.trim_end().strip_prefix("```") {
            open = match open {
                Some((at, kind, start)) => {
                    if kinds.contains(&kind) {
                        blocks.push((at, kind, &page[start..offset]));
                    }
                    None
                }
                None => Some((index + 2, kind, offset + line.len())),
            };
        }
        offset += line.len();
    }
    blocks
}

#[test]
fn pages_are_formatted_as_they_say() {
    let bless = std::env::var_os("CALYX_BLESS").is_some();
    let mut failures = Vec::new();
    let mut programs = 0;
    for path in found("lang/tests/format", ".md") {
        let page = fs::read_to_string(&path).unwrap();
        let mut blessed = page.clone();
        let all = blocks(&page, &["cx", "formatted"]);
        for (index, (line, kind, text)) in all.iter().enumerate() {
            if *kind != "cx" {
                continue;
            }
            programs += 1;
            let name = format!("{}:{line}", path.file_name().unwrap().to_string_lossy());
            if let Err(problem) = judge(text) {
                failures.push(format!("{name}: {problem}"));
            }
            match (format(text), all.get(index + 1).filter(|(_, kind, _)| *kind == "formatted")) {
                (Ok(formatted), Some((_, _, expected))) if formatted != *expected => {
                    blessed = blessed.replacen(
                        &format!("```cx\n{text}```\n\n```formatted\n{expected}```"),
                        &format!("```cx\n{text}```\n\n```formatted\n{formatted}```"),
                        1,
                    );
                    if !bless {
                        failures.push(format!("{name}: becomes\n{formatted}"));
                    }
                }
                (Ok(_), None) => failures.push(format!("{name}: no `formatted` block follows")),
                (Err(_), Some(_)) => failures.push(format!("{name}: is not formatted")),
                (Ok(_), Some(_)) | (Err(_), None) => {}
            }
        }
        if bless {
            fs::write(&path, blessed).unwrap();
        }
    }
    assert!(programs > 10, "only {programs} programs found");
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

/// Models, library and tests have the format of `calyx fmt`. `CALYX_BLESS=1` formats them.
#[test]
fn programs_of_the_repository_are_formatted() {
    let bless = std::env::var_os("CALYX_BLESS").is_some();
    let mut paths = found("", ".cx");
    // The samples for syntax highlighting need not be valid or formatted.
    paths.retain(|path| !path.components().any(|part| part.as_os_str() == "grammar"));
    assert!(paths.len() >= 3);
    let mut failures = Vec::new();
    for path in paths {
        let text = fs::read_to_string(&path).unwrap();
        match format(&text) {
            Ok(formatted) if formatted == text => {}
            Ok(formatted) if bless => fs::write(&path, formatted).unwrap(),
            Ok(_) => failures.push(format!("{}: run `calyx fmt`", path.display())),
            Err(problem) => failures.push(format!("{}: {problem:?}", path.display())),
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// So are the models on the pages of the book, which people copy.
#[test]
fn snippets_of_the_book_are_formatted() {
    let bless = std::env::var_os("CALYX_BLESS").is_some();
    let mut failures = Vec::new();
    for path in found("docs", ".md") {
        let original = fs::read_to_string(&path).unwrap();
        let mut page = original.clone();
        for (line, kind, text) in blocks(&original, &["cx", "cx fragment"]) {
            let place = format!("{}:{line}", path.display());
            match format(text) {
                Ok(formatted) if formatted == text => {}
                // The example of unformatted text.
                Ok(_) if text.starts_with("// before") => {}
                Ok(formatted) if bless => {
                    let fenced = |text: &str| format!("```{kind}\n{text}```");
                    page = page.replacen(&fenced(text), &fenced(&formatted), 1);
                }
                Ok(formatted) => failures.push(format!("{place}: not\n{text}but\n{formatted}")),
                // Examples of syntax errors.
                Err(FormatError::Errors(_)) if text.contains("//~") => {}
                Err(problem) => failures.push(format!("{place}: {problem:?}")),
            }
        }
        if page != original {
            fs::write(&path, page).unwrap();
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// Formatting any program of any test preserves tree and comments, and is idempotent.
#[test]
fn formatting_changes_no_program() {
    let mut failures = Vec::new();
    let mut programs = 0;
    for path in found("", ".cx") {
        programs += 1;
        if let Err(problem) = judge(&fs::read_to_string(&path).unwrap()) {
            failures.push(format!("{}: {problem}", path.display()));
        }
    }
    for path in found("", ".md") {
        let page = fs::read_to_string(&path).unwrap();
        for (line, _, text) in blocks(&page, &["cx", "cx fragment", "formatted"]) {
            programs += 1;
            if let Err(problem) = judge(text) {
                failures.push(format!("{}:{line}: {problem}", path.display()));
            }
        }
    }
    assert!(programs > 150, "only {programs} programs found");
    assert!(failures.is_empty(), "\n{}", failures.join("\n"));
}

#[test]
fn lines_are_as_long_as_they_may_be() {
    for terms in 2..60 {
        for text in [
            format!("var x = {};\n", vec!["term"; terms].join("+")),
            format!("f({});\n", vec!["argument"; terms].join(",")),
            format!("f({});\n", vec!["name = 1 inch"; terms].join(",")),
            format!("var x = [{}];\n", vec!["[1, 2, 3]"; terms].join(",")),
        ] {
            let formatted = judge(&text).unwrap();
            assert!(formatted.lines().all(|line| line.chars().count() <= WIDTH), "{formatted}");
            let one_line = formatted.split_whitespace().collect::<Vec<_>>().join(" ");
            assert_eq!(formatted.lines().count() == 1, one_line.chars().count() <= WIDTH, "{formatted}");
        }
    }
}

#[test]
fn a_selection_is_formatted_alone() {
    let text = "var a=1;\nvar b=2;\nvar c=3;\n";
    let start = text.find("var b").unwrap() as u32;
    let edits = format_range(text, start + 4..start + 6).unwrap();
    assert_eq!(edits.len(), 2, "{edits:?}");
    assert!(edits.iter().all(|e| e.span.start > start && e.span.end < start + 8 && e.replacement == " "));
}

#[test]
fn a_part_is_laid_out_as_in_its_file() {
    let statement = format!("var x=f({}, 3 euro*mm);", ["arguments"; 7].join(","));
    let file =
        format!("unit euro: Cost;\nfunction g() {{\n    if (TRUE) {{\n        {statement}\n    }}\n}}\n");
    let place = FormatContext { units: ["euro".to_string()].into(), indent: 8 };
    let mut part = statement.clone();
    for edit in format_part(&statement, &place).unwrap().iter().rev() {
        part.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.replacement);
    }
    assert_eq!(format(&file).unwrap(), file.replace(&statement, &part));
    // The indentation counts: without it, the statement would fit on one line.
    assert!(part.contains('\n') && !format(&statement).unwrap().trim_end().contains('\n'), "{part}");
    assert!(matches!(format_part("var x = ;", &place), Err(FormatError::Errors(_))));
}
