//! Coverage of productions, diagnostics, type rules and operations by cases of the language corpus.
//!
//! Every table lists all possible rows, from exhaustive matches over the compiler's types or from
//! its lists, so that a new construct is an uncovered row, which fails the test of the corpus.

pub mod corpus;
pub mod program;
pub mod report;
pub mod symbolic;
pub mod syntax;

use std::collections::BTreeSet;

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

/// Rows of one kind, and those that tests cover.
#[derive(Debug)]
pub struct Table {
    title: &'static str,
    rows: Vec<String>,
    covered: BTreeSet<String>,
}

impl Table {
    pub fn new<R: Into<String>>(title: &'static str, rows: impl IntoIterator<Item = R>) -> Table {
        let rows = rows.into_iter().map(Into::into).collect();
        Table { title, rows, covered: BTreeSet::new() }
    }

    pub fn rows(&self) -> &[String] {
        &self.rows
    }

    /// Marks rows as covered; ignores rows of other tables.
    pub fn cover<'r>(&mut self, rows: impl IntoIterator<Item = &'r str>) {
        self.covered.extend(rows.into_iter().map(str::to_owned));
    }

    pub fn is_covered(&self, row: &str) -> bool {
        self.covered.contains(row)
    }

    /// Returns the uncovered rows.
    pub fn holes(&self) -> impl Iterator<Item = String> {
        self.rows.iter().filter(|row| !self.is_covered(row)).map(|row| format!("{}: {row}", self.title))
    }
}
