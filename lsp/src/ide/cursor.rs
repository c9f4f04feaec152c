//! Context of a cursor in the token stream: its word, the statement and delimiters around it, and
//! the enclosing calls.
//!
//! Completion and signature help are requested in incomplete statements, for which the syntax tree
//! has little information. Therefore this module scans the tokens backwards from the cursor, to a
//! token that certainly starts a statement.

mod calls;

pub use calls::{Call, WrittenArgument};

use calyx_lang::lexer::{CommentKind, Kind, Token, Tokens};
use std::ops::Range;

/// A cursor in the token stream of a text.
pub struct CursorContext<'a> {
    pub text: &'a str,
    tokens: &'a [Token],
    /// Number of tokens before the word at the cursor, or before the cursor if there is no word.
    pub before: usize,
    /// Whole word at the cursor; empty if there is none.
    pub word: Range<usize>,
    pub offset: usize,
}

/// Region around the cursor in which no names are offered.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CursorRegion {
    Code,
    Comment,
    /// In a number or directly after its digits.
    Number,
    /// Between the quotes of a string: the range of its text, `None` if the string has
    /// interpolations.
    Text(Option<Range<usize>>),
}

/// A delimiter that is open at the cursor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OpenDelimiter {
    /// Its token index.
    pub at: usize,
    pub kind: Bracket,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bracket {
    /// `f(`
    Call,
    /// `if (`, `while (`
    Condition,
    /// `switch (`
    Switch,
    /// `for (`
    For,
    /// `catch (`
    Catch,
    /// `function f(`
    Parameters,
    /// `(` of an expression
    Group,
    /// `a[`
    Index,
    /// `[` of a list
    List,
    /// `in [`
    Choices,
    /// `"{`
    Interpolation,
}

/// The statement around a cursor, up to the cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// Its first token.
    pub start: usize,
    /// Delimiters open in it, innermost first.
    pub open: Vec<OpenDelimiter>,
}

/// A `{` of statements or fields that is open at the cursor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Block {
    pub kind: BlockKind,
    /// First token of its construct: `function`, `for`, `catch`, `record`, ...
    pub head: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BlockKind {
    Function,
    Loop,
    Switch,
    Try,
    Catch,
    Record,
    Plain,
}

impl<'a> CursorContext<'a> {
    pub fn new(text: &'a str, tokens: &'a Tokens, offset: usize) -> Self {
        let tokens = tokens.tokens.as_slice();
        let before = tokens.partition_point(|token| (token.span.start as usize) < offset);
        let mut around = CursorContext { text, tokens, before, word: offset..offset, offset };
        if let Some(last) = before.checked_sub(1)
            && around.range(last).end >= offset
            && around.is_word(last)
        {
            around.word = around.range(last);
            around.before = last;
        }
        around
    }

    pub fn kind(&self, at: usize) -> Option<Kind> {
        self.tokens.get(at).map(|token| token.kind)
    }

    /// Returns the kind of the previous token.
    pub fn previous(&self, at: usize) -> Option<Kind> {
        at.checked_sub(1).and_then(|at| self.kind(at))
    }

    /// Returns the byte range of a token; the end of the text if there is no such token.
    pub fn range(&self, at: usize) -> Range<usize> {
        let end = self.text.len();
        self.tokens.get(at).map_or(end..end, |token| token.span.start as usize..token.span.end as usize)
    }

    /// Returns the token that starts at an offset, or the next one.
    pub fn token_at(&self, offset: usize) -> usize {
        self.tokens.partition_point(|token| (token.span.start as usize) < offset)
    }

