//! Compliance matrix of the cells of all patches: half-planes where load and observer share a
//! surface, structures where they share a body.
//!
//! Every entry is the same expression with its two cells exchanged, so the matrix is symmetric bit
//! for bit without averaging.

use super::dense::tiles;
use super::grid::Cell;
use calyx_numerics::error::EngineError;
use calyx_numerics::interrupt::Interrupt;
use calyx_numerics::parallel::try_map;
use calyx_structure::half_plane::HalfPlane;
use calyx_structure::{Chart, Structure};

/// Body in a patch.
#[derive(Clone, Copy)]
pub struct Side<'a> {
    /// Index of the body. Several bodies may share a structure (equal planets) without coupling of
    /// their displacements.
    pub body: usize,
    /// Elastic behaviour of the body.
    pub structure: &'a dyn Structure,
    /// Loaded surface of the body.
    pub chart: Chart,
}

/// Contact patch: its two different bodies, in the order of its grid's sides, and its cells.
#[derive(Clone, Copy)]
pub struct PatchCells<'a> {
    /// First and second body.
    pub sides: [Side<'a>; 2],
    /// Cells of the contact grid.
    pub cells: &'a [Cell],
}

/// Compliance matrix of the same patches of which some had other cells.
#[derive(Clone, Copy)]
pub struct FormerCompliance<'a> {
    /// The matrix, row-major.
    pub matrix: &'a [f64],
    /// Number of cells of each patch in it.
    pub sizes: &'a [usize],
    /// Whether each patch still has these cells.
    pub unchanged: &'a [bool],
}

/// Entries of a compliance matrix that are computed.
#[derive(Clone, Copy)]
pub enum Entries<'a> {
    /// All.
    All,
    /// Those of blocks of two patches of which at least one has changed; the others are copied.
    Changed(FormerCompliance<'a>),
    /// Those between cells that are wanted, by patch. The others are zero, except for a positive
    /// diagonal, and of no meaning.
    Between(&'a [Vec<bool>]),
}

impl FormerCompliance<'_> {
    /// Returns the block of two patches, row-major, if both are unchanged.
    fn block(&self, p: usize, q: usize) -> Option<Vec<f64>> {
        if !(self.unchanged[p] && self.unchanged[q]) {
            return None;
        }
        let n: usize = self.sizes.iter().sum();
        let [rows, columns] = [p, q].map(|patch| {
            let first: usize = self.sizes[..patch].iter().sum();
            first..first + self.sizes[patch]
        });
        Some(rows.flat_map(|row| &self.matrix[row * n..][columns.clone()]).copied().collect())
    }
}

/// Computes A, row-major, with the cells in the order of the patches: growth of a cell's average
/// gap per force on a cell, m/(N/m). Each row of a block is a checkpoint.
///
/// # Errors
/// Those of the interrupt.
pub fn compliance(
    patches: &[PatchCells],
    entries: Entries,
    interrupt: &Interrupt,
) -> Result<Vec<f64>, EngineError> {
    let former = match entries {
        Entries::All => None,
        Entries::Changed(former) => Some(former),
        Entries::Between(wanted) => {
            let cells: Vec<&[Cell]> = patches.iter().map(|patch| patch.cells).collect();
            return between(&cells, wanted, |kept| {
                let reduced = patches.iter().zip(kept).map(|(patch, cells)| PatchCells { cells, ..*patch });
                compliance(&reduced.collect::<Vec<_>>(), Entries::All, interrupt)
            });
        }
    };
    let sizes: Vec<usize> = patches.iter().map(|patch| patch.cells.len()).collect();
    symmetric_of_blocks(&sizes, former, interrupt, |p, q| {
        let block = block(&patches[p], &patches[q], p == q, interrupt)?;
        debug_assert!(p != q || is_symmetric(&block, sizes[q]), "a structure's compliance is not symmetric");
        Ok(block)
    })
}

/// Computes the entries between `wanted` cells, see [`Entries::Between`]. `compliance` returns the
/// matrix of the patches with these cells only.
pub(crate) fn between<C: Clone>(
    cells: &[&[C]],
    wanted: &[Vec<bool>],
    compliance: impl FnOnce(&[Vec<C>]) -> Result<Vec<f64>, EngineError>,
) -> Result<Vec<f64>, EngineError> {
    let of_patch = |(cells, wanted): (&&[C], &Vec<bool>)| -> Vec<C> {
        cells.iter().zip(wanted).filter(|(_, wanted)| **wanted).map(|(cell, _)| cell.clone()).collect()
    };
    let kept: Vec<Vec<C>> = cells.iter().zip(wanted).map(of_patch).collect();
    Ok(spread(&compliance(&kept)?, wanted))
}

