//! Part of a grid that may carry load: a range of cells in each slice.
//!
//! A grid is wide enough for the largest load of a patch and is mostly open under smaller ones. A
//! contact problem with one cell for each slice estimates the load of the slices, and Hertz's
//! theory the width on which each carries it. The contact problem of the cells in this zone is the
//! one of the whole grid if all cells beyond it are open, which its solution shows: the zone is
//! extended until they are.
//!
//! See `docs/theory/contact.md`.

use super::grid::{Cell, Grid, Slice};
use std::f64::consts::PI;
use std::ops::Range;

/// Cells of each slice of a grid that may carry load, numbered as in [`Grid::cells`]: at least the
/// one with the least gap.
pub type LoadedZone = Vec<Range<usize>>;

/// Width of the only cell of a slice, relative to that of the grid. A uniform pressure over 1.36
/// times the half-width of a Hertzian one displaces its cell by as much as that one its middle; the
/// half-width of a shared load is about a quarter of the grid.
const SLICE_WIDTH: f64 = 0.35;
/// Margin of a zone on either side, in cells, beyond the Hertzian half-width times
/// [`ESTIMATED_WIDTH`].
const MARGIN: f64 = 1.5;
const ESTIMATED_WIDTH: f64 = 1.05;
/// Half-width relative to that of the neighbouring slices that a slice has at least.
const LEAST_PART: f64 = 0.5;
/// Number of cells by which a zone grows where its outermost cell carries load.
const EXTENSION: usize = 2;
/// Factor on the elastic deflection that may be missing at cells beyond a zone.
const SAFETY: f64 = 1.2;

/// Returns the grid with one cell for each slice, at its cell with the least gap.
pub fn with_a_cell_for_each_slice(grid: &Grid) -> Grid {
    let width = SLICE_WIDTH * grid.width;
    let of_slice = |slice: &Slice| {
        let cell = &grid.cells[nearest(grid, slice)];
        Cell { size: [width, cell.size[1]], ..*cell }
    };
    let cells = grid.slices.iter().map(of_slice).collect();
    let slice = |(index, slice): (usize, &Slice)| Slice { cells: index..index + 1, ..slice.clone() };
    let slices = grid.slices.iter().enumerate().map(slice).collect();
    Grid { cells, slices, ..without_cells(grid) }
}

/// Estimates the zone from the forces of the slices, N. Returns also the cells that presumably
/// carry load, numbered as in the grid of the zone.
pub fn estimated_zone(grid: &Grid, forces: &[f64]) -> (LoadedZone, Vec<usize>) {
    let half_width = |(slice, force): (&Slice, &f64)| {
        let length = grid.cells[nearest(grid, slice)].size[1];
        grid.unit_half_width * (force.max(0.0) / length).sqrt()
    };
    let half_widths: Vec<f64> = grid.slices.iter().zip(forces).map(half_width).collect();
    let (mut zone, mut loaded, mut first) = (LoadedZone::new(), Vec::new(), 0);
    for (index, slice) in grid.slices.iter().enumerate() {
        let beside = index.saturating_sub(1)..(index + 2).min(half_widths.len());
        let neighbours = half_widths[beside].iter().copied().fold(0.0, f64::max);
        let reach = ESTIMATED_WIDTH * half_widths[index].max(LEAST_PART * neighbours);
        let middle = nearest(grid, slice);
        let apart = |cell: usize| (grid.cells[cell].center[0] - grid.cells[middle].center[0]).abs();
        let is_in = |cell: &usize| apart(*cell) <= reach + MARGIN * grid.cells[*cell].size[0];
        let from = slice.cells.clone().find(is_in).unwrap_or(middle);
        let to = slice.cells.clone().rfind(is_in).unwrap_or(middle) + 1;
        let carries = |cell: &usize| half_widths[index] > 0.0 && apart(*cell) <= half_widths[index];
        loaded.extend((from..to).filter(carries).map(|cell| first + cell - from));
        first += to - from;
        zone.push(from..to);
    }
    (zone, loaded)
}

