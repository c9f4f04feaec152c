//! Results of an optimization as text.

use super::{FEASIBLE, Optimization, STEP};
use crate::summary_table::{align, number};
use calyx_abi::units::from_si;

/// Formats the optimum: variables, objective by load case, constraints, and the searches.
pub fn text(all: &Optimization) -> String {
    let Some((variables, optimum)) = all.best() else {
        return if all.interrupted { String::new() } else { "all designs failed\n".to_owned() };
    };
    let mut text = align(&variable_rows(all, variables));
    text.push('\n');
    text += &align(&value_rows(all));
    text.push('\n');
    text += &agreement(all);
    if optimum.violation > FEASIBLE {
        text += &format!(
            "no design meets all constraints; this one exceeds a bound by {:.2} %\n",
            100.0 * optimum.violation
        );
    }
    text
}

fn variable_rows(all: &Optimization, variables: &[f64]) -> Vec<Vec<String>> {
    let step = format!("{:.0} % of range", 100.0 * STEP);
    let head = [
        "variable",
        "unit",
        "from",
        "to",
        "initial",
        "optimum",
        "",
        &format!("objective at -{step}"),
        &format!("at +{step}"),
    ];
    let mut rows = vec![head.map(str::to_owned).to_vec()];
    for (k, (variable, si)) in all.variables.iter().zip(variables).enumerate() {
        let unit = if variable.column.unit == "1" { "" } else { variable.column.unit.as_str() };
        let mut row = vec![variable.column.name.clone(), unit.to_owned()];
        row.extend([variable.low, variable.high, variable.initial].map(|si| variable.shown(si)));
        row.push(number(from_si(*si, variable.column.factor)));
        row.push(all.bound_of(k, *si).map(|bound| format!("at {bound}")).unwrap_or_default());
        row.extend([0, 1].map(|side| influence(all, k, side)));
        rows.push(row);
    }
    rows
}

/// Returns the text in place of a value of the initial design that is not known.
pub(crate) fn missing(all: &Optimization) -> &'static str {
    if all.interrupted { "not solved" } else { "failed" }
}

/// Describes the change of the objective after a step of a variable.
pub(crate) fn influence(all: &Optimization, variable: usize, side: usize) -> String {
    let (Some((_, optimum)), Some(influence)) = (all.best(), all.influences.get(variable)) else {
        return String::new();
    };
    let values = match &influence.steps[side] {
        None => return String::new(),
        Some(Err(_)) => return "failed".to_owned(),
        Some(Ok(values)) => values,
    };
    let change = values.objective - optimum.objective;
    let change = if optimum.objective.abs() < all.scale() {
        let unit = if all.column.unit == "1" { "" } else { all.column.unit.as_str() };
        let sign = if change < 0.0 { "" } else { "+" };
        format!("{sign}{} {unit}", number(from_si(change, all.column.factor))).trim_end().to_owned()
    } else {
        format!("{:+.2} %", 100.0 * change / optimum.objective.abs())
    };
    let violates = values.violation > FEASIBLE.max(optimum.violation);
    if violates { format!("{change}, violates") } else { change }
}

fn value_rows(all: &Optimization) -> Vec<Vec<String>> {
    let Some((_, optimum)) = all.best() else { return Vec::new() };
    let mut rows = vec![["", "unit", "initial", "optimum", ""].map(str::to_owned).to_vec()];
    let initial = all.initial.as_ref().ok();
    let shown =
        |si: Option<f64>, factor: f64| si.map_or(missing(all).to_owned(), |si| number(from_si(si, factor)));
    let unit = |unit: &str| if unit == "1" { String::new() } else { unit.to_owned() };
    let name = format!("{}.{}", all.column.name, all.objective.statistic.name());
    let factor = all.column.factor;
    rows.push(vec![
        name.clone(),
        unit(&all.column.unit),
        shown(initial.map(|values| values.objective), factor),
        number(from_si(optimum.objective, factor)),
        "objective".to_owned(),
    ]);
    if all.cases.len() > 1 {
        for (k, label) in all.cases.iter().enumerate() {
            rows.push(vec![
                format!("  {label}"),
                unit(&all.column.unit),
                shown(initial.map(|values| values.cases[k]), factor),
                number(from_si(optimum.cases[k], factor)),
                String::new(),
            ]);
        }
    }
    for (k, (constraint, column)) in all.constraints.iter().zip(&all.constraint_columns).enumerate() {
        let at = |values| all.governing(values, k).map(|(_, value)| value);
        let case = all.governing(optimum, k).map(|(case, _)| case).filter(|_| all.cases.len() > 1);
        let mut state = all.state_of(optimum, k).to_owned();
        if let Some(case) = case {
            state = format!("{state} {}", all.cases[case]).trim().to_owned();
        }
        rows.push(vec![
            constraint.shown(column),
            unit(&column.unit),
            shown(initial.and_then(at), column.factor),
            shown(at(optimum), column.factor),
            state,
        ]);
    }
    rows
}

/// States how many searches have the same optimum, and what limits the result.
pub(crate) fn agreement(all: &Optimization) -> String {
    let count = all.searches.len();
    let alike = |k: usize| (0..count).filter(|&search| all.agreement(search)[k]).count();
    let designs = all.designs.len();
    let mut text = if count == 1 {
        format!("1 search with {designs} designs")
    } else {
        let [objective, variables] = [alike(0), alike(1)];
        let own = match variables {
            all if all == objective => ", with the same variables within 1 % of their ranges".to_owned(),
            1 => ", but other variables: the optimum is not unique, or flat".to_owned(),
            some => format!(", {some} of them with the same variables within 1 % of their ranges"),
        };
        format!("{objective} of {count} searches have this objective within 0.1 %{own}; {designs} designs")
    };
    let failed = all.designs.iter().filter(|design| design.values.is_err()).count();
    if failed > 0 {
        text += &format!(", of which {failed} failed");
    }
    text.push('\n');
    if let (Err(reason), false) = (&all.initial, all.interrupted) {
        text += &format!("the initial design failed: {reason}\n");
    }
    let unfinished = all.searches.iter().filter(|search| !search.converged).count();
    if unfinished > 0 && !all.interrupted {
        let searches = if unfinished == 1 { "1 search" } else { &format!("{unfinished} searches") };
        text += &format!("{searches} did not converge: a larger limit `designs` may give a better design\n");
    }
    text
}
