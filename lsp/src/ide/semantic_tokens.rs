//! Semantic tokens, for highlighting.
//!
//! Keywords, numbers, strings and comments are known from tokens alone. The meaning of names is
//! known from the checked program, or is guessed from the adjacent tokens. Thus few colours change
//! while a statement is incomplete.

use super::lines::slice;
use super::source::Source;
use super::symbols::is_library;
use calyx_lang::analysis::{Name, NameKind};
use calyx_lang::ast::{FunctionBody, Ident, Stmt, StmtKind, TypeExpr, TypeKind};
use calyx_lang::lexer::{Comment, CommentKind, Kind, Token};
use calyx_lang::walk::Node;
use std::collections::HashMap;
use std::ops::{BitOr, Range};

/// Type of a semantic token. Uses the protocol's types where one is suitable, so that every theme
/// supports them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TokenKind {
    Comment,
    Keyword,
    Number,
    String,
    Operator,
    Namespace,
    Type,
    Struct,
    Parameter,
    Variable,
    Property,
    Function,
    Label,
    /// Not a type of the protocol.
    Unit,
}

/// Names of the types in the order of [`TokenKind`].
pub const KINDS: [&str; 14] = [
    "comment",
    "keyword",
    "number",
    "string",
    "operator",
    "namespace",
    "type",
    "struct",
    "parameter",
    "variable",
    "property",
    "function",
    "label",
    "unit",
];

/// Modifiers of a semantic token.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Modifiers(pub u32);

impl Modifiers {
    pub const NONE: Modifiers = Modifiers(0);
    pub const DECLARATION: Modifiers = Modifiers(1);
    pub const READONLY: Modifiers = Modifiers(1 << 1);
    /// The name is assigned to.
    pub const MODIFICATION: Modifiers = Modifiers(1 << 2);
    pub const DOCUMENTATION: Modifiers = Modifiers(1 << 3);
    /// The name is builtin or of the library.
    pub const DEFAULT_LIBRARY: Modifiers = Modifiers(1 << 4);
    /// The name refers to an expression, not to a value. This and the following modifiers are not
    /// of the protocol.
    pub const SYMBOLIC: Modifiers = Modifiers(1 << 5);
    /// Param of the model.
    pub const PARAM: Modifiers = Modifiers(1 << 6);
    /// Output of the model.
    pub const OUTPUT: Modifiers = Modifiers(1 << 7);
    /// Name of an argument.
    pub const ARGUMENT: Modifiers = Modifiers(1 << 8);
}

/// Names of the modifiers in the order of their bits.
pub const MODIFIERS: [&str; 9] = [
    "declaration",
    "readonly",
    "modification",
    "documentation",
    "defaultLibrary",
    "symbolic",
    "param",
    "output",
    "argument",
];

impl BitOr for Modifiers {
    type Output = Modifiers;

    fn bitor(self, other: Modifiers) -> Modifiers {
        Modifiers(self.0 | other.0)
    }
}

/// A word, or a comment or string on one line. Tokens are sorted and do not overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SemanticToken {
    pub start: u32,
    pub end: u32,
    pub kind: TokenKind,
    pub modifiers: Modifiers,
}

type NameMeaning = (TokenKind, Modifiers);

/// Returns the tokens in a range. `names` are the names of the file in order, at least those of the
/// top-level statements in the range.
pub fn tokens(source: &Source<'_>, names: &[Name], range: Range<u32>) -> Vec<SemanticToken> {
    let all = &source.tokens.tokens;
    let written = written(source, &range);
    let first = all.partition_point(|token| token.span.end <= range.start);
    let last = all.partition_point(|token| token.span.start < range.end);
    let comments = &source.tokens.comments;
    let comment = comments.partition_point(|comment| comment.span.end <= range.start);
    let mut comments = comments.iter().skip(comment).peekable();
    let mut names = names.iter().peekable();
    let mut found = Vec::with_capacity(last.saturating_sub(first));
    for index in first..last {
        let Some(token) = all.get(index) else { break };
        while let Some(comment) = comments.next_if(|comment| comment.span.start < token.span.start) {
            comment_lines(source, comment, &mut found);
        }
        while names.next_if(|name| name.start < token.span.start).is_some() {}
        let name = names.peek().filter(|name| name.start == token.span.start);
        let around = TokenContext { source, index };
        let meaning = match token.kind {
            Kind::Identifier => match (name, written.get(&token.span.start)) {
                (Some(name), _) => Some(around.named(name)),
                (None, Some(meaning)) => Some(*meaning),
                (None, None) => around.unknown(),
            },
            kind => of_kind(kind, around.before()),
        };
        if let Some((kind, modifiers)) = meaning {
            push(&mut found, token, kind, modifiers);
        }
    }
    for comment in comments.take_while(|comment| comment.span.start < range.end) {
        comment_lines(source, comment, &mut found);
    }
    found
}

/// Adds a token; merges adjacent parts of a string.
fn push(found: &mut Vec<SemanticToken>, token: &Token, kind: TokenKind, modifiers: Modifiers) {
    let (start, end) = (token.span.start, token.span.end);
    match found.last_mut() {
        Some(last) if kind == TokenKind::String && last.kind == kind && last.end == start => last.end = end,
        _ if start < end => found.push(SemanticToken { start, end, kind, modifiers }),
        _ => {}
    }
}

