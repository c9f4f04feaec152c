//! Tests of the editor support in `lsp/editors/`: keywords match those of the compiler, snippets
//! are valid Calyx, and installed editors work with `calyx lsp`.

mod clients;
mod snippets;
mod words;

use std::path::{Path, PathBuf};

/// Returns a file or directory of `lsp/editors/`.
fn editors(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../lsp/editors").join(path)
}

fn read(path: &str) -> String {
    let path = editors(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
