//! Flank and edge zone of a contact patch.
//!
//! An edge that cuts a patch off, or on which its curvature jumps, raises the pressure beside it, up to a singularity at a sharp
//! corner. The edge zone is what lies within one Hertzian half-width of such an edge if the patch reaches it, and beyond on its
//! rounding; the flank zone is what lies farther away. A patch whose line of closest approach is farther from the edge than its half-width does not reach the edge, and has its
//! largest pressure in the flank zone. As the line comes nearer to the edge, what such a patch adds to the flank falls in proportion
//! to the distance, down to nothing where the line is on the edge: near a cut the pressure is steep one half-width away, too.
//!
//! The edge's position, the line of closest approach and the half-width (of the load that the patch carries, Johnson, eq. 4.43) follow
//! from the surfaces and the load, not from the contact grid, so the largest pressure of either zone changes continuously with the
//! grid and converges. Pressures at the limit of both zones are interpolated between cells.

use super::pressure::{self, Peak, Piece, center, hertz_half_width};

/// A part of a patch across its contact line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Zone {
    /// At least one Hertzian half-width away from the ends of both flanks.
    Flank,
    /// Nearer to the end of a flank, or beyond it.
    Edge,
}

/// Ends of the flanks on the common tangent, m: where the rounding of an edge begins or a surface ends. Infinite where there is
/// none.
pub type FlankEnds = [f64; 2];

/// No edge anywhere.
pub const ENDLESS: FlankEnds = [f64::NEG_INFINITY, f64::INFINITY];

/// Hertzian half-width of a line load of 1 N/m, m: half-widths grow with the root of the line load. Zero for rigid bodies and where
/// the relative curvature (1/m) is not positive.
pub fn unit_half_width(contact_modulus: f64, relative_curvature: f64) -> f64 {
    let half_width = hertz_half_width(1.0, contact_modulus, relative_curvature);
    if half_width.is_finite() { half_width } else { 0.0 }
}

impl Zone {
    /// Intervals of the zone along the tangent, m. Beside an edge that a patch does not reach there is no edge zone.
    fn intervals(self, [low, high]: FlankEnds, closest: f64, half_width: f64) -> [[f64; 2]; 2] {
        let beside = |distance: f64| if distance < half_width { half_width } else { 0.0 };
        match self {
            Zone::Flank => [[low + half_width, high - half_width], [f64::INFINITY, f64::NEG_INFINITY]],
            Zone::Edge => [
                [f64::NEG_INFINITY, low + beside(closest - low)],
                [high - beside(high - closest), f64::INFINITY],
            ],
        }
    }

    /// The largest pressure in the zone, Pa. `half_width` is that of the patch, m, and `closest` where the surfaces come closest to each
    /// other. `None` where nothing in the zone is loaded.
    pub fn peak(
        self,
        pieces: &[impl Piece],
        pressures: &[f64],
        (flank, closest): (FlankEnds, f64),
        half_width: f64,
    ) -> Option<Peak> {
        let within = |interval| peak_within(pieces, pressures, interval);
        let peaks = self.intervals(flank, closest, half_width).into_iter().filter_map(within);
        let largest = peaks.reduce(|one, other| if other.pressure > one.pressure { other } else { one })?;
        let distance = (closest - flank[0]).min(flank[1] - closest);
        let part = match self {
            Zone::Flank if distance < half_width => (distance / half_width).max(0.0),
            _ => 1.0,
        };
        (part > 0.0).then_some(Peak { pressure: part * largest.pressure, ..largest })
    }
}

/// The largest pressure between two places, Pa.
fn peak_within(pieces: &[impl Piece], pressures: &[f64], [from, to]: [f64; 2]) -> Option<Peak> {
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

/// The pressure at a place: the squares of pressures, which are parabolas under Hertz's pressure, go straight between centres of
/// cells. `None` where there is no load.
fn at(pieces: &[impl Piece], pressures: &[f64], x: f64) -> Option<Peak> {
    let behind = pieces.partition_point(|piece| center(piece) < x);
    let own = |cell: usize| pressures.get(cell).copied().unwrap_or(0.0);
    let (pressure, cell) = match behind.checked_sub(1) {
        Some(before) if behind < pieces.len() => {
            let (left, right) = (center(&pieces[before]), center(&pieces[behind]));
            let part = (x - left) / (right - left);
            let squared = (1.0 - part) * own(before).powi(2) + part * own(behind).powi(2);
            (squared.sqrt(), if own(before) > own(behind) { before } else { behind })
        }
        // Beyond the outermost centres.
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

    /// Hertz's pressure 1 over half-width 1 about `middle`, averaged over cells that end at a flank's end at 0.
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
            zone.peak(&pieces, &pressures, ([f64::NEG_INFINITY, 0.0], middle), 1.0)
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

    /// Nearer to the edge the pressure at one half-width from the edge is left, less the nearer the patch is; nothing jumps.
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

    #[test]
    fn without_edges_all_is_flank() {
        let (pieces, pressures) = hertz(-2.0, 50);
        let whole = pressure::peak(&pieces, &pressures);
        assert_eq!(Zone::Flank.peak(&pieces, &pressures, (ENDLESS, 0.0), 1.0), whole);
        assert_eq!(Zone::Edge.peak(&pieces, &pressures, (ENDLESS, 0.0), 1.0), None);
        assert_eq!([unit_half_width(f64::INFINITY, 10.0), unit_half_width(1e11, 0.0)], [0.0; 2]);
    }
}