/// Adds a comment line by line: not all editors support multi-line tokens.
fn comment_lines(source: &Source<'_>, comment: &Comment, found: &mut Vec<SemanticToken>) {
    let modifiers = match comment.kind {
        CommentKind::Doc => Modifiers::DOCUMENTATION,
        CommentKind::Line | CommentKind::Block => Modifiers::NONE,
    };
    let mut at = comment.span.start;
    for line in source.slice(comment.span.start, comment.span.end).split_inclusive('\n') {
        let content = line.trim();
        let start = at + (line.len() - line.trim_start().len()) as u32;
        if !content.is_empty() {
            let end = start + content.len() as u32;
            found.push(SemanticToken { start, end, kind: TokenKind::Comment, modifiers });
        }
        at += line.len() as u32;
    }
}

/// Classifies a token other than a name; delimiters and separators have no type.
fn of_kind(kind: Kind, before: Option<Kind>) -> Option<NameMeaning> {
    let kind = match kind {
        Kind::Number => TokenKind::Number,
        Kind::StringOpen | Kind::StringText | Kind::StringClose | Kind::Format => TokenKind::String,
        Kind::Bind => return Some((TokenKind::Operator, Modifiers::SYMBOLIC)),
        Kind::Percent if before == Some(Kind::Number) => {
            return Some((TokenKind::Unit, Modifiers::DEFAULT_LIBRARY));
        }
        Kind::DotDot
        | Kind::Assign
        | Kind::Arrow
        | Kind::FatArrow
        | Kind::Plus
        | Kind::Minus
        | Kind::Star
        | Kind::Slash
        | Kind::Percent
        | Kind::Caret
        | Kind::Less
        | Kind::LessEqual
        | Kind::Greater
        | Kind::GreaterEqual
        | Kind::Equal
        | Kind::NotEqual
        | Kind::And
        | Kind::Or
        | Kind::AndAnd
        | Kind::OrOr
        | Kind::Not => TokenKind::Operator,
        Kind::Identifier
        | Kind::InterpolationOpen
        | Kind::InterpolationClose
        | Kind::OpenParen
        | Kind::CloseParen
        | Kind::OpenBracket
        | Kind::CloseBracket
        | Kind::OpenBrace
        | Kind::CloseBrace
        | Kind::Comma
        | Kind::Semicolon
        | Kind::Colon
        | Kind::Dot => return None,
        _ => TokenKind::Keyword,
    };
    Some((kind, Modifiers::NONE))
}

/// A name and its adjacent tokens.
struct TokenContext<'a> {
    source: &'a Source<'a>,
    index: usize,
}

impl TokenContext<'_> {
    fn kind(&self, index: Option<usize>) -> Option<Kind> {
        Some(self.source.tokens.tokens.get(index?)?.kind)
    }

    fn before(&self) -> Option<Kind> {
        self.kind(self.index.checked_sub(1))
    }

    fn after(&self) -> Option<Kind> {
        self.kind(self.index.checked_add(1))
    }

    /// Returns true if the adjacent tokens indicate the name of an argument.
    fn is_argument(&self) -> bool {
        let opens = match self.before() {
            Some(Kind::Comma) => true,
            Some(Kind::OpenParen) => self.kind(self.index.checked_sub(2)) != Some(Kind::For),
            _ => false,
        };
        opens && matches!(self.after(), Some(Kind::Assign | Kind::Bind))
    }

    /// Classifies a resolved name.
    fn named(&self, name: &Name) -> NameMeaning {
        let none = Modifiers::NONE;
        let argument =
            if !name.declares && !name.writes && self.is_argument() { Modifiers::ARGUMENT } else { none };
        let (kind, modifiers) = match name.kind {
            NameKind::Variable => (TokenKind::Variable, none),
            NameKind::Symbolic => (TokenKind::Variable, Modifiers::SYMBOLIC),
            NameKind::Parameter => (TokenKind::Parameter, argument),
            NameKind::Param => (TokenKind::Variable, Modifiers::PARAM | Modifiers::READONLY),
            NameKind::Output => {
                (TokenKind::Variable, Modifiers::OUTPUT | Modifiers::READONLY | Modifiers::SYMBOLIC)
            }
            NameKind::Function | NameKind::Extern | NameKind::Builtin => (TokenKind::Function, none),
            NameKind::SymbolicFunction => (TokenKind::Function, Modifiers::SYMBOLIC),
            NameKind::Const => (TokenKind::Variable, Modifiers::READONLY),
            NameKind::Record | NameKind::Component => (TokenKind::Struct, none),
            NameKind::Field if argument != none => (TokenKind::Parameter, argument),
            NameKind::Field => (TokenKind::Property, none),
            NameKind::Dimension | NameKind::Enum => (TokenKind::Type, none),
            NameKind::Unit => (TokenKind::Unit, none),
            NameKind::Module => (TokenKind::Namespace, none),
            NameKind::Constant if &*name.text == "Time" => {
                (TokenKind::Variable, Modifiers::READONLY | Modifiers::SYMBOLIC)
            }
            NameKind::Constant => (TokenKind::Variable, Modifiers::READONLY),
        };
        let of_library = name.declared.as_ref().is_none_or(|place| is_library(&place.file));
        let more = [
            (name.declares, Modifiers::DECLARATION),
            (name.writes && !name.declares, Modifiers::MODIFICATION),
            (of_library, Modifiers::DEFAULT_LIBRARY),
        ];
        let more = more.into_iter().filter(|(applies, _)| *applies);
        (kind, more.fold(modifiers, |all, (_, modifier)| all | modifier))
    }

    /// Classifies an unresolved name.
    fn unknown(&self) -> Option<NameMeaning> {
        let kind = match (self.before(), self.after()) {
            (Some(Kind::Number), _) => TokenKind::Unit,
            (_, Some(Kind::OpenParen)) => TokenKind::Function,
            (Some(Kind::Dot), _) => TokenKind::Property,
            _ if self.is_argument() => return Some((TokenKind::Parameter, Modifiers::ARGUMENT)),
            // `was` between a name and its former name.
            (Some(Kind::Identifier), Some(Kind::Identifier)) => TokenKind::Keyword,
            (Some(Kind::In | Kind::Out | Kind::InOut), _) => {
                return Some((TokenKind::Parameter, Modifiers::DECLARATION));
            }
            (Some(Kind::Var), _) => return Some((TokenKind::Variable, Modifiers::DECLARATION)),
            _ => return None,
        };
        Some((kind, Modifiers::NONE))
    }
}

