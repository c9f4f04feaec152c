//! Evaluation of the pressures of a three-dimensional patch: peak, extent of the loaded part, and
//! assessment of the grid.
//!
//! Across each slice and along the peaks of the slices p² is nearly a parabola, as in plane
//! contact.

use super::grid::{Cell, Grid, Slice};
use crate::grid::{LEAST_LOADED_CELLS, MARGIN};
use crate::pressure::{self, zeros_of_squared_pressure};
use crate::zone::Zone;

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
    along(grid, &slice_peaks(grid, pressures))
}

/// Returns the largest pressure of a zone. Side faces do not count as edges, because every patch
/// reaches them.
pub fn peak_in(grid: &Grid, pressures: &[f64], zone: Zone) -> Option<Peak> {
    let peaks = slice_peaks_in(grid, pressures, zone);
    let half_width = half_width(grid, pressures);
    // At slices that an edge truncates, and within the edge zone, the peaks of the slices do not
    // lie on a parabola.
    let mut whole = peaks.clone();
    let mut largest_cut: Option<usize> = None;
    for index in 0..peaks.len() {
        let (cells, own) = strip(grid, pressures, index);
        if zone == Zone::Edge || grid.slices[index].edges.reached(&cells, &own, half_width) {
            whole[index] = NONE;
            let larger = |other: usize| peaks[index].pressure > peaks[other].pressure;
            largest_cut = if largest_cut.is_none_or(larger) { Some(index) } else { largest_cut };
        }
    }
    let found = along(grid, &whole);
    let cut = largest_cut.map(|index| {
        let pressure::Peak { pressure, x, cell } = peaks[index];
        let Slice { y, cells, .. } = &grid.slices[index];
        Peak { pressure, at: [x, 0.5 * (y[0] + y[1])], cell: cells.start + cell }
    });
    let cut = cut.filter(|peak| peak.pressure > found.map_or(0.0, |found| found.pressure));
    cut.or(found)
}

/// Returns the largest of the slices' peaks.
fn along(grid: &Grid, peaks: &[pressure::Peak]) -> Option<Peak> {
    let values: Vec<f64> = peaks.iter().map(|peak| peak.pressure).collect();
    let found = pressure::peak(&lengths(grid), &values)?;
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
    Some([pressure::half_width(&cells, &own)?, pressure::half_width(&lengths(grid), &peaks)?])
}

/// Assessment of a grid from a solution (report figures 3.40 to 3.42).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GridReport {
    /// Number of cells that carry force.
    pub loaded_cells: usize,
    /// True across and along if an outermost cell is loaded although the surfaces continue.
    /// Pressures are overestimated then.
    pub truncated: [bool; 2],
    /// True across and along if fewer than five cells of the slice with the largest force, or fewer
    /// than five slices, are loaded: too few for a pressure distribution. A patch whose surfaces
    /// end on both sides has no distribution to resolve if all its cells are loaded.
    pub under_resolved: [bool; 2],
    /// Recommended width and length (m), for the same M and N. `None` for an under-resolved patch
    /// that no smaller grid covers: it needs more cells or slices.
    pub recommended: [Option<f64>; 2],
}