/// Returns the matrix of all cells from that of the wanted ones, see [`Entries::Between`].
fn spread(reduced: &[f64], wanted: &[Vec<bool>]) -> Vec<f64> {
    let all: Vec<bool> = wanted.iter().flatten().copied().collect();
    let places: Vec<usize> = (0..all.len()).filter(|&cell| all[cell]).collect();
    let (n, k) = (all.len(), places.len());
    let largest = (0..k).map(|i| reduced[i * k + i]).fold(0.0, f64::max);
    let diagonal = if largest > 0.0 { largest } else { 1.0 };
    let mut matrix = vec![0.0; n * n];
    (0..n).for_each(|cell| matrix[cell * n + cell] = diagonal);
    for (row, &i) in reduced.chunks_exact(k.max(1)).zip(&places) {
        row.iter().zip(&places).for_each(|(value, &j)| matrix[i * n + j] = *value);
    }
    matrix
}

/// Assembles a symmetric matrix, row-major. `block(p, q)` returns the block, row-major, of the
/// `sizes[p]` rows of patch `p` and the `sizes[q]` columns of patch `q`. It is called for `p <= q`
/// unless both are unchanged since the `former` matrix, by several threads at a time unless all are
/// busy with other positions.
pub(crate) fn symmetric_of_blocks(
    sizes: &[usize],
    former: Option<FormerCompliance>,
    interrupt: &Interrupt,
    block: impl Fn(usize, usize) -> Result<Vec<f64>, EngineError> + Sync,
) -> Result<Vec<f64>, EngineError> {
    let (n, patches): (usize, usize) = (sizes.iter().sum(), sizes.len());
    let pairs: Vec<[usize; 2]> = (0..patches).flat_map(|p| (p..patches).map(move |q| [p, q])).collect();
    let blocks = try_map(&pairs, |&[p, q]| match former.and_then(|former| former.block(p, q)) {
        Some(known) => Ok(known),
        None => block(p, q),
    })?;
    let mut matrix = vec![0.0; n * n];
    let first = |patch: usize| -> usize { sizes[..patch].iter().sum() };
    for ([p, q], block) in pairs.into_iter().zip(blocks) {
        insert(&mut matrix, n, &block, [sizes[p], sizes[q]], [first(p), first(q)], interrupt)?;
    }
    Ok(matrix)
}

/// Inserts a block and its transpose into a row-major matrix of size `n`. `first` is the row and
/// the column of the block's first entry; a block on the diagonal is symmetric. Tiles of the
/// transpose are checkpoints.
fn insert(
    matrix: &mut [f64],
    n: usize,
    block: &[f64],
    [rows, columns]: [usize; 2],
    first: [usize; 2],
    interrupt: &Interrupt,
) -> Result<(), EngineError> {
    for (i, row) in block.chunks_exact(columns.max(1)).enumerate() {
        matrix[(first[0] + i) * n + first[1]..][..columns].copy_from_slice(row);
    }
    if first[0] == first[1] {
        return interrupt.check();
    }
    for tile_rows in tiles(rows) {
        interrupt.check()?;
        for tile_columns in tiles(columns) {
            for i in tile_rows.clone() {
                for j in tile_columns.clone() {
                    matrix[(first[1] + j) * n + first[0] + i] = block[i * columns + j];
                }
            }
        }
    }
    Ok(())
}

/// Returns `true` if a block of `n` rows and columns is symmetric, bit for bit.
pub(crate) fn is_symmetric(block: &[f64], n: usize) -> bool {
    (0..n * n).all(|e| block[e].to_bits() == block[e % n * n + e / n].to_bits())
}

/// Computes the influence coefficients of forces on the cells of one patch for the gaps of another
/// or the `same`.
fn block(
    observing: &PatchCells,
    loaded: &PatchCells,
    same: bool,
    interrupt: &Interrupt,
) -> Result<Vec<f64>, EngineError> {
    let columns = loaded.cells.len();
    let mut block = vec![0.0; observing.cells.len() * columns];
    for (a, observer) in observing.sides.iter().enumerate() {
        for (b, load) in loaded.sides.iter().enumerate() {
            if observer.body != load.body {
                continue;
            }
            let arcs = |patch: &PatchCells, side: usize| -> Vec<f64> {
                patch.cells.iter().map(|c| c.loaded_at[side]).collect()
            };
            observer.structure.add_compliance_until(
                observer.chart,
                &arcs(observing, a),
                load.chart,
                &arcs(loaded, b),
                &mut block,
                interrupt,
            )?;
            if observer.chart != load.chart {
                continue;
            }
            let half_plane = HalfPlane {
                surface_modulus: observer.structure.surface_modulus(),
                reference_length: observer.structure.reference_length(),
            };
            for (i, cell) in observing.cells.iter().enumerate() {
                interrupt.check()?;
                // The half-plane term is symmetric, so compute one triangle.
                let others = if same { &loaded.cells[..=i] } else { loaded.cells };
                for (j, other) in others.iter().enumerate() {
                    let given = half_plane.cell_compliance(cell.arc[a], other.arc[b]);
                    block[i * columns + j] += given;
                    if same && j < i {
                        block[j * columns + i] += given;
                    }
                }
            }
        }
    }
    Ok(block)
}
