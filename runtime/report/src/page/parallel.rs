//! Parallel coordinates: a vertical axis per param and output, and a line per case.

use super::chart::{FONT, Plot, TALL, drawn};
use crate::signals::tick;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// Largest number of lines; of more cases, every so many are drawn.
pub const LINES: usize = 400;
/// Largest number of axes that remain legible.
pub const AXES: usize = 9;
/// Space left and right of the axes, and above and below them.
const MARGIN: [i32; 4] = [110, 110, 130, 60];
/// Colours of the lowest and the highest line: both are legible on white and on black.
const ENDS: [[f64; 3]; 2] = [[58.0, 134.0, 214.0], [226.0, 92.0, 56.0]];
/// Largest number of letters of a name above an axis.
const LETTERS: usize = 18;

/// Vertical axis.
pub struct Coordinate {
    pub name: String,
    pub unit: String,
    pub kind: Kind,
}

/// Values of a coordinate by case.
pub enum Kind {
    Numbers(Vec<f64>),
    /// Indices into names.
    Choices(Vec<usize>, Vec<String>),
}

impl Coordinate {
    /// Returns the part of the height of each case; NaN for a case without a value.
    fn heights(&self) -> Vec<f64> {
        match &self.kind {
            Kind::Numbers(values) => {
                let (low, high) = ends(values);
                let part =
                    |value: &f64| if high > low { (value - low) / (high - low) } else { 0.5 + 0.0 * value };
                values.iter().map(part).collect()
            }
            Kind::Choices(values, names) => {
                let last = names.len().saturating_sub(1).max(1) as f64;
                values.iter().map(|value| *value as f64 / last).collect()
            }
        }
    }

    /// Returns labels with their heights.
    fn labels(&self) -> Vec<(f64, String)> {
        match &self.kind {
            Kind::Numbers(values) => {
                let (low, high) = ends(values);
                let rounded = |value: f64| tick(format!("{value:.3e}").parse().unwrap_or(value));
                match (low, high) {
                    _ if low > high => Vec::new(),
                    _ if low == high => vec![(0.5, rounded(low))],
                    _ => vec![(0.0, rounded(low)), (1.0, rounded(high))],
                }
            }
            Kind::Choices(_, names) => {
                let last = names.len().saturating_sub(1).max(1) as f64;
                names.iter().enumerate().map(|(k, name)| (k as f64 / last, name.clone())).collect()
            }
        }
    }
}

fn ends(values: &[f64]) -> (f64, f64) {
    let known = values.iter().copied().filter(|value| value.is_finite());
    known.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)))
}

fn colour(part: f64) -> RGBColor {
    let [red, green, blue] =
        [0, 1, 2].map(|k| (ENDS[0][k] + (ENDS[1][k] - ENDS[0][k]) * part.clamp(0.0, 1.0)).round() as u8);
    RGBColor(red, green, blue)
}

/// Shortens a long name.
fn shortened(name: &str) -> String {
    if name.chars().count() <= LETTERS {
        return name.to_owned();
    }
    name.chars().take(LETTERS - 1).chain(['…']).collect()
}

/// Draws the cases, coloured by the coordinate `by`. Cases without a value of a coordinate are left
/// out.
pub fn plot(coordinates: &[Coordinate], by: usize) -> Plot {
    let heights: Vec<Vec<f64>> = coordinates.iter().map(Coordinate::heights).collect();
    let count = heights.first().map_or(0, Vec::len);
    let complete: Vec<usize> =
        (0..count).filter(|&case| heights.iter().all(|axis| axis[case].is_finite())).collect();
    if coordinates.len() < 2 || complete.len() < 2 {
        return Plot::default();
    }
    let [left, right, above, below] = MARGIN;
    let (width, height) = (TALL.0 as i32 - left - right, TALL.1 as i32 - above - below);
    let x = |axis: usize| left + width * axis as i32 / (coordinates.len() as i32 - 1);
    let y = |part: f64| above + (f64::from(height) * (1.0 - part)).round() as i32;
    let svg = drawn(TALL, |area| {
        let stride = complete.len().div_ceil(LINES);
        for &case in complete.iter().step_by(stride) {
            let points: Vec<(i32, i32)> = (0..heights.len()).map(|k| (x(k), y(heights[k][case]))).collect();
            let style = colour(heights[by][case]).mix(0.55).stroke_width(2);
            area.draw(&PathElement::new(points, style))?;
        }
        let text = |size: i32| ("sans-serif", size).into_font().color(&BLACK);
        for (k, coordinate) in coordinates.iter().enumerate() {
            area.draw(&PathElement::new(vec![(x(k), y(0.0)), (x(k), y(1.0))], BLACK.stroke_width(2)))?;
            let side = match k {
                0 => HPos::Left,
                _ if k + 1 == coordinates.len() => HPos::Right,
                _ => HPos::Center,
            };
            let at = match k {
                0 => 8,
                _ if k + 1 == coordinates.len() => TALL.0 as i32 - 8,
                _ => x(k),
            };
            // Names of neighbours are on two lines, so that they do not overlap.
            let line = if k % 2 == 0 { 12 } else { 48 };
            let unit =
                if coordinate.unit.is_empty() { String::new() } else { format!(", {}", coordinate.unit) };
            let name = shortened(&coordinate.name);
            let style = text(FONT - 4).pos(Pos::new(side, VPos::Top));
            area.draw(&Text::new(format!("{name}{unit}"), (at, line), style))?;
            for (part, value) in coordinate.labels() {
                let style = text(FONT - 6);
                let (at, pos) = match (part, &coordinate.kind) {
                    (0.0, _) => ((x(k), y(0.0) + 8), Pos::new(HPos::Center, VPos::Top)),
                    (1.0, _) => ((x(k), y(1.0) - 8), Pos::new(HPos::Center, VPos::Bottom)),
                    (part, _) => ((x(k) + 8, y(part)), Pos::new(HPos::Left, VPos::Center)),
                };
                area.draw(&Text::new(value, at, style.pos(pos)))?;
            }
        }
        Ok(())
    });
    Plot { svg, ..Plot::default() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_per_case_passes_all_axes() {
        let numbers = |name: &str, values: &[f64]| Coordinate {
            name: name.into(),
            unit: "N".into(),
            kind: Kind::Numbers(values.to_vec()),
        };
        let choices = Kind::Choices(vec![0, 1, 1], vec!["plane".into(), "medium".into()]);
        let level = Coordinate { name: "fidelity".into(), unit: String::new(), kind: choices };
        let all = [numbers("a", &[1.0, 2.0, 3.0]), level, numbers("b", &[5.0, 4.0, f64::NAN])];
        let text = plot(&all, 2).svg;
        // Two complete cases and three axes.
        assert_eq!(text.matches("<polyline").count(), 5, "{text}");
        assert!(text.contains("medium") && text.contains("a, N"));
        assert!(plot(&all[..1], 0).is_empty());
    }
}
