//! Polar plots of levels, as SVG.

use super::chart::{COLOURS, Error, FONT, Plot, drawn};
use plotters::coord::Shift;
use plotters::prelude::*;

/// Size of a row of three plots.
const SIZE: (u32, u32) = (1640, 640);
/// Range of levels, dB: circles every 10 dB.
const RANGE: f64 = 40.0;
const STEP: f64 = 10.0;
/// Largest angle between adjacent points that a curve connects, degrees.
const GAP: f64 = 10.0;
/// Space for the names of the axes, drawing units.
const MARGIN: f64 = 56.0;
/// Direction of the labels of the circles, degrees.
const LABELS: f64 = 60.0;

/// Levels in a plane over the angle.
#[derive(Clone, Debug, Default)]
pub struct Pattern {
    /// Name in the legend.
    pub name: String,
    /// Levels by plane: angles in degrees, ascending, and levels in dB.
    pub planes: [Vec<(f64, f64)>; 3],
}

/// Plots levels in three planes, which have these names for the directions of 0 and 90 degrees.
/// Levels more than 40 dB below the largest one are in the centre.
pub fn plot(axes: [[&str; 2]; 3], patterns: &[Pattern]) -> Plot {
    let levels = patterns.iter().flat_map(|pattern| pattern.planes.iter().flatten().map(|point| point.1));
    let largest = levels.filter(|level| level.is_finite()).fold(f64::NEG_INFINITY, f64::max);
    if !largest.is_finite() {
        return Plot::default();
    }
    let top = STEP * (largest / STEP).ceil();
    let svg = drawn(SIZE, |area| {
        for (plane, part) in area.split_evenly((1, 3)).iter().enumerate() {
            draw(part, axes[plane], top, |pattern| &patterns[pattern].planes[plane], patterns.len())?;
        }
        Ok(())
    });
    let legend =
        patterns.iter().enumerate().map(|(index, pattern)| (index % COLOURS.len(), pattern.name.clone()));
    Plot { svg, legend: legend.collect(), ..Plot::default() }
}

fn draw<'p>(
    area: &DrawingArea<SVGBackend<'_>, Shift>,
    [first, second]: [&str; 2],
    top: f64,
    points: impl Fn(usize) -> &'p Vec<(f64, f64)>,
    count: usize,
) -> Result<(), Error> {
    let (width, height) = area.dim_in_pixel();
    let center = [0.5 * f64::from(width), 0.5 * f64::from(height)];
    let radius = 0.5 * f64::from(width.min(height)) - MARGIN;
    let at = |angle: f64, part: f64| -> (i32, i32) {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let [x, y] = [center[0] + radius * part * cosine, center[1] - radius * part * sine];
        (x.round() as i32, y.round() as i32)
    };
    let part = |level: f64| (1.0 - (top - level) / RANGE).clamp(0.0, 1.0);
    let grid = BLACK.mix(0.15);
    for step in 1..=(RANGE / STEP) as usize {
        let size = (radius * step as f64 * STEP / RANGE).round() as i32;
        area.draw(&Circle::new(at(0.0, 0.0), size, grid.stroke_width(2)))?;
    }
    for spoke in 0..12 {
        area.draw(&PathElement::new([at(0.0, 0.0), at(30.0 * f64::from(spoke), 1.0)], grid))?;
    }
    let style = || ("sans-serif", FONT - 4).into_font().color(&BLACK.mix(0.7));
    for step in 1..=(RANGE / STEP) as usize {
        let own = step as f64 * STEP / RANGE;
        let (x, y) = at(LABELS, own);
        area.draw(&Text::new(format!("{:.0}", top - RANGE + RANGE * own), (x + 4, y - 14), style()))?;
    }
    let (x, y) = at(0.0, 1.0);
    area.draw(&Text::new(first.to_owned(), (x + 12, y - 16), style()))?;
    let (x, y) = at(90.0, 1.0);
    area.draw(&Text::new(second.to_owned(), (x - 8, y - 40), style()))?;
    for pattern in 0..count {
        let colour = COLOURS[pattern % COLOURS.len()].stroke_width(4);
        for stretch in stretches(points(pattern)) {
            let path: Vec<(i32, i32)> =
                stretch.into_iter().map(|(angle, level)| at(angle, part(level))).collect();
            area.draw(&PathElement::new(path, colour))?;
        }
    }
    Ok(())
}

/// Divides a curve at gaps, such as the part behind a rigid plane, and closes it over 360 degrees.
fn stretches(points: &[(f64, f64)]) -> Vec<Vec<(f64, f64)>> {
    let known = points.iter().copied().filter(|(angle, level)| angle.is_finite() && !level.is_nan());
    let mut turn: Vec<(f64, f64)> = known.collect();
    // The first point again, a turn later.
    turn.extend(turn.first().copied().map(|(angle, level)| (angle + 360.0, level)));
    let mut all: Vec<Vec<(f64, f64)>> = Vec::new();
    for point in turn {
        match all.last_mut().filter(|last| last.last().is_some_and(|before| point.0 - before.0 <= GAP)) {
            Some(last) => last.push(point),
            None => all.push(vec![point]),
        }
    }
    all.retain(|stretch| stretch.len() > 1);
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_turns_are_closed_and_half_ones_are_not() {
        let circle: Vec<(f64, f64)> = (0..72).map(|k| (5.0 * f64::from(k), 60.0)).collect();
        let found = stretches(&circle);
        assert_eq!((found.len(), found[0].len(), found[0][72].0), (1, 73, 360.0));
        let half: Vec<(f64, f64)> = circle.iter().copied().filter(|(angle, _)| *angle <= 180.0).collect();
        let found = stretches(&half);
        assert_eq!((found.len(), found[0].len()), (1, 37));
        // A half-turn over the angle zero.
        let right: Vec<(f64, f64)> =
            circle.iter().copied().filter(|(angle, _)| *angle <= 90.0 || *angle >= 270.0).collect();
        let found = stretches(&right);
        assert_eq!(found.iter().map(Vec::len).collect::<Vec<_>>(), [19, 19]);
        assert!(stretches(&[]).is_empty());
    }

    #[test]
    fn patterns_without_levels_have_no_plot() {
        let axes = [["x", "y"], ["y", "z"], ["z", "x"]];
        let pattern = |level: f64| Pattern {
            name: "2300 Hz".into(),
            planes: [vec![(0.0, level), (5.0, level)], Vec::new(), Vec::new()],
        };
        assert!(plot(axes, &[]).is_empty() && plot(axes, &[pattern(f64::NAN)]).is_empty());
        let found = plot(axes, &[pattern(63.0)]);
        assert!(found.svg.contains(">70</text>") || found.svg.contains("\n70\n"), "{}", found.svg);
        assert_eq!(found.legend, [(0, "2300 Hz".to_owned())]);
    }
}
