//! Extreme inputs of every method: each case meets a stated accuracy, is rejected with a reason, or
//! reports a warning in its results. No case returns a silently wrong number or NaN.
//!
//! The cases are data. One test runs them, another one compares `docs/extremes.md` with them
//! (`CALYX_BLESS=1` writes it). References are the cheapest that are independent of the method:
//! closed forms, scaling laws, exact limits, another method for the same number.

mod bearings;
mod case;
mod cylinders;
mod elements;
mod motion;
mod pairs;
mod shapes;

use case::{Case, Outcome};
use rayon::prelude::*;
use std::path::Path;

/// Chapters with their cases.
fn chapters() -> Vec<(&'static str, Vec<Case>)> {
    vec![
        ("Contact", cylinders::cases()),
        ("Gears in mesh", pairs::cases()),
        ("Shapes of gears", shapes::cases()),
        ("Bearings, clearances and supports", bearings::cases()),
        ("Motion in time", motion::cases()),
        ("Elements", elements::cases()),
    ]
}

#[test]
fn every_method_holds_at_its_edges_or_says_that_it_does_not() {
    let cases: Vec<Case> = chapters().into_iter().flat_map(|(_, cases)| cases).collect();
    let only = std::env::var("CALYX_EXTREME").unwrap_or_default();
    let cases: Vec<Case> = cases.into_iter().filter(|case| case.method.contains(&only)).collect();
    let wrong: Vec<String> = cases.par_iter().filter_map(Case::fails).collect();
    assert!(wrong.is_empty(), "{} of {} cases:\n{}", wrong.len(), cases.len(), wrong.join("\n"));
}

#[test]
fn the_table_of_extremes_is_that_of_the_cases() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs/extremes.md");
    let written = document();
    if std::env::var_os("CALYX_BLESS").is_some() {
        std::fs::create_dir_all(path.parent().expect("a directory")).expect("it can be made");
        std::fs::write(&path, &written).expect("it can be written");
    }
    let known = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        known == written,
        "docs/extremes.md is stale: CALYX_BLESS=1 cargo test -p calyx-gears --test all extremes"
    );
}

fn document() -> String {
    let mut text = String::from(
        "# Extremes\n\n\
         How far each method can be driven. Every row is a case of a test, `stdlib-gears/tests/extremes`. The column\n\
         *Result* has one of three outcomes:\n\n\
         - an accuracy: the largest relative error over all values of the row, against the independent truth in the last\n  \
         column;\n\
         - rejected: the code of the error (`calyx explain CODE`);\n\
         - warning: part of the warning that is shown with the result.\n\n\
         The test fails if a case does not have its outcome. It also writes this page:\n\
         `CALYX_BLESS=1 cargo test -p calyx-gears --test all extremes`.\n",
    );
    for (chapter, cases) in chapters() {
        text +=
            &format!("\n## {chapter}\n\n| Case | Extreme | Result | Truth or reason |\n|---|---|---|---|\n");
        for Case { method, driven, outcome } in cases {
            let (happens, by) = match outcome {
                Outcome::Holds { to: 0.0, truth, .. } => ("exact".to_string(), truth.to_string()),
                Outcome::Holds { to, truth, .. } => (format!("within {}", shown(to)), truth.to_string()),
                Outcome::Refused { code, why, .. } => (format!("rejected, {code}"), why.to_string()),
                Outcome::Warns { says, why, .. } => (format!("warning \"{says}\""), why.to_string()),
            };
            text += &format!("| {method} | {driven} | {happens} | {by} |\n");
        }
    }
    text
}

/// Formats a bound as it was written.
fn shown(bound: f64) -> String {
    if bound >= 1e-3 { format!("{} %", (bound * 1e5).round() / 1e3) } else { format!("{bound:e}") }
}
