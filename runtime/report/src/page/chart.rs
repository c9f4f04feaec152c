//! Plots of the page, as SVG: curves over the positions, bar charts, and maps of a flank.
//!
//! The plots have a transparent background and few colours. The style of the page refers to these
//! colours by value, to change them in dark mode.

use super::logarithmic::Logarithmic;
use crate::signals::{label, tick};
use plotters::coord::Shift;
use plotters::coord::ranged1d::{AsRangedCoord, Ranged, ValueFormatter};
use plotters::coord::types::RangedCoordf64;
use plotters::prelude::*;
use std::ops::Range;

/// Size of a plot in drawing units: two per pixel, because `plotters` rounds to whole ones.
pub const WIDE: (u32, u32) = (1640, 520);
/// Size of the bar chart next to a plot.
pub const NARROW: (u32, u32) = (640, 520);
/// Size of a map.
pub const TALL: (u32, u32) = (1640, 720);
pub(super) const FONT: i32 = 32;
/// Number of intervals into which a long curve is divided: the minimum and the maximum of each are
/// drawn.
const STRETCHES: usize = 800;
/// Width reserved for a name above a plot.
const NAME: i32 = 104;
/// Width of a letter of the name.
const LETTER: i32 = 20;
/// Curves with at most this many points show each point.
const DOTTED: usize = 24;
/// Width of the legend of a map.
pub(super) const LEGEND: u32 = 250;

/// Colours of curves; the style of the page refers to them.
pub(super) const COLOURS: [RGBColor; 6] = [
    RGBColor(31, 95, 168),
    RGBColor(196, 60, 46),
    RGBColor(38, 135, 86),
    RGBColor(138, 86, 176),
    RGBColor(176, 116, 26),
    RGBColor(20, 140, 150),
];

/// Label of an axis.
pub struct Axis<'a> {
    pub what: &'a str,
    pub unit: &'a str,
}

/// A curve of a plot.
#[derive(Clone, Debug, Default)]
pub struct Curve {
    /// Name in the legend; curves without a name are not listed.
    pub name: String,
    /// Index into [`COLOURS`].
    pub colour: usize,
    pub points: Vec<(f64, f64)>,
    /// Error bounds of the minimum and the maximum, to both sides; linear in between.
    pub off: Option<[f64; 2]>,
}

impl Curve {
    fn heights(&self) -> impl Iterator<Item = f64> + '_ {
        self.points.iter().filter(|(x, y)| x.is_finite() && y.is_finite()).map(|point| point.1)
    }

    /// Returns the error bound as a function of the value, if it is known and not zero.
    fn band(&self) -> Option<impl Fn(f64) -> f64> {
        let known = |off: &[f64; 2]| off.iter().all(|off| *off >= 0.0 && off.is_finite()) && *off != [0.0; 2];
        let [of_least, of_largest] = self.off.filter(known)?;
        let (least, largest) = ends(self.heights());
        Some(move |value: f64| {
            let part = if largest > least { (value - least) / (largest - least) } else { 1.0 };
            of_least + part * (of_largest - of_least)
        })
    }
}

fn ends(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

/// A drawing with its legend.
#[derive(Clone, Debug, Default)]
pub struct Plot {
    /// SVG text; empty if there is nothing to draw.
    pub svg: String,
    /// Colours and names of the named curves. The page shows them next to the drawing, where they
    /// cover nothing.
    pub legend: Vec<(usize, String)>,
    /// True if the error band exceeds the drawing.
    pub band_is_cut: bool,
}

impl Plot {
    /// Returns true if there is nothing to show.
    pub fn is_empty(&self) -> bool {
        self.svg.is_empty()
    }
}

/// Scale of an abscissa.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    Linear,
    /// Logarithmic, for positive values; others have a linear scale.
    Logarithmic,
}

/// Plots curves; `marks` are named positions.
pub fn curves(size: (u32, u32), x: &Axis, y: &Axis, curves: &[Curve], marks: &[(f64, String)]) -> Plot {
    scaled_curves(size, (Scale::Linear, x), y, curves, marks)
}

