//! Runs the library's tests, which are written in Calyx, and checks its reference pages.

use calyx::doc;
use calyx::testing::{files_with_tests, test_file};
use std::path::Path;
use std::sync::Arc;

#[test]
fn tests_of_the_library_pass() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-gears/calyx/tests");
    let files = files_with_tests(&folder).expect("the library has tests");
    let mut ran = 0;
    for file in files {
        let tested = test_file(&file, &Arc::default(), "").expect("it can be read");
        let problems: Vec<_> = tested.outcomes.iter().filter_map(|outcome| outcome.failure.clone()).collect();
        let problems = [tested.errors.clone(), problems].concat();
        assert!(problems.is_empty(), "{}", calyx::render(&problems, &tested.files));
        ran += tested.passed();
    }
    assert!(ran >= 9, "only {ran} tests ran");
}

/// Every declaration of the library has a description.
#[test]
fn everything_in_the_library_is_documented() {
    for name in doc::library() {
        let page = doc::page(name, &Arc::default()).expect("a module of the library");
        assert_ne!(page.doc, "", "{name}");
        for entry in &page.entries {
            assert_ne!(entry.doc, "", "{name}.{}", entry.name);
        }
    }
}

/// Compares the reference text of the gear library with its snapshot. `CALYX_BLESS=1` rewrites it.
#[test]
fn the_reference_of_the_gears_says_what_it_said() {
    let expected = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/gears.txt");
    let text = doc::text(&doc::page("gears", &Arc::default()).expect("a module of the library"));
    if std::env::var_os("CALYX_BLESS").is_some() {
        std::fs::write(&expected, &text).expect("it can be written");
    }
    let old = std::fs::read_to_string(&expected).expect("tests/data/gears.txt");
    assert_eq!(text, old, "if the change is meant, run this test with CALYX_BLESS=1");
}

/// Link targets of a page are on one of the pages.
#[test]
fn links_of_the_reference_lead_somewhere() {
    let directory = tempfile::tempdir().expect("a directory");
    let pages: Vec<_> =
        doc::library().into_iter().map(|name| doc::page(name, &Arc::default()).expect("a module")).collect();
    doc::write(&pages, directory.path(), false).expect("they can be written");
    let read = |name: &str| std::fs::read_to_string(directory.path().join(name)).unwrap_or_default();
    let mut links = 0;
    for page in std::fs::read_dir(directory.path()).expect("the directory") {
        let own = page.expect("a file").file_name().to_string_lossy().into_owned();
        for link in read(&own).split("href=\"").skip(1).filter_map(|rest| rest.split('"').next()) {
            let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = read(if file.is_empty() { &own } else { file });
            assert!(
                target.contains(&format!("id=\"{anchor}\"")) || anchor.is_empty() && !target.is_empty(),
                "{own}: {link}"
            );
            links += 1;
        }
    }
    assert!(links > 50, "only {links} links");
}
