//! Hover, definitions, references, highlights and renames from fixtures; renames of all names in
//! the examples.

use crate::support::{Case, changed, elaborated, run, snapshot};
use calyx_lang::analysis::Name;
use calyx_lang::lexer::Kind;
use calyx_lsp::ide::definition::{Definition, definition, type_definition};
use calyx_lsp::ide::hover::hover;
use calyx_lsp::ide::references::{highlight, references};
use calyx_lsp::ide::rename::{prepare, rename};
use calyx_lsp::ide::{Position, Snapshot};
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::{Path, PathBuf};

#[test]
fn hover_shows_what_is_known() {
    run("hover", |case| card(case, &case.snapshot));
}

#[test]
fn hover_shows_what_elaboration_knows() {
    run("hover_elaborated", |case| card(case, &elaborated(&case.snapshot)));
}

fn card(case: &Case, snapshot: &Snapshot) -> String {
    match hover(snapshot, case.cursor()) {
        Some(found) => {
            let text = case.text(&case.cursor().file);
            let about = &text[found.range.start as usize..found.range.end as usize];
            // A code fence would end the block of the fixture.
            format!("about `{about}`\n{}", found.markdown.replace("```", "~~~"))
        }
        None => "nothing".into(),
    }
}

/// Results for an earlier text are moved to their current position, unless an edit has touched
/// them.
#[test]
fn geometry_follows_the_text() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/spur_pair.cx"))
        .expect("the example");
    let first = elaborated(&snapshot(&[("model.cx".to_string(), text.clone())]));
    let card = |text: &str| {
        let mut now = snapshot(&[("model.cx".to_string(), text.to_string())]);
        now.elaborated = first.elaborated.clone();
        let offset = text.find("gears.external").expect("a gear") as u32 + 8;
        hover(&now, &Position { file: "model.cx".into(), offset }).expect("a card").markdown
    };
    assert!(card(&text).contains("base diameter"), "{}", card(&text));
    assert!(card(&format!("// Above.\n{text}")).contains("base diameter"));
    assert!(card(&format!("{text}\nvar below = 1;\n")).contains("base diameter"));
    let touched = text.replacen("gears.external(", "gears.external( ", 1);
    assert!(!card(&touched).contains("base diameter"), "{}", card(&touched));
}

#[test]
fn definitions_are_found() {
    run("definition", |case| {
        let show = |word: &str, found: Option<Definition>| match found {
            Some(found) => format!("{word}: {}\n", target(case, &found)),
            None => format!("{word}: nothing\n"),
        };
        let at = case.cursor();
        show("definition", definition(&case.snapshot, at))
            + &show("type", type_definition(&case.snapshot, at))
    });
}

fn target(case: &Case, found: &Definition) -> String {
    let text = case.snapshot.database.text(&found.file).expect("a file");
    let slice = |start: u32, end: u32| text[start as usize..end as usize].lines().next().unwrap_or_default();
    let line = text[..found.name.start as usize].matches('\n').count() + 1;
    // Line numbers of the library change often.
    let place =
        if found.file.starts_with('<') { found.file.to_string() } else { format!("{}:{line}", found.file) };
    let name = slice(found.name.start, found.name.end);
    format!("{place} `{name}` in `{}`", slice(found.item.start, found.item.end))
}

#[test]
fn references_are_found() {
    run("references", |case| {
        let mut shown = String::new();
        for reference in references(&case.snapshot, case.cursor(), true) {
            let place = case.place(&reference.file, reference.start);
            let writes = if reference.writes { " writes" } else { "" };
            writeln!(shown, "{}:{place}{writes}", reference.file).expect("text");
        }
        shown
    });
}

#[test]
fn what_belongs_together_is_marked() {
    run("highlight", |case| {
        let text = case.text(&case.cursor().file);
        let mut marks: Vec<_> = highlight(&case.snapshot, case.cursor());
        marks.sort_by_key(|mark| mark.range.start);
        let mut marked = text.to_string();
        for mark in marks.iter().rev() {
            let word = match mark.writes {
                Some(true) => "w",
                Some(false) => "r",
                None => "",
            };
            marked.insert(mark.range.end as usize, ']');
            marked.insert_str(mark.range.start as usize, &format!("{word}["));
        }
        marked
    });
}

#[test]
fn names_are_changed_everywhere() {
    run("rename", |case| {
        // The new name is the last word of the heading.
        let to = case.heading.rsplit(' ').next().unwrap_or_default().trim_matches('`');
        let at = case.cursor();
        if let Err(refusal) = prepare(&case.snapshot, at) {
            return format!("refused: {}", refusal.0);
        }
        match rename(&case.snapshot, at, to) {
            Err(refusal) => format!("refused: {}", refusal.0),
            Ok(edits) => {
                let files = changed(&case.files, &edits);
                let several = files.len() > 1;
                let each = files
                    .iter()
                    .map(|(name, text)| if several { format!("{name}\n{text}") } else { text.clone() });
                each.collect()
            }
        }
    });
}

