//! Excerpts: small programs of the items that one check needs.
//!
//! A check unit is checked in a program that consists of its own items, the declarations they use,
//! and the headers of the functions they call. Names, types and diagnostics work as in any program.
//! Source locations refer to the texts of the excerpt; its layout maps them to items.

use super::ModuleData;
use super::item::Item;
use crate::ast::Module;
use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::relocate;
use crate::span::{FileId, Span};
use crate::units::UnitSystem;

/// Identifies an item, across excerpts and edits.
pub type ItemId = u64;

/// Identifies a record: its item, and the offset of the record's name in the item.
pub type RecordKey = (ItemId, u32);

/// The role of an item in an excerpt.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// The item is checked.
    Own,
    /// The item is needed in full.
    Whole,
    /// The item is a function of which only the header is needed.
    Header,
}

/// A module of an excerpt and its items, in order.
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

/// The positions of the items.
#[derive(Debug, Default)]
pub struct Layout {
    /// Items by file of the excerpt, in order of position.
    files: Vec<Vec<Segment>>,
    starts: HashMap<ItemId, (FileId, u32)>,
    /// Module and name of every base dimension of the program, so that all checks number them
    /// equally.
    pub bases: Vec<(String, String)>,
}

impl Layout {
    /// Returns the segment that contains a location.
    pub fn segment(&self, file: FileId, at: u32) -> Option<&Segment> {
        let segments = self.files.get(file.0 as usize)?;
        segments.get(segments.partition_point(|segment| segment.start <= at).checked_sub(1)?)
    }

    /// Returns the item that contains a location, and the offset in the item.
    pub fn locate(&self, span: Span) -> Option<(ItemId, u32)> {
        let segment = self.segment(span.file, span.start)?;
        Some((segment.item, span.start - segment.start))
    }

    /// Returns the start of an item.
    pub fn start(&self, item: ItemId) -> Option<(FileId, u32)> {
        self.starts.get(&item).copied()
    }

    /// Returns `true` if a location belongs to an item that is checked.
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
    /// Builds an excerpt. The model is the first file, the prelude the second.
    pub fn new(extracts: Vec<Extract<'_>>) -> Excerpt {
        let mut excerpt = Excerpt { modules: Vec::new(), layout: Layout::default() };
        for (index, extract) in extracts.into_iter().enumerate() {
            let (file, count) = (FileId(index as u32), extract.items.len());
            let (mut text, mut statements, mut segments) =
                (String::new(), Vec::with_capacity(count), Vec::with_capacity(count));
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

/// Maps locations in an excerpt to locations in files.
pub struct Places<'l> {
    layout: &'l Layout,
    /// For each segment, the file and the start of its item.
    starts: Vec<Vec<(FileId, u32)>>,
}

impl<'l> Places<'l> {
    /// Creates the map. `items` has the start of each item.
    pub fn new(layout: &'l Layout, items: &HashMap<ItemId, (FileId, u32)>) -> Self {
        let start = |segment: &Segment| items.get(&segment.item).copied().unwrap_or_default();
        let starts = layout.files.iter().map(|segments| segments.iter().map(start).collect());
        Places { layout, starts: starts.collect() }
    }

    pub fn span(&self, span: Span) -> Span {
        // The default span belongs to no text.
        if span == Span::default() {
            return span;
        }
        let (file, start) = self.position(span.file, span.start);
        // The end of an item must not be mistaken for the start of the next.
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