/// Plots curves over an abscissa with a scale; `marks` are named positions.
pub fn scaled_curves(
    size: (u32, u32),
    (scale, x): (Scale, &Axis),
    y: &Axis,
    curves: &[Curve],
    marks: &[(f64, String)],
) -> Plot {
    let points =
        || curves.iter().flat_map(|curve| &curve.points).filter(|(x, y)| x.is_finite() && y.is_finite());
    let heights = || curves.iter().flat_map(Curve::heights);
    let off = curves.iter().filter_map(|curve| curve.off).flatten();
    let off = off.filter(|off| off.is_finite()).fold(0.0, f64::max);
    let Some(across) = span(points().map(|point| point.0), 0.0) else { return Plot::default() };
    // The variation of a curve must remain visible, however wide the band.
    let (least, largest) = ends(heights());
    let is_course = is_course(largest - least, least.abs().max(largest.abs()));
    let seen = if is_course { off.min(largest - least) } else { off };
    let Some(up) = span(heights().flat_map(|height| [height - seen, height + seen]), 0.06) else {
        return Plot::default();
    };
    let legend = curves.iter().filter(|curve| !curve.name.is_empty());
    let legend = legend.map(|curve| (curve.colour % COLOURS.len(), curve.name.clone())).collect();
    let nought = [small(&across), small(&up)];
    let logarithmic = Logarithmic::new(&across).filter(|_| scale == Scale::Logarithmic);
    let svg = drawn(size, |area| match logarithmic {
        Some(logarithmic) => {
            draw_curves(area, (logarithmic, &across, &up), (x, y, [0.0, nought[1]]), curves, marks)
        }
        None => draw_curves(area, (across.clone(), &across, &up), (x, y, nought), curves, marks),
    });
    let beyond = |curve: &Curve| {
        let Some(off) = curve.band() else { return false };
        curve.heights().any(|y| y + off(y) > up.end || y - off(y) < up.start)
    };
    Plot { svg, legend, band_is_cut: curves.iter().any(beyond) }
}

/// Draws curves over an abscissa of any scale. `across` and `up` are the ranges of both axes.
fn draw_curves<X: Ranged<ValueType = f64> + ValueFormatter<f64>>(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    (abscissa, across, up): (impl AsRangedCoord<CoordDescType = X, Value = f64>, &Range<f64>, &Range<f64>),
    (x, y, nought): (&Axis, &Axis, [f64; 2]),
    curves: &[Curve],
    marks: &[(f64, String)],
) -> Result<(), Error> {
    let last_x = area.dim_in_pixel().0 as i32;
    let above = if marks.is_empty() { 16 } else { 50 };
    let mut chart = ChartBuilder::on(area)
        .margin(8)
        .margin_right(36)
        .margin_top(above)
        .x_label_area_size(88)
        .y_label_area_size(164)
        .build_cartesian_2d(abscissa, up.clone())?;
    mesh(&mut chart, x, y, nought)?;
    // Adjacent marks share one line of names.
    let mut names: Vec<(i32, String)> = Vec::new();
    for (place, name) in marks.iter().filter(|(place, _)| (across.start..=across.end).contains(place)) {
        let line = [(*place, up.start), (*place, up.end)];
        chart.draw_series(LineSeries::new(line, BLACK.mix(0.35)))?;
        let (at, _) = chart.backend_coord(&(*place, up.end));
        match names.last_mut().filter(|(before, _)| at < before + NAME) {
            Some((_, names)) => *names += &format!(", {name}"),
            None => names.push((at, name.clone())),
        }
    }
    let (_, top) = chart.backend_coord(&(across.start, up.end));
    for (at, name) in names {
        let style = ("sans-serif", FONT - 4).into_font().color(&BLACK.mix(0.7));
        let last = last_x - LETTER * name.len() as i32;
        area.draw(&Text::new(name, ((at - 16).min(last), top - 38), style))?;
    }
    for curve in curves {
        let colour = COLOURS[curve.colour % COLOURS.len()];
        let points = thinned(&curve.points);
        if let Some(off) = curve.band() {
            let band: Vec<(f64, [f64; 2])> =
                points.iter().map(|&(x, y)| (x, [y - off(y), y + off(y)])).collect();
            let over = band.iter().map(|(x, [_, over])| (*x, over.min(up.end)));
            let under = band.iter().rev().map(|(x, [under, _])| (*x, under.max(up.start)));
            chart.draw_series(std::iter::once(Polygon::new(
                over.chain(under).collect::<Vec<_>>(),
                colour.mix(0.22).filled(),
            )))?;
        }
        chart.draw_series(LineSeries::new(points.iter().copied(), colour.stroke_width(3)))?;
        if points.len() <= DOTTED {
            let dots = points.iter().map(|point| Circle::new(*point, 5, colour.filled()));
            chart.draw_series(dots)?;
        }
    }
    Ok(())
}

