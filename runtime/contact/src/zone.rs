//! Flank zone and edge zone of a contact patch.
//!
//! An edge that truncates a patch, or on which the curvature jumps, raises the pressure next to it,
//! up to a singularity at a sharp corner. If the patch reaches such an edge, the edge zone is the
//! part of the patch within one Hertzian half-width of the edge. It also includes the part beyond
//! the edge, on its rounding. The flank zone is the rest of the patch. A patch whose contact line
//! is farther from the edge than its half-width does not reach the edge, and has its largest
//! pressure in the flank zone. As the contact line approaches the edge, the contribution of the
//! patch to the flank zone decreases in proportion to the distance, down to zero for a contact line
//! on the edge, because near a truncation the pressure gradient is large one half-width away, too.
//!
//! Edge, contact line and half-width (under the load of the patch, Johnson, eq. 4.43) follow from
//! the surfaces and the load, not from the contact grid, and pressures at the limit of the zones
//! are interpolated between cells. So the largest pressure of the flank zone is continuous in the
//! grid and converges.
//!
//! A slice of a three-dimensional patch has a length. An oblique edge approaches over that length,
//! and the load may end before the edge at the middle of the slice, with the raised pressure next
//! to that end. Therefore the half-width
//! is measured from the end of the load ([`Edges::effective`]). As slices become shorter, that end
//! tends to the edge itself.

use super::pressure::{self, Peak, PressureStrip, center, hertz_half_width};

/// Part of a patch across its contact line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// At least one Hertzian half-width away from the ends of both flanks.
    Flank,
    /// Nearer to the end of a flank, or beyond it.
    Edge,
}

/// Ends of the flanks on the common tangent, m: the start of a rounded edge or the end of a
/// surface. Infinite without one.
pub type FlankEnds = [f64; 2];

/// No edges.
pub const ENDLESS: FlankEnds = [f64::NEG_INFINITY, f64::INFINITY];

/// Returns the Hertzian half-width of a line load of 1 N/m, m; half-widths grow with the root of
/// the line load. Zero for rigid bodies and for a relative curvature (1/m) that is not positive.
pub fn unit_half_width(contact_modulus: f64, relative_curvature: f64) -> f64 {
    let half_width = hertz_half_width(1.0, contact_modulus, relative_curvature);
    if half_width.is_finite() { half_width } else { 0.0 }
}

/// Edges next to a section across the contact line, or next to a slice of a three-dimensional
/// patch, on the common tangent, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edges {
    /// Ends of the flanks at the middle of the slice.
    pub ends: FlankEnds,
    /// Nearest ends of the flanks over the length of the slice.
    pub nearest: FlankEnds,
    /// Location of the closest approach.
    pub closest: f64,
}

impl Edges {
    /// Creates edges parallel to the contact line.
    pub fn parallel(ends: FlankEnds, closest: f64) -> Edges {
        Edges { ends, nearest: ends, closest }
    }

    /// Returns the ends of the load, each between the nearest point of its edge and the point at
    /// the middle of the slice.
    fn effective(&self, pieces: &[impl PressureStrip], pressures: &[f64]) -> FlankEnds {
        let loaded = |cell: &usize| pressures[*cell] > 0.0;
        let (first, last) = ((0..pieces.len()).find(loaded), (0..pieces.len()).rfind(loaded));
        let (Some(first), Some(last)) = (first, last) else { return self.ends };
        // A cell that carries less than its neighbour counts in part, so that the end does not jump
        // as a cell becomes loaded.
        let part = |cell: usize, neighbour: Option<&f64>| {
            neighbour.filter(|p| **p > 0.0).map_or(1.0, |p| (pressures[cell] / p).min(1.0))
        };
        let width = |cell: usize| {
            let [from, to] = pieces[cell].ends();
            to - from
        };
        let low = pieces[first].ends()[1] - part(first, pressures.get(first + 1)) * width(first);
        let before = last.checked_sub(1).and_then(|cell| pressures.get(cell));
        let high = pieces[last].ends()[0] + part(last, before) * width(last);
        [low.min(self.nearest[0]).max(self.ends[0]), high.max(self.nearest[1]).min(self.ends[1])]
    }

    /// Returns whether the patch reaches an edge here: its contact line is nearer to the end of the
    /// load at an edge than the half-width of the patch, m.
    pub fn reached(&self, pieces: &[impl PressureStrip], pressures: &[f64], half_width: f64) -> bool {
        let [low, high] = self.effective(pieces, pressures);
        (self.closest - low).min(high - self.closest) < half_width
    }
}

/// Returns the zone of each cell by its centre. `half_width` is that of the patch, m. Cells next to
/// an edge that the patch does not reach are in the flank zone.
pub fn of_cells(
    pieces: &[impl PressureStrip],
    pressures: &[f64],
    edges: &Edges,
    half_width: f64,
) -> Vec<Zone> {
    let intervals = Zone::Edge.intervals(edges.effective(pieces, pressures), edges.closest, half_width);
    let is_edge = |x: f64| intervals.iter().any(|[from, to]| (*from..*to).contains(&x));
    pieces.iter().map(|piece| if is_edge(center(piece)) { Zone::Edge } else { Zone::Flank }).collect()
}

