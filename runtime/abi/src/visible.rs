//! Replaces control characters in text from files before the text is written to a terminal.
//!
//! A source file, its name or a string in it may contain control characters. On a terminal, these
//! can move the cursor, change colours or titles, or reorder the output, so that a message could
//! display text that is not in the file.

use std::borrow::Cow;

/// Returns the text with every control character replaced by a visible character, except line ends
/// and tabs.
pub fn visible(text: &str) -> Cow<'_, str> {
    // Most texts contain no control characters.
    if !text.char_indices().any(|(at, c)| sign(text, at, c).is_some()) {
        return Cow::Borrowed(text);
    }
    Cow::Owned(text.char_indices().map(|(at, c)| sign(text, at, c).unwrap_or(c)).collect())
}

/// Returns the replacement of a character that would affect a terminal.
fn sign(text: &str, at: usize, c: char) -> Option<char> {
    match c {
        '\n' | '\t' => None,
        '\r' if text[at..].starts_with("\r\n") => None,
        // The Unicode control pictures have the order of the control characters.
        '\0'..='\u{1f}' => char::from_u32(0x2400 + c as u32),
        '\u{7f}' => Some('\u{2421}'),
        // C1 control characters, and characters that change the writing direction.
        '\u{80}'..='\u{9f}'
        | '\u{61c}'
        | '\u{200e}'
        | '\u{200f}'
        | '\u{202a}'..='\u{202e}'
        | '\u{2066}'..='\u{2069}' => Some(char::REPLACEMENT_CHARACTER),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::visible;

    #[test]
    fn control_characters_become_visible() {
        assert_eq!(visible("a\u{1b}[31m\u{7}b\u{7f}"), "a␛[31m␇b␡");
        assert_eq!(visible("a\rb\r\n\tc"), "a␍b\r\n\tc");
        assert_eq!(visible("\u{9b}2J \u{202e}x"), "\u{fffd}2J \u{fffd}x");
        assert_eq!(visible("Größe µ\n"), "Größe µ\n");
    }
}
