//! A ring of equal sectors, known through the cuts between them (report section 2.6).
//!
//! A sector is condensed onto its two cuts: a stiffness of the cut degrees of freedom, and for every load inside the
//! sector its equivalent on the cuts. Displacements of a cut are expressed in the frame of the sector that it is the
//! *first* cut of, so that every sector has the same matrix, whatever the angle it stands at, and turning the ring only
//! renumbers the sectors.
//!
//! The sectors that carry no load are joined two by two, four by four and so on: O(log N) condensations for N sectors.
//! Joining eliminates the cut between two chains, and the stiffness of that cut with both ends held is positive
//! definite even if the ring itself is free, so no step needs pivoting.

use super::StructureError;
use super::dense::{
    add_product, add_product_lower, cholesky, half_solve, mirror_lower, other_half_solve, solve,
};
use crate::interrupt::Interrupt;
use faer::{Mat, MatRef};

/// A sector, or a chain of them, condensed onto its first and last cut.
#[derive(Clone, Debug)]
pub struct CutStiffness {
    /// Symmetric, first cut before last cut.
    matrix: Mat<f64>,
}

/// The stiffness of a ring's cuts is not positive definite: something can move freely.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("the ring of sectors is not held: it can move without deforming")]
pub struct FreeRing;

impl CutStiffness {
    /// `matrix` is symmetric of even size: the degrees of freedom of the first cut, then as many of the last, in N/m
    /// (in the plane per metre of face width). Only its lower triangle is read.
    pub fn new(mut matrix: Mat<f64>) -> Self {
        assert!(
            matrix.nrows() == matrix.ncols() && matrix.nrows().is_multiple_of(2),
            "two cuts of equal size"
        );
        mirror_lower(&mut matrix);
        Self { matrix }
    }

    /// Degrees of freedom of one cut.
    pub fn cut_size(&self) -> usize {
        self.matrix.nrows() / 2
    }

    fn block(&self, row: usize, column: usize) -> MatRef<'_, f64> {
        let n = self.cut_size();
        self.matrix.as_ref().submatrix(row * n, column * n, n, n)
    }

    /// The chain of `self` followed by `next`, the cut between them condensed (report eq. 2.80).
    fn joined(&self, next: &Self, interrupt: &Interrupt) -> Result<Self, StructureError> {
        Ok(self.join(next, interrupt)?.0)
    }

    /// The chain of `self` followed by `next`, and how the cut between them follows its ends.
    fn join(&self, next: &Self, interrupt: &Interrupt) -> Result<(Self, Inner), StructureError> {
        interrupt.check().map_err(StructureError::Interrupted)?;
        let n = self.cut_size();
        let between = self.block(1, 1) + next.block(0, 0);
        let factor = cholesky(between).ok_or(FreeRing)?;
        let mut coupling = Mat::zeros(n, 2 * n);
        coupling.as_mut().submatrix_mut(0, 0, n, n).copy_from(self.block(1, 0));
        coupling.as_mut().submatrix_mut(0, n, n, n).copy_from(next.block(0, 1));
        let coupling = half_solve(factor.as_ref(), coupling);
        let mut matrix = Mat::zeros(2 * n, 2 * n);
        matrix.as_mut().submatrix_mut(0, 0, n, n).copy_from(self.block(0, 0));
        matrix.as_mut().submatrix_mut(n, n, n, n).copy_from(next.block(1, 1));
        add_product_lower(matrix.as_mut(), -1.0, coupling.transpose(), coupling.as_ref());
        Ok((Self::new(matrix), Inner { factor, coupling }))
    }

    /// The chain of `count >= 1` equal sectors, by doubling.
    fn repeated(&self, count: u32, interrupt: &Interrupt) -> Result<Self, StructureError> {
        let mut power = self.clone();
        let mut chain: Option<Self> = None;
        let mut rest = count;
        loop {
            if rest & 1 == 1 {
                chain = Some(match chain {
                    None => power.clone(),
                    Some(chain) => chain.joined(&power, interrupt)?,
                });
            }
            rest >>= 1;
            match chain {
                Some(chain) if rest == 0 => return Ok(chain),
                _ => power = power.joined(&power, interrupt)?,
            }
        }
    }
}

/// A cut between two chains: its displacements are `-L^-T C` times those of the ends of both, first end before last.
struct Inner {
    /// `L`, of the stiffness of the cut with the ends held.
    factor: Mat<f64>,
    /// `C = L^-1 K`, with `K` between the cut and the ends.
    coupling: Mat<f64>,
}

