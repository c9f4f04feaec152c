//! Fixtures: Markdown files in which every case has a text with a cursor and the expected answer.
//!
//! A case is a `##` heading followed by one or more ```` ```cx ```` blocks and one ```` ```text
//! ```` block. The first block is the model; a word after `cx` is the name of another file in its
//! folder (```` ```cx util.cx ````). `$0` is the cursor and not part of the text; two of them are a
//! selection. `CALYX_BLESS=1` writes the answers into the file.

#![allow(dead_code, reason = "every test uses its part of this")]

use calyx_elaborate::{Cancel, Params, elaborate};
use calyx_lang::check::Loader;
use calyx_lang::db::Database;
use calyx_lsp::ide::elaborated::Elaborated;
use calyx_lsp::ide::{Edit, Position, Snapshot};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A case of a fixture.
pub struct Case {
    pub heading: String,
    /// Name and text without cursor marks; the model, `model.cx`, is first.
    pub files: Vec<(String, String)>,
    /// File and offset of each mark, in order.
    pub cursors: Vec<Position>,
    pub snapshot: Snapshot,
}

impl Case {
    /// Returns the first cursor. A case without one is about the whole model.
    pub fn cursor(&self) -> &Position {
        self.cursors.first().unwrap_or_else(|| panic!("`{}` has no cursor", self.heading))
    }

    pub fn text(&self, file: &str) -> &str {
        self.files.iter().find(|(name, _)| name == file).map_or("", |(_, text)| text)
    }

    /// Formats a position in a file of the case as `line:column`, from 1, in characters.
    pub fn place(&self, file: &str, offset: u32) -> String {
        let before = self.text(file).get(..offset as usize).unwrap_or_default();
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
        format!("{line}:{column}")
    }
}

/// Computes the answers to all cases of `tests/ide/NAME.md`, and compares them with the expected
/// ones.
pub fn run(name: &str, answer: impl Fn(&Case) -> String) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("tests/ide/{name}.md"));
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let bless = std::env::var_os("CALYX_BLESS").is_some();
    let mut blessed = String::new();
    let mut wrong = Vec::new();
    let mut rest = text.as_str();
    let mut count = 0;
    // The text before the first heading documents the file.
    let first = rest.find("\n## ").map_or(rest.len(), |at| at + 1);
    blessed.push_str(&rest[..first]);
    rest = &rest[first..];
    while !rest.is_empty() {
        let end = rest[3..].find("\n## ").map_or(rest.len(), |at| at + 4);
        let (section, after) = rest.split_at(end);
        rest = after;
        count += 1;
        let heading = section.lines().next().unwrap_or_default().trim_start_matches('#').trim().to_string();
        let (start, stop) = text_block(section).unwrap_or_else(|| panic!("`{heading}` has no ```text block"));
        let expected = &section[start..stop];
        let found = answer(&case(&heading, section)).trim_end().to_string();
        let found = if found.is_empty() { found } else { found + "\n" };
        if found != expected {
            wrong.push(format!("## {heading}\nexpected:\n{expected}\nfound:\n{found}"));
        }
        blessed.push_str(&section[..start]);
        blessed.push_str(&found);
        blessed.push_str(&section[stop..]);
    }
    assert!(count > 0, "{} has no cases", path.display());
    if bless && !wrong.is_empty() {
        fs::write(&path, blessed).expect("fixtures can be written");
    }
    assert!(bless || wrong.is_empty(), "{}\n{}", path.display(), wrong.join("\n"));
}

/// Creates a case whose model is a text without cursors.
pub fn of(text: &str) -> Case {
    case("a model", &format!("```cx\n{text}```"))
}

/// Returns the range of the content of the ```text block.
fn text_block(section: &str) -> Option<(usize, usize)> {
    let start = section.find("```text\n")? + "```text\n".len();
    let stop = start + section[start..].find("```")?;
    Some((start, stop))
}

