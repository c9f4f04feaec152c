//! Incremental parsing: splits a file into pieces that are parsed independently, so that an edit
//! affects only the pieces that it touches.
//!
//! A piece is a top-level statement with the comments and blanks above it; if brackets or keywords
//! are missing, it may contain several statements. The result of a piece depends only on its own
//! text. Adjacent pieces are first parsed together, which is faster; pieces with errors are then
//! parsed again individually. The result therefore does not depend on which pieces were parsed
//! together.

use super::parse_run;
use crate::ast::Stmt;
use crate::diagnostic::Diagnostic;
use crate::lexer::{Kind, Token, Tokens, lex};
use crate::relocate;
use crate::span::FileId;
use crate::threads;
use std::ops::Range;
use std::sync::Arc;

/// The parsed form of a piece. Locations are relative to the start of the piece, in file 0.
#[derive(Debug, Default, PartialEq)]
pub struct Chunk {
    pub statements: Vec<Stmt>,
    /// Syntax errors.
    pub problems: Vec<Diagnostic>,
}

/// A piece and its position.
#[derive(Clone, Debug)]
pub struct PlacedChunk {
    pub range: Range<usize>,
    pub piece: Arc<Chunk>,
}

/// Returns the pieces of a text. `kept` returns cached pieces by text; it is not called for the
/// last piece, which contains the end of the file.
pub fn pieces(text: &str, tokens: &Tokens, kept: impl Fn(&str) -> Option<Arc<Chunk>>) -> Vec<PlacedChunk> {
    pieces_on(text, tokens, kept, threads::for_text)
}

/// As [`pieces`]; `threads` returns the number of threads for a length of text.
fn pieces_on(
    text: &str,
    tokens: &Tokens,
    kept: impl Fn(&str) -> Option<Arc<Chunk>>,
    threads: impl Fn(usize) -> usize,
) -> Vec<PlacedChunk> {
    let ranges = split(&tokens.tokens);
    let slice = |range: &Range<usize>| text.get(range.clone()).unwrap_or_default();
    let inner = ranges.iter().take(ranges.len().saturating_sub(1)).map(|range| kept(slice(range)));
    let mut found: Vec<Option<Arc<Chunk>>> = inner.collect();
    found.resize(ranges.len(), None);
    let mut at = 0;
    while at < ranges.len() {
        let run = (at..ranges.len()).take_while(|index| found[*index].is_none()).count();
        let ends_file = at + run == ranges.len();
        // A new text is parsed as a whole. An invalid token may reach beyond its piece.
        let all = (run == ranges.len() && tokens.diagnostics.is_empty()).then_some(tokens);
        let (own, to) = (&ranges[at..at + run], &mut found[at..at + run]);
        let bytes = own.first().zip(own.last()).map_or(0, |(first, last)| last.end - first.start);
        parse_in_parts(text, (all, ends_file), own, to, threads(bytes));
        at += run.max(1);
    }
    let placed = ranges.into_iter().zip(found);
    placed.map(|(range, piece)| PlacedChunk { range, piece: piece.unwrap_or_default() }).collect()
}

/// Parses adjacent pieces; many pieces in parts, each on a thread of its own. Arguments as for
/// [`parse_together`].
fn parse_in_parts(
    text: &str,
    (all, ends_file): (Option<&Tokens>, bool),
    mut ranges: &[Range<usize>],
    mut found: &mut [Option<Arc<Chunk>>],
    threads: usize,
) {
    let (Some(first), Some(last)) = (ranges.first(), ranges.last()) else { return };
    if threads < 2 {
        return parse_together(text, (all, ends_file), ranges, found);
    }
    let (start, bytes) = (first.start, last.end - first.start);
    let mut parts = Vec::with_capacity(threads);
    for part in 1..=threads {
        let end = start + bytes * part / threads;
        let count =
            if part == threads { ranges.len() } else { ranges.partition_point(|range| range.start < end) };
        let (own, others) = ranges.split_at(count);
        let (to, rest) = std::mem::take(&mut found).split_at_mut(count);
        (ranges, found) = (others, rest);
        parts.push((own, to, ends_file && others.is_empty()));
    }
    threads::for_each(parts, threads, |(ranges, found, ends_file)| {
        let (Some(first), Some(last)) = (ranges.first(), ranges.last()) else { return };
        let tokens = all.map(|all| part_of(all, first.start - start..last.end - start));
        parse_together(text, (tokens.as_ref(), ends_file), ranges, found);
    });
}

