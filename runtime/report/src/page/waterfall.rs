//! Waterfall plot: spectral lines over speed and frequency, coloured by their level.

use super::chart::{Axis, Error, FONT, LEGEND, Plot, SHADES, TALL, drawn, mesh, shade, small, span};
use crate::signals::label;
use plotters::prelude::*;

/// Range of levels below the largest amplitude, dB.
const RANGE: f64 = 60.0;

/// Number of colours: 3 dB each.
const LEVELS: f64 = 20.0;

/// Spectral line over the speed.
#[derive(Clone, Debug, Default)]
pub struct Ray {
    pub points: Vec<Point>,
}

/// Amplitude at a speed and a frequency.
#[derive(Clone, Copy, Debug, Default)]
pub struct Point {
    /// Speed and frequency.
    pub at: [f64; 2],
    pub amplitude: f64,
}

/// Straight stretch of a ray with one colour.
struct Stroke {
    /// Level from 0 to 1.
    level: f64,
    ends: [(f64, f64); 2],
}

/// Plots rays, and natural frequencies as dashed lines. Colours are levels in dB of the largest
/// amplitude.
pub fn plot(x: &Axis, y: &Axis, rays: &[Ray], natural_frequencies: &[f64]) -> Plot {
    let points = || rays.iter().flat_map(|ray| &ray.points);
    let amplitudes = points().map(|point| point.amplitude).filter(|amplitude| amplitude.is_finite());
    let largest = amplitudes.fold(0.0, f64::max);
    let (Some(across), Some(up)) =
        (span(points().map(|point| point.at[0]), 0.0), span(points().map(|point| point.at[1]), 0.02))
    else {
        return Plot::default();
    };
    if largest <= 0.0 {
        return Plot::default();
    }
    let part = |amplitude: f64| 1.0 + 20.0 * (amplitude / largest).log10() / RANGE;
    let svg = drawn(TALL, |area| {
        let (picture, legend) = area.split_horizontally(TALL.0 - LEGEND);
        let mut chart = ChartBuilder::on(&picture)
            .margin(8)
            .margin_top(16)
            .x_label_area_size(88)
            .y_label_area_size(148)
            .build_cartesian_2d(across.clone(), up.clone())?;
        mesh(&mut chart, x, y, [small(&across), small(&up)])?;
        // The highest levels are drawn last, so that nothing covers them.
        let mut all: Vec<Stroke> = rays.iter().flat_map(|ray| strokes(ray, part)).collect();
        all.sort_by(|one, other| one.level.total_cmp(&other.level));
        for Stroke { level, ends } in all {
            chart.draw_series(LineSeries::new(ends, shade(level).stroke_width(5)))?;
        }
        for &frequency in natural_frequencies.iter().filter(|frequency| up.contains(frequency)) {
            let line = [(across.start, frequency), (across.end, frequency)];
            chart.draw_series(DashedLineSeries::new(line, 6, 8, BLACK.mix(0.6).stroke_width(1)))?;
        }
        key(&legend)
    });
    Plot { svg, ..Plot::default() }
}

/// Divides a ray into stretches of one colour, each of which begins where the one before it ends,
/// and leaves out what is below the range of levels.
fn strokes(ray: &Ray, part: impl Fn(f64) -> f64) -> Vec<Stroke> {
    let mut all: Vec<Stroke> = Vec::new();
    let place = |point: &Point| (point.at[0], point.at[1]);
    for pair in ray.points.windows(2) {
        let mean = 0.5 * (pair[0].amplitude + pair[1].amplitude);
        let level = (part(mean) * LEVELS).floor() / LEVELS;
        if level.is_nan() || level < 0.0 {
            continue;
        }
        let [from, to] = [place(&pair[0]), place(&pair[1])];
        match all.last_mut() {
            Some(last) if last.level == level && last.ends[1] == from => last.ends[1] = to,
            _ => all.push(Stroke { level, ends: [from, to] }),
        }
    }
    all
}

/// Draws the scale of the levels.
fn key(area: &DrawingArea<SVGBackend<'_>, plotters::coord::Shift>) -> Result<(), Error> {
    let mut key = ChartBuilder::on(area)
        .margin(8)
        .margin_top(16)
        .margin_right(60)
        .x_label_area_size(88)
        .y_label_area_size(124)
        .build_cartesian_2d(0.0..1.0, -RANGE..0.0)?;
    let step = |k: usize| RANGE * (k as f64 / SHADES as f64 - 1.0);
    key.draw_series((0..SHADES).map(|k| {
        let colour = shade((k as f64 + 0.5) / SHADES as f64);
        Rectangle::new([(0.0, step(k)), (1.0, step(k + 1))], colour.filled())
    }))?;
    key.configure_mesh()
        .disable_mesh()
        .x_labels(0)
        .x_desc(label("level", "dB"))
        .axis_desc_style(("sans-serif", FONT))
        .label_style(("sans-serif", FONT - 3))
        .y_label_formatter(&|value| format!("{value:.0}"))
        .draw()?;
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ray(amplitudes: &[f64]) -> Ray {
        let point =
            |(index, &amplitude): (usize, &f64)| Point { at: [index as f64, 2.0 * index as f64], amplitude };
        Ray { points: amplitudes.iter().enumerate().map(point).collect() }
    }

    #[test]
    fn a_stretch_of_one_colour_is_one_line() {
        let part = |amplitude: f64| amplitude;
        let found = strokes(&ray(&[0.1, 0.1, 0.1, 0.9, 0.9]), part);
        let places: Vec<_> = found.iter().map(|stroke| (stroke.ends[0].0, stroke.ends[1].0)).collect();
        assert_eq!(places, [(0.0, 2.0), (2.0, 3.0), (3.0, 4.0)]);
        // A resonance without damping has no amplitude.
        assert_eq!(strokes(&ray(&[0.1, f64::NAN, 0.1, 0.1]), part).len(), 1);
    }

    #[test]
    fn a_plot_needs_amplitudes() {
        let axis = Axis { what: "speed", unit: "rpm" };
        assert!(plot(&axis, &axis, &[], &[100.0]).is_empty());
        assert!(plot(&axis, &axis, &[ray(&[0.0, 0.0])], &[]).is_empty());
        assert!(!plot(&axis, &axis, &[ray(&[0.2, 0.4])], &[1.0]).is_empty());
    }
}
