//! Limits the depth of the tree before it is built, so that no traversal overflows the stack.

use super::source::Source;
use crate::diagnostic::Diagnostic;
use crate::lexer::Kind;

/// Limit of nested brackets, interpolations and blocks.
const MAX_BRACKETS: usize = 256;
/// Largest depth of the tree: brackets, and everything that makes one node the child of another
/// (operators of one expression, `else if` chains, labels in a row). Traversals of such a tree use
/// the stack of [`crate::deep_recursion`].
const MAX_LEVELS: usize = 400;

/// Returns an error at the first token that is nested too deeply. The depth is an upper bound: each
/// operator counts as one level until the next separator, as in `a - b - c`.
pub(super) fn exceeds_nesting(source: &Source<'_>) -> Option<Diagnostic> {
    // Number of levels at each open bracket, outermost first.
    let mut open = vec![0_usize];
    let mut levels = 0_usize;
    for index in 0..source.len() {
        let Some(kind) = source.kind(index) else { break };
        match kind {
            Kind::OpenParen
            | Kind::OpenBracket
            | Kind::OpenBrace
            | Kind::StringOpen
            | Kind::InterpolationOpen => {
                add(&mut open, &mut levels);
                open.push(0);
            }
            Kind::CloseParen
            | Kind::CloseBracket
            | Kind::CloseBrace
            | Kind::StringClose
            | Kind::InterpolationClose => {
                if open.len() > 1 {
                    levels -= open.pop().unwrap_or(0);
                }
                if kind == Kind::CloseBrace && !continues(source, index) {
                    reset(&mut open, &mut levels);
                }
            }
            Kind::Comma => reset(&mut open, &mut levels),
            Kind::Semicolon if !continues(source, index) => reset(&mut open, &mut levels),
            Kind::Semicolon
            | Kind::Number
            | Kind::Identifier
            | Kind::StringText
            | Kind::True
            | Kind::False
            | Kind::In
            | Kind::Out
            | Kind::InOut => {}
            _ => add(&mut open, &mut levels),
        }
        if open.len() > MAX_BRACKETS || levels > MAX_LEVELS {
            let message = "this is nested too deeply";
            let help = format!(
                "split it into several statements; at most {MAX_BRACKETS} nested brackets or {MAX_LEVELS} nested operators are allowed"
            );
            let place = source.place(index);
            return Some(Diagnostic::error("E0106", message, place, "exceeds the limit here").help(help));
        }
    }
    None
}

fn add(open: &mut [usize], levels: &mut usize) {
    if let Some(here) = open.last_mut() {
        *here += 1;
        *levels += 1;
    }
}

/// Ends the levels at a separator: code after it is not nested in code before it.
fn reset(open: &mut [usize], levels: &mut usize) {
    if let Some(here) = open.last_mut() {
        *levels -= *here;
        *here = 0;
    }
}

/// Returns `true` if the statement that ends here continues one level deeper.
fn continues(source: &Source<'_>, index: usize) -> bool {
    matches!(source.kind(index + 1), Some(Kind::Else | Kind::Catch))
}