/// Assesses a grid from the pressures (Pa) on it: across each slice, and along the patch by the
/// peaks of the slices.
pub fn assess(grid: &Grid, pressures: &[f64]) -> GridReport {
    let loaded_cells = pressures.iter().filter(|&&p| p > 0.0).count();
    let mut report = GridReport {
        loaded_cells,
        truncated: [false; 2],
        under_resolved: [false; 2],
        recommended: [None; 2],
    };
    if loaded_cells == 0 {
        return report;
    }
    // The slice with the largest force carries the patch; slices at its ends have narrow contact
    // and are not resolved across.
    let (mut main, mut widest) = (None::<(f64, Judgement)>, 0.0f64);
    for (index, slice) in grid.slices.iter().enumerate() {
        let (cells, own) = strip(grid, pressures, index);
        let force: f64 = slice.cells.clone().map(|cell| pressures[cell] * grid.cells[cell].area()).sum();
        // The width of a grid is measured from the contact line of each slice, which is not the
        // middle of a slice that a surface ends.
        let cells: Vec<[f64; 2]> = cells.iter().map(|cell| cell.map(|x| x - slice.edges.closest)).collect();
        let judged = judge(&cells, &own, slice.surface_ends, grid.extent[0]);
        if judged.truncated {
            report.truncated[0] = true;
            widest = judged.recommended.map_or(widest, |wanted| widest.max(wanted));
        }
        if main.as_ref().is_none_or(|(largest, _)| force > *largest) {
            main = Some((force, judged));
        }
    }
    if report.truncated[0] {
        report.recommended[0] = Some(if widest > 0.0 { widest } else { UNKNOWN * grid.extent[0] });
    } else if let Some((_, judged)) = main {
        report.under_resolved[0] = judged.under_resolved;
        report.recommended[0] = judged.recommended;
    }
    let peaks: Vec<f64> = slice_peaks(grid, pressures).iter().map(|peak| peak.pressure).collect();
    // The length is measured from the closest approach, the origin of the frame.
    let along = judge(&lengths(grid), &peaks, grid.surface_ends, grid.extent[1]);
    report.truncated[1] = along.truncated;
    report.under_resolved[1] = along.under_resolved;
    report.recommended[1] = match along.recommended {
        None if along.truncated => Some(UNKNOWN * grid.extent[1]),
        recommended => recommended,
    };
    report
}

/// A grid is made smaller only to less than this part of its size.
const LEAST_CHANGE: f64 = 0.95;
/// Factor on the size of a grid that truncates a patch too much for an estimate of its size.
const UNKNOWN: f64 = 2.0;

struct Judgement {
    truncated: bool,
    under_resolved: bool,
    /// Recommended extent, if another one is better, m; `None` for a truncated patch whose size
    /// cannot be estimated.
    recommended: Option<f64>,
}

/// Assesses intervals, measured from the middle of the region that they should cover, with their
/// pressures.
fn judge(pieces: &[[f64; 2]], pressures: &[f64], surface_ends: [bool; 2], extent: f64) -> Judgement {
    let loaded = |p: Option<&f64>| p.is_some_and(|&p| p > 0.0);
    let truncated =
        [loaded(pressures.first()) && !surface_ends[0], loaded(pressures.last()) && !surface_ends[1]];
    if truncated != [false; 2] {
        // Zeros of the extrapolated p² if they lie outside. The side that is not truncated is wide
        // enough.
        let reach = |zeros: [f64; 2]| {
            let sides = zeros.into_iter().zip(truncated).filter(|(_, truncated)| *truncated);
            2.0 * MARGIN * sides.map(|(zero, _)| zero.abs()).fold(0.0, f64::max)
        };
        let zeros = zeros_of_squared_pressure(pieces, pressures);
        let recommended = zeros.map(reach).filter(|&wanted| wanted > 1.1 * extent);
        return Judgement { truncated: true, under_resolved: false, recommended };
    }
    let count = pressures.iter().filter(|&&p| p > 0.0).count();
    let ended = count == pieces.len() && surface_ends == [true; 2];
    let under_resolved = count > 0 && count < LEAST_LOADED_CELLS && !ended;
    // The loaded pieces bound the patch from above. A grid without a margin around them could
    // truncate it, and the next one would be wider again.
    let reach = pieces.iter().zip(pressures).filter(|&(_, &p)| p > 0.0);
    let needed = 2.0 * reach.map(|(piece, _)| piece[0].abs().max(piece[1].abs())).fold(0.0, f64::max);
    let fitted = MARGIN * needed;
    let recommended = Some(fitted).filter(|fitted| under_resolved && *fitted < LEAST_CHANGE * extent);
    Judgement { truncated: false, under_resolved, recommended }
}