/// Returns true if a difference of values exceeds rounding.
fn is_course(difference: f64, magnitude: f64) -> bool {
    difference > 1e-9 * magnitude
}

/// Draws a bar chart with numbered bars.
pub fn bars(size: (u32, u32), x: &Axis, y: &Axis, bars: &[(u64, f64)]) -> Plot {
    let largest = bars.iter().map(|bar| bar.1).filter(|height| height.is_finite()).fold(0.0, f64::max);
    let last = bars.iter().map(|bar| bar.0).max().unwrap_or(0);
    if largest <= 0.0 {
        return Plot::default();
    }
    let svg = drawn(size, |area| {
        let mut chart = ChartBuilder::on(area)
            .margin(8)
            .margin_top(16)
            .x_label_area_size(88)
            .y_label_area_size(164)
            .build_cartesian_2d(0.4..last as f64 + 0.6, 0.0..1.08 * largest)?;
        chart
            .configure_mesh()
            .disable_x_mesh()
            .x_labels(last as usize)
            .x_label_formatter(&|place| if place.fract() == 0.0 { format!("{place}") } else { String::new() })
            .y_label_formatter(&|value| tick(*value))
            .y_labels(5)
            .x_desc(label(x.what, x.unit))
            .y_desc(label(y.what, y.unit))
            .axis_desc_style(("sans-serif", FONT))
            .label_style(("sans-serif", FONT - 3))
            .light_line_style(TRANSPARENT)
            .bold_line_style(BLACK.mix(0.15))
            .draw()?;
        chart.draw_series(bars.iter().map(|&(place, height)| {
            let place = place as f64;
            Rectangle::new([(place - 0.3, 0.0), (place + 0.3, height)], COLOURS[0].filled())
        }))?;
        Ok(())
    });
    Plot { svg, ..Plot::default() }
}

/// A cell of a map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapCell {
    /// Lower and upper bound of the abscissa.
    pub x: [f64; 2],
    /// Lower and upper bound of the ordinate.
    pub y: [f64; 2],
    pub value: f64,
}

/// Draws a map of a surface: cells coloured by their values, from zero to the largest.
pub fn map(x: &Axis, y: &Axis, value: &Axis, pieces: &[MapCell]) -> Plot {
    let largest =
        pieces.iter().map(|piece| piece.value).filter(|value| value.is_finite()).fold(0.0, f64::max);
    let (Some(across), Some(up)) = (
        span(pieces.iter().flat_map(|piece| piece.x), 0.0),
        span(pieces.iter().flat_map(|piece| piece.y), 0.0),
    ) else {
        return Plot::default();
    };
    if largest <= 0.0 {
        return Plot::default();
    }
    let svg = drawn(TALL, |area| {
        let (picture, legend) = area.split_horizontally(TALL.0 - LEGEND);
        let mut chart = ChartBuilder::on(&picture)
            .margin(8)
            .margin_top(16)
            .x_label_area_size(88)
            .y_label_area_size(148)
            .build_cartesian_2d(across.clone(), up.clone())?;
        for piece in merged(pieces, largest) {
            let corners = [(piece.x[0], piece.y[0]), (piece.x[1], piece.y[1])];
            chart.draw_series(std::iter::once(Rectangle::new(
                corners,
                shade(piece.value / largest).filled(),
            )))?;
        }
        // Drawn over the map, so that frame and ticks are visible.
        mesh(&mut chart, x, y, [small(&across), small(&up)])?;
        let mut key = ChartBuilder::on(&legend)
            .margin(8)
            .margin_top(16)
            .margin_right(60)
            .x_label_area_size(88)
            .y_label_area_size(124)
            .build_cartesian_2d(0.0..1.0, 0.0..largest)?;
        let step = |k: usize| largest * k as f64 / SHADES as f64;
        key.draw_series((0..SHADES).map(|k| {
            let colour = shade((k as f64 + 0.5) / SHADES as f64);
            Rectangle::new([(0.0, step(k)), (1.0, step(k + 1))], colour.filled())
        }))?;
        key.configure_mesh()
            .disable_mesh()
            .x_labels(0)
            .x_desc(label(value.what, value.unit))
            .axis_desc_style(("sans-serif", FONT))
            .label_style(("sans-serif", FONT - 3))
            .y_label_formatter(&|value| tick(*value))
            .draw()?;
        Ok(())
    });
    Plot { svg, ..Plot::default() }
}

