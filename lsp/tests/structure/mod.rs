//! Features based on the syntax of a file: outline, folds, selections, formatting, tokens.

mod properties;

use crate::support::{Case, run};
use calyx_lsp::ide::call_hierarchy::{self, Calls, Item};
use calyx_lsp::ide::code_lenses::{Lens, lenses, uses};
use calyx_lsp::ide::document_links::links;
use calyx_lsp::ide::folding::{FoldKind, folds};
use calyx_lsp::ide::formatting::{Change, format_file, format_selection};
use calyx_lsp::ide::inlay_hints::{HintSettings, OutputResult, Results, hints};
use calyx_lsp::ide::on_type_formatting::typed;
use calyx_lsp::ide::selection::selections;
use calyx_lsp::ide::semantic_tokens::{self, KINDS, MODIFIERS};
use calyx_lsp::ide::source::Source;
use calyx_lsp::ide::symbols::{Symbol, find, symbols, types};
use std::fmt::Write;
use std::ops::Range;

const MODEL: &str = "model.cx";

fn source(case: &Case) -> Source<'_> {
    Source::of(&case.snapshot, MODEL).expect("the model is known")
}

/// Returns the range from the first to the last cursor; the whole model without cursors.
fn range(case: &Case) -> Range<u32> {
    match case.cursors.as_slice() {
        [] => 0..case.text(MODEL).len() as u32,
        [first, .., last] => first.offset..last.offset,
        [only] => only.offset..only.offset,
    }
}

/// Returns the text after disjoint changes.
fn changed(text: &str, changes: &[Change]) -> String {
    let mut changes: Vec<&Change> = changes.iter().collect();
    changes.sort_by_key(|change| (change.start, change.end));
    let mut text = text.to_string();
    for change in changes.iter().rev() {
        text.replace_range(change.start as usize..change.end as usize, &change.replacement);
    }
    text
}

#[test]
fn folding() {
    run("folding", |case| {
        let mut answer = String::new();
        for fold in folds(&source(case)) {
            let kind = match fold.kind {
                FoldKind::Code => "code",
                FoldKind::Comment => "comment",
                FoldKind::Imports => "imports",
            };
            let (start, end) = (case.place(MODEL, fold.start), case.place(MODEL, fold.end));
            writeln!(answer, "{start} - {end} {kind}").unwrap();
        }
        answer
    });
}

#[test]
fn outline() {
    fn show(case: &Case, symbols: &[Symbol], depth: usize, answer: &mut String) {
        for symbol in symbols {
            let detail = symbol.detail.as_ref().map(|detail| format!(" {detail}")).unwrap_or_default();
            let place = |offset| case.place(MODEL, offset);
            let (start, end) = (place(symbol.start), place(symbol.end));
            let (indent, kind) = ("  ".repeat(depth), format!("{:?}", symbol.kind).to_lowercase());
            writeln!(answer, "{indent}{kind} {}{detail} @ {start} - {end}", symbol.name).unwrap();
            show(case, &symbol.children, depth + 1, answer);
        }
    }
    run("symbols", |case| {
        let mut answer = String::new();
        let names = case.snapshot.database.names(MODEL);
        show(case, &symbols(&source(case), &types(&names)), 0, &mut answer);
        answer
    });
}

/// The first line is the query.
#[test]
fn search() {
    run("workspace_symbols", |case| {
        let query = case.text("query");
        let files: Vec<_> = case
            .files
            .iter()
            .filter(|(name, _)| name != "query")
            .map(|(name, text)| (name.as_str().into(), Source::new(text)))
            .collect();
        let mut answer = String::new();
        for found in
            find(query, files.iter().map(|(name, source): &(std::sync::Arc<str>, _)| (name.clone(), source)))
        {
            let kind = format!("{:?}", found.symbol.kind).to_lowercase();
            let container = found.container.map(|of| format!(" of {of}")).unwrap_or_default();
            writeln!(answer, "{kind} {}{container} in {}", found.symbol.name, found.file).unwrap();
        }
        answer
    });
}

#[test]
fn selection() {
    run("selection", |case| {
        let source = source(case);
        let mut answer = String::new();
        for (start, end) in selections(&source, case.cursor().offset) {
            let text = source.slice(start, end).replace('\n', "\\n");
            writeln!(answer, "{text}").unwrap();
        }
        answer
    });
}

/// Formats the file without a cursor, or the selection between two cursors.
#[test]
fn formatting() {
    run("formatting", |case| {
        let source = source(case);
        let changes = match case.cursors.as_slice() {
            [] => format_file(&source),
            [only] => format_selection(&source, only.offset..only.offset),
            [first, .., last] => format_selection(&source, first.offset..last.offset),
        };
        changed(source.text, &changes)
    });
}

