//! Sections of a deck, included files, and cards assembled from their lines.
//!
//! Source: NASTRAN Quick Reference Guide, "File Management Statements" (INCLUDE), "Executive
//! Control", "Case Control", "Format of Bulk Data Entries" (continuations).

use super::super::error::ImportError;
use super::super::source::{Place, Sources, included, lines, plain};
use super::fields::{Line, split};
use std::collections::HashMap;

/// Deepest nesting of included files.
const DEEPEST: usize = 16;
/// Largest number of lines of an INCLUDE statement.
const INCLUDE_LINES: usize = 20;

/// Logical card: all fields after the name, in the order of the format's field numbers.
#[derive(Debug)]
pub(in crate::import) struct Card {
    pub name: String,
    /// Data fields of all lines, eight a line, without blank ones at the end.
    pub fields: Vec<String>,
    pub place: Place,
    next: String,
    /// True after the first half of a large-field line.
    half: bool,
}

#[derive(Clone, Copy, PartialEq)]
enum Section {
    Executive,
    Case,
    Bulk,
    End,
}

/// Cards and control statements of a deck.
pub(super) struct Deck {
    pub cards: Vec<Card>,
    /// Lines of executive and case control.
    pub control: Vec<(String, Place)>,
    /// True if the deck has executive or case control.
    pub has_case_control: bool,
}

pub(super) struct DeckReader<'s, 'o> {
    sources: &'s mut Sources<'o>,
    deck: Deck,
    section: Section,
    /// Cards that name their continuation.
    named: HashMap<String, usize>,
    /// Card of the last line.
    current: Option<usize>,
    /// Paths of the files that are being read.
    open: Vec<String>,
    /// True after a line of an equation (DEQATN), whose lines have no fields.
    in_equation: bool,
}

/// Reads a deck with all files that it includes.
pub(super) fn read(path: &str, sources: &mut Sources) -> Result<Deck, ImportError> {
    let deck = Deck { cards: Vec::new(), control: Vec::new(), has_case_control: false };
    let mut reader = DeckReader {
        sources,
        deck,
        section: Section::Executive,
        named: HashMap::new(),
        current: None,
        open: Vec::new(),
        in_equation: false,
    };
    reader.file(path, None)?;
    let mut deck = reader.deck;
    for card in &mut deck.cards {
        while card.fields.last().is_some_and(String::is_empty) {
            card.fields.pop();
        }
    }
    Ok(deck)
}

/// First word of a statement in upper case, without the rest after a blank, `=` or `(`.
pub(super) fn keyword(line: &str) -> String {
    line.trim_start()
        .split([' ', '\t', '=', '(', ',', '\'', '"'])
        .next()
        .unwrap_or_default()
        .to_ascii_uppercase()
}

impl DeckReader<'_, '_> {
    fn file(&mut self, path: &str, from: Option<Place>) -> Result<(), ImportError> {
        let (file, text) = self.sources.text(path, from)?;
        if self.open.is_empty() {
            // A file without control sections consists of bulk data only.
            let has_control =
                lines(&text).any(|(_, line)| matches!(keyword(line).as_str(), "BEGIN" | "CEND"));
            self.section = if has_control { Section::Executive } else { Section::Bulk };
        }
        self.open.push(plain(path));
        let mut all = lines(&text);
        while let Some((number, line)) = all.next() {
            let place = Place { file, line: number };
            if self.section == Section::End {
                break;
            }
            if keyword(line) == "INCLUDE" {
                let mut statement = line.trim().to_owned();
                let mut count = 1;
                while open_quote(&statement) && count < INCLUDE_LINES {
                    let Some((_, more)) = all.next() else { break };
                    statement.push_str(more.trim());
                    count += 1;
                }
                self.include(&statement, path, place)?;
            } else {
                self.line(line, place)?;
            }
        }
        self.open.pop();
        Ok(())
    }

