//! Queries over names: the items that an item depends on, and groups of mutually recursive
//! functions.

use super::items::{Item, declared, items, module, nameable, namings, reachable, state_names};
use super::{Library, Text};
use crate::check::excerpt::{Extract, Part};
use crate::check::item::{self, ItemKind};
use crate::check::sees;
use crate::components::components;
use crate::hashed::{HashMap, HashSet};
use salsa::plumbing::AsId;
use smol_str::SmolStr;
use std::sync::Arc;

/// Functions that are checked together: one function, or mutually recursive functions.
#[salsa::interned]
pub(super) struct Group<'db> {
    pub members: Vec<Item<'db>>,
}

/// Returns the items that names in a file can refer to.
fn meant<'db>(
    db: &'db dyn salsa::Database,
    file: Text,
    names: &HashSet<SmolStr>,
    library: Library,
) -> Vec<Item<'db>> {
    let mut found: Vec<Item<'db>> = Vec::new();
    let mut imported = Vec::new();
    let (own, prelude) = (nameable(db, file), library.prelude(db));
    for item in names.iter().filter_map(|name| own.get(name.as_str()).copied()) {
        if let ItemKind::Import(path) = item.kind(db) {
            imported.extend(module(db, library, path.clone()));
        }
        found.push(item);
    }
    imported.extend((prelude != file).then_some(prelude));
    // A text may stand for a handle of a type that the item names.
    for file in imported.iter().copied().chain([file]) {
        let namings = namings(db, file).iter().filter(|(handle, _)| names.contains(handle.as_str()));
        found.extend(namings.map(|(_, item)| *item));
    }
    for file in imported {
        let exported = nameable(db, file);
        let all = names.iter().filter_map(|name| exported.get(name.as_str()).copied());
        found.extend(all.filter(|item| {
            matches!(item.kind(db), ItemKind::Function | ItemKind::Extern | ItemKind::Declaration)
        }));
    }
    found.sort_by_key(|item| item.as_id());
    found.dedup();
    found
}

/// Returns the part of an item that other items depend on.
#[salsa::tracked]
pub(super) fn header<'db>(db: &'db dyn salsa::Database, item: Item<'db>) -> Arc<item::Item> {
    Arc::new(item.content(db).header())
}

/// Returns the items of a file that declare a name, in order.
#[salsa::tracked]
pub(super) fn named<'db>(db: &'db dyn salsa::Database, file: Text, name: String) -> Vec<Item<'db>> {
    declared(db, file).get(&name).cloned().unwrap_or_default()
}

/// Returns the items that an item refers to.
#[salsa::tracked]
pub(super) fn links<'db>(db: &'db dyn salsa::Database, item: Item<'db>, library: Library) -> Vec<Item<'db>> {
    meant(db, item.file(db), &item.content(db).names, library)
}

/// Returns the items that users of an item also depend on.
#[salsa::tracked]
pub(super) fn header_links<'db>(
    db: &'db dyn salsa::Database,
    item: Item<'db>,
    library: Library,
) -> Vec<Item<'db>> {
    meant(db, item.file(db), &item.content(db).header_names, library)
}

/// Returns the representative of the files that import each other; a file without import cycle
/// represents itself.
#[salsa::tracked]
fn leader(db: &dyn salsa::Database, text: Text, library: Library) -> Text {
    let mutual = |other: &Text| reachable(db, *other, library).contains(&text);
    let others = reachable(db, text, library).iter().copied().filter(mutual);
    others.chain([text]).min_by_key(|file| file.as_id()).unwrap_or(text)
}

/// Groups of functions, callees first.
#[derive(Debug, Default, PartialEq, salsa::SalsaValue)]
pub(super) struct Groups<'db> {
    pub order: Vec<Vec<Item<'db>>>,
    of: HashMap<Item<'db>, usize>,
}

/// Returns the groups of a file and of the files in the same import cycle.
#[salsa::tracked]
fn groups_of_leader(db: &dyn salsa::Database, first: Text, library: Library) -> Groups<'_> {
    let others = reachable(db, first, library).iter().copied();
    let mut files: Vec<Text> = others.filter(|file| *leader(db, *file, library) == first).collect();
    if !files.contains(&first) {
        files.push(first);
    }
    let files: HashSet<Text> = files.into_iter().collect();
    let all = files.iter().flat_map(|file| items(db, *file)).copied();
    let mut all: Vec<Item<'_>> = all.filter(|item| is_node(db, *item)).collect();
    all.sort_by_key(|item| item.as_id());
    let found = components(all, |item| {
        let all = links(db, item, library).iter().copied();
        all.filter(|to| is_node(db, *to) && files.contains(&to.file(db))).collect::<Vec<_>>()
    });
    let mut groups = Groups::default();
    for mut members in found {
        members.retain(|item| *item.kind(db) != ItemKind::Declaration);
        members.sort_by_key(|item| item.as_id());
        groups.of.extend(members.iter().map(|item| (*item, groups.order.len())));
        groups.order.push(members);
    }
    groups
}

fn is_node(db: &dyn salsa::Database, item: Item<'_>) -> bool {
    matches!(item.kind(db), ItemKind::Function | ItemKind::Extern | ItemKind::Declaration)
}

pub(super) fn groups<'db>(db: &'db dyn salsa::Database, file: Text, library: Library) -> &'db Groups<'db> {
    groups_of_leader(db, *leader(db, file, library), library)
}

/// Returns the group of a function.
#[salsa::tracked(returns(copy))]
pub(super) fn group_of<'db>(db: &'db dyn salsa::Database, item: Item<'db>, library: Library) -> Group<'db> {
    let groups = groups(db, item.file(db), library);
    let members = groups.of.get(&item).and_then(|index| groups.order.get(*index));
    Group::new(db, members.cloned().unwrap_or_else(|| vec![item]))
}

/// Returns `true` if a function uses a variable, param or output of its file's top level.
#[salsa::tracked(returns(copy))]
pub(super) fn sees_state<'db>(db: &'db dyn salsa::Database, item: Item<'db>) -> bool {
    let (states, content) = (state_names(db, item.file(db)), item.content(db));
    let shared: Vec<&str> =
        content.names.iter().filter(|name| states.contains(name.as_str())).map(SmolStr::as_str).collect();
    // A local variable of the function may shadow the name.
    !shared.is_empty()
        && sees(Extract { name: String::new(), system: None, items: vec![(0, content, Part::Own)] }, &shared)
}
