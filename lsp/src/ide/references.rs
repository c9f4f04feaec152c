//! Find references, and highlights of a name.

use super::labels::{exits_at, label_at};
use super::{Position, Snapshot};
use calyx_lang::analysis::{Name, NameKind};
use std::ops::Range;
use std::sync::Arc;

/// Reference to a name.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Reference {
    pub file: Arc<str>,
    pub start: u32,
    pub end: u32,
    /// True for a declaration or an assignment.
    pub writes: bool,
}

/// Returns every reference to the name at a cursor, sorted by file and position. For builtin names,
/// the references in the user's files.
pub fn references(snapshot: &Snapshot, at: &Position, with_declaration: bool) -> Vec<Reference> {
    let database = &snapshot.database;
    let reference = |file: &Arc<str>, name: &Name| Reference {
        file: file.clone(),
        start: name.start,
        end: name.end,
        writes: name.writes || name.declares,
    };
    let mut found: Vec<Reference> = match database.name_at(&at.file, at.offset) {
        Some(name) => match &name.declared {
            Some(place) => {
                let all = database.references(place);
                let all = all.iter().filter(|(_, name)| with_declaration || !name.declares);
                all.map(|(file, name)| reference(file, name)).collect()
            }
            None => {
                let files = database.files().into_iter().filter(|file| !file.starts_with('<'));
                let alike = |other: &Name| same(&name, other);
                let each = files.flat_map(|file| {
                    let names = database.names(&file).into_iter().filter(alike);
                    names.map(|name| reference(&file, &name)).collect::<Vec<_>>()
                });
                each.collect()
            }
        },
        None => label(snapshot, at, with_declaration),
    };
    found.sort();
    found.dedup();
    found
}

/// Returns true if two names refer to the same builtin.
fn same(a: &Name, b: &Name) -> bool {
    a.declared.is_none() && b.declared.is_none() && (a.kind, &a.text) == (b.kind, &b.text)
}

fn label(snapshot: &Snapshot, at: &Position, with_declaration: bool) -> Vec<Reference> {
    let Some(tree) = snapshot.database.tree(&at.file) else { return Vec::new() };
    let Some(label) = label_at(&tree.module, at.offset) else { return Vec::new() };
    let declared = with_declaration.then_some((label.declared, true));
    let jumps = label.jumps.into_iter().map(|span| (span, false));
    declared
        .into_iter()
        .chain(jumps)
        .map(|(span, writes)| Reference { file: at.file.clone(), start: span.start, end: span.end, writes })
        .collect()
}

/// Range to highlight.
#[derive(Clone, Debug, PartialEq)]
pub struct Highlight {
    pub range: Range<u32>,
    /// True for a write, false for a read; `None` for types, modules and keywords.
    pub writes: Option<bool>,
}

/// Returns the highlights in the file of the cursor: the same name, or the exits of the same loop
/// or function.
pub fn highlight(snapshot: &Snapshot, at: &Position) -> Vec<Highlight> {
    let database = &snapshot.database;
    if let Some(asked) = database.name_at(&at.file, at.offset) {
        let holds = matches!(
            asked.kind,
            NameKind::Variable | NameKind::Symbolic | NameKind::Parameter | NameKind::Param | NameKind::Field
        );
        let names = database.names(&at.file).into_iter();
        let meant = names.filter(|name| match &asked.declared {
            Some(_) => name.declared == asked.declared,
            None => same(&asked, name),
        });
        let each = meant.map(|name| Highlight {
            range: name.start..name.end,
            writes: holds.then_some(name.writes || name.declares),
        });
        return each.collect();
    }
    let labels = label(snapshot, at, true);
    if !labels.is_empty() {
        return labels.iter().map(|of| Highlight { range: of.start..of.end, writes: None }).collect();
    }
    let Some(tree) = database.tree(&at.file) else { return Vec::new() };
    let words = exits_at(&tree.module, at.offset);
    words.into_iter().map(|span| Highlight { range: span.start..span.end, writes: None }).collect()
}
