//! `optimization.html`: the result of an optimization as one self-contained page.

use super::chart::{Axis, COLOURS, Curve, TALL, curves};
use super::parallel::{self, Coordinate, Kind};
use super::{document, figure};
use crate::optimization::{FEASIBLE, Measure, Optimization, STEP, Search, Values, influence};
use crate::summary_table::number;
use crate::sweep::Column;
use calyx_abi::units::from_si;
use maud::{Markup, PreEscaped, html};
use std::fs;
use std::io;
use std::path::Path;

/// File name of the page.
pub const NAME: &str = "optimization.html";

/// Residual of the gradients above which an optimum is questioned: 0.1 % of the objective for 1 % of
/// the ranges.
const UNBALANCED: f64 = 0.1;

/// Writes the page.
///
/// # Errors
/// The file cannot be written.
pub fn write(path: &Path, all: &Optimization) -> io::Result<()> {
    fs::write(path, page(all).into_string())
}

fn page(all: &Optimization) -> Markup {
    let header = html! {
        @if let Some(line) = all.doc.lines().next().filter(|line| !line.is_empty()) { p { (line) } }
        p { (capitalized(&all.goal())) "." }
        p { (crate::optimization::agreement(all)) }
        @if all.interrupted { p.notice { "The optimization was interrupted: these are the best designs until then." } }
    };
    let main = html! {
        @if let Some((variables, optimum)) = all.best() {
            section id="optimum" {
                h2 { "Optimum" }
                @if optimum.violation > FEASIBLE {
                    p.notice { "No design meets all constraints. This one exceeds a bound by " (percent(optimum.violation)) "." }
                }
                (variable_table(all, variables))
                p.note { "The last columns are the change of the objective when the variable alone moves by " (percent(STEP)) " of its range; \"violates\" if a constraint is no longer met; empty outside of the range." }
                (value_table(all, optimum))
                (certificate(all))
            }
            section id="searches" {
                h2 { "Searches" }
                (convergence(all))
                (search_table(all))
            }
            section id="designs" { h2 { "Designs" } (designs(all)) }
        } @else {
            p.notice {
                @if all.interrupted { "No design was evaluated." } @else { "All designs failed; designs.csv has the reason of each." }
            }
        }
    };
    document(&format!("Optimization of {}", all.model), header, main)
}

fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn percent(part: f64) -> String {
    format!("{} %", number(100.0 * part))
}

fn unit(column: &Column) -> &str {
    if column.unit == "1" { "" } else { column.unit.as_str() }
}

fn shown(column: &Column, si: f64) -> String {
    number(from_si(si, column.factor))
}

fn variable_table(all: &Optimization, variables: &[f64]) -> Markup {
    html! {
        table.numbers {
            thead { tr {
                th { "variable" } th { "from" } th { "to" } th { "initial" } th { "optimum" } th { "" }
                th { "objective" br; "a step lower" } th { "objective" br; "a step higher" }
            } }
            tbody { @for (k, (variable, si)) in all.variables.iter().zip(variables).enumerate() { tr {
                td.word { (variable.column.name) " " (unit(&variable.column)) }
                @for si in [variable.low, variable.high, variable.initial] { td { (variable.shown(si)) } }
                td { strong { (shown(&variable.column, *si)) } }
                td.word { @if let Some(bound) = all.bound_of(k, *si) { "at its " (bound) } }
                @for side in 0..2 { td { (influence(all, k, side)) } }
            } } }
        }
    }
}