/// Returns the tokens of a part of a text. Their locations are relative to the start of the part.
fn part_of(all: &Tokens, bytes: Range<usize>) -> Tokens {
    let index = |at: usize| all.tokens.partition_point(|token| (token.span.start as usize) < at);
    let range = index(bytes.start)..index(bytes.end);
    let moved = |token: &Token| {
        let mut token = *token;
        token.span.start -= bytes.start as u32;
        token.span.end -= bytes.start as u32;
        token
    };
    let docs = all.docs.iter().filter(|(at, _)| range.contains(at));
    Tokens {
        tokens: all.tokens[range.clone()].iter().map(moved).collect(),
        docs: docs.map(|(at, doc)| (at - range.start, doc.clone())).collect(),
        ..Tokens::default()
    }
}

/// Parses adjacent pieces together. `all` are the tokens of the text if these are all its pieces.
fn parse_together(
    text: &str,
    (all, ends_file): (Option<&Tokens>, bool),
    ranges: &[Range<usize>],
    found: &mut [Option<Arc<Chunk>>],
) {
    let (Some(first), Some(last)) = (ranges.first(), ranges.last()) else { return };
    let slice = |range: Range<usize>| text.get(range).unwrap_or_default();
    let run = slice(first.start..last.end);
    let own;
    let tokens = match all {
        Some(all) => all,
        None => {
            own = lex(FileId(0), run);
            &own
        }
    };
    let (statements, problems) = parse_run(run, tokens, ends_file);
    if let [only] = found {
        *only = Some(Arc::new(Chunk { statements, problems }));
        return;
    }
    let mut statements = statements.into_iter().peekable();
    let mut problems = problems.iter().map(|problem| problem.primary.span.start as usize).peekable();
    let mut at = 0;
    for (range, found) in ranges.iter().zip(found) {
        let (start, end) = (range.start - first.start, range.end - first.start);
        // Earlier statements belong to a piece that is parsed individually.
        while statements.next_if(|statement| (statement.span.start as usize) < start).is_some() {}
        let mut own = Vec::new();
        while let Some(statement) = statements.next_if(|statement| (statement.span.start as usize) < end) {
            own.push(statement);
        }
        while problems.next_if(|at| *at < start).is_some() {}
        // An error at its end is reported at the next token.
        let after = tokens.tokens.partition_point(|token| (token.span.start as usize) < end);
        let next = tokens.tokens.get(after).map_or(end, |token| token.span.start as usize);
        let faulty = problems.peek().is_some_and(|at| *at <= next);
        while tokens.tokens.get(at).is_some_and(|token| (token.span.start as usize) < start) {
            at += 1;
        }
        let begins = tokens.tokens.get(at).map(|token| token.span.start);
        let whole = match own.as_slice() {
            [only] => Some(only.span.start) == begins && only.span.end as usize == end,
            _ => false,
        };
        *found = Some(Arc::new(if whole && !faulty {
            for statement in &mut own {
                let to = statement.span.start - start as u32;
                relocate::to(statement, FileId(0), to);
            }
            Chunk { statements: own, problems: Vec::new() }
        } else {
            let alone = slice(range.clone());
            let ends_file = ends_file && range.end == last.end;
            let (statements, problems) = parse_run(alone, &lex(FileId(0), alone), ends_file);
            Chunk { statements, problems }
        }));
    }
}

/// Splits tokens at the ends of top-level statements.
fn split(tokens: &[Token]) -> Vec<Range<usize>> {
    let mut ranges = Vec::new();
    let (mut start, mut end) = (0, 0);
    let mut open = OpenBlock::default();
    for (index, token) in tokens.iter().enumerate() {
        end = token.span.end as usize;
        let next = tokens.get(index + 1).map(|token| token.kind);
        if open.ends(token.kind, next) {
            ranges.push(start..end);
            start = end;
            open = OpenBlock::default();
        }
    }
    if end > start {
        ranges.push(start..end);
    }
    ranges
}

/// The open constructs of a statement.
#[derive(Default)]
struct OpenBlock {
    /// Number of open blocks.
    braces: usize,
    /// Open parentheses outside of blocks, each with the number of semicolons that may still occur
    /// in it: two in the head of a `for`.
    parentheses: Vec<u8>,
    /// The previous token.
    previous: Option<Kind>,
    /// Number of `do` without their `while`, outside of blocks.
    loops: usize,
}

