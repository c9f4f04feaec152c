//! Outputs whose values number the choices of an enumeration, shown by the names of the choices.

use calyx_abi::description::choice_of;
use calyx_abi::units::shortest;

/// Returns the names of the choices that occur, each with its number of positions, the most
/// frequent one first. A value that numbers no choice is shown as a number, NaN as `none`.
pub fn counts(choices: &[String], values: impl Iterator<Item = f64>) -> Vec<(String, usize)> {
    let mut counts: Vec<(String, usize)> = Vec::new();
    for value in values {
        let name = match choice_of(choices, value) {
            Some(choice) => choice.to_owned(),
            None if value.is_nan() => "none".to_owned(),
            None => shortest(value),
        };
        match counts.iter_mut().find(|(known, _)| *known == name) {
            Some((_, count)) => *count += 1,
            None => counts.push((name, 1)),
        }
    }
    ordered(counts)
}

/// Returns the choices with the most frequent one first. Of equally frequent choices, the order
/// does not change.
pub fn ordered(mut counts: Vec<(String, usize)>) -> Vec<(String, usize)> {
    counts.sort_by_key(|(_, count)| std::cmp::Reverse(*count));
    counts
}

/// Describes the choices by position: the name of the only one, or `mixed at 3 positions, planet at
/// 1`.
pub fn described(counts: &[(String, usize)]) -> String {
    match counts {
        [(name, _)] => name.clone(),
        all => {
            let parts = all.iter().enumerate().map(|(index, (name, count))| {
                let unit = if index == 0 { if *count == 1 { " position" } else { " positions" } } else { "" };
                format!("{name} at {count}{unit}")
            });
            parts.collect::<Vec<_>>().join(", ")
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choices_are_counted_by_name() {
        let choices = ["mixed", "rotational"].map(String::from);
        let found = |values: &[f64]| counts(&choices, values.iter().copied());
        assert_eq!(found(&[1.0, 1.0]), [("rotational".to_owned(), 2)]);
        assert_eq!(described(&found(&[1.0, 1.0])), "rotational");
        let several = found(&[0.0, 1.0, 1.0, f64::NAN, 2.0, 0.5, -1.0]);
        assert_eq!(several[0], ("rotational".to_owned(), 2));
        assert_eq!(
            described(&several),
            "rotational at 2 positions, mixed at 1, none at 1, 2 at 1, 0.5 at 1, -1 at 1"
        );
        assert_eq!(described(&found(&[])), "");
    }
}
