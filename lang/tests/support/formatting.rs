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
        Err(FormatError::WouldChange) => return Err("it would be changed".into()),
    };
    let (before, _) = parse(FileId(0), text);
    let (after, _) = parse(FileId(0), &formatted);
    let (before, after) = (tree::print(&before), tree::print(&after));
    if before != after {
        return Err(format!("another tree:\n{before}\n{after}"));
    }
    if comments(text) != comments(&formatted) {
        return Err("other comments".into());
    }
    match format(&formatted) {
        Ok(again) if again == formatted => {}
        Ok(again) => return Err(format!("not yet done:\n{formatted}\nbecomes\n{again}")),
        Err(_) => return Err(format!("cannot be read again:\n{formatted}")),
    }
    if let Some(line) = formatted.lines().find(|line| line.ends_with(' ') && !line.contains("*/")) {
        return Err(format!("blanks at the end of `{line}`"));
    }
    if applied(text) != Ok(formatted.clone()) {
        return Err(format!("the edits give something else than\n{formatted}"));
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