fn value_table(all: &Optimization, optimum: &Values) -> Markup {
    let initial = all.initial.as_ref().ok();
    let name = format!("{}, {}", all.column.name, all.objective.statistic.described());
    let of = |values: Option<&Values>, value: &dyn Fn(&Values) -> Option<f64>, column: &Column| {
        values.and_then(value).map_or(crate::optimization::missing(all).to_owned(), |si| shown(column, si))
    };
    html! {
        table.numbers {
            thead { tr { th { "value" } th { "initial" } th { "optimum" } th { "" } } }
            tbody {
                tr {
                    td.word { strong { (name) } " " (unit(&all.column)) }
                    td { (of(initial, &|values| Some(values.objective), &all.column)) }
                    td { strong { (shown(&all.column, optimum.objective)) } }
                    td.word { "objective" (improvement(all, optimum)) }
                }
                @if all.cases.len() > 1 { @for (k, label) in all.cases.iter().enumerate() { tr {
                    td.word { (label) }
                    td { (of(initial, &|values| values.cases.get(k).copied(), &all.column)) }
                    td { (shown(&all.column, optimum.cases[k])) }
                    td.word { (share(all, k)) }
                } } }
                @for (k, (constraint, column)) in all.constraints.iter().zip(&all.constraint_columns).enumerate() {
                    @let at = |values: &Values| all.governing(values, k).map(|(_, value)| value);
                    tr {
                        td.word { (constraint.shown(column)) }
                        td { (of(initial, &at, column)) }
                        td { (of(Some(optimum), &at, column)) }
                        td.word { (state(all, optimum, k)) }
                    }
                }
            }
        }
    }
}

fn improvement(all: &Optimization, optimum: &Values) -> String {
    let Ok(initial) = &all.initial else { return String::new() };
    let change = (optimum.objective - initial.objective) / initial.objective.abs();
    if change.is_finite() { format!(", {:+.1} %", 100.0 * change) } else { String::new() }
}

/// States which share of the optimum a load case determines.
fn share(all: &Optimization, case: usize) -> String {
    let Some(optimality) = all.optimality.as_ref().filter(|_| all.over_cases == Measure::Worst) else {
        return String::new();
    };
    let own = optimality.multipliers.iter().filter(|one| one.constraint.is_none() && one.case == case);
    let share: f64 = own.map(|one| one.value).sum();
    if share > 0.005 { format!("determines {:.0} % of the optimum", 100.0 * share) } else { String::new() }
}

/// States whether a constraint is active, in which load case, and what it costs.
fn state(all: &Optimization, optimum: &Values, constraint: usize) -> String {
    let own = &all.constraints[constraint];
    let column = &all.constraint_columns[constraint];
    let mut parts = vec![all.state_of(optimum, constraint).to_owned()];
    if let Some((case, _)) = all.governing(optimum, constraint).filter(|_| all.cases.len() > 1) {
        let extreme = if own.at_most { "largest" } else { "least" };
        parts.push(format!("{extreme} at {}", all.cases[case]));
    }
    let multipliers = all.optimality.iter().flat_map(|optimality| &optimality.multipliers);
    let cost: f64 = multipliers.filter(|one| one.constraint == Some(constraint)).map(|one| one.value).sum();
    if cost > 1e-4 {
        let weaker = match own.bound {
            0.0 => format!("0.01 {}", unit(column)).trim_end().to_owned(),
            _ => "1 %".to_owned(),
        };
        parts.push(format!("a bound weaker by {weaker} improves the objective by about {} %", number(cost)));
    }
    parts.retain(|part| !part.is_empty());
    parts.join(", ")
}

fn certificate(all: &Optimization) -> Markup {
    let Some(optimality) = &all.optimality else { return PreEscaped(String::new()) };
    html! {
        p.note {
            "By the gradients of the active functions, moving the variables by 1 % of their ranges would improve the objective by at most "
            (percent(0.01 * optimality.residual)) "; at the optimum of a smooth problem, by nothing. "
            @if optimality.residual > UNBALANCED {
                "Here a smaller `tolerance` or more `designs` may find a better design, or a function has a kink that the gradients do not show."
            }
        }
    }
}