fn models(below: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(below).expect("examples").flatten() {
        let path = entry.path();
        if path.is_dir() {
            models(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "cx") {
            found.push(path);
        }
    }
}

/// Largest number of names of an example that are changed.
const NAMES_OF_A_MODEL: usize = 3;

/// Returns the declarations of a model.
fn declared(snapshot: &Snapshot) -> Vec<Name> {
    snapshot.database.names("model.cx").into_iter().filter(|name| name.declares).collect()
}

/// Renames declarations of the examples to fresh names: there are no errors, the output is the
/// same, and the inverse rename restores the text. A sample of the names, because each requires
/// complete checks of its model and modules.
#[test]
fn names_of_the_examples_can_be_changed_and_changed_back() {
    let mut paths = Vec::new();
    models(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../examples"), &mut paths);
    let mut renamed = 0;
    for path in paths {
        let text = std::fs::read_to_string(&path).expect("an example");
        let files = vec![("model.cx".to_string(), text.clone())];
        let first = snapshot(&files);
        let before = first.database.check("model.cx").expect("a model").diagnostics.len();
        let names = declared(&first);
        let step = names.len().div_ceil(NAMES_OF_A_MODEL).max(2);
        for name in names.into_iter().step_by(step) {
            let fresh = format!("{}_fresh", name.text);
            let at = Position { file: "model.cx".into(), offset: name.start };
            let edits = rename(&first, &at, &fresh)
                .unwrap_or_else(|why| panic!("{}: {}: {}", path.display(), name.text, why.0));
            let there = changed(&files, &edits);
            let second = snapshot(&there);
            let after = second.database.check("model.cx").expect("a model");
            assert_eq!(after.diagnostics.len(), before, "{}: {}", path.display(), name.text);
            let earlier = edits.iter().filter(|edit| edit.start < name.start).count();
            let moved = name.start + earlier as u32 * "_fresh".len() as u32;
            let at = Position { file: "model.cx".into(), offset: moved };
            let back = rename(&second, &at, &name.text)
                .unwrap_or_else(|why| panic!("{}: {}: {}", path.display(), fresh, why.0));
            assert_eq!(changed(&there, &back)[0].1, text, "{}: {}", path.display(), name.text);
            renamed += 1;
        }
    }
    assert!(renamed > 40, "only {renamed} names");
}

/// At every cursor, in complete and truncated texts, every query returns positions within the text.
#[test]
fn questions_are_answered_everywhere() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/spur_pair.cx"))
        .expect("the example");
    let mut words = BTreeSet::new();
    for cut in [text.len(), text.len() * 2 / 3, text.len() / 2 + 5, 300] {
        let cut = text.floor_char_boundary(cut);
        let snapshot = snapshot(&[("model.cx".to_string(), text[..cut].to_string())]);
        let inside = |start: u32, end: u32| text[..cut].get(start as usize..end as usize).is_some();
        for offset in 0..=cut {
            let at = Position { file: "model.cx".into(), offset: offset as u32 };
            if let Some(found) = hover(&snapshot, &at) {
                assert!(inside(found.range.start, found.range.end), "{found:?}");
                assert!(!found.markdown.trim().is_empty());
                words.insert(text[found.range.start as usize..found.range.end as usize].to_string());
            }
            if let Some(found) = definition(&snapshot, &at) {
                assert!(inside(found.origin.start, found.origin.end), "{found:?}");
            }
            type_definition(&snapshot, &at);
            for mark in highlight(&snapshot, &at) {
                assert!(inside(mark.range.start, mark.range.end), "{mark:?}");
            }
            let _ = prepare(&snapshot, &at);
        }
    }
    // Every identifier of the example has a hover text.
    let whole = snapshot(&[("model.cx".to_string(), text.clone())]);
    for token in &whole.database.tokens("model.cx").expect("tokens").tokens {
        let word = &text[token.span.start as usize..token.span.end as usize];
        let system = word.contains("_s") && word.contains("lbf");
        assert!(
            token.kind != Kind::Identifier || system || words.contains(word) || is_unit(&words, word),
            "no card for `{word}`"
        );
    }
}

/// Returns true for units, which are described with their number.
fn is_unit(words: &BTreeSet<String>, word: &str) -> bool {
    words.iter().any(|known| known.contains(' ') && known.contains(word))
}
