//! The comparison as text: a table that marks the Pareto frontier, and recommendations.

use super::comparison::{Comparison, Errors, TOLERANCES};

/// A setting that was not run, and the reason.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OmittedSetting {
    pub name: String,
    pub reason: String,
}

/// Formats seconds with three digits.
pub fn seconds(time: f64) -> String {
    match time {
        time if time < 9.995e-4 => format!("{:.0} us", 1e6 * time),
        time if time < 0.09995 => format!("{:.1} ms", 1e3 * time),
        time if time < 9.995 => format!("{time:.2} s"),
        time if time < 99.95 => format!("{time:.1} s"),
        time if time < 5999.5 => format!("{time:.0} s"),
        time => format!("{:.1} h", time / 3600.0),
    }
}

/// Formats a fraction in per cent with two digits.
pub fn percent(part: f64) -> String {
    let percent = 100.0 * part;
    match percent {
        0.0 => "0".into(),
        p if p < 1e-4 => format!("{p:.0e}"),
        // As many decimals as two digits require.
        p if p < 9.95 => format!("{p:.*}", (1.0 - p.log10().floor()).clamp(1.0, 6.0) as usize),
        p => format!("{p:.0}"),
    }
}

/// Formats the table: one row per setting, one column per output, errors in per cent.
pub fn table(comparison: &Comparison) -> String {
    let mut rows = vec![vec!["setting".to_owned(), "time".into(), "structures".into(), "predicted".into()]];
    rows[0].extend((1..=comparison.outputs.len()).map(|number| format!("[{number}]")));
    for (index, measured) in comparison.settings.iter().enumerate() {
        let predicted = measured.predicted.map_or_else(|| "-".into(), seconds);
        let mut row = vec![
            measured.setting.name.clone(),
            seconds(measured.time()),
            seconds(measured.structures),
            predicted,
        ];
        row.extend(comparison.outputs.iter().map(|output| {
            if index == comparison.reference {
                return "reference".into();
            }
            let Some(errors) = &output.errors[index] else { return String::new() };
            let mark = match output.frontier.contains(&index) {
                true => "*",
                false if !comparison.includes_mesh_error[index] => "~",
                false => " ",
            };
            format!("{} %{mark}", percent(errors.error()))
        }));
        rows.push(row);
    }
    let columns = rows[0].len();
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let mut line = String::new();
        for (column, (cell, width)) in row.iter().zip(&widths).enumerate() {
            let gap = if column == 0 { "" } else { "  " };
            let aligned = if column == 0 { format!("{cell:<width$}") } else { format!("{cell:>width$}") };
            line = line + gap + &aligned;
        }
        text = text + line.trim_end() + "\n";
    }
    for (number, output) in (1..).zip(&comparison.outputs) {
        text += &format!("[{number}] {}\n", output.name);
    }
    text += "\
errors are the largest deviation at any position over the largest magnitude in the reference run; they exclude the error of the
reference run itself; * marks settings that are more accurate than all cheaper ones\n";
    let unseen = |index: usize| index != comparison.reference && !comparison.includes_mesh_error[index];
    if (0..comparison.settings.len()).any(unseen) {
        text += "\
~ marks errors that exclude those of the mesh and of the level, because the mesh of the reference is no finer; such settings are not
recommended\n";
    }
    text
}

