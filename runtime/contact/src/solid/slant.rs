//! Slant of the cells of a slice that its contact line or the end of a flank crosses obliquely.
//!
//! Gaps are averaged over parallelograms. Their long sides follow the contact line, and those that
//! the end of a flank crosses follow that end. The mean gap of a rectangle would include the space
//! beyond an oblique edge, so that the edge and the cells next to it would carry too little load.
//! Across an oblique contact line it would be too large by κ d² / 24, with the relative curvature κ
//! and the displacement d of the contact line within the slice. The compliance is that of
//! rectangles of the same size and centre.

use super::contact_line::ContactLinePoint;

/// Ends of flanks that are steeper than this, x per y, do not slant cells.
const STEEPEST: f64 = 1.0;
/// Parts of a contact line that are shorter than this fraction of it have no direction.
const SHORTEST: f64 = 1e-3;

/// End of a flank in a slice.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlankEnd {
    /// x at the middle of the slice, m.
    pub x: f64,
    /// Rate along the slice, x per y.
    pub rate: f64,
}

/// Direction of the cells of a slice as a function of x, x per y.
pub(super) struct Slant {
    /// x of the contact line, m, and its rate.
    line: [f64; 2],
    /// Ends of the flanks at low and at high x.
    ends: [Option<FlankEnd>; 2],
    /// Length of the slice, m.
    length: f64,
}

impl Slant {
    /// Creates the slant of a slice of this length. `line` is x of the contact line, m, and its
    /// rate.
    pub fn new(line: [f64; 2], ends: [Option<FlankEnd>; 2], length: f64) -> Slant {
        let oblique = |end: Option<FlankEnd>| end.filter(|end| end.rate.abs() <= STEEPEST);
        Slant { line, ends: ends.map(oblique), length }
    }

    /// Returns the direction of a cell whose centre is at `x`.
    ///
    /// An end crosses cells that follow the contact line up to half of its displacement relative
    /// to them. These cells follow the end. From there they turn, up to the contact line or, if
    /// that is nearer, over the same distance: a quick turn would make parallelograms overlap.
    pub fn at(&self, x: f64) -> f64 {
        let [closest, line] = self.line;
        let turn = |side: usize| {
            let FlankEnd { x: end, rate } = self.ends[side]?;
            let inside = |x: f64| if side == 0 { x - end } else { end - x };
            let crossed = 0.5 * (rate - line).abs() * self.length;
            let turned = inside(closest).max(2.0 * crossed);
            let part = if crossed > 0.0 { (turned - inside(x)) / (turned - crossed) } else { 0.0 };
            Some(part.clamp(0.0, 1.0) * (rate - line))
        };
        let turns = [0, 1].map(|side| turn(side).unwrap_or(0.0));
        // Where both ends cross a cell, it follows neither.
        line + turns[0] + turns[1]
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

    /// An edge with rate -0.4 and a contact line with rate 0.1 at the middle, or next to the edge. In
    /// a slice of length 2 the edge crosses cells within 0.5.
    #[test]
    fn cells_turn_from_the_contact_line_to_the_edge() {
        let far = [(-1.0, 0.1), (0.0, 0.1), (0.75, -0.15), (1.5, -0.4), (2.0, -0.4), (3.0, -0.4)];
        let near = [(0.75, 0.1), (1.0, 0.1), (1.25, -0.15), (1.5, -0.4), (2.0, -0.4), (3.0, -0.4)];
        for (sense, closest, expected) in [(1.0, 0.0, far), (-1.0, 0.0, far), (1.0, 1.9, near)] {
            let end = Some(FlankEnd { x: 2.0 * sense, rate: -0.4 });
            let ends = if sense > 0.0 { [None, end] } else { [end, None] };
            let slant = Slant::new([sense * closest, 0.1], ends, 2.0);
            for (x, expected) in expected {
                let found = slant.at(sense * x);
                assert!((found - expected).abs() < 1e-12, "{sense} {x}: {found}");
            }
        }
    }

    #[test]
    fn a_side_face_across_the_slices_does_not_turn_cells() {
        let slant = Slant::new([0.0, 0.1], [None, Some(FlankEnd { x: 2.0, rate: -8.0 })], 1.0);
        assert_eq!(slant.at(1.9), 0.1);
    }

    #[test]
    fn an_end_parallel_to_the_contact_line_does_not_turn_cells() {
        let slant = Slant::new([0.0, 0.1], [None, Some(FlankEnd { x: 2.0, rate: 0.1 })], 1.0);
        assert_eq!([1.0, 2.0, 3.0].map(|x| slant.at(x)), [0.1; 3]);
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
