//! Excerpts: a program of just the items that one check needs.
//!
//! A unit of checking is checked in a small program made of its own items, the declarations they name, and the headers
//! of the functions they call. Names, types and diagnostics then work as in any program. Places lie in an excerpt's
//! own texts; its layout tells which item each belongs to.

use super::ModuleData;
use super::item::Item;
use crate::ast::Module;
use crate::diagnostic::Diagnostic;
use crate::relocate;
use crate::span::{FileId, Span};
use crate::units::UnitSystem;
use std::collections::HashMap;

/// Tells items apart, across excerpts and edits.
pub type ItemId = u64;

/// Tells records apart: the item, and where in it the record's name stands.
pub type RecordKey = (ItemId, u32);

/// How an item takes part in an excerpt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// It is what is checked.
    Own,
    /// It is needed in full.
    Whole,
    /// It is what callers see of a function.
    Header,
}

/// A module of an excerpt and its items in order.
pub struct Extract<'i> {
    pub name: String,
    pub system: Option<UnitSystem>,
    pub items: Vec<(ItemId, &'i Item, Part)>,
}

#[derive(Debug)]
pub struct Segment {
    start: u32,
    pub item: ItemId,
    pub part: Part,
}

/// Which item lies where.
#[derive(Debug, Default)]
pub struct Layout {
    /// By file of the excerpt, in order of place.
    files: Vec<Vec<Segment>>,
    starts: HashMap<ItemId, (FileId, u32)>,
    /// Module and name of every base dimension that the program declares, so that all checks number them alike.
    pub bases: Vec<(String, String)>,
}

impl Layout {
    /// The item a place belongs to.
    pub fn segment(&self, file: FileId, at: u32) -> Option<&Segment> {
        let segments = self.files.get(file.0 as usize)?;
        segments.get(segments.partition_point(|segment| segment.start <= at).checked_sub(1)?)
    }

    /// The item a place belongs to, and where it lies in that.
    pub fn locate(&self, span: Span) -> Option<(ItemId, u32)> {
        let segment = self.segment(span.file, span.start)?;
        Some((segment.item, span.start - segment.start))
    }

    /// Where an item starts.
    pub fn start(&self, item: ItemId) -> Option<(FileId, u32)> {
        self.starts.get(&item).copied()
    }

    /// Whether a place belongs to what is checked.
    pub fn is_own(&self, span: Span) -> bool {
        self.segment(span.file, span.start).is_some_and(|segment| segment.part == Part::Own)
    }
}

/// A program of some items.
pub struct Excerpt {
    pub modules: Vec<ModuleData>,
    pub layout: Layout,
}

impl Excerpt {
    /// The model first, the prelude second.
    pub fn new(extracts: Vec<Extract<'_>>) -> Excerpt {
        let mut excerpt = Excerpt { modules: Vec::new(), layout: Layout::default() };
        for (index, extract) in extracts.into_iter().enumerate() {
            let file = FileId(index as u32);
            let (mut text, mut statements, mut segments) = (String::new(), Vec::new(), Vec::new());
            for (id, item, part) in extract.items {
                let start = text.len() as u32;
                let mut statement = item.statement.clone();
                relocate::to(&mut statement, file, start);
                statements.push(statement);
                segments.push(Segment { start, item: id, part });
                excerpt.layout.starts.insert(id, (file, start));
                text.push_str(&item.text);
                text.push('\n');
            }
            excerpt.layout.files.push(segments);
            excerpt.modules.push(ModuleData {
                name: extract.name,
                file,
                text,
                tree: Module { statements, doc: None },
                system: extract.system,
            });
        }
        excerpt
    }
}

/// From places in an excerpt to places in files.
pub struct Places<'l> {
    layout: &'l Layout,
    /// File and start of the item of each segment.
    starts: Vec<Vec<(FileId, u32)>>,
}

impl<'l> Places<'l> {
    /// `items` tells where each item starts.
    pub fn new(layout: &'l Layout, items: &HashMap<ItemId, (FileId, u32)>) -> Self {
        let start = |segment: &Segment| items.get(&segment.item).copied().unwrap_or_default();
        let starts = layout.files.iter().map(|segments| segments.iter().map(start).collect());
        Places { layout, starts: starts.collect() }
    }

    pub fn span(&self, span: Span) -> Span {
        // Belongs to no text.
        if span == Span::default() {
            return span;
        }
        let (file, start) = self.position(span.file, span.start);
        // The end of an item is not the start of the next.
        let (end_file, end) = match span.end.checked_sub(1) {
            Some(last) if span.end > span.start => self.position(span.file, last),
            _ => (file, start.saturating_sub(1)),
        };
        let end = end.saturating_add(1);
        if end_file == file {
            Span { file, start, end: end.max(start) }
        } else {
            Span { file, start, end: start }
        }
    }

    fn position(&self, file: FileId, at: u32) -> (FileId, u32) {
        let found = || {
            let segments = self.layout.files.get(file.0 as usize)?;
            let index = segments.partition_point(|segment| segment.start <= at).checked_sub(1)?;
            let (to, start) = *self.starts.get(file.0 as usize)?.get(index)?;
            Some((to, start + (at - segments[index].start)))
        };
        found().unwrap_or_default()
    }

    pub fn diagnostic(&self, diagnostic: &Diagnostic) -> Diagnostic {
        let mut placed = diagnostic.clone();
        placed.primary.span = self.span(placed.primary.span);
        for label in &mut placed.labels {
            label.span = self.span(label.span);
        }
        for fix in placed.fix.iter_mut().chain(&mut placed.suggestions) {
            fix.span = self.span(fix.span);
        }
        placed
    }
}