    fn include(&mut self, statement: &str, from: &str, place: Place) -> Result<(), ImportError> {
        let rest = statement["INCLUDE".len()..].trim_start_matches([' ', '\t', '=']);
        let name = match rest.chars().next() {
            Some(quote @ ('\'' | '"')) => rest[1..].split_once(quote).map(|(name, _)| name),
            _ => rest.split([' ', '\t', '$']).next(),
        };
        let Some(name) = name.map(str::trim).filter(|name| !name.is_empty()) else {
            return Err(self.sources.error(
                place,
                "INCLUDE states no file name",
                "write INCLUDE 'name' with the same quote at both ends",
            ));
        };
        let path = included(from, name);
        if self.open.contains(&plain(&path)) {
            let message = format!("`{path}` includes itself");
            return Err(self.sources.error(place, message, "remove one INCLUDE statement of the cycle"));
        }
        if self.open.len() >= DEEPEST {
            let message = format!("included files are nested more than {DEEPEST} deep");
            return Err(self.sources.error(place, message, "include the files from the main file"));
        }
        self.file(&path, Some(place))
    }

    fn line(&mut self, line: &str, place: Place) -> Result<(), ImportError> {
        let word = keyword(line);
        if line.trim_start().is_empty() || line.trim_start().starts_with('$') {
            return Ok(());
        }
        match self.section {
            Section::End => {}
            Section::Bulk => match word.as_str() {
                "ENDDATA" => self.section = Section::End,
                "BEGIN" => {
                    let message =
                        "the deck has a second BEGIN statement: superelements and parts are not supported";
                    return Err(self.sources.error(place, message, "import one bulk data section"));
                }
                _ => self.bulk(line, place)?,
            },
            Section::Executive | Section::Case => match word.as_str() {
                "CEND" => {
                    self.section = Section::Case;
                    self.deck.has_case_control = true;
                }
                "BEGIN" => {
                    let super_element = line.to_ascii_uppercase().contains("SUPER");
                    if super_element {
                        let message = "superelements are not supported";
                        return Err(self.sources.error(place, message, "import one bulk data section"));
                    }
                    self.section = Section::Bulk;
                    // The statement alone selects nothing, as if it were missing.
                    self.deck.has_case_control |= !self.deck.control.is_empty();
                }
                _ => self.deck.control.push((line.trim().to_owned(), place)),
            },
        }
        Ok(())
    }

    fn bulk(&mut self, line: &str, place: Place) -> Result<(), ImportError> {
        let continues = line.starts_with([' ', '\t', '+', '*', ',']);
        if keyword(line) == "DEQATN" {
            self.in_equation = true;
            let line = Line { name: "DEQATN".into(), ..Line::default() };
            return self.start(line, place);
        }
        self.in_equation &= continues;
        if self.in_equation {
            return Ok(());
        }
        let columns = "check the columns of the line: 8 columns a field, or 16 after `*`, or commas";
        let split = split(line).map_err(|message| self.sources.error(place, message, columns))?;
        let Some(line) = split else {
            return Ok(());
        };
        if line.continues { self.append(line, place) } else { self.start(line, place) }
    }

    fn start(&mut self, line: Line, place: Place) -> Result<(), ImportError> {
        let at = self.deck.cards.len();
        self.current = Some(at);
        if !line.next.is_empty() {
            self.named.insert(line.next.clone(), at);
        }
        self.deck.cards.push(Card {
            name: line.name,
            fields: line.fields,
            place,
            next: line.next,
            half: line.large,
        });
        Ok(())
    }

    fn append(&mut self, line: Line, place: Place) -> Result<(), ImportError> {
        let follows = |at: &usize| {
            let next = &self.deck.cards[*at].next;
            line.name.is_empty() || next.is_empty() || *next == line.name
        };
        let target = self.current.filter(follows).or_else(|| self.named.get(&line.name).copied());
        let Some(at) = target else {
            let message = format!("the continuation `{}` follows no card that names it", line.name);
            let help = "place the continuation after its card, or name it in field 10 of the card";
            return Err(self.sources.error(place, message, help));
        };
        if self.deck.cards[at].half && !line.large {
            let card = &self.deck.cards[at];
            let message = format!("{} in large-field format lacks the second half of its line", card.name);
            return Err(self.sources.error(card.place, message, "add a line that begins with `*`"));
        }
        let card = &mut self.deck.cards[at];
        card.half = line.large && !card.half;
        card.fields.extend(line.fields);
        self.named.remove(&line.name);
        if !line.next.is_empty() {
            self.named.insert(line.next.clone(), at);
        }
        card.next = line.next;
        self.current = Some(at);
        Ok(())
    }
}

/// True if a statement has an opening quote without a closing one.
fn open_quote(statement: &str) -> bool {
    let first = statement.find(['\'', '"']);
    first.is_some_and(|at| {
        let quote = &statement[at..=at];
        !statement[at + 1..].contains(quote)
    })
}
