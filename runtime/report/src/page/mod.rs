//! `report.html`: a run as one self-contained HTML page that requires no network, other files or
//! scripts.
//!
//! It is generated from the files of the run directory alone, so `calyx report` generates the same
//! page for an old or a killed run. All durations are in the section `time`, the only part that
//! differs between two runs of one model.

mod about;
mod accuracy;
mod bearings;
mod bodies;
mod chart;
mod command_line;
mod contact;
mod fillets;
mod flanks;
mod gear_data;
mod heat_map;
mod k_chart;
mod load_cases;
mod logarithmic;
mod noise;
pub mod optimization;
mod parallel;
mod pareto;
mod polar;
mod power_flow;
mod projection;
mod read;
pub mod sensitivity;
pub mod sweep;
mod tolerances;
mod units;
mod vibration;
mod waterfall;

use crate::directory::REPORT;
use crate::summary_table::{variation, without_rounding};
use calyx_abi::units::shortest;
use chart::{Axis, Curve, NARROW, Plot, WIDE};
use maud::{DOCTYPE, Markup, PreEscaped, html};
use read::{End, Output, Run};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use units::Units;

/// Returns a self-contained page with a title, what follows it in the header, and the content.
fn document(title: &str, header: Markup, main: Markup) -> Markup {
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(include_str!("style.css"))) }
            }
            body {
                header { h1 { (title) } (header) }
                main { (main) }
            }
        }
    }
}

/// Names of the finished page and of the one that is being written, in a run directory.
pub const FILES: [&str; 2] = [REPORT, "report.html.part"];

/// Generates the page of the run in a directory, replaces an earlier page, and returns its path.
///
/// # Errors
/// There is no run, its files cannot be read, or the page cannot be written.
pub fn write(directory: &Path) -> io::Result<PathBuf> {
    write_run(directory, &Run::read(directory)?)
}

fn write_run(directory: &Path, run: &Run) -> io::Result<PathBuf> {
    let page = page(run).into_string();
    let (path, unfinished) = (directory.join(REPORT), directory.join(FILES[1]));
    fs::write(&unfinished, page)?;
    fs::rename(unfinished, &path)?;
    Ok(path)
}

/// Generates the page as [`write()`] does. Returns the settings that reduce large estimated errors,
/// in one line; `None` if no error is large.
///
/// # Errors
/// Fails as [`write()`] does.
pub fn write_with_advice(directory: &Path) -> io::Result<Option<String>> {
    let run = Run::read(directory)?;
    write_run(directory, &run)?;
    Ok(accuracy::advice(&run.outputs))
}

/// Returns true if a directory has a run: its summary or its journal.
pub fn is_run(directory: &Path) -> bool {
    directory.join("run.json").exists() || crate::journal::path(directory).exists()
}

/// Returns the heading of the output plots, which names their abscissa.
fn plots_heading(run: &Run) -> &'static str {
    match run.positions.len() {
        _ if run.is_calculation() => "Values",
        0 | 1 => "Positions",
        _ if by_time(run) => "Over time",
        _ => "Over the mesh cycle",
    }
}

/// Anchor, title and content of a section.
type Section = (&'static str, &'static str, Markup);

