//! Completion items: plain data, which the server converts to messages.

use crate::ide::Edit;
use calyx_lang::analysis::{NameKind, SourceRange};

/// Completions at a cursor, best first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Completions {
    /// Start of the byte range that the chosen item replaces.
    pub start: u32,
    /// End of the byte range that the chosen item replaces.
    pub end: u32,
    pub items: Vec<Item>,
    /// True if items were omitted: request again after more typing.
    pub incomplete: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    pub label: String,
    pub kind: ItemKind,
    /// Summary in one line: type, unit, default.
    pub detail: String,
    pub insert: Insert,
    /// Text that the typed letters are compared with, if it is not the label.
    pub filter: Option<String>,
    pub rank: Rank,
    /// Edit that adds a required `import`.
    pub import: Option<Edit>,
    /// Key of its documentation.
    pub subject: Option<Subject>,
    /// Command to run after insertion.
    pub then: AfterInsert,
}

/// Inserted text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Insert {
    pub plain: String,
    /// Snippet with placeholders, for editors that support them.
    pub snippet: Option<String>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ItemKind {
    Name(NameKind),
    Keyword,
    /// `name = ` of a call.
    Argument,
    /// An allowed value.
    Value,
    Unit,
    Type,
    Module,
    Label,
    /// A component of a vector or field of a record.
    Field,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum AfterInsert {
    #[default]
    Nothing,
    /// Shows signature help.
    Signature,
    /// Shows completion at the new cursor.
    Completion,
}

/// Subject of an item, small enough to be part of the item's data.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Subject {
    Declaration(SourceRange),
    /// A parameter of the declaration at the position, or a field.
    Parameter(SourceRange, String),
    /// A builtin function or constant.
    Builtin(String),
    Keyword(String),
    Unit(String),
}

/// Rank of an item; lower is better.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rank {
    /// Quality of the match with the expected type.
    pub fit: u8,
    /// Distance of the origin: locals, top level, library, language.
    pub origin: u8,
    /// Order among items of equal rank.
    pub order: u32,
}

impl Insert {
    pub fn plain(text: impl Into<String>) -> Insert {
        Insert { plain: text.into(), snippet: None }
    }

    pub fn snippet(plain: impl Into<String>, snippet: impl Into<String>) -> Insert {
        Insert { plain: plain.into(), snippet: Some(snippet.into()) }
    }
}

impl Item {
    pub fn new(label: impl Into<String>, kind: ItemKind, rank: Rank) -> Item {
        let label = label.into();
        Item {
            insert: Insert::plain(label.clone()),
            label,
            kind,
            detail: String::new(),
            filter: None,
            rank,
            import: None,
            subject: None,
            then: AfterInsert::Nothing,
        }
    }

    pub fn detail(mut self, detail: impl Into<String>) -> Item {
        self.detail = detail.into();
        self
    }

    pub fn insert(mut self, insert: Insert) -> Item {
        self.insert = insert;
        self
    }

    pub fn about(mut self, subject: Subject) -> Item {
        self.subject = Some(subject);
        self
    }

    /// Returns the text that typed letters are compared with.
    pub fn key(&self) -> &str {
        self.filter.as_deref().unwrap_or(&self.label)
    }
}

impl ItemKind {
    /// Returns the display name.
    pub fn describe(self) -> &'static str {
        match self {
            ItemKind::Name(kind) => kind.describe(),
            ItemKind::Keyword => "keyword",
            ItemKind::Argument => "argument",
            ItemKind::Value => "value",
            ItemKind::Unit => "unit",
            ItemKind::Type => "type",
            ItemKind::Module => "module",
            ItemKind::Label => "label",
            ItemKind::Field => "field",
        }
    }
}

/// Escapes a text for a snippet.
pub fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '$' | '}' | '\\') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}