impl Zone {
    /// Returns the intervals of the zone along the tangent, m. There is no edge zone at an edge
    /// that the patch does not reach.
    fn intervals(self, [low, high]: FlankEnds, closest: f64, half_width: f64) -> [[f64; 2]; 2] {
        let other_loads = |distance: f64| if distance < half_width { half_width } else { 0.0 };
        match self {
            Zone::Flank => [[low + half_width, high - half_width], [f64::INFINITY, f64::NEG_INFINITY]],
            Zone::Edge => [
                [f64::NEG_INFINITY, low + other_loads(closest - low)],
                [high - other_loads(high - closest), f64::INFINITY],
            ],
        }
    }

    /// Returns the largest pressure in the zone, Pa. `half_width` is that of the patch, m. `None`
    /// if nothing in the zone is loaded.
    pub fn peak(
        self,
        pieces: &[impl PressureStrip],
        pressures: &[f64],
        edges: &Edges,
        half_width: f64,
    ) -> Option<Peak> {
        let ends = edges.effective(pieces, pressures);
        let within = |interval| peak_within(pieces, pressures, interval);
        let peaks = self.intervals(ends, edges.closest, half_width).into_iter().filter_map(within);
        let largest = peaks.reduce(|one, other| if other.pressure > one.pressure { other } else { one })?;
        let distance = (edges.closest - ends[0]).min(ends[1] - edges.closest);
        let part = match self {
            Zone::Flank if distance < half_width => (distance / half_width).max(0.0),
            _ => 1.0,
        };
        (part > 0.0).then_some(Peak { pressure: part * largest.pressure, ..largest })
    }
}

/// Returns the largest pressure between two points (m), Pa.
pub(crate) fn peak_within(
    pieces: &[impl PressureStrip],
    pressures: &[f64],
    [from, to]: [f64; 2],
) -> Option<Peak> {
    if from >= to {
        return None;
    }
    let first = pieces.partition_point(|piece| center(piece) < from);
    let last = pieces.partition_point(|piece| center(piece) <= to);
    let inside =
        (first < last).then(|| pressure::peak(&pieces[first..last], &pressures[first..last])).flatten();
    let inside = inside.map(|peak| Peak { cell: peak.cell + first, ..peak });
    let limits = [from, to].into_iter().filter_map(|x| at(pieces, pressures, x));
    inside
        .into_iter()
        .chain(limits)
        .reduce(|one, other| if other.pressure > one.pressure { other } else { one })
}

