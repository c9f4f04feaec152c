//! Token kinds and their spellings, comments, and the result of lexing.

use crate::diagnostic::Diagnostic;
use crate::hashed::HashMap;
use crate::span::Span;
use std::sync::LazyLock;

/// The kind of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Kind {
    Number,
    Identifier,
    StringOpen,
    StringText,
    /// `: 10.3e`, the format of an interpolated value.
    Format,
    InterpolationOpen,
    InterpolationClose,
    StringClose,

    Var,
    If,
    Else,
    For,
    While,
    Do,
    Switch,
    Case,
    Default,
    Break,
    Continue,
    Return,
    Goto,
    Throw,
    Try,
    Catch,
    Function,
    In,
    Out,
    InOut,
    True,
    False,

    // Contextual keywords: programs may still use them as names.
    Import,
    Units,
    Param,
    Output,
    Extern,
    Host,
    At,
    Is,
    Private,
    Test,
    Const,
    Record,
    Enum,
    Component,
    Dimension,
    Unit,

    OpenParen,
    CloseParen,
    OpenBracket,
    CloseBracket,
    OpenBrace,
    CloseBrace,
    Comma,
    Semicolon,
    Colon,
    Dot,
    DotDot,
    Assign,
    Bind,
    AddAssign,
    SubtractAssign,
    MultiplyAssign,
    DivideAssign,
    Arrow,
    /// `=>`
    FatArrow,
    Plus,
    Minus,
    Star,
    Slash,
    Percent,
    Caret,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Or,
    AndAnd,
    OrOr,
    Not,
}

impl Kind {
    /// Returns the description of the token for messages.
    pub fn describe(self) -> &'static str {
        match self {
            Kind::Number => "a number",
            Kind::Identifier => "a name",
            Kind::Format => "a format",
            Kind::StringOpen | Kind::StringText | Kind::StringClose => "a string",
            Kind::InterpolationOpen => "`{`",
            Kind::InterpolationClose => "`}`",
            other => KEYWORDS
                .iter()
                .chain(CONTEXTUAL)
                .chain(SYMBOLS)
                .find(|(_, kind, _)| *kind == other)
                .map_or("this", |(_, _, quoted)| quoted),
        }
    }

    /// Returns `true` if an expression can end with this token.
    pub fn ends_expression(self) -> bool {
        matches!(
            self,
            Kind::Number
                | Kind::Identifier
                | Kind::StringClose
                | Kind::True
                | Kind::False
                | Kind::CloseParen
                | Kind::CloseBracket
                | Kind::Percent
        )
    }

    /// Returns `true` for `=`, `:=`, `+=` and the like.
    pub fn assigns(self) -> bool {
        matches!(
            self,
            Kind::Assign
                | Kind::Bind
                | Kind::AddAssign
                | Kind::SubtractAssign
                | Kind::MultiplyAssign
                | Kind::DivideAssign
        )
    }

    /// Returns `true` if the token is a keyword that only starts statements.
    pub fn begins_statement(self) -> bool {
        matches!(
            self,
            Kind::Var
                | Kind::For
                | Kind::While
                | Kind::Do
                | Kind::Switch
                | Kind::Case
                | Kind::Default
                | Kind::Break
                | Kind::Continue
                | Kind::Return
                | Kind::Goto
                | Kind::Throw
                | Kind::Try
                | Kind::Function
                | Kind::Import
                | Kind::Units
                | Kind::Param
                | Kind::Output
                | Kind::Extern
                | Kind::Private
                | Kind::Host
                | Kind::Test
                | Kind::Const
                | Kind::Record
                | Kind::Enum
                | Kind::Component
                | Kind::Dimension
                | Kind::Unit
        )
    }
}

pub(super) type Spelling = (&'static str, Kind, &'static str);

pub(super) const KEYWORDS: &[Spelling] = &[
    ("var", Kind::Var, "`var`"),
    ("if", Kind::If, "`if`"),
    ("else", Kind::Else, "`else`"),
    ("for", Kind::For, "`for`"),
    ("while", Kind::While, "`while`"),
    ("do", Kind::Do, "`do`"),
    ("switch", Kind::Switch, "`switch`"),
    ("case", Kind::Case, "`case`"),
    ("default", Kind::Default, "`default`"),
    ("break", Kind::Break, "`break`"),
    ("continue", Kind::Continue, "`continue`"),
    ("return", Kind::Return, "`return`"),
    ("goto", Kind::Goto, "`goto`"),
    ("throw", Kind::Throw, "`throw`"),
    ("try", Kind::Try, "`try`"),
    ("catch", Kind::Catch, "`catch`"),
    ("function", Kind::Function, "`function`"),
    ("in", Kind::In, "`in`"),
    ("out", Kind::Out, "`out`"),
    ("inout", Kind::InOut, "`inout`"),
    ("TRUE", Kind::True, "`TRUE`"),
    ("FALSE", Kind::False, "`FALSE`"),
];

