//! Compares the library modules of ratings and tolerances with published calculations.
//!
//! `ratings/cases.cx` has the inputs. Each row of `ratings.csv` has an expression of its variables
//! and the published digits.

use calyx_tests::printed::printed_lines;
use calyx_tests::root;
use std::fmt::Write;

/// A published number.
struct Row {
    case: String,
    quantity: String,
    published: String,
    /// Unit of the digits; empty for pure numbers.
    unit: String,
    /// "digit": half a unit of the last digit; "unit": one unit; or a relative deviation in
    /// percent.
    agreement: String,
    expression: String,
}

impl Row {
    /// Largest difference that the row allows; 0.01 % of a digit are for the binary fractions.
    fn allowed(&self) -> f64 {
        let decimals = self.published.split_once('.').map_or(0, |(_, decimals)| decimals.len());
        let unit = 10.0_f64.powi(-i32::try_from(decimals).expect("few digits"));
        match self.agreement.as_str() {
            "digit" => 0.5001 * unit,
            "unit" => 1.0001 * unit,
            percent => {
                let percent: f64 = percent.trim_end_matches(" %").parse().expect("a percentage");
                percent / 100.0 * self.number().abs()
            }
        }
    }

    fn number(&self) -> f64 {
        self.published.parse().unwrap_or_else(|_| panic!("not a number: {}", self.published))
    }

    /// Statement that prints the number in its unit.
    fn statement(&self) -> String {
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        format!("print(\"{{{} : .12e{unit}}}\");", self.expression)
    }
}

fn rows() -> Vec<Row> {
    let text = std::fs::read_to_string(root().join("stdlib-gears/tests/data/ratings.csv")).expect("the data");
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    lines
        .map(|line| {
            let cells: Vec<String> = line.split('|').map(str::to_owned).collect();
            let [case, quantity, published, unit, agreement, expression] =
                <[String; 6]>::try_from(cells).unwrap_or_else(|_| panic!("not a row: {line}"));
            Row { case, quantity, published, unit, agreement, expression }
        })
        .collect()
}

#[test]
fn published_ratings_and_tolerances_are_reproduced() {
    let rows = rows();
    let mut text = std::fs::read_to_string(root().join("tests/ratings/cases.cx")).expect("the model");
    for row in &rows {
        writeln!(text, "{}", row.statement()).expect("text grows");
    }
    let lines = printed_lines("cases.cx", &text);
    assert_eq!(lines.len(), rows.len());
    let mut wrong = String::new();
    for (row, line) in rows.iter().zip(lines.iter()) {
        let number = line.split(' ').next().unwrap_or_default();
        let value: f64 = number.parse().unwrap_or_else(|_| panic!("not a number: {line}"));
        if (value - row.number()).abs() > row.allowed() {
            writeln!(wrong, "{} {}: {value} is not {}", row.case, row.quantity, row.published).unwrap();
        }
    }
    assert!(wrong.is_empty(), "\n{wrong}");
    assert!(rows.len() > 500, "only {} rows", rows.len());
}
