//! Markdown documents with programs in them: the language corpus and the reference.
//!
//! Fenced blocks:
//! - `cx` is a model without any diagnostic, except those that its comments `//~ CODE part of the message` expect on
//!   their line (`//~^` on the line above, `//~ elsewhere CODE ...` in another file);
//! - `cx fragment` is the same, and unused variables pass;
//! - `cx module NAME` is a file `NAME.cx` that all models of the document may import, `file NAME` any other file;
//! - after a model, in any order: `types` of what it declares at its top level, `diagnostic`s as people see them, the
//!   `text` it prints and the `error` it ends with, run by the interpreter and as machine code.

use std::fs;
use std::path::Path;

/// What stands between two fences.
#[derive(Clone, Debug)]
pub struct Block {
    /// Line of the document its text begins on, from 1.
    pub line: usize,
    /// What stands after the opening fence.
    pub kind: String,
    pub text: String,
}

/// A model and what is expected of it.
#[derive(Clone, Debug)]
pub struct Case {
    /// The heading it stands under; the second model under a heading has `(2)` added.
    pub heading: String,
    /// The heading as it is linked to.
    pub anchor: String,
    pub model: Block,
    pub expected: Vec<Block>,
}

impl Case {
    pub fn expects(&self, kind: &str) -> Option<&Block> {
        self.expected.iter().find(|block| block.kind == kind)
    }

    /// Unused variables pass.
    pub fn is_fragment(&self) -> bool {
        self.model.kind == "cx fragment"
    }
}

/// A document, taken apart.
#[derive(Clone, Debug)]
pub struct Document {
    /// As messages name it.
    pub name: String,
    pub text: String,
    pub cases: Vec<Case>,
    /// Files beside the models: name and text.
    pub files: Vec<(String, String)>,
}

const EXPECTATIONS: [&str; 4] = ["types", "diagnostic", "text", "error"];

impl Document {
    /// Reads a document; `name` is how messages name it.
    ///
    /// # Panics
    /// If it cannot be read, a block is not closed or a block of expectations follows no model.
    pub fn read(path: &Path, name: &str) -> Document {
        let text = fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        Document::new(name, text)
    }

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

    /// Adds a block; `heading` is the one above it, with the number of models under it so far.
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
                panic!("{}:{}: nothing to expect this of", self.name, block.line)
            };
            case.expected.push(block);
        }
    }

    /// The document with other texts in some of its blocks.
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

/// A heading as Markdown viewers link to it: small letters, blanks as hyphens, no punctuation.
pub fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || [' ', '-', '_'].contains(c));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}
