//! Finds the blocks of a source text, and by the indentation of its lines where a block ends whose
//! `}` is missing.

use super::source::Source;
use crate::lexer::Kind;
use std::collections::HashMap;

/// The blocks of a text.
pub(super) struct Layout {
    /// For each token, the `{` of the innermost block around it.
    pub openings: Vec<Option<usize>>,
    /// For each `{` whose block ends without a `}`, the token before which it ends.
    ends: HashMap<usize, usize>,
}

/// A block that is open.
struct OpenBlock {
    open: usize,
    /// Indentation of the line on which its statement begins.
    indent: usize,
    /// Its statements are on separate lines and indented further than that.
    is_indented: bool,
}

/// Returns `true` if some `{` has no `}`.
pub(super) fn is_unmatched(source: &Source<'_>) -> bool {
    let (mut depth, mut unmatched) = (0_usize, false);
    for at in (0..source.len()).rev() {
        match source.kind(at) {
            Some(Kind::CloseBrace) => depth += 1,
            Some(Kind::OpenBrace) => {
                unmatched |= depth == 0;
                depth = depth.saturating_sub(1);
            }
            _ => {}
        }
    }
    unmatched
}

impl Layout {
    /// Finds the blocks. `unmatched` is `true` if some `{` has no `}`.
    pub(super) fn new(source: &Source<'_>, unmatched: bool) -> Self {
        let mut layout = Layout { openings: vec![None], ends: HashMap::new() };
        let mut stack: Vec<OpenBlock> = Vec::new();
        // The first token of the line of each token.
        let mut lines: Vec<usize> = Vec::new();
        for at in 0..source.len() {
            if unmatched {
                let first = lines.last().copied().filter(|_| !source.begins_line(at));
                lines.push(first.unwrap_or(at));
                layout.end_blocks(source, at, &mut stack);
                // The innermost block around this token.
                if let Some(around) = layout.openings.last_mut() {
                    *around = stack.last().map(|block| block.open);
                }
            }
            match source.kind(at) {
                Some(Kind::OpenBrace) => {
                    let indent = if unmatched { statement_indent(source, at, &lines) } else { 0 };
                    let is_indented =
                        unmatched && source.begins_line(at + 1) && source.indent(at + 1) > indent;
                    stack.push(OpenBlock { open: at, indent, is_indented });
                }
                Some(Kind::CloseBrace) => {
                    stack.pop();
                }
                _ => {}
            }
            layout.openings.push(stack.last().map(|block| block.open));
        }
        layout
    }

    /// Ends the blocks that a token is not part of, because its line is not indented further than
    /// their statements.
    fn end_blocks(&mut self, source: &Source<'_>, at: usize, stack: &mut Vec<OpenBlock>) {
        let begins =
            matches!(source.previous(at), Some(Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace));
        if !begins || !source.begins_line(at) {
            return;
        }
        let indent = source.indent(at);
        let closes = source.kind(at) == Some(Kind::CloseBrace);
        while let Some(top) = stack.last() {
            // A `}` may close the block itself, if its indentation is that of the statement.
            let is_outside = match closes {
                true => indent < top.indent && stack.len() > 1,
                false => indent <= top.indent,
            };
            if !top.is_indented || !is_outside {
                return;
            }
            self.ends.insert(top.open, at);
            stack.pop();
        }
    }

    /// Returns `true` if the block of a `{` ends before a token without a `}`.
    pub(super) fn ends_before(&self, open: usize, at: usize) -> bool {
        self.ends.get(&open) == Some(&at)
    }
}

/// Returns the indentation of the line on which the statement of a `{` begins: its head may extend
/// over several lines in parentheses. `lines` has the first token of the line of each token.
fn statement_indent(source: &Source<'_>, open: usize, lines: &[usize]) -> usize {
    let mut first = lines[open];
    while let Some(before) = source.opening(first, Kind::CloseParen).filter(|before| *before < first) {
        first = lines[before];
    }
    source.indent(first)
}
