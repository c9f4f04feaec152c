//! Folding ranges: multi-line delimiters, cases, and consecutive comments or imports.
//!
//! Delimiters are matched on tokens, so that folds persist while a statement is incomplete.

use super::lines::Lines;
use super::source::Source;
use calyx_lang::ast::{Stmt, StmtKind};
use calyx_lang::lexer::{CommentKind, Kind};
use calyx_lang::walk::Node;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FoldKind {
    Code,
    Comment,
    Imports,
}

/// Range from the end of the opening token to the end of the last hidden line. The lines of two
/// folds are disjoint or nested.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fold {
    pub start: u32,
    pub end: u32,
    pub kind: FoldKind,
}

/// Returns the folds of a file, sorted by position.
pub fn folds(source: &Source<'_>) -> Vec<Fold> {
    let lines = Lines::new(source.text);
    let mut folds = brackets(source, &lines);
    comments(source, &lines, &mut folds);
    imports(&source.tree.module.statements, &mut folds);
    for statement in &source.tree.module.statements {
        let mut visit = |node| {
            if let Node::Statement(Stmt { kind: StmtKind::Block(statements), .. }) = node {
                cases(statements, &mut folds);
            }
        };
        Node::Statement(statement).walk(&mut visit);
    }
    nested(folds, &lines)
}

/// Matches delimiters of all kinds that span a line break.
fn brackets(source: &Source<'_>, lines: &Lines<'_>) -> Vec<Fold> {
    let mut folds = Vec::new();
    let mut open: Vec<(Kind, u32)> = Vec::new();
    let mut strings = 0_usize;
    for token in &source.tokens.tokens {
        match token.kind {
            // A string ends on its line, with all delimiters in it.
            Kind::StringOpen => strings += 1,
            Kind::StringClose => strings = strings.saturating_sub(1),
            _ if strings > 0 => {}
            Kind::OpenBrace | Kind::OpenParen | Kind::OpenBracket => open.push((token.kind, token.span.end)),
            Kind::CloseBrace | Kind::CloseParen | Kind::CloseBracket => {
                let opening = opening(token.kind);
                let known = open.iter().rposition(|(kind, _)| *kind == opening);
                // A `)` does not match across the enclosing block.
                let block = open.iter().rposition(|(kind, _)| *kind == Kind::OpenBrace);
                let Some(at) = known.filter(|at| Some(*at) >= block) else { continue };
                let start = open[at].1;
                open.truncate(at);
                let line = lines.line(token.span.start);
                let end = match lines.begins(token.span.start) && line > 0 {
                    true => lines.end(line - 1),
                    false => token.span.start,
                };
                folds.push(Fold { start, end, kind: FoldKind::Code });
            }
            _ => {}
        }
    }
    folds
}

fn opening(close: Kind) -> Kind {
    match close {
        Kind::CloseBrace => Kind::OpenBrace,
        Kind::CloseParen => Kind::OpenParen,
        _ => Kind::OpenBracket,
    }
}

/// Adds multi-line comments, and consecutive line comments of one kind.
fn comments(source: &Source<'_>, lines: &Lines<'_>, folds: &mut Vec<Fold>) {
    let mut run: Option<(CommentKind, u32, u32)> = None;
    for comment in &source.tokens.comments {
        let (start, end) = (comment.span.start, comment.span.end);
        if comment.kind == CommentKind::Block {
            folds.push(Fold { start, end, kind: FoldKind::Comment });
            continue;
        }
        if !lines.begins(start) {
            continue;
        }
        let follows = |last: u32| lines.line(last) + 1 == lines.line(start);
        run = match run {
            Some((kind, first, last)) if kind == comment.kind && follows(last) => Some((kind, first, end)),
            before => {
                folds.extend(before.map(comment_run));
                Some((comment.kind, start, end))
            }
        };
    }
    folds.extend(run.map(comment_run));
}

fn comment_run((_, start, end): (CommentKind, u32, u32)) -> Fold {
    Fold { start, end, kind: FoldKind::Comment }
}

/// Adds consecutive imports.
fn imports(statements: &[Stmt], folds: &mut Vec<Fold>) {
    let is_import = |statement: &Stmt| matches!(statement.kind, StmtKind::Import(_));
    for run in statements.chunk_by(|a, b| is_import(a) && is_import(b)) {
        if let [first, .., last] = run {
            folds.push(Fold { start: first.span.start, end: last.span.end, kind: FoldKind::Imports });
        }
    }
}

/// Adds the statements of each `case` of a block.
fn cases(statements: &[Stmt], folds: &mut Vec<Fold>) {
    let is_case = |statement: &Stmt| matches!(statement.kind, StmtKind::Case { .. } | StmtKind::Default(_));
    for run in statements.chunk_by(|_, next| !is_case(next)) {
        if let ([first, ..], Some(last)) = (run, run.last())
            && is_case(first)
        {
            folds.push(Fold { start: first.span.start, end: last.span.end, kind: FoldKind::Code });
        }
    }
}

/// Returns the folds that hide a line: the largest of several that start on one line, and none that
/// overlaps another.
fn nested(folds: Vec<Fold>, lines: &Lines<'_>) -> Vec<Fold> {
    let with_lines = |fold: Fold| (lines.line(fold.start), lines.line(fold.end), fold);
    let mut folds: Vec<_> = folds.into_iter().map(with_lines).filter(|(from, to, _)| from < to).collect();
    folds.sort_by_key(|(from, to, fold)| (*from, std::cmp::Reverse(*to), fold.start));
    let mut around: Vec<usize> = Vec::new();
    let mut kept: Vec<Fold> = Vec::new();
    let mut last_start = None;
    for (from, to, fold) in folds {
        while around.last().is_some_and(|end| *end < from) {
            around.pop();
        }
        if last_start == Some(from) || around.last().is_some_and(|end| *end < to) {
            continue;
        }
        last_start = Some(from);
        around.push(to);
        kept.push(fold);
    }
    kept
}
