//! Checks that the theory manual matches the repository: every path in its pages and in
//! ARCHITECTURE.md exists, every page is in the index, and inline formulas end on the line on which
//! they begin, which GitHub requires. ARCHITECTURE.md has at most 10 kB.

use calyx_tests::root;
use std::collections::BTreeMap;
use std::fs;

/// Returns the pages of the manual and ARCHITECTURE.md, by their paths relative to the root.
fn pages() -> BTreeMap<String, String> {
    let folder = root().join("docs/theory");
    let entries = fs::read_dir(&folder).expect("the folder of the manual");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let names = paths.filter(|path| path.extension().is_some_and(|extension| extension == "md"));
    let names = names.map(|path| {
        let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
        format!("docs/theory/{name}")
    });
    let all = names.chain(["ARCHITECTURE.md".to_owned()]);
    all.map(|name| (name.clone(), fs::read_to_string(root().join(name)).expect("readable"))).collect()
}

/// Returns the numbered lines outside of fenced blocks.
fn prose(text: &str) -> Vec<(usize, &str)> {
    let mut fenced = false;
    let mut lines = Vec::new();
    for (index, line) in text.lines().enumerate() {
        if line.starts_with("```") {
            fenced = !fenced;
        } else if !fenced {
            lines.push((index + 1, line));
        }
    }
    lines
}

/// Expands `a/{b,c}.rs` to `a/b.rs` and `a/c.rs`.
fn expanded(path: &str) -> Vec<String> {
    let braces = path.find('{').and_then(|open| Some((open, open + path[open..].find('}')?)));
    let Some((open, close)) = braces else { return vec![path.to_owned()] };
    let (before, after) = (&path[..open], &path[close + 1..]);
    path[open + 1..close].split(',').flat_map(|one| expanded(&format!("{before}{one}{after}"))).collect()
}

/// Returns true if a path, or a pattern with stars in its last component, exists.
fn exists(path: &str) -> bool {
    let Some(star) = path.find('*') else { return root().join(path).exists() };
    let folder = path[..star].rfind('/').map_or("", |end| &path[..end]);
    let start = path[folder.len()..star].trim_start_matches('/');
    let mut entries = fs::read_dir(root().join(folder)).into_iter().flatten().flatten();
    entries.any(|entry| entry.file_name().to_string_lossy().starts_with(start))
}

#[test]
fn named_paths_exist() {
    let folders = [".ci", "compiler", "docs", "examples", "lang", "lsp", "runtime", "stdlib-gears", "tests"];
    let mut missing = Vec::new();
    let mut named = 0;
    for (page, text) in pages() {
        for (line, text) in prose(&text) {
            for span in text.split('`').skip(1).step_by(2) {
                let is_path = span.split_once('/').is_some_and(|(first, _)| folders.contains(&first));
                if !is_path || span.contains(' ') {
                    continue;
                }
                named += 1;
                let absent = expanded(span).into_iter().filter(|path| !exists(path));
                missing.extend(absent.map(|path| format!("{page}:{line}: no `{path}`")));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
    assert!(named > 100, "only {named} paths are named");
}

#[test]
fn the_index_lists_every_page() {
    let pages = pages();
    let index = &pages["docs/theory/README.md"];
    for page in pages.keys().filter_map(|page| page.strip_prefix("docs/theory/")) {
        assert!(page == "README.md" || index.contains(&format!("]({page})")), "{page} is not in the index");
    }
}

#[test]
fn inline_formulas_end_on_their_line() {
    for (page, text) in pages() {
        for (line, text) in prose(&text) {
            let outside: String = text.split('`').step_by(2).collect();
            assert!(
                outside.matches('$').count().is_multiple_of(2),
                "{page}:{line}: a formula without an end"
            );
        }
    }
}

#[test]
fn the_map_is_short() {
    let size = pages()["ARCHITECTURE.md"].len();
    assert!(size <= 10_000, "ARCHITECTURE.md has {size} bytes; methods belong in docs/theory");
}