impl OpenBlock {
    /// Processes a token. Returns `true` if the statement ends with it.
    fn ends(&mut self, kind: Kind, next: Option<Kind>) -> bool {
        let previous = self.previous.replace(kind);
        let outside = self.braces == 0;
        match kind {
            Kind::OpenBrace => {
                // Parentheses contain no blocks, so they were left open.
                self.parentheses.clear();
                self.braces += 1;
            }
            Kind::CloseBrace => {
                self.parentheses.clear();
                self.braces = self.braces.saturating_sub(1);
                return self.braces == 0 && !self.goes_on(next);
            }
            Kind::OpenParen if outside => {
                self.parentheses.push(if previous == Some(Kind::For) { 2 } else { 0 })
            }
            Kind::CloseParen if outside => {
                self.parentheses.pop();
            }
            Kind::Do if outside => self.loops += 1,
            // After a statement it belongs to a `do`; elsewhere it starts a loop.
            Kind::While if outside && matches!(previous, Some(Kind::Semicolon | Kind::CloseBrace)) => {
                self.loops = self.loops.saturating_sub(1);
            }
            Kind::Semicolon if outside => {
                return match self.parentheses.last_mut() {
                    Some(left) if *left > 0 => {
                        *left -= 1;
                        false
                    }
                    _ => {
                        self.parentheses.clear();
                        !self.goes_on(next)
                    }
                };
            }
            _ => {}
        }
        false
    }

    /// Returns `true` if the next token continues a statement that could end here.
    fn goes_on(&self, next: Option<Kind>) -> bool {
        match next {
            Some(Kind::Else | Kind::Catch) => true,
            Some(Kind::While) => self.loops > 0,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODEL: &str = "\
units inch_lbf_s;
/// How wide.
param size = 2 inch in 1 inch .. 3 inch;
function area(in w, in h) { return w*h; }
try { size; } catch (e) { print(e); }
do size = size + 1; while (size < 3 inch);
for (var i = 0; i < 3; i = i + 1) print(i);
if (size > 1 inch) print(1); else print(2);
output doubled := 2*area(size, size);
print(\"{size : .3 mm}\");
";

    #[rustfmt::skip]
    const WRITTEN: [&str; 26] = [
        "{", "}", "(", ")", "[", ";", "var x = 1;", "/// Says it.\n", "// note\n", "\n", "else ", "try ", "do ", "while ",
        "for (", "catch ", "function f(in a) ", "\"", "{x}", "output ", "units SI;", "@", "/*", "return ", "µ", "x = ",
    ];

    /// Returns a reproducible pseudo-random number.
    fn below(state: &mut u64, end: usize) -> usize {
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*state >> 33) as usize % end.max(1)
    }

    #[test]
    fn loops_inside_of_loops_are_one_piece() {
        for text in [
            "do while (a) do ; while (b) ; while (c) ;",
            "do if (a) { } else while (b) { } while (c);",
            "do for (;;) try while (a) ; catch (e) ; while (b);",
        ] {
            let written = format!("{text}\nwhile (d) ;\n");
            let found = split(&lex(FileId(0), &written).tokens);
            let texts: Vec<_> = found.into_iter().map(|range| written[range].trim()).collect();
            assert_eq!(texts, [text, "while (d) ;"]);
        }
    }

    #[test]
    fn pieces_parsed_together_are_as_parsed_alone() {
        let (mut state, mut text) = (1, MODEL.to_string());
        for round in 0..2000 {
            if round % 20 == 0 {
                text = MODEL.to_string();
            }
            let mut boundary = || {
                let at = below(&mut state, text.len() + 1);
                (at..=text.len()).find(|at| text.is_char_boundary(*at)).unwrap_or(0)
            };
            let (start, end) = (boundary(), boundary());
            let end = if end > start && end < start + 20 { end } else { start };
            let written = WRITTEN[below(&mut state, WRITTEN.len())];
            text.replace_range(start..end, written);
            let found = pieces_on(&text, &lex(FileId(0), &text), |_| None, |_| 1 + round % 3);
            for (index, PlacedChunk { range, piece }) in found.iter().enumerate() {
                let alone = &text[range.clone()];
                let ends_file = index + 1 == found.len();
                let (statements, problems) = parse_run(alone, &lex(FileId(0), alone), ends_file);
                assert_eq!(**piece, Chunk { statements, problems }, "{alone}\nin\n{text}");
            }
        }
    }
}
