//! Keyword blocks of an input file: keyword lines with parameters, and their data lines.
//!
//! Source: Abaqus Analysis User's Guide, "Input syntax rules"; CalculiX CrunchiX User's Manual,
//! "Input deck format".

use super::super::error::ImportError;
use super::super::origin::Problem;
use super::super::source::{Place, Sources, included, lines, plain};

/// Deepest nesting of included files.
const DEEPEST: usize = 16;

pub(super) type Result<T> = std::result::Result<T, Problem>;

/// Data line.
pub(super) struct DataLine {
    text: String,
    pub place: Place,
}

/// Keyword with its parameters and data lines. Names are in upper case without blanks.
pub(super) struct Block {
    pub keyword: String,
    parameters: Vec<(String, String)>,
    pub data: Vec<DataLine>,
    pub place: Place,
}

impl DataLine {
    /// Data line of this text, or the value of a parameter.
    pub fn new(text: &str, place: Place) -> Self {
        Self { text: text.to_owned(), place }
    }

    /// Values between commas, without blanks around them and without an empty one at the end.
    pub fn values(&self) -> Vec<&str> {
        let mut values: Vec<&str> =
            self.text.split(',').map(|value| value.trim().trim_matches('"')).collect();
        while values.last().is_some_and(|value| value.is_empty()) {
            values.pop();
        }
        values
    }

    pub fn problem(&self, message: impl Into<String>, help: impl Into<String>) -> Problem {
        Problem::new(self.place, message, help)
    }
}

impl Block {
    /// Value of a parameter; empty for one without value.
    pub fn parameter(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    pub fn required(&self, name: &str) -> Result<&str> {
        self.parameter(name).filter(|value| !value.is_empty()).ok_or_else(|| {
            self.problem(format!("*{} has no parameter {name}", self.keyword), format!("write {name}=..."))
        })
    }

    /// Rejects parameters that change the body and are not supported.
    pub fn without(&self, names: &[&str]) -> Result<()> {
        match names.iter().find(|name| self.parameter(name).is_some()) {
            None => Ok(()),
            Some(name) => Err(self.problem(
                format!("*{}: the parameter {name} is not supported", self.keyword),
                "export the model without it",
            )),
        }
    }

    pub fn problem(&self, message: impl Into<String>, help: impl Into<String>) -> Problem {
        Problem::new(self.place, message, help)
    }

    /// Data line with this index.
    pub fn line(&self, index: usize, what: &str) -> Result<&DataLine> {
        self.data.get(index).ok_or_else(|| {
            self.problem(
                format!("*{} has no data line with {what}", self.keyword),
                format!("write {what} in a data line"),
            )
        })
    }
}

/// Returns the real number that a value states.
pub(super) fn real(text: &str) -> Option<f64> {
    let valid = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eEdD".contains(&byte));
    let value: f64 = text.replace(['d', 'D'], "e").parse().ok()?;
    (valid && value.is_finite()).then_some(value)
}

/// Real number at an index of the values; zero if it is blank.
pub(super) fn real_at(line: &DataLine, values: &[&str], index: usize, what: &str) -> Result<f64> {
    match values.get(index).copied().unwrap_or_default() {
        "" => Ok(0.0),
        text => real(text).ok_or_else(|| not_a_number(line, text, what)),
    }
}

pub(super) fn positive_at(line: &DataLine, values: &[&str], index: usize, what: &str) -> Result<f64> {
    let value = real_at(line, values, index, what)?;
    if value > 0.0 {
        return Ok(value);
    }
    Err(line.problem(format!("{what} is {value}, but must be positive"), format!("correct {what}")))
}

/// Positive integer at an index of the values.
pub(super) fn integer_at(line: &DataLine, values: &[&str], index: usize, what: &str) -> Result<u64> {
    let text = values.get(index).copied().unwrap_or_default();
    text.parse().ok().filter(|value| *value > 0).ok_or_else(|| not_a_number(line, text, what))
}

fn not_a_number(line: &DataLine, text: &str, what: &str) -> Problem {
    let found = if text.is_empty() { "is missing".to_owned() } else { format!("is `{text}`") };
    line.problem(format!("{what} {found}, but must be a number"), "check the values of the line")
}

/// Name in upper case without blanks.
pub(super) fn normalized(name: &str) -> String {
    name.chars().filter(|c| !c.is_whitespace()).collect::<String>().to_ascii_uppercase()
}

/// Reads the blocks of an input file with all files that it includes.
pub(super) fn read(path: &str, sources: &mut Sources) -> std::result::Result<Vec<Block>, ImportError> {
    let mut blocks = Vec::new();
    read_file(path, None, sources, &mut blocks, &mut Vec::new())?;
    Ok(blocks)
}

fn read_file(
    path: &str,
    from: Option<Place>,
    sources: &mut Sources,
    blocks: &mut Vec<Block>,
    open: &mut Vec<String>,
) -> std::result::Result<(), ImportError> {
    if let Some(place) = from {
        let message = match open.contains(&plain(path)) {
            true => format!("`{path}` includes itself"),
            false => format!("included files are nested more than {DEEPEST} deep"),
        };
        if open.contains(&plain(path)) || open.len() >= DEEPEST {
            return Err(sources.error(place, message, "include each file once, from the main file"));
        }
    }
    open.push(plain(path));
    let (file, text) = sources.text(path, from)?;
    let mut all = lines(&text);
    while let Some((number, line)) = all.next() {
        let place = Place { file, line: number };
        if line.trim().is_empty() || line.trim_start().starts_with("**") {
            continue;
        }
        if !line.trim_start().starts_with('*') {
            let Some(block) = blocks.last_mut() else {
                let message = "the file begins with data instead of a keyword line";
                return Err(sources.error(
                    place,
                    message,
                    "check that this is an input file of Abaqus or CalculiX",
                ));
            };
            block.data.push(DataLine { text: line.to_owned(), place });
            continue;
        }
        let mut keyword_line = line.trim().to_owned();
        while keyword_line.ends_with(',') {
            let Some((_, more)) = all.next() else { break };
            keyword_line.push_str(more.trim());
        }
        let block = keyword_block(&keyword_line, place);
        if block.keyword == "INCLUDE" {
            let Some(name) = block.parameter("INPUT").filter(|name| !name.is_empty()) else {
                return Err(sources.error(place, "*INCLUDE states no file", "write INPUT=name"));
            };
            read_file(&included(path, name), Some(place), sources, blocks, open)?;
        } else {
            blocks.push(block);
        }
    }
    open.pop();
    Ok(())
}

fn keyword_block(line: &str, place: Place) -> Block {
    let mut parts = line[1..].split(',');
    let keyword = normalized(parts.next().unwrap_or_default());
    let parameter = |part: &str| {
        let (name, value) = part.split_once('=').unwrap_or((part, ""));
        (normalized(name), value.trim().trim_matches('"').to_owned())
    };
    let parameters = parts.filter(|part| !part.trim().is_empty()).map(parameter).collect();
    Block { keyword, parameters, data: Vec::new(), place }
}
