//! Queries that check: groups of functions, and the rest of a file.

use super::groups::{Group, group_of, groups, header, header_links, links, named, sees_state};
use super::items::{
    Item, bases, declarations, declared, facts, handles, items, library_bases, module, own_handles,
    reachable, vocabulary,
};
use super::{Library, Text};
use crate::ast::{StmtKind, TypeExpr, TypeKind};
use crate::check::excerpt::{Excerpt, Extract, ItemId, Part};
use crate::check::interface::Interface;
use crate::check::item::ItemKind;
use crate::check::unit::{self, Context, Maker, Surroundings, Unit};
use crate::hashed::{HashMap, HashSet};
use salsa::Id;
use salsa::plumbing::{AsId, FromId};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The result of checking a group.
#[derive(Debug, Default)]
pub(super) struct Checked {
    /// The unit; `None` if the group can only be checked together with its uses.
    pub unit: Option<Unit>,
    /// Interfaces by member of the group.
    interfaces: Option<Vec<Arc<Interface>>>,
}

pub(super) fn id(item: Item<'_>) -> ItemId {
    item.as_id().as_bits()
}

// The result is large and rarely equal to the previous one; `interfaces` compares the parts that
// other units need.
#[salsa::tracked(no_eq)]
pub(super) fn check_group<'db>(
    db: &'db dyn salsa::Database,
    group: Group<'db>,
    library: Library,
) -> Arc<Checked> {
    let members = group.members(db);
    let Some(first) = members.first() else { return Arc::default() };
    let mut gathered = Gathered::new(db, first.file(db), library);
    for &member in members {
        gathered.add(member, Part::Own);
    }
    gathered.follow();
    if gathered.open {
        return Arc::default();
    }
    let ids: Vec<ItemId> = members.iter().map(|item| id(*item)).collect();
    let (unit, interfaces) = gathered.check(&ids);
    let interfaces = interfaces.map(|all| all.into_iter().map(Arc::new).collect());
    Arc::new(Checked { unit: Some(unit), interfaces })
}

/// Returns the interfaces of a group's functions; `None` if their types depend on their uses.
#[salsa::tracked]
fn interfaces<'db>(
    db: &'db dyn salsa::Database,
    group: Group<'db>,
    library: Library,
) -> Option<Vec<Arc<Interface>>> {
    check_group(db, group, library).interfaces.clone()
}

fn interface<'db>(db: &'db dyn salsa::Database, item: Item<'db>, library: Library) -> Option<Arc<Interface>> {
    let group = group_of(db, item, library);
    let at = group.members(db).iter().position(|member| *member == item)?;
    interfaces(db, group, library).as_ref()?.get(at).cloned()
}

/// Returns the functions of a file that are checked with its top level: they use its variables,
/// their types depend on their uses, or they call such functions.
#[salsa::tracked]
pub(super) fn dependents(db: &dyn salsa::Database, file: Text, library: Library) -> HashSet<Item<'_>> {
    let mut found: HashSet<Item<'_>> = HashSet::default();
    for members in &groups(db, file, library).order {
        let own = |item: &Item<'_>| item.file(db) == file && *item.kind(db) == ItemKind::Function;
        if !members.iter().any(own) {
            continue;
        }
        let dependent = members.iter().any(|item| {
            sees_state(db, *item) || links(db, *item, library).iter().any(|to| found.contains(to))
        });
        if dependent || interfaces(db, Group::new(db, members.clone()), library).is_none() {
            found.extend(members.iter().copied().filter(own));
        }
    }
    found
}

/// Checks the rest of a file, without the functions that can be checked on their own.
#[salsa::tracked(no_eq)]
pub(super) fn check_top(db: &dyn salsa::Database, file: Text, library: Library) -> Arc<Unit> {
    let dependents = dependents(db, file, library);
    let mut gathered = Gathered::new(db, file, library);
    gathered.top = true;
    for &item in items(db, file) {
        match item.kind(db) {
            ItemKind::Extern => {}
            ItemKind::Function if !dependents.contains(&item) => {}
            _ => gathered.add(item, Part::Own),
        }
    }
    gathered.follow();
    Arc::new(gathered.check(&[]).0)
}

/// The items of an excerpt.
struct Gathered<'db> {
    db: &'db dyn salsa::Database,
    library: Library,
    file: Text,
    /// `true` for a top level, which includes functions that cannot be checked on their own.
    top: bool,
    /// `true` if a function was found that cannot be checked on its own.
    open: bool,
    parts: HashMap<Item<'db>, Part>,
    left: Vec<Item<'db>>,
    interfaces: HashMap<ItemId, Arc<Interface>>,
}

