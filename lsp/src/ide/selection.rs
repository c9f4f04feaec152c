//! Selection ranges: token, argument, call, expression by precedence, statement, block, item, file.

use super::lines::slice;
use super::source::Source;
use calyx_lang::ast::{Stmt, StmtKind};
use calyx_lang::lexer::{CommentKind, Kind};
use calyx_lang::walk::Node;

type Range = (u32, u32);

/// Returns ranges around a byte, each inside the next; the last is the whole file.
pub fn selections(source: &Source<'_>, offset: u32) -> Vec<Range> {
    let offset = offset.min(source.text.len() as u32);
    let mut ranges = Vec::new();
    let (token, strings) = words(source, offset);
    ranges.extend(token);
    ranges.extend(strings);
    let mut inside = brackets(source, offset);
    // From the file inwards.
    let mut path = Vec::new();
    let statements = &source.tree.module.statements;
    let documented = documented(source, offset);
    let at = statements.partition_point(|statement| statement.span.end < documented);
    // At the border of two adjacent statements, the cursor is in the later one.
    let mut touching = statements.iter().skip(at).take(2).filter(|s| s.span.start <= documented);
    if let Some(statement) = touching.next_back() {
        descend(source, Node::Statement(statement), documented, &mut path);
    }
    path.reverse();
    ranges.append(&mut path);
    ranges.append(&mut inside);
    ranges.push((0, source.text.len() as u32));
    growing(ranges, offset)
}

/// Returns the ranges around a byte, from the smallest to the largest, each strictly inside the
/// next.
fn growing(mut ranges: Vec<Range>, offset: u32) -> Vec<Range> {
    ranges.retain(|(start, end)| *start <= offset && offset <= *end);
    ranges.sort_by_key(|(start, end)| (end - start, *start));
    let mut kept: Vec<Range> = Vec::new();
    for range in ranges {
        let inner = kept.last().copied().unwrap_or((offset, offset));
        let grows = range.0 <= inner.0 && inner.1 <= range.1 && (range != inner || kept.is_empty());
        if grows {
            kept.push(range);
        }
    }
    kept
}

/// Returns the start of the item documented by the comment at a byte; otherwise the byte.
fn documented(source: &Source<'_>, offset: u32) -> u32 {
    let comments = &source.tokens.comments;
    let at = comments.partition_point(|comment| comment.span.end < offset);
    let comment = comments.get(at).filter(|comment| comment.span.start <= offset);
    let next = source.tokens.tokens.get(source.token_after(offset)).map(|token| token.span.start);
    match (comment, next) {
        (Some(comment), Some(next)) if comment.kind == CommentKind::Doc => {
            if source.with_documentation(next) <= comment.span.start { next } else { offset }
        }
        _ => offset,
    }
}

fn descend(source: &Source<'_>, node: Node<'_>, offset: u32, path: &mut Vec<Range>) {
    let range = node.range();
    match node {
        Node::Statement(statement) => {
            path.push((source.with_documentation(statement.span.start), statement.span.end));
            path.push(range);
            // `else if` is inside the first `if`; the content of braces is a separate range.
            if let StmtKind::Block(statements) = &statement.kind
                && let [first, .., last] | [first @ last] = statements.as_slice()
            {
                path.push((source.with_documentation(first.span.start), last.span.end));
            }
        }
        Node::Argument(_) | Node::Parameter(_) => {
            path.push((with_words_before(source, range.0), range.1));
        }
        Node::Field(_) => path.extend([(range.0, after_semicolon(source, range.1)), range]),
        Node::Expression(_) | Node::Variable(_) | Node::Domain(_) | Node::Type(_) | Node::Name(_) => {
            path.push(range);
        }
    }
    let mut next = None;
    node.children(&mut |child| {
        let (start, end) = child.range();
        if start <= offset && offset <= end && (start < end || next.is_none()) {
            // At the border of two nodes, the later one.
            next = Some(child);
        }
    });
    if let Some(child) = next {
        descend(source, child, offset, path);
    }
}

/// Extends a range by the `in` of a parameter or the `..` of an argument, which the tree does not
/// include.
fn with_words_before(source: &Source<'_>, start: u32) -> u32 {
    let before = source.tokens.tokens.partition_point(|token| token.span.end <= start).checked_sub(1);
    let token = before.and_then(|at| source.tokens.tokens.get(at));
    let belongs = |kind| matches!(kind, Kind::In | Kind::Out | Kind::InOut | Kind::DotDot);
    token.filter(|token| belongs(token.kind)).map_or(start, |token| token.span.start)
}

fn after_semicolon(source: &Source<'_>, end: u32) -> u32 {
    let next = source.tokens.tokens.get(source.token_after(end));
    next.filter(|token| token.kind == Kind::Semicolon).map_or(end, |token| token.span.end)
}

