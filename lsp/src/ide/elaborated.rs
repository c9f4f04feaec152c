//! Result of the last elaboration of a model, mapped to the current text.
//!
//! A model is elaborated in the background, and its text may have changed since. Results at
//! positions that no change has touched remain valid, and are moved to their current positions.

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

/// Replacement of bytes `start..end` by `by` others.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Change {
    start: u32,
    end: u32,
    by: u32,
}

impl Change {
    /// Returns the smallest change between two texts.
    fn between(before: &str, after: &str) -> Change {
        let (old, new) = (before.as_bytes(), after.as_bytes());
        let start = old.iter().zip(new).take_while(|(a, b)| a == b).count();
        let (old, new) = (&old[start..], &new[start..]);
        let same = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
        Change { start: start as u32, end: (start + old.len() - same) as u32, by: (new.len() - same) as u32 }
    }

    /// Returns the inverse change.
    fn undone(self) -> Change {
        Change { start: self.start, end: self.start + self.by, by: self.end - self.start }
    }

    /// Returns a range after the change; `None` if the change touches it.
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

    /// Returns true if it was made from this program (compared by identity).
    pub fn is_of(&self, checked: &Arc<Checked>) -> bool {
        Arc::ptr_eq(&self.of, checked)
    }

    /// Returns true if the texts have not changed since.
    pub fn is_current(&self, database: &Database) -> bool {
        self.files().iter().all(|file| database.text(&file.name) == Some(&*file.text))
    }

    /// Returns the program it was made from.
    pub fn program(&self) -> Option<&Program> {
        self.of.program.as_ref()
    }

    /// Returns the files it was made from; positions in [`Elaborated::found`] refer to them.
    pub fn files(&self) -> &[SourceFile] {
        &self.of.files
    }

    /// Returns the findings at their current positions. Omits findings, labels and fixes that an
    /// edit has touched.
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

    /// Maps a current offset of a file to the texts it was made from.
    pub fn before(&self, database: &Database, file: &str, offset: u32) -> Option<(FileId, u32)> {
        let index = self.files().iter().position(|known| known.name == file)?;
        let change = change(self.files().get(index)?, database)?.undone();
        let (start, _) = change.moved(offset, offset)?;
        Some((FileId(index as u32), start))
    }

    /// Returns the gear created by the call around an offset of a file.
    pub fn gear_at(&self, database: &Database, file: &str, offset: u32) -> Option<&CreatedAt<GearGeometry>> {
        let (file, offset) = self.before(database, file, offset)?;
        self.elaboration.geometry.gear_at(file.0, offset)
    }

    /// Returns the mesh created by the call around an offset of a file.
    pub fn mesh_at(&self, database: &Database, file: &str, offset: u32) -> Option<&CreatedAt<MeshGeometry>> {
        let (file, offset) = self.before(database, file, offset)?;
        self.elaboration.geometry.mesh_at(file.0, offset)
    }

    /// Maps a position in the texts it was made from to the current texts.
    pub fn now(&self, database: &Database, span: Span) -> Option<SourceRange> {
        let file = self.files().get(span.file.0 as usize)?;
        let (start, end) = change(file, database)?.moved(span.start, span.end)?;
        Some(SourceRange { file: file.name.as_str().into(), start, end })
    }
}

/// Returns the change of a file's text; `None` if the file no longer exists.
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