fn page(run: &Run) -> Markup {
    let units = Units::of_system(run.text("units"));
    let sections: Vec<Section> = [
        // A wrong datum of a gear invalidates all results, so the data come first.
        ("gears", "Gear data", gear_data::section(run)),
        ("power-flow", "Power flow", power_flow::section(run)),
        ("outputs", "Outputs", summary(run)),
        ("accuracy", "Error estimates", accuracy::section(run)),
        ("sensitivities", "Sensitivities", sensitivity::section(run)),
        ("cycle", plots_heading(run), plots(run)),
        ("flanks", "Flanks", flanks::section(run, units)),
        ("tooth-contact", "Tooth contact", projection::section(run, units)),
        ("contact", "Contact", contact_section(run, units)),
        ("stress", "Root stress", stress_section(run, units)),
        ("bearings", "Rolling bearings", bearings::section(run, units)),
        ("bodies", "Deformed bodies", bodies::section(run, units)),
        ("signals", "Spectra", signals(run)),
        ("vibration", "Forced vibration", vibration::section(run, units)),
        ("noise", "Radiated sound", noise::section(run)),
        ("modes", "Modes", modes(run)),
        ("plan", "Model", about::plan(run)),
        ("params", "Params", about::params(run)),
        ("solved", "Solver residuals", about::certificate(run)),
        ("time", "Time and memory", about::timing(run)),
        ("origin", "Provenance", about::origin(run)),
    ]
    .into_iter()
    .filter(|(_, _, content)| !content.0.is_empty())
    .collect();
    let (title, rest) = title(run);
    html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                meta name="generator" content={ "Calyx " (run.text("calyx")) };
                title { (title.replace('`', "")) }
                style { (PreEscaped(include_str!("style.css"))) }
            }
            body {
                header {
                    h1 { (prose(&title)) }
                    @for paragraph in rest { p { (prose(&paragraph)) } }
                    (about::facts(run))
                    (about::notices(run))
                    (about::scene(run))
                    nav { ul { @for (name, title, _) in &sections { li { a href={ "#" (name) } { (title) } } } } }
                }
                main {
                    @for (name, title, content) in &sections {
                        section id=(name) { h2 { (title) } (content) }
                    }
                }
            }
        }
    }
}

/// Returns the first sentence of the model's doc comment, and the rest.
fn title(run: &Run) -> (String, Vec<String>) {
    let mut paragraphs = paragraphs(run.text("doc"));
    if paragraphs.is_empty() {
        return (run.text("model").to_owned(), Vec::new());
    }
    let first = paragraphs.remove(0);
    // A sentence starts with a capital.
    let end = first.match_indices(". ").find(|(at, _)| first[at + 2..].starts_with(char::is_uppercase));
    let (sentence, rest) = match end {
        Some((at, _)) => (&first[..at], Some(first[at + 2..].to_owned())),
        None => (&first[..], None),
    };
    (sentence.trim_end_matches('.').to_owned(), rest.into_iter().chain(paragraphs).collect())
}

/// Formats a doc comment; text between backticks is code.
fn prose(text: &str) -> Markup {
    let pieces: Vec<&str> = text.split('`').collect();
    // Unpaired backticks are plain text.
    if pieces.len().is_multiple_of(2) {
        return html! { (text) };
    }
    html! { @for (index, piece) in pieces.iter().enumerate() {
        @if index % 2 == 1 { code { (piece) } } @else { (piece) }
    } }
}

/// Splits a doc comment into paragraphs: consecutive lines are joined.
fn paragraphs(doc: &str) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut open = false;
    for line in doc.lines().map(str::trim) {
        match all.last_mut().filter(|_| open) {
            Some(last) if !line.is_empty() => {
                last.push(' ');
                last.push_str(line);
            }
            _ if !line.is_empty() => all.push(line.to_owned()),
            _ => {}
        }
        open = !line.is_empty();
    }
    all
}

/// Returns true if positions differ in time alone, as in a dynamic analysis.
fn by_time(run: &Run) -> bool {
    run.positions.iter().all(|position| position.cycle == 0.0 && position.roll == 0.0)
}

/// Formats four significant digits.
fn number(value: f64) -> String {
    if !value.is_finite() {
        return if value.is_nan() { "–".into() } else { format!("{value}") };
    }
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    shortest(rounded)
}

/// Formats an error with two digits, and never as zero.
fn error(value: f64) -> String {
    format!("± {}", shortest(format!("{value:.1e}").parse().unwrap_or(value)))
}

/// Formats a fraction in per cent.
fn percent(part: f64) -> String {
    let percent = 100.0 * part;
    match percent {
        _ if !percent.is_finite() => "–".into(),
        _ if percent != 0.0 && percent.abs() < 1e-3 => format!("{percent:.0e} %"),
        _ => format!("{} %", shortest(format!("{percent:.1e}").parse().unwrap_or(percent))),
    }
}

