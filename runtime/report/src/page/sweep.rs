//! `sweep.html`: the cases of a sweep as one self-contained page, with plots that suit the number
//! of varied params: curves over one, heat maps over two, parallel coordinates of more.

use super::chart::{self, Axis, Curve, Scale, WIDE};
use super::heat_map::{self, Grid};
use super::parallel::{self, Coordinate, Kind};
use super::{document, figure, load_cases, pareto, tolerances};
use crate::duty_cycle::DutyCycle;
use crate::study::{Group, Statistic};
use crate::sweep::{Case, Column, Row, Statistics, SweepTable};
use calyx_abi::description::ParamValue;
use calyx_abi::units::from_si;
use maud::{Markup, PreEscaped, html};
use std::fs;
use std::io;
use std::path::Path;

/// Largest number of curves in a plot, one per colour.
const CURVES: usize = 6;
/// Largest number of rows in the table of the page; the file has all.
const ROWS: usize = 500;

/// Smallest number of values along both axes of a heat map.
const CELLS: usize = 3;
/// Largest number of heat maps of an output, one per combination of the other params.
const MAPS: usize = 3;
/// Number of outputs with a coordinate in a plot of parallel coordinates.
const COORDINATES: usize = 4;

/// Writes the page of a sweep, with the values over its duty cycle if there is one, and the
/// statistics of its samples.
///
/// # Errors
/// The file cannot be written.
pub fn write(
    path: &Path,
    table: &SweepTable,
    cycle: Option<&Result<DutyCycle, String>>,
    groups: &[Group],
) -> io::Result<()> {
    fs::write(path, page(table, cycle, groups).into_string())
}

fn page(table: &SweepTable, cycle: Option<&Result<DutyCycle, String>>, groups: &[Group]) -> Markup {
    let header = html! {
        @if let Some(line) = table.doc.lines().next().filter(|line| !line.is_empty()) { p { (line) } }
        p { (table.rows.len()) " cases" @if table.failures() > 0 { ", of which " (table.failures()) " failed" } "." }
    };
    let main = html! {
        (load_cases::duty_cycle(table, cycle))
        (load_cases::section(table))
        (tolerances::section(table, groups))
        (pareto::section(table))
        section id="plots" { h2 { "Outputs" } (plots(table)) }
        section id="cases" { h2 { "Cases" } (cases(table)) }
        (printed(table))
        (warnings(table))
    };
    document(&format!("Sweep of {}", table.model), header, main)
}

/// Returns the index of the first param that is a number with several values: the abscissa.
fn abscissa(table: &SweepTable) -> Option<usize> {
    (0..table.params.len()).find(|&param| {
        let mut numbers = table.cases.iter().filter_map(|case| number_of(case, param));
        let Some(first) = numbers.next() else { return false };
        numbers.any(|other| other != first)
    })
}

fn number_of(case: &Case, param: usize) -> Option<f64> {
    match case.values.get(param)? {
        ParamValue::Number(si) => Some(*si),
        _ => None,
    }
}

/// Cases that one curve connects, and its name.
type Family<'t> = (String, Vec<(&'t Case, &'t Row)>);

/// Groups the cases that differ in the abscissa only.
fn families(table: &SweepTable, abscissa: usize) -> Vec<Family<'_>> {
    let mut families: Vec<Family<'_>> = Vec::new();
    for (case, row) in table.cases.iter().zip(&table.rows) {
        let name = others(table, case, &[abscissa]);
        match families.iter_mut().find(|(known, _)| *known == name) {
            Some((_, members)) => members.push((case, row)),
            None => families.push((name, vec![(case, row)])),
        }
    }
    families
}

