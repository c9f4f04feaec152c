//! Queries over single files: their trees, their items, and their declarations.

use super::{Library, Parsed, Text};
use crate::ast::StmtKind;
use crate::check::item::{self, ItemKind, Split};
use crate::check::{handles_of, model_doc, named_type};
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::lexer::{self, Tokens};
use crate::parser;
use crate::parser::chunks::{Chunk, PlacedChunk, pieces};
use crate::span::FileId;
use crate::threads;
use crate::units::UnitSystem;
use std::collections::BTreeSet;
use std::ops::{Deref, Range};
use std::sync::{Arc, Mutex, PoisonError};

#[salsa::tracked(no_eq)]
pub(super) fn tokens(db: &dyn salsa::Database, text: Text) -> Arc<Tokens> {
    Arc::new(lexer::lex(FileId(0), text.content(db)))
}

/// A piece of a text, parsed and split into items.
#[derive(Debug)]
pub(super) struct Part {
    pub start: u32,
    pub piece: Arc<Chunk>,
    pub splits: Arc<Vec<Split>>,
}

/// A cache of the parsed pieces of a text, by their text, across revisions: after an edit, only
/// changed pieces are parsed.
#[derive(Debug, Default)]
pub(super) struct ChunkCache(Mutex<HashMap<Arc<str>, KnownChunk>>);

#[derive(Clone, Debug)]
struct KnownChunk {
    piece: Arc<Chunk>,
    splits: Arc<Vec<Split>>,
}

/// The text of a piece and its items.
type SplitText = (Arc<str>, Arc<Vec<Split>>);

#[salsa::tracked(no_eq)]
pub(super) fn parts(db: &dyn salsa::Database, text: Text) -> Arc<Vec<Part>> {
    let content = text.content(db);
    let mut kept = text.kept(db).0.lock().unwrap_or_else(PoisonError::into_inner);
    let pieces = pieces(content, tokens(db, text), |slice| Some(kept.get(slice)?.piece.clone()));
    let slice = |range: &Range<usize>| content.get(range.clone()).unwrap_or_default();
    let known = |placed: &PlacedChunk| {
        let (written, known) = kept.get_key_value(slice(&placed.range))?;
        Arc::ptr_eq(&known.piece, &placed.piece).then(|| (written.clone(), known.splits.clone()))
    };
    let mut found: Vec<Option<SplitText>> = pieces.iter().map(known).collect();
    let new: Vec<_> = pieces.iter().zip(&mut found).filter(|(_, found)| found.is_none()).collect();
    let threads = threads::for_text(new.iter().map(|(placed, _)| placed.range.len()).sum());
    threads::for_each(new, threads, |(placed, found)| {
        let slice = slice(&placed.range);
        let statements = placed.piece.statements.iter();
        let splits = statements.map(|statement| item::split(statement.clone(), slice)).collect();
        *found = Some((Arc::from(slice), Arc::new(splits)));
    });
    let count = pieces.len();
    let mut next: HashMap<Arc<str>, KnownChunk> =
        HashMap::with_capacity_and_hasher(count, Default::default());
    let mut parts = Vec::with_capacity(count);
    for (PlacedChunk { range, piece }, (written, splits)) in
        pieces.into_iter().zip(found.into_iter().flatten())
    {
        // The last piece depends on the end of the file.
        if parts.len() + 1 < count {
            next.insert(written, KnownChunk { piece: piece.clone(), splits: splits.clone() });
        }
        parts.push(Part { start: range.start as u32, piece, splits });
    }
    *kept = next;
    Arc::new(parts)
}

/// Returns the syntax errors of a file.
pub(super) fn problems(db: &dyn salsa::Database, text: Text) -> Vec<Diagnostic> {
    let own = parts(db, text)
        .iter()
        .flat_map(|part| part.piece.problems.iter().map(|problem| problem.moved(FileId(0), part.start)));
    tokens(db, text).diagnostics.iter().cloned().chain(own).collect()
}

/// Returns the tree of a file.
#[salsa::tracked(no_eq)]
pub(super) fn parse(db: &dyn salsa::Database, text: Text) -> Arc<Parsed> {
    let placed = parts(db, text).iter().map(|part| PlacedChunk {
        range: part.start as usize..part.start as usize,
        piece: part.piece.clone(),
    });
    let (module, diagnostics) = parser::assemble(FileId(0), tokens(db, text), &placed.collect::<Vec<_>>());
    Arc::new(Parsed { module, diagnostics })
}

