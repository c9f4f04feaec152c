//! Finds the names of a file that are visible at a position. It uses only tokens, so it also works
//! if the text cannot be parsed.
//!
//! Functions, constants and records are visible in their whole block, the variable of a
//! comprehension in its element and its condition, all other names after their declaration.

use crate::analysis::NameKind;
use crate::lexer::{Kind, Token};
use crate::span::Span;

/// A local name that is visible at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Local {
    pub span: Span,
    pub kind: NameKind,
    /// Number of blocks between the position and the declaration: 0 is the innermost block.
    pub level: u32,
}

/// Returns the names of a file that are visible at an offset, innermost first, and later names of a
/// block before earlier ones. Excludes the name at the offset itself.
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
    // A declaration that contains the position is not complete.
    scan.pending.clear();
    let seen = scan.hoisted(split);
    let innermost = scan.scopes.len() - 1;
    let mut found = comprehended(tokens, split);
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

/// Returns the variables of the comprehensions around a token, and the parameters of the anonymous
/// functions, innermost first.
fn comprehended(tokens: &[Token], split: usize) -> Vec<Local> {
    let mut found = Vec::new();
    let mut closed = 0_u32;
    // A comma ends the expression of an anonymous function before it.
    let mut after_comma = false;
    for index in (0..split).rev() {
        match tokens.get(index).map(|token| token.kind) {
            Some(Kind::CloseBracket | Kind::CloseParen) => closed += 1,
            Some(Kind::OpenBracket | Kind::OpenParen) if closed > 0 => closed -= 1,
            Some(kind @ (Kind::OpenBracket | Kind::OpenParen)) => {
                after_comma = false;
                if kind == Kind::OpenBracket {
                    found.extend(comprehension_variable(tokens, index, split));
                }
            }
            Some(Kind::Comma) if closed == 0 => after_comma = true,
            Some(Kind::FatArrow) if closed == 0 && !after_comma => {
                found.extend(anonymous_parameters(&tokens[..index]));
            }
            Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace) => break,
            _ => {}
        }
    }
    found
}

/// Returns the names in the parentheses at the end of tokens, last first.
fn anonymous_parameters(tokens: &[Token]) -> Vec<Local> {
    let before = tokens.iter().rev().skip(1);
    let names = before.take_while(|token| matches!(token.kind, Kind::Identifier | Kind::Comma));
    let names = names.filter(|token| token.kind == Kind::Identifier);
    names.map(|token| Local { span: token.span, kind: NameKind::Parameter, level: 0 }).collect()
}

/// Returns the variable of the comprehension that starts at a bracket, if the token `split` is in
/// its element or in its condition.
fn comprehension_variable(tokens: &[Token], bracket: usize, split: usize) -> Option<Local> {
    let kind = |index: usize| tokens.get(index).map(|token| token.kind);
    let mut open = 0_u32;
    let mut variable = None;
    let mut sees = false;
    for index in bracket + 1..tokens.len() {
        // The values may refer to a name that the variable shadows.
        if index == split {
            sees = variable.is_none() || sees;
        }
        match kind(index) {
            Some(Kind::OpenBracket | Kind::OpenParen) => open += 1,
            Some(Kind::CloseBracket | Kind::CloseParen) if open > 0 => open -= 1,
            Some(Kind::CloseBracket | Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace) | None => break,
            Some(Kind::For) if open == 0 && variable.is_none() && kind(index + 2) == Some(Kind::In) => {
                variable = tokens.get(index + 1).filter(|name| name.kind == Kind::Identifier);
            }
            // A conditional expression starts the values; the condition follows them.
            Some(Kind::If) if open == 0 && variable.is_some() && kind(index - 1) != Some(Kind::In) => {
                sees |= index < split;
            }
            _ => {}
        }
    }
    let span = variable.filter(|_| sees)?.span;
    Some(Local { span, kind: NameKind::Variable, level: 0 })
}

#[derive(Default)]
struct Scope {
    names: Vec<(Span, NameKind)>,
    /// `true` for the head of a function, loop or handler without a body yet: a brace starts the
    /// body, a semicolon is an empty body.
    head: bool,
    /// Number of open brackets at its start.
    depth: u32,
}

struct Scan<'t> {
    tokens: &'t [Token],
    scopes: Vec<Scope>,
    /// Names whose declaration is not complete.
    pending: Vec<(Span, NameKind)>,
    /// Number of open parentheses and square brackets.
    depth: u32,
}

