//! What is wrong with a file, in any of the models it is part of.

use super::Snapshot;
use calyx_lang::diagnostic::Diagnostic;
use calyx_lang::span::FileId;

/// The diagnostics that blame a place in a file, in order of place. Other places in them may lie in other files; what they
/// offer to change is of this file.
pub fn of_file(snapshot: &Snapshot, file: &str) -> Vec<Diagnostic> {
    let database = &snapshot.database;
    let imports =
        |model: &&str| *model == file || database.imported(model).iter().any(|other| **other == *file);
    let mut found: Vec<Diagnostic> = Vec::new();
    for model in database.models().filter(imports) {
        let Some(checked) = database.check(model) else { continue };
        let Some(own) = checked.files.iter().position(|source| source.name == file) else { continue };
        let own = FileId(own as u32);
        for diagnostic in checked.diagnostics.iter().filter(|d| d.primary.span.file == own) {
            let mut diagnostic = diagnostic.clone();
            diagnostic.fix = diagnostic.fix.filter(|fix| fix.span.file == own);
            diagnostic.suggestions.retain(|fix| fix.span.file == own);
            // Labels elsewhere are of no use to who does not know the model's files.
            diagnostic.labels.retain(|label| label.span.file == own);
            let known = |d: &Diagnostic| {
                (d.primary.span.start, d.primary.span.end)
                    == (diagnostic.primary.span.start, diagnostic.primary.span.end)
                    && (&d.code, &d.message) == (&diagnostic.code, &diagnostic.message)
            };
            if !found.iter().any(known) {
                found.push(diagnostic);
            }
        }
    }
    found.sort_by_key(|d| (d.primary.span.start, d.primary.span.end));
    found
}
