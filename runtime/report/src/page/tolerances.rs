//! Section of a sweep's page about toleranced params: their distributions, the distribution of each
//! output, and the params that explain it.

use super::chart::{self, Axis, COLOURS, Curve, FONT, Plot, WIDE, drawn};
use super::{described, figure, legend};
use crate::study::{Estimate, Group, Method, PERCENTILES, Sensitivities, Statistic, Variation};
use crate::summary_table::number;
use crate::sweep::{Column, SweepTable};
use calyx_abi::description::ParamValue;
use calyx_abi::units::from_si;
use maud::{Markup, PreEscaped, html};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Largest number of combinations of the other axes that are shown, one per colour.
const GROUPS: usize = 6;
/// Largest number of params in a bar chart.
const BARS: usize = 8;
/// Size of a bar chart: its width, and the heights of a bar with its name and of the abscissa.
const BAR_CHART: [i32; 3] = [640, 66, 110];
/// Largest number of samples of which each step of the distribution function is drawn.
const STEPS: usize = 400;

/// Shows the statistics of a sample; nothing without one.
pub fn section(table: &SweepTable, groups: &[Group]) -> Markup {
    let (Some(sample), false) = (&table.sample, groups.is_empty()) else {
        return PreEscaped(String::new());
    };
    let fixed = groups[0].values.len();
    let failed: usize = groups.iter().map(|group| group.failed).sum();
    let few = groups.iter().flat_map(|group| &group.variations);
    let few = few.filter_map(|variation| variation.sensitivities.as_ref().ok()).any(|all| all.uncertain);
    html! {
        section id="tolerances" {
            h2 { "Tolerances" }
            p { (sample.count) " samples (" (sample.method.described()) ", seed " (sample.seed) ") of" }
            table {
                thead { tr { th { "param" } th { "distribution" } } }
                tbody { @for (column, distribution) in table.params[fixed..].iter().zip(&sample.distributions) {
                    tr { th scope="row" { code { (column.name) } } td { (distribution) } }
                } }
            }
            p.note { (explanation(sample.method)) }
            @if failed > 0 { p.notice.alarm {
                b { (failed) " failed cases" } " are left out of the statistics. If they fail because of their values, the statistics are biased."
            } }
            @if few { p.notice { "The samples are few for so many params: compare the intervals of the sensitivities, not the values." } }
            @if groups.len() > GROUPS { p.note { "The plots show the first " (GROUPS) " of " (groups.len()) " combinations of the other params; the files have all." } }
            (percentiles_over_axis(table, groups))
            @for variation in shown(&groups[0]).filter(|variation| variation.varies()) { (output(table, groups, variation)) }
            @for group in groups.iter().take(GROUPS) { (statistics(table, group)) }
        }
    }
}

/// States how the intervals are computed.
fn explanation(method: Method) -> &'static str {
    match method {
        Method::Random => {
            "Intervals contain the true value with a probability of 95 %: percentiles between order statistics, means by Student's t distribution, standard deviations by Bonett (2006). A dash means that the samples are too few for a bound."
        }
        Method::LatinHypercube | Method::Sobol => {
            "Intervals are those of independent random samples: percentiles between order statistics, means by Student's t distribution, standard deviations by Bonett (2006). The points of this method are more even, so that the intervals are wider than necessary and contain the true value with a probability of at least about 95 %. A dash means that the samples are too few for a bound."
        }
    }
}

/// Returns the variations that are drawn: largest values, and peak-to-peak values that vary.
fn shown(group: &Group) -> impl Iterator<Item = &Variation> {
    group.variations.iter().filter(|variation| match variation.statistic {
        Statistic::Max => true,
        Statistic::PeakToPeak => variation.varies(),
        Statistic::Min | Statistic::Mean => false,
    })
}

fn unit(column: &Column) -> &str {
    if column.unit == "1" { "" } else { &column.unit }
}

fn name(table: &SweepTable, variation: &Variation) -> String {
    format!("{}, {}", table.outputs[variation.output].name, variation.statistic.described())
}

/// Returns the same variation of another group.
fn same<'g>(group: &'g Group, variation: &Variation) -> Option<&'g Variation> {
    let mut all = group.variations.iter();
    all.find(|other| other.output == variation.output && other.statistic == variation.statistic)
}

