//! Evaluation of the pressures of a three-dimensional patch: peak, extent of the loaded part, and
//! assessment of the grid.
//!
//! Across each slice and along the peaks of the slices p² is nearly a parabola, as in plane
//! contact.

use super::grid::{Cell, Grid, Slice};
use crate::grid::{LEAST_LOADED_CELLS, MARGIN};
use crate::pressure::{self, zeros_of_squared_pressure};
use crate::zone::{self, Zone};

/// Computes the pressure in each cell (Pa) from the cell forces (N).
pub fn pressures(cells: &[Cell], forces: &[f64]) -> Vec<f64> {
    cells.iter().zip(forces).map(|(cell, force)| force / cell.area()).collect()
}

/// Peak pressure of a patch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Peak {
    /// Peak pressure, Pa.
    pub pressure: f64,
    /// Location, x and y in the patch's frame, m.
    pub at: [f64; 2],
    /// Loaded cell nearest to the location.
    pub cell: usize,
}

/// Returns the ends of the cells of a slice across the contact line, and their pressures.
fn strip(grid: &Grid, pressures: &[f64], slice: usize) -> (Vec<[f64; 2]>, Vec<f64>) {
    let cells = grid.slices[slice].cells.clone();
    (grid.cells[cells.clone()].iter().map(|cell| cell.ends(0)).collect(), pressures[cells].to_vec())
}

/// Peak of an unloaded slice.
const NONE: pressure::Peak = pressure::Peak { pressure: 0.0, x: 0.0, cell: 0 };

/// Returns the peak of each slice, Pa; 0 for unloaded slices.
fn slice_peaks(grid: &Grid, pressures: &[f64]) -> Vec<pressure::Peak> {
    (0..grid.slices.len())
        .map(|slice| {
            let (cells, pressures) = strip(grid, pressures, slice);
            pressure::peak(&cells, &pressures).unwrap_or(NONE)
        })
        .collect()
}

/// Returns the largest pressure of each slice in a zone, Pa; 0 for unloaded slices. Cells are
/// numbered within the slice.
pub fn slice_peaks_in(grid: &Grid, pressures: &[f64], zone: Zone) -> Vec<pressure::Peak> {
    let half_width = half_width(grid, pressures);
    (0..grid.slices.len())
        .map(|slice| {
            let (cells, pressures) = strip(grid, pressures, slice);
            zone.peak(&cells, &pressures, &grid.slices[slice].edges, half_width).unwrap_or(NONE)
        })
        .collect()
}

/// Returns the Hertzian half-width of the patch, m: of the mean line load of its slices, weighted
/// by their forces.
fn half_width(grid: &Grid, pressures: &[f64]) -> f64 {
    let force = |cell: usize| pressures[cell] * grid.cells[cell].area();
    let (mut sum, mut by_load) = (0.0, 0.0);
    for slice in &grid.slices {
        let own: f64 = slice.cells.clone().map(force).sum();
        sum += own;
        by_load += own * own / (slice.y[1] - slice.y[0]);
    }
    if sum > 0.0 { grid.unit_half_width * (by_load / sum).sqrt() } else { 0.0 }
}

/// Returns the ends of each slice along the contact line, m.
fn lengths(grid: &Grid) -> Vec<[f64; 2]> {
    grid.slices.iter().map(|slice| slice.y).collect()
}

/// Returns the peak pressure, interpolated between cells and slices; `None` if no cell is loaded.
/// `pressures` are in Pa, one per cell.
pub fn peak(grid: &Grid, pressures: &[f64]) -> Option<Peak> {
    along(grid, &slice_peaks(grid, pressures), zone::ENDLESS)
}

/// Returns the largest pressure of a zone.
///
/// A contact line that ends at a side face has a singular pressure there, so the flank zone ends
/// one half-width before it. The edge zone is that of the edges across the slices only, because
/// every contact line along a whole face reaches its side faces.
pub fn peak_in(grid: &Grid, pressures: &[f64], zone: Zone) -> Option<Peak> {
    let peaks = slice_peaks_in(grid, pressures, zone);
    let half_width = half_width(grid, pressures);
    let between = match zone {
        Zone::Flank => between_side_faces(grid, half_width),
        Zone::Edge => zone::ENDLESS,
    };
    // At slices that an edge truncates, and within the edge zone, the peaks of the slices do not
    // lie on a parabola.
    let mut whole = peaks.clone();
    let mut largest_cut: Option<usize> = None;
    for index in 0..peaks.len() {
        let (cells, own) = strip(grid, pressures, index);
        if zone == Zone::Edge || grid.slices[index].edges.reached(&cells, &own, half_width) {
            whole[index] = NONE;
            let middle = middle(&grid.slices[index]);
            let larger = |other: usize| peaks[index].pressure > peaks[other].pressure;
            if between[0] <= middle && middle <= between[1] && largest_cut.is_none_or(larger) {
                largest_cut = Some(index);
            }
        }
    }
    let found = along(grid, &whole, between);
    let cut = largest_cut.map(|index| {
        let pressure::Peak { pressure, x, cell } = peaks[index];
        let slice = &grid.slices[index];
        Peak { pressure, at: [x, middle(slice)], cell: slice.cells.start + cell }
    });
    let cut = cut.filter(|peak| peak.pressure > found.map_or(0.0, |found| found.pressure));
    cut.or(found)
}

