//! Go to definition.

use super::enclosing::EnclosingNodes;
use super::labels::label_at;
use super::{Position, Snapshot};
use calyx_lang::analysis::{Name, NameKind, SourceRange, Visible};
use calyx_lang::declared::{Declared, find};
use calyx_lang::span::Span;
use std::ops::Range;
use std::sync::Arc;

/// Definition of a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// Name at the cursor.
    pub origin: Range<u32>,
    pub file: Arc<str>,
    /// Name in the declaration; empty at the start of a module.
    pub name: Range<u32>,
    /// Range of the whole declaration.
    pub item: Range<u32>,
}

/// Returns the definition of the name at a cursor; for a module, its file.
pub fn definition(snapshot: &Snapshot, at: &Position) -> Option<Definition> {
    let database = &snapshot.database;
    if let Some(name) = database.name_at(&at.file, at.offset) {
        return declared(snapshot, &name, name.declared.as_ref()?);
    }
    let label = label_at(&database.tree(&at.file)?.module, at.offset)?;
    let range = |span: Span| span.start..span.end;
    let all = [label.declared].into_iter().chain(label.jumps);
    let origin = all.into_iter().find(|span| span.start <= at.offset && at.offset <= span.end)?;
    let (name, item) = (range(label.declared), range(label.declared));
    Some(Definition { origin: range(origin), file: at.file.clone(), name, item })
}

/// Returns the definition of the record type of the value at a cursor.
pub fn type_definition(snapshot: &Snapshot, at: &Position) -> Option<Definition> {
    let database = &snapshot.database;
    let name = database.name_at(&at.file, at.offset)?;
    if matches!(name.kind, NameKind::Record | NameKind::Component) {
        return declared(snapshot, &name, name.declared.as_ref()?);
    }
    // The result type of a function, the element type of an array.
    let ty = name.ty.as_deref()?;
    let ty = ty.rsplit("->").next().unwrap_or(ty).trim();
    let ty = ty.trim_start_matches("Array(").trim_end_matches(')');
    let (module, record) = ty.rsplit_once('.').map_or((None, ty), |(module, record)| (Some(module), record));
    let is_type = |kind| matches!(kind, NameKind::Record | NameKind::Component);
    let is_record = |known: &&Visible| is_type(known.kind) && *known.name == *record;
    let visible = || database.visible(&at.file, at.offset);
    let known = match module {
        Some(module) => database.members(module).iter().find(is_record).cloned(),
        None => visible().iter().find(is_record).cloned(),
    };
    // The type of a record of a module is its unqualified name.
    let exported =
        || database.exported(record).into_iter().map(|(_, known)| known).find(|known| is_record(&known));
    let place = known.or_else(exported)?.declared?;
    declared(snapshot, &name, &place)
}

fn declared(snapshot: &Snapshot, name: &Name, place: &SourceRange) -> Option<Definition> {
    let whole = match place.end {
        // A module.
        0 => 0..0,
        _ => item(snapshot, place).unwrap_or(place.start..place.end),
    };
    Some(Definition {
        origin: name.start..name.end,
        file: place.file.clone(),
        name: place.start..place.end,
        item: whole,
    })
}

/// Returns the statement of the declaration at a position.
fn item(snapshot: &Snapshot, place: &SourceRange) -> Option<Range<u32>> {
    let tree = snapshot.database.around(&place.file, place.start)?;
    let (top, found) = find(&tree.module, place.start)?;
    let span = match found {
        Declared::Statement(statement)
        | Declared::Variable(statement, _)
        | Declared::Caught(statement)
        | Declared::Element(statement, ..) => statement.span,
        Declared::Parameter(..) | Declared::Field(..) | Declared::Choice(..) => {
            let around = EnclosingNodes::new(&tree.module, place.start..place.end);
            around.statements().next_back().map_or(top.span, |inner| inner.span)
        }
    };
    Some(span.start..span.end)
}