impl<'db> Gathered<'db> {
    fn new(db: &'db dyn salsa::Database, file: Text, library: Library) -> Self {
        Gathered {
            db,
            library,
            file,
            top: false,
            open: false,
            parts: HashMap::default(),
            left: Vec::new(),
            interfaces: HashMap::default(),
        }
    }

    fn add(&mut self, item: Item<'db>, part: Part) {
        self.parts.insert(item, part);
        self.left.push(item);
    }

    /// Adds the items that the existing ones need.
    fn follow(&mut self) {
        let (db, library) = (self.db, self.library);
        // The type of a `catch` variable need not be named in the source.
        for &item in named(db, library.prelude(db), "Error".to_string()) {
            if *item.kind(db) == ItemKind::Declaration && !self.parts.contains_key(&item) {
                self.add(item, Part::Whole);
            }
        }
        self.follow_links(true);
        let imported = reachable(db, self.file, library).iter().copied();
        for file in [self.file, library.prelude(db)].into_iter().chain(imported) {
            for &item in vocabulary(db, file) {
                if !self.parts.contains_key(&item) {
                    self.add(item, Part::Whole);
                }
            }
        }
        // All units share the declared units and dimensions. These must not refer to functions;
        // such an error is reported at the top level. Following it from every group would lead to a
        // cycle of queries.
        self.follow_links(self.top);
    }

    /// Adds the items that the newly added items refer to.
    fn follow_links(&mut self, to_functions: bool) {
        let (db, library) = (self.db, self.library);
        while let Some(item) = self.left.pop() {
            let needed = match self.parts.get(&item) {
                Some(Part::Header) => header_links(db, item, library),
                _ => links(db, item, library),
            };
            let mut needed = needed.clone();
            while let Some(to) = needed.pop() {
                if self.parts.contains_key(&to) || (!to_functions && *to.kind(db) == ItemKind::Function) {
                    continue;
                }
                let part = match to.kind(db) {
                    ItemKind::Function => match interface(db, to, library) {
                        Some(interface) => {
                            // Records, and components whose instances occur in its types.
                            let records = interface.records.iter();
                            needed.extend(records.map(|(record, _)| Item::from_id(Id::from_bits(*record))));
                            self.interfaces.insert(id(to), interface);
                            Part::Header
                        }
                        None => {
                            self.open = true;
                            Part::Whole
                        }
                    },
                    _ => Part::Whole,
                };
                self.add(to, part);
                if self.open && !self.top {
                    return;
                }
            }
        }
    }

    fn check(self, group: &[ItemId]) -> (Unit, Option<Vec<Interface>>) {
        let db = self.db;
        let mut files: Vec<Text> = Vec::new();
        for item in self.parts.keys() {
            files.push(item.file(db));
            if let ItemKind::Import(path) = item.kind(db) {
                files.extend(module(db, self.library, path.clone()));
            }
        }
        let prelude = self.library.prelude(db);
        files.retain(|file| *file != self.file && *file != prelude);
        files.sort_by_key(|file| file.as_id());
        files.dedup();
        if self.file != prelude && !self.file.module(db).is_empty() {
            files.insert(0, self.file);
        }
        // A module can be checked without a model.
        let model = match self.file.module(db).as_str() {
            "" => self.extract(self.file),
            _ => Extract { name: String::new(), system: None, items: Vec::new() },
        };
        let mut extracts = vec![model, self.extract(prelude)];
        extracts.extend(files.into_iter().map(|file| self.extract(file)));
        let context = Context {
            interfaces: &self.interfaces,
            handles: handles(db, self.file, self.library),
            surroundings: &GroupContext { db, library: self.library, file: self.file },
        };
        let mut excerpt = Excerpt::new(extracts);
        excerpt.layout.bases = library_bases(db, self.library).clone();
        if self.file.module(db).is_empty() {
            let own = bases(db, self.file).iter().map(|name| (String::new(), name.clone()));
            excerpt.layout.bases.extend(own);
        }
        unit::check(excerpt, group, &context)
    }

