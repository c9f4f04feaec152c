//! Plot of the comparison: one panel per output, error over time on logarithmic axes, with the
//! Pareto frontier as a line.

use super::comparison::Comparison;
use super::text::{percent, seconds};
use calyx_runtime::scene::Fidelity;
use plotters::coord::Shift;
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

/// Size of a panel, pixels.
const PANEL: (u32, u32) = (420, 300);
/// Number of panels in a row.
const ROW: usize = 2;
/// Height of the title and the legend of fidelity levels above the panels, pixels.
const HEAD: u32 = 84;
/// Smallest error drawn: settings that differ from the reference by rounding only are drawn here.
const LEAST: f64 = 1e-6;
/// Colours of the fidelity levels in order of cost; also distinguishable by lightness.
const COLOURS: [RGBColor; 7] = [
    RGBColor(150, 150, 150),
    RGBColor(214, 152, 20),
    RGBColor(200, 70, 40),
    RGBColor(60, 130, 200),
    RGBColor(90, 170, 90),
    RGBColor(120, 70, 160),
    RGBColor(20, 40, 90),
];

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

fn colour(level: &str) -> RGBColor {
    // Counted from the finest level, so that a level keeps its colour.
    let from_end =
        Fidelity::ALL.iter().rev().position(|known| known.name() == level).unwrap_or(COLOURS.len());
    COLOURS[COLOURS.len().saturating_sub(1 + from_end)]
}

/// Draws the comparison of a model into a file.
///
/// # Errors
/// The file cannot be written.
pub fn draw(path: &Path, model: &str, comparison: &Comparison) -> Result<(), Box<dyn Error>> {
    let rows = comparison.outputs.len().div_ceil(ROW).max(1) as u32;
    let size = (PANEL.0 * ROW as u32, HEAD + PANEL.1 * rows);
    let area = SVGBackend::new(path, size).into_drawing_area();
    area.fill(&WHITE)?;
    head(&area, model, comparison)?;
    let panels = area.margin(HEAD, 0, 0, 0).split_evenly((rows as usize, ROW));
    let times: Vec<f64> = comparison.settings.iter().map(|measured| measured.time()).collect();
    let span = decades(times.iter().copied());
    for (output, panel) in (0..comparison.outputs.len()).zip(&panels) {
        self::panel(panel, comparison, output, span)?;
    }
    area.present()?;
    Ok(())
}

fn head(area: &Area<'_>, model: &str, comparison: &Comparison) -> Result<(), Box<dyn Error>> {
    let reference = &comparison.settings[comparison.reference];
    let title = format!("{model}: error against time");
    area.draw(&Text::new(title, (16, 10), ("sans-serif", 18)))?;
    let grey = ("sans-serif", 12).into_font().color(&BLACK.mix(0.7));
    let said = format!(
        "reference: {} ({}); error: largest deviation at any position over the largest magnitude; line: settings that are more accurate than all cheaper ones",
        reference.setting.name,
        seconds(reference.time())
    );
    area.draw(&Text::new(said, (16, 34), grey.clone()))?;
    let mut x = 16;
    let levels = Fidelity::ALL.iter().map(|level| level.name());
    for level in
        levels.filter(|level| comparison.settings.iter().any(|measured| measured.setting.level() == *level))
    {
        area.draw(&Circle::new((x + 5, 62), 5, colour(level).filled()))?;
        area.draw(&Text::new(level, (x + 15, 56), ("sans-serif", 13)))?;
        x += 32 + 8 * level.len() as i32;
    }
    let shapes = "full: default settings of the level; ring: changed settings";
    area.draw(&Text::new(shapes, (x + 16, 56), grey))?;
    Ok(())
}

/// Returns a range of whole decades, or thirds of them for a short range, around positive numbers.
fn decades(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let (low, high) = values
        .filter(|value| value.is_finite() && *value > 0.0)
        .fold((f64::INFINITY, 0.0_f64), |(low, high), value| (low.min(value), high.max(value)));
    if high == 0.0 {
        return (0.1, 10.0);
    }
    // A margin around the data.
    let step = if high / low > 100.0 { 1.0 } else { 3.0 };
    let down = ((0.8 * low).log10() * step).floor() / step;
    let up = ((1.25 * high).log10() * step).ceil() / step;
    (10f64.powf(down), 10f64.powf(up))
}