/// Returns the zone of each cell by its centre. Cells within one half-width of a side face at which
/// the contact line ends are in neither zone, as in [`peak_in`].
pub fn zones(grid: &Grid, pressures: &[f64]) -> Vec<Option<Zone>> {
    let half_width = half_width(grid, pressures);
    let [from, to] = between_side_faces(grid, half_width);
    let mut zones = vec![None; grid.cells.len()];
    for (index, slice) in grid.slices.iter().enumerate() {
        let (cells, own) = strip(grid, pressures, index);
        let is_beside = !(from..=to).contains(&middle(slice));
        let of_slice = zone::of_cells(&cells, &own, &slice.edges, half_width);
        for (cell, zone) in slice.cells.clone().zip(of_slice) {
            zones[cell] = (zone == Zone::Edge || !is_beside).then_some(zone);
        }
    }
    zones
}

/// Returns the part of the contact line that is at least one half-width (m) away from side faces,
/// m.
fn between_side_faces(grid: &Grid, half_width: f64) -> [f64; 2] {
    let (Some(first), Some(last)) = (grid.slices.first(), grid.slices.last()) else { return zone::ENDLESS };
    let [low, high] = grid.surface_ends;
    [
        if low { first.y[0] + half_width } else { f64::NEG_INFINITY },
        if high { last.y[1] - half_width } else { f64::INFINITY },
    ]
}

/// Returns the middle of a slice along the contact line, m.
fn middle(slice: &Slice) -> f64 {
    0.5 * (slice.y[0] + slice.y[1])
}

/// Returns the largest of the slices' peaks between two points of the contact line, m.
fn along(grid: &Grid, peaks: &[pressure::Peak], between: [f64; 2]) -> Option<Peak> {
    let values: Vec<f64> = peaks.iter().map(|peak| peak.pressure).collect();
    let found = zone::peak_within(&lengths(grid), &values, between)?;
    let own = &peaks[found.cell];
    Some(Peak {
        pressure: found.pressure,
        at: [own.x, found.x],
        cell: grid.slices[found.cell].cells.start + own.cell,
    })
}

/// Returns the half-extents of the loaded part, m: across, at the slice of the largest pressure,
/// and along. `None` with fewer than five loaded cells either way, or if a fit of p² does not have
/// two zeros.
pub fn half_axes(grid: &Grid, pressures: &[f64]) -> Option<[f64; 2]> {
    let peaks: Vec<f64> = slice_peaks(grid, pressures).iter().map(|peak| peak.pressure).collect();
    let largest = (0..peaks.len()).max_by(|&i, &j| peaks[i].total_cmp(&peaks[j]).then(j.cmp(&i)))?;
    let (cells, own) = strip(grid, pressures, largest);
    Some([pressure::half_width_of_core(&cells, &own)?, pressure::half_width_of_core(&lengths(grid), &peaks)?])
}

/// Assessment of a grid from a solution (report figures 3.40 to 3.42).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridReport {
    /// Number of cells that carry force.
    pub loaded_cells: usize,
    /// True across and along if an outermost cell is loaded although the surfaces continue.
    /// Pressures are overestimated then.
    pub truncated: [bool; 2],
    /// True across and along if fewer than five cells or slices are loaded, too few for a pressure
    /// distribution.
    pub under_resolved: [bool; 2],
    /// Recommended width and length (m), for the same M and N.
    pub recommended: [Option<f64>; 2],
}

