//! Traverses tokens and comments while a tree is printed.
//!
//! Tokens are copied from the text in order; a token that differs from the tree stops the printing.
//! Comments keep their positions: after code on its line, on separate lines, or between two tokens.

use super::document::{Breaks, Item};
use crate::lexer::{Comment, CommentKind, Kind, Token, Tokens};
use std::collections::BTreeSet;

pub(super) struct Printer<'t> {
    text: &'t str,
    tokens: &'t [Token],
    comments: &'t [Comment],
    /// Index of the next token.
    at: usize,
    /// Index of the next comment.
    comment_at: usize,
    items: Vec<Item<'t>>,
    /// `true` if tree and tokens did not match.
    lost: bool,
    /// Units that the file declares, which are formatted like built-in ones.
    pub(super) units: BTreeSet<String>,
}

/// The line breaks between the items of a bracket.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    /// One item per line, with the closing bracket after the last item.
    Each,
    /// One item per line, with the closing bracket on a separate line.
    EachClosed,
    /// As many items as fit on a line.
    Filled,
    /// The bracket is adjacent to its only item, which breaks inside.
    Hugged,
}

impl<'t> Printer<'t> {
    pub(super) fn new(text: &'t str, tokens: &'t Tokens, units: BTreeSet<String>) -> Self {
        Printer {
            text,
            tokens: &tokens.tokens,
            comments: &tokens.comments,
            at: 0,
            comment_at: 0,
            items: Vec::new(),
            lost: false,
            units,
        }
    }