fn panel(
    area: &Area<'_>,
    comparison: &Comparison,
    output: usize,
    times: (f64, f64),
) -> Result<(), Box<dyn Error>> {
    let output = &comparison.outputs[output];
    let point = |index: usize| {
        let error = output.errors[index]?.error().max(LEAST);
        Some((comparison.settings[index].time(), error))
    };
    let shown: Vec<(usize, (f64, f64))> = (0..comparison.settings.len())
        .filter(|index| *index != comparison.reference)
        .filter_map(|index| Some((index, point(index)?)))
        .collect();
    let (low, high) = decades(shown.iter().map(|(_, (_, error))| *error));
    let mut chart = ChartBuilder::on(area)
        .caption(&output.name, ("sans-serif", 15))
        .margin(8)
        .margin_right(16)
        .x_label_area_size(36)
        .y_label_area_size(62)
        .build_cartesian_2d((times.0..times.1).log_scale(), (low..high).log_scale())?;
    chart
        .configure_mesh()
        .x_desc("time")
        .y_desc("error")
        .x_labels(6)
        .y_labels(6)
        .axis_desc_style(("sans-serif", 12))
        .label_style(("sans-serif", 11))
        .x_label_formatter(&|value| tick_of_time(*value))
        .y_label_formatter(&|value| format!("{} %", tick_of_percent(*value)))
        .light_line_style(BLACK.mix(0.05))
        .bold_line_style(BLACK.mix(0.15))
        .draw()?;
    let reference = comparison.settings[comparison.reference].time();
    let dashes = [(reference, low), (reference, high)];
    chart.draw_series(DashedLineSeries::new(dashes, 4, 4, BLACK.mix(0.4).stroke_width(1)))?;
    // The frontier is a staircase: the error of a setting is available for all longer times.
    let mut stairs: Vec<(f64, f64)> = Vec::new();
    for (time, error) in output.frontier.iter().filter_map(|index| point(*index)) {
        stairs.extend(stairs.last().map(|(_, before)| (time, *before)));
        stairs.push((time, error));
    }
    stairs.extend(stairs.last().map(|(_, error)| (times.1, *error)));
    chart.draw_series(LineSeries::new(stairs, BLACK.mix(0.6).stroke_width(2)))?;
    for (index, at) in &shown {
        let setting = &comparison.settings[*index].setting;
        let own = setting.overridden().is_empty();
        let colour = colour(setting.level());
        let style = if own { colour.filled() } else { colour.stroke_width(2) };
        chart.draw_series(std::iter::once(Circle::new(*at, if own { 5 } else { 4 }, style)))?;
    }
    Ok(())
}

/// Formats a power of ten, or twice or five times one.
fn tick_of_time(value: f64) -> String {
    match value {
        value if value < 0.999e-3 => format!("{:.0} us", 1e6 * value),
        value if value < 0.999 => format!("{:.0} ms", 1e3 * value),
        value => format!("{value:.0} s"),
    }
}

fn tick_of_percent(value: f64) -> String {
    let rounded: f64 = percent(value).parse().unwrap_or(100.0 * value);
    format!("{rounded}")
}

#[cfg(test)]
mod tests {
    use super::super::comparison::tests::measured;
    use super::*;

    #[test]
    fn ranges_hold_what_they_show() {
        for values in [vec![0.5], vec![0.3, 0.4], vec![1e-4, 2.0], vec![]] {
            let (low, high) = decades(values.iter().copied());
            assert!(low < high && values.iter().all(|value| (low..=high).contains(value)), "{values:?}");
        }
    }

    #[test]
    fn a_picture_names_outputs_and_levels() {
        let times = [0.0, 1.0];
        let of = |level: &str, time, value: f64| {
            let mut measured =
                measured(level, time, &times, &[("load_share", &[1.0, value]), ("nought", &[0.0, 0.0])]);
            measured.setting.overrides.set("fidelity", level).unwrap();
            measured
        };
        let all = vec![of("plane", 0.1, 1.2), of("medium", 2.0, 1.02), of("finest", 30.0, 1.0)];
        let comparison = Comparison::new(all, "finest").unwrap();
        let directory = tempfile::tempdir().unwrap();
        let path = directory.path().join("picture.svg");
        draw(&path, "pair.cx", &comparison).unwrap();
        let text = std::fs::read_to_string(path).unwrap();
        for named in ["load_share", "nought", "plane", "medium", "finest", "pair.cx"] {
            assert!(text.contains(named), "{named}");
        }
        assert!(!text.contains("NaN"));
        let colours: std::collections::BTreeSet<[u8; 3]> = Fidelity::ALL
            .map(|level| {
                let c = colour(level.name());
                [c.0, c.1, c.2]
            })
            .into();
        assert_eq!(colours.len(), Fidelity::ALL.len());
    }
}
