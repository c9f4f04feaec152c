//! Heat maps of a sweep over two axes: a cell per case, coloured by a value.

use super::chart::{Axis, FONT, LEGEND, Plot, SHADES, TALL, drawn, shade};
use crate::signals::{label, tick};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Largest number of cells in a row whose values are written into them.
const WRITTEN: usize = 10;
/// Largest number of names along an axis.
const NAMES: usize = 14;
/// Colour of numbers in pale cells. The style of the page changes black in dark mode, but not the
/// colours of cells.
const DARK: RGBColor = RGBColor(27, 31, 36);
/// Shade above which numbers are white.
const DARK_SHADE: f64 = 0.55;

/// Values over two axes.
pub struct Grid {
    /// Values of the abscissa, as text.
    pub columns: Vec<String>,
    /// Values of the ordinate, as text.
    pub rows: Vec<String>,
    /// Values by row and column; NaN leaves a cell empty.
    pub values: Vec<Vec<f64>>,
}

/// Draws a heat map. All cells have the same size, so that axes of any spacing are legible.
pub fn plot(x: &Axis, y: &Axis, value: &Axis, grid: &Grid) -> Plot {
    let known = grid.values.iter().flatten().copied().filter(|value| value.is_finite());
    let (low, high) = known
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
    if low > high {
        return Plot::default();
    }
    let is_constant = high - low <= 1e-9 * low.abs().max(high.abs());
    let part = |value: f64| if is_constant { 0.0 } else { (value - low) / (high - low) };
    let svg = drawn(TALL, |area| {
        let (picture, legend) = area.split_horizontally(TALL.0 - LEGEND);
        let (width, height) = (grid.columns.len() as f64, grid.rows.len() as f64);
        let mut chart = ChartBuilder::on(&picture)
            .margin(8)
            .margin_top(16)
            .x_label_area_size(88)
            .y_label_area_size(148)
            .build_cartesian_2d(0.0..width, 0.0..height)?;
        chart
            .configure_mesh()
            .disable_mesh()
            .x_labels(0)
            .y_labels(0)
            .x_desc(label(x.what, x.unit))
            .y_desc(label(y.what, y.unit))
            .axis_desc_style(("sans-serif", FONT))
            .draw()?;
        for (row, values) in grid.values.iter().enumerate() {
            for (column, &value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
                let at = (column as f64, row as f64);
                let corners = [at, (at.0 + 1.0, at.1 + 1.0)];
                let cell = Rectangle::new(corners, shade(part(value)).filled());
                chart.draw_series(std::iter::once(cell))?;
                if grid.columns.len() > WRITTEN || grid.rows.len() > WRITTEN {
                    continue;
                }
                let colour = if part(value) > DARK_SHADE { WHITE } else { DARK };
                let style = ("sans-serif", FONT - 6).into_font().color(&colour);
                let style = style.pos(Pos::new(HPos::Center, VPos::Center));
                let centre = chart.backend_coord(&(at.0 + 0.5, at.1 + 0.5));
                picture.draw(&Text::new(rounded(value), centre, style))?;
            }
        }
        let grey = ("sans-serif", FONT - 3).into_font().color(&BLACK);
        for (column, name) in shown(&grid.columns) {
            let at = chart.backend_coord(&(column as f64 + 0.5, 0.0));
            let style = grey.clone().pos(Pos::new(HPos::Center, VPos::Top));
            picture.draw(&Text::new(name.clone(), (at.0, at.1 + 8), style))?;
        }
        for (row, name) in shown(&grid.rows) {
            let at = chart.backend_coord(&(0.0, row as f64 + 0.5));
            let style = grey.clone().pos(Pos::new(HPos::Right, VPos::Center));
            picture.draw(&Text::new(name.clone(), (at.0 - 8, at.1), style))?;
        }
        if is_constant {
            return Ok(());
        }
        let mut key = ChartBuilder::on(&legend)
            .margin(8)
            .margin_top(16)
            .margin_right(60)
            .x_label_area_size(88)
            .y_label_area_size(124)
            .build_cartesian_2d(0.0..1.0, low..high)?;
        let step = |k: usize| low + (high - low) * k as f64 / SHADES as f64;
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

/// Formats three significant digits.
fn rounded(value: f64) -> String {
    tick(format!("{value:.2e}").parse().unwrap_or(value))
}

/// Returns the names that fit along an axis, with their indices.
fn shown(names: &[String]) -> impl Iterator<Item = (usize, &String)> {
    names.iter().enumerate().step_by(names.len().div_ceil(NAMES).max(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_have_their_values_and_failed_cases_are_empty() {
        let axis = |what| Axis { what, unit: "" };
        let grid = Grid {
            columns: vec!["10".into(), "20".into()],
            rows: vec!["a".into(), "b".into()],
            values: vec![vec![1.0, 2.0], vec![f64::NAN, 4.0]],
        };
        let text = plot(&axis("x"), &axis("y"), &axis("z"), &grid).svg;
        let cells = |text: &str| text.matches("<rect").count() - SHADES;
        assert_eq!(cells(&text), 3, "{text}");
        let empty = Grid { values: vec![vec![f64::NAN; 2]; 2], ..grid };
        assert!(plot(&axis("x"), &axis("y"), &axis("z"), &empty).is_empty());
    }
}
