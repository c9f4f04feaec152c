//! Queries for editors: the meaning of names and the types of expressions.
//!
//! Meanings are computed by item, with locations relative to its start, and cached until the unit
//! of the item is checked again.

use super::groups::group_of;
use super::items::{Item, Part, facts, items, module, parse, parts, tokens};
use super::units::{check_group, check_top, dependents, id};
use super::{Database, Library, Parsed, Text};
use crate::analysis::*;
use crate::ast::{Bind, FunctionBody, StmtKind};
use crate::check::excerpt::ItemId;
use crate::check::item::ItemKind;
use crate::check::name_resolution::Declared as Target;
use crate::check::unit::Unit;
use crate::check::{ShownScheme, builtins, declared_names, expressions};
use crate::declared::{self, Declared};
use crate::deep_recursion::with_deep_stack;
use crate::hashed::HashMap;
use crate::lexer::Tokens;
use crate::parser::{self, chunks::PlacedChunk};
use crate::relocate;
use crate::span::{FileId, Span};
use crate::units::UnitSystem;
use salsa::Id;
use salsa::plumbing::FromId;
use std::ops::Range;
use std::sync::Arc;

/// A name in an item, with locations relative to their items.
#[derive(Debug)]
pub(super) struct Relative {
    pub start: u32,
    pub end: u32,
    pub text: Arc<str>,
    pub kind: NameKind,
    pub target: RelativeTarget,
    pub ty: Option<Arc<str>>,
    written: bool,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RelativeTarget {
    Nowhere,
    In(ItemId, u32, u32),
    Module(Text),
}

/// Returns the check unit of an item.
pub(super) fn unit_of<'db>(
    db: &'db dyn salsa::Database,
    item: Item<'db>,
    library: Library,
) -> Option<&'db Unit> {
    let file = item.file(db);
    let alone = match item.kind(db) {
        ItemKind::Extern => true,
        ItemKind::Function => !dependents(db, file, library).contains(&item),
        _ => false,
    };
    match alone {
        true => check_group(db, group_of(db, item, library), library).unit.as_ref(),
        false => Some(check_top(db, file, library)),
    }
}

/// Returns the scheme of a function item.
fn scheme<'db>(db: &'db dyn salsa::Database, item: Item<'db>, library: Library) -> Option<&'db ShownScheme> {
    let unit = unit_of(db, item, library)?;
    unit.meanings.scheme(*unit.functions.get(&id(item))?)
}

/// Returns the names in an item.
#[salsa::tracked(no_eq)]
pub(super) fn relative_names<'db>(
    db: &'db dyn salsa::Database,
    item: Item<'db>,
    library: Library,
) -> Arc<Vec<Relative>> {
    let Some(unit) = unit_of(db, item, library) else { return Arc::default() };
    let Some((file, start)) = unit.layout.start(id(item)) else { return Arc::default() };
    let content = item.content(db);
    let mut found: Vec<Relative> = Vec::new();
    // Many names refer to few declarations.
    let mut types: HashMap<RelativePlace, Option<Arc<str>>> = HashMap::default();
    let mut statement = content.statement.clone();
    relocate::to(&mut statement, file, start);
    relocate::statement(&mut statement, &mut |span, text| {
        let Some(text) = text else { return };
        let Some(meaning) = unit.meanings.at(&unit.typed, *span) else { return };
        let target = match &meaning.declared {
            Target::Nowhere => RelativeTarget::Nowhere,
            Target::Module(path) => match module(db, library, path.clone()) {
                Some(file) => RelativeTarget::Module(*file),
                None => return,
            },
            Target::Member(component, member) => {
                let item = unit.layout.locate(*component).map(|(item, _)| item);
                let at = item.and_then(|item| member_span(db, item, member));
                match item.zip(at) {
                    Some((item, at)) => RelativeTarget::In(item, at.start, at.end),
                    None => return,
                }
            }
            Target::At(at) => match unit.layout.locate(*at) {
                Some((to, from)) => RelativeTarget::In(to, from, from + at.end.saturating_sub(at.start)),
                None => return,
            },
        };
        let ty = match target {
            RelativeTarget::In(to, from, _) => types
                .entry((to, from))
                .or_insert_with(|| {
                    let to = item_of(to);
                    let elsewhere = || match (meaning.kind, to.kind(db)) {
                        (NameKind::Extern, _) => extern_scheme(db, to).map(|shown| shown.to_string()),
                        (_, ItemKind::Function) => scheme(db, to, library).map(ShownScheme::to_string),
                        _ => None,
                    };
                    meaning.ty.clone().or_else(elsewhere).map(Arc::from)
                })
                .clone(),
            _ => meaning.ty.or_else(|| builtins::shown(text)).map(Arc::from),
        };
        found.push(Relative {
            start: span.start.saturating_sub(start),
            end: span.end.saturating_sub(start),
            text: text.as_str().into(),
            kind: meaning.kind,
            target,
            ty,
            written: meaning.written,
        });
    });
    found.sort_by_key(|name| name.start);
    Arc::new(found)
}

