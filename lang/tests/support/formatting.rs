//! Checks that formatting preserves a text.

use calyx_lang::format::{FormatError, format, format_range};
use calyx_lang::lexer::lex;
use calyx_lang::parser::parse;
use calyx_lang::span::FileId;
use calyx_lang::tree_text as tree;

fn comments(text: &str) -> Vec<&str> {
    lex(FileId(0), text).comments.iter().map(|c| &text[c.span.start as usize..c.span.end as usize]).collect()
}

/// Formats a text without syntax errors, and returns a description of any violation.
pub fn judge(text: &str) -> Result<String, String> {
    let formatted = match format(text) {
        Ok(formatted) => formatted,
        Err(FormatError::Errors(_)) => return Ok(text.into()),
        Err(FormatError::WouldChange) => return Err("formatting would change the program".into()),
    };
    let (before, _) = parse(FileId(0), text);
    let (after, _) = parse(FileId(0), &formatted);
    let (before, after) = (tree::print(&before), tree::print(&after));
    if before != after {
        return Err(format!("formatting changes the syntax tree:\n{before}\n{after}"));
    }
    if comments(text) != comments(&formatted) {
        return Err("formatting changes comments".into());
    }
    match format(&formatted) {
        Ok(again) if again == formatted => {}
        Ok(again) => return Err(format!("formatting is not idempotent:\n{formatted}\nbecomes\n{again}")),
        Err(_) => return Err(format!("the formatted text has syntax errors:\n{formatted}")),
    }
    if let Some(line) = formatted.lines().find(|line| line.ends_with(' ') && !line.contains("*/")) {
        return Err(format!("trailing blanks in `{line}`"));
    }
    if applied(text) != Ok(formatted.clone()) {
        return Err(format!("the edits do not produce\n{formatted}"));
    }
    Ok(formatted)
}

/// Returns the text after all edits of the formatter.
fn applied(text: &str) -> Result<String, FormatError> {
    let mut result = text.to_string();
    for edit in format_range(text, 0..text.len() as u32)?.iter().rev() {
        result.replace_range(edit.span.start as usize..edit.span.end as usize, &edit.replacement);
    }
    Ok(result)
}
