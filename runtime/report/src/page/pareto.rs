//! Trade-off of two objectives: all cases, and the Pareto front of those that no other case
//! surpasses in both.

use super::chart::{Axis, COLOURS, Error, Plot, TALL, drawn, mesh, small, span};
use super::figure;
use crate::study::Objective;
use crate::summary_table::number;
use crate::sweep::{Column, Row, SweepTable};
use maud::{Markup, PreEscaped, html};
use plotters::prelude::*;

/// Largest number of cases on the front whose labels are drawn.
const LABELLED: usize = 12;
/// Largest number of rows in the table of the front.
const ROWS: usize = 50;

/// Shows the trade-off of the two objectives of a table; nothing without them.
pub fn section(table: &SweepTable) -> Markup {
    let [first, second] = &table.objectives[..] else { return PreEscaped(String::new()) };
    let column = |objective: &Objective| table.outputs.iter().find(|column| column.name == objective.output);
    let (Some(x), Some(y)) = (column(first), column(second)) else { return PreEscaped(String::new()) };
    let value = |row: &Row, column: &Column, objective: &Objective| {
        table.value(row, column, |all| all.get(objective.statistic))
    };
    let points: Vec<(usize, [f64; 2])> = table
        .rows
        .iter()
        .enumerate()
        .filter(|(_, row)| row.failure.is_none())
        .map(|(index, row)| (index, [value(row, x, first), value(row, y, second)]))
        .filter(|(_, at)| at.iter().all(|value| value.is_finite()))
        .collect();
    let front = front(&points, [first.maximize, second.maximize]);
    if front.is_empty() {
        return html! { section id="trade-off" { h2 { "Trade-off" } p { "No solved case has values of both objectives." } } };
    }
    let names = [first, second].map(named);
    let unit = |column: &'_ Column| if column.unit == "1" { String::new() } else { column.unit.clone() };
    let units = [unit(x), unit(y)];
    let goal = |objective: &Objective| if objective.maximize { "maximize" } else { "minimize" };
    let axes = [0, 1].map(|k| Axis { what: &names[k], unit: &units[k] });
    let caption = format!(
        "Trade-off: {} {} and {} {}. A dot is a case, and the line is the Pareto front: no other case is at least as good in both objectives and better in one. {} of {} cases are on the front.",
        goal(first),
        names[0],
        goal(second),
        names[1],
        front.len(),
        points.len()
    );
    let plot = plot(table, &axes, &points, (&front, first.maximize));
    html! {
        section id="trade-off" {
            h2 { "Trade-off" }
            (figure(&plot, &caption))
            table.numbers {
                thead { tr {
                    th { "case on the front" }
                    @for column in &table.params { th { (column.name) br; (unit(column)) } }
                    @for k in 0..2 { th { (names[k]) br; (units[k]) } }
                } }
                tbody { @for (index, at) in front.iter().take(ROWS) { tr {
                    td { (table.label(*index)) }
                    @for (column, value) in table.params.iter().zip(&table.cases[*index].values) { td { (column.shown(value)) } }
                    @for value in at { td { (number(*value)) } }
                } } }
            }
            @if front.len() > ROWS { p.note { "The first " (ROWS) " of " (front.len()) " cases on the front." } }
        }
    }
}

/// Returns the name of the value that an objective compares.
fn named(objective: &Objective) -> String {
    format!("{}, {}", objective.output, objective.statistic.described())
}

/// Returns the points that no other one surpasses, in the order of the first objective.
fn front(points: &[(usize, [f64; 2])], maximize: [bool; 2]) -> Vec<(usize, [f64; 2])> {
    let sign = maximize.map(|maximize| if maximize { -1.0 } else { 1.0 });
    let cost = |at: &[f64; 2]| [sign[0] * at[0], sign[1] * at[1]];
    let mut order = points.to_vec();
    order.sort_by(|(_, one), (_, other)| {
        let (one, other) = (cost(one), cost(other));
        one[0].total_cmp(&other[0]).then(one[1].total_cmp(&other[1]))
    });
    let mut front: Vec<(usize, [f64; 2])> = Vec::new();
    for (index, at) in order {
        let is_better = front.last().is_none_or(|(_, last)| {
            // Equal points are all on the front.
            cost(&at)[1] < cost(last)[1] || at == *last
        });
        if is_better {
            front.push((index, at));
        }
    }
    front
}

fn plot(
    table: &SweepTable,
    axes: &[Axis<'_>; 2],
    points: &[(usize, [f64; 2])],
    (front, maximize): (&[(usize, [f64; 2])], bool),
) -> Plot {
    let ends = |k: usize| span(points.iter().map(|(_, at)| at[k]), 0.06);
    let (Some(across), Some(up)) = (ends(0), ends(1)) else { return Plot::default() };
    let svg = drawn(TALL, |area| -> Result<(), Error> {
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_right(36)
            .margin_top(16)
            .x_label_area_size(88)
            .y_label_area_size(164)
            .build_cartesian_2d(across.clone(), up.clone())?;
        mesh(&mut chart, &axes[0], &axes[1], [small(&across), small(&up)])?;
        chart
            .draw_series(points.iter().map(|(_, at)| Circle::new((at[0], at[1]), 5, COLOURS[0].filled())))?;
        // The attainable values: the front is a staircase.
        let mut stairs: Vec<(f64, f64)> = Vec::new();
        for (_, at) in front {
            stairs.extend(stairs.last().map(|(_, before)| (at[0], *before)));
            stairs.push((at[0], at[1]));
        }
        let last = if maximize { across.start } else { across.end };
        stairs.extend(stairs.last().map(|(_, y)| (last, *y)));
        chart.draw_series(LineSeries::new(stairs, COLOURS[1].stroke_width(3)))?;
        chart.draw_series(front.iter().map(|(_, at)| Circle::new((at[0], at[1]), 8, COLOURS[1].filled())))?;
        if front.len() <= LABELLED {
            for (index, at) in front {
                let (x, y) = chart.backend_coord(&(at[0], at[1]));
                let style = ("sans-serif", 26).into_font().color(&BLACK);
                let number = table.rows[*index].case.to_string();
                area.draw(&Text::new(number, (x + 12, y - 34), style))?;
            }
        }
        Ok(())
    });
    let legend = vec![(0, "cases".to_owned()), (1, "Pareto front, with numbers of cases".to_owned())];
    Plot { svg, legend, band_is_cut: false }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_has_the_cases_that_no_other_surpasses() {
        let points = [
            (0, [1.0, 5.0]),
            (1, [2.0, 3.0]),
            (2, [3.0, 3.0]),
            (3, [4.0, 1.0]),
            (4, [2.0, 4.0]),
            (5, [4.0, 1.0]),
        ];
        let numbers = |maximize| front(&points, maximize).iter().map(|point| point.0).collect::<Vec<_>>();
        assert_eq!(numbers([false, false]), [0, 1, 3, 5]);
        assert_eq!(numbers([true, true]), [3, 5, 2, 4, 0]);
        assert_eq!(numbers([true, false]), [3, 5]);
    }
}