/// Returns the grid of the cells in a zone.
pub fn within_zone(grid: &Grid, zone: &[Range<usize>]) -> Grid {
    let cells: Vec<Cell> = zone.iter().flat_map(|own| &grid.cells[own.clone()]).copied().collect();
    let mut first = 0;
    let slice = |(slice, own): (&Slice, &Range<usize>)| {
        let cells = first..first + own.len();
        first = cells.end;
        Slice { cells, ..slice.clone() }
    };
    let slices = grid.slices.iter().zip(zone).map(slice).collect();
    Grid { cells, slices, ..without_cells(grid) }
}

/// Returns the zone extended by the cells beyond it that may carry load, from the forces (N) and
/// the gaps (m) in the zone; `None` if there are none.
///
/// Beyond the zone the gap of a slice is that of the undeformed surfaces with the displacement of
/// its outermost cell, less the decrease of the displacement by its loads, as line loads on a
/// half-space (Johnson, Contact Mechanics, section 2.2).
pub fn extended_zone(
    grid: &Grid,
    zone: &[Range<usize>],
    (forces, gaps): (&[f64], &[f64]),
    contact_modulus: f64,
) -> Option<LoadedZone> {
    let (mut extended, mut first) = (LoadedZone::with_capacity(zone.len()), 0);
    for (slice, own) in grid.slices.iter().zip(zone) {
        let cells = first..first + own.len();
        first = cells.end;
        let (forces, gaps) = (&forces[cells.clone()], &gaps[cells]);
        let of_cell = |cell: usize| (&grid.cells[cell], forces[cell - own.start], gaps[cell - own.start]);
        // Decrease of the displacement from the outermost cell of the zone to one beyond it.
        let decrease = |outermost: &Cell, beyond: &Cell| -> f64 {
            let by_line = |(cell, force): (&Cell, &f64)| {
                let [near, far] = [outermost, beyond].map(|at| (at.center[0] - cell.center[0]).abs());
                if *force > 0.0 { force / cell.size[1] * (far / near).ln() } else { 0.0 }
            };
            let lines: f64 = grid.cells[own.clone()].iter().zip(forces).map(by_line).sum();
            SAFETY * 2.0 / (PI * contact_modulus) * lines
        };
        let may_close = |outermost: usize, beyond: usize| {
            let (cell, force, gap) = of_cell(outermost);
            let beyond = &grid.cells[beyond];
            force == 0.0 && gap + (beyond.gap - cell.gap) < decrease(cell, beyond)
        };
        let (mut from, mut to) = (own.start, own.end);
        if of_cell(own.start).1 > 0.0 {
            from = from.saturating_sub(EXTENSION).max(slice.cells.start);
        }
        if of_cell(own.end - 1).1 > 0.0 {
            to = (to + EXTENSION).min(slice.cells.end);
        }
        let below = (slice.cells.start..own.start).find(|&cell| may_close(own.start, cell));
        let above = (own.end..slice.cells.end).rfind(|&cell| may_close(own.end - 1, cell));

        extended.push(from.min(below.unwrap_or(from))..to.max(above.map_or(to, |cell| cell + 1)));
    }
    (extended != zone).then_some(extended)
}

/// Returns the cell of a slice with the least gap.
fn nearest(grid: &Grid, slice: &Slice) -> usize {
    let by_gap = |a: &usize, b: &usize| grid.cells[*a].gap.total_cmp(&grid.cells[*b].gap);
    slice.cells.clone().min_by(by_gap).unwrap_or(slice.cells.start)
}

fn without_cells(grid: &Grid) -> Grid {
    let Grid { frame, width, along, line, half_counts, surface_ends, unit_half_width, .. } = *grid;
    let (cells, slices) = (Vec::new(), Vec::new());
    Grid { frame, cells, slices, width, along, line, half_counts, surface_ends, unit_half_width }
}
