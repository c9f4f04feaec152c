//! Access to the fields of a card, with errors that name the card, the field and its content.

use super::super::origin::{Origin, Problem};
use super::deck::Card;
use super::fields::{integer, real};
use crate::model::Components;

pub(in crate::import) type Result<T> = std::result::Result<T, Problem>;

impl Card {
    /// Returns the content of a field: 1 is the first field after the name. It is blank if the card
    /// has fewer fields.
    pub fn text(&self, field: usize) -> &str {
        self.fields.get(field.wrapping_sub(1)).map_or("", String::as_str)
    }

    pub fn is_blank(&self, field: usize) -> bool {
        self.text(field).is_empty()
    }

    /// Number of fields after the name, without blank ones at the end.
    pub fn len(&self) -> usize {
        self.fields.len()
    }

    /// Name and first field, for messages.
    pub fn subject(&self) -> String {
        format!("{} {}", self.name, self.text(1)).trim_end().to_owned()
    }

    pub fn origin(&self, name: &'static str) -> Origin {
        Origin { name, place: self.place }
    }

    pub fn problem(&self, message: impl Into<String>, help: impl Into<String>) -> Problem {
        Problem::new(self.place, message, help)
    }

    /// Number of a field within its line and the number of the line, for messages.
    fn located(&self, field: usize) -> String {
        let (line, column) = ((field - 1) / 8, (field - 1) % 8 + 2);
        match line {
            0 => format!("field {column}"),
            _ => format!("field {column} of continuation {line}"),
        }
    }

    fn invalid(&self, field: usize, what: &str, expected: &str) -> Problem {
        let found = match self.text(field) {
            "" => "is blank".to_owned(),
            text => format!("is `{text}`"),
        };
        self.problem(
            format!("{}: {} ({what}) {found}, but must be {expected}", self.subject(), self.located(field)),
            format!("write {expected} there, and check the columns of the card"),
        )
    }

    pub fn optional_integer(&self, field: usize, what: &str) -> Result<Option<i64>> {
        match self.text(field) {
            "" => Ok(None),
            text => integer(text).map(Some).ok_or_else(|| self.invalid(field, what, "an integer")),
        }
    }

    /// Identification number; `None` if the field is blank.
    pub fn optional_id(&self, field: usize, what: &str) -> Result<Option<u64>> {
        match self.optional_integer(field, what)? {
            None => Ok(None),
            Some(id) if id > 0 => Ok(Some(id as u64)),
            Some(_) => Err(self.invalid(field, what, "a positive integer")),
        }
    }

    pub fn id(&self, field: usize, what: &str) -> Result<u64> {
        self.optional_id(field, what)?.ok_or_else(|| self.invalid(field, what, "a positive integer"))
    }

    /// Identification number of a coordinate system; zero if the field is blank.
    pub fn system(&self, field: usize, what: &str) -> Result<u64> {
        match self.optional_integer(field, what)? {
            None => Ok(0),
            Some(id) if id >= 0 => Ok(id as u64),
            Some(_) => Err(self.invalid(field, what, "zero or a positive integer")),
        }
    }

    pub fn optional_real(&self, field: usize, what: &str) -> Result<Option<f64>> {
        match self.text(field) {
            "" => Ok(None),
            text => real(text).map(Some).ok_or_else(|| self.invalid(field, what, "a real number")),
        }
    }

    pub fn real(&self, field: usize, what: &str) -> Result<f64> {
        self.optional_real(field, what)?.ok_or_else(|| self.invalid(field, what, "a real number"))
    }

    pub fn real_or(&self, field: usize, default: f64, what: &str) -> Result<f64> {
        Ok(self.optional_real(field, what)?.unwrap_or(default))
    }

    pub fn positive(&self, field: usize, what: &str) -> Result<f64> {
        let value = self.real(field, what)?;
        if value > 0.0 { Ok(value) } else { Err(self.invalid(field, what, "a positive real number")) }
    }

    /// Real number that is zero or positive; zero if the field is blank.
    pub fn not_negative(&self, field: usize, what: &str) -> Result<f64> {
        let value = self.real_or(field, 0.0, what)?;
        if value >= 0.0 {
            Ok(value)
        } else {
            Err(self.invalid(field, what, "zero or a positive real number"))
        }
    }

