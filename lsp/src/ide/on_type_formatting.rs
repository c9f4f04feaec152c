//! Formatting on typing: of the statement that `;` or `}` ends, and of the new line after a line
//! break.
//!
//! Changes only blanks, and continues comment marks. Indentation follows the existing lines, so
//! that a file with another layout is respected.

use super::formatting::{Change, format_ended};
use super::lines::Lines;
use super::source::Source;
use calyx_lang::lexer::{CommentKind, Kind, Token};

const INDENT: usize = 4;

/// Characters that trigger formatting.
pub const TRIGGERS: [char; 3] = [';', '}', '\n'];

/// Returns the changes after a character was typed directly before a byte.
pub fn typed(source: &Source<'_>, offset: u32, character: char) -> Vec<Change> {
    let lines = Lines::new(source.text);
    match character {
        '\n' => new_line(source, &lines, offset),
        ';' if ends(source, offset, Kind::Semicolon).is_some() => {
            format_ended(source, &lines, offset).unwrap_or_default()
        }
        '}' => {
            let Some(at) = ends(source, offset, Kind::CloseBrace) else { return Vec::new() };
            format_ended(source, &lines, offset).unwrap_or_else(|| align_brace(source, &lines, at))
        }
        _ => Vec::new(),
    }
}

/// Returns the index of the token of a kind that ends at a byte.
fn ends(source: &Source<'_>, offset: u32, kind: Kind) -> Option<usize> {
    let at = source.token_after(offset).checked_sub(1)?;
    let token = source.tokens.tokens.get(at)?;
    (token.kind == kind && token.span.end == offset).then_some(at)
}

/// Aligns a `}` at the start of its line with the statement of its block.
fn align_brace(source: &Source<'_>, lines: &Lines<'_>, at: usize) -> Vec<Change> {
    let Some(token) = source.tokens.tokens.get(at) else { return Vec::new() };
    if !lines.begins(token.span.start) {
        return Vec::new();
    }
    let open = open_brackets(&source.tokens.tokens[..at]);
    let Some(block) = open.iter().rev().find(|open| open.kind == Kind::OpenBrace) else { return Vec::new() };
    let wanted = lines.indentation(lines.line(block.anchor)).to_string();
    indent(source, lines, lines.line(token.span.start), wanted)
}

fn new_line(source: &Source<'_>, lines: &Lines<'_>, offset: u32) -> Vec<Change> {
    let line = lines.line(offset);
    let Some(above) = line.checked_sub(1) else { return Vec::new() };
    let end_above = lines.end(above);
    let comments = &source.tokens.comments;
    let last = comments.partition_point(|comment| comment.span.start < end_above).checked_sub(1);
    if let Some(comment) = last.and_then(|at| comments.get(at)) {
        let start = comment.span.start;
        let own_line = lines.line(start) == above && lines.begins(start);
        let broken = lines.line(start) == above && !lines.content(line).trim().is_empty();
        match comment.kind {
            CommentKind::Doc if own_line || broken => return comment_goes_on(source, lines, above, "/// "),
            CommentKind::Line if broken => return comment_goes_on(source, lines, above, "// "),
            CommentKind::Block if comment.span.end > end_above => {
                return indent(source, lines, line, lines.indentation(above).to_string());
            }
            _ => {}
        }
    }
    let mut changes = case_above(source, lines, above);
    changes.extend(indent(source, lines, line, wanted(source, lines, lines.start(line))));
    changes
}

/// Continues a documentation comment, or a comment that was split in two, on the next line. A
/// second line break, after an empty line of documentation, ends it.
fn comment_goes_on(source: &Source<'_>, lines: &Lines<'_>, above: usize, mark: &str) -> Vec<Change> {
    let below = lines.content(above + 1).trim_start();
    let indentation = lines.indentation(above).to_string();
    let before = above.checked_sub(1).map_or("", |line| lines.content(line).trim());
    if lines.content(above).trim() == "///" && below.is_empty() && before.starts_with("///") {
        let end = lines.end(above + 1);
        return vec![Change { start: lines.start(above), end, replacement: indentation }];
    }
    if below.starts_with(mark.trim_end()) {
        return Vec::new();
    }
    indent(source, lines, above + 1, indentation + mark)
}

/// Aligns `case` and `default`, which are indented less than the statements before them.
fn case_above(source: &Source<'_>, lines: &Lines<'_>, above: usize) -> Vec<Change> {
    let tokens = &source.tokens.tokens;
    let first = tokens.get(source.token_after(lines.start(above)));
    let is_case = first.is_some_and(|token| {
        matches!(token.kind, Kind::Case | Kind::Default) && lines.line(token.span.start) == above
    });
    if !is_case {
        return Vec::new();
    }
    indent(source, lines, above, wanted(source, lines, lines.start(above)))
}