/// Recommends settings by tolerance, for each output and for all of them.
pub fn recommendations(comparison: &Comparison) -> String {
    let described = |index: Option<usize>| {
        index.map_or_else(
            || "none of these".into(),
            |index| {
                let measured = &comparison.settings[index];
                format!("{}, {}", measured.setting.name, seconds(measured.time()))
            },
        )
    };
    let within = |cheapest: &dyn Fn(f64) -> Option<usize>| {
        let mut parts: Vec<(f64, Option<usize>)> = Vec::new();
        for tolerance in TOLERANCES {
            let index = cheapest(tolerance);
            // A setting that meets several tolerances is listed with the tightest one.
            match parts.last_mut().filter(|last| last.1 == index) {
                Some(last) => last.0 = tolerance,
                None => parts.push((tolerance, index)),
            }
        }
        let parts = parts
            .into_iter()
            .map(|(tolerance, index)| format!("{} %: {}", percent_of(tolerance), described(index)));
        parts.collect::<Vec<_>>().join("; ")
    };
    let mut text = String::new();
    for output in &comparison.outputs {
        text += &format!("{} within {}\n", output.name, within(&|tolerance| output.cheapest(tolerance)));
    }
    if comparison.outputs.len() > 1 {
        text +=
            &format!("all outputs within {}\n", within(&|tolerance| cheapest_of_all(comparison, tolerance)));
    }
    text
}

fn percent_of(tolerance: f64) -> String {
    format!("{}", (1e6 * tolerance).round() / 1e4)
}

/// Returns the cheapest setting at which the errors of all outputs are at most `tolerance`.
pub fn cheapest_of_all(comparison: &Comparison, tolerance: f64) -> Option<usize> {
    let within = |errors: &Option<Errors>| errors.as_ref().is_some_and(|errors| errors.error() <= tolerance);
    (0..comparison.settings.len())
        .filter(|index| *index != comparison.reference && comparison.includes_mesh_error[*index])
        .find(|index| comparison.outputs.iter().all(|output| within(&output.errors[*index])))
}

/// Lists the settings that were not run, with the reasons.
pub fn omitted(all: &[OmittedSetting]) -> String {
    all.iter().map(|OmittedSetting { name, reason }| format!("{name} omitted: {reason}\n")).collect()
}

#[cfg(test)]
mod tests {
    use super::super::comparison::tests::measured;
    use super::*;

    fn comparison() -> Comparison {
        let times = [0.0, 1.0];
        let of = |name, time, a: f64, b: f64| {
            measured(name, time, &times, &[("a", &[100.0, 100.0 + a]), ("b", &[10.0, 10.0 + b])])
        };
        let all = vec![
            of("plane", 0.4, 20.0, 0.2),
            of("medium", 3.0, 0.5, 0.05),
            of("finest", 40.0, 0.0, 0.0),
            of("fineroot", 9.0, 0.2, 0.3),
        ];
        Comparison::new(all, "finest").unwrap()
    }

    #[test]
    fn numbers_have_a_few_digits() {
        assert_eq!(
            [2e-4, 0.0421, 0.4, 12.34, 321.9, 7200.0].map(seconds),
            ["200 us", "42.1 ms", "0.40 s", "12.3 s", "322 s", "2.0 h"]
        );
        assert_eq!(
            [0.0, 1e-9, 3.14159e-5, 0.001, 0.0123, 0.5, 12.0].map(percent),
            ["0", "1e-7", "0.0031", "0.10", "1.2", "50", "1200"]
        );
    }

    #[test]
    fn the_table_marks_what_nothing_cheaper_beats() {
        let table = table(&comparison());
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[0], "setting     time  structures  predicted        [1]        [2]");
        assert_eq!(lines[1], "plane     0.40 s      0.30 s          -      20 %*     2.0 %*");
        assert_eq!(lines[3], "fineroot  9.00 s      6.75 s          -    0.20 %*     3.0 %");
        assert_eq!(lines[4], "finest    40.0 s      30.0 s          -  reference  reference");
    }

    #[test]
    fn what_to_choose() {
        let text = recommendations(&comparison());
        assert_eq!(
            text.lines().collect::<Vec<_>>(),
            [
                "a within 1 %: medium, 3.00 s; 0.1 %: none of these",
                "b within 2 %: plane, 0.40 s; 1 %: medium, 3.00 s; 0.1 %: none of these",
                "all outputs within 1 %: medium, 3.00 s; 0.1 %: none of these",
            ]
        );
    }
}
