//! Which production, diagnostic, type rule and operation is covered by which case: `tests/language/COVERAGE.md`.
//!
//! Every table lists all the rows there could be, from exhaustive matches over the compiler's own types or from its
//! lists, so that what is new appears here by itself, as a hole.

pub mod corpus;
pub mod program;
pub mod report;
pub mod symbolic;
pub mod syntax;

use std::collections::BTreeMap;

/// A match from values of a type to the rows that stand for them, and the list of these rows.
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

/// A place that covers a row.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// As shown.
    pub title: String,
    /// What it links to, from the folder of the table.
    pub link: String,
}

/// Rows of one kind and what covers them.
#[derive(Debug)]
pub struct Table {
    pub title: &'static str,
    /// What counts.
    pub note: &'static str,
    /// In the order they are shown in.
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

    /// Marks rows as covered; those that the table does not have are somebody else's.
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

    /// Rows that nothing covers.
    pub fn holes(&self) -> impl Iterator<Item = String> {
        self.rows.iter().filter(|row| !self.is_covered(row)).map(|row| format!("{}: {row}", self.title))
    }

    /// As Markdown, with the first places of each row.
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

/// Places shown per row.
const MOST_SHOWN: usize = 2;
