//! The language corpus: every case of `tests/language/` is compiled, checked and run. Together the
//! cases cover the whole language ([`calyx_tests::coverage`]).
//!
//! `CALYX_BLESS=1` rewrites the expectations, except those in comments.

use calyx_tests::coverage::corpus::Coverage;
use calyx_tests::document::Document;
use calyx_tests::judge::{judge, write_files};
use calyx_tests::{blessing, root};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Collects the Markdown files of a directory.
fn documents(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("the corpus") {
        let path = entry.expect("a file").path();
        if path.is_dir() {
            documents(&path, files);
        } else if path.extension().is_some_and(|e| e == "md") {
            files.push(path);
        }
    }
}

fn folder() -> PathBuf {
    root().join("tests/language")
}

fn corpus() -> Vec<(PathBuf, Document)> {
    let mut files = Vec::new();
    documents(&folder(), &mut files);
    files.sort();
    let read = |path: PathBuf| {
        let name = path.strip_prefix(folder()).unwrap_or(&path).display().to_string();
        let document = Document::read(&path, &name);
        (path, document)
    };
    files.into_iter().map(read).collect()
}

#[test]
fn every_case_is_as_it_says_and_together_they_leave_no_hole() {
    let mut coverage = Coverage::new();
    let mut problems = Vec::new();
    for (path, document) in corpus() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        write_files(&document, folder.path());
        let mut differing = Vec::new();
        for case in &document.cases {
            let judgement = judge(case, folder.path());
            let place = |(line, problem): &(usize, String)| format!("{}:{line}: {problem}", document.name);
            problems.extend(judgement.problems.iter().map(place));
            coverage.add(&document, case, &judgement);
            differing.extend(judgement.differing);
        }
        if blessing() && !differing.is_empty() {
            fs::write(&path, document.with_blocks_replaced(&differing)).expect("the corpus is writable");
        }
    }
    coverage.add_other_tests();
    assert!(problems.is_empty(), "tests/language\n{}", problems.join("\n"));
    let holes = coverage.holes();
    assert!(holes.is_empty(), "without a case:\n{}", holes.join("\n"));
}

#[test]
fn headings_are_unique_in_a_document() {
    for (_, document) in corpus() {
        let mut seen = BTreeSet::new();
        for case in &document.cases {
            assert!(seen.insert(&case.heading), "{}: `{}` stands twice", document.name, case.heading);
        }
    }
}
