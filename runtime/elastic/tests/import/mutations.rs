//! Mutations of valid files: `tests/data/import/mutations.md`.

use super::cases::import;
use super::files::{Files, data, read};

#[test]
fn mutations_are_rejected_at_their_line() {
    let table = std::fs::read_to_string(data("import/mutations.md")).expect("the table exists");
    let (mut count, mut failures) = (0, Vec::new());
    for row in table.lines().filter(|row| row.starts_with('|')).skip(2) {
        let cells: Vec<&str> = row
            .trim_matches('|')
            .split('|')
            .map(|cell| {
                cell.strip_prefix(' ').unwrap_or(cell).strip_suffix(' ').unwrap_or(cell).trim_matches('`')
            })
            .collect();
        let [deck, search, replace, line, words] = cells[..] else { panic!("{row}") };
        let info = format!("{} N-mm-s", if deck.ends_with("inp") { "abaqus" } else { "nastran" });
        let text = String::from_utf8(read(&format!("import/{deck}"))).expect("text");
        let search = &search.replace("\\n", "\n");
        assert_eq!(text.matches(search.as_str()).count(), 1, "`{search}` is not once in {deck}");
        let content = text.replace(search.as_str(), &replace.replace("\\n", "\n"));
        let files = Files::from([("main".to_owned(), content.into_bytes())]);
        count += 1;
        match import(&info, &files) {
            Ok(_) => failures.push(format!("{row}\n  is accepted")),
            Err(error) => {
                let all = words.split(';').all(|word| error.message.contains(word.trim()));
                if error.line.to_string() != line || !all || error.help.is_empty() {
                    failures.push(format!("{row}\n  {error}"));
                }
            }
        }
    }
    assert!(count >= 40, "{count} mutations");
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_decks_without_mutations_are_accepted() {
    for deck in ["bracket.bdf", "bracket.inp"] {
        let files = Files::from([("main".to_owned(), read(&format!("import/{deck}")))]);
        let info = if deck.ends_with("inp") { "abaqus N-mm-s" } else { "nastran N-mm-s" };
        if let Err(error) = import(info, &files) {
            panic!("{error}");
        }
    }
}
