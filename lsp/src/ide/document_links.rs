//! Document links: imports link to the files of their modules.

use super::Snapshot;
use super::source::Source;
use calyx_lang::ast::StmtKind;
use std::sync::Arc;

/// Path of an import, and its file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Link {
    pub start: u32,
    pub end: u32,
    pub file: Arc<str>,
}

/// Returns the resolved imports of a file.
pub fn links(snapshot: &Snapshot, source: &Source<'_>) -> Vec<Link> {
    let imports = source.tree.module.statements.iter().filter_map(|statement| match &statement.kind {
        StmtKind::Import(path) => Some(path),
        _ => None,
    });
    let link = |path: &calyx_lang::ast::Import| {
        let (first, last) = (path.first()?, path.last()?);
        let names: Vec<&str> = path.iter().map(|name| name.name.as_str()).collect();
        let file = snapshot.database.file_of(&names.join("."))?;
        Some(Link { start: first.span.start, end: last.span.end, file })
    };
    imports.filter_map(link).collect()
}
