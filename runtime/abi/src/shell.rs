//! Quoting for shell command lines that messages show for copying.

use std::path::Path;

/// Formats a text as one word of a POSIX shell: quoted if the shell would parse it differently.
///
/// ```
/// use calyx_abi::shell::word;
/// assert_eq!(word("pair.cx"), "pair.cx");
/// assert_eq!(word("torque=5 N*m"), "'torque=5 N*m'");
/// assert_eq!(word("it's; rm -rf ~"), r"'it'\''s; rm -rf ~'");
/// ```
pub fn word(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "._-/=+:,@%".contains(c);
    if text.chars().any(is_invisible) {
        // Such characters would change the display of the terminal.
        let escaped = |c: char| match c {
            '\'' | '\\' => format!("\\{c}"),
            c if is_invisible(c) => c.to_string().bytes().map(|byte| format!("\\x{byte:02x}")).collect(),
            c => c.into(),
        };
        return format!("$'{}'", text.chars().map(escaped).collect::<String>());
    }
    match !text.is_empty() && text.chars().all(plain) {
        true => text.to_owned(),
        false => format!("'{}'", text.replace('\'', r"'\''")),
    }
}

/// Quotes a path as one word that no command parses as an option.
pub fn path(path: &Path) -> String {
    let text = path.to_string_lossy();
    if text.starts_with('-') { word(&format!("./{text}")) } else { word(&text) }
}

/// Quotes the path of an executable as a word that runs it: the shell would search for a name
/// without a slash in `PATH`.
pub fn command(executable: &Path) -> String {
    match executable.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => path(executable),
        _ => word(&format!("./{}", executable.to_string_lossy())),
    }
}

/// Returns true for control characters and characters that reorder the text around them.
fn is_invisible(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{2069}' | '\u{feff}')
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::process::Command;

    #[test]
    fn a_shell_reads_back_what_was_written() {
        let texts = [
            "pair",
            "",
            "a b",
            "it's",
            "$(touch x)",
            "`id`",
            "a;b",
            "a\nb",
            "\u{1b}[31mred",
            "\\",
            "\"",
            "*",
            "~",
            "!x",
            "-rf",
            "#x",
            "é",
            "\u{202e}cx.exe",
            "a\t'\\b",
            "x\u{7f}",
            "a=$HOME",
            "{a,b}",
            "&",
            "|",
            "<",
            ">",
        ];
        for text in texts {
            let said = Command::new("bash").args(["-c", &format!("printf %s {}", word(text))]).output();
            let said = said.expect("a shell").stdout;
            let expected = text.as_bytes();
            // `printf` parses a first word with a leading dash as an option.
            if !text.starts_with('-') {
                assert_eq!(said, expected, "{text:?} as {}", word(text));
            }
            assert!(!word(text).contains(|c: char| c.is_control() || c == '\u{202e}'), "{text:?}");
        }
        assert_eq!(path(Path::new("-rf")), "./-rf");
        assert_eq!(command(Path::new("pair")), "./pair");
        assert_eq!(command(Path::new("/bin/a b")), "'/bin/a b'");
    }
}