    fn extract(&self, file: Text) -> Extract<'db> {
        let db = self.db;
        let mut chosen: Vec<Item<'db>> = Vec::new();
        if self.top && file == self.file {
            chosen.extend(items(db, file).iter().filter(|item| self.parts.contains_key(item)));
        } else {
            chosen.extend(declarations(db, file).iter().filter(|item| self.parts.contains_key(item)));
            // The order of functions matters only between functions with the same name.
            let mut by_name: BTreeMap<&String, Vec<Item<'db>>> = BTreeMap::new();
            for &item in self.parts.keys().filter(|item| item.file(db) == file && is_function(db, **item)) {
                by_name.entry(item.name(db)).or_default().push(item);
            }
            for (name, all) in by_name {
                match all.as_slice() {
                    [only] => chosen.push(*only),
                    // Items of one kind are numbered in order.
                    _ if all.iter().all(|item| item.kind(db) == all[0].kind(db)) => {
                        let mut all = all;
                        all.sort_by_key(|item| item.number(db));
                        chosen.extend(all);
                    }
                    _ => {
                        let all: HashSet<Item<'db>> = all.into_iter().collect();
                        chosen.extend(named(db, file, name.clone()).iter().filter(|item| all.contains(item)))
                    }
                }
            }
        }
        let item = |item: Item<'db>| match self.parts[&item] {
            Part::Header => (id(item), &**header(db, item), Part::Header),
            part => (id(item), &**item.content(db), part),
        };
        Extract {
            name: file.module(db).clone(),
            system: facts(db, file).system,
            items: chosen.into_iter().map(item).collect(),
        }
    }
}

fn is_function(db: &dyn salsa::Database, item: Item<'_>) -> bool {
    matches!(item.kind(db), ItemKind::Function | ItemKind::Extern)
}

/// Returns the name of a named type.
fn type_name(ty: &TypeExpr) -> Option<&str> {
    match &ty.kind {
        TypeKind::Name(name) | TypeKind::Member(_, name) => Some(&name.name),
        _ => None,
    }
}

/// Answers queries for the suggestions in diagnostics.
struct GroupContext<'db> {
    db: &'db dyn salsa::Database,
    library: Library,
    file: Text,
}

/// Limit of the declared names in a file for which suggestions are computed.
const MOST_NAMES: usize = 2000;

impl GroupContext<'_> {
    /// Returns the file of a module, of the prelude, or of the model itself.
    fn file_of(&self, name: &str) -> Option<Text> {
        let prelude = self.library.prelude(self.db);
        match name {
            _ if name == self.file.module(self.db) => Some(self.file),
            _ if name == prelude.module(self.db) => Some(prelude),
            _ => *module(self.db, self.library, name.to_string()),
        }
    }
}

impl Surroundings for GroupContext<'_> {
    fn doc(&self, name: &str) -> String {
        self.file_of(name).map(|file| facts(self.db, file).doc.clone()).unwrap_or_default()
    }

    fn makers(&self, handle: &str) -> Vec<Maker> {
        let mut makers = Vec::new();
        for name in self.modules() {
            let Some(file) = *module(self.db, self.library, name.clone()) else { continue };
            for item in items(self.db, file).iter().filter(|item| *item.kind(self.db) == ItemKind::Extern) {
                let StmtKind::Function(decl) = &item.content(self.db).statement.kind else { continue };
                let makes = decl.result.as_ref().is_some_and(|result| type_name(result) == Some(handle));
                if makes && !item.private(self.db) {
                    let parameters = decl.parameters.iter().filter_map(|parameter| {
                        let kind = type_name(parameter.annotation.as_ref()?)?;
                        Some((parameter.name.name.to_string(), kind.to_owned()))
                    });
                    let name = format!("{name}.{}", decl.name.name);
                    makers.push(Maker { name, parameters: parameters.collect() });
                }
            }
        }
        makers
    }

    fn declared(&self, name: &str) -> Vec<String> {
        let Some(file) = self.file_of(name) else { return Vec::new() };
        let declared = declared(self.db, file);
        if declared.len() > MOST_NAMES {
            return Vec::new();
        }
        // Only exported items of other files.
        let callable = |name: &String, all: &Vec<Item<'_>>| {
            all.iter().any(|item| {
                let declares = is_function(self.db, *item) || *item.kind(self.db) == ItemKind::Declaration;
                let is_current = item.name(self.db) == name;
                declares && is_current && (file == self.file || !item.private(self.db))
            })
        };
        let mut names: Vec<String> =
            declared.iter().filter(|(name, all)| callable(name, all)).map(|(name, _)| name.clone()).collect();
        names.sort();
        names
    }

    fn has_handle(&self, module: &str, handle: &str) -> bool {
        self.file_of(module).is_some_and(|file| own_handles(self.db, file).contains(handle))
    }

    fn is_module(&self, name: &str) -> bool {
        module(self.db, self.library, name.to_string()).is_some() || self.modules().iter().any(|m| m == name)
    }

    fn modules(&self) -> Vec<String> {
        self.library.known(self.db).clone()
    }
}