fn case(heading: &str, section: &str) -> Case {
    let mut files = Vec::new();
    let mut cursors = Vec::new();
    for block in section.split("```cx").skip(1) {
        let (head, rest) = block.split_once('\n').expect("a block has lines");
        let marked = rest.split("```").next().unwrap_or_default();
        let name = if head.trim().is_empty() { "model.cx" } else { head.trim() };
        assert!(files.iter().all(|(other, _)| other != name), "`{heading}` has two blocks `{name}`");
        let mut text = String::new();
        for (index, part) in marked.split("$0").enumerate() {
            if index > 0 {
                cursors.push(Position { file: name.into(), offset: text.len() as u32 });
            }
            text.push_str(part);
        }
        files.push((name.to_string(), text));
    }
    assert!(!files.is_empty(), "`{heading}` has no ```cx block");
    let snapshot = snapshot(&files);
    Case { heading: heading.to_string(), files, cursors, snapshot }
}

/// Returns a snapshot with an elaborated model, if the elaboration succeeds.
pub fn elaborated(snapshot: &Snapshot) -> Snapshot {
    let model = snapshot.database.models().next().expect("a model").to_string();
    let checked = snapshot.database.check(&model).expect("it was set");
    let mut snapshot = snapshot.clone();
    if let Some(program) = &checked.program {
        let elaboration = elaborate(program, Params::Defaults, &Cancel::default()).expect("nobody cancels");
        let all = BTreeMap::from([(model.into(), Arc::new(Elaborated::new(&checked, elaboration)))]);
        snapshot.elaborated = Arc::new(all);
    }
    snapshot
}

/// Creates a snapshot of files by name and text; the first is the model.
pub fn snapshot(files: &[(String, String)]) -> Snapshot {
    let loader = Files::new(files);
    let mut database = Database::new(&loader);
    let (model, text) = &files[0];
    database.set_model(model, text);
    database.load_imports(model, &loader);
    // An editor knows all modules, imported or not.
    for path in loader.names() {
        let names: Vec<String> = path.split('.').map(str::to_string).collect();
        if let Some((name, text)) = loader.module(&names) {
            database.set_module(&path, &name, &text);
        }
    }
    Snapshot::new(database)
}

/// Returns the files after disjoint edits.
pub fn changed(files: &[(String, String)], edits: &[Edit]) -> Vec<(String, String)> {
    let mut changed = files.to_vec();
    let mut edits: Vec<&Edit> = edits.iter().collect();
    edits.sort_by_key(|edit| std::cmp::Reverse((edit.start, edit.end)));
    for edit in edits {
        let file = changed.iter_mut().find(|(name, _)| **name == *edit.file);
        let (_, text) = file.unwrap_or_else(|| panic!("{} is not of the case", edit.file));
        text.replace_range(edit.start as usize..edit.end as usize, &edit.replacement);
    }
    changed
}

/// Loader of the library and the files of a case.
struct Files {
    folder: PathBuf,
    others: BTreeMap<String, String>,
}

impl Files {
    fn new(files: &[(String, String)]) -> Files {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../stdlib-gears/calyx");
        Files { folder, others: files.iter().skip(1).cloned().collect() }
    }

    fn library(&self, name: &str) -> Option<(String, String)> {
        let text = fs::read_to_string(self.folder.join(name)).ok()?;
        Some((format!("<library>/{name}"), text))
    }
}

impl Loader for Files {
    fn module(&self, path: &[String]) -> Option<(String, String)> {
        let name = format!("{}.cx", path.join("/"));
        let other = self.others.get(&name).map(|text| (name.clone(), text.clone()));
        other.or_else(|| self.library(&name))
    }

    fn names(&self) -> Vec<String> {
        let others = self.others.keys().map(|name| name.trim_end_matches(".cx").replace('/', "."));
        others.chain(["gears".to_string()]).collect()
    }

    fn prelude(&self) -> (String, String) {
        self.library("prelude.cx").expect("the library has a prelude")
    }
}