/// Returns the location of a member in the item of its component.
fn member_span(db: &dyn salsa::Database, component: ItemId, member: &str) -> Option<Span> {
    let content = item_of(component).content(db);
    let StmtKind::Function(decl) = &content.statement.kind else { return None };
    let parameters = decl.parameters.iter().map(|parameter| &parameter.name);
    let declared = match &decl.body {
        FunctionBody::Statement(body) => match &body.kind {
            StmtKind::Block(statements) => statements.as_slice(),
            _ => &[],
        },
        _ => &[],
    };
    let mut names = parameters.chain(declared.iter().flat_map(declared_names));
    names.find(|name| name.name == member).map(|name| name.span)
}

type RelativePlace = (ItemId, u32);

/// Returns the item with an id of the current revision.
fn item_of<'db>(id: ItemId) -> Item<'db> {
    Item::from_id(Id::from_bits(id))
}

/// Returns the declared types of an engine function.
pub(super) fn extern_scheme(db: &dyn salsa::Database, item: Item<'_>) -> Option<ShownScheme> {
    let content = item.content(db);
    let StmtKind::Function(decl) = &content.statement.kind else { return None };
    let text =
        |span: Span| content.text.get(span.start as usize..span.end as usize).unwrap_or("_").to_string();
    let parameters = decl.parameters.iter().map(|parameter| {
        let ty = parameter.annotation.as_ref().map_or_else(|| "_".into(), |annotation| text(annotation.span));
        (parameter.mode, parameter.name.name.to_string(), ty)
    });
    Some(ShownScheme {
        name: decl.name.name.to_string(),
        is_component: false,
        parameters: parameters.collect(),
        result: decl.result.as_ref().map(|result| text(result.span)),
        demands: Vec::new(),
    })
}

/// An item in the excerpt of its unit.
#[derive(Clone, Copy)]
struct Excerpted {
    /// File of the excerpt.
    file: FileId,
    base: u32,
    /// Start in its own file.
    start: u32,
    length: u32,
}

/// Returns the expressions in some items of a unit that overlap a range of their file.
fn expressions_of(unit: &Unit, parts: &[Excerpted], range: &Range<u32>) -> Vec<Typed> {
    let mut parts = parts.to_vec();
    parts.sort_by_key(|part| part.base);
    let (Some(first), Some(last)) = (parts.first(), parts.last()) else { return Vec::new() };
    let wanted = Span { file: first.file, start: first.base, end: last.base + last.length };
    let mut found = expressions::touching(&unit.typed, wanted);
    found.retain_mut(|typed| {
        let Some(at) = parts.partition_point(|part| part.base <= typed.start).checked_sub(1) else {
            return false;
        };
        let part = parts[at];
        let inside = typed.end <= part.base + part.length;
        typed.start = typed.start - part.base + part.start;
        typed.end = (typed.end + part.start).saturating_sub(part.base);
        inside && typed.start <= range.end && range.start <= typed.end
    });
    found
}

impl Database {
    pub(super) fn find(&self, file: &str) -> Option<Text> {
        let db = &self.salsa;
        let modules = || self.library.modules(db).values().copied().chain([self.library.prelude(db)]);
        self.models.get(file).copied().or_else(|| modules().find(|text| **text.name(db) == *file))
    }

