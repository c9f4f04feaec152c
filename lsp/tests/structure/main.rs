//! What follows from a file's structure: outline, folds, selections, layout, tokens.

mod properties;
#[path = "../support/mod.rs"]
mod support;

use calyx_lsp::ide::folding::{FoldKind, folds};
use calyx_lsp::ide::formatting::{Change, format_file, format_selection};
use calyx_lsp::ide::selection::selections;
use calyx_lsp::ide::source::Source;
use calyx_lsp::ide::symbols::{Symbol, find, symbols};
use calyx_lsp::ide::typing::typed;
use std::fmt::Write;
use support::{Case, run};

fn source(case: &Case) -> Source {
    Source::new(case.text("model.cx"))
}

/// The text after changes that do not overlap.
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
            let (start, end) = (case.place("model.cx", fold.start), case.place("model.cx", fold.end));
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
            let place = |offset| case.place("model.cx", offset);
            let (start, end) = (place(symbol.start), place(symbol.end));
            let (indent, kind) = ("  ".repeat(depth), format!("{:?}", symbol.kind).to_lowercase());
            writeln!(answer, "{indent}{kind} {}{detail} @ {start} - {end}", symbol.name).unwrap();
            show(case, &symbol.children, depth + 1, answer);
        }
    }
    run("symbols", |case| {
        let mut answer = String::new();
        show(case, &symbols(&source(case), &|_| None), 0, &mut answer);
        answer
    });
}

/// The first line is what is searched for.
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

/// Without a cursor the file, with two the selection between them.
#[test]
fn formatting() {
    run("formatting", |case| {
        let source = source(case);
        let changes = match case.cursors.as_slice() {
            [] => format_file(&source),
            [only] => format_selection(&source, only.offset..only.offset),
            [first, .., last] => format_selection(&source, first.offset..last.offset),
        };
        changed(&source.text, &changes)
    });
}

/// The character before the cursor was typed.
#[test]
fn typing() {
    run("typing", |case| {
        let source = source(case);
        let offset = case.cursor().offset;
        // Blanks behind a line end were put there by the editor.
        let before = source.text[..offset as usize].trim_end_matches(' ');
        let character = before.chars().next_back().expect("something was typed");
        let changes = typed(&source, offset, character);
        changed(&source.text, &changes).lines().map(|line| format!("{line}|\n")).collect()
    });
}
