//! Part of a grid that may carry load: a range of cells in each slice.
//!
//! A grid is wide enough for the largest load of a patch, and most of its cells are open under
//! smaller loads. A contact problem with one cell for each slice estimates the load of the slices;
//! the width on which a slice carries it follows from Hertz's theory. The contact problem of these
//! ranges has the solution of the whole grid if all other cells are open. Its solution shows
//! whether they are, and the ranges are extended until they are.
//!
//! See `docs/theory/contact.md`.

use super::grid::{Cell, Grid, Slice};
use std::f64::consts::PI;
use std::ops::Range;

/// Cells of each slice of a grid that may carry load, numbered as in [`Grid::cells`]: at least the
/// one with the least gap.
pub type LoadedRanges = Vec<Range<usize>>;

/// Width of the only cell of a slice, relative to that of the grid. A uniform pressure over 1.36
/// half-widths gives its cell the mean displacement that a Hertzian pressure of the same force
/// gives the middle of the contact; the half-width of a shared load is about a quarter of the grid.
const SLICE_WIDTH: f64 = 0.35;
/// Margin of a range on either side, in cells, beyond the Hertzian half-width times
/// [`ESTIMATED_WIDTH`].
const MARGIN: f64 = 1.5;
const ESTIMATED_WIDTH: f64 = 1.05;
/// Half-width relative to that of the neighbouring slices that a slice has at least.
const LEAST_PART: f64 = 0.5;
/// Least number of cells by which a range grows where its outermost cell carries load. Longer
/// ranges grow by half of their cells.
const EXTENSION: usize = 2;
/// Factor on the decrease of the displacement from the outermost cell of a range to one beyond it.
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

/// Estimates the ranges from the forces of the slices, N. Returns also the cells that presumably
/// carry load, numbered as in the grid of these ranges. Without a Hertzian half-width the ranges
/// contain all cells.
pub fn estimated_ranges(grid: &Grid, forces: &[f64]) -> (LoadedRanges, Vec<usize>) {
    let half_width = |(slice, force): (&Slice, &f64)| {
        let length = grid.cells[nearest(grid, slice)].size[1];
        match grid.unit_half_width > 0.0 {
            true => grid.unit_half_width * (force.max(0.0) / length).sqrt(),
            false => f64::INFINITY,
        }
    };
    let half_widths: Vec<f64> = grid.slices.iter().zip(forces).map(half_width).collect();
    let (mut ranges, mut loaded, mut first) = (LoadedRanges::new(), Vec::new(), 0);
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
        ranges.push(from..to);
    }
    (ranges, loaded)
}

/// Returns the grid of the cells in some ranges.
pub fn within_ranges(grid: &Grid, ranges: &[Range<usize>]) -> Grid {
    let cells: Vec<Cell> = ranges.iter().flat_map(|own| &grid.cells[own.clone()]).copied().collect();
    let mut first = 0;
    let slice = |(slice, own): (&Slice, &Range<usize>)| {
        let cells = first..first + own.len();
        first = cells.end;
        Slice { cells, ..slice.clone() }
    };
    let slices = grid.slices.iter().zip(ranges).map(slice).collect();
    Grid { cells, slices, ..without_cells(grid) }
}

/// Returns the ranges extended by the cells beyond them that may carry load, from the forces (N)
/// and the gaps (m) of their cells; `None` if there are none.
///
/// Beyond its range the gap of a slice is that of the undeformed surfaces with the displacement of
/// the outermost cell, less the decrease of the displacement: by its own loads as line loads on a
/// half-space, and by the loads of other slices as point loads (Johnson, Contact Mechanics,
/// sections 2.2 and 3.2).
pub fn extended_ranges(
    grid: &Grid,
    ranges: &[Range<usize>],
    (forces, gaps): (&[f64], &[f64]),
    contact_modulus: f64,
) -> Option<LoadedRanges> {
    let (mut loads, mut first) = (Vec::new(), 0);
    for (slice, own) in ranges.iter().enumerate() {
        let cells = own.clone().zip(&forces[first..]);
        let loaded = cells.filter(|(_, force)| **force > 0.0);
        loads.extend(loaded.map(|(cell, &force)| Load { slice, cell: &grid.cells[cell], force }));
        first += own.len();
    }
    let (mut extended, mut first) = (LoadedRanges::with_capacity(ranges.len()), 0);
    for (index, (slice, own)) in grid.slices.iter().zip(ranges).enumerate() {
        let at = |cell: usize| first + cell - own.start;
        // An outermost cell without load states the displacement next to it.
        let may_close = |outermost: usize, beyond: usize| {
            let [from, to] = [outermost, beyond].map(|cell| &grid.cells[cell]);
            let decrease: f64 = loads.iter().map(|load| load.decrease(index, from, to)).sum();
            let decrease = SAFETY * decrease.max(0.0) / (PI * contact_modulus);
            forces[at(outermost)] == 0.0 && gaps[at(outermost)] + (to.gap - from.gap) < decrease
        };
        let growth = EXTENSION.max(own.len() / 2);
        let (mut from, mut to) = (own.start, own.end);
        if forces[at(own.start)] > 0.0 {
            from = from.saturating_sub(growth).max(slice.cells.start);
        }
        if forces[at(own.end - 1)] > 0.0 {
            to = (to + growth).min(slice.cells.end);
        }
        let below = (slice.cells.start..own.start).find(|&cell| may_close(own.start, cell));
        let above = (own.end..slice.cells.end).rfind(|&cell| may_close(own.end - 1, cell));
        extended.push(from.min(below.unwrap_or(from))..to.max(above.map_or(to, |cell| cell + 1)));
        first += own.len();
    }
    (extended != ranges).then_some(extended)
}

/// Returns the numbers of the cells of some ranges in the grid of ranges that contain them.
pub fn renumbered(former: &[Range<usize>], ranges: &[Range<usize>]) -> Vec<usize> {
    let mut first = 0;
    let of_slice = |(former, own): (&Range<usize>, &Range<usize>)| {
        let start = first + former.start - own.start;
        first += own.len();
        start..start + former.len()
    };
    former.iter().zip(ranges).flat_map(of_slice).collect()
}

/// Force on a cell, N.
struct Load<'a> {
    slice: usize,
    cell: &'a Cell,
    force: f64,
}

impl Load<'_> {
    /// Returns the decrease of the displacement from one cell of a slice to another, times pi and
    /// the contact modulus, N/m.
    fn decrease(&self, slice: usize, from: &Cell, to: &Cell) -> f64 {
        let [near, far] =
            [from, to].map(|cell| [0, 1].map(|axis: usize| cell.center[axis] - self.cell.center[axis]));
        match slice == self.slice {
            true => 2.0 * self.force / self.cell.size[1] * (far[0] / near[0]).abs().ln(),
            false => self.force * (near[0].hypot(near[1]).recip() - far[0].hypot(far[1]).recip()),
        }
    }
}

/// Returns the cell of a slice with the least gap.
fn nearest(grid: &Grid, slice: &Slice) -> usize {
    let by_gap = |a: &usize, b: &usize| grid.cells[*a].gap.total_cmp(&grid.cells[*b].gap);
    slice.cells.clone().min_by(by_gap).unwrap_or(slice.cells.start)
}

fn without_cells(grid: &Grid) -> Grid {
    let Grid { frame, width, along, line, half_counts, surface_ends, unit_half_width, beside_faces, .. } =
        *grid;
    let (cells, slices) = (Vec::new(), Vec::new());
    Grid {
        frame,
        cells,
        slices,
        width,
        along,
        line,
        half_counts,
        surface_ends,
        unit_half_width,
        beside_faces,
    }
}
