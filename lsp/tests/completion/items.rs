//! Completion items and their order: `tests/ide/completion.md` and
//! `tests/ide/completion_ranking.md`.

use crate::support;
use calyx_lsp::ide::Position;
use calyx_lsp::ide::completion::{CompletionTrigger, Item, ItemKind, complete};

const ASKED: CompletionTrigger<'static> = CompletionTrigger { typed: None, beside: &Vec::new };

/// Number of items shown, as many as an editor shows without scrolling.
const SHOWN: usize = 10;

#[test]
fn items() {
    support::run("completion", |case| {
        let answers = case.cursors.iter().map(|cursor| {
            let found = complete(&case.snapshot, cursor, &ASKED);
            let mut lines: Vec<String> = found.items.iter().take(SHOWN).map(line).collect();
            if found.items.len() > SHOWN {
                lines.push(format!("... {} more", found.items.len() - SHOWN));
            }
            if lines.is_empty() { "nothing\n".to_string() } else { lines.join("\n") + "\n" }
        });
        answers.collect::<Vec<_>>().join("\n")
    });
}

fn line(item: &Item) -> String {
    let inserted = item.insert.snippet.as_deref().unwrap_or(&item.insert.plain);
    let mut line =
        format!("{}  {}  {}", item.label, item.kind.describe(), item.detail).trim_end().to_string();
    if inserted != item.label && item.kind != ItemKind::Keyword {
        line.push_str(&format!("  <{}>", inserted.escape_debug()));
    }
    if let Some(import) = &item.import {
        line.push_str(&format!("  {:?} at {}", import.replacement, import.start));
    }
    line
}

/// Checks the first three items at each cursor of a table of situations. The first block of a case
/// precedes each line of the second one, which is a statement at the end of the text.
#[test]
fn ranking() {
    support::run("completion_ranking", |case| {
        let (_, lines) = case.files.get(1).expect("a case has a model and lines");
        let mut answer = String::new();
        let model = case.text("model.cx");
        // A text can be changed only if no other reference to the database exists.
        let mut snapshot = support::of(model).snapshot;
        for line in lines.lines() {
            let (before, after) = line.split_once('|').expect("a line has a cursor");
            let offset = (model.len() + before.len()) as u32;
            snapshot.database.set_model("model.cx", &format!("{model}{before}{after}\n"));
            let cursor = Position { file: "model.cx".into(), offset };
            let found = complete(&snapshot, &cursor, &ASKED);
            let labels: Vec<&str> = found.items.iter().take(3).map(|item| item.label.as_str()).collect();
            answer.push_str(&format!("{line}\n    {}\n", labels.join("   ")));
        }
        answer
    });
}

/// Completion succeeds at every position of truncated programs.
#[test]
fn every_place_is_answered() {
    let model = include_str!("../../../compiler/templates/spur_pair.cx");
    let mut snapshot = support::of(model).snapshot;
    for cut in (0..model.len()).filter(|cut| model.is_char_boundary(*cut)).step_by(41) {
        let text = model.get(..cut).unwrap_or_default();
        snapshot.database.set_model("model.cx", text);
        let cursor = Position { file: "model.cx".into(), offset: cut as u32 };
        let found = complete(&snapshot, &cursor, &ASKED);
        assert!(
            found.start <= cursor.offset && cursor.offset <= found.end || found.items.is_empty(),
            "{cut}"
        );
        let _ = calyx_lsp::ide::signature::signature(&snapshot, &cursor);
        for item in &found.items {
            if let Some(subject) = &item.subject {
                let _ = calyx_lsp::ide::completion::documentation(&snapshot.database, subject);
            }
        }
    }
}