/// The content of an item. Most items are unchanged from one revision to the next, which a pointer
/// comparison detects.
#[derive(Clone, Debug, salsa::SalsaValue)]
pub(super) struct Content(pub Arc<item::Item>);

impl PartialEq for Content {
    fn eq(&self, other: &Content) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.0 == other.0
    }
}

impl Deref for Content {
    type Target = item::Item;

    fn deref(&self) -> &item::Item {
        &self.0
    }
}

/// A top-level statement. It keeps its identity as long as it declares the same name.
#[salsa::tracked(debug)]
pub(super) struct Item<'db> {
    #[returns(copy)]
    pub file: Text,
    pub kind: ItemKind,
    pub name: String,
    pub more: Vec<String>,
    /// `true` if importers do not see it.
    #[returns(copy)]
    pub private: bool,
    /// Number of earlier items with the same kind and name. It makes the hashes of equal statements
    /// distinct; a generated text may have thousands of them.
    #[returns(copy)]
    pub number: u32,
    #[tracked]
    pub content: Content,
    /// Start in its file. An edit above changes only this field.
    #[tracked]
    #[returns(copy)]
    pub start: u32,
}

#[salsa::tracked]
pub(super) fn items(db: &dyn salsa::Database, text: Text) -> Vec<Item<'_>> {
    let mut alike: HashMap<(&ItemKind, &str), u32> = HashMap::default();
    let mut found = Vec::new();
    for part in parts(db, text).iter() {
        for split in part.splits.iter() {
            let next = alike.entry((&split.kind, &split.name)).or_default();
            let number = std::mem::replace(next, *next + 1);
            let (kind, name, more) = (split.kind.clone(), split.name.clone(), split.more.clone());
            let (content, start) = (Content(split.item.clone()), part.start + split.start);
            found.push(Item::new(db, text, kind, name, more, split.private, number, content, start));
        }
    }
    found
}

/// Properties that a file declares for itself.
#[derive(Clone, Debug, Default, PartialEq, salsa::SalsaValue)]
pub(super) struct Facts {
    /// The system of `units ...;`, if the file has it.
    pub system: Option<UnitSystem>,
    pub doc: String,
}

#[salsa::tracked]
pub(super) fn facts(db: &dyn salsa::Database, text: Text) -> Facts {
    let statements = || parts(db, text).iter().flat_map(|part| &part.piece.statements);
    let system = statements().find_map(|statement| match &statement.kind {
        // An unknown system is reported when statements are checked.
        StmtKind::Units(name) => UnitSystem::from_name(&name.name),
        _ => None,
    });
    Facts { system, doc: model_doc(tokens(db, text).file_doc.as_deref(), statements()) }
}

/// Returns the items of a file by the names they declare.
#[salsa::tracked]
pub(super) fn declared(db: &dyn salsa::Database, text: Text) -> HashMap<String, Vec<Item<'_>>> {
    let mut declared: HashMap<String, Vec<Item<'_>>> = HashMap::default();
    for &item in items(db, text) {
        for name in [item.name(db)].into_iter().chain(item.more(db)).filter(|name| !name.is_empty()) {
            declared.entry(name.clone()).or_default().push(item);
        }
    }
    declared
}

/// Names of the variables, params and outputs of a file's top level. They are collected once for a
/// file: a search among all items for each name takes quadratic time.
#[salsa::tracked]
pub(super) fn state_names(db: &dyn salsa::Database, text: Text) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for item in items(db, text).iter().filter(|item| *item.kind(db) == ItemKind::State) {
        let own = [item.name(db)].into_iter().chain(item.more(db));
        names.extend(own.filter(|name| !name.is_empty()).cloned());
    }
    names
}

/// Returns the items that functions and declarations can refer to, by name: the first one of each
/// name, without variables and statements.
#[salsa::tracked]
pub(super) fn nameable(db: &dyn salsa::Database, text: Text) -> HashMap<String, Item<'_>> {
    let mut nameable = HashMap::default();
    for &item in items(db, text) {
        if !matches!(item.kind(db), ItemKind::State | ItemKind::Other) {
            nameable.entry(item.name(db).clone()).or_insert(item);
        }
    }
    // A former name never hides a current one.
    for &item in items(db, text) {
        if !matches!(item.kind(db), ItemKind::State | ItemKind::Other) {
            for former in item.more(db) {
                nameable.entry(former.clone()).or_insert(item);
            }
        }
    }
    nameable.remove("");
    nameable
}