fn plots(table: &SweepTable) -> Markup {
    let varied: Vec<usize> = (0..table.params.len()).filter(|&param| is_varied(table, param)).collect();
    let parallel = if varied.len() > 2 {
        parallel_coordinates(table, &varied)
    } else {
        html! {}
    };
    // Curves over random samples would jump.
    if table.sample.is_some() {
        let shown = if parallel.0.is_empty() {
            html! { p.note { "See the distributions above." } }
        } else {
            parallel
        };
        return shown;
    }
    let numbers: Vec<usize> =
        varied.iter().copied().filter(|&param| number_of(&table.cases[0], param).is_some()).collect();
    let maps = match numbers[..] {
        [x, y] => heat_maps(table, [x, y]),
        _ => None,
    };
    // Curves show few values of the second axis better than many.
    let many = maps.is_some() && numbers.iter().all(|&param| distinct(table, param).len() > CURVES);
    html! { (parallel) (maps.unwrap_or_default()) @if !many { (curves(table)) } }
}

/// Returns whether a param has several values.
fn is_varied(table: &SweepTable, param: usize) -> bool {
    table.cases.iter().any(|case| case.values.get(param) != table.cases[0].values.get(param))
}

/// Returns the different values of a param, numbers in ascending order.
fn distinct(table: &SweepTable, param: usize) -> Vec<ParamValue> {
    let mut all: Vec<ParamValue> = Vec::new();
    for value in table.cases.iter().filter_map(|case| case.values.get(param)) {
        if !all.contains(value) {
            all.push(value.clone());
        }
    }
    all.sort_by(|one, other| match (one, other) {
        (ParamValue::Number(one), ParamValue::Number(other)) => one.total_cmp(other),
        _ => std::cmp::Ordering::Equal,
    });
    all
}

/// Draws a coordinate per varied param and per output. Of many params or outputs, the first ones
/// are drawn.
fn parallel_coordinates(table: &SweepTable, varied: &[usize]) -> Markup {
    let outputs = table.outputs.len().min(COORDINATES);
    let params = varied.iter().take(parallel::AXES.saturating_sub(outputs));
    let solved: Vec<(&Case, &Row)> = table.cases.iter().zip(&table.rows).collect();
    let unit = |column: &Column| if column.unit == "1" { String::new() } else { column.unit.clone() };
    let of_param = |&param: &usize| {
        let column = &table.params[param];
        let numbers: Option<Vec<f64>> = solved.iter().map(|(case, _)| number_of(case, param)).collect();
        let kind = match numbers {
            Some(numbers) => Kind::Numbers(numbers.iter().map(|si| from_si(*si, column.factor)).collect()),
            None => {
                let all = distinct(table, param);
                let index = |case: &Case| all.iter().position(|value| Some(value) == case.values.get(param));
                let indices = solved.iter().map(|(case, _)| index(case).unwrap_or(0)).collect();
                Kind::Choices(indices, all.iter().map(|value| column.shown(value)).collect())
            }
        };
        Coordinate { name: column.name.clone(), unit: unit(column), kind }
    };
    let objective = table.objectives.first();
    let statistic = |column: &Column| {
        let own = table.objectives.iter().find(|objective| objective.output == column.name);
        own.map_or(Statistic::Max, |objective| objective.statistic)
    };
    let of_output = |column: &Column| {
        let statistic = statistic(column);
        let value = |row: &Row| table.value(row, column, |all| all.get(statistic));
        let numbers = solved.iter().map(|(_, row)| value(row)).collect();
        let name = match statistic {
            Statistic::Max => column.name.clone(),
            statistic => format!("{}.{}", column.name, statistic.name()),
        };
        Coordinate { name, unit: unit(column), kind: Kind::Numbers(numbers) }
    };
    let mut coordinates: Vec<Coordinate> = params.map(of_param).collect();
    let first = coordinates.len();
    // Objectives come first.
    let mut columns: Vec<&Column> = table.outputs.iter().collect();
    let place = |column: &Column| table.objectives.iter().position(|own| own.output == column.name);
    columns.sort_by_key(|column| place(column).unwrap_or(usize::MAX));
    columns.truncate(outputs);
    let by = columns.iter().position(|column| objective.is_some_and(|first| first.output == column.name));
    coordinates.extend(columns.into_iter().map(of_output));
    let by = (first + by.unwrap_or(0)).min(coordinates.len().saturating_sub(1));
    let of = coordinates.get(by).map_or("", |coordinate| coordinate.name.as_str());
    let caption = format!(
        "Parallel coordinates: a line is a case, and each axis a varied param or an output. Lines are coloured by {of}, from blue (low) to red (high). Cases without a value of an axis are left out."
    );
    figure(&parallel::plot(&coordinates, by), &caption)
}

