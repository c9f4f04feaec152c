//! Parser of Markdown documents with test cases: the pages in `tests/language` and the language
//! reference.
//!
//! A case is a fenced block with a model, followed by blocks with its expected results:
//!
//! - `cx`: a model. Comments state the expected diagnostics: `//~ CODE part of the message` on the
//!   same line, `//~^` for the line above, `//~ elsewhere CODE ...` for another file. Any other
//!   diagnostic is a failure.
//! - `cx fragment`: the same, but unused variables are allowed.
//! - `cx module NAME`: the file `NAME.cx`, which all models of the document may import.
//! - `file NAME`: any other file.
//! - `types`: types of the top-level declarations of the preceding model.
//! - `diagnostic`: diagnostics of the model as users see them.
//! - `text`: text that the model prints, in the interpreter and as machine code.
//! - `error`: error that ends the model, in both.

use std::fs;
use std::path::Path;

/// Fenced block.
#[derive(Clone, Debug)]
pub struct Block {
    /// Line of the document on which the text begins, from 1.
    pub line: usize,
    /// Info string after the opening fence.
    pub kind: String,
    /// Lines between the fences.
    pub text: String,
}

/// Model with its expected results.
#[derive(Clone, Debug)]
pub struct Case {
    /// Heading of the section; the second model of a section has the suffix `(2)`.
    pub heading: String,
    /// Anchor of the heading.
    pub anchor: String,
    pub model: Block,
    pub expected: Vec<Block>,
}

impl Case {
    /// Returns the expected result of a kind, such as `types`.
    pub fn expects(&self, kind: &str) -> Option<&Block> {
        self.expected.iter().find(|block| block.kind == kind)
    }

    /// Returns true if the model may have unused variables.
    pub fn is_fragment(&self) -> bool {
        self.model.kind == "cx fragment"
    }
}

/// Parsed document.
#[derive(Clone, Debug)]
pub struct Document {
    /// Name for messages.
    pub name: String,
    /// Complete text.
    pub text: String,
    pub cases: Vec<Case>,
    /// Names and texts of files that models can import or read.
    pub files: Vec<(String, String)>,
}

/// Info strings of expected results.
const EXPECTATIONS: [&str; 4] = ["types", "diagnostic", "text", "error"];

impl Document {
    /// Reads a document; `name` is its name in messages.
    ///
    /// # Panics
    /// Panics if the file cannot be read, and as [`Document::new`].
    pub fn read(path: &Path, name: &str) -> Document {
        let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        Document::new(name, text)
    }

    /// Parses a document.
    ///
    /// # Panics
    /// Panics if a block is not closed, or if no model precedes an expected result.
    pub fn new(name: &str, text: String) -> Document {
        let mut document =
            Document { name: name.to_owned(), text: String::new(), cases: Vec::new(), files: Vec::new() };
        let mut heading = (String::new(), 0);
        let mut open: Option<Block> = None;
        for (index, line) in text.lines().enumerate() {
            match (&mut open, line.strip_prefix("```")) {
                (None, Some(kind)) => {
                    open = Some(Block { line: index + 2, kind: kind.trim().into(), text: String::new() });
                }
                (None, None) => {
                    if line.starts_with('#') {
                        heading = (line.trim_start_matches('#').trim().to_owned(), 0);
                    }
                }
                (Some(_), Some(_)) => {
                    if let Some(block) = open.take() {
                        document.add(block, &mut heading);
                    }
                }
                (Some(block), None) => {
                    block.text.push_str(line);
                    block.text.push('\n');
                }
            }
        }
        assert!(open.is_none(), "{name}: a block is not closed");
        document.text = text;
        document
    }

    /// Adds a block. `heading` is the current heading and the number of models below it so far.
    fn add(&mut self, block: Block, (heading, count): &mut (String, usize)) {
        if let Some(module) = block.kind.strip_prefix("cx module ") {
            self.files.push((format!("{}.cx", module.replace('.', "/")), block.text));
        } else if let Some(file) = block.kind.strip_prefix("file ") {
            self.files.push((file.to_owned(), block.text));
        } else if block.kind == "cx" || block.kind == "cx fragment" {
            *count += 1;
            let number = if *count > 1 { format!(" ({count})") } else { String::new() };
            self.cases.push(Case {
                heading: format!("{heading}{number}"),
                anchor: anchor(heading),
                model: block,
                expected: Vec::new(),
            });
        } else if EXPECTATIONS.contains(&block.kind.as_str()) {
            let Some(case) = self.cases.last_mut() else {
                panic!("{}:{}: no model precedes this expected result", self.name, block.line)
            };
            case.expected.push(block);
        }
    }

    /// Returns the text of the document with other texts in some of its blocks.
    pub fn with_blocks_replaced(&self, replacements: &[(Block, String)]) -> String {
        let mut lines: Vec<&str> = self.text.lines().collect();
        let mut sorted: Vec<&(Block, String)> = replacements.iter().collect();
        sorted.sort_by_key(|(block, _)| std::cmp::Reverse(block.line));
        for (block, text) in sorted {
            let first = block.line - 1;
            lines.splice(first..first + block.text.lines().count(), text.lines());
        }
        lines.iter().map(|line| format!("{line}\n")).collect()
    }
}

/// Returns the anchor of a heading in Markdown viewers: lower case, hyphens for blanks, no
/// punctuation.
pub fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}
