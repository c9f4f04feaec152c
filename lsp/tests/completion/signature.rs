//! Signature help: `tests/ide/signature.md`.

use crate::support;
use calyx_lsp::ide::signature::signature;

#[test]
fn signatures() {
    support::run("signature", |case| {
        let answers = case.cursors.iter().map(|cursor| {
            let Some(found) = signature(&case.snapshot, cursor) else { return "nothing\n".to_string() };
            let mut text = found.label.clone();
            if let Some(shown) = found.active.and_then(|at| found.parameters.get(at)) {
                // Marks the active parameter.
                let mark = "^".repeat(shown.label.len());
                text.push_str(&format!("\n{}{mark}\n{}", " ".repeat(shown.label.start), shown.doc));
            }
            text.trim_end().to_string() + "\n"
        });
        answers.collect::<Vec<_>>().join("\n")
    });
}
