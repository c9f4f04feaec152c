//! Durations of load cases in a file: times with a unit, percentages, or plain numbers as shares.

use super::axis::refused;
use crate::error::Error;
use calyx_abi::description::{Exponents, OWN_BASES, UnitDescription};
use calyx_abi::quantity::{self, fits};
use calyx_report::durations::Durations;
use std::fmt::Display;

/// Dimension of time.
const TIME: Exponents = {
    let mut time = [(0, 1); 5 + OWN_BASES];
    time[2] = (1, 1);
    time
};
/// Largest deviation of the sum of percentages from 100.
const PERCENT_TOLERANCE: f64 = 0.1;

/// How a duration is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Form {
    Time,
    Percent,
    Share,
}

impl Form {
    fn describe(self) -> &'static str {
        match self {
            Form::Time => "times",
            Form::Percent => "percentages",
            Form::Share => "plain numbers",
        }
    }
}

/// Duration of a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Entry {
    form: Form,
    /// s, percent, or any unit of a share.
    value: f64,
}

/// Parses the duration of a case: `40 hour`, `12.5 %`, or `3`. `unit` is that of the heading, for
/// plain numbers.
///
/// # Errors
/// The duration is missing, not finite, negative, or has a unit other than of time.
pub fn parse(cell: &str, unit: &str, place: &str, units: &[UnitDescription]) -> Result<Entry, Error> {
    const FORMS: &str =
        "give a time like `40 hour`, a percentage like `12.5 %`, or a plain number as a share";
    if cell.is_empty() {
        return Err(refused(
            format!("{place} has no duration"),
            "give every case a duration; 0 leaves a case out of the duty cycle",
        ));
    }
    let invalid = |why: &str| refused(format!("{place}: duration `{cell}` {why}"), FORMS);
    let plain = cell.parse::<f64>();
    let (text, number) = match (&plain, unit) {
        (Ok(number), "") => return checked(Form::Share, *number, &invalid),
        (Ok(number), unit) => (format!("{cell} {unit}"), Some(*number)),
        (Err(_), _) => (cell.to_owned(), None),
    };
    if let Some(percent) = text.strip_suffix('%') {
        let number = number.or_else(|| percent.trim().parse().ok());
        return checked(Form::Percent, number.ok_or_else(|| invalid("is not a percentage"))?, &invalid);
    }
    let parsed =
        quantity::parse(&text, units).map_err(|why| invalid(&format!("is not a duration: {why}")))?;
    if !fits(parsed.dimension, TIME) {
        return Err(invalid("is not a time"));
    }
    checked(Form::Time, parsed.value, &invalid)
}

fn checked(form: Form, value: f64, invalid: &impl Fn(&str) -> Error) -> Result<Entry, Error> {
    match value {
        value if !value.is_finite() => Err(invalid("is not a finite number")),
        value if value < 0.0 => Err(invalid("is negative")),
        value => Ok(Entry { form, value }),
    }
}

/// Returns the durations of all cases of a file.
///
/// # Errors
/// Some durations are times and others shares; percentages do not add up to 100; all durations are
/// zero.
pub fn of(entries: &[Entry], shown: &impl Display) -> Result<Durations, Error> {
    // A plain 0 is no time at all in every form.
    let counts = |entry: &&Entry| entry.form != Form::Share || entry.value != 0.0;
    let first = entries.iter().find(counts).map_or(Form::Share, |entry| entry.form);
    let differs = |(_, entry): &(usize, &Entry)| counts(entry) && entry.form != first;
    if let Some((case, other)) = entries.iter().enumerate().find(differs) {
        return Err(refused(
            format!(
                "some durations in {shown} are {}, and others are {} (case {})",
                first.describe(),
                other.form.describe(),
                case + 1
            ),
            "give all cases a time with a unit, all a percentage, or all a plain number",
        ));
    }
    let sum: f64 = entries.iter().map(|entry| entry.value).sum();
    if sum <= 0.0 || !sum.is_finite() {
        return Err(refused(
            format!("the durations in {shown} add up to {sum}"),
            "give at least one case a positive duration",
        ));
    }
    if first == Form::Percent && (sum - 100.0).abs() > PERCENT_TOLERANCE {
        return Err(refused(
            format!("the durations in {shown} add up to {} %", (1e6 * sum).round() / 1e6),
            "give percentages that add up to 100 %, or plain numbers, of which only the proportions count",
        ));
    }
    let values = entries.iter().map(|entry| entry.value).collect();
    Ok(Durations { values, are_times: first == Form::Time })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entry(form: Form, value: f64) -> Entry {
        Entry { form, value }
    }

    #[test]
    fn a_plain_zero_combines_with_every_form() {
        let times = of(&[entry(Form::Share, 0.0), entry(Form::Time, 60.0)], &"cases.csv").expect("durations");
        assert_eq!((times.values, times.are_times), (vec![0.0, 60.0], true));
        let mixed = of(&[entry(Form::Share, 1.0), entry(Form::Time, 60.0)], &"cases.csv");
        assert!(mixed.is_err());
    }
}