/// Assesses a grid from the pressures (Pa) on it.
pub fn assess(grid: &Grid, pressures: &[f64]) -> GridReport {
    let loaded_cells = pressures.iter().filter(|&&p| p > 0.0).count();
    let peaks: Vec<f64> = slice_peaks(grid, pressures).iter().map(|peak| peak.pressure).collect();
    let mut report = GridReport {
        loaded_cells,
        truncated: [false; 2],
        under_resolved: [false; 2],
        recommended: [None; 2],
    };
    if loaded_cells == 0 {
        return report;
    }
    let mut most_loaded = 0;
    let mut width = None;
    for (index, slice) in grid.slices.iter().enumerate() {
        let (cells, own) = strip(grid, pressures, index);
        // Widths are measured from the middle of the slice.
        let middle = 0.5 * (cells[0][0] + cells[cells.len() - 1][1]);
        let cells: Vec<[f64; 2]> = cells.iter().map(|cell| cell.map(|x| x - middle)).collect();
        let judged = judge(&cells, &own, slice.surface_ends, grid.extent[0]);
        report.truncated[0] |= judged.truncated;
        most_loaded = most_loaded.max(own.iter().filter(|&&p| p > 0.0).count());
        if judged.truncated {
            width = Some(width.map_or(judged.recommended, |w: f64| w.max(judged.recommended)));
        }
    }
    let largest = (0..peaks.len()).max_by(|&i, &j| peaks[i].total_cmp(&peaks[j]).then(j.cmp(&i)));
    let available = largest.map_or(0, |slice| grid.slices[slice].cells.len());
    if width.is_none() && most_loaded < LEAST_LOADED_CELLS.min(available) {
        report.under_resolved[0] = true;
        let farthest = largest.map(|slice| {
            let (cells, own) = strip(grid, pressures, slice);
            let loaded: Vec<f64> =
                cells.iter().zip(&own).filter(|&(_, &p)| p > 0.0).flat_map(|(cell, _)| *cell).collect();
            let middle = 0.5 * (cells[0][0] + cells[cells.len() - 1][1]);
            loaded.iter().map(|x| (x - middle).abs()).fold(0.0, f64::max)
        });
        width = farthest.map(|farthest| (2.0 * MARGIN * farthest).min(0.5 * grid.extent[0]));
    }
    report.recommended[0] = width;
    let along = judge(&lengths(grid), &peaks, grid.surface_ends, grid.correctable_length());
    report.truncated[1] = along.truncated;
    report.under_resolved[1] = along.under_resolved;
    if along.truncated || along.under_resolved {
        report.recommended[1] = Some(along.recommended);
    }
    report
}

/// Fraction of a grid below which its loaded part is too small for accurate pressures.
const LEAST_LOADED_PART: f64 = 0.64;

/// Returns the width and length (m) that a grid should have for its loaded part to be [`MARGIN`]
/// times smaller, where that part is now less than [`LEAST_LOADED_PART`] of the grid; `None` where
/// the grid suits. `pressures` are in Pa, one per cell.
pub fn fitting_size(grid: &Grid, pressures: &[f64]) -> [Option<f64>; 2] {
    let mut reach = [0.0f64; 2];
    let mut cell = [0.0f64; 2];
    for index in 0..grid.slices.len() {
        let (cells, own) = strip(grid, pressures, index);
        let middle = 0.5 * (cells[0][0] + cells[cells.len() - 1][1]);
        for (ends, _) in cells.iter().zip(&own).filter(|(_, p)| **p > 0.0) {
            let [from, to] = ends.map(|x| (x - middle).abs());
            let y = grid.slices[index].y;
            reach = [reach[0].max(from).max(to), reach[1].max(y[0].abs()).max(y[1].abs())];
            cell = [cell[0].max(ends[1] - ends[0]), cell[1].max(y[1] - y[0])];
        }
    }
    [0, 1].map(|k: usize| {
        // The outermost loaded cells are loaded on a part of them only.
        let fitting = 2.0 * MARGIN * (reach[k] - 0.5 * cell[k]);
        let present = [grid.extent[0], grid.correctable_length()][k];
        (fitting > 0.0 && fitting < LEAST_LOADED_PART * MARGIN * present).then_some(fitting)
    })
}

struct Judgement {
    truncated: bool,
    under_resolved: bool,
    /// Recommended extent, if any.
    recommended: f64,
}

/// Assesses intervals, measured from the middle of the region that they should cover, with their
/// pressures.
fn judge(pieces: &[[f64; 2]], pressures: &[f64], surface_ends: [bool; 2], extent: f64) -> Judgement {
    let loaded = |p: Option<&f64>| p.is_some_and(|&p| p > 0.0);
    let truncated =
        (loaded(pressures.first()) && !surface_ends[0]) || (loaded(pressures.last()) && !surface_ends[1]);
    let count = pressures.iter().filter(|&&p| p > 0.0).count();
    let reach = pieces.iter().zip(pressures).filter(|&(_, &p)| p > 0.0);
    let reach = reach.map(|(piece, _)| piece[0].abs().max(piece[1].abs())).fold(0.0, f64::max);
    // A load at one end only must remain within a grid of the same middle.
    let smaller = 2.0 * MARGIN * reach;
    let few = count > 0 && count < LEAST_LOADED_CELLS.min(pieces.len());
    let under_resolved = !truncated && few && smaller < extent;
    let recommended = if truncated {
        // Zero of the extrapolated p² if it lies outside; otherwise the patch is truncated too much
        // for an estimate.
        zeros_of_squared_pressure(pieces, pressures)
            .map(|zeros| 2.0 * MARGIN * zeros[0].abs().max(zeros[1].abs()))
            .filter(|&w| w > 1.1 * extent)
            .unwrap_or(2.0 * extent)
    } else {
        smaller
    };
    Judgement { truncated, under_resolved, recommended }
}