/// Errors below this fraction of a value are rounding errors.
const DIGITS: f64 = 1e-12;

/// Formats an error relative to its value.
fn part_of_value(estimate: &read::Estimate) -> String {
    match estimate.is_rounding {
        true => "rounding".into(),
        false if estimate.relative < DIGITS => percent(0.0),
        false => percent(estimate.relative),
    }
}

/// Shows a plot with a caption; nothing if it is empty. The caption is also the text for screen
/// readers.
fn figure(plot: &Plot, caption: &str) -> Markup {
    if plot.is_empty() {
        return PreEscaped(String::new());
    }
    html! { figure { (described(&plot.svg, caption)) (legend(plot)) figcaption { (caption) } } }
}

/// Shows the legend of a plot.
fn legend(plot: &Plot) -> Markup {
    html! { @if !plot.legend.is_empty() {
        p.legend { @for (colour, name) in &plot.legend { span class={ "c" (colour) } { (name) } " " } }
    } }
}

/// Shows a drawing as an image with an accessible name.
fn described(svg: &str, name: &str) -> Markup {
    let opening = format!("<svg role=\"img\" aria-label=\"{}\" ", html! { (name) }.into_string());
    // The element is replaced by one of the page; everything before it does not belong in HTML.
    let svg = svg.find("<svg ").map_or("", |at| &svg[at + 5..]);
    let svg = if svg.is_empty() { String::new() } else { opening + svg };
    // Wide drawings scroll on a narrow screen.
    html! { @if !svg.is_empty() { div.drawing { (PreEscaped(svg)) } } }
}

/// Shows the table of all outputs.
fn summary(run: &Run) -> Markup {
    if run.outputs.is_empty() {
        return PreEscaped(String::new());
    }
    if run.is_calculation() {
        return values(run);
    }
    let estimated = run.outputs.iter().any(|output| output.error.is_some());
    html! {
        table.numbers {
            thead { tr {
                th { "output" } th.word { "unit" } th { "min" } th { "mean" } th { "max" }
                @if estimated { th { (accuracy::error_header(run)) } th {} }
                th { "peak to peak" }
                th { "max at" }
            } }
            tbody { @for output in &run.outputs {
                @let of = output.statistics;
                @let rounding = output.error.as_ref().map_or(0.0, |error| error.rounding);
                @let value = |value| number(without_rounding(value, of.magnitude(), rounding));
                @if !output.has_values() { tr.faint {
                    th scope="row" { code { (output.name) } }
                    td.word { (output.unit) }
                    td.word colspan=(if estimated { "7" } else { "5" }) { "no value" }
                } } @else if let Some(choices) = output.shown_choices() { tr {
                    th scope="row" { a href={ "#output-" (output.name) } { code { (output.name) } } }
                    td {}
                    td.word colspan=(if estimated { "7" } else { "5" }) { (choices) }
                } } @else { tr {
                    th scope="row" { a href={ "#output-" (output.name) } { code { (output.name) } } }
                    td.word { (output.unit) }
                    td { (value(of.min)) }
                    td { @match of.mean { Some(mean) => (value(mean)), None => "–" } }
                    td.main { (value(of.max)) }
                    @if estimated { @match &output.error {
                        Some(of) => { td { (accuracy::of_largest(output, of)) } td { (part_of_value(of)) } },
                        None => { td { "–" } td {} },
                    } }
                    td { (value(variation([of.min, of.max], of.peak_to_peak))) }
                    td.word { (output.place) }
                } }
            } }
        }
        (accuracy::without_level(run))
        @if run.end != End::Finished {
            p.note { "Statistics of the positions solved so far; the mean is available after the last position." }
        }
    }
}

/// Shows the outputs of a model without an analysis.
fn values(run: &Run) -> Markup {
    html! {
        table.numbers {
            thead { tr { th { "output" } th.word { "unit" } th { "value" } } }
            tbody { @for output in &run.outputs { tr {
                th scope="row" { a href={ "#output-" (output.name) } { code { (output.name) } } }
                td.word { (output.unit) }
                td.main { (output.shown_choices().unwrap_or_else(|| number(output.statistics.max))) }
            } } }
        }
    }
}

