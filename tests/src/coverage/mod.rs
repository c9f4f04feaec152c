//! Coverage of productions, diagnostics, type rules and operations by cases:
//! `tests/language/COVERAGE.md`.
//!
//! Every table lists all possible rows, from exhaustive matches over the compiler's types or from
//! its lists, so that a new construct appears as an uncovered row.

pub mod corpus;
pub mod program;
pub mod report;
pub mod symbolic;
pub mod syntax;

use std::collections::BTreeMap;

/// Defines a match from values of a type to their rows, and the list of these rows.
macro_rules! rows {
    ($name:ident($type:ty) { $($pattern:pat $(if $guard:expr)? => $row:literal,)+ }) => {
        pub mod $name {
            use super::*;

            pub const ALL: &[&str] = &[$($row),+];

            pub fn row(value: &$type) -> &'static str {
                match value {
                    $($pattern $(if $guard)? => $row,)+
                }
            }
        }
    };
}
use rows;

/// Location of a test that covers a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Title in the table.
    pub title: String,
    /// Link target, relative to the directory of the table.
    pub link: String,
}

/// Rows of one kind with the tests that cover them.
#[derive(Debug)]
pub struct Table {
    pub title: &'static str,
    /// Definition of coverage in this table.
    pub note: &'static str,
    /// Rows in display order.
    rows: Vec<String>,
    covered: BTreeMap<String, Vec<Place>>,
}

impl Table {
    pub fn new<R: Into<String>>(
        title: &'static str,
        note: &'static str,
        rows: impl IntoIterator<Item = R>,
    ) -> Table {
        let rows = rows.into_iter().map(Into::into).collect();
        Table { title, note, rows, covered: BTreeMap::new() }
    }

    pub fn rows(&self) -> &[String] {
        &self.rows
    }

    /// Marks rows as covered; ignores rows of other tables.
    pub fn cover<'r>(&mut self, rows: impl IntoIterator<Item = &'r str>, place: &Place) {
        for row in rows {
            let places = self.covered.entry(row.to_owned()).or_default();
            if !places.contains(place) {
                places.push(place.clone());
            }
        }
    }

    pub fn covering(&self, row: &str) -> &[Place] {
        self.covered.get(row).map_or(&[], Vec::as_slice)
    }

    pub fn is_covered(&self, row: &str) -> bool {
        !self.covering(row).is_empty()
    }

    /// Returns the uncovered rows.
    pub fn holes(&self) -> impl Iterator<Item = String> {
        self.rows.iter().filter(|row| !self.is_covered(row)).map(|row| format!("{}: {row}", self.title))
    }

    /// Renders Markdown with the first locations of each row.
    pub fn to_markdown(&self) -> String {
        let mut text = format!("\n## {}\n\n{}\n\n| | covered by |\n|---|---|\n", self.title, self.note);
        for row in &self.rows {
            let places = self.covering(row);
            let links = places.iter().take(MOST_SHOWN).map(|p| format!("[{}]({})", p.title, p.link));
            let mut cell = links.collect::<Vec<_>>().join(", ");
            if places.is_empty() {
                cell = "**nothing**".into();
            }
            text.push_str(&format!("| {} | {cell} |\n", row.replace('|', "\\|")));
        }
        text
    }
}

/// Number of locations shown per row.
const MOST_SHOWN: usize = 2;
