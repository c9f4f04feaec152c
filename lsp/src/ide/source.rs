//! One file with text, tokens and tree, for features based on its syntax.

use super::Snapshot;
use calyx_lang::db::Parsed;
use calyx_lang::lexer::{self, Token, Tokens};
use calyx_lang::parser;
use calyx_lang::span::FileId;
use std::sync::Arc;

/// A file of a snapshot. All positions in it are byte offsets of `text`.
#[derive(Clone)]
pub struct Source<'s> {
    pub text: &'s str,
    pub tokens: Arc<Tokens>,
    pub tree: Arc<Parsed>,
}

impl<'s> Source<'s> {
    /// Returns a file by its display name; `None` if it does not exist.
    pub fn of(snapshot: &'s Snapshot, file: &str) -> Option<Source<'s>> {
        let database = &snapshot.database;
        Some(Source {
            text: database.text(file)?,
            tokens: database.tokens(file)?,
            tree: database.tree(file)?,
        })
    }

    /// Parses a text outside of any snapshot.
    pub fn new(text: &'s str) -> Source<'s> {
        let tokens = lexer::lex(FileId(0), text);
        let (module, diagnostics) = parser::parse_tokens(FileId(0), text, &tokens);
        Source { text, tokens: Arc::new(tokens), tree: Arc::new(Parsed { module, diagnostics }) }
    }

    /// Returns the text between two byte offsets.
    pub fn slice(&self, start: u32, end: u32) -> &'s str {
        super::lines::slice(self.text, start, end)
    }

    /// Returns the text of a token.
    pub fn word(&self, token: &Token) -> &'s str {
        self.slice(token.span.start, token.span.end)
    }

    /// Returns the index of the first token that ends after a byte: the token around it, or the
    /// next one.
    pub fn token_after(&self, offset: u32) -> usize {
        self.tokens.tokens.partition_point(|token| token.span.end <= offset)
    }

    /// Returns the start of the `///` comment directly above a byte; the byte itself if there is
    /// none.
    pub fn with_documentation(&self, start: u32) -> u32 {
        let comments = &self.tokens.comments;
        let mut from = start;
        let before = comments.partition_point(|comment| comment.span.start < start);
        for comment in comments.iter().take(before).rev() {
            let between = self.slice(comment.span.end, from);
            let directly_above = between.trim().is_empty() && between.matches('\n').count() == 1;
            if comment.kind != lexer::CommentKind::Doc || !directly_above {
                break;
            }
            from = comment.span.start;
        }
        from
    }
}