    /// Returns the names of the models, in order.
    pub fn models(&self) -> impl Iterator<Item = &str> {
        self.models.keys().map(String::as_str)
    }

    /// Returns all files: models, modules, and the prelude.
    pub fn files(&self) -> Vec<Arc<str>> {
        let db = &self.salsa;
        let modules =
            self.library.modules(db).values().chain([&self.library.prelude(db)]).copied().collect::<Vec<_>>();
        let modules = modules.into_iter().map(|text| text.name(db).clone());
        self.models().map(Arc::from).chain(modules).collect()
    }

    /// Returns the files that a file imports, directly or indirectly.
    pub fn imported(&self, file: &str) -> Vec<Arc<str>> {
        let db = &self.salsa;
        let Some(text) = self.find(file) else { return Vec::new() };
        let all = super::items::reachable(db, text, self.library).iter();
        all.map(|text| text.name(db).clone()).collect()
    }

    /// Returns the dotted path of a module's file; `None` for a model.
    pub fn module_of(&self, file: &str) -> Option<String> {
        let path = self.find(file)?.module(&self.salsa).clone();
        (!path.is_empty()).then_some(path)
    }

    /// Returns the file of a module, by its dotted path.
    pub fn file_of(&self, module: &str) -> Option<Arc<str>> {
        let db = &self.salsa;
        self.library.modules(db).get(module).map(|text| text.name(db).clone())
    }

    /// Returns the modules that can be imported, by their dotted paths.
    pub fn modules(&self) -> Vec<String> {
        let db = &self.salsa;
        let mut all: Vec<String> = self.library.known(db).clone();
        all.extend(self.library.modules(db).keys().cloned());
        all.sort();
        all.dedup();
        all
    }

    /// Returns the text of a file.
    pub fn text(&self, file: &str) -> Option<&str> {
        Some(self.find(file)?.content(&self.salsa))
    }

    /// Returns the tokens of a file; locations have file 0.
    pub fn tokens(&self, file: &str) -> Option<Arc<Tokens>> {
        Some(tokens(&self.salsa, self.find(file)?).clone())
    }

    /// Returns the tree of a file; locations have file 0.
    pub fn tree(&self, file: &str) -> Option<Arc<Parsed>> {
        let text = self.find(file)?;
        Some(with_deep_stack(|| parse(&self.salsa, text).clone()))
    }

    /// Returns the names in a file that have a meaning, in order.
    pub fn names(&self, file: &str) -> Vec<Name> {
        let Some(text) = self.find(file) else { return Vec::new() };
        with_deep_stack(|| {
            let each = items(&self.salsa, text).iter();
            each.flat_map(|item| self.names_of(*item)).collect()
        })
    }

    /// Returns the names in the top-level statements that overlap a range, in order.
    pub fn names_in(&self, file: &str, range: Range<u32>) -> Vec<Name> {
        let Some(text) = self.find(file) else { return Vec::new() };
        with_deep_stack(|| {
            let touched = self.items_in(text, range);
            touched.into_iter().flat_map(|item| self.names_of(item)).collect()
        })
    }

    /// Returns the name that contains an offset or ends there.
    pub fn name_at(&self, file: &str, offset: u32) -> Option<Name> {
        let text = self.find(file)?;
        with_deep_stack(|| {
            // The later of two adjacent names.
            self.items_in(text, offset..offset).into_iter().rev().find_map(|item| self.name_in(item, offset))
        })
    }

    fn name_in(&self, item: Item<'_>, offset: u32) -> Option<Name> {
        let at = offset.checked_sub(item.start(&self.salsa))?;
        let names = relative_names(&self.salsa, item, self.library);
        let name = names.get(names.partition_point(|name| name.start <= at).checked_sub(1)?)?;
        (at <= name.end).then(|| self.placed(item, name))
    }

