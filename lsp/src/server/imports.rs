//! Imports of a text, found without parsing it.
//!
//! The database determines imports exactly but must parse first. The files of a project must be
//! known before their texts are passed to the database, while the client waits to send its next
//! message. The result may have too many imports (one inside a comment), never too few.

/// Returns the dotted paths of the modules that a text seems to import, sorted.
pub fn imports(text: &str) -> Vec<String> {
    let mut found: Vec<String> = text
        .match_indices("import")
        .filter_map(|(at, word)| {
            let before = text[..at].chars().next_back();
            if before.is_some_and(is_of_name) {
                return None;
            }
            path(&text[at + word.len()..])
        })
        .collect();
    found.sort();
    found.dedup();
    found
}

fn is_of_name(character: char) -> bool {
    character.is_alphanumeric() || character == '_'
}

/// Returns the path after the keyword.
fn path(rest: &str) -> Option<String> {
    let mut rest = rest.strip_prefix(char::is_whitespace)?;
    let mut names = Vec::new();
    loop {
        rest = rest.trim_start();
        let (name, after) = rest.split_at(rest.find(|c| !is_of_name(c)).unwrap_or(rest.len()));
        if name.is_empty() || name.starts_with(char::is_numeric) {
            return None;
        }
        names.push(name);
        match after.trim_start().strip_prefix('.') {
            Some(more) => rest = more,
            None => return Some(names.join(".")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::imports;

    #[test]
    fn imports_are_found_wherever_they_stand() {
        let text = "import gears;\n  import a . b ;import c\nimportant x; var reimport d; import 1; import x.;import";
        assert_eq!(imports(text), ["a.b", "c", "gears"]);
    }
}