/// Replaces the indentation of a line.
fn indent(source: &Source<'_>, lines: &Lines<'_>, line: usize, wanted: String) -> Vec<Change> {
    let start = lines.start(line);
    let end = start + lines.indentation(line).len() as u32;
    if source.slice(start, end) == wanted {
        return Vec::new();
    }
    vec![Change { start, end, replacement: wanted }]
}

/// An open delimiter, and the indentation of its content.
struct OpenConstruct {
    kind: Kind,
    /// Start of the statement for a block, of the delimiter otherwise.
    anchor: u32,
    /// Start of the incomplete statement in it.
    statement: Option<u32>,
    /// True if it contains a `case`.
    has_case: bool,
}

/// Returns the delimiters that tokens leave open, outermost first; the file itself is a block
/// around all.
fn open_brackets(tokens: &[Token]) -> Vec<OpenConstruct> {
    let mut open = vec![OpenConstruct { kind: Kind::OpenBrace, anchor: 0, statement: None, has_case: false }];
    let mut strings = 0_usize;
    for token in tokens {
        let start = token.span.start;
        match token.kind {
            Kind::StringOpen => strings += 1,
            Kind::StringClose => strings = strings.saturating_sub(1),
            _ => {}
        }
        if strings > 0 && token.kind != Kind::StringOpen {
            continue;
        }
        if let Some(here) = open.last_mut()
            && here.kind == Kind::OpenBrace
            && !matches!(token.kind, Kind::CloseBrace | Kind::Semicolon)
        {
            here.statement.get_or_insert(start);
            here.has_case |= matches!(token.kind, Kind::Case | Kind::Default);
        }
        match token.kind {
            Kind::OpenParen | Kind::OpenBracket => {
                open.push(OpenConstruct {
                    kind: token.kind,
                    anchor: start,
                    statement: None,
                    has_case: false,
                });
            }
            Kind::OpenBrace => {
                let anchor = open.last().and_then(|here| here.statement).unwrap_or(start);
                open.push(OpenConstruct { kind: token.kind, anchor, statement: None, has_case: false });
            }
            Kind::CloseParen | Kind::CloseBracket => {
                let opening =
                    if token.kind == Kind::CloseParen { Kind::OpenParen } else { Kind::OpenBracket };
                // It does not match across the enclosing block.
                let block = open.iter().rposition(|here| here.kind == Kind::OpenBrace);
                let known = open.iter().rposition(|here| here.kind == opening);
                if let Some(at) = known.filter(|at| Some(*at) > block) {
                    open.truncate(at);
                }
            }
            Kind::CloseBrace => {
                if let Some(at) =
                    open.iter().rposition(|here| here.kind == Kind::OpenBrace).filter(|at| *at > 0)
                {
                    open.truncate(at);
                }
                open.last_mut().into_iter().for_each(|here| here.statement = None);
            }
            // The `:` of a case or label; others are in delimiters, as is the `;` of a `for`.
            Kind::Semicolon | Kind::Colon => {
                if let Some(here) = open.last_mut().filter(|here| here.kind == Kind::OpenBrace) {
                    here.statement = None;
                }
            }
            _ => {}
        }
    }
    open
}

/// Returns the indentation of the line that starts at a byte.
fn wanted(source: &Source<'_>, lines: &Lines<'_>, line_start: u32) -> String {
    let tokens = &source.tokens.tokens;
    let at = source.token_after(line_start);
    let before = tokens.get(..at).unwrap_or_default();
    let line = lines.line(line_start);
    let next = tokens.get(at).filter(|token| lines.line(token.span.start) == line).map(|token| token.kind);
    let open = open_brackets(before);
    let depth = open.len();
    let Some(here) = open.last() else { return String::new() };
    let base = lines.indentation(lines.line(here.anchor)).to_string();
    let more = |levels: usize| base.clone() + &" ".repeat(levels * INDENT);
    if here.kind != Kind::OpenBrace {
        let closes = matches!(next, Some(Kind::CloseParen | Kind::CloseBracket));
        return if closes { base } else { more(1) };
    }
    let outside = usize::from(depth > 1);
    match next {
        Some(Kind::CloseBrace) => return base,
        Some(Kind::Case | Kind::Default) => return more(outside),
        _ => {}
    }
    let inside = outside + usize::from(here.has_case);
    let ended = here.statement.is_none();
    more(if ended || next == Some(Kind::OpenBrace) { inside } else { inside + 1 })
}
