//! Quick fixes and rewrites: the actions offered at a cursor, and the lines that each changes.

use crate::support::{Case, changed, run, snapshot};
use calyx_lang::diagnostic::Severity;
use calyx_lsp::ide::Edit;
use calyx_lsp::ide::actions::{Action, ActionKind, actions, fix_all};
use std::fmt::Write;

/// Returns the diagnostics of the model of these files: code, whether it is an error, and position.
fn codes(files: &[(String, String)]) -> Vec<(String, bool, u32)> {
    let checked = snapshot(files).database.check(&files[0].0).expect("the model was set");
    let each = checked.diagnostics.iter();
    each.map(|d| (d.code.clone(), d.severity == Severity::Error, d.primary.span.start)).collect()
}

fn show(case: &Case, action: &Action) -> String {
    let files = changed(&case.files, &action.edits);
    let before = codes(&case.files);
    let after = codes(&files);
    // A rewrite causes no new error; a certain fix resolves a diagnostic.
    let errors = |codes: &[(String, bool, u32)]| codes.iter().filter(|(_, error, _)| *error).count();
    match action.kind {
        ActionKind::QuickFix | ActionKind::FixAll => {
            assert!(
                !action.preferred || after != before,
                "{}: `{}` fixes nothing",
                case.heading,
                action.title
            );
        }
        _ => assert!(
            errors(&after) <= errors(&before) && after.len() <= before.len(),
            "{}: `{}` gives {after:?}\n{}",
            case.heading,
            action.title,
            files[0].1
        ),
    }
    let mut shown = String::new();
    let kind = match action.kind {
        ActionKind::QuickFix => "fix",
        ActionKind::Rewrite => "rewrite",
        ActionKind::Extract => "extract",
        ActionKind::Inline => "inline",
        ActionKind::FixAll => "all",
    };
    let preferred = if action.preferred { " (preferred)" } else { "" };
    writeln!(shown, "{kind}{preferred}: {}", action.title).expect("text");
    for ((name, old), (_, new)) in case.files.iter().zip(&files) {
        for line in difference(old, new) {
            let file = if *name == case.files[0].0 { String::new() } else { format!("{name} ") };
            writeln!(shown, "    {file}{line}").expect("text");
        }
    }
    shown
}

/// Returns removed and added lines, without the common prefix and suffix.
fn difference(old: &str, new: &str) -> Vec<String> {
    let (old, new): (Vec<&str>, Vec<&str>) = (old.lines().collect(), new.lines().collect());
    let same = old.iter().zip(&new).take_while(|(a, b)| a == b).count();
    let tail = old[same..].iter().rev().zip(new[same..].iter().rev()).take_while(|(a, b)| a == b).count();
    let gone = old[same..old.len() - tail].iter().map(|line| format!("- {line}"));
    let come = new[same..new.len() - tail].iter().map(|line| format!("+ {line}"));
    gone.chain(come).collect()
}

#[test]
fn actions_are_offered() {
    run("actions", |case| {
        let start = case.cursor();
        let end = case.cursors.get(1).map_or(start.offset, |end| end.offset);
        let found = actions(&case.snapshot, &start.file, start.offset..end);
        found.iter().map(|action| show(case, action)).collect()
    });
}

#[test]
fn everything_certain_is_fixed_at_once() {
    run("fix_all", |case| match fix_all(&case.snapshot, "model.cx") {
        Some(action) => changed(&case.files, &action.edits)[0].1.clone(),
        None => "nothing".into(),
    });
}

/// At every cursor, in complete and truncated texts: edits are within the text and disjoint.
#[test]
fn actions_are_sound_everywhere() {
    let text = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../examples/spur_pair.cx"))
        .expect("the example");
    let cuts = [text.len(), text.len() / 2, text.len() / 3 + 7];
    for cut in cuts.into_iter().map(|cut| text.floor_char_boundary(cut)) {
        let files = vec![("model.cx".to_string(), text[..cut].to_string())];
        let snapshot = snapshot(&files);
        for at in (0..cut).step_by(23) {
            for end in [at, (at + 17).min(cut)] {
                for action in actions(&snapshot, "model.cx", at as u32..end as u32) {
                    sound(&text[..cut], &action.edits);
                }
            }
        }
    }
}

fn sound(text: &str, edits: &[Edit]) {
    let mut edits: Vec<&Edit> = edits.iter().filter(|edit| &*edit.file == "model.cx").collect();
    edits.sort_by_key(|edit| (edit.start, edit.end));
    assert!(edits.windows(2).all(|pair| pair[0].end <= pair[1].start), "{edits:?}");
    assert!(edits.iter().all(|edit| text.get(edit.start as usize..edit.end as usize).is_some()), "{edits:?}");
}
