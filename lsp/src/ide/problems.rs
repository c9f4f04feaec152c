//! Diagnostics of a file, from all models it is part of.

use super::Snapshot;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::ir::SourceFile;
use calyx_lang::span::FileId;

/// Returns the diagnostics in a file, sorted by position, including those of elaboration. Omits
/// labels in other files; the fixes are edits of this file.
pub fn of_file(snapshot: &Snapshot, file: &str) -> Vec<Diagnostic> {
    let database = &snapshot.database;
    let imports =
        |model: &&str| *model == file || database.imported(model).iter().any(|other| **other == *file);
    let mut found: Vec<Diagnostic> = Vec::new();
    for model in database.models().filter(imports) {
        let Some(checked) = database.check(model) else { continue };
        found.extend(of_model(&checked.diagnostics, &checked.files, file));
        if let Some(elaborated) = snapshot.elaborated.get(model) {
            found.extend(of_model(&elaborated.found(database), elaborated.files(), file));
        }
    }
    found.sort_by_key(|d| (d.primary.span.start, d.primary.span.end));
    let mut seen: Vec<Diagnostic> = Vec::new();
    for diagnostic in found {
        let key =
            |d: &Diagnostic| (d.primary.span.start, d.primary.span.end, d.code.clone(), d.message.clone());
        // A module may be part of several models.
        let near = seen.iter().rev().take_while(|d| d.primary.span.start == diagnostic.primary.span.start);
        if !near.into_iter().any(|known| key(known) == key(&diagnostic)) {
            seen.push(diagnostic);
        }
    }
    seen
}

fn of_model(all: &[Diagnostic], files: &[SourceFile], file: &str) -> Vec<Diagnostic> {
    let Some(own) = files.iter().position(|source| source.name == file) else { return Vec::new() };
    let own = FileId(own as u32);
    let each = all.iter().filter(|diagnostic| diagnostic.primary.span.file == own).map(|diagnostic| {
        let mut diagnostic = diagnostic.clone();
        diagnostic.fix = diagnostic.fix.filter(|fix| fix.span.file == own);
        diagnostic.suggestions.retain(|fix| fix.span.file == own);
        diagnostic.labels.retain(|label| label.span.file == own);
        diagnostic
    });
    each.collect()
}