/// Plots of the outputs, with their harmonics.
fn plots(run: &Run) -> Markup {
    if run.outputs.is_empty() || run.positions.is_empty() {
        return PreEscaped(String::new());
    }
    let by_time = by_time(run);
    let clock = units::clock(run.positions.iter().map(|position| position.time));
    let x = match by_time {
        true => Axis { what: "time", unit: clock.name },
        false => Axis { what: "roll angle of the entering tooth pair on the first gear", unit: "deg" },
    };
    let place = |position: &read::Position| match by_time {
        true => clock.of(position.time),
        false => position.roll.to_degrees(),
    };
    let places: Vec<f64> = run.positions.iter().map(place).collect();
    let named = run.positions.iter().zip(&places).filter(|(position, _)| !position.point.is_empty());
    let marks: Vec<(f64, String)> = named.map(|(position, place)| (*place, position.point.clone())).collect();
    let banded = run.outputs.iter().any(|output| output.error.is_some());
    html! {
        @if banded { p.note { "The band is the estimated error: that of the minimum at the minimum, that of the maximum at the maximum, and interpolated in between." } }
        @for output in run.outputs.iter().filter(|output| output.has_values()) {
            @match output.shown_choices() {
                Some(choices) => (choice_article(output, &choices)),
                None => (plot(output, &x, &places, &marks)),
            }
        }
    }
}

/// Shows an output whose values are the choices of an enumeration, which have no curve.
fn choice_article(output: &Output, choices: &str) -> Markup {
    html! {
        article.output id={ "output-" (output.name) } {
            h3 { code { (output.name) } }
            @for paragraph in paragraphs(&output.doc) { p { (prose(&paragraph)) } }
            p { b { (choices) } @if !choices.contains(" at ") && output.values.len() > 1 { " at all positions." } }
        }
    }
}

fn plot(output: &Output, x: &Axis<'_>, places: &[f64], marks: &[(f64, String)]) -> Markup {
    let points = places.iter().copied().zip(output.values.iter().copied()).collect();
    let off = output.error.as_ref().map(|error| [error.total.min.abs(), error.total.max.abs()]);
    let curve = Curve { points, off, ..Curve::default() };
    let y = Axis { what: "", unit: &output.unit };
    let is_rounding = output.error.as_ref().is_some_and(|error| error.is_rounding);
    // A single position or a constant has no variation to plot.
    let read::Statistics { min, max, peak_to_peak, .. } = output.statistics;
    let constant = variation([min, max], peak_to_peak) == 0.0;
    let variation = match is_rounding || constant {
        true => Plot::default(),
        false => chart::curves(WIDE, x, &y, &[curve], marks),
    };
    let order = Axis { what: "multiple of the mesh frequency", unit: "" };
    let harmonics =
        chart::bars(NARROW, &order, &Axis { what: "amplitude", unit: &output.unit }, &output.harmonics);
    let unit = if output.unit.is_empty() { String::new() } else { format!(" in {}", output.unit) };
    let name = format!(
        "{}{unit}: {} to {}",
        output.name,
        number(output.statistics.min),
        number(output.statistics.max)
    );
    html! {
        article.output id={ "output-" (output.name) } {
            h3 { code { (output.name) } @if !output.unit.is_empty() { small { " [" (output.unit) "]" } } }
            @for paragraph in paragraphs(&output.doc) { p { (prose(&paragraph)) } }
            (accuracy::of_output(output))
            @if constant {
                p { b { (number(output.statistics.max)) " " (output.unit) } @if places.len() > 1 { " at all positions." } }
            }
            @if !variation.is_empty() {
                @if variation.band_is_cut { p.note { "The band is wider than the plot: the variation of the curve is smaller than its estimated error." } }
                div.side {
                    div.wide { (described(&variation.svg, &name)) }
                    @if !harmonics.is_empty() { div.narrow { (described(&harmonics.svg, &format!("harmonics of {}", output.name))) } }
                }
            }
        }
    }
}