pub(super) const CONTEXTUAL: &[Spelling] = &[
    ("import", Kind::Import, "`import`"),
    ("units", Kind::Units, "`units`"),
    ("param", Kind::Param, "`param`"),
    ("output", Kind::Output, "`output`"),
    ("extern", Kind::Extern, "`extern`"),
    ("at", Kind::At, "`at`"),
    ("is", Kind::Is, "`is`"),
    ("private", Kind::Private, "`private`"),
    ("host", Kind::Host, "`host`"),
    ("test", Kind::Test, "`test`"),
    ("const", Kind::Const, "`const`"),
    ("record", Kind::Record, "`record`"),
    ("enum", Kind::Enum, "`enum`"),
    ("component", Kind::Component, "`component`"),
    ("dimension", Kind::Dimension, "`dimension`"),
    ("unit", Kind::Unit, "`unit`"),
];

/// Longer spellings precede their prefixes.
pub(super) const SYMBOLS: &[Spelling] = &[
    ("..", Kind::DotDot, "`..`"),
    (":=", Kind::Bind, "`:=`"),
    ("=>", Kind::FatArrow, "`=>`"),
    ("->", Kind::Arrow, "`->`"),
    ("+=", Kind::AddAssign, "`+=`"),
    ("-=", Kind::SubtractAssign, "`-=`"),
    ("*=", Kind::MultiplyAssign, "`*=`"),
    ("/=", Kind::DivideAssign, "`/=`"),
    ("<=", Kind::LessEqual, "`<=`"),
    (">=", Kind::GreaterEqual, "`>=`"),
    ("==", Kind::Equal, "`==`"),
    ("!=", Kind::NotEqual, "`!=`"),
    ("&&", Kind::AndAnd, "`&&`"),
    ("||", Kind::OrOr, "`||`"),
    ("(", Kind::OpenParen, "`(`"),
    (")", Kind::CloseParen, "`)`"),
    ("[", Kind::OpenBracket, "`[`"),
    ("]", Kind::CloseBracket, "`]`"),
    ("{", Kind::OpenBrace, "`{`"),
    ("}", Kind::CloseBrace, "`}`"),
    (",", Kind::Comma, "`,`"),
    (";", Kind::Semicolon, "`;`"),
    (":", Kind::Colon, "`:`"),
    (".", Kind::Dot, "`.`"),
    ("=", Kind::Assign, "`=`"),
    ("+", Kind::Plus, "`+`"),
    ("-", Kind::Minus, "`-`"),
    ("*", Kind::Star, "`*`"),
    ("/", Kind::Slash, "`/`"),
    ("%", Kind::Percent, "`%`"),
    ("^", Kind::Caret, "`^`"),
    ("<", Kind::Less, "`<`"),
    (">", Kind::Greater, "`>`"),
    ("&", Kind::And, "`&`"),
    ("|", Kind::Or, "`|`"),
    ("!", Kind::Not, "`!`"),
];

/// Spellings by their first byte, each list in the order of its table.
pub(super) struct ByFirstByte {
    sorted: Vec<Spelling>,
    /// Start of the spellings of each ASCII byte in `sorted`, and the end of the last ones.
    starts: [usize; 129],
}

impl ByFirstByte {
    fn new(table: &[Spelling]) -> Self {
        let first = |spelling: &Spelling| usize::from(spelling.0.as_bytes()[0]);
        let mut sorted = table.to_vec();
        sorted.sort_by_key(first);
        let starts = std::array::from_fn(|byte| sorted.partition_point(|spelling| first(spelling) < byte));
        ByFirstByte { sorted, starts }
    }

    /// Returns the spellings with the first byte of a text.
    pub(super) fn of(&self, text: &[u8]) -> &[Spelling] {
        match text.first().map(|byte| usize::from(*byte)) {
            Some(byte @ 0..128) => &self.sorted[self.starts[byte]..self.starts[byte + 1]],
            _ => &[],
        }
    }
}

pub(super) static KEYWORDS_BY_BYTE: LazyLock<ByFirstByte> = LazyLock::new(|| ByFirstByte::new(KEYWORDS));
pub(super) static CONTEXTUAL_BY_BYTE: LazyLock<ByFirstByte> = LazyLock::new(|| ByFirstByte::new(CONTEXTUAL));
pub(super) static SYMBOLS_BY_BYTE: LazyLock<ByFirstByte> = LazyLock::new(|| ByFirstByte::new(SYMBOLS));

/// Returns the reserved keywords, for completion and suggestions.
pub fn keywords() -> impl Iterator<Item = &'static str> {
    KEYWORDS.iter().chain(CONTEXTUAL).map(|(word, _, _)| *word)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Token {
    pub kind: Kind,
    pub span: Span,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum CommentKind {
    /// `// ...`
    Line,
    /// `/// ...`, which documents what follows.
    Doc,
    /// `/* ... */`
    Block,
}

/// A comment. Comments do not affect the program, but formatting preserves them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comment {
    pub kind: CommentKind,
    /// Range without trailing whitespace.
    pub span: Span,
}

/// The tokens of a file.
#[derive(Clone, Debug, Default)]
pub struct Tokens {
    pub tokens: Vec<Token>,
    /// All comments, in source order.
    pub comments: Vec<Comment>,
    /// Text of the `///` block directly above a token, by the token's index.
    pub docs: HashMap<usize, String>,
    /// Text of a `///` block at the start of the file that is followed by a blank line.
    pub file_doc: Option<String>,
    pub diagnostics: Vec<Diagnostic>,
}