/// Draws the best objective of each search over its designs.
fn convergence(all: &Optimization) -> Markup {
    let name =
        |search: usize| if search == 0 { "sample of starts".to_owned() } else { format!("search {search}") };
    let curve = |(k, search): (usize, &Search)| {
        let search = search.number;
        let mut best: Option<&Values> = None;
        let mut points = Vec::new();
        let own = all.designs.iter().filter(|design| design.search == search);
        for (number, design) in (1..).zip(own) {
            if let Ok(values) = &design.values
                && best.is_none_or(|best| all.is_better(values, best))
            {
                best = Some(values);
            }
            if let Some(best) = best.filter(|best| best.violation <= FEASIBLE) {
                points.push((f64::from(number), from_si(best.objective, all.column.factor)));
            }
        }
        Curve { name: name(search), colour: k, points, off: None }
    };
    let all_curves: Vec<Curve> = all.searches.iter().take(COLOURS.len()).enumerate().map(curve).collect();
    if all_curves.iter().all(|curve| curve.points.len() < 2) {
        return PreEscaped(String::new());
    }
    let name = format!("{}, {}", all.column.name, all.objective.statistic.described());
    let x = Axis { what: "design of the search", unit: "" };
    let y = Axis { what: &name, unit: &all.column.unit };
    let caption = "Best objective of each search over the number of its designs, from the first design that meets all constraints.";
    figure(&curves(TALL, &x, &y, &all_curves, &[]), caption)
}

fn search_table(all: &Optimization) -> Markup {
    let state = |k: usize, search: &Search| {
        let [objective, variables] = all.agreement(k);
        let mut state = match (objective, variables) {
            (_, true) => "best".to_owned(),
            (true, false) => "same objective, other variables".to_owned(),
            _ => "worse".to_owned(),
        };
        if !search.converged {
            state += if all.interrupted { ", interrupted" } else { ", not converged" };
        }
        state
    };
    html! {
        table.numbers {
            thead { tr {
                th { "search" }
                @for variable in &all.variables { th { (variable.column.name) br; (unit(&variable.column)) } }
                th { "objective" br; (unit(&all.column)) } th { "designs" } th { "result" }
            } }
            tbody { @for (k, search) in all.searches.iter().enumerate() { tr {
                td { (search.number) }
                @match &search.best {
                    Some((variables, values)) => {
                        @for (variable, si) in all.variables.iter().zip(variables) { td { (shown(&variable.column, *si)) } }
                        td { (shown(&all.column, values.objective)) }
                        td { (search.designs) }
                        td.word { (state(k, search)) }
                    }
                    None => {
                        @for _ in &all.variables { td {} }
                        td {}
                        td { (search.designs) }
                        td.word { "all designs failed" }
                    }
                }
            } } }
        }
    }
}

fn designs(all: &Optimization) -> Markup {
    let solved: Vec<(&Vec<f64>, &Values)> = all
        .designs
        .iter()
        .filter_map(|design| Some((&design.variables, design.values.as_ref().ok()?)))
        .collect();
    let failed = all.designs.len() - solved.len();
    let of_variable = |k: usize| {
        let column = &all.variables[k].column;
        let values = solved.iter().map(|(variables, _)| from_si(variables[k], column.factor)).collect();
        Coordinate { name: column.name.clone(), unit: unit(column).to_owned(), kind: Kind::Numbers(values) }
    };
    let drawn = all.variables.len().min(parallel::AXES - 2);
    let mut coordinates: Vec<Coordinate> = (0..drawn).map(of_variable).collect();
    let values = |value: &dyn Fn(&Values) -> f64| {
        Kind::Numbers(solved.iter().map(|(_, values)| value(values)).collect())
    };
    if !all.constraints.is_empty() {
        coordinates.push(Coordinate {
            name: "violation".to_owned(),
            unit: "%".to_owned(),
            kind: values(&|values| 100.0 * values.violation.max(0.0)),
        });
    }
    coordinates.push(Coordinate {
        name: all.column.name.clone(),
        unit: unit(&all.column).to_owned(),
        kind: values(&|values| from_si(values.objective, all.column.factor)),
    });
    let by = coordinates.len() - 1;
    let left_out = match all.variables.len() - drawn {
        0 => String::new(),
        left => format!(" Without the last {left} variables."),
    };
    let caption = "Parallel coordinates: a line is a design. Lines are coloured by the objective, from blue (low) to red (high). designs.csv has all of them.";
    html! {
        @if failed > 0 { p.note { (failed) " designs failed; designs.csv has the reasons." } }
        (figure(&parallel::plot(&coordinates, by), &format!("{caption}{left_out}")))
    }
}
