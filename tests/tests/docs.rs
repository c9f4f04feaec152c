//! Checks the documentation: every relative link and anchor resolves, every page of the book is in
//! its table of contents, every complete model on a page passes `check`, and recipes name existing
//! files.
//!
//! `compiler/tests/docs.rs` compares the output of the commands on pages of the book.

use calyx_tests::document::{Document, anchor};
use calyx_tests::judge::{judge, write_files};
use calyx_tests::root;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// Returns the root of the repository, without `..` in its path.
fn home() -> PathBuf {
    normal(&root())
}

/// Collects Markdown files of a directory, without those of package managers and builds.
fn markdown(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name").to_string_lossy();
        if path.is_dir() && !["node_modules", "target"].contains(&&*name) && !name.starts_with('.') {
            markdown(&path, files);
        } else if path.extension().is_some_and(|extension| extension == "md") {
            files.push(path);
        }
    }
}

/// Returns the pages of the book except its table of contents.
fn pages() -> Vec<PathBuf> {
    let mut files = Vec::new();
    markdown(&home().join("docs"), &mut files);
    files.retain(|path| !path.ends_with("SUMMARY.md"));
    files.sort();
    assert!(files.len() > 10, "only {} pages", files.len());
    files
}

/// Returns pages with links: those of the book, at the top level, of the examples and of the
/// editors.
fn linking() -> Vec<PathBuf> {
    let mut files = pages();
    files.push(home().join("docs/SUMMARY.md"));
    markdown(&home().join("examples"), &mut files);
    markdown(&home().join("lsp/editors"), &mut files);
    for entry in fs::read_dir(home()).expect("the root") {
        files.push(entry.expect("an entry").path());
    }
    files.retain(|path| path.extension().is_some_and(|extension| extension == "md"));
    files.sort();
    files
}

/// Returns a path without `.` and `..`.
fn normal(path: &Path) -> PathBuf {
    let mut result = PathBuf::new();
    for component in path.components() {
        match component {
            Component::CurDir => {}
            Component::ParentDir => {
                result.pop();
            }
            other => result.push(other),
        }
    }
    result
}

/// Returns the numbered lines outside of fenced blocks, with inline code blanked out.
fn prose(text: &str) -> Vec<(usize, String)> {
    let mut fence = None;
    let mut lines = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let start = line.trim_start();
        let marks = start.chars().take_while(|c| *c == '`').count();
        match fence {
            None if marks >= 3 => fence = Some(marks),
            Some(length) if marks >= length && start[marks..].trim().is_empty() => fence = None,
            Some(_) => {}
            None => {
                let pieces = line.split('`').enumerate();
                let kept: Vec<&str> =
                    pieces.map(|(place, piece)| if place % 2 == 0 { piece } else { "" }).collect();
                lines.push((index + 1, kept.concat()));
            }
        }
    }
    lines
}

/// Returns targets of links and images with their lines: `[text](target)`, `<img src="target">` and
/// `[name]: target`.
fn links(text: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    for (line, text) in prose(text) {
        for rest in text.split("](").skip(1) {
            let target = rest.split([')', ' ']).next().unwrap_or_default();
            found.push((line, target.to_owned()));
        }
        for rest in text.split("src=\"").skip(1).chain(text.split("href=\"").skip(1)) {
            found.extend(rest.split_once('"').map(|(target, _)| (line, target.to_owned())));
        }
        if let Some((_, target)) = text.strip_prefix('[').and_then(|rest| rest.split_once("]: ")) {
            found.push((line, target.trim().to_owned()));
        }
    }
    found
}

/// Returns the anchors of a page's headings as in GitHub and mdBook: a repeated name has the suffix
/// `-1`.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut count: BTreeMap<String, usize> = BTreeMap::new();
    let mut fenced = false;
    let mut found = BTreeSet::new();
    for line in text.lines() {
        fenced ^= line.starts_with("```");
        let title = line.trim_start_matches('#');
        if fenced || title.len() == line.len() || !title.starts_with(' ') {
            continue;
        }
        let name = anchor(title.trim());
        let times = count.entry(name.clone()).or_default();
        found.insert(if *times == 0 { name } else { format!("{name}-{times}") });
        *times += 1;
    }
    found
}