/// Shows the distribution of an output and what explains it.
fn output(table: &SweepTable, groups: &[Group], first: &Variation) -> Markup {
    let column = &table.outputs[first.output];
    let name = name(table, first);
    let curve = |(colour, group): (usize, &Group)| {
        let variation = same(group, first)?;
        let label = if groups.len() > 1 { group.label(table) } else { String::new() };
        Some(Curve { name: label, colour, points: steps(&variation.sorted), off: None })
    };
    let curves: Vec<Curve> = groups.iter().take(GROUPS).enumerate().filter_map(curve).collect();
    let marks: Vec<(f64, String)> = match groups.len() {
        1 => PERCENTILES
            .iter()
            .zip(&first.percentiles)
            .map(|(percent, estimate)| (estimate.value, format!("{percent} %")))
            .collect(),
        _ => Vec::new(),
    };
    let x = Axis { what: &name, unit: unit(column) };
    let y = Axis { what: "samples below", unit: "%" };
    let plot = chart::curves(WIDE, &x, &y, &curves, &marks);
    let caption = format!(
        "{name}: cumulative distribution{}.",
        if marks.is_empty() { "" } else { " with percentiles" }
    );
    let params = &table.params[groups[0].values.len()..];
    let explained = |group: &Group| -> Option<Markup> {
        let variation = same(group, first)?;
        let label = if groups.len() > 1 { format!(", {}", group.label(table)) } else { String::new() };
        Some(match &variation.sensitivities {
            Ok(all) => {
                let caption = format!(
                    "Share of the variance that a param explains alone{label} (first-order Sobol index, with 95 % interval). Sum: {:.0} %.",
                    100.0 * sum(all)
                );
                html! { figure { (described(&bars(params, all), &caption)) figcaption { (caption) } } }
            }
            Err(reason) => html! { p.note { "No influences of params" (label) ": " (reason) "." } },
        })
    };
    html! {
        article.output {
            h3 { (name) }
            div.side {
                div.wide { figure { (described(&plot.svg, &caption)) (legend(&plot)) figcaption { (caption) } } }
                div.narrow { @for group in groups.iter().take(1) { @if let Some(shown) = explained(group) { (shown) } } }
            }
            @if groups.len() > 1 { details {
                summary { "Influence of the params at the other combinations" }
                div.side { @for group in groups.iter().skip(1).take(GROUPS - 1) { @if let Some(shown) = explained(group) { div.narrow { (shown) } } } }
            } }
        }
    }
}

fn sum(all: &Sensitivities) -> f64 {
    all.params.iter().map(|param| param.first_order.value).sum()
}

/// Returns the empirical distribution function as steps, in per cent; of many samples as a line
/// through some of them.
fn steps(sorted: &[f64]) -> Vec<(f64, f64)> {
    let count = sorted.len();
    let percent = |k: usize| 100.0 * k as f64 / count as f64;
    if count <= STEPS {
        return sorted
            .iter()
            .enumerate()
            .flat_map(|(k, y)| [(*y, percent(k)), (*y, percent(k + 1))])
            .collect();
    }
    let at = |k: usize| k * (count - 1) / (STEPS - 1);
    (0..STEPS).map(at).map(|k| (sorted[k], percent(k) + 50.0 / count as f64)).collect()
}

/// Draws bars of the first-order indices with their intervals, the largest first. Each name is
/// above its bar.
fn bars(params: &[Column], all: &Sensitivities) -> String {
    let [width, step, below] = BAR_CHART;
    let order: Vec<usize> = all.order().into_iter().take(BARS).collect();
    let size = (width as u32, (step * order.len() as i32 + below) as u32);
    drawn(size, |area| {
        let (left, right) = (16, width - 40);
        let x = |part: f64| left + (f64::from(right - left) * part).round() as i32;
        let bottom = step * order.len() as i32 + 12;
        let text = ("sans-serif", FONT - 5).into_font().color(&BLACK);
        for quarter in 0..=4 {
            let part = f64::from(quarter) / 4.0;
            let line = vec![(x(part), 8), (x(part), bottom)];
            area.draw(&PathElement::new(line, BLACK.mix(0.15)))?;
            let style = text.clone().pos(Pos::new(HPos::Center, VPos::Top));
            area.draw(&Text::new(format!("{}", 25 * quarter), (x(part), bottom + 8), style))?;
        }
        let style = text.clone().pos(Pos::new(HPos::Center, VPos::Top));
        area.draw(&Text::new("share of the variance, %", (x(0.5), bottom + 48), style))?;
        for (k, &index) in order.iter().enumerate() {
            let top = step * k as i32 + 8;
            let Estimate { value, low, high } = all.params[index].first_order;
            let name = format!("{}: {:.0} %", params[index].name, 100.0 * value);
            area.draw(&Text::new(name, (left + 4, top), text.clone()))?;
            let corners = [(x(0.0), top + 34), (x(value), top + 54)];
            area.draw(&Rectangle::new(corners, COLOURS[0].filled()))?;
            if let (Some(low), Some(high)) = (low, high) {
                let line = vec![(x(low), top + 44), (x(high), top + 44)];
                area.draw(&PathElement::new(line, BLACK.stroke_width(2)))?;
                for end in [low, high] {
                    let line = vec![(x(end), top + 37), (x(end), top + 51)];
                    area.draw(&PathElement::new(line, BLACK.stroke_width(2)))?;
                }
            }
        }
        Ok(())
    })
}