    /// Returns the items of a file that overlap a range.
    pub(super) fn items_in(&self, text: Text, range: Range<u32>) -> Vec<Item<'_>> {
        let db = &self.salsa;
        let all = items(db, text);
        // Items do not overlap, so their ends are ordered like their starts.
        let end = |item: &Item<'_>| item.start(db) + item.content(db).text.len() as u32;
        let first = all.partition_point(|item| end(item) < range.start);
        all.iter().skip(first).copied().take_while(|item| item.start(db) <= range.end).collect()
    }

    pub(super) fn names_of(&self, item: Item<'_>) -> Vec<Name> {
        let names = relative_names(&self.salsa, item, self.library);
        names.iter().map(|name| self.placed(item, name)).collect()
    }

    /// Converts a name of an item to its file.
    fn placed(&self, item: Item<'_>, name: &Relative) -> Name {
        let db = &self.salsa;
        let start = item.start(db);
        let declared = match name.target {
            RelativeTarget::Nowhere => None,
            RelativeTarget::Module(text) => {
                Some(SourceRange { file: text.name(db).clone(), start: 0, end: 0 })
            }
            RelativeTarget::In(to, from, end) => {
                let to = item_of(to);
                let base = to.start(db);
                Some(SourceRange { file: to.file(db).name(db).clone(), start: base + from, end: base + end })
            }
        };
        Name {
            start: start + name.start,
            end: start + name.end,
            text: name.text.clone(),
            kind: name.kind,
            declared,
            ty: name.ty.clone(),
            declares: name.target == RelativeTarget::In(id(item), name.start, name.end),
            writes: name.written,
        }
    }

    /// Returns every name of the declaration at a location, including the declaration, by file.
    pub fn references(&self, place: &SourceRange) -> Vec<(Arc<str>, Name)> {
        let db = &self.salsa;
        let Some(target) = self.find(&place.file) else { return Vec::new() };
        let name = match place.end {
            0 => target.module(db).rsplit('.').next().unwrap_or_default(),
            _ => self
                .text(&place.file)
                .and_then(|t| t.get(place.start as usize..place.end as usize))
                .unwrap_or(""),
        };
        let former = self.former_name(place);
        let mut found = Vec::new();
        with_deep_stack(|| {
            for file in self.files() {
                let Some(text) = self.find(&file) else { continue };
                for &item in items(db, text) {
                    let names = &item.content(db).names;
                    if names.contains(name)
                        || former.as_ref().is_some_and(|former| names.contains(former.as_str()))
                    {
                        let names = self.names_of(item).into_iter();
                        let meant = names.filter(|name| name.declared.as_ref() == Some(place));
                        found.extend(meant.map(|name| (file.clone(), name)));
                    }
                }
            }
        });
        found
    }

    /// Returns the typed expressions that overlap a range, by start, outer before inner.
    pub fn expressions(&self, file: &str, range: Range<u32>) -> Vec<Typed> {
        let Some(text) = self.find(file) else { return Vec::new() };
        let mut found = with_deep_stack(|| {
            let units = self.excerpts(text, range.clone()).into_values();
            units.flat_map(|(unit, parts)| expressions_of(unit, &parts, &range)).collect::<Vec<_>>()
        });
        found.sort_by_key(|typed| (typed.start, u32::MAX - typed.end));
        found.dedup_by(|b, a| (a.start, a.end) == (b.start, b.end));
        found
    }

    /// Returns the units of the items in a range, each once.
    fn excerpts(
        &self,
        text: Text,
        range: Range<u32>,
    ) -> HashMap<(*const Unit, FileId), (&Unit, Vec<Excerpted>)> {
        let db = &self.salsa;
        let mut units: HashMap<_, (&Unit, Vec<Excerpted>)> = HashMap::default();
        for item in self.items_in(text, range) {
            let Some(unit) = unit_of(db, item, self.library) else { continue };
            let Some((file, base)) = unit.layout.start(id(item)) else { continue };
            let part =
                Excerpted { file, base, start: item.start(db), length: item.content(db).text.len() as u32 };
            units.entry((std::ptr::from_ref(unit), file)).or_insert((unit, Vec::new())).1.push(part);
        }
        units
    }

    /// Returns the smallest expression that contains an offset.
    pub fn expression_at(&self, file: &str, offset: u32) -> Option<Typed> {
        let around = self.expressions(file, offset..offset).into_iter();
        let around = around.filter(|typed| typed.start <= offset && offset <= typed.end);
        around.min_by_key(|typed| (typed.end - typed.start, u32::MAX - typed.start))
    }

    /// Returns the part of a file that contains an offset.
    pub(super) fn part_at(&self, file: &str, offset: u32) -> Option<&Part> {
        let text = self.find(file)?;
        let all = with_deep_stack(|| parts(&self.salsa, text));
        all.get(all.partition_point(|part| part.start <= offset).checked_sub(1)?)
    }

    /// Returns the top-level statement around an offset, as a tree with locations in the file.
    /// After an edit, this is much faster than the tree of the whole file.
    pub fn around(&self, file: &str, offset: u32) -> Option<Arc<Parsed>> {
        let part = self.part_at(file, offset)?;
        let start = part.start as usize;
        let placed = PlacedChunk { range: start..start, piece: part.piece.clone() };
        let (module, diagnostics) = parser::assemble(FileId(0), &Tokens::default(), &[placed]);
        Some(Arc::new(Parsed { module, diagnostics }))
    }

    /// Returns the unit system that a file declares.
    pub fn system(&self, file: &str) -> Option<UnitSystem> {
        facts(&self.salsa, self.find(file)?).system
    }

    /// Returns the text of a declaration. `place` is the location of its name.
    pub fn declaration(&self, place: &SourceRange) -> Option<Declaration> {
        let part = self.part_at(&place.file, place.start)?;
        let text = self.text(&place.file)?.get(part.start as usize..)?;
        let (item, found) = declared::find_in(&part.piece.statements, place.start - part.start)?;
        let name = self.name_at(&place.file, place.start).filter(|name| name.start == place.start);
        let kind = match (&name, found) {
            (Some(name), _) => name.kind,
            (None, found) => written_kind(found),
        };
        let of = match found {
            Declared::Statement(statement) => statement.span,
            _ => item.span,
        };
        let doc = match (kind, declared::doc(found)) {
            (NameKind::Module, _) => None,
            (_, doc) => doc.map(str::to_string),
        };
        Some(Declaration {
            kind,
            name: text
                .get((place.start - part.start) as usize..(place.end.checked_sub(part.start)?) as usize)?
                .into(),
            former: declared::former(found).map(|former| former.name.as_str().into()),
            header: declared::header(found, text),
            doc,
            ty: name.and_then(|name| name.ty),
            item: SourceRange {
                file: place.file.clone(),
                start: of.start + part.start,
                end: of.end + part.start,
            },
        })
    }

    /// Returns the documentation of a module.
    pub fn module_doc(&self, file: &str) -> Option<String> {
        self.tree(file)?.module.doc.clone()
    }

    /// Returns the parameters and the result of a built-in function.
    pub fn builtin(&self, name: &str) -> Option<Callable> {
        builtins::callable(name)
    }
}