#[test]
fn every_link_resolves() {
    let mut problems = Vec::new();
    for path in linking() {
        let text = fs::read_to_string(&path).expect("readable");
        let name = path.strip_prefix(home()).expect("below the root").display().to_string();
        for (line, link) in links(&text) {
            if ["http://", "https://", "mailto:"].iter().any(|scheme| link.starts_with(scheme)) {
                continue;
            }
            let (file, wanted) = link.split_once('#').map_or((&*link, None), |(f, a)| (f, Some(a)));
            let target = match file {
                "" => path.clone(),
                file => normal(&path.parent().expect("a folder").join(file)),
            };
            if !target.exists() {
                problems.push(format!("{name}:{line}: no file `{link}`"));
            } else if let Some(wanted) = wanted {
                let text = fs::read_to_string(&target).expect("a page has anchors");
                if !anchors(&text).contains(wanted) {
                    problems.push(format!("{name}:{line}: no heading `{link}`"));
                }
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn the_summary_lists_every_page_once() {
    let folder = home().join("docs");
    let text = fs::read_to_string(folder.join("SUMMARY.md")).expect("the table of contents");
    let listed: Vec<PathBuf> = links(&text).into_iter().map(|(_, link)| normal(&folder.join(link))).collect();
    let once: BTreeSet<&PathBuf> = listed.iter().collect();
    assert_eq!(once.len(), listed.len(), "a page is listed twice");
    let missing: Vec<PathBuf> = pages().into_iter().filter(|page| !once.contains(page)).collect();
    assert!(missing.is_empty(), "docs/SUMMARY.md lacks {missing:?}");
    let foreign: Vec<_> = listed.iter().filter(|page| !page.starts_with(&folder)).collect();
    assert!(foreign.is_empty(), "mdBook cannot show pages outside of docs: {foreign:?}");
}

/// Checks paths between backquotes, so that a recipe does not name a file that has moved.
#[test]
fn paths_on_the_pages_for_contributors_exist() {
    const FOLDERS: [&str; 8] =
        [".ci/", "compiler/", "docs/", "examples/", "lang/", "lsp/", "runtime/", "stdlib-gears/"];
    let mut problems = Vec::new();
    for page in ["CONTRIBUTING.md", "docs/contributing.md"] {
        let text = fs::read_to_string(home().join(page)).expect("readable");
        for path in text.split('`').skip(1).step_by(2) {
            let named = FOLDERS.iter().any(|folder| path.starts_with(folder));
            if named && !path.contains(['*', ' ']) && !home().join(path).exists() {
                problems.push(format!("{page}: no `{path}`"));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Returns all identifiers in the sources of a folder.
fn identifiers(folder: &Path, words: &mut BTreeSet<String>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("readable").path()) {
        if entry.is_dir() {
            identifiers(&entry, words);
        } else if entry.extension().is_some_and(|extension| extension == "rs" || extension == "cx") {
            let text = fs::read_to_string(&entry).expect("readable");
            let split = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
            words.extend(split.map(str::to_owned));
        }
    }
}

/// Checks identifiers between backquotes, so that a recipe does not name an item that has been
/// renamed.
#[test]
fn items_on_the_page_of_recipes_exist() {
    let mut words = BTreeSet::new();
    for folder in ["compiler", "lsp", "runtime", "stdlib-gears"] {
        identifiers(&home().join(folder), &mut words);
    }
    let text = fs::read_to_string(home().join("docs/contributing.md")).expect("readable");
    let spans: Vec<&str> = text.split('`').skip(1).step_by(2).collect();
    let is_path = |span: &&&str| span.chars().all(|c| c.is_alphanumeric() || c == '_' || c == ':');
    let unknown: Vec<&str> = spans
        .iter()
        .filter(is_path)
        .filter(|span| span.split("::").any(|segment| !words.contains(segment)))
        .copied()
        .collect();
    assert!(unknown.is_empty(), "docs/contributing.md names unknown items: {unknown:?}");
    assert!(spans.iter().filter(is_path).count() > 80, "the page has few items");
}

/// The reference has its own test. Pages without a model may have other blocks of text.
#[test]
fn every_model_on_a_page_passes_check() {
    let mut problems = Vec::new();
    let mut models = 0;
    for path in pages().into_iter().filter(|path| !path.ends_with("reference.md")) {
        let name = path.strip_prefix(home()).expect("below the root").display().to_string();
        let text = fs::read_to_string(&path).expect("readable");
        if !text.contains("\n```cx") {
            continue;
        }
        let document = Document::new(&name, text);
        let folder = tempfile::tempdir().expect("a temporary folder");
        write_files(&document, folder.path());
        for case in &document.cases {
            models += 1;
            for (line, problem) in judge(case, folder.path()).problems {
                problems.push(format!("{name}:{line}: {problem}"));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
    assert!(models >= 6, "only {models} models");
}

/// The README shows the model that `calyx new` writes, which has 15 lines of code.
#[test]
fn the_first_model_is_that_of_the_readme() {
    let read = |path: &str| fs::read_to_string(home().join(path)).expect("a file");
    let (template, readme) = (read("compiler/templates/spur_pair.cx"), read("README.md"));
    let code: Vec<&str> =
        template.lines().filter(|line| !line.is_empty() && !line.starts_with("//")).collect();
    assert_eq!(code.len(), 15, "{code:#?}");
    let block = format!("```\n{}\n```", code.join("\n"));
    assert!(readme.contains(&block), "README.md does not show\n{block}");
}