/// Draws heat maps over two params; `None` if their values form no grid.
fn heat_maps(table: &SweepTable, [x, y]: [usize; 2]) -> Option<Markup> {
    let [columns, rows] = [x, y].map(|param| distinct(table, param));
    if columns.len() < CELLS || rows.len() < CELLS {
        return None;
    }
    let mut members: Vec<(String, Vec<(&Case, &Row)>)> = Vec::new();
    for (case, row) in table.cases.iter().zip(&table.rows) {
        let name = others(table, case, &[x, y]);
        match members.iter_mut().find(|(known, _)| *known == name) {
            Some((_, all)) => all.push((case, row)),
            None => members.push((name, vec![(case, row)])),
        }
    }
    // Rows of a file are no grid.
    if members.iter().all(|(_, all)| 2 * all.len() < columns.len() * rows.len()) {
        return None;
    }
    let text = |param: usize, all: &[ParamValue]| -> Vec<String> {
        let shown = |value: &ParamValue| match value {
            ParamValue::Number(si) => crate::summary_table::number(from_si(*si, table.params[param].factor)),
            other => table.params[param].shown(other),
        };
        all.iter().map(shown).collect()
    };
    let map = |output: &Column, statistic: Statistic, (name, all): &(String, Vec<(&Case, &Row)>)| {
        let mut values = vec![vec![f64::NAN; columns.len()]; rows.len()];
        for (case, row) in all {
            let column = columns.iter().position(|value| *value == case.values[x]);
            let line = rows.iter().position(|value| *value == case.values[y]);
            if let (Some(column), Some(line)) = (column, line) {
                values[line][column] = table.value(row, output, |all| all.get(statistic));
            }
        }
        let known = || values.iter().flatten().filter(|value| value.is_finite());
        if known().all(|value| *value == 0.0) {
            return html! {};
        }
        let grid = Grid { columns: text(x, &columns), rows: text(y, &rows), values };
        let axis = |param: usize| Axis { what: &table.params[param].name, unit: &table.params[param].unit };
        let value = Axis { what: "", unit: &output.unit };
        let of = if name.is_empty() { String::new() } else { format!(", {name}") };
        let caption = format!(
            "{}: {} of each case over {} and {}{of}.",
            output.name,
            statistic.described(),
            table.params[x].name,
            table.params[y].name
        );
        figure(&heat_map::plot(&axis(x), &axis(y), &value, &grid), &caption)
    };
    let left_out = members.len().saturating_sub(MAPS);
    Some(html! {
        @if left_out > 0 { p.note { "The heat maps show the first " (MAPS) " of " (members.len()) " combinations of the other params; sweep.csv has all cases." } }
        @for output in &table.outputs { @for statistic in [Statistic::Max, Statistic::PeakToPeak] {
            @for member in members.iter().take(MAPS) { (map(output, statistic, member)) }
        } }
    })
}

/// Names the values of a case without those of some params.
fn others(table: &SweepTable, case: &Case, without: &[usize]) -> String {
    let others = table.params.iter().zip(&case.values).enumerate();
    let others = others.filter(|(param, _)| !without.contains(param));
    let mut parts: Vec<String> = others
        .map(|(_, (column, value))| {
            format!("{} = {} {}", column.name, column.shown(value), column.unit).trim_end().to_owned()
        })
        .collect();
    parts.splice(0..0, (!case.name.is_empty()).then(|| case.name.clone()));
    parts.join(", ")
}

fn curves(table: &SweepTable) -> Markup {
    let families = abscissa(table).map(|abscissa| (abscissa, families(table, abscissa)));
    // Cases that no curve connects.
    let Some((abscissa, families)) =
        families.filter(|(_, families)| families.iter().any(|(_, members)| members.len() > 1))
    else {
        return html! { @for output in &table.outputs { (bars(table, output)) } };
    };
    let left_out = families.len().saturating_sub(CURVES);
    html! {
        @if left_out > 0 {
            p.note { "The plots show the first " (CURVES) " of " (families.len()) " combinations of the other params; sweep.csv has all cases." }
        }
        @for output in &table.outputs {
            (plot(table, output, (abscissa, &families), ("largest value", |all| all.max)))
            (plot(table, output, (abscissa, &families), ("peak to peak", |all| all.peak_to_peak)))
        }
    }
}