    pub fn source(&self, at: usize) -> &'a str {
        self.text.get(self.range(at)).unwrap_or_default()
    }

    /// Returns the token after the word at the cursor.
    pub fn next(&self) -> usize {
        if self.word.is_empty() { self.before } else { self.before + 1 }
    }

    fn is_under_cursor(&self, at: usize) -> bool {
        !self.word.is_empty() && at == self.before
    }

    /// Returns the word at the cursor, up to the cursor.
    pub fn prefix(&self) -> &'a str {
        self.text.get(self.word.start..self.offset).unwrap_or_default()
    }

    /// Returns true if there is a line break before a token.
    pub fn begins_line(&self, at: usize) -> bool {
        let Some(previous) = at.checked_sub(1) else { return true };
        self.text.get(self.range(previous).end..self.range(at).start).is_none_or(|gap| gap.contains('\n'))
    }

    /// Returns true if there is a line break before the word at the cursor, or before the cursor.
    pub fn cursor_begins_line(&self) -> bool {
        let Some(previous) = self.before.checked_sub(1) else { return true };
        self.text.get(self.range(previous).end..self.word.start).is_none_or(|gap| gap.contains('\n'))
    }

    /// Returns the number of blanks at the start of the line of an offset.
    pub fn indentation(&self, offset: usize) -> usize {
        let before = self.text.get(..offset).unwrap_or_default();
        let line = before.rfind('\n').map_or(0, |end| end + 1);
        let rest = self.text.get(line..).unwrap_or_default();
        rest.len() - rest.trim_start_matches([' ', '\t']).len()
    }

    fn is_word(&self, at: usize) -> bool {
        self.source(at).starts_with(|c: char| c.is_alphabetic() || c == '_')
            && !matches!(self.kind(at), Some(Kind::StringText | Kind::Format))
    }

    /// Returns the region of the cursor.
    pub fn standing(&self, tokens: &Tokens) -> CursorRegion {
        let offset = self.offset;
        let comments = &tokens.comments;
        let last = comments.partition_point(|comment| (comment.span.start as usize) < offset);
        if let Some(comment) = last.checked_sub(1).and_then(|last| comments.get(last)) {
            let end = comment.span.end as usize;
            let open = match comment.kind {
                CommentKind::Block => {
                    let closed = self.text.get(..end).is_some_and(|text| text.ends_with("*/"));
                    offset < end || (!closed && offset == end)
                }
                // Blanks after the number belong to it.
                _ => self.text.get(end..offset.max(end)).is_some_and(|rest| !rest.contains('\n')),
            };
            if open {
                return CursorRegion::Comment;
            }
        }
        let begun = self.tokens.partition_point(|token| (token.span.start as usize) < offset);
        let Some(last) = begun.checked_sub(1) else { return CursorRegion::Code };
        match self.kind(last) {
            Some(Kind::Number) if self.range(last).end >= offset => CursorRegion::Number,
            Some(Kind::StringOpen | Kind::StringText | Kind::InterpolationClose) => {
                CursorRegion::Text(self.plain_text(last))
            }
            _ => CursorRegion::Code,
        }
    }

    /// Returns the range of the text of the string around a token, if the string has no
    /// interpolations.
    fn plain_text(&self, at: usize) -> Option<Range<usize>> {
        let open = if self.kind(at) == Some(Kind::StringText) { at.checked_sub(1)? } else { at };
        let mut close = open + 1;
        if self.kind(open) != Some(Kind::StringOpen) {
            return None;
        }
        if self.kind(close) == Some(Kind::StringText) {
            close += 1;
        }
        (self.kind(close) == Some(Kind::StringClose)).then(|| self.range(open).end..self.range(close).start)
    }

    /// Returns the opening token of the string around the cursor.
    pub fn string_open(&self) -> Option<usize> {
        let begun = self.tokens.partition_point(|token| (token.span.start as usize) < self.offset);
        (0..begun).rev().take(2).find(|&at| self.kind(at) == Some(Kind::StringOpen))
    }

    /// Returns the opening delimiter of the closing one at `at`.
    pub fn opening(&self, at: usize) -> Option<usize> {
        let mut depth = 0_usize;
        for index in (0..=at).rev() {
            match self.kind(index)? {
                Kind::CloseParen | Kind::CloseBracket | Kind::CloseBrace | Kind::StringClose => depth += 1,
                Kind::OpenParen | Kind::OpenBracket | Kind::OpenBrace | Kind::StringOpen => {
                    depth = depth.checked_sub(1)?;
                    if depth == 0 {
                        return Some(index);
                    }
                }
                _ => {}
            }
        }
        None
    }

    /// Returns the statement around the token before `end`.
    pub fn statement(&self, end: usize) -> Statement {
        let mut open: Vec<OpenDelimiter> = Vec::new();
        // Start of the statement if the line above is a statement without its `;`.
        let mut unended: Option<(usize, usize)> = None;
        let mut at = end;
        while let Some(index) = at.checked_sub(1) {
            let Some(kind) = self.kind(index) else { break };
            match kind {
                Kind::CloseParen | Kind::CloseBracket | Kind::StringClose => {
                    // An unmatched closing delimiter is skipped.
                    at = self.opening(index).filter(|&open| !self.ends_between(open, index)).unwrap_or(index);
                    continue;
                }
                Kind::OpenParen | Kind::OpenBracket => {
                    if let Some((line, known)) = unended
                        && self.indentation(self.range(line).start)
                            <= self.indentation(self.range(index).start)
                    {
                        open.truncate(known);
                        return self.begun(line, open, end);
                    }
                    unended = None;
                    open.push(OpenDelimiter { at: index, kind: self.bracket(index) });
                }
                Kind::InterpolationOpen => {
                    open.push(OpenDelimiter { at: index, kind: Bracket::Interpolation });
                    // The text before it belongs to the same string.
                    at = self.string_of(index);
                    continue;
                }
                Kind::Semicolon => match self.for_header(index) {
                    Some(paren) => {
                        open.push(OpenDelimiter { at: paren, kind: Bracket::For });
                        return Statement { start: index + 1, open };
                    }
                    None => break,
                },
                Kind::OpenBrace | Kind::CloseBrace => break,
                _ if kind.begins_statement() => {
                    at = index;
                    break;
                }
                _ => {}
            }
            let operands = matches!(kind, Kind::Identifier | Kind::If)
                && index > 0
                && self.begins_line(index)
                && self.ends_expression(index - 1);
            if operands && unended.is_none() {
                unended = Some((index, open.len()));
            }
            at = index;
        }
        if let Some((line, known)) = unended {
            open.truncate(known);
            return self.begun(line, open, end);
        }
        self.begun(at, open, end)
    }

    /// Skips labels and the headers of `if`, `while`, ... before a statement.
    fn begun(&self, mut start: usize, open: Vec<OpenDelimiter>, end: usize) -> Statement {
        let outermost = open.last().map_or(end, |open| open.at.min(end));
        while start < outermost {
            let next = match self.kind(start) {
                Some(Kind::Else | Kind::Do | Kind::Try) => Some(start + 1),
                Some(kind @ (Kind::If | Kind::While | Kind::For | Kind::Switch | Kind::Catch)) => {
                    let body = self.closing(start + 1, outermost).map(|close| close + 1);
                    // The `else` branch, if the first branch lacks its `;`.
                    let other = (kind == Kind::If
                        && body.is_some_and(|body| self.kind(body) != Some(Kind::If)))
                    .then(|| (start..outermost).find(|&at| self.kind(at) == Some(Kind::Else)))
                    .flatten();
                    other.or(body)
                }
                Some(Kind::Case) => self.colon(start, outermost).map(|colon| colon + 1),
                Some(Kind::Default) if self.kind(start + 1) == Some(Kind::Colon) => Some(start + 2),
                Some(Kind::Identifier)
                    if self.kind(start + 1) == Some(Kind::Colon)
                        && self.block(start).is_none_or(|block| block.kind != BlockKind::Record) =>
                {
                    Some(start + 2)
                }
                _ => None,
            };
            match next {
                Some(next) if next <= outermost => start = next,
                _ => break,
            }
        }
        Statement { start, open }
    }

    /// Returns the closing delimiter of the one at `open`, before `end`.
    fn closing(&self, open: usize, end: usize) -> Option<usize> {
        let mut depth = 0_usize;
        for index in open..end {
            match self.kind(index)? {
                Kind::OpenParen | Kind::OpenBracket | Kind::StringOpen => depth += 1,
                Kind::CloseParen | Kind::CloseBracket | Kind::StringClose => {
                    depth = depth.checked_sub(1)?;
                    if depth == 0 {
                        return Some(index);
                    }
                }
                _ if depth == 0 => return None,
                _ => {}
            }
        }
        None
    }

    /// Returns the `:` of a `case`, before `end`.
    fn colon(&self, case: usize, end: usize) -> Option<usize> {
        (case..end).find(|&index| self.kind(index) == Some(Kind::Colon))
    }

    /// Returns true if a statement ends between two delimiters, so that they are no pair. Ignores
    /// the semicolons in the header of a `for`.
    fn ends_between(&self, open: usize, close: usize) -> bool {
        let header = self.previous(open) == Some(Kind::For);
        (open + 1..close).any(|index| match self.kind(index) {
            Some(Kind::Semicolon) => !header,
            Some(Kind::OpenBrace | Kind::CloseBrace) => true,
            _ => false,
        })
    }

    /// Returns the `(` of the `for` header with this `;`.
    fn for_header(&self, semicolon: usize) -> Option<usize> {
        let mut index = semicolon;
        while let Some(before) = index.checked_sub(1) {
            match self.kind(before)? {
                Kind::CloseParen | Kind::CloseBracket | Kind::StringClose => {
                    index = self.opening(before)?;
                    continue;
                }
                Kind::OpenParen => return (self.previous(before) == Some(Kind::For)).then_some(before),
                Kind::OpenBracket | Kind::OpenBrace | Kind::CloseBrace | Kind::InterpolationOpen => {
                    return None;
                }
                _ => index = before,
            }
        }
        None
    }

    /// Returns the opening token of the string with the interpolation that starts at `at`.
    fn string_of(&self, at: usize) -> usize {
        let mut depth = 0_usize;
        for index in (0..at).rev() {
            match self.kind(index) {
                Some(Kind::StringClose) => depth += 1,
                Some(Kind::StringOpen) if depth == 0 => return index,
                Some(Kind::StringOpen) => depth -= 1,
                _ => {}
            }
        }
        0
    }

    fn bracket(&self, at: usize) -> Bracket {
        let previous = self.previous(at);
        if self.kind(at) == Some(Kind::OpenBracket) {
            return match previous {
                Some(Kind::In) => Bracket::Choices,
                Some(Kind::Identifier | Kind::CloseParen | Kind::CloseBracket) if !self.begins_line(at) => {
                    Bracket::Index
                }
                _ => Bracket::List,
            };
        }
        match previous {
            Some(Kind::If | Kind::While) => Bracket::Condition,
            Some(Kind::Switch) => Bracket::Switch,
            Some(Kind::For) => Bracket::For,
            Some(Kind::Catch) => Bracket::Catch,
            Some(Kind::Identifier) if at >= 2 && self.kind(at - 2) == Some(Kind::Function) => {
                Bracket::Parameters
            }
            Some(Kind::Function) => Bracket::Parameters,
            Some(Kind::Identifier) => Bracket::Call,
            _ => Bracket::Group,
        }
    }

    /// Returns true if an expression may end with the token.
    pub fn ends_expression(&self, at: usize) -> bool {
        self.kind(at).is_some_and(Kind::ends_expression)
    }

    /// Returns the blocks around a token, innermost first.
    pub fn blocks(&self, before: usize) -> impl Iterator<Item = Block> {
        let mut depth = 0_usize;
        let mut at = before;
        std::iter::from_fn(move || {
            while let Some(index) = at.checked_sub(1) {
                at = index;
                match self.kind(index)? {
                    Kind::CloseBrace => depth += 1,
                    Kind::OpenBrace if depth > 0 => depth -= 1,
                    Kind::OpenBrace => return Some(self.block_at(index)),
                    // These occur at the top level only: a brace above them is unclosed.
                    Kind::Import | Kind::Units | Kind::Param | Kind::Output
                        if depth == 0 && self.begins_line(index) =>
                    {
                        at = 0;
                        return None;
                    }
                    _ => {}
                }
            }
            None
        })
    }

    /// Returns the innermost block around a token.
    pub fn block(&self, before: usize) -> Option<Block> {
        self.blocks(before).next()
    }

    fn block_at(&self, brace: usize) -> Block {
        let plain = Block { kind: BlockKind::Plain, head: brace };
        let Some(last) = brace.checked_sub(1) else { return plain };
        match self.kind(last) {
            Some(Kind::Do) => return Block { kind: BlockKind::Loop, head: last },
            Some(Kind::Try) => return Block { kind: BlockKind::Try, head: last },
            Some(Kind::Identifier) if self.previous(last) == Some(Kind::Record) => {
                return Block { kind: BlockKind::Record, head: last - 1 };
            }
            Some(Kind::CloseParen) => {
                if let Some(head) = self.opening(last).and_then(|open| open.checked_sub(1)) {
                    let kind = match self.kind(head) {
                        Some(Kind::For | Kind::While) => Some(BlockKind::Loop),
                        Some(Kind::Switch) => Some(BlockKind::Switch),
                        Some(Kind::Catch) => Some(BlockKind::Catch),
                        _ => None,
                    };
                    if let Some(kind) = kind {
                        return Block { kind, head };
                    }
                    if matches!(self.previous(head), Some(Kind::Function | Kind::Component)) {
                        return Block { kind: BlockKind::Function, head: head - 1 };
                    }
                }
            }
            _ => {}
        }
        // `function f(...) -> Length {`
        let within = |&index: &usize| {
            !matches!(self.kind(index), Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace))
        };
        let mut head = (0..brace).rev().take_while(within);
        match head.find(|&index| self.kind(index) == Some(Kind::Function)) {
            Some(head) => Block { kind: BlockKind::Function, head },
            None => plain,
        }
    }
}
