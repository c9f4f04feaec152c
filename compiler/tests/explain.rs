//! Tests of the explanations of diagnostic codes. Every code has a page, every example shows its
//! code, and the corrected form of an example has no errors.

use calyx::check_text;
use calyx::explain::{all, example, examples, explanation};
use std::collections::BTreeSet;
use std::path::Path;

#[test]
fn examples_show_their_code_and_are_fixed() {
    let mut wrong = String::new();
    for example in examples() {
        let codes = |text: &str| -> Vec<(String, bool)> {
            let found = check_text("example.cx", text).diagnostics;
            let is_error = |d: &calyx_lang::diagnostic::Diagnostic| {
                d.severity == calyx_lang::diagnostic::Severity::Error
            };
            found.iter().map(|d| (d.code.clone(), is_error(d))).collect()
        };
        let (shown, fixed) = (codes(example.wrong), codes(example.fixed));
        if !shown.iter().any(|(code, _)| code == example.code) {
            wrong += &format!("{}: the example gives {shown:?}\n", example.code);
        }
        if fixed.iter().any(|(code, error)| *error || code == example.code) {
            wrong += &format!("{}: the fixed example gives {fixed:?}\n", example.code);
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
}

#[test]
fn a_code_has_one_page_and_at_most_one_example() {
    let mut seen = BTreeSet::new();
    for explanation in all() {
        assert!(seen.insert(explanation.code), "{} stands twice", explanation.code);
    }
    let mut shown = BTreeSet::new();
    for example in examples() {
        assert!(explanation(example.code).is_some(), "{} has an example and no page", example.code);
        assert!(shown.insert(example.code), "{} has two examples", example.code);
    }
    assert!(example("E0401").is_some());
}

/// Compares the codes in the sources of library and engine with the pages of both.
#[test]
fn every_code_of_library_and_engine_has_a_page() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut codes = BTreeSet::new();
    for folder in [
        "stdlib-gears/src",
        "runtime/analysis/src",
        "runtime/solve/src",
        "runtime/model/src",
        "runtime/contact/src",
        "runtime/structure/src",
        "runtime/fe/src",
        "runtime/numerics/src",
        "runtime/abi/src",
        "runtime/report/src",
        "runtime/rt/src",
        "compiler/src",
        "compiler/lower/src",
    ] {
        codes_in(&root.join(folder), &mut codes);
    }
    let missing: Vec<&String> = codes.iter().filter(|code| explanation(code).is_none()).collect();
    assert!(missing.is_empty(), "no page for {missing:?}");
    assert!(codes.len() > 60, "only {} codes found", codes.len());
}

fn codes_in(directory: &Path, codes: &mut BTreeSet<String>) {
    for entry in std::fs::read_dir(directory).expect("sources") {
        let path = entry.expect("a file").path();
        if path.is_dir() {
            codes_in(&path, codes);
        } else if path.extension().is_some_and(|extension| extension == "rs")
            && !path.ends_with("explain/engine.rs")
        {
            let text = std::fs::read_to_string(&path).expect("readable");
            // Tests may contain invented codes.
            let text = text.split("#[cfg(test)]").next().unwrap_or_default();
            let is_code = |piece: &&str| {
                piece.len() == 5
                    && piece.starts_with(['E', 'W'])
                    && piece[1..].bytes().all(|b| b.is_ascii_digit())
            };
            codes.extend(text.split('"').filter(is_code).map(str::to_owned));
        }
    }
}

/// The reference lists the same codes with the same titles.
#[test]
fn the_reference_has_the_titles_of_the_pages() {
    let reference =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/reference.md"));
    let reference = reference.expect("the reference");
    let mut rows = 0;
    for row in reference.lines().filter(|line| line.starts_with("| E") || line.starts_with("| W")) {
        let cells: Vec<&str> = row.trim_matches('|').split('|').map(str::trim).collect();
        let [code, title] = cells[..] else { continue };
        let page = explanation(code).unwrap_or_else(|| panic!("no page for {code}"));
        assert_eq!(page.title, title, "{code}");
        rows += 1;
    }
    assert!(rows > 100, "only {rows} rows");
}
