//! Fuzzy matching of names.

/// Scores the match of a name with a query, higher is better; `None` unless all letters of the
/// query occur in the name in order.
///
/// Letters match in any case, with a bonus for the same case. Letters at the start of a word of the
/// name (`te` in `transmission_error`) and consecutive letters score higher.
pub fn score(query: &str, name: &str) -> Option<u32> {
    const BEGINS_WORD: u32 = 16;
    const FOLLOWS: u32 = 12;
    const SAME_CASE: u32 = 1;
    let name: Vec<char> = name.chars().collect();
    let query: Vec<char> = query.chars().filter(|c| !c.is_whitespace()).collect();
    if query.len() > name.len() {
        return None;
    }
    let begins_word = |at: usize| {
        let before = at.checked_sub(1).and_then(|at| name.get(at));
        let here = name.get(at);
        before.is_none_or(|before| {
            !before.is_alphanumeric() || (before.is_lowercase() && here.is_some_and(|c| c.is_uppercase()))
        })
    };
    // best[j]: best score so far with the last letter at index j of the name.
    let mut best: Vec<Option<u32>> = Vec::new();
    for (index, wanted) in query.iter().enumerate() {
        let mut next = vec![None; name.len()];
        // Best score of all positions that are not directly before.
        let mut apart = None;
        for (at, letter) in name.iter().enumerate() {
            let adjacent = at.checked_sub(1).and_then(|before| best.get(before).copied().flatten());
            let before = match index {
                0 => Some(0),
                _ => adjacent.map(|score| score + FOLLOWS).max(apart),
            };
            apart = apart.max(adjacent);
            if letter.to_lowercase().eq(wanted.to_lowercase()) {
                let worth = 1
                    + if begins_word(at) { BEGINS_WORD } else { 0 }
                    + if letter == wanted { SAME_CASE } else { 0 };
                next[at] = before.map(|score| score + worth);
            }
        }
        best = next;
    }
    if query.is_empty() {
        return Some(0);
    }
    let found = best.into_iter().flatten().max()?;
    let prefix = query.iter().zip(&name).all(|(a, b)| a.to_lowercase().eq(b.to_lowercase()));
    // An exact match ranks above a prefix, a prefix above scattered letters.
    let whole = prefix && query.len() == name.len();
    Some(found + u32::from(prefix) * BEGINS_WORD + u32::from(whole) * BEGINS_WORD)
}

#[cfg(test)]
mod tests {
    use super::score;

    /// Returns the matching names, the best first.
    fn found<'n>(query: &str, names: &[&'n str]) -> Vec<&'n str> {
        let mut fitting: Vec<_> =
            names.iter().filter_map(|name| Some((score(query, name)?, *name))).collect();
        fitting.sort_by_key(|(score, _)| std::cmp::Reverse(*score));
        fitting.into_iter().map(|(_, name)| name).collect()
    }

    #[test]
    fn letters_must_stand_in_order() {
        assert_eq!(found("ten", &["teeth", "net", "torque_n", "Tension"]), ["Tension", "torque_n"]);
        assert_eq!(score("", "teeth"), Some(0));
        assert_eq!(score("teeth", "tee"), None);
    }

    #[test]
    fn beginnings_of_words_and_whole_names_come_first() {
        assert_eq!(
            found("te", &["water", "transmission_error", "te", "teeth"]),
            ["te", "teeth", "transmission_error", "water"]
        );
        assert_eq!(found("rack", &["track", "basic_rack", "rack"])[0], "rack");
        assert_eq!(found("mü", &["Müller", "mu", "maß_ü"]), ["Müller", "maß_ü"]);
    }
}
