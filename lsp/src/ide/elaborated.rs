//! What elaboration has last said of a model, carried over to the text as it is now.
//!
//! A model is elaborated in the background, on a text that may have changed since. What was said of places that no change has
//! touched still holds, and is found where those places are now.

use calyx_elaborate::{CreatedAt, Elaboration, GearGeometry, MeshGeometry};
use calyx_lang::analysis::SourceRange;
use calyx_lang::check::Checked;
use calyx_lang::db::Database;
use calyx_lang::diagnostic::{Diagnostic, Fix};
use calyx_lang::ir::{Program, SourceFile};
use calyx_lang::span::{FileId, Span};
use std::sync::Arc;

/// An elaboration and the texts it was made from.
#[derive(Debug)]
pub struct Elaborated {
    pub elaboration: Elaboration,
    of: Arc<Checked>,
}

/// Bytes `start..end` have become `by` others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Change {
    start: u32,
    end: u32,
    by: u32,
}

impl Change {
    /// The smallest change that makes one text of another.
    fn between(before: &str, after: &str) -> Change {
        let (old, new) = (before.as_bytes(), after.as_bytes());
        let start = old.iter().zip(new).take_while(|(a, b)| a == b).count();
        let (old, new) = (&old[start..], &new[start..]);
        let same = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
        Change { start: start as u32, end: (start + old.len() - same) as u32, by: (new.len() - same) as u32 }
    }

    /// The opposite change.
    fn undone(self) -> Change {
        Change { start: self.start, end: self.start + self.by, by: self.end - self.start }
    }

    /// Where bytes are after the change; `None` if it touched them.
    fn moved(self, start: u32, end: u32) -> Option<(u32, u32)> {
        let Change { start: from, end: to, by } = self;
        if from == to && by == 0 || end < from {
            return Some((start, end));
        }
        (start > to).then(|| (start - to + from + by, end - to + from + by))
    }
}

impl Elaborated {
    pub fn new(checked: &Arc<Checked>, elaboration: Elaboration) -> Elaborated {
        Elaborated { elaboration, of: checked.clone() }
    }

    /// Whether it was made from just this program.
    pub fn is_of(&self, checked: &Arc<Checked>) -> bool {
        Arc::ptr_eq(&self.of, checked)
    }

    /// Whether the texts are still those it was made from.
    pub fn is_current(&self, database: &Database) -> bool {
        self.files().iter().all(|file| database.text(&file.name) == Some(&*file.text))
    }

    /// The program it was made from.
    pub fn program(&self) -> Option<&Program> {
        self.of.program.as_ref()
    }

    /// The files it was made from; places in [`Elaborated::found`] refer to them.
    pub fn files(&self) -> &[SourceFile] {
        &self.of.files
    }

    /// What was found, where it is now. What an edit has touched is left out, and labels and fixes that it has touched.
    pub fn found(&self, database: &Database) -> Vec<Diagnostic> {
        let changes: Vec<Option<Change>> = self.files().iter().map(|file| change(file, database)).collect();
        let moved = |span: Span| -> Option<Span> {
            let change = (*changes.get(span.file.0 as usize)?)?;
            let (start, end) = change.moved(span.start, span.end)?;
            Some(Span { start, end, ..span })
        };
        let carried = self.elaboration.found.iter().filter_map(|found| {
            let mut found = found.clone();
            found.primary.span = moved(found.primary.span)?;
            found.labels.retain_mut(|label| moved(label.span).map(|span| label.span = span).is_some());
            found.suggestions.retain_mut(|fix| moved(fix.span).map(|span| fix.span = span).is_some());
            found.fix = found.fix.and_then(|fix| Some(Fix { span: moved(fix.span)?, ..fix }));
            Some(found)
        });
        carried.collect()
    }

    /// The place in the texts it was made from that is now at an offset of a file.
    pub fn before(&self, database: &Database, file: &str, offset: u32) -> Option<(FileId, u32)> {
        let index = self.files().iter().position(|known| known.name == file)?;
        let change = change(self.files().get(index)?, database)?.undone();
        let (start, _) = change.moved(offset, offset)?;
        Some((FileId(index as u32), start))
    }

    /// The gear that the call around an offset of a file makes.
    pub fn gear_at(&self, database: &Database, file: &str, offset: u32) -> Option<&CreatedAt<GearGeometry>> {
        let (file, offset) = self.before(database, file, offset)?;
        self.elaboration.geometry.gear_at(file.0, offset)
    }

    /// The mesh that the call around an offset of a file makes.
    pub fn mesh_at(&self, database: &Database, file: &str, offset: u32) -> Option<&CreatedAt<MeshGeometry>> {
        let (file, offset) = self.before(database, file, offset)?;
        self.elaboration.geometry.mesh_at(file.0, offset)
    }

    /// Where a place in the texts it was made from is now.
    pub fn now(&self, database: &Database, span: Span) -> Option<SourceRange> {
        let file = self.files().get(span.file.0 as usize)?;
        let (start, end) = change(file, database)?.moved(span.start, span.end)?;
        Some(SourceRange { file: file.name.as_str().into(), start, end })
    }
}

/// What has become of a file's text; `None` if there is no such file any more.
fn change(file: &SourceFile, database: &Database) -> Option<Change> {
    Some(Change::between(&file.text, database.text(&file.name)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_followed_there_and_back() {
        let change = Change::between("one two three", "one 2 and a half three");
        assert_eq!(change, Change { start: 4, end: 7, by: 12 });
        assert_eq!(change.moved(0, 3), Some((0, 3)));
        assert_eq!(change.moved(8, 13), Some((17, 22)));
        assert_eq!(change.undone().moved(17, 22), Some((8, 13)));
        assert_eq!(change.moved(4, 6), None);
        assert_eq!(change.moved(0, 4), None);
        assert_eq!(Change::between("aa", "aaa"), Change { start: 2, end: 2, by: 1 });
        assert_eq!(Change::between("same", "same").moved(0, 4), Some((0, 4)));
    }
}
