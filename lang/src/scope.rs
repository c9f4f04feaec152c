//! Which names of its own file a place can see, from tokens alone, so that it works where there is no tree yet.
//!
//! Functions, constants and records are seen in their whole block, everything else from the end of its declaration on.

use crate::analysis::NameKind;
use crate::lexer::{Kind, Token};
use crate::span::Span;

/// A name declared around a place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local {
    pub span: Span,
    pub kind: NameKind,
    /// Blocks between the place and the declaration: 0 is the innermost block.
    pub level: u32,
}

/// The names of a file that are seen at an offset, innermost first, the later of one block before the earlier. A name that is
/// being written at the offset is not among them.
pub fn visible(tokens: &[Token], offset: u32) -> Vec<Local> {
    let mut scan = Scan { tokens, scopes: vec![Scope::default()], pending: Vec::new(), depth: 0 };
    let mut split = tokens.partition_point(|token| token.span.end <= offset);
    if let Some(last) = split.checked_sub(1)
        && tokens.get(last).is_some_and(|token| token.kind == Kind::Identifier && token.span.end == offset)
    {
        split = last;
    }
    let mut index = 0;
    while index < split {
        index = scan.token(index, split);
    }
    // A declaration that the place lies in has not been made yet.
    scan.pending.clear();
    let seen = scan.hoisted(split);
    let innermost = scan.scopes.len() - 1;
    let mut found = Vec::new();
    for (at, scope) in scan.scopes.iter().enumerate().rev() {
        let level = (innermost - at) as u32;
        let later = seen.iter().filter(|(scope, ..)| *scope == at).map(|(_, span, kind)| (*span, *kind));
        let own = scope.names.iter().copied().chain(later);
        let mut own: Vec<Local> = own.map(|(span, kind)| Local { span, kind, level }).collect();
        own.reverse();
        found.extend(own);
    }
    found
}

#[derive(Default)]
struct Scope {
    names: Vec<(Span, NameKind)>,
    /// Of the head of a function, loop or handler whose body has not begun: a brace opens the body, a semicolon is one.
    head: bool,
    /// Brackets that were open where it began.
    depth: u32,
}

struct Scan<'t> {
    tokens: &'t [Token],
    scopes: Vec<Scope>,
    /// Names whose declaration has not ended.
    pending: Vec<(Span, NameKind)>,
    /// Open parentheses and square brackets.
    depth: u32,
}