impl Inner {
    fn displacements(&self, first: MatRef<'_, f64>, last: MatRef<'_, f64>) -> Mat<f64> {
        let n = self.factor.nrows();
        let mut forces = Mat::zeros(n, first.ncols());
        add_product(forces.as_mut(), -1.0, self.coupling.as_ref().subcols(0, n), first);
        add_product(forces.as_mut(), -1.0, self.coupling.as_ref().subcols(n, n), last);
        other_half_solve(self.factor.as_ref(), forces)
    }
}

/// Displacements of the cuts of every sector in a window, per unit force on the cuts of the first one.
#[derive(Clone, Debug)]
pub struct RingFlexibility {
    /// By offset from the loaded sector: rows are the first and last cut of the observed sector, columns those of the
    /// loaded one.
    by_offset: Vec<Mat<f64>>,
}

impl RingFlexibility {
    /// For a ring of `sectors` equal sectors: offsets `0 ..= window`, at most half way round.
    ///
    /// The sectors outside the window are condensed by doubling. Those of the window are joined to them one by one, from the last
    /// one back to the loaded one, and the cuts passed on the way follow from those of the loaded one.
    /// There is a checkpoint before each joining.
    ///
    /// # Errors
    /// The ring is free to move, or the interrupt's.
    pub fn new(
        sector: &CutStiffness,
        sectors: u32,
        window: u32,
        interrupt: &Interrupt,
    ) -> Result<Self, StructureError> {
        assert!(sectors >= 1, "a ring has sectors");
        let window = window.min(sectors / 2).min(sectors - 1);
        let n = sector.cut_size();
        let ends = [[0, 0], [0, 1], [1, 0], [1, 1]];
        if sectors == 1 {
            // Both ends of the one sector are the same degrees of freedom.
            let mut closed = Mat::zeros(n, n);
            ends.iter().for_each(|&[row, column]| closed += sector.block(row, column));
            let factor = cholesky(closed).ok_or(FreeRing)?;
            let alone = solve(factor.as_ref(), Mat::identity(n, n));
            let at = |row: usize, column: usize| alone[(row % n, column % n)];
            return Ok(Self { by_offset: vec![Mat::from_fn(2 * n, 2 * n, at)] });
        }
        // The sectors outside the window, or its last one if there are none, go from cut `known` back to cut 0.
        let outside = sectors - window - 1;
        let (mut rest, known) = match outside {
            0 => (sector.clone(), window),
            _ => (sector.repeated(outside, interrupt)?, window + 1),
        };
        let mut passed = Vec::new();
        for _ in 1..known {
            let (longer, inner) = sector.join(&rest, interrupt)?;
            passed.push(inner);
            rest = longer;
        }
        interrupt.check().map_err(StructureError::Interrupted)?;
        let mut closed = sector.matrix.clone();
        for [row, column] in ends {
            let mut target = closed.as_mut().submatrix_mut((1 - row) * n, (1 - column) * n, n, n);
            target += rest.block(row, column);
        }
        let factor = cholesky(closed).ok_or(FreeRing)?;
        interrupt.check().map_err(StructureError::Interrupted)?;
        let loaded = solve(factor.as_ref(), Mat::identity(2 * n, 2 * n));
        let (first, second) = loaded.as_ref().split_at_row(n);
        let mut cuts = vec![first.to_owned(), second.to_owned()];
        while let Some(inner) = passed.pop() {
            interrupt.check().map_err(StructureError::Interrupted)?;
            cuts.push(inner.displacements(cuts[cuts.len() - 1].as_ref(), first));
        }
        let of_sector = |offset: usize| {
            let mut rows = Mat::zeros(2 * n, 2 * n);
            for (end, cut) in [offset, (offset + 1) % cuts.len()].into_iter().enumerate() {
                rows.as_mut().submatrix_mut(end * n, 0, n, 2 * n).copy_from(&cuts[cut]);
            }
            rows
        };
        Ok(Self { by_offset: (0..=window as usize).map(of_sector).collect() })
    }

    /// The largest offset known.
    pub fn window(&self) -> u32 {
        self.by_offset.len() as u32 - 1
    }

    /// Cut displacements of the sector `offset` places further on, `2n` by `2n`. `offset <= window()`.
    pub fn at(&self, offset: u32) -> MatRef<'_, f64> {
        self.by_offset[offset as usize].as_ref()
    }
}

#[cfg(test)]
mod tests;
