//! Text of tokens, one per line: location, kind, text.

use calyx_lang::lexer::lex;
use calyx_lang::render::line_column;
use calyx_lang::span::FileId;

pub fn print(text: &str) -> String {
    let mut out = String::new();
    for token in &lex(FileId(0), text).tokens {
        let (start, end) = (token.span.start as usize, token.span.end as usize);
        let (line, column) = line_column(text, start);
        let written = text.get(start..end).unwrap_or_default();
        let kind = format!("{:?}", token.kind);
        out += &format!("{:<8} {kind:<18} {written}\n", format!("{line}:{column}"));
    }
    out
}