impl Scan<'_> {
    fn kind(&self, index: usize) -> Option<Kind> {
        self.tokens.get(index).map(|token| token.kind)
    }

    fn name(&self, index: usize) -> Option<Span> {
        self.tokens.get(index).filter(|token| token.kind == Kind::Identifier).map(|token| token.span)
    }

    fn declare(&mut self, span: Span, kind: NameKind) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.names.push((span, kind));
        }
    }

    fn settle(&mut self) {
        if let Some(scope) = self.scopes.last_mut() {
            scope.names.append(&mut self.pending);
        }
    }

    fn open(&mut self) {
        self.scopes.push(Scope { names: Vec::new(), head: true, depth: self.depth });
    }

    /// Takes the token at `index`, and those after it that belong to it; gives the index of the next.
    fn token(&mut self, index: usize, end: usize) -> usize {
        let Some(kind) = self.kind(index) else { return index + 1 };
        // Where a declaration was left open, the next statement begins without it.
        if kind.begins_statement() && self.depth == self.scopes.last().map_or(0, |scope| scope.depth) {
            self.settle();
        }
        match kind {
            Kind::OpenParen | Kind::OpenBracket => self.depth += 1,
            Kind::CloseParen | Kind::CloseBracket => self.depth = self.depth.saturating_sub(1),
            Kind::OpenBrace => {
                self.settle();
                match self.scopes.last_mut() {
                    Some(scope) if scope.head => scope.head = false,
                    _ => self.scopes.push(Scope::default()),
                }
                // Brackets left open before a block belong to no expression that goes on in it.
                self.depth = 0;
            }
            Kind::CloseBrace => {
                self.settle();
                self.close_heads();
                if self.scopes.len() > 1 {
                    self.scopes.pop();
                }
                self.depth = 0;
                self.close_heads();
            }
            Kind::Semicolon => {
                self.settle();
                if self.scopes.last().is_some_and(|scope| scope.depth >= self.depth) {
                    self.close_heads();
                }
            }
            Kind::Var => return self.variables(index + 1, end),
            Kind::Param | Kind::Output => {
                let named = if kind == Kind::Param { NameKind::Param } else { NameKind::Output };
                self.pending.extend(self.name(index + 1).map(|span| (span, named)));
                return index + 2;
            }
            Kind::Const | Kind::Record | Kind::Dimension | Kind::Unit => {
                if let Some(span) = self.name(index + 1) {
                    self.declare(span, hoisted_kind(kind));
                }
                // The fields of a record are no names of a block.
                if kind == Kind::Record && self.kind(index + 2) == Some(Kind::OpenBrace) {
                    self.open();
                }
                return index + 2;
            }
            Kind::Import => {
                let mut last = index + 1;
                while self.kind(last + 1) == Some(Kind::Dot) && self.name(last + 2).is_some() {
                    last += 2;
                }
                self.pending.extend(self.name(last).map(|span| (span, NameKind::Module)));
                return last + 1;
            }
            Kind::Function => {
                if let Some(span) = self.name(index + 1) {
                    self.declare(span, NameKind::Function);
                }
                self.open();
                return self.parameters(index + 2, end);
            }
            Kind::For => self.open(),
            Kind::Catch => {
                self.open();
                if self.kind(index + 1) == Some(Kind::OpenParen)
                    && let Some(span) = self.name(index + 2)
                {
                    self.declare(span, NameKind::Variable);
                }
            }
            _ => {}
        }
        index + 1
    }

    /// Heads whose body was a single statement end with it.
    fn close_heads(&mut self) {
        while self.scopes.len() > 1 && self.scopes.last().is_some_and(|scope| scope.head) {
            self.scopes.pop();
        }
    }

    /// `a = 1, b := 2` after `var`, as far as the first expression.
    fn variables(&mut self, mut index: usize, end: usize) -> usize {
        let around = self.depth;
        let mut expected = true;
        while index < end {
            match self.kind(index) {
                Some(Kind::Identifier) if expected => {
                    let symbolic = self.kind(index + 1) == Some(Kind::Bind);
                    let kind = if symbolic { NameKind::Symbolic } else { NameKind::Variable };
                    self.pending.extend(self.name(index).map(|span| (span, kind)));
                    expected = false;
                }
                Some(Kind::OpenParen | Kind::OpenBracket) => self.depth += 1,
                Some(Kind::CloseParen | Kind::CloseBracket) if self.depth > around => self.depth -= 1,
                Some(Kind::Comma) if self.depth == around => {
                    self.settle();
                    expected = true;
                }
                Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace | Kind::CloseParen) | None => break,
                Some(kind) if kind.begins_statement() => break,
                Some(_) => {}
            }
            index += 1;
        }
        index
    }

    /// The parameters of a function, which its body sees.
    fn parameters(&mut self, mut index: usize, end: usize) -> usize {
        if self.kind(index) != Some(Kind::OpenParen) {
            return index;
        }
        let mut depth = 0_u32;
        let mut expected = false;
        while index < end {
            match self.kind(index) {
                Some(Kind::OpenParen | Kind::OpenBracket) => {
                    depth += 1;
                    expected = depth == 1;
                }
                Some(Kind::CloseParen | Kind::CloseBracket) => {
                    depth -= 1;
                    if depth == 0 {
                        return index + 1;
                    }
                }
                Some(Kind::Comma) => expected = depth == 1,
                Some(Kind::In | Kind::Out | Kind::InOut) if expected => {}
                Some(Kind::Identifier) if expected => {
                    if let Some(span) = self.name(index) {
                        let symbolic = self.kind(index + 1) == Some(Kind::Bind);
                        let kind = if symbolic { NameKind::Symbolic } else { NameKind::Parameter };
                        self.declare(span, kind);
                    }
                    expected = false;
                }
                // The parentheses were never closed.
                Some(Kind::OpenBrace | Kind::Semicolon) | None => return index,
                Some(_) => expected = false,
            }
            index += 1;
        }
        index
    }

    /// What is declared after the place and yet seen from it: scope, name, and kind.
    fn hoisted(&mut self, from: usize) -> Vec<(usize, Span, NameKind)> {
        let mut found = Vec::new();
        let mut open = self.scopes.len() - 1;
        // Blocks opened after the place hide what is in them.
        let mut inner = 0_u32;
        for index in from..self.tokens.len() {
            match self.kind(index) {
                Some(Kind::OpenBrace) => inner += 1,
                Some(Kind::CloseBrace) if inner > 0 => inner -= 1,
                Some(Kind::CloseBrace) => open = open.saturating_sub(1),
                Some(kind @ (Kind::Function | Kind::Const | Kind::Record | Kind::Dimension | Kind::Unit))
                    if inner == 0 =>
                {
                    found.extend(self.name(index + 1).map(|span| (open, span, hoisted_kind(kind))));
                }
                _ => {}
            }
        }
        found
    }
}

fn hoisted_kind(kind: Kind) -> NameKind {
    match kind {
        Kind::Const => NameKind::Const,
        Kind::Record => NameKind::Record,
        Kind::Dimension => NameKind::Dimension,
        Kind::Unit => NameKind::Unit,
        _ => NameKind::Function,
    }
}
