//! The calls around a cursor, with their arguments as written.

use super::{Bracket, CursorContext, Statement};
use calyx_lang::lexer::Kind;
use std::ops::Range;

/// A call around a cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// `gears`, `external`; the last is the function.
    pub path: Vec<String>,
    /// Byte range of the path.
    pub callee: Range<usize>,
    pub arguments: Vec<WrittenArgument>,
    /// Index of the argument at the cursor.
    pub active: usize,
}

/// An argument as written.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct WrittenArgument {
    pub name: Option<String>,
    /// `..record`; the name of the record if it is one.
    pub spread: Option<String>,
    /// True if the argument has at most the word at the cursor.
    pub empty: bool,
}

impl CursorContext<'_> {
    /// Returns the calls around the cursor in a statement, innermost first.
    pub fn calls(&self, statement: &Statement) -> Vec<Call> {
        let calls = statement.open.iter().filter(|open| open.kind == Bracket::Call);
        calls.filter_map(|open| self.call(open.at)).collect()
    }

    /// Returns the call whose arguments start at an open `(`.
    pub fn call(&self, open: usize) -> Option<Call> {
        let last = open.checked_sub(1)?;
        let mut path = vec![self.source(last).to_string()];
        let mut first = last;
        while let Some(before) = first.checked_sub(2)
            && self.kind(first - 1) == Some(Kind::Dot)
            && self.kind(before) == Some(Kind::Identifier)
        {
            path.insert(0, self.source(before).to_string());
            first = before;
        }
        let callee = self.range(first).start..self.range(last).end;
        let mut arguments = Vec::new();
        let mut active = 0;
        let mut start = open + 1;
        let margin = self.indentation(callee.start);
        loop {
            let end = self.argument_end(start, margin);
            if start <= self.before {
                active = arguments.len();
            }
            let followed = self.kind(end) == Some(Kind::Comma);
            // After a trailing comma there is an argument only if the cursor is there.
            if end > start || followed || start == self.before {
                arguments.push(self.given(start, end));
            }
            if !followed {
                break;
            }
            start = end + 1;
        }
        Some(Call { path, callee, arguments, active })
    }

    /// Returns the token after the argument that starts at `start`: a comma, a closing delimiter,
    /// or the end of the statement. In an unclosed call, an assignment on a line that is not
    /// indented more than the call is a separate statement.
    fn argument_end(&self, start: usize, margin: usize) -> usize {
        let mut depth = 0_usize;
        let mut index = start;
        while let Some(kind) = self.kind(index) {
            match kind {
                Kind::Comma if depth == 0 => break,
                Kind::OpenParen | Kind::OpenBracket | Kind::StringOpen => depth += 1,
                Kind::CloseParen | Kind::CloseBracket | Kind::StringClose if depth > 0 => depth -= 1,
                Kind::CloseParen | Kind::CloseBracket | Kind::InterpolationClose if depth == 0 => break,
                Kind::Semicolon | Kind::OpenBrace | Kind::CloseBrace => break,
                _ if kind.begins_statement() && !self.is_under_cursor(index) => break,
                Kind::Identifier
                    if !self.is_under_cursor(index)
                        && self.begins_line(index)
                        && self.indentation(self.range(index).start) <= margin
                        && matches!(self.kind(index + 1), Some(Kind::Assign | Kind::Bind)) =>
                {
                    break;
                }
                _ => {}
            }
            index += 1;
        }
        index
    }

    fn given(&self, start: usize, end: usize) -> WrittenArgument {
        if self.kind(start) == Some(Kind::DotDot) {
            let name = self.kind(start + 1) == Some(Kind::Identifier) && end == start + 2;
            let spread = if name { self.source(start + 1).to_string() } else { String::new() };
            return WrittenArgument { spread: Some(spread), ..WrittenArgument::default() };
        }
        let bound = matches!(self.kind(start + 1), Some(Kind::Assign | Kind::Bind)) && start + 1 < end;
        let name =
            (bound && self.kind(start) == Some(Kind::Identifier)).then(|| self.source(start).to_string());
        let empty = end == start || (start == self.before && end == self.next());
        WrittenArgument { name, spread: None, empty }
    }
}
