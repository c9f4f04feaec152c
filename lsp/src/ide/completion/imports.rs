//! Completion of names in modules that are not imported; the chosen item adds the `import`.

use super::item::{Item, Rank};
use super::names;
use super::request::Request;
use crate::ide::Edit;
use crate::ide::cursor::CursorContext;
use calyx_lang::lexer::Kind;

/// Smallest number of typed letters: a list of all names would be useless.
const LEAST_TYPED: usize = 2;

/// Offers the declarations of modules that are not imported.
pub fn not_imported(request: &Request<'_>, items: &mut Vec<Item>) {
    let around = &request.context.around;
    if around.prefix().chars().count() < LEAST_TYPED {
        return;
    }
    let imported = imported(around);
    let own = request.database.module_of(request.file);
    for path in request.database.modules() {
        let name = path.rsplit('.').next().unwrap_or(&path).to_string();
        // Skips names that are shadowed.
        if imported.contains(&path) || own.as_deref() == Some(&*path) || request.find(&name).is_some() {
            continue;
        }
        for (order, known) in request.database.members(&path).iter().enumerate() {
            if names::fit(request, known).is_none() {
                continue;
            }
            let rank = Rank { fit: 5, origin: 7, order: order as u32 };
            let mut item = names::item(request, known, Some(&name), rank);
            item.detail = format!("import {path}; {}", item.detail);
            item.import = Some(import(request.file, around, &path));
            items.push(item);
        }
    }
}

/// Returns the modules that a file imports.
pub fn imported(around: &CursorContext<'_>) -> Vec<String> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(kind) = around.kind(at) {
        // The incomplete import at the cursor does not count.
        if kind == Kind::Import && !(at < around.before && around.statement(around.before).start == at) {
            found.push(path(around, at + 1));
        }
        at += 1;
    }
    found
}

fn path(around: &CursorContext<'_>, from: usize) -> String {
    let names = (from..).map_while(|at| match around.kind(at) {
        Some(Kind::Identifier | Kind::Dot) => Some(around.source(at)),
        _ => None,
    });
    names.collect()
}

/// Returns the edit that imports a module: after the last import, else before all statements.
pub fn import(file: &str, around: &CursorContext<'_>, path: &str) -> Edit {
    let tokens = (0..).map_while(|at| around.kind(at).map(|kind| (at, kind)));
    let last = tokens.filter(|(_, kind)| *kind == Kind::Import).last();
    let (offset, replacement) = match last {
        Some((at, _)) => {
            let end = (at..)
                .find(|&at| !matches!(around.kind(at), Some(Kind::Import | Kind::Identifier | Kind::Dot)));
            let end = end.filter(|&end| around.kind(end) == Some(Kind::Semicolon)).unwrap_or(at);
            (around.range(end).end, format!("\nimport {path};"))
        }
        None => (head(around), format!("import {path};\n")),
    };
    Edit { file: file.into(), start: offset as u32, end: offset as u32, replacement }
}

/// Returns the start of the first statement with its comments, after the documentation of the file.
fn head(around: &CursorContext<'_>) -> usize {
    let mut offset = 0;
    let mut rest = around.text;
    // A block of comments followed by an empty line documents the file.
    let block: usize =
        rest.split_inclusive('\n').take_while(|line| line.starts_with("//")).map(str::len).sum();
    let behind = rest.get(block..).unwrap_or_default();
    let blank = behind.len() - behind.trim_start_matches(['\n', '\r']).len();
    if block > 0 && blank > 0 {
        offset = block + blank;
        rest = "";
    }
    if rest.starts_with('\u{feff}') { '\u{feff}'.len_utf8() } else { offset }
}