/// Returns the pressure at a point by linear interpolation of squared pressures between the centres
/// of cells, because the squared Hertzian pressure is a parabola. `None` without load.
fn at(pieces: &[impl PressureStrip], pressures: &[f64], x: f64) -> Option<Peak> {
    let behind = pieces.partition_point(|piece| center(piece) < x);
    let own = |cell: usize| pressures.get(cell).copied().unwrap_or(0.0);
    let (pressure, cell) = match behind.checked_sub(1) {
        Some(before) if behind < pieces.len() => {
            let (left, right) = (center(&pieces[before]), center(&pieces[behind]));
            let part = (x - left) / (right - left);
            let squared = (1.0 - part) * own(before).powi(2) + part * own(behind).powi(2);
            (squared.sqrt(), if own(before) > own(behind) { before } else { behind })
        }
        // Outside the outermost centres.
        before => {
            let cell = before.unwrap_or(0);
            let [low, high] = pieces.get(cell)?.ends();
            ((low..=high).contains(&x).then(|| own(cell))?, cell)
        }
    };
    (pressure > 0.0).then_some(Peak { pressure, x, cell })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hertzian pressure with peak 1 and half-width 1 about `middle`, averaged over cells that end
    /// at a flank's end at 0.
    fn hertz(middle: f64, cells: usize) -> (Vec<[f64; 2]>, Vec<f64>) {
        let size = 4.0 / cells as f64;
        let pieces: Vec<[f64; 2]> =
            (0..cells).map(|k| [-4.0 + k as f64 * size, -4.0 + (k + 1) as f64 * size]).collect();
        let primitive = |x: f64| {
            let u = (x - middle).clamp(-1.0, 1.0);
            0.5 * (u * (1.0 - u * u).max(0.0).sqrt() + u.asin())
        };
        let pressures = pieces.iter().map(|[a, b]| (primitive(*b) - primitive(*a)) / size).collect();
        (pieces, pressures)
    }

    fn both(middle: f64, cells: usize) -> [f64; 2] {
        let (pieces, pressures) = hertz(middle, cells);
        [Zone::Flank, Zone::Edge].map(|zone| {
            zone.peak(&pieces, &pressures, &Edges::parallel([f64::NEG_INFINITY, 0.0], middle), 1.0)
                .map_or(0.0, |peak| peak.pressure)
        })
    }

    #[test]
    fn a_patch_that_does_not_reach_the_edge_has_its_peak_on_the_flank() {
        let [flank, edge] = both(-2.5, 160);
        assert!((flank - 1.0).abs() < 1e-3 && edge == 0.0, "{flank} {edge}");
        let [flank, edge] = both(-1.05, 160);
        assert!((flank - 1.0).abs() < 1e-3 && edge == 0.0, "{flank} {edge}");
    }

    /// Near the edge, the pressure one half-width away from the edge counts in proportion to the
    /// distance.
    #[test]
    fn zones_change_continuously() {
        for (middle, expected) in
            [(-0.8, 0.8 * 0.96_f64.sqrt()), (-0.5, 0.5 * 0.75_f64.sqrt()), (-0.2, 0.2 * 0.36_f64.sqrt())]
        {
            for cells in [40, 56, 97, 160] {
                let [flank, edge] = both(middle, cells);
                let off = 1.5 / cells as f64;
                assert!((flank - expected).abs() < off, "{middle} {cells}: {flank} {expected}");
                assert!((edge - 1.0).abs() < off, "{middle} {cells}: {edge}");
            }
        }
    }

    /// An edge crosses a slice whose half-width is 1: the load ends at x = 0.4, with the largest
    /// pressure in the cell next to it, for any position of the edge at the middle of the slice.
    #[test]
    fn a_cell_beside_an_oblique_edge_is_in_the_edge_zone() {
        let pieces: Vec<[f64; 2]> = (-5..5).map(|k| [0.4 * f64::from(k), 0.4 * f64::from(k + 1)]).collect();
        let pressures = [0.0, 0.2, 0.7, 0.9, 1.0, 2.5, 0.0, 0.0, 0.0, 0.0];
        for middle in [0.4, 0.9, 1.1, 1.7] {
            let edges =
                Edges { ends: [f64::NEG_INFINITY, middle], nearest: [f64::NEG_INFINITY, 0.0], closest: 0.0 };
            let [flank, edge] =
                [Zone::Flank, Zone::Edge].map(|zone| zone.peak(&pieces, &pressures, &edges, 1.0));
            assert!(flank.is_some_and(|peak| peak.x <= -0.6 && peak.pressure < 1.0), "{middle}: {flank:?}");
            assert!(edge.is_some_and(|peak| peak.pressure == 2.5), "{middle}: {edge:?}");
            assert!(edges.reached(&pieces, &pressures, 1.0));
        }
        // An edge that the load does not reach does not divide the slice.
        let far = Edges { ends: [f64::NEG_INFINITY, 4.0], nearest: [f64::NEG_INFINITY, 3.0], closest: 0.0 };
        assert_eq!(Zone::Flank.peak(&pieces, &pressures, &far, 1.0), pressure::peak(&pieces, &pressures));
        assert!(!far.reached(&pieces, &pressures, 1.0));
    }

    /// The cells of the edge zone are those whose pressures it contains.
    #[test]
    fn zones_of_cells_are_those_of_the_peaks() {
        for (middle, is_reached) in [(-2.5, false), (-1.05, false), (-0.6, true), (0.3, true)] {
            let (pieces, pressures) = hertz(middle, 160);
            let edges = Edges::parallel([f64::NEG_INFINITY, 0.0], middle);
            let zones = of_cells(&pieces, &pressures, &edges, 1.0);
            let from = if is_reached { -1.0 } else { 0.0 };
            for (piece, zone) in pieces.iter().zip(zones) {
                assert_eq!(zone == Zone::Edge, center(piece) >= from, "{middle} {piece:?}");
            }
        }
    }

    /// The limit of the zones does not jump as the outermost cell becomes loaded.
    #[test]
    fn the_end_of_the_load_is_continuous() {
        let pieces: Vec<[f64; 2]> = (0..4).map(|k| [f64::from(k), f64::from(k + 1)]).collect();
        let edges = Edges { ends: [f64::NEG_INFINITY, 4.0], nearest: [f64::NEG_INFINITY, 2.0], closest: 1.0 };
        let end = |last: f64| edges.effective(&pieces, &[1.0, 1.0, 1.0, last])[1];
        assert_eq!([0.0, 0.5, 1.0, 2.0].map(end), [3.0, 3.5, 4.0, 4.0]);
    }

    #[test]
    fn without_edges_all_is_flank() {
        let (pieces, pressures) = hertz(-2.0, 50);
        let whole = pressure::peak(&pieces, &pressures);
        assert_eq!(Zone::Flank.peak(&pieces, &pressures, &Edges::parallel(ENDLESS, 0.0), 1.0), whole);
        assert_eq!(Zone::Edge.peak(&pieces, &pressures, &Edges::parallel(ENDLESS, 0.0), 1.0), None);
        assert_eq!([unit_half_width(f64::INFINITY, 10.0), unit_half_width(1e11, 0.0)], [0.0; 2]);
    }
}
