//! What is offered: plain data, which the server turns into messages.

use crate::ide::Edit;
use calyx_lang::analysis::{NameKind, SourceRange};

/// Everything that can be written at a cursor, best first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Completions {
    /// The bytes that what is chosen takes the place of.
    pub start: u32,
    pub end: u32,
    pub items: Vec<Item>,
    /// There is more than was sent: ask again when more is typed.
    pub incomplete: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Item {
    pub label: String,
    pub kind: ItemKind,
    /// One line: type, unit, default.
    pub detail: String,
    pub insert: Insert,
    /// What typed letters are compared with, if it is not the label.
    pub filter: Option<String>,
    pub rank: Rank,
    /// An `import` that goes with it.
    pub import: Option<Edit>,
    /// What its documentation is asked by.
    pub subject: Option<Subject>,
    /// What an editor shows next.
    pub then: AfterInsert,
}

/// What is put in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Insert {
    pub plain: String,
    /// With places to fill in, for editors that have them.
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
    /// The parameters of what was put in.
    Signature,
    /// What can stand where the cursor now is.
    Completion,
}

/// What an item is about, small enough to travel to the editor and back.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Subject {
    Declaration(SourceRange),
    /// A parameter of what is declared at the place, or a field.
    Parameter(SourceRange, String),
    /// A function or constant of the language.
    Builtin(String),
    Keyword(String),
    Unit(String),
}

/// Where an item stands among others; less is better.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct Rank {
    /// How it fits the place.
    pub fit: u8,
    /// How near its origin is: locals, top level, library, language.
    pub origin: u8,
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

    /// What typed letters are compared with.
    pub fn key(&self) -> &str {
        self.filter.as_deref().unwrap_or(&self.label)
    }
}

impl ItemKind {
    /// As said to people.
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

/// Text as it stands for itself in a snippet.
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