/// Chart with an abscissa of a scale and a linear ordinate.
pub(super) type Chart<'a, 'b, X = RangedCoordf64> =
    ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, RangedCoordf64>>;

/// Returns the magnitude on an axis below which a tick is a rounding error of zero.
pub(super) fn small(range: &Range<f64>) -> f64 {
    1e-9 * (range.end - range.start)
}

pub(super) fn mesh<X: Ranged<ValueType = f64> + ValueFormatter<f64>>(
    chart: &mut Chart<'_, '_, X>,
    x: &Axis,
    y: &Axis,
    nought: [f64; 2],
) -> Result<(), Error> {
    let at = |axis: usize, value: f64| tick(if value.abs() < nought[axis] { 0.0 } else { value });
    chart
        .configure_mesh()
        .x_desc(label(x.what, x.unit))
        .y_desc(label(y.what, y.unit))
        .axis_desc_style(("sans-serif", FONT))
        .label_style(("sans-serif", FONT - 3))
        .x_label_formatter(&|value| at(0, *value))
        .y_label_formatter(&|value| at(1, *value))
        .y_labels(9)
        .light_line_style(TRANSPARENT)
        .bold_line_style(BLACK.mix(0.15))
        .draw()?;
    Ok(())
}

pub(super) type Error = Box<dyn std::error::Error>;