/// Returns the word, token or comment at a byte, and the strings and comments around it.
fn words(source: &Source<'_>, offset: u32) -> (Vec<Range>, Vec<Range>) {
    let tokens = &source.tokens.tokens;
    let (mut found, mut around) = (Vec::new(), Vec::new());
    let comments = &source.tokens.comments;
    let at = comments.partition_point(|comment| comment.span.end < offset);
    if let Some(comment) = comments.get(at).filter(|comment| comment.span.start <= offset) {
        found.extend(word(source.text, comment.span.start, comment.span.end, offset));
        found.push((comment.span.start, comment.span.end));
        around.extend(comment_run(source, at));
        return (found, around);
    }
    // Prefers a word at the border of two adjacent tokens.
    let first = tokens.partition_point(|token| token.span.end < offset);
    let touching = tokens.iter().skip(first).take_while(|token| token.span.start <= offset);
    let is_word = |kind: Kind| matches!(kind, Kind::Identifier | Kind::Number | Kind::StringText);
    let token =
        touching.filter(|token| token.span.start < token.span.end).max_by_key(|token| is_word(token.kind));
    if let Some(token) = token {
        if token.kind == Kind::StringText {
            found.extend(word(source.text, token.span.start, token.span.end, offset));
        }
        found.push((token.span.start, token.span.end));
    }
    around.extend(string_content(source, offset));
    (found, around)
}

/// Returns the range of consecutive comments with the comment `at`.
fn comment_run(source: &Source<'_>, at: usize) -> Option<Range> {
    let comments = &source.tokens.comments;
    let adjacent = |a: usize, b: usize| {
        let (Some(a), Some(b)) = (comments.get(a), comments.get(b)) else { return false };
        let between = source.slice(a.span.end, b.span.start);
        a.kind == b.kind
            && a.kind != CommentKind::Block
            && between.trim().is_empty()
            && between.matches('\n').count() == 1
    };
    let first = (1..=at).rev().take_while(|i| adjacent(i - 1, *i)).last().map_or(at, |i| i - 1);
    let last = (at..comments.len()).take_while(|i| adjacent(*i, i + 1)).last().map_or(at, |i| i + 1);
    Some((comments.get(first)?.span.start, comments.get(last)?.span.end))
}

/// Returns the content of the string around a byte.
fn string_content(source: &Source<'_>, offset: u32) -> Option<Range> {
    let tokens = &source.tokens.tokens;
    let line_start = source.slice(0, offset).rfind('\n').map_or(0, |at| at as u32 + 1);
    let from = tokens.partition_point(|token| token.span.start < line_start);
    let mut open = Vec::new();
    for token in tokens.iter().skip(from) {
        match token.kind {
            Kind::StringOpen if token.span.end <= offset => open.push(token.span.end),
            Kind::StringOpen => return None,
            Kind::StringClose => {
                let start = open.pop()?;
                if offset <= token.span.start {
                    return Some((start, token.span.start));
                }
            }
            _ if token.span.start > offset && open.is_empty() => return None,
            _ => {}
        }
    }
    None
}

/// Returns the run of letters and digits around a byte.
fn word(text: &str, start: u32, end: u32, offset: u32) -> Option<Range> {
    let part = |c: char| c.is_alphanumeric() || c == '_';
    let before = slice(text, start, offset);
    let after = slice(text, offset, end);
    let from = before.trim_end_matches(part).len() as u32 + start;
    let to = offset + (after.len() - after.trim_start_matches(part).len()) as u32;
    (from < to).then_some((from, to))
}

/// Returns the delimiters around a byte inside its statement, with and without the delimiters
/// themselves.
fn brackets(source: &Source<'_>, offset: u32) -> Vec<Range> {
    let tokens = &source.tokens.tokens;
    let statement = source.tree.module.statements.iter();
    let around = statement_around(statement, offset).unwrap_or((0, source.text.len() as u32));
    let from = tokens.partition_point(|token| token.span.start < around.0);
    let mut open: Vec<(Kind, Range)> = Vec::new();
    let mut found = Vec::new();
    for token in tokens.iter().skip(from).take_while(|token| token.span.start < around.1) {
        match token.kind {
            Kind::OpenBrace | Kind::OpenParen | Kind::OpenBracket => {
                open.push((token.kind, (token.span.start, token.span.end)));
            }
            Kind::CloseBrace | Kind::CloseParen | Kind::CloseBracket => {
                let matching = match token.kind {
                    Kind::CloseBrace => Kind::OpenBrace,
                    Kind::CloseParen => Kind::OpenParen,
                    _ => Kind::OpenBracket,
                };
                let Some(at) = open.iter().rposition(|(kind, _)| *kind == matching) else { continue };
                let (start, inner_start) = open[at].1;
                open.truncate(at);
                let inner = source.slice(inner_start, token.span.start);
                let lead = (inner.len() - inner.trim_start().len()) as u32;
                let content = (inner_start + lead, inner_start + lead + inner.trim().len() as u32);
                found.extend([content, (start, token.span.end)]);
            }
            _ => {}
        }
    }
    found
}

fn statement_around<'t>(mut statements: impl Iterator<Item = &'t Stmt>, offset: u32) -> Option<Range> {
    let found = statements.find(|statement| statement.span.start <= offset && offset <= statement.span.end);
    found.map(|statement| (statement.span.start, statement.span.end))
}