    /// Three real numbers; blank ones are zero.
    pub fn vector(&self, field: usize, what: &str) -> Result<[f64; 3]> {
        Ok([
            self.real_or(field, 0.0, what)?,
            self.real_or(field + 1, 0.0, what)?,
            self.real_or(field + 2, 0.0, what)?,
        ])
    }

    /// Set of components as digits 1 to 6; empty if the field is blank or 0.
    pub fn optional_components(&self, field: usize, what: &str) -> Result<Components> {
        let mut components = [false; 6];
        for digit in self.text(field).bytes().filter(|byte| *byte != b'0') {
            match digit {
                b'1'..=b'6' => components[(digit - b'1') as usize] = true,
                _ => return Err(self.invalid(field, what, "digits from 1 to 6")),
            }
        }
        Ok(components)
    }

    pub fn components(&self, field: usize, what: &str) -> Result<Components> {
        let components = self.optional_components(field, what)?;
        match components.contains(&true) {
            true => Ok(components),
            false => Err(self.invalid(field, what, "digits from 1 to 6")),
        }
    }

    /// Single component from 1 to 6, as an index from 0.
    pub fn component(&self, field: usize, what: &str) -> Result<usize> {
        match self.optional_integer(field, what)? {
            Some(digit @ 1..=6) => Ok(digit as usize - 1),
            _ => Err(self.invalid(field, what, "one digit from 1 to 6")),
        }
    }

    /// Identification numbers from a field to the end of the card, without blank fields.
    pub fn ids(&self, first: usize, what: &str) -> Result<Vec<u64>> {
        let filled = (first..=self.len()).filter(|field| !self.is_blank(*field));
        filled.map(|field| self.id(field, what)).collect()
    }

    /// Rejects fields that have a value other than zero.
    pub fn unsupported(&self, fields: impl IntoIterator<Item = usize>, what: &str) -> Result<()> {
        for field in fields {
            let zero = self.is_blank(field) || real(self.text(field)) == Some(0.0);
            if !zero {
                let (subject, located) = (self.subject(), self.located(field));
                let message = format!(
                    "{subject}: {located} ({what}) is `{}`: {what} is not supported",
                    self.text(field)
                );
                return Err(self.problem(message, "leave the field blank, if the body permits it"));
            }
        }
        Ok(())
    }

    /// Identification numbers of a list that may contain `n1 THRU n2` and `BY step`.
    pub fn ranges(&self, first: usize, what: &str) -> Result<Vec<Range>> {
        let fields: Vec<usize> = (first..=self.len()).filter(|field| !self.is_blank(*field)).collect();
        let mut ranges = Vec::new();
        let mut at = 0;
        while at < fields.len() {
            let from = self.id(fields[at], what)?;
            let word = |offset: usize| fields.get(at + offset).map_or("", |field| self.text(*field));
            if word(1) == "THRU" {
                let Some(end) = fields.get(at + 2) else {
                    return Err(self.invalid(fields[at + 1] + 1, what, "the end of the range"));
                };
                let to = self.id(*end, what)?;
                let (step, used) = match (word(3), fields.get(at + 4)) {
                    ("BY", Some(step)) => (self.id(*step, what)?, 5),
                    _ => (1, 3),
                };
                if to < from {
                    return Err(self.invalid(*end, what, "at least the start of the range"));
                }
                ranges.push(Range { from, to, step });
                at += used;
            } else {
                ranges.push(Range { from, to: from, step: 1 });
                at += 1;
            }
        }
        Ok(ranges)
    }
}

/// Range of identification numbers.
#[derive(Clone, Copy, Debug)]
pub(in crate::import) struct Range {
    pub from: u64,
    pub to: u64,
    pub step: u64,
}

impl Range {
    pub fn is_single(&self) -> bool {
        self.from == self.to
    }

    pub fn contains(&self, id: u64) -> bool {
        (self.from..=self.to).contains(&id) && (id - self.from).is_multiple_of(self.step)
    }
}