/// Returns the kind of a declaration, by its syntax alone.
fn written_kind(found: Declared<'_>) -> NameKind {
    match found {
        Declared::Variable(_, decl) => match decl.init {
            Some((Bind::Symbolic, _)) => NameKind::Symbolic,
            _ => NameKind::Variable,
        },
        Declared::Parameter(..) => NameKind::Parameter,
        Declared::Field(..) => NameKind::Field,
        Declared::Choice(..) => NameKind::Const,
        Declared::Caught(_) | Declared::Element(..) => NameKind::Variable,
        Declared::Statement(statement) => match &statement.kind {
            StmtKind::Function(decl) => match decl.body {
                FunctionBody::Statement(_) if decl.is_component => NameKind::Component,
                FunctionBody::Statement(_) => NameKind::Function,
                FunctionBody::Symbolic(_) => NameKind::SymbolicFunction,
                FunctionBody::Extern { .. } => NameKind::Extern,
            },
            StmtKind::Record(_) => NameKind::Record,
            StmtKind::Enum(_) => NameKind::Enum,
            StmtKind::Param(_) => NameKind::Param,
            StmtKind::Output { .. } => NameKind::Output,
            StmtKind::Const { .. } => NameKind::Const,
            StmtKind::Dimension { .. } => NameKind::Dimension,
            StmtKind::Unit(_) => NameKind::Unit,
            _ => NameKind::Module,
        },
    }
}
