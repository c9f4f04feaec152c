//! `sensitivities.html`: the sensitivities of a model as one self-contained page.

use super::chart::{Axis, COLOURS, Curve, WIDE, curves};
use super::{document, figure};
use crate::sample::Statistic;
use crate::sensitivity::{CHANGE, Entry, SensitivityTable, shown_derivative, shown_relative};
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
        (explanation(all))
    };
    document(&format!("Sensitivities of {}", all.model), header, main)
}

fn unit(unit: &str) -> &str {
    if unit == "1" { "" } else { unit }
}

/// Shows the derivatives of a statistic, with a bar for the effect of each param.
fn statistic_table(all: &SensitivityTable, output: usize, statistic: Statistic) -> Markup {
    let column = &all.outputs[output];
    let title = if all.is_single() { "value" } else { statistic.described() };
    let Some(value) = all.value(output, statistic) else {
        return html! { p.note { (title) ": none" } };
    };
    let entries = all.entries(output, statistic);
    let largest = entries.iter().map(|entry| entry.effect.abs()).fold(0.0, f64::max);
    html! {
        h3 { (title) ": " (number(value)) " " (unit(&column.unit)) }
        table.numbers {
            thead { tr {
                th { "param" } th { "value" } th { "derivative" } th { "" }
                th { "effect of +1 %" br; (unit(&column.unit)) } th { "in %" } th { "" } th { "" }
            } }
            tbody { @for entry in &entries {
                @let param = &all.params[entry.param];
                tr {
                    td.word { (param.name) }
                    td { (number(all.param_value(entry.param))) " " (unit(&param.unit)) }
                    td { (shown_derivative(entry)) }
                    td.word { (all.unit(output, entry.param)) }
                    td { @if entry.is_zero() { "0" } @else { (number(entry.effect)) } }
                    td { @if !entry.is_zero() { (shown_relative(entry, value)) } }
                    td { (bar(entry, largest)) }
                    td.word { (all.remarks(entry).join(", ")) }
                }
            } }
        }
    }
}

/// Draws the effect of a param as a bar from the middle.
fn bar(entry: &Entry, largest: f64) -> Markup {
    let part = if largest > 0.0 && entry.effect.is_finite() { entry.effect / largest } else { 0.0 };
    let (half, height) = (60.0, 12.0);
    let width = (half * part.abs()).max(if entry.is_zero() { 0.0 } else { 0.5 });
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

fn explanation(all: &SensitivityTable) -> Markup {
    let any = |remark: &str| {
        all.shown.iter().any(|&output| {
            let statistics = all.shown_statistics().into_iter();
            let mut entries = statistics.flat_map(|statistic| all.entries(output, statistic));
            entries.any(|entry| all.remarks(&entry).iter().any(|one| one == remark))
        })
    };
    html! {
        section {
            h2 { "About the derivatives" }
            p.note { "Derivatives keep the state of contact: the cells that carry force. Their errors are estimated from differences of two widths; errors below 0.01 % are not shown." }
            @if any("kink") { p.note { "At a kink, the derivatives towards smaller and larger values of the param differ, because a tooth pair comes into contact, or the largest value moves to another position." } }
            @if any("new structures") { p.note { "New structures: the param changes the stiffness of a body, which was computed again at each value." } }
        }
    }
}
