//! Influence matrix of the images of a patch's cells in one inclined mirror.
//!
//! The potential of an image is smooth on the patch, except where a cell touches the mirror, and
//! the matrix of averages of 1/r has a low numerical rank. It is positive semidefinite, since
//! between points on one side of a plane and mirrored points, with wave number k parallel to the
//! plane and distances z from it,
//!
//! ```text
//! 1 / r = 1 / (2 pi) ∫ exp(i k . (x - x')) exp(-|k| (z + z')) / |k| d²k
//! ```
//!
//! Hence a Cholesky decomposition with diagonal pivoting, ended when the remaining diagonal is
//! small, bounds the error of every entry: `|E_ij| <= sqrt(E_ii E_jj)` (Harbrecht, Peters and
//! Schneider, Applied Numerical Mathematics 62, 2012). It evaluates as many columns as the rank,
//! instead of all pairs of cells.

use super::grid::Cell;
use super::image::Images;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;

/// Largest error of an entry relative to the influence of its cells on themselves. With a smaller
/// one, the errors of quadrature, up to 1e-6 of an entry, make small pivots meaningless.
const TOLERANCE: f64 = 1e-7;
/// The decomposition ends, and all pairs are evaluated, if its rank exceeds this share of the
/// number of cells.
const LARGEST_RANK: f64 = 0.4;
/// Pivots that are equal to within this share are tied. Rounding must not decide: results would
/// depend on the position of the bodies in space by more than rounding.
const TIE: f64 = 1e-6;

/// Adds the influence of images to a symmetric block, row-major. `own` has the direct influence of
/// each cell on itself, in the units of the block. Rows are checkpoints.
///
/// # Errors
/// Those of the interrupt.
pub(super) fn add_images(
    images: &Images,
    cells: &[Cell],
    own: &[f64],
    block: &mut [f64],
    interrupt: &Interrupt,
) -> Result<(), EngineError> {
    let n = cells.len();
    let mut add = |i: usize, j: usize, value: f64| {
        block[i * n + j] += value;
        if j < i {
            block[j * n + i] += value;
        }
    };
    if let Some(Factor { rows, rank }) = Factor::of(images, cells, own, interrupt)? {
        let row = |i: usize| &rows[i * rank..(i + 1) * rank];
        for i in 0..n {
            interrupt.check()?;
            for j in 0..=i {
                add(i, j, row(i).iter().zip(row(j)).map(|(a, b)| a * b).sum());
            }
        }
        return Ok(());
    }
    for i in 0..n {
        interrupt.check()?;
        for j in 0..=i {
            add(i, j, images.influence(&cells[i], &cells[j]));
        }
    }
    Ok(())
}

/// Factor L of the approximation L L^T.
struct Factor {
    /// Rows of L, by cell.
    rows: Vec<f64>,
    rank: usize,
}

impl Factor {
    /// Decomposes the matrix of a mirror; `None` if the rank is too large or cells lie on both
    /// sides of the mirror, where the matrix is not positive semidefinite.
    fn of(
        images: &Images,
        cells: &[Cell],
        own: &[f64],
        interrupt: &Interrupt,
    ) -> Result<Option<Self>, EngineError> {
        let n = cells.len();
        let most = (LARGEST_RANK * n as f64) as usize;
        if most == 0 || !images.are_on_one_side(cells) {
            return Ok(None);
        }
        let mut remaining: Vec<f64> = cells.iter().map(|cell| images.influence(cell, cell)).collect();
        // Columns of L, one after the other.
        let mut columns: Vec<f64> = Vec::new();
        for rank in 0..=most {
            let error = |cell: usize| remaining[cell] / own[cell];
            let largest = (0..n).map(error).fold(0.0, f64::max);
            let first = (0..n).find(|&cell| error(cell) >= (1.0 - TIE) * largest);
            let Some(pivot) = first.filter(|_| largest > TOLERANCE) else {
                let rows = (0..n * rank).map(|entry| columns[entry % rank * n + entry / rank]).collect();
                return Ok(Some(Self { rows, rank }));
            };
            if rank == most {
                break;
            }
            interrupt.check()?;
            let scale = remaining[pivot].sqrt().recip();
            let mut column: Vec<f64> =
                cells.iter().map(|cell| images.influence(cell, &cells[pivot])).collect();
            for earlier in columns.chunks_exact(n) {
                let factor = earlier[pivot];
                column.iter_mut().zip(earlier).for_each(|(entry, part)| *entry -= factor * part);
            }
            for (entry, left) in column.iter_mut().zip(&mut remaining) {
                *entry *= scale;
                *left -= *entry * *entry;
            }
            remaining[pivot] = 0.0;
            columns.extend(column);
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use super::super::image::tests::{FRAME, cell, face};
    use super::*;

    /// Cells of a lattice that ends at `end`, 0.8 long.
    fn lattice(end: f64) -> Vec<Cell> {
        let place = |k: usize| [0.03 * (k % 16) as f64, end - 0.8 * ((k / 16) as f64 + 0.5) / 20.0];
        (0..320).map(|k| cell(place(k), [0.03, 0.04])).collect()
    }

    fn matrix(images: &Images, cells: &[Cell], own: &[f64]) -> Vec<f64> {
        let mut block = vec![0.0; cells.len() * cells.len()];
        add_images(images, cells, own, &mut block, &Interrupt::never()).unwrap();
        block
    }

    /// Every entry against its own quadrature, up to the mirror and away from it.
    #[test]
    fn the_error_is_small_relative_to_the_cells_themselves() {
        for (end, lean, most) in [(1.99, 0.4, 0.25), (1.5, 0.3, 0.05), (-4.0, -0.6, 0.02)] {
            let images = Images::new(face(lean), &FRAME);
            let cells = lattice(end);
            let own: Vec<f64> = cells.iter().map(|c| c.size[0].max(c.size[1]).recip()).collect();
            let rank = Factor::of(&images, &cells, &own, &Interrupt::never()).unwrap().unwrap().rank;
            assert!((rank as f64) < most * cells.len() as f64, "{end}: rank {rank}");
            let block = matrix(&images, &cells, &own);
            for (entry, found) in block.iter().enumerate() {
                let (i, j) = (entry / cells.len(), entry % cells.len());
                let error = (found - images.influence(&cells[i], &cells[j])).abs();
                assert!(error <= 3.0 * TOLERANCE * (own[i] * own[j]).sqrt(), "{end}: {i}, {j}: {error:e}");
                assert_eq!(found.to_bits(), block[j * cells.len() + i].to_bits());
            }
        }
    }

    /// Cells beyond the mirror, as where a grid leaves the tooth: every pair is evaluated.
    #[test]
    fn cells_on_both_sides_of_a_mirror_are_evaluated_by_pairs() {
        let images = Images::new(face(0.4), &FRAME);
        let cells: Vec<Cell> = lattice(2.1).into_iter().step_by(8).collect();
        let own = vec![1.0; cells.len()];
        assert!(Factor::of(&images, &cells, &own, &Interrupt::never()).unwrap().is_none());
        let block = matrix(&images, &cells, &own);
        assert_eq!(block[7], images.influence(&cells[7], &cells[0]));
    }
}