/// Classifies names by their position in the tree: types, labels, unit systems, words of `extern`.
fn written(source: &Source<'_>, range: &Range<u32>) -> HashMap<u32, NameMeaning> {
    let mut found = HashMap::new();
    let statements = &source.tree.module.statements;
    let first = statements.partition_point(|statement| statement.span.end < range.start);
    let touched = statements.iter().skip(first).take_while(|statement| statement.span.start <= range.end);
    for statement in touched {
        Node::Statement(statement).walk(&mut |node| match node {
            Node::Statement(statement) => of_statement(statement, &mut found),
            Node::Type(ty) => of_type(source, ty, &mut found),
            _ => {}
        });
    }
    found
}

fn of_statement(statement: &Stmt, found: &mut HashMap<u32, NameMeaning>) {
    let mut is = |name: &Ident, kind, modifiers| {
        found.insert(name.span.start, (kind, modifiers));
    };
    match &statement.kind {
        StmtKind::Label { label, .. } => is(label, TokenKind::Label, Modifiers::DECLARATION),
        StmtKind::Goto(label) => is(label, TokenKind::Label, Modifiers::NONE),
        StmtKind::Units(system) => is(system, TokenKind::Unit, Modifiers::DEFAULT_LIBRARY),
        StmtKind::Import(path) => {
            let written = path.path.iter().filter(|_| !path.is_quoted);
            written.chain(&path.alias).for_each(|name| is(name, TokenKind::Namespace, Modifiers::NONE));
        }
        StmtKind::Function(function) => {
            if let FunctionBody::Extern { purity: Some(word), .. } = &function.body {
                is(word, TokenKind::Keyword, Modifiers::NONE);
            }
        }
        _ => {}
    }
}

fn of_type(source: &Source<'_>, ty: &TypeExpr, found: &mut HashMap<u32, NameMeaning>) {
    let name = match &ty.kind {
        TypeKind::Name(name) | TypeKind::Apply(name, _) => name,
        TypeKind::Member(module, name) => {
            found.insert(module.span.start, (TokenKind::Namespace, Modifiers::NONE));
            name
        }
        TypeKind::Function(..) => {
            found.insert(ty.span.start, (TokenKind::Type, Modifiers::DEFAULT_LIBRARY));
            return;
        }
        _ => return,
    };
    // Names that the program declares are classified by resolution.
    let shown = slice(source.text, name.span.start, name.span.end);
    let modifiers =
        if shown.starts_with(char::is_uppercase) { Modifiers::DEFAULT_LIBRARY } else { Modifiers::NONE };
    found.insert(name.span.start, (TokenKind::Type, modifiers));
}

/// Difference of two sequences: at `start`, `removed` elements are replaced by those of `inserted`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Difference<T> {
    pub start: usize,
    pub removed: usize,
    pub inserted: Vec<T>,
}

/// Returns the difference of two sequences as one edit; `None` if they are equal.
pub fn difference<T: PartialEq + Clone>(old: &[T], new: &[T]) -> Option<Difference<T>> {
    let start = old.iter().zip(new).take_while(|(a, b)| a == b).count();
    let (old, new) = (old.get(start..).unwrap_or_default(), new.get(start..).unwrap_or_default());
    let same = old.iter().rev().zip(new.iter().rev()).take_while(|(a, b)| a == b).count();
    let (removed, inserted) = (old.len() - same, new.get(..new.len() - same).unwrap_or_default().to_vec());
    (removed > 0 || !inserted.is_empty()).then_some(Difference { start, removed, inserted })
}
