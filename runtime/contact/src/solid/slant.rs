//! Slant of the cells of a slice that its contact line or the end of a flank crosses obliquely.
//!
//! Gaps are averaged over parallelograms. Their long sides follow the contact line, next to the end
//! of a flank that end, and between them a direction in between. The mean gap of a rectangle would
//! include the space beyond an oblique edge, so that the edge and the cells next to it would carry
//! too little load. Across an oblique contact line it would be too large by κ d² / 24, with the
//! relative curvature κ and the displacement d of the contact line within the slice. The compliance
//! is that of rectangles of the same size and centre.

use super::contact_line::ContactLinePoint;
use crate::zone::FlankEnds;

/// Ends of flanks that are steeper than this, x per y, do not slant cells.
const STEEPEST: f64 = 1.0;
/// Parts of a contact line that are shorter than this fraction of it have no direction.
const SHORTEST: f64 = 1e-3;

/// Direction of the cells of a slice as a function of x, x per y.
pub(super) struct Slant {
    /// x of the contact line, m, and its rate.
    line: [f64; 2],
    /// x, m, and rates of the ends of the flanks at low and at high x.
    ends: [Option<[f64; 2]>; 2],
}

impl Slant {
    /// `closest` is x of the contact line at `y`; `rate` is its rate, `None` if the contact line is
    /// on an edge there. `ends` are those of the flanks at `y`, `around` at both ends of the slice
    /// of length `length`.
    pub fn new(
        closest: f64,
        rate: Option<f64>,
        ends: FlankEnds,
        around: [FlankEnds; 2],
        length: f64,
    ) -> Slant {
        let ends = [0, 1].map(|side| {
            let end = [ends[side], (around[1][side] - around[0][side]) / length];
            (end.iter().all(|value| value.is_finite()) && end[1].abs() <= STEEPEST).then_some(end)
        });
        let from_line = |end: &&[f64; 2]| (end[0] - closest).abs();
        let nearest = ends.iter().flatten().min_by(|a, b| from_line(a).total_cmp(&from_line(b)));
        match rate {
            Some(rate) => Slant { line: [closest, rate], ends },
            // On an edge the contact line follows it.
            None => Slant { line: [closest, nearest.map_or(0.0, |[_, rate]| *rate)], ends: [None; 2] },
        }
    }

    /// Returns the direction of a cell whose centre is at `x`.
    pub fn at(&self, x: f64) -> f64 {
        let [closest, rate] = self.line;
        match self.ends[usize::from(x > closest)] {
            Some([end, end_rate]) if end != closest => {
                let part = ((x - closest) / (end - closest)).clamp(0.0, 1.0);
                rate + part * (end_rate - rate)
            }
            _ => rate,
        }
    }
}

/// Returns the rate of a contact line at `y`, x per y, interpolated between the middles of its
/// parts on the flanks; zero without such a part.
pub(super) fn rate_on_flanks(points: &[ContactLinePoint], y: f64) -> f64 {
    let [from, to] = [points.first(), points.last()].map(|point| point.map_or(0.0, |point| point.at[1]));
    let shortest = SHORTEST * (to - from);
    let parts = points.windows(2).filter(|ends| {
        ends.iter().all(|point| !point.on_edge && !point.at_end) && ends[1].at[1] - ends[0].at[1] > shortest
    });
    let rates = parts.map(|ends| {
        let [from, to] = [ends[0].at, ends[1].at];
        [0.5 * (from[1] + to[1]), (to[0] - from[0]) / (to[1] - from[1])]
    });
    let (mut below, mut above): (Option<[f64; 2]>, Option<[f64; 2]>) = (None, None);
    for part in rates {
        if part[0] <= y {
            below = Some(part);
        } else {
            above = above.or(Some(part));
        }
    }
    match (below, above) {
        (Some(low), Some(high)) => low[1] + (high[1] - low[1]) * (y - low[0]) / (high[0] - low[0]),
        (Some(only), None) | (None, Some(only)) => only[1],
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Contact line with rate 0.1 at x = 0, and an edge with rate -0.4 at x = 2.
    #[test]
    fn cells_turn_from_the_contact_line_to_the_edge() {
        let around = [[f64::NEG_INFINITY, 2.2], [f64::NEG_INFINITY, 1.8]];
        let slant = Slant::new(0.0, Some(0.1), [f64::NEG_INFINITY, 2.0], around, 1.0);
        for (x, expected) in [(-1.0, 0.1), (0.0, 0.1), (1.0, -0.15), (2.0, -0.4), (3.0, -0.4)] {
            assert!((slant.at(x) - expected).abs() < 1e-12, "{x}: {}", slant.at(x));
        }
        let on_edge = Slant::new(2.001, None, [f64::NEG_INFINITY, 2.0], around, 1.0);
        assert!([0.0, 2.0, 3.0].iter().all(|x| (on_edge.at(*x) + 0.4).abs() < 1e-12));
    }

    #[test]
    fn a_side_face_across_the_slices_does_not_turn_cells() {
        let slant = Slant::new(0.0, Some(0.1), [-3.0, 2.0], [[-3.0, 6.0], [-3.0, -2.0]], 1.0);
        assert_eq!(slant.at(1.0), 0.1);
    }

    #[test]
    fn the_rate_is_continuous_along_the_contact_line() {
        let point = |x: f64, y: f64, on_edge: bool| ContactLinePoint {
            at: [x, y],
            gap: 0.0,
            slope: [0.0; 2],
            on_edge,
            at_end: false,
        };
        let points =
            [point(0.0, 0.0, false), point(1.0, 1.0, false), point(4.0, 2.0, false), point(4.0, 3.0, true)];
        for (y, expected) in [(0.0, 1.0), (0.5, 1.0), (1.0, 2.0), (1.5, 3.0), (2.5, 3.0)] {
            assert!((rate_on_flanks(&points, y) - expected).abs() < 1e-12, "{y}");
        }
        assert_eq!(rate_on_flanks(&points[..1], 0.0), 0.0);
        // Its last point is found twice.
        let twice = [point(0.0, 0.0, false), point(1.0, 1.0, false), point(1.1, 1.0, false)];
        assert_eq!(rate_on_flanks(&twice, 1.0), 1.0);
    }
}