fn contact_section(run: &Run, units: Units) -> Markup {
    // Meshes on general axes have their own section.
    let drawn = projection::bodies(run);
    let elsewhere = |row: &read::Loaded| drawn.contains(&[row.first_body.clone(), row.second_body.clone()]);
    let rows: Vec<read::Loaded> = run.contact.iter().filter(|row| !elsewhere(row)).cloned().collect();
    let (meshes, left_out) = contact::meshes(&rows, units);
    if meshes.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        @for mesh in &meshes {
            @let [first, second] = &mesh.bodies;
            article {
                h3 { (first) " and " (second) @if mesh.back { ", back flanks" } }
                p { "Largest pressure away from tip edges: " b { (number(units.stress.of(mesh.largest))) " " (units.stress.name) } "."
                    @if mesh.largest_on_edges > 0.0 {
                        " On tip edges and within one half-width of them: " (number(units.stress.of(mesh.largest_on_edges))) " "
                        (units.stress.name) "."
                    }
                }
                (figure(&mesh.pattern, &format!("Contact pattern on {first}: largest pressure away from tip edges at each point of the flank over all positions and teeth.")))
                (figure(&mesh.along_face, "Line load along the face: each tooth pair at the position with the largest line load, and the maximum over all positions."))
                (figure(&mesh.path, "Load sharing: load of a tooth pair over its contact point, the centre of its load."))
                @for (plot, caption) in &mesh.lubricated { (figure(plot, caption)) }
            }
        }
        @if left_out > 0 {
            p.note { "Shows the meshes with the largest pressures; " (left_out) " more meshes are in " code { "line_load.csv" } "." }
        }
    }
}

fn stress_section(run: &Run, units: Units) -> Markup {
    let (fillets, left_out) = fillets::fillets(&run.stresses, units);
    if fillets.is_empty() {
        return PreEscaped(String::new());
    }
    html! {
        p.note { "Principal stresses in the surface of the fillets: largest and smallest value at each point over all positions and teeth, the stress range for fatigue. The loaded side is that of the flank that carries load." }
        @for fillet in &fillets {
            article {
                h3 { (fillet.body) }
                p { "From " b { (number(units.stress.of(fillet.smallest))) } " to " b { (number(units.stress.of(fillet.largest))) } " " (units.stress.name) "." }
                @if let Some([least, most]) = fillet.radii.map(|radii| radii.map(|radius| number(units.length.of(radius)))) {
                    p.note { "This fidelity level computes the stress at one point of the profile, at "
                        @if least == most { "radius " (least) } @else { "radii from " (least) " to " (most) }
                        " " (units.length.name) "."
                    }
                }
                (figure(&fillet.along_face, "Stress along the face at that point of the profile."))
                (figure(&fillet.along_profile, "Stress along the fillet: largest and smallest value over the face."))
                (figure(&fillet.over_face, "Largest stress over fillet and face, loaded side."))
            }
        }
        @if left_out > 0 {
            p.note { (left_out) " more bodies are in " code { (crate::stress_range::NAME) } "." }
        }
    }
}

fn signals(run: &Run) -> Markup {
    html! {
        @for picture in &run.pictures {
            figure.paper { (described(&picture.svg, &picture.name)) figcaption { (picture.name) } }
        }
    }
}

fn modes(run: &Run) -> Markup {
    let Some((header, rows)) = run.modes.split_first() else { return PreEscaped(String::new()) };
    let shown = |cell: &str| cell.parse().map_or_else(|_| cell.replace('_', " "), number);
    html! {
        p.note { "Modes at the first position. Frequencies in Hz; the columns after the type are fractions of the kinetic energy." }
        table.numbers {
            thead { tr { @for name in header { th { (name.replace('_', " ")) } } } }
            tbody { @for row in rows { tr { @for cell in row { td { (shown(cell)) } } } } }
        }
    }
}

#[cfg(test)]
mod tests;
