//! Evaluation of the pressures of a three-dimensional patch: peak, extent of the loaded part, and
//! assessment of the grid.
//!
//! Across each slice and along the peaks of the slices p² is nearly a parabola, as in plane
//! contact.

use super::grid::{Cell, Grid, Slice};
use super::grid_region::GridSize;
use crate::grid::{LEAST_CHANGE, LEAST_LOADED_CELLS, MARGIN};
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
    /// Recommended size where the present one does not suit, for the same M and N.
    pub recommended: GridSize,
}

/// Assesses a grid from the pressures (Pa) on it.
pub fn assess(grid: &Grid, pressures: &[f64]) -> GridReport {
    let loaded_cells = pressures.iter().filter(|&&p| p > 0.0).count();
    let peaks: Vec<f64> = slice_peaks(grid, pressures).iter().map(|peak| peak.pressure).collect();
    let mut report = GridReport {
        loaded_cells,
        truncated: [false; 2],
        under_resolved: [false; 2],
        recommended: GridSize::default(),
    };
    if loaded_cells == 0 {
        return report;
    }
    let mut most_loaded = 0;
    let mut width: Option<f64> = None;
    for (index, slice) in grid.slices.iter().enumerate() {
        let (cells, own) = strip(grid, pressures, index);
        most_loaded = most_loaded.max(own.iter().filter(|&&p| p > 0.0).count());
        if let Some(wider) = width_without_truncation(slice, &cells, &own, grid.width) {
            report.truncated[0] = true;
            width = Some(width.map_or(wider, |width| width.max(wider)));
        }
    }
    let largest = (0..peaks.len()).max_by(|&i, &j| peaks[i].total_cmp(&peaks[j]).then(j.cmp(&i)));
    let available = largest.map_or(0, |slice| grid.slices[slice].cells.len());
    if width.is_none() && most_loaded < LEAST_LOADED_CELLS.min(available) {
        report.under_resolved[0] = true;
        let needed = largest.map(|index| {
            let (cells, own) = strip(grid, pressures, index);
            let loaded = cells.iter().zip(&own).filter(|&(_, &p)| p > 0.0).flat_map(|(cell, _)| *cell);
            loaded.map(|x| grid.slices[index].width_to_reach(x)).fold(0.0, f64::max)
        });
        width = needed.map(|needed| (MARGIN * needed).min(0.5 * grid.width));
    }
    let along = ends_along(grid, &peaks);
    report.truncated[1] = matches!(along, EndsAlong::Truncated(_));
    report.under_resolved[1] = matches!(along, EndsAlong::UnderResolved(_));
    report.recommended = GridSize {
        width,
        along: match along {
            EndsAlong::Suitable => None,
            EndsAlong::Truncated(ends) | EndsAlong::UnderResolved(ends) => Some(ends),
        },
    };
    report
}

/// Fraction of a grid below which its loaded part is too small for accurate pressures.
const LEAST_LOADED_PART: f64 = 0.64;

/// Smallest distance of the end of a grid from the load, relative to the length of the slices or
/// the width of the cells at that end: the load may reach into cells that are unloaded on average.
const LEAST_MARGIN: f64 = 0.75;

/// Returns the size that a grid should have for its loaded part to be [`MARGIN`] times smaller,
/// where that part is now less than [`LEAST_LOADED_PART`] of the grid; `None` where the grid suits.
/// `pressures` are in Pa, one per cell.
///
/// Cells that are loaded on a part of them count as a whole: a grid that truncates the load costs
/// more corrections than one that is too large.
pub fn fitting_size(grid: &Grid, pressures: &[f64]) -> GridSize {
    let mut needed = 0.0f64;
    let mut peaks = vec![0.0f64; grid.slices.len()];
    for (index, slice) in grid.slices.iter().enumerate() {
        let (cells, own) = strip(grid, pressures, index);
        for (ends, pressure) in cells.iter().zip(&own).filter(|(_, p)| **p > 0.0) {
            let least = LEAST_MARGIN * (ends[1] - ends[0]);
            for x in ends {
                let outwards = x + least * (x - slice.middle).signum();
                let reach = MARGIN * slice.width_to_reach(*x);
                needed = needed.max(reach).max(slice.width_to_reach(outwards));
            }
            peaks[index] = peaks[index].max(*pressure);
        }
    }
    let is_small = |fitting: f64, present: f64| fitting < LEAST_LOADED_PART * MARGIN * present;
    let [low, high] = grid.along;
    GridSize {
        width: Some(needed).filter(|width| *width > 0.0 && is_small(*width, grid.width)),
        along: ends_about_load(grid, &peaks).filter(|[from, to]| is_small(to - from, high - low)),
    }
}