/// Draws into a text. Errors mean that the data cannot be drawn, and yield an empty plot.
pub(super) fn drawn(
    size: (u32, u32),
    draw: impl FnOnce(&DrawingArea<SVGBackend<'_>, Shift>) -> Result<(), Error>,
) -> String {
    let mut text = String::new();
    let outcome = {
        let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
        draw(&area).and_then(|()| Ok(area.present()?))
    };
    if outcome.is_ok() { text } else { String::new() }
}

/// Returns the range of values with a relative margin on both sides; never empty.
pub(super) fn span(values: impl Iterator<Item = f64>, more: f64) -> Option<Range<f64>> {
    let (low, high) = ends(values.filter(|value| value.is_finite()));
    if low > high {
        return None;
    }
    // A variation by rounding is drawn as a constant.
    let scale = low.abs().max(high.abs());
    let room = if is_course(high - low, scale) {
        more * (high - low)
    } else if scale > 0.0 {
        0.05 * scale
    } else {
        1.0
    };
    Some(low - room..high + room)
}

/// Reduces a curve with many points to the minimum and the maximum of each interval.
fn thinned(points: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let points: Vec<(f64, f64)> =
        points.iter().copied().filter(|(x, y)| x.is_finite() && y.is_finite()).collect();
    if points.len() <= 2 * STRETCHES {
        return points;
    }
    let stretch = |stretch: &[(f64, f64)]| {
        let index = |best: Option<(usize, &(f64, f64))>| best.map_or(0, |(index, _)| index);
        let least = index(stretch.iter().enumerate().min_by(|a, b| a.1.1.total_cmp(&b.1.1)));
        let most = index(stretch.iter().enumerate().max_by(|a, b| a.1.1.total_cmp(&b.1.1)));
        [stretch[least.min(most)], stretch[least.max(most)]]
    };
    points.chunks(points.len().div_ceil(STRETCHES)).flat_map(stretch).collect()
}

/// Merges vertically adjacent cells of the same colour, which keeps drawings small.
fn merged(pieces: &[MapCell], largest: f64) -> Vec<MapCell> {
    let colour = |piece: &MapCell| shade(piece.value / largest);
    let mut all: Vec<MapCell> = Vec::new();
    for piece in pieces {
        match all.last_mut() {
            Some(last) if last.x == piece.x && last.y[1] == piece.y[0] && colour(last) == colour(piece) => {
                last.y[1] = piece.y[1];
            }
            _ => all.push(*piece),
        }
    }
    all
}

/// Number of colours of maps.
pub(super) const SHADES: usize = 40;

/// Returns a colour of the scale from pale over red to dark, for `part` from 0 to 1. Lightness is
/// monotonic.
pub(super) fn shade(part: f64) -> RGBColor {
    const STOPS: [[f64; 3]; 5] = [
        [235.0, 240.0, 248.0],
        [250.0, 214.0, 130.0],
        [236.0, 130.0, 62.0],
        [178.0, 42.0, 56.0],
        [70.0, 10.0, 50.0],
    ];
    let steps = SHADES as f64;
    let at =
        ((part.clamp(0.0, 1.0) * steps).floor().min(steps - 1.0) / (steps - 1.0)) * (STOPS.len() - 1) as f64;
    let from = (at.floor() as usize).min(STOPS.len() - 2);
    let passed = at - from as f64;
    let [red, green, blue] = [0, 1, 2]
        .map(|k: usize| (STOPS[from][k] + (STOPS[from + 1][k] - STOPS[from][k]) * passed).round() as u8);
    RGBColor(red, green, blue)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_curve_keeps_its_peaks() {
        let mut points: Vec<(f64, f64)> = (0..100_000).map(|k| (k as f64, (k as f64 * 0.01).sin())).collect();
        points[31_415].1 = 7.0;
        points[92_653].1 = -9.0;
        let thin = thinned(&points);
        assert!(thin.len() <= 2 * STRETCHES + 2, "{}", thin.len());
        assert!(thin.contains(&(31_415.0, 7.0)) && thin.contains(&(92_653.0, -9.0)));
        assert!(thin.windows(2).all(|pair| pair[0].0 <= pair[1].0));
    }

    #[test]
    fn what_cannot_be_drawn_is_no_plot() {
        let axis = || Axis { what: "load", unit: "N" };
        let curve = |points: Vec<(f64, f64)>| Curve { points, ..Curve::default() };
        assert!(curves(WIDE, &axis(), &axis(), &[], &[]).is_empty());
        assert!(curves(WIDE, &axis(), &axis(), &[curve(vec![(f64::NAN, 1.0)])], &[]).is_empty());
        assert!(bars(NARROW, &axis(), &axis(), &[(1, 0.0)]).is_empty());
        assert!(map(&axis(), &axis(), &axis(), &[]).is_empty());
        // A constant is drawn as a line, and labels are escaped.
        let plot = curves(
            WIDE,
            &Axis { what: "a < b", unit: "" },
            &axis(),
            &[curve(vec![(0.0, 3.0), (1.0, 3.0)])],
            &[],
        )
        .svg;
        assert!(plot.contains("<polyline") && plot.contains("a &lt; b"), "{plot}");
    }

    /// A band of 50 around a curve that varies by 1 leaves a third of the height to the curve; a
    /// band of 0.2 is drawn whole, and so is that of a constant.
    #[test]
    fn a_band_leaves_room_for_its_curve() {
        let heights = |off: f64, end: f64| {
            let axis = || Axis { what: "", unit: "" };
            let curve =
                Curve { points: vec![(0.0, 3.0), (1.0, end)], off: Some([off; 2]), ..Curve::default() };
            let plot = curves(WIDE, &axis(), &axis(), &[curve], &[]);
            let line = plot.svg.split("<polyline").find(|part| part.contains("stroke-width=\"3\"")).unwrap();
            let points = line.split("points=\"").nth(1).unwrap().split('"').next().unwrap();
            let heights: Vec<i32> = points
                .split_whitespace()
                .map(|point| point.split(',').nth(1).unwrap().parse().unwrap())
                .collect();
            (plot.band_is_cut, heights[0] - heights[1])
        };
        let (cut, rise) = heights(50.0, 4.0);
        assert!(cut && rise > 120, "{rise}");
        assert!(!heights(0.2, 4.0).0);
        assert_eq!(heights(0.2, 3.0), (false, 0));
    }

    #[test]
    fn a_map_draws_neighbours_of_one_colour_as_one() {
        let piece = |k: usize, value: f64| MapCell { x: [0.0, 1.0], y: [k as f64, k as f64 + 1.0], value };
        let pieces = [piece(0, 1.0), piece(1, 1.0), piece(2, 9.0), piece(4, 9.0)];
        let all = merged(&pieces, 9.0);
        assert_eq!(all.len(), 3);
        assert_eq!(all[0].y, [0.0, 2.0]);
        let shades: Vec<f64> = (0..=10)
            .map(|k| {
                let RGBColor(r, g, b) = shade(k as f64 / 10.0);
                f64::from(r) + f64::from(g) + f64::from(b)
            })
            .collect();
        assert!(shades.windows(2).all(|pair| pair[0] > pair[1]), "{shades:?}");
    }
}