impl Scan<'_> {
    fn kind(&self, index: usize) -> Option<Kind> {
        self.tokens.get(index).map(|token| token.kind)
    }

    fn name(&self, index: usize) -> Option<Span> {
        self.tokens.get(index).filter(|token| token.kind == Kind::Identifier).map(|token| token.span)
    }

    /// Returns the index after a declared name and its former name: `teeth was lugs`.
    fn after_name(&self, index: usize) -> usize {
        let renamed = self.name(index + 1).and(self.name(index + 2)).is_some();
        if renamed { index + 3 } else { index + 1 }
    }

    /// Returns `true` for the `for` of a comprehension, `for x in xs`; a loop has a parenthesis.
    fn is_comprehension(&self, index: usize) -> bool {
        self.kind(index) == Some(Kind::For) && self.name(index + 1).is_some()
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

    /// Processes the token at `index` and the following tokens that belong to it; returns the index
    /// of the next token.
    fn token(&mut self, index: usize, end: usize) -> usize {
        let Some(kind) = self.kind(index) else { return index + 1 };
        // The start of a statement ends an incomplete declaration.
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
                // Brackets that are open before a block do not extend into it.
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
            Kind::Const | Kind::Record | Kind::Enum | Kind::Dimension | Kind::Unit => {
                if let Some(span) = self.name(index + 1) {
                    self.declare(span, hoisted_kind(kind));
                }
                // The fields of a record are not names of the enclosing block.
                let after = self.after_name(index + 1);
                if kind == Kind::Record && self.kind(after) == Some(Kind::OpenBrace) {
                    self.open();
                }
                return after;
            }
            Kind::Import => {
                let mut last = index + 1;
                while self.kind(last + 1) == Some(Kind::Dot) && self.name(last + 2).is_some() {
                    last += 2;
                }
                // `import module as name` declares the second name.
                if self.name(last + 1).is_some() && self.name(last + 2).is_some() {
                    last += 2;
                }
                self.pending.extend(self.name(last).map(|span| (span, NameKind::Module)));
                return last + 1;
            }
            Kind::Function | Kind::Component => {
                if let Some(span) = self.name(index + 1) {
                    self.declare(span, hoisted_kind(kind));
                }
                self.open();
                return self.parameters(self.after_name(index + 1), end);
            }
            Kind::For if !self.is_comprehension(index) => {
                self.open();
                self.loop_variable(index, end);
            }
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

    /// Declares the variable of the loop `for (x in xs)` for its body.
    fn loop_variable(&mut self, index: usize, end: usize) {
        if self.kind(index + 1) != Some(Kind::OpenParen) || self.kind(index + 3) != Some(Kind::In) {
            return;
        }
        let mut open = 0_u32;
        for at in index + 1..end {
            match self.kind(at) {
                Some(Kind::OpenParen) => open += 1,
                Some(Kind::CloseParen) => open -= 1,
                Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace) | None => return,
                _ => {}
            }
            if open == 0 {
                if let Some(span) = self.name(index + 2) {
                    self.declare(span, NameKind::Variable);
                }
                return;
            }
        }
    }

    /// Closes the heads whose body was a single statement.
    fn close_heads(&mut self) {
        while self.scopes.len() > 1 && self.scopes.last().is_some_and(|scope| scope.head) {
            self.scopes.pop();
        }
    }

    /// Reads `a = 1, b := 2` after `var`, up to the first expression.
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
                Some(kind) if kind.begins_statement() && !self.is_comprehension(index) => break,
                Some(_) => {}
            }
            index += 1;
        }
        index
    }

    /// Reads the parameters of a function, which are visible in its body.
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
                        let symbolic = self.kind(self.after_name(index)) == Some(Kind::Bind);
                        let kind = if symbolic { NameKind::Symbolic } else { NameKind::Parameter };
                        self.declare(span, kind);
                    }
                    expected = false;
                }
                // The parentheses are not closed.
                Some(Kind::OpenBrace | Kind::Semicolon) | None => return index,
                Some(_) => expected = false,
            }
            index += 1;
        }
        index
    }

    /// Returns names that are declared after the position but visible there: scope, name, and kind.
    fn hoisted(&mut self, from: usize) -> Vec<(usize, Span, NameKind)> {
        let mut found = Vec::new();
        let mut open = self.scopes.len() - 1;
        // Names in blocks that start after the position are not visible.
        let mut inner = 0_u32;
        for index in from..self.tokens.len() {
            match self.kind(index) {
                Some(Kind::OpenBrace) => inner += 1,
                Some(Kind::CloseBrace) if inner > 0 => inner -= 1,
                Some(Kind::CloseBrace) => open = open.saturating_sub(1),
                Some(
                    kind @ (Kind::Function
                    | Kind::Component
                    | Kind::Const
                    | Kind::Record
                    | Kind::Enum
                    | Kind::Dimension
                    | Kind::Unit),
                ) if inner == 0 => {
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
        Kind::Enum => NameKind::Enum,
        Kind::Component => NameKind::Component,
        Kind::Dimension => NameKind::Dimension,
        Kind::Unit => NameKind::Unit,
        _ => NameKind::Function,
    }
}