/// Shows percentiles over the other axis, if it is the only one and has numbers.
fn percentiles_over_axis(table: &SweepTable, groups: &[Group]) -> Markup {
    let at = |group: &Group| match group.values[..] {
        [ParamValue::Number(si)] => Some(from_si(si, table.params[0].factor)),
        _ => None,
    };
    let places: Option<Vec<f64>> = groups.iter().map(at).collect();
    let Some(places) = places.filter(|places| places.len() > 2) else { return PreEscaped(String::new()) };
    let plot = |first: &Variation| -> (Plot, String) {
        let curve = |(colour, k): (usize, usize)| {
            let point =
                |(place, group): (&f64, &Group)| Some((*place, same(group, first)?.percentiles[k].value));
            let points = places.iter().zip(groups).filter_map(point).collect();
            Curve {
                name: format!("{} % of the samples are below", PERCENTILES[k]),
                colour,
                points,
                off: None,
            }
        };
        let curves: Vec<Curve> = [1, 2, 3].into_iter().enumerate().map(curve).collect();
        let name = name(table, first);
        let x = Axis { what: &table.params[0].name, unit: unit(&table.params[0]) };
        let y = Axis { what: &name, unit: unit(&table.outputs[first.output]) };
        let caption = format!("{name} over {}: percentiles of the samples.", table.params[0].name);
        (chart::curves(WIDE, &x, &y, &curves, &[]), caption)
    };
    html! { @for variation in shown(&groups[0]) {
        @let (plot, caption) = plot(variation);
        (figure(&plot, &caption))
    } }
}

/// Shows the statistics of a group as a table.
fn statistics(table: &SweepTable, group: &Group) -> Markup {
    let label = group.label(table);
    let bound = |bound: Option<f64>| bound.map_or("–".to_owned(), number);
    let cell = |estimate: &Estimate| {
        html! { td { (number(estimate.value)) br; small { (bound(estimate.low)) " .. " (bound(estimate.high)) } } }
    };
    let params = &table.params[group.values.len()..];
    html! { details open[group.values.is_empty()] {
        summary { "Statistics with 95 % intervals" @if !label.is_empty() { ", " (label) } ", " (group.solved) " samples" }
        table.numbers {
            thead { tr {
                th { "output" } th { "mean" } th { "standard deviation" }
                @for percent in PERCENTILES { th { (percent) " %" } }
            } }
            tbody { @for variation in shown(group) { tr {
                th scope="row" { (name(table, variation)) br; (unit(&table.outputs[variation.output])) }
                (cell(&variation.mean)) (cell(&variation.standard_deviation))
                @for estimate in &variation.percentiles { (cell(estimate)) }
            } } }
        }
        table.numbers {
            thead { tr {
                th { "output" } th.word { "param" } th { "first-order index" } th { "rank coefficient" } th { "R² of the ranks" }
            } }
            tbody { @for variation in shown(group) { @if let Ok(all) = &variation.sensitivities {
                @for (k, index) in all.order().into_iter().enumerate() { tr {
                    th scope="row" { @if k == 0 { (name(table, variation)) } }
                    td.word { code { (params[index].name) } }
                    (cell(&all.params[index].first_order)) (cell(&all.params[index].rank_coefficient))
                    td { @if k == 0 { (format!("{:.3}", all.rank_r2)) } }
                } }
            } } }
        }
    } }
}