    /// Returns the document; `None` if the tree did not match the tokens.
    pub(super) fn finish(mut self) -> Option<Vec<Item<'t>>> {
        self.comments();
        let complete = self.at == self.tokens.len() && self.comment_at == self.comments.len();
        (complete && !self.lost).then_some(self.items)
    }

    pub(super) fn kind(&self) -> Option<Kind> {
        self.kind_after(0)
    }

    /// Returns the text of the next token.
    pub(super) fn word(&self) -> Option<&'t str> {
        let span = self.tokens.get(self.at)?.span;
        self.text.get(span.start as usize..span.end as usize)
    }

    /// Returns the kind of a later token.
    pub(super) fn kind_after(&self, distance: usize) -> Option<Kind> {
        self.tokens.get(self.at + distance).map(|t| t.kind)
    }

    /// Returns the kind of the last written token.
    pub(super) fn previous(&self) -> Option<Kind> {
        self.at.checked_sub(1).and_then(|i| self.tokens.get(i)).map(|t| t.kind)
    }

    pub(super) fn item(&mut self, item: Item<'t>) {
        self.items.push(item);
    }

    pub(super) fn space(&mut self) {
        self.item(Item::Space);
    }

    pub(super) fn line(&mut self) {
        self.item(Item::Line);
    }

    /// Writes `inside` as a group that breaks at all its breaks, with later lines indented.
    pub(super) fn group(&mut self, inside: impl FnOnce(&mut Self)) {
        self.open();
        self.item(Item::Indent);
        inside(self);
        self.item(Item::Dedent);
        self.item(Item::Close);
    }

    /// Opens a group that breaks at all its breaks. Comments before it are outside the group and do
    /// not break it.
    pub(super) fn open(&mut self) {
        self.comments();
        self.item(Item::Open(Breaks::All));
    }

    /// Writes the next token, which must have this kind.
    pub(super) fn token(&mut self, kind: Kind) {
        let Some(token) = self.tokens.get(self.at).filter(|t| t.kind == kind) else {
            self.lost = true;
            return;
        };
        // A separator directly follows the item that it ends; comments before it are written after
        // it.
        let separates = matches!(kind, Kind::Comma | Kind::Semicolon);
        if !(separates && self.comments_may_follow()) {
            self.comments();
        }
        self.write(token.span.start, token.span.end);
        self.at += 1;
    }

    /// Writes the next token.
    pub(super) fn any_token(&mut self) {
        match self.kind() {
            Some(kind) => self.token(kind),
            None => self.lost = true,
        }
    }

    /// Copies a string from its opening to its closing quote.
    pub(super) fn string(&mut self) {
        self.comments();
        let Some(first) = self.tokens.get(self.at) else {
            self.lost = true;
            return;
        };
        let mut open = 0_usize;
        while let Some(token) = self.tokens.get(self.at) {
            match token.kind {
                Kind::StringOpen => open += 1,
                Kind::StringClose => open = open.saturating_sub(1),
                _ => {}
            }
            self.at += 1;
            if open == 0 {
                self.write(first.span.start, token.span.end);
                // Comments inside were copied with the string.
                while self.comments.get(self.comment_at).is_some_and(|c| c.span.start < token.span.end) {
                    self.comment_at += 1;
                }
                return;
            }
        }
        self.lost = true;
    }

    fn write(&mut self, start: u32, end: u32) {
        match self.text.get(start as usize..end as usize) {
            Some(text) => self.item(Item::Text(text)),
            None => self.lost = true,
        }
    }

    /// Writes a bracket with items separated by commas.
    pub(super) fn bracket<T>(
        &mut self,
        (open, close): (Kind, Kind),
        items: &[T],
        layout: Layout,
        mut write: impl FnMut(&mut Self, &T),
    ) {
        self.token(open);
        if items.is_empty() {
            self.item(Item::Indent);
            self.comments();
            self.item(Item::Dedent);
            self.token(close);
            return;
        }
        let hugged = layout == Layout::Hugged && !self.comment_ahead();
        self.item(Item::Open(Breaks::All));
        if !hugged {
            self.item(Item::Indent);
            self.item(Item::SoftLine);
        }
        if layout == Layout::Filled {
            self.item(Item::Open(Breaks::Filled));
        }
        for (index, item) in items.iter().enumerate() {
            if index > 0 {
                self.token(Kind::Comma);
                self.line();
            }
            write(self, item);
        }
        // A trailing comma is allowed, but not printed.
        if self.kind() == Some(Kind::Comma) {
            self.at += 1;
        }
        self.comments();
        if layout == Layout::Filled {
            self.item(Item::Close);
        }
        if !hugged {
            self.item(Item::Dedent);
        }
        if layout == Layout::EachClosed {
            self.item(Item::SoftLine);
        }
        self.item(Item::Close);
        self.token(close);
    }

    /// Starts a statement or another item with separate lines; an empty line before it is
    /// preserved.
    pub(super) fn begin_item(&mut self) {
        let start = self.tokens.get(self.at).map_or(self.text.len() as u32, |t| t.span.start);
        // Comments before it determine the empty lines themselves.
        let empty = !self.comment_ahead() && self.empty_line(self.end_before(start), start);
        self.item(if empty { Item::EmptyLine } else { Item::HardLine });
    }

    /// Returns `true` if a comment precedes the next token.
    pub(super) fn comment_ahead(&self) -> bool {
        let next = self.tokens.get(self.at).map_or(u32::MAX, |t| t.span.start);
        self.comments.get(self.comment_at).is_some_and(|c| c.span.start < next)
    }

    /// Returns `true` if there is a line end between the next token and a byte.
    pub(super) fn spans_lines(&self, until: u32) -> bool {
        let Some(token) = self.tokens.get(self.at) else { return false };
        self.line_ends(token.span.start, until) > 0
    }

    /// Returns `true` if the comments before the next token may move after it: the last one ends
    /// its line, and none is documentation, which would then document the following item.
    fn comments_may_follow(&self) -> bool {
        let Some(token) = self.tokens.get(self.at) else { return true };
        let rest = self.comments.get(self.comment_at..).unwrap_or_default();
        let before = &rest[..rest.iter().take_while(|c| c.span.start < token.span.start).count()];
        before.iter().all(|c| c.kind != CommentKind::Doc)
            && before.last().is_none_or(|c| self.line_ends(c.span.end, token.span.start) > 0)
    }

    /// Returns `true` if a comment and those after it on its line are the last on the line before
    /// the next token, and the index of the first comment that was not examined.
    fn ends_line(&self, comment: usize, next_token: u32) -> (bool, usize) {
        let mut index = comment;
        while let Some(c) = self.comments.get(index).filter(|c| c.span.start < next_token) {
            index += 1;
            let next = self.comments.get(index).map_or(next_token, |c| c.span.start.min(next_token));
            if self.line_ends(c.span.end, next) > 0 || next as usize == self.text.len() {
                return (true, index);
            }
        }
        (false, index)
    }

    /// Writes the comments before the next token.
    pub(super) fn comments(&mut self) {
        let next_token = self.tokens.get(self.at).map_or(self.text.len() as u32, |t| t.span.start);
        // No text can follow a line comment on its line.
        let mut line_is_full = false;
        let (mut ends_line, mut known_before) = (false, 0);
        while let Some(comment) = self.comments.get(self.comment_at).filter(|c| c.span.start < next_token) {
            let (start, end) = (comment.span.start, comment.span.end);
            if self.comment_at >= known_before {
                (ends_line, known_before) = self.ends_line(self.comment_at, next_token);
            }
            self.comment_at += 1;
            let next =
                self.comments.get(self.comment_at).map_or(next_token, |c| c.span.start.min(next_token));
            // A line ends between the last statement of a block and its `}`.
            let ends_line = ends_line
                || self.kind() == Some(Kind::CloseBrace) && self.previous() == Some(Kind::Semicolon);
            let previous = self.end_before(start);
            let begins_line = previous == 0
                || self.line_ends(previous, start) > 0
                || line_is_full
                // It documents the item below.
                || comment.kind == CommentKind::Doc;
            let line = |empty| if empty { Item::EmptyLine } else { Item::HardLine };
            let before = line(self.empty_line(previous, start));
            let Some(text) = self.text.get(start as usize..end as usize) else { continue };
            if !ends_line {
                self.between(text, begins_line.then_some(before), next < next_token);
            } else if begins_line {
                self.items.extend([before, Item::Text(text), line(self.empty_line(end, next))]);
            } else {
                self.items.extend([Item::Trailing(text), line(self.empty_line(end, next))]);
            }
            line_is_full = comment.kind != CommentKind::Block;
        }
    }

    /// Writes a comment between two tokens, or between a token and another comment.
    fn between(&mut self, text: &'t str, line: Option<Item<'t>>, comment_follows: bool) {
        if let Some(line) = line {
            self.item(line);
        }
        if !matches!(self.previous(), Some(Kind::OpenParen | Kind::OpenBracket)) {
            self.space();
        }
        self.item(Item::Text(text));
        let closes = matches!(
            self.kind(),
            Some(Kind::CloseParen | Kind::CloseBracket | Kind::Comma | Kind::Semicolon)
        );
        if comment_follows || !closes {
            self.space();
        }
    }

    /// Returns the end of the token or comment before a byte; 0 at the start.
    fn end_before(&self, start: u32) -> u32 {
        let token = self.tokens.partition_point(|t| t.span.end <= start).checked_sub(1);
        let comment = self.comments.partition_point(|c| c.span.end <= start).checked_sub(1);
        let token = token.map_or(0, |i| self.tokens[i].span.end);
        token.max(comment.map_or(0, |i| self.comments[i].span.end))
    }

    /// Returns `true` if there is an empty line between two bytes.
    fn empty_line(&self, from: u32, to: u32) -> bool {
        let between = self.text.get(from as usize..to as usize).unwrap_or_default();
        let mut ends = between.split('\n');
        // The text before the first and after the last line end is on lines that are not empty.
        ends.next();
        ends.next_back();
        ends.any(|line| line.trim().is_empty())
    }

    fn line_ends(&self, from: u32, to: u32) -> usize {
        self.text.get(from as usize..to as usize).map_or(0, |between| between.matches('\n').count())
    }
}
