//! Selection and order of completion items.
//!
//! Editors match the typed letters with every item, and sort equal matches by the order given here.
//! The same match is computed here, so that truncation of a long list removes the worst items.

use super::item::Item;
use super::names::UNFIT;

/// Largest number of items.
const MOST: usize = 200;

/// Match of typed letters with a name, the best first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Match {
    /// The name starts with the letters.
    Begins,
    /// The name starts with the letters in another case.
    BeginsInOtherCase,
    /// A word of the name starts with the letters.
    Word,
    /// The letters occur in the name in order, the first at the start of a word.
    Letters,
}

/// Removes items that do not match the typed letters and, if no letters are typed, items of a wrong
/// type. Sorts the rest, and returns true if it was truncated.
pub fn rank(items: &mut Vec<Item>, typed: &str) -> bool {
    let mut matched: Vec<(Match, Item)> = std::mem::take(items)
        .into_iter()
        .filter(|item| !typed.is_empty() || item.rank.fit < UNFIT)
        .filter_map(|item| Some((matching(item.key(), typed)?, item)))
        .collect();
    matched.sort_by(|(a, left), (b, right)| {
        (a, left.rank, &left.label, &left.detail).cmp(&(b, right.rank, &right.label, &right.detail))
    });
    matched.dedup_by(|(_, b), (_, a)| a.label == b.label && a.detail == b.detail);
    let cut = matched.len() > MOST;
    matched.truncate(MOST);
    items.extend(matched.into_iter().map(|(_, item)| item));
    cut
}

fn matching(name: &str, typed: &str) -> Option<Match> {
    if name.starts_with(typed) {
        return Some(Match::Begins);
    }
    let same = |a: char, b: char| a == b || a.to_lowercase().eq(b.to_lowercase());
    let begins = |name: &str| {
        let mut letters = name.chars();
        typed.chars().all(|wanted| letters.next().is_some_and(|letter| same(letter, wanted)))
    };
    if begins(name) {
        return Some(Match::BeginsInOtherCase);
    }
    let mut found = None;
    for (at, _) in name.char_indices().filter(|&(at, _)| begins_word(name, at)) {
        let rest = name.get(at..).unwrap_or_default();
        if begins(rest) {
            return Some(Match::Word);
        }
        let first = rest.chars().next().zip(typed.chars().next());
        let mut letters = rest.chars();
        if first.is_some_and(|(letter, wanted)| same(letter, wanted))
            && typed.chars().all(|wanted| letters.any(|letter| same(letter, wanted)))
        {
            found = Some(Match::Letters);
        }
    }
    found
}

fn begins_word(name: &str, at: usize) -> bool {
    let before = name.get(..at).and_then(|before| before.chars().next_back());
    let here = name.get(at..).and_then(|rest| rest.chars().next());
    match (before, here) {
        (None, _) => true,
        (Some(before), Some(here)) => {
            !before.is_alphanumeric() && here.is_alphanumeric()
                || before.is_lowercase() && here.is_uppercase()
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::{Match, matching};

    #[test]
    fn letters_match_from_the_beginning_of_a_word() {
        for (name, typed, found) in [
            ("tooth_thickness", "", Some(Match::Begins)),
            ("tooth_thickness", "too", Some(Match::Begins)),
            ("Translate", "tra", Some(Match::BeginsInOtherCase)),
            ("tooth_thickness", "thi", Some(Match::Word)),
            ("tooth_thickness", "tt", Some(Match::Letters)),
            ("lbf*inch", "inch", Some(Match::Word)),
            ("tooth_thickness", "ooth", None),
            ("tooth", "tooths", None),
        ] {
            assert_eq!(matching(name, typed), found, "{name} {typed}");
        }
    }
}