fn plot(
    table: &SweepTable,
    output: &Column,
    (abscissa, families): (usize, &[Family<'_>]),
    (what, statistic): (&str, fn(&Statistics) -> Option<f64>),
) -> Markup {
    let param = &table.params[abscissa];
    let curve = |(index, (name, members)): (usize, &Family<'_>)| {
        let point = |(case, row): &(&Case, &Row)| {
            Some((from_si(number_of(case, abscissa)?, param.factor), table.value(row, output, statistic)))
        };
        let mut points: Vec<(f64, f64)> = members.iter().filter_map(point).collect();
        points.sort_by(|one, other| one.0.total_cmp(&other.0));
        Curve { name: name.clone(), colour: index, points, off: None }
    };
    let curves: Vec<Curve> = families.iter().take(CURVES).enumerate().map(curve).collect();
    if curves.iter().flat_map(|curve| &curve.points).all(|(_, y)| !y.is_finite() || *y == 0.0) {
        return PreEscaped(String::new());
    }
    let name = format!("{}, {what}", output.name);
    let x = Axis { what: &param.name, unit: &param.unit };
    let y = Axis { what: &name, unit: &output.unit };
    let caption = format!("{} over {}: {what} of each case.", output.name, param.name);
    let scale = if table.logarithmic.contains(&abscissa) { Scale::Logarithmic } else { Scale::Linear };
    figure(&chart::scaled_curves(WIDE, (scale, &x), &y, &curves, &[]), &caption)
}

/// Shows the largest value of an output in each case.
fn bars(table: &SweepTable, output: &Column) -> Markup {
    let value = |row: &Row| table.value(row, output, |all| all.max);
    let bars: Vec<(u64, f64)> = table.rows.iter().map(|row| (row.case as u64, value(row))).collect();
    let name = format!("{}, largest value", output.name);
    let (x, y) = (Axis { what: "case", unit: "" }, Axis { what: &name, unit: &output.unit });
    figure(&chart::bars(WIDE, &x, &y, &bars), &format!("{}: largest value of each case.", output.name))
}

fn cases(table: &SweepTable) -> Markup {
    let unit = |column: &Column| if column.unit == "1" { String::new() } else { column.unit.clone() };
    let shown = |value: f64| if value.is_nan() { String::new() } else { crate::summary_table::number(value) };
    html! {
        @if table.rows.len() > ROWS { p.note { "The first " (ROWS) " cases; sweep.csv has all." } }
        table.numbers {
            thead { tr {
                th { "case" }
                @if table.is_named() { th { "name" } }
                @for column in &table.params { th { (column.name) br; (unit(column)) } }
                @for column in &table.outputs { th { (column.name) br; "max, " (unit(column)) } }
                th { "failure" }
            } }
            tbody { @for (case, row) in table.cases.iter().zip(&table.rows).take(ROWS) { tr {
                td { (row.case) }
                @if table.is_named() { td { (case.name) } }
                @for (column, value) in table.params.iter().zip(&case.values) { td { (column.shown(value)) } }
                @for column in &table.outputs { td { (shown(table.value(row, column, |all| all.max))) } }
                td { (row.failure.as_deref().unwrap_or_default()) }
            } } }
        }
    }
}

/// Shows the lines that the model has printed in each case.
fn printed(table: &SweepTable) -> Markup {
    html! { @if table.has_printed() {
        section id="printed" {
            h2 { "Printed text" }
            @for (index, row) in table.rows.iter().enumerate().filter(|(_, row)| !row.printed.is_empty()).take(ROWS) {
                details { summary { (table.label(index)) } pre { (row.printed.join("\n")) } }
            }
        }
    } }
}

/// Lists each distinct warning with the numbers of its cases.
fn warnings(table: &SweepTable) -> Markup {
    let mut all: Vec<(&str, Vec<String>)> = Vec::new();
    for row in &table.rows {
        for warning in &row.warnings {
            match all.iter_mut().find(|(known, _)| known == warning) {
                Some((_, cases)) => cases.push(row.case.to_string()),
                None => all.push((warning, vec![row.case.to_string()])),
            }
        }
    }
    html! { @if !all.is_empty() {
        section id="warnings" {
            h2 { "Warnings" }
            ul { @for (warning, cases) in all { li { (warning) " (case " (cases.join(", ")) ")" } } }
        }
    } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::durations::Durations;
    use calyx_runtime::component_loads::{Component, ComponentLoads, LoadQuantity, LoadStatistics};
    use std::collections::BTreeMap;

    fn table() -> SweepTable {
        let column =
            |name: &str| Column { name: name.into(), unit: "N".into(), factor: 1.0, is_power: false };
        let case = |load: f64| Case { name: String::new(), values: vec![ParamValue::Number(load)] };
        let row = |(index, force): (usize, f64)| {
            let statistics = Statistics { max: Some(force), ..Statistics::default() };
            let constant = LoadStatistics { min: force, mean: force, max: force };
            let component = Component::Bearing { name: "left <1>".into(), kind: None };
            let quantities = vec![(LoadQuantity::RadialForce, constant)];
            Row {
                case: index + 1,
                outputs: BTreeMap::from([("force".to_owned(), statistics)]),
                components: Some(vec![ComponentLoads { component, quantities }]),
                printed: vec![format!("force {force}")],
                ..Row::default()
            }
        };
        SweepTable {
            params: vec![column("load")],
            outputs: vec![column("force")],
            cases: [10.0, 100.0, 1000.0].map(case).to_vec(),
            rows: [1.0, 2.0, 3.0].into_iter().enumerate().map(row).collect(),
            ..SweepTable::default()
        }
    }

    /// Returns the abscissas of the points of the first plot.
    fn points(page: &str) -> Vec<i32> {
        let plot = page.split("</svg>").next().expect("a plot");
        let circles = plot.split("<circle").skip(1);
        let abscissa = |circle: &str| circle.split("cx=\"").nth(1)?.split('"').next()?.parse().ok();
        circles.filter_map(abscissa).collect()
    }

    #[test]
    fn a_logarithmic_axis_has_equal_distances_of_equal_ratios() {
        let logarithmic = SweepTable { logarithmic: vec![0], ..table() };
        let at = points(&page(&logarithmic, None, &[]).into_string());
        assert_eq!(at.len(), 3);
        assert!((at[1] - at[0] - (at[2] - at[1])).abs() <= 1, "{at:?}");
        let at = points(&page(&table(), None, &[]).into_string());
        assert!(at[2] - at[1] > 5 * (at[1] - at[0]), "{at:?}");
    }

    #[test]
    fn load_cases_have_tables_of_components_and_the_duty_cycle() {
        let plain = page(&table(), None, &[]).into_string();
        assert!(!plain.contains("id=\"loads\"") && !plain.contains("id=\"duty-cycle\""));
        let durations = Durations { values: vec![1.0, 1.0, 2.0], are_times: false };
        let table = SweepTable { load_cases: true, durations: Some(durations), ..table() };
        let cycle = DutyCycle::of(&table, &[]);
        let shown = page(&table, cycle.as_ref(), &[]).into_string();
        for part in [
            "Radial force, mean, N",
            "<th scope=\"row\">left &lt;1&gt;</th><td>1</td><td>2</td><td><b>3</b></td>",
            "<th scope=\"row\">case 3</th><td>50 %</td>",
            "left &lt;1&gt; has springs instead of rolling elements",
            "<summary>case 2</summary><pre>force 2</pre>",
        ] {
            assert!(shown.contains(part), "the page lacks {part}");
        }
        let failed = page(&table, Some(&Err("case 2 failed".into())), &[]).into_string();
        assert!(failed.contains("There are no values over the duty cycle: case 2 failed."));
    }
}
