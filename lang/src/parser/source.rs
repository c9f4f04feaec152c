//! Properties of the source file that rules need: locations, texts, documentation.

use super::layout::{Layout, is_unmatched};
use crate::ast::Ident;
use crate::hashed::HashMap;
use crate::lexer::{Kind, Token};
use crate::span::{FileId, Span};
use chumsky::span::SimpleSpan;
use std::cell::{Cell, OnceCell};

/// A lexed file. Tokens are accessed by index; an index past the last token denotes the end of the
/// file.
pub(super) struct Source<'a> {
    file: FileId,
    text: &'a str,
    tokens: &'a [Token],
    docs: &'a HashMap<usize, String>,
    /// `true` if the file ends with the last token.
    ends_file: bool,
    /// Index of the first token of the current statement, if it starts with an expression.
    statement: Cell<usize>,
    /// For parentheses and brackets, the innermost open one at each token. Computed on first use.
    openings: OnceCell<[Vec<Option<usize>>; 2]>,
    /// The blocks, computed on first use.
    layout: OnceCell<Layout>,
    /// `true` if some `{` has no `}`; computed on first use.
    unmatched: OnceCell<bool>,
}

/// Kinds of brackets other than those of blocks.
const BRACKETS: [(Kind, Kind); 2] =
    [(Kind::OpenParen, Kind::CloseParen), (Kind::OpenBracket, Kind::CloseBracket)];

impl<'a> Source<'a> {
    pub(super) fn new(
        file: FileId,
        text: &'a str,
        tokens: &'a [Token],
        docs: &'a HashMap<usize, String>,
        ends_file: bool,
    ) -> Self {
        Source {
            file,
            text,
            tokens,
            docs,
            ends_file,
            statement: Cell::new(usize::MAX),
            openings: OnceCell::new(),
            layout: OnceCell::new(),
            unmatched: OnceCell::new(),
        }
    }

    pub(super) fn len(&self) -> usize {
        self.tokens.len()
    }

    pub(super) fn kind(&self, index: usize) -> Option<Kind> {
        self.tokens.get(index).map(|t| t.kind)
    }

    /// Returns the kind of the token before `index`.
    pub(super) fn previous(&self, index: usize) -> Option<Kind> {
        index.checked_sub(1).and_then(|i| self.kind(i))
    }

    /// Returns the source range of a token; past the last token, the end of the file.
    pub(super) fn place(&self, index: usize) -> Span {
        self.tokens.get(index).map_or_else(|| self.after(index), |t| t.span)
    }

    /// Returns the empty range directly after the token before `index`.
    pub(super) fn after(&self, index: usize) -> Span {
        let end = index.min(self.tokens.len()).checked_sub(1).map_or(0, |i| self.tokens[i].span.end as usize);
        Span::new(self.file, end, end)
    }

    /// Returns the source range of tokens, without surrounding blanks.
    pub(super) fn range(&self, tokens: SimpleSpan) -> Span {
        if tokens.start < tokens.end {
            self.place(tokens.start).to(self.place(tokens.end - 1))
        } else {
            self.after(tokens.start)
        }
    }

    pub(super) fn text(&self, index: usize) -> &'a str {
        let span = self.place(index);
        &self.text[span.start as usize..span.end as usize]
    }

    pub(super) fn text_of(&self, span: Span) -> &'a str {
        self.text.get(span.start as usize..span.end as usize).unwrap_or_default()
    }

    pub(super) fn ident(&self, index: usize) -> Ident {
        Ident { name: self.text(index).into(), span: self.place(index) }
    }

    pub(super) fn doc(&self, index: usize) -> Option<String> {
        self.docs.get(&index).cloned()
    }

    pub(super) fn begin_statement(&self, index: usize) {
        self.statement.set(index);
    }

    /// Returns `true` if a token is the first of a statement that starts with an expression.
    pub(super) fn begins_statement(&self, index: usize) -> bool {
        self.statement.get() == index
    }

    /// Returns `true` if a token is on a later line than the previous one.
    pub(super) fn begins_line(&self, index: usize) -> bool {
        let (from, to) = (self.after(index).start as usize, self.place(index).start as usize);
        self.text[from..to.max(from)].contains('\n')
    }

    /// Returns the number of blanks at the start of a token's line.
    pub(super) fn indent(&self, index: usize) -> usize {
        let before = &self.text[..self.place(index).start as usize];
        let line = before.rfind('\n').map_or(0, |end| end + 1);
        self.text[line..].chars().take_while(|c| matches!(c, ' ' | '\t')).count()
    }

    fn is_unmatched(&self) -> bool {
        *self.unmatched.get_or_init(|| is_unmatched(self))
    }

    fn layout(&self) -> &Layout {
        self.layout.get_or_init(|| Layout::new(self, self.is_unmatched()))
    }

    /// Returns `true` if the block of a `{` ends before a token although its `}` is missing.
    pub(super) fn ends_block(&self, open: usize, at: usize) -> bool {
        self.is_unmatched() && self.layout().ends_before(open, at)
    }

    /// Returns `true` if a token directly follows the previous one, without a blank.
    pub(super) fn touches_previous(&self, index: usize) -> bool {
        index > 0 && self.after(index).end == self.place(index).start
    }

    /// Returns the start of the first token after a byte position.
    pub(super) fn next_start(&self, from: u32) -> Option<u32> {
        let index = self.tokens.partition_point(|t| t.span.start < from);
        self.tokens.get(index).map(|t| t.span.start)
    }

    /// Returns `true` if there are only blanks between two byte positions.
    pub(super) fn is_blank(&self, from: u32, to: u32) -> bool {
        self.text.get(from as usize..to as usize).is_some_and(|t| t.trim().is_empty())
    }

    /// Returns the description of a token for messages: its own text if it is short.
    pub(super) fn describe(&self, index: usize) -> String {
        match self.kind(index) {
            None if self.ends_file => "the end of the file".into(),
            None => "the end of the statement".into(),
            Some(Kind::Identifier | Kind::Number) if self.text(index).len() <= 30 => {
                format!("`{}`", self.text(index))
            }
            Some(kind) => kind.describe().into(),
        }
    }

    /// Returns the index after a token; for the start of a string, after the whole string.
    pub(super) fn next(&self, index: usize) -> usize {
        if self.kind(index) != Some(Kind::StringOpen) {
            return index + 1;
        }
        let mut open = 0_usize;
        for (offset, token) in self.tokens[index..].iter().enumerate() {
            match token.kind {
                Kind::StringOpen => open += 1,
                Kind::StringClose => open -= 1,
                _ => {}
            }
            if open == 0 {
                return index + offset + 1;
            }
        }
        self.tokens.len()
    }

    /// Returns the last open bracket before `index` that `close` would close; other kinds of
    /// brackets are ignored.
    pub(super) fn opening(&self, index: usize, close: Kind) -> Option<usize> {
        let index = index.min(self.tokens.len());
        if close == Kind::CloseBrace {
            return self.layout().openings.get(index).copied().flatten();
        }
        let kind = BRACKETS.iter().position(|(_, closes)| *closes == close)?;
        let openings = self.openings.get_or_init(|| BRACKETS.map(|pair| self.openings_of(pair)));
        openings[kind].get(index).copied().flatten()
    }

    fn openings_of(&self, (opens, closes): (Kind, Kind)) -> Vec<Option<usize>> {
        let mut open = Vec::new();
        let mut found = vec![None];
        for (index, token) in self.tokens.iter().enumerate() {
            if token.kind == opens {
                open.push(index);
            } else if token.kind == closes {
                open.pop();
            }
            found.push(open.last().copied());
        }
        found
    }
}