/// Returns the imports and declarations of a file in order, which matters for them.
#[salsa::tracked]
pub(super) fn declarations(db: &dyn salsa::Database, text: Text) -> Vec<Item<'_>> {
    let all = items(db, text).iter().copied();
    all.filter(|item| matches!(item.kind(db), ItemKind::Import(_) | ItemKind::Declaration)).collect()
}

/// Returns the dimensions and units that a file declares. Every check of an importing file depends
/// on them: a unit is used without its module, and is used for display even where the source does
/// not name it.
#[salsa::tracked]
pub(super) fn vocabulary(db: &dyn salsa::Database, text: Text) -> Vec<Item<'_>> {
    let measures = |item: &Item<'_>| {
        matches!(item.content(db).statement.kind, StmtKind::Dimension { .. } | StmtKind::Unit(_))
    };
    declarations(db, text).iter().copied().filter(measures).collect()
}

/// Returns the names of the base dimensions that a file declares.
#[salsa::tracked]
pub(super) fn bases(db: &dyn salsa::Database, text: Text) -> Vec<String> {
    let base = |item: &Item<'_>| match &item.content(db).statement.kind {
        StmtKind::Dimension { name, value: None } => Some(name.name.to_string()),
        _ => None,
    };
    vocabulary(db, text).iter().filter_map(base).collect()
}

/// Returns module and name of the base dimensions of all modules.
#[salsa::tracked]
pub(super) fn library_bases(db: &dyn salsa::Database, library: Library) -> Vec<(String, String)> {
    let files = [library.prelude(db)].into_iter().chain(library.modules(db).values().copied());
    let named = |file: Text| {
        let module = file.module(db).clone();
        bases(db, file).iter().map(move |name| (module.clone(), name.clone())).collect::<Vec<_>>()
    };
    files.flat_map(named).collect()
}

/// Returns the file of a module.
#[salsa::tracked]
pub(super) fn module(db: &dyn salsa::Database, library: Library, path: String) -> Option<Text> {
    library.modules(db).get(&path).copied()
}

/// Returns the files that a file imports, directly or indirectly, in order of discovery.
#[salsa::tracked]
pub(super) fn reachable(db: &dyn salsa::Database, text: Text, library: Library) -> Vec<Text> {
    let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
    let mut at = text;
    let mut next = 0;
    loop {
        for item in declarations(db, at) {
            if let ItemKind::Import(path) = item.kind(db)
                && seen.insert(path.clone())
                && let Some(file) = module(db, library, path.clone())
            {
                found.push(*file);
            }
        }
        let Some(&file) = found.get(next) else { return found };
        (at, next) = (file, next + 1);
    }
}

/// Returns the names of handle types in a file's declarations of engine functions.
#[salsa::tracked]
pub(super) fn own_handles(db: &dyn salsa::Database, text: Text) -> BTreeSet<String> {
    let externs = items(db, text).iter().filter(|item| *item.kind(db) == ItemKind::Extern);
    let decls = externs.filter_map(|item| match &item.content(db).statement.kind {
        StmtKind::Function(decl) => Some(handles_of(decl)),
        _ => None,
    });
    // Records and dimensions also have capitalized names.
    let known = declared(db, text);
    let other = |name: &String| {
        known.get(name).is_some_and(|all| all.iter().any(|item| *item.kind(db) == ItemKind::Declaration))
    };
    decls.flatten().filter(|name| !other(name)).collect()
}

/// Returns the functions of a file that declare the names of handles, by handle type.
#[salsa::tracked]
pub(super) fn namings(db: &dyn salsa::Database, text: Text) -> HashMap<String, Item<'_>> {
    let mut found = HashMap::default();
    for &item in items(db, text).iter().filter(|item| *item.kind(db) == ItemKind::Extern) {
        if let StmtKind::Function(decl) = &item.content(db).statement.kind
            && let Some(handle) = named_type(decl)
        {
            found.entry(handle.to_owned()).or_insert(item);
        }
    }
    found
}

/// Returns the handle types that a file may use.
#[salsa::tracked]
pub(super) fn handles(db: &dyn salsa::Database, text: Text, library: Library) -> BTreeSet<String> {
    let imported = reachable(db, text, library).iter().copied();
    let files = [text, library.prelude(db)].into_iter().chain(imported);
    files.flat_map(|file| own_handles(db, file).iter().cloned()).collect()
}
