//! The editor set-ups of `lsp/editors/`: their words are the compiler's, their snippets are Calyx, and real editors get on with
//! `calyx lsp`.

mod clients;
mod snippets;
mod words;

use std::path::{Path, PathBuf};

/// A file or folder of `lsp/editors/`.
fn editors(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../lsp/editors").join(path)
}

fn read(path: &str) -> String {
    let path = editors(path);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