/// Returns the ends of the part of a grid along the contact line that contains its load with a
/// margin, m; `None` without load, and if a slice beyond the end of the contact line at an oblique
/// side face carries load: a shorter grid would have shorter slices there. `peaks` are positive in
/// loaded slices.
fn ends_about_load(grid: &Grid, peaks: &[f64]) -> Option<[f64; 2]> {
    let loaded = |slice: &usize| peaks[*slice] > 0.0;
    let (first, last) = ((0..peaks.len()).find(loaded)?, (0..peaks.len()).rfind(loaded)?);
    let [[from, end], [start, to]] = [grid.slices[first].y, grid.slices[last].y];
    let [low, high] = grid.along;
    if middle(&grid.slices[first]) < low || middle(&grid.slices[last]) > high {
        return None;
    }
    let more = (0.5 * (MARGIN - 1.0) * (to - from)).max(LEAST_MARGIN * (end - from).max(to - start));
    Some([(from - more).max(low), (to + more).min(high)])
}

/// Returns the width of a grid that does not truncate the load of a slice; `None` if the present
/// `width` (m) does not. `cells` are the ends of its cells, and `pressures` theirs, Pa.
fn width_without_truncation(slice: &Slice, cells: &[[f64; 2]], pressures: &[f64], width: f64) -> Option<f64> {
    let loaded = |p: Option<&f64>| p.is_some_and(|&p| p > 0.0);
    let [low, high] = slice.surface_ends;
    let truncated = [loaded(pressures.first()) && !low, loaded(pressures.last()) && !high];
    if truncated == [false; 2] {
        return None;
    }
    // On a side that is not truncated, the grid already reaches far enough.
    let reach = |[left, right]: [f64; 2]| {
        let left = if truncated[0] { left } else { left.max(cells[0][0]) };
        let right = if truncated[1] { right } else { right.min(cells[cells.len() - 1][1]) };
        MARGIN * slice.width_to_reach(left).max(slice.width_to_reach(right))
    };
    let wider = zeros_of_squared_pressure(cells, pressures).map(reach).filter(|wider| *wider > 1.1 * width);
    Some(wider.unwrap_or(2.0 * width))
}

/// Assessment of the ends of a grid along the contact line, with better ones, m.
enum EndsAlong {
    Suitable,
    Truncated([f64; 2]),
    /// Few slices are loaded.
    UnderResolved([f64; 2]),
}

/// Assesses the ends of a grid from the largest pressures (Pa) of its slices.
fn ends_along(grid: &Grid, peaks: &[f64]) -> EndsAlong {
    let (pieces, [low, high]) = (lengths(grid), grid.along);
    let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else { return EndsAlong::Suitable };
    // The surfaces do not face each other where slices are missing.
    let pitch = last[1] - last[0];
    let continues = [first[0] < low + 0.5 * pitch, last[1] > high - 0.5 * pitch];
    let outermost = [peaks[0], peaks[peaks.len() - 1]];
    let truncated = [0, 1].map(|end| outermost[end] > 0.0 && continues[end] && !grid.surface_ends[end]);
    if truncated != [false; 2] {
        // Zeros of the extrapolated p² if they lie outside; otherwise the patch is truncated too
        // much for an estimate.
        let length = high - low;
        let with_margin = |[from, to]: [f64; 2]| {
            let more = 0.5 * (MARGIN - 1.0) * (to - from);
            [from - more, to + more]
        };
        let zeros = zeros_of_squared_pressure(&pieces, peaks).map(with_margin);
        let beyond = |end: usize| {
            let zero = zeros.map_or(0.0, |zeros| [low - zeros[0], zeros[1] - high][end]);
            match truncated[end] {
                true if zero > 0.05 * length => zero,
                true => length,
                false => 0.0,
            }
        };
        return EndsAlong::Truncated([low - beyond(0), high + beyond(1)]);
    }
    let loaded = peaks.iter().filter(|peak| **peak > 0.0).count();
    let few = loaded < LEAST_LOADED_CELLS.min(pieces.len());
    let is_shorter = |[from, to]: &[f64; 2]| to - from < LEAST_CHANGE * (high - low);
    match ends_about_load(grid, peaks).filter(is_shorter) {
        Some(better) if few => EndsAlong::UnderResolved(better),
        _ => EndsAlong::Suitable,
    }
}
