//! Labels and `goto`; loops, `switch` and functions with their exits.

use calyx_lang::ast::{FunctionBody, Ident, Module, Stmt, StmtKind};
use calyx_lang::declared::children;
use calyx_lang::span::Span;

/// A label with all `goto`s to it.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    pub declared: Span,
    pub jumps: Vec<Span>,
}

/// Returns the label referred to at an offset.
pub fn label_at(module: &Module, offset: u32) -> Option<Label> {
    let mut found = Found { labels: Vec::new(), blocks: Vec::new() };
    found.block(&module.statements);
    let here = |span: &Span| span.start <= offset && offset <= span.end;
    found.labels.into_iter().find(|label| here(&label.declared) || label.jumps.iter().any(here))
}

struct Found {
    labels: Vec<Label>,
    /// Indices of the labels in the enclosing blocks, by name; the labels outside a function are
    /// not visible in it.
    blocks: Vec<Vec<(String, usize)>>,
}

impl Found {
    fn block(&mut self, statements: &[Stmt]) {
        let mut own = Vec::new();
        for mut statement in statements {
            while let StmtKind::Label { label, statement: inner } = &statement.kind {
                own.push((label.name.to_string(), self.labels.len()));
                self.labels.push(Label { declared: label.span, jumps: Vec::new() });
                statement = inner;
            }
        }
        self.blocks.push(own);
        statements.iter().for_each(|statement| self.statement(statement));
        self.blocks.pop();
    }

    fn statement(&mut self, statement: &Stmt) {
        match &statement.kind {
            StmtKind::Goto(name) => self.jump(name),
            StmtKind::Block(all) => self.block(all),
            StmtKind::Function(decl) => {
                let around = std::mem::take(&mut self.blocks);
                if let FunctionBody::Statement(body) = &decl.body {
                    self.statement(body);
                }
                self.blocks = around;
            }
            _ => children(statement).into_iter().for_each(|inner| self.statement(inner)),
        }
    }

    fn jump(&mut self, name: &Ident) {
        let mut blocks = self.blocks.iter().rev().flatten();
        let target = blocks.find(|(label, _)| *label == name.name).map(|(_, index)| *index);
        if let Some(label) = target.and_then(|index| self.labels.get_mut(index)) {
            label.jumps.push(name.span);
        }
    }
}

/// Returns the keywords of the loop, `switch` or function of the `break`, `continue` or `return` at
/// an offset, or that starts there: its own keyword first, then its exits and `continue`s.
pub fn exits_at(module: &Module, offset: u32) -> Vec<Span> {
    let mut scan = Exits { offset, open: Vec::new(), found: Vec::new() };
    module.statements.iter().for_each(|statement| scan.statement(statement));
    scan.found
}

/// Construct with exits.
struct OpenBlock {
    words: Vec<Span>,
    function: bool,
    /// True for loops, which accept `continue`.
    is_loop: bool,
}

struct Exits {
    offset: u32,
    open: Vec<OpenBlock>,
    found: Vec<Span>,
}

impl Exits {
    fn statement(&mut self, statement: &Stmt) {
        let start = statement.span.start;
        let word = |length: usize| Span { end: start + length as u32, ..statement.span };
        let opened = match &statement.kind {
            StmtKind::For { .. } | StmtKind::ForEach { .. } => Some((word("for".len()), false, true)),
            StmtKind::While { .. } => Some((word("while".len()), false, true)),
            StmtKind::DoWhile { .. } => Some((word("do".len()), false, true)),
            StmtKind::Switch { .. } => Some((word("switch".len()), false, false)),
            StmtKind::Function(decl) => {
                let start = decl.name.span.start.saturating_sub("function ".len() as u32);
                Some((Span { start, end: start + "function".len() as u32, ..decl.name.span }, true, false))
            }
            _ => None,
        };
        match &statement.kind {
            StmtKind::Break => self.leave(word("break".len()), |open| !open.function),
            StmtKind::Continue => self.leave(word("continue".len()), |open| open.is_loop),
            StmtKind::Return(_) => self.leave(word("return".len()), |open| open.function),
            _ => {}
        }
        if let Some((word, function, is_loop)) = opened {
            self.open.push(OpenBlock { words: vec![word], function, is_loop });
        }
        children(statement).into_iter().for_each(|inner| self.statement(inner));
        if opened.is_some()
            && let Some(open) = self.open.pop()
            && open.words.iter().any(|word| word.start <= self.offset && self.offset <= word.end)
        {
            self.found = open.words;
        }
    }

    fn leave(&mut self, word: Span, what: impl Fn(&OpenBlock) -> bool) {
        // Only `return` can leave a function.
        let inner = self.open.iter().rposition(|open| open.function).unwrap_or(0);
        let target =
            self.open.iter_mut().enumerate().rev().find(|(index, open)| *index >= inner && what(open));
        if let Some((_, open)) = target {
            open.words.push(word);
        }
    }
}