/// Simulates that the character before the cursor was typed.
#[test]
fn typing() {
    run("typing", |case| {
        let source = source(case);
        let offset = case.cursor().offset;
        // Blanks after a line break were inserted by the editor.
        let before = source.text[..offset as usize].trim_end_matches(' ');
        let character = before.chars().next_back().expect("something was typed");
        let changes = typed(&source, offset, character);
        changed(source.text, &changes).lines().map(|line| format!("{line}|\n")).collect()
    });
}

/// Lists every word with its kind and modifiers.
#[test]
fn tokens() {
    run("semantic_tokens", |case| {
        let source = source(case);
        let range = range(case);
        let names = case.snapshot.database.names_in(MODEL, range.clone());
        let mut answer = String::new();
        for token in semantic_tokens::tokens(&source, &names, range) {
            let modifiers =
                MODIFIERS.iter().enumerate().filter(|(bit, _)| token.modifiers.0 & (1 << bit) != 0);
            let modifiers: String = modifiers.map(|(_, name)| format!(".{name}")).collect();
            let word = source.slice(token.start, token.end);
            writeln!(answer, "{word:20} {}{modifiers}", KINDS[token.kind as usize]).unwrap();
        }
        answer
    });
}

#[test]
fn import_links() {
    run("document_links", |case| {
        let links = links(&case.snapshot, &source(case)).into_iter();
        links.map(|link| format!("{} -> {}\n", source(case).slice(link.start, link.end), link.file)).collect()
    });
}

#[test]
fn code_lenses() {
    run("code_lenses", |case| {
        let mut answer = String::new();
        for lens in lenses(&source(case), &MODEL.into()) {
            let shown = match &lens.lens {
                Lens::Run => "run".to_string(),
                Lens::ExplainPlan => "explain plan".to_string(),
                Lens::RunTest(name) => format!("run test {name}"),
                Lens::Uses(place) => format!("{} uses", uses(&case.snapshot, place).len()),
            };
            let word = source(case).slice(lens.start, lens.end);
            writeln!(answer, "{} {word}: {shown}", case.place(MODEL, lens.start)).unwrap();
        }
        answer
    });
}

#[test]
fn calls() {
    fn shown(item: &Item) -> String {
        let detail = item.detail.as_deref().unwrap_or_default();
        let kind = item.kind.map_or("file", |kind| kind.describe());
        format!("{kind} {}{detail} in {}", item.name, item.place.file)
    }
    fn list(case: &Case, title: &str, calls: &[Calls], caller: Option<&str>, answer: &mut String) {
        for call in calls {
            let file = caller.unwrap_or(&call.item.place.file);
            let places: Vec<String> = call.ranges.iter().map(|(start, _)| case.place(file, *start)).collect();
            writeln!(answer, "{title} {} at {}", shown(&call.item), places.join(", ")).unwrap();
        }
    }
    run("call_hierarchy", |case| {
        let snapshot = &case.snapshot;
        let Some(item) = call_hierarchy::prepare(snapshot, case.cursor()) else {
            return "no function".into();
        };
        let mut answer = shown(&item) + "\n";
        let incoming = call_hierarchy::incoming(snapshot, &item.place);
        list(case, "from", &incoming, None, &mut answer);
        list(
            case,
            "to",
            &call_hierarchy::outgoing(snapshot, &item.place),
            Some(&item.place.file),
            &mut answer,
        );
        for file in incoming.iter().filter(|caller| caller.item.kind.is_none()) {
            let place = &file.item.place;
            list(
                case,
                "the file calls",
                &call_hierarchy::outgoing(snapshot, place),
                Some(&place.file),
                &mut answer,
            );
        }
        answer
    });
}

/// Hints are shown in the text between «». A block `results` has `name: value` of the last run.
#[test]
fn inlay_hints() {
    run("inlay_hints", |case| {
        let lines = case.text("results").lines();
        let outputs = lines.clone().filter_map(|line| line.split_once(": ")).map(|(name, shown)| {
            (name.to_string(), OutputResult { shown: shown.to_string(), details: None })
        });
        let results =
            Results { outputs: outputs.collect(), outdated: lines.clone().any(|line| line == "outdated") };
        let source = source(case);
        let found = hints(&case.snapshot, &source, MODEL, range(case), HintSettings::default(), &results);
        let mut text = source.text.to_string();
        for hint in found.iter().rev() {
            text.insert_str(hint.offset as usize, &format!("«{}»", hint.label));
        }
        text
    });
}
