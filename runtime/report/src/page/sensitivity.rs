//! `sensitivities.html`: the sensitivities of a model as one self-contained page; and those that a
//! model requests in the report of its run.

use super::chart::{Axis, COLOURS, Curve, WIDE, curves};
use super::read::Run;
use super::{document, figure};
use crate::sample::Statistic;
use crate::sensitivity::{CHANGE, DerivativeRow, Entry, SensitivityTable};
use crate::summary_table::number;
use calyx_abi::units::from_si;
use maud::{Markup, PreEscaped, html};
use std::fs;
use std::io;
use std::path::Path;

/// File name of the page.
pub const NAME: &str = "sensitivities.html";

/// Writes the page.
///
/// # Errors
/// The file cannot be written.
pub fn write(path: &Path, all: &SensitivityTable) -> io::Result<()> {
    fs::write(path, page(all).into_string())
}

fn page(all: &SensitivityTable) -> Markup {
    let header = html! {
        @if let Some(line) = all.doc.lines().next().filter(|line| !line.is_empty()) { p { (line) } }
        p { "Change of outputs by small changes of params. Params are ranked by the effect of 1 % more of each: of its value or, if its range is narrower, of the width of the range." }
    };
    let main = html! {
        @for &output in &all.shown {
            section {
                h2 { (all.outputs[output].name) }
                @for statistic in all.shown_statistics() { (statistic_table(all, output, statistic)) }
                (course(all, output))
            }
        }
        @for own in &all.sensitivities { @if let Some(failure) = &own.failure {
            p.notice { "No derivative with respect to " code { (own.param.name) } ": " (failure.message) ". " (failure.help) "." }
        } }
        section { h2 { "About the derivatives" } (notes(&all.rows())) }
    };
    document(&format!("Sensitivities of {}", all.model), header, main)
}

fn unit(unit: &str) -> &str {
    if unit == "1" { "" } else { unit }
}

/// Shows the derivatives of a statistic, or states that it has no value.
fn statistic_table(all: &SensitivityTable, output: usize, statistic: Statistic) -> Markup {
    if all.value(output, statistic).is_none() {
        let title = if all.is_single() { "value" } else { statistic.described() };
        return html! { p.note { (title) ": none" } };
    }
    rows_table(&all.rows_of(output, statistic))
}

/// Shows the derivatives of a statistic, with a bar for the effect of each param.
fn rows_table(rows: &[DerivativeRow]) -> Markup {
    let Some(first) = rows.first() else { return PreEscaped(String::new()) };
    let effect = |row: &DerivativeRow| row.effect_of_1_percent.unwrap_or(f64::NAN);
    let largest = rows.iter().map(|row| effect(row).abs()).fold(0.0, f64::max);
    let title = Statistic::named(&first.statistic).map_or("value", Statistic::described);
    html! {
        h3 { (title) @if let Some(value) = first.value { ": " (number(value)) " " (unit(&first.unit)) } }
        table.numbers {
            thead { tr {
                th { "param" } th { "value" } th { "derivative" } th { "" }
                th { "effect of +1 %" br; (unit(&first.unit)) } th { "in %" } th { "" } th { "" }
            } }
            tbody { @for row in rows { tr {
                td.word { (row.param) }
                td { (number(row.param_value)) " " (unit(&row.param_unit)) }
                td { (row.shown_derivative()) }
                td.word { (row.derivative_unit) }
                td { (row.shown_effect()) }
                td { (row.shown_relative()) }
                td { (bar(if row.is_zero() { 0.0 } else { effect(row) / largest })) }
                td.word { (row.remarks().join(", ")) }
            } } }
        }
    }
}

/// Section of a run's report: the derivatives that the model requests.
pub(super) fn section(run: &Run) -> Markup {
    let outputs = run.sensitivities.chunk_by(|one, other| one.output == other.output);
    html! {
        @for rows in outputs {
            h3 { (rows[0].output) }
            @for rows in rows.chunk_by(|one, other| one.statistic == other.statistic) { (rows_table(rows)) }
        }
        @if !run.sensitivities.is_empty() { (notes(&run.sensitivities)) }
    }
}

/// Draws a part of the largest effect, from -1 to 1, as a bar from the middle.
fn bar(part: f64) -> Markup {
    let (half, height) = (60.0, 12.0);
    let part = if part.is_finite() { part } else { 0.0 };
    let width = half * part.abs();
    let left = if part < 0.0 { half - width } else { half };
    let colour = COLOURS[usize::from(part < 0.0)];
    let fill = format!("#{:02x}{:02x}{:02x}", colour.0, colour.1, colour.2);
    html! {
        svg width=(2.0 * half) height=(height) viewBox={ "0 0 " (2.0 * half) " " (height) } aria-hidden="true" {
            rect x=(format!("{left:.1}")) y="1" width=(format!("{width:.1}")) height=(height - 2.0) fill=(fill) {}
            line x1=(half) x2=(half) y1="0" y2=(height) stroke="currentColor" stroke-width="0.5" {}
        }
    }
}

/// Draws the effects of the params over the positions.
fn course(all: &SensitivityTable, output: usize) -> Markup {
    if all.is_single() {
        return PreEscaped(String::new());
    }
    let ranked = all.entries(output, Statistic::Max);
    let factor = all.outputs[output].factor;
    let in_cycle = all.positions.iter().any(|position| position.cycle != 0.0);
    let curve = |(colour, entry): (usize, &Entry)| {
        let own = &all.sensitivities[entry.param];
        let effect = |row: usize| {
            let derivative = own.positions[row][output];
            from_si(derivative.value() * CHANGE * own.param.scale(), factor)
        };
        let place = |row: usize| {
            let position = &all.positions[row];
            if in_cycle { position.cycle } else { position.time }
        };
        let points = (0..own.positions.len()).map(|row| (place(row), effect(row))).collect();
        Curve { name: all.params[entry.param].name.clone(), colour, points, off: None }
    };
    let drawn: Vec<Curve> = ranked
        .iter()
        .filter(|entry| !entry.is_zero() && entry.value().is_finite())
        .take(COLOURS.len())
        .enumerate()
        .map(curve)
        .collect();
    let x = if in_cycle { Axis { what: "mesh cycle", unit: "" } } else { Axis { what: "time", unit: "s" } };
    let y = Axis { what: "effect of +1 %", unit: unit(&all.outputs[output].unit) };
    let name = &all.outputs[output].name;
    let caption = format!("Change of {name} at each position if a param grows by 1 %.");
    figure(&curves(WIDE, &x, &y, &drawn, &[]), &caption)
}

/// Explains the remarks that some rows have.
fn notes(rows: &[DerivativeRow]) -> Markup {
    let any = |remark: &str| rows.iter().any(|row| row.remarks().iter().any(|one| one == remark));
    html! {
        p.note { "Derivatives keep the state of contact: the cells that carry force. Their errors are estimated from differences of two widths; errors below 0.01 % are not shown." }
        @if any("kink") { p.note { "At a kink, the derivatives towards smaller and larger values of the param differ, because a tooth pair comes into contact, or the largest value moves to another position." } }
        @if any("new structures") { p.note { "New structures: the param changes the stiffness of a body, which was computed again at each value." } }
    }
}
