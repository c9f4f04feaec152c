//! K-charts: traces of left and right flanks next to each other, with their tolerance bands.

use super::chart::{Axis, COLOURS, Curve, Error, FONT, Plot, TALL, drawn, mesh, small, span};
use plotters::prelude::*;

/// Least distance of the names of two marks.
const APART: i32 = 34;

/// Traces of one flank.
#[derive(Clone, Debug, Default)]
pub struct Panel {
    pub title: String,
    /// Named positions.
    pub marks: Vec<(f64, String)>,
    /// Tolerance band: positions with their lower and upper limit.
    pub band: Vec<(f64, [f64; 2])>,
    pub curves: Vec<Curve>,
}

impl Panel {
    fn heights(&self) -> impl Iterator<Item = f64> + '_ {
        let band = self.band.iter().flat_map(|(_, limits)| *limits);
        self.curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.1)).chain(band)
    }

    fn places(&self) -> impl Iterator<Item = f64> + '_ {
        self.curves.iter().flat_map(|curve| curve.points.iter().map(|point| point.0))
    }
}

/// Draws the panels of both flanks with common scales.
pub fn panels(x: &Axis, y: &Axis, panels: &[Panel; 2]) -> Plot {
    let zero = std::iter::once(0.0);
    let heights = panels.iter().flat_map(Panel::heights).chain(zero);
    let (Some(across), Some(up)) = (span(panels.iter().flat_map(Panel::places), 0.0), span(heights, 0.08))
    else {
        return Plot::default();
    };
    let svg = drawn(TALL, |area| {
        let (left, right) = area.split_horizontally(TALL.0 / 2);
        for (area, panel) in [left, right].iter().zip(panels) {
            let mut chart = ChartBuilder::on(area)
                .margin(8)
                .margin_right(28)
                .margin_top(100)
                .x_label_area_size(88)
                .y_label_area_size(128)
                .build_cartesian_2d(across.clone(), up.clone())?;
            let limits = panel.band.iter().map(|(place, [_, upper])| (*place, *upper));
            let back = panel.band.iter().rev().map(|(place, [lower, _])| (*place, *lower));
            let outline: Vec<(f64, f64)> = limits.chain(back).collect();
            if !outline.is_empty() {
                let colour = COLOURS[BAND];
                chart.draw_series([Polygon::new(outline.clone(), colour.mix(0.22).filled())])?;
                let closed = outline.iter().chain(outline.first()).copied();
                chart.draw_series(LineSeries::new(closed, colour.stroke_width(2)))?;
            }
            mesh(&mut chart, x, y, [small(&across), small(&up)])?;
            chart.draw_series(LineSeries::new(
                [(across.start, 0.0), (across.end, 0.0)],
                BLACK.mix(0.5).stroke_width(2),
            ))?;
            let size = area.dim_in_pixel().0 as i32;
            let title = ("sans-serif", FONT).into_font().color(&BLACK);
            area.draw(&Text::new(panel.title.clone(), (140, 8), title))?;
            draw_marks(area, &mut chart, &panel.marks, [up.start, up.end], size)?;
            for curve in &panel.curves {
                let colour = COLOURS[curve.colour % COLOURS.len()];
                chart.draw_series(LineSeries::new(curve.points.iter().copied(), colour.stroke_width(3)))?;
            }
        }
        Ok(())
    });
    let [first, _] = panels;
    let named = first.curves.iter().filter(|curve| !curve.name.is_empty());
    let mut legend: Vec<(usize, String)> =
        named.map(|curve| (curve.colour % COLOURS.len(), curve.name.clone())).collect();
    if !first.band.is_empty() {
        legend.push((BAND, "tolerance band".into()));
    }
    Plot { svg, legend, ..Plot::default() }
}

/// Colour of tolerance bands.
const BAND: usize = 2;

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// Draws named vertical lines; names of adjacent marks share a line.
fn draw_marks(
    area: &Area<'_>,
    chart: &mut super::chart::Chart<'_, '_>,
    marks: &[(f64, String)],
    [low, high]: [f64; 2],
    size: i32,
) -> Result<(), Error> {
    let mut names: Vec<(i32, i32, String)> = Vec::new();
    for (place, name) in marks {
        chart.draw_series(LineSeries::new([(*place, low), (*place, high)], BLACK.mix(0.35)))?;
        let (at, top) = chart.backend_coord(&(*place, high));
        match names.last_mut() {
            // Lines closer than a name.
            Some((before, _, names)) if at < *before + APART * names.len() as i32 / 2 => {
                *names += &format!(", {name}");
            }
            _ => names.push((at, top, name.clone())),
        }
    }
    let (origin, _) = area.get_base_pixel();
    for (at, top, name) in names {
        let width = 16 * name.len() as i32;
        let style = ("sans-serif", FONT - 4).into_font().color(&BLACK.mix(0.7));
        area.draw(&Text::new(name, ((at - origin - 16).min(size - width), top - 38), style))?;
    }
    Ok(())
}
